//! Section 2.4, for all q ≥ 1: how many roots the curves' equations have, and the order of the curves.
//!
//! B and E are parametrised by β = asin(qλ₀) between 0 and π/2, in which the arcs of Newton's law, from α = asin λ₀
//! to π + β for B and to 2π − β for E, have slopes everywhere. [`exact`](mod@super::exact) proves that they are the
//! differences of the sides of (54) and of E, `arcs` that they rise or fall all the way, so that each curve has one
//! root at most. B's arc is positive at β = 0 and falls; E's is λ₀ times what is −2π there and grows. At β = π/2
//! both are one function c of q, which is zero at q_Y only, where it changes from negative to positive: B has one
//! root for q < q_Y and none beyond, E none before and one beyond. (53) has a root for every q, as its left side
//! falls from ∞ to 0.

pub(super) mod arcs;
pub(crate) mod points;

use super::prelude::*;
use super::{exact, motions};
use crate::validated::drive::{self, Edge, arc};
use trialbook::certified::cover::{Said, everywhere};
use trialbook::certified::interval::Interval;
use trialbook::certified::jet::{Jet, over};
use trialbook::trials::enclosed::{certified, citing};

type Two = Jet<2>;
type Outcome = Result<usize, CertifiedError>;

/// q_Y, to the last places of an f64.
fn q_y() -> Result<Interval, CertifiedError> {
    let [q, _] = drive::y(64)?;
    Ok(q.interval())
}

/// The arc that ends at the edge of the stretch in which the drive could pull backward, by q and β.
fn arc_to<S: Scalar>(edge: Edge, [q, beta]: [S; 2]) -> S {
    let lambda0 = beta.sin() / q;
    let end = match edge {
        Edge::Beginning => S::pi() + beta,
        Edge::End => S::int(2) * S::pi() - beta,
    };
    arc(lambda0.asin(), end, lambda0)
}

fn given(algebra: &[Proof], certificate: impl FnOnce() -> Outcome) -> Outcome {
    match algebra.iter().find(|proof| !proof.holds()) {
        None => certificate(),
        Some(fails) => Err(CertifiedError::False(fails.title().to_owned())),
    }
}

/// How far from q_Y its sides are looked at.
const NEAR_Y: f64 = 1e-13;

/// c, the arc at β = π/2 by q.
fn corner<S: Scalar>(q: S) -> S {
    let lambda0 = S::int(1) / q;
    let end = S::int(3) * S::pi() / S::int(2);
    arc(lambda0.asin(), end, lambda0)
}

/// That c, which has one zero at most, has it at q_Y, where it changes from negative to positive.
fn prove_corner(critical: Interval) -> Outcome {
    let mut parts = 0;
    for way in [-1.0, 1.0] {
        let q = critical + Interval::point(way * NEAR_Y);
        parts += everywhere([q], |cell| {
            Said::of_sign(over(|[q]| corner(q), cell).value, way)
        })?;
    }
    Ok(parts)
}

fn algebra_of_b(sides: [Expr; 2]) -> [Proof; 3] {
    let curve = exact::prove_eq54(sides);
    [curve, arcs::b_falls(), arcs::corner_falls()]
}

fn algebra_of_e(sides: [Expr; 2]) -> [Proof; 3] {
    [exact::prove_e(sides), arcs::e_grows(), arcs::corner_falls()]
}

fn prove_b(sides: [Expr; 2]) -> Outcome {
    prove_curve(&algebra_of_b(sides))
}

fn prove_e(sides: [Expr; 2]) -> Outcome {
    prove_curve(&algebra_of_e(sides))
}

fn prove_curve(algebra: &[Proof]) -> Outcome {
    given(algebra, at_y)
}

fn shows(
    algebra: &[Proof],
    subject: Subject,
    clause: &'static str,
    certificate: impl FnOnce() -> Outcome,
) -> Evidence {
    let proof = given(algebra, certificate);
    citing(algebra, certified(proof, subject, Compared::shown(clause)))
}

fn at_y() -> Outcome {
    prove_corner(q_y()?)
}

/// λ₀ on A by (53): its left side is the cotangent of asin λ₀, so that λ₀ = 1/√(1 + r²) if its right side r is positive.
fn on_a<S: Scalar>(q: S) -> S {
    let [_, right] = printed::eq53_sides(printed::eq53_k(q), S::int(1));
    S::int(1) / (S::int(1) + right.squared()).sqrt()
}

/// That A lies below B up to Y and below E from Y on: the arc to the edge, on A.
fn prove_a_lowest(on_a: fn(Jet<1>) -> Jet<1>) -> Outcome {
    let y = q_y()?;
    let on = |edge| {
        move |[q]: [Jet<1>; 1]| {
            let lambda0 = on_a(q);
            arc_to(edge, [q, (q * lambda0).asin()])
        }
    };
    // At q = 1, where A and B meet, the arc is 0, as far as can be seen (and exactly so, by the proof of (57)).
    let before = everywhere([Interval::new(1.0, y.hi())], |cell| {
        let jet = over(on(Edge::Beginning), cell);
        if cell[0].lo() == 1.0 {
            let corner = over(on(Edge::Beginning), &[Interval::int(1)]).value;
            Said::all([Said::of_zero(corner), Said::of_sign(jet.slope[0], 1.0)])
        } else {
            Said::of_sign(jet.value, 1.0)
        }
    })?;
    // Beyond Y A lies below π/q², and there E's arc is negative, as it is below.
    let far = Interval::new(0.0, (Interval::int(1) / y).hi());
    let beyond = given(&[arcs::a_below(), arcs::e_grows()], || {
        everywhere([far], |cell| {
            Said::of_sign(arcs::e_beyond([cell[0], Interval::pi()]), -1.0)
        })
    })?;
    Ok(before + beyond)
}

fn prove_order(on_a: fn(Jet<1>) -> Jet<1>, on_c: fn(Expr) -> Expr) -> Outcome {
    // On A, where the right side of (53) is positive, the sides are equal.
    let algebra = [arcs::a_falls(exact::sides_of_a()), arcs::c_falls(on_c)];
    let equal = given(&algebra, || {
        everywhere([Interval::new(1.0, q_y()?.hi())], |cell| {
            let q = Jet::constant(Interval::point(cell[0].mid()));
            let [left, right] = printed::eq53_sides(printed::eq53_k(q), on_a(q));
            Said::of_zero((left - right).value)
        })
    })?;
    let [b, e] = [prove_b(exact::sides_of_b())?, prove_e(exact::sides_of_e())?];
    Ok(equal + b + e + prove_a_lowest(on_a)?)
}

fn regions() -> [Proof; 5] {
    [
        motions::FIRST.proof(),
        motions::SECOND.proof(),
        motions::THIRD.proof(),
        motions::FOURTH.proof(),
        motions::FIFTH.proof(),
    ]
}

attempts![
    a_once = shows(
        &[arcs::a_falls(exact::sides_of_a())],
        Printed,
        r"(53) has one root in $0<\lambda_0<1$ for every $q\ge1$: with growing $\lambda_0$ the left side falls from $\infty$ to 0, and the right side is positive",
        || Ok(1),
    ),
    b_once = shows(
        &algebra_of_b(exact::sides_of_b()),
        Printed,
        r"(54) has one root for every $1\le q<q_Y$ and none for $q>q_Y$: the arc that ends at $\pi+\sin^{-1}(q\lambda_0)$ falls from 2, its slope being a sum of terms of one sign",
        at_y,
    ),
    e_once = shows(
        &algebra_of_e(exact::sides_of_e()),
        Corrected,
        r"E has no root but $\lambda_0=0$ for $1\le q<q_Y$ and one for every $q>q_Y$: the arc that ends at $2\pi-\sin^{-1}(q\lambda_0)$ is $\lambda_0$ times what grows from $-2\pi$",
        at_y,
    )
    .of_a_part(),
    // About the rest of the region's motion it says nothing.
    e_below_c = shows(
        &algebra_of_e(exact::sides_of_e()),
        Corrected,
        r"the arc to the last moment at which the drive could pull backward is negative below E and positive between E and C, for every $q>q_Y$",
        at_y,
    )
    .of_a_part(),
    order = shows(
        &regions(),
        Corrected,
        r"$A<B<C<D$ for all $1<q<q_Y$ and $A<E<C<D$ for all $q>q_Y$, with $A=B$ and $C=D$ at $q=1$, where the slopes of their differences have a sign; and between the curves lie the regions as they are proved for every $q\ge1$",
        || prove_order(on_a, printed::eq55_lambda0),
    ),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn without_the_algebra_there_is_no_certificate() {
        let name = String::new();
        let fails = Proof::impossible("no", crate::exact::ExactError::UnknownSymbol(name));
        assert!(given(&[exact::E.proof(), fails], || Ok(3)).is_err());
        assert_eq!(given(&[exact::E.proof()], || Ok(3)).unwrap(), 3);
    }

    fn assert_refused(proof: Outcome) {
        assert!(
            matches!(proof, Err(CertifiedError::False { .. })),
            "{proof:?}"
        );
    }

    #[test]
    fn mutated_statements_are_refused() {
        assert_refused(prove_b(exact::sides_of_e()));
        assert_refused(prove_e(exact::sides_of_b()));
        let [left, right] = exact::sides_of_b();
        let off = symbol("λ₀") / int(1_000_000);
        assert_refused(prove_b([left, right + off]));
        assert_refused(prove_corner(q_y().unwrap() + Interval::point(1e-12)));
        // A raised by a part in a thousand crosses B.
        assert_refused(prove_a_lowest(|q| {
            on_a(q) * Jet::int(1001) / Jet::int(1000)
        }));
        let [left, right] = exact::sides_of_a();
        assert!(!arcs::a_falls([left, -right]).holds());
        assert_refused(prove_order(on_a, |q| q));
        assert_refused(prove_order(|q| on_a(q) * q, printed::eq55_lambda0));
    }

    #[test]
    fn the_arc_far_out_is_that_of_e() {
        for (q, beta) in [(1.5, 0.3), (6.0, 1.0), (50.0, 0.02)] {
            let lambda0 = libm::sin(beta) / q;
            let far = arcs::e_beyond([1.0 / q, lambda0 * q * q]);
            let near = arc_to(Edge::End, [q, beta]) / lambda0;
            assert!((far - near).abs() < 1e-9, "{q} {far} {near}");
        }
    }

    #[test]
    fn a_lies_below_its_bound() {
        for q in [1.0, 1.7, 4.0, 30.0, 1e4] {
            assert!(on_a(q) < std::f64::consts::PI / (q * q), "{q}");
        }
    }
}
