//! Section 2.4, for all q from 1 to 12: how many roots the curves' equations have, and the order of the curves.
//!
//! B and E are parametrised by β = asin(qλ₀) between 0 and π/2, in which the arcs of Newton's law have slopes
//! everywhere: from α = asin λ₀ to π + β for B, to 2π − β for E. That these arcs are the differences of the sides of
//! (54) and of E is proved in [`exact`](mod@super::exact), which every certificate asks first; the numbers are looked at again
//! in the middle of every part of a range.
//! Where each root of a function crosses zero downwards, there is one at most; for that a part of the range needs a
//! sign of the function, or a negative slope.
//!
//! B's arc is positive at β = 0 and E's is 0 there and falls. At β = π/2 both arcs end at 3π/2 and are the same
//! function c of q, which is zero at q_Y only, where it changes from negative to positive. So B has one root for
//! q < q_Y and none beyond, E none before q_Y and one beyond.

pub mod points;

use super::exact;
use crate::certified::cover::{Said, everywhere_written};
use crate::certified::drive::{self, Edge, arc};
use crate::certified::error::CertifiedError;
use crate::certified::interval::{Interval, PI};
use crate::certified::jet::{Jet, over};
use crate::certified::written::{dyadic, sign, slope};
use crate::claims::compare::Compared;
use crate::claims::enclosed::certified;
use crate::corrections::anisotropic as corrected;
use crate::evidence::{Evidence, Subject};
use crate::exact::{Expr, Proof};
use crate::paper::anisotropic as printed;
use crate::scalar::Scalar;
use trialbook::witness::{Condition, Where};

type Two = Jet<2>;
type Outcome = Result<usize, CertifiedError>;
/// The two sides of an equation of λ₀ and qλ₀.
type Sides = fn(Two, Two) -> [Two; 2];

/// From 1 to 12.
fn ratios() -> Interval {
    Interval::new(1.0, 12.0)
}

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

/// The certificate, if the algebra holds that it rests on.
fn given(algebra: &Proof, certificate: Outcome) -> Outcome {
    if algebra.holds() {
        certificate
    } else {
        Err(CertifiedError::False {
            at: algebra.title().to_owned(),
        })
    }
}

/// That the difference of an equation's sides is the arc, for numbers: in the middle of a part.
fn is_arc(sides: Sides, edge: Edge, cell: &[Interval; 2]) -> Said {
    let middle = cell.map(|x| Interval::point(x.mid()));
    let [left, right] = {
        let [q, beta] = middle.map(Jet::constant);
        sides(beta.sin() / q, beta.sin())
    };
    let off = (left - right).value - arc_to(edge, middle);
    if off.width() < 1e-6 {
        Said::of_zero(off)
    } else {
        Said::Nothing
    }
}

/// That the equation has one root β at most for each q, and that it is crossed in the direction of `way`.
fn prove_single_root(sides: Sides, edge: Edge, way: f64) -> Outcome {
    let range = [ratios(), Interval::new(0.0, (PI / Interval::int(2)).hi())];
    let written = || {
        let names = ["q", "β"];
        let arc = arc_to(edge, names.map(Expr::symbol));
        let crosses = [slope(arc, 1, way), sign(arc, 1.0), sign(arc, -1.0)];
        let mut cases = vec![(Where::Rest, Condition::Any(crosses.to_vec()))];
        if edge == Edge::End {
            cases.insert(0, (Where::From(1, "0".into()), slope(arc, 1, -1.0)));
        }
        (names, cases)
    };
    everywhere_written(written, range, |cell| {
        let jet = over(|x| arc_to(edge, x), cell);
        let falls = Said::of_sign(jet.slope[1], -1.0);
        if edge == Edge::End && cell[1].lo() == 0.0 {
            // The arc of E is 0 at β = 0: next to it, it falls, and is negative.
            return Said::all([is_arc(sides, edge, cell), falls]);
        }
        let crosses = Said::of_sign(jet.slope[1], way);
        let signs = [1.0, -1.0].map(|sign| Said::of_sign(jet.value, sign));
        let plain = Said::any([crosses, signs[0], signs[1]]);
        Said::all([is_arc(sides, edge, cell), plain])
    })
}

/// How far from q_Y its sides are looked at.
const NEAR_Y: f64 = 1e-13;

/// c, the arc at β = π/2 by q.
fn corner<S: Scalar>(q: S) -> S {
    let lambda0 = S::int(1) / q;
    let end = S::int(3) * S::pi() / S::int(2);
    arc(lambda0.asin(), end, lambda0)
}

/// That c has its one zero at q_Y, where it changes from negative to positive.
fn prove_corner(critical: Interval) -> Outcome {
    let c = || corner(Expr::symbol("q"));
    let written = || {
        let crossing = |way: f64| Condition::Any(vec![sign(c(), way), slope(c(), 0, 1.0)]);
        let before = Where::Below(0, dyadic(critical.lo()));
        (
            ["q"],
            vec![(before, crossing(-1.0)), (Where::Rest, crossing(1.0))],
        )
    };
    let once = everywhere_written(written, [ratios()], |cell| {
        let jet = over(|[q]| corner(q), cell);
        let before = cell[0].below(critical);
        let sign = Said::of_sign(jet.value, if before { -1.0 } else { 1.0 });
        Said::any([sign, Said::of_sign(jet.slope[0], 1.0)])
    })?;
    let mut parts = once;
    for way in [-1.0, 1.0] {
        let q = critical + Interval::point(way * NEAR_Y);
        let written = || (["q"], vec![(Where::Rest, sign(c(), way))]);
        parts += everywhere_written(written, [q], |cell| {
            Said::of_sign(over(|[q]| corner(q), cell).value, way)
        })?;
    }
    Ok(parts)
}

/// That B's arc is positive at β = 0: (54) has a root only where c is negative.
fn prove_beginning() -> Outcome {
    let written = || {
        let arc = arc_to(Edge::Beginning, [Expr::symbol("q"), Expr::int(0)]);
        (["q"], vec![(Where::Rest, sign(arc, 1.0))])
    };
    everywhere_written(written, [ratios()], |cell| {
        Said::of_sign(arc_to(Edge::Beginning, [cell[0], Interval::int(0)]), 1.0)
    })
}

fn prove_b(sides: Sides) -> Outcome {
    Ok(prove_single_root(sides, Edge::Beginning, -1.0)?
        + prove_beginning()?
        + prove_corner(q_y()?)?)
}

fn prove_e(sides: Sides) -> Outcome {
    Ok(prove_single_root(sides, Edge::End, 1.0)? + prove_corner(q_y()?)?)
}

/// (54) has one root before q_Y and none beyond.
pub fn b_once() -> Evidence {
    let compared = Compared::shown(
        r"(54) has one root for every $1\le q<q_Y$ and none for $q_Y<q\le12$, by the signs and slopes of the arc that ends at $\pi+\sin^{-1}(q\lambda_0)$",
    );
    let proof = given(&exact::EQ54.proof(), prove_b(printed::eq54_sides));
    certified(proof, Subject::Printed, compared)
}

/// E has no root before q_Y and one beyond.
pub fn e_once() -> Evidence {
    let compared = Compared::shown(
        r"E has no root but $\lambda_0=0$ for $1\le q<q_Y$ and one for every $q_Y<q\le12$, by the signs and slopes of the arc that ends at $2\pi-\sin^{-1}(q\lambda_0)$",
    );
    let proof = given(&exact::E.proof(), prove_e(corrected::e_sides));
    certified(proof, Subject::Corrected, compared).of_a_part()
}

/// λ₀ on A by (53): its left side is the cotangent of asin λ₀, so that λ₀ = 1/√(1 + r²) if its right side r is positive.
fn on_a<S: Scalar>(q: S) -> S {
    let [_, right] = printed::eq53_sides(printed::eq53_k(q), S::int(1));
    S::int(1) / (S::int(1) + right.squared()).sqrt()
}

/// That (53) has one root for each q: its left side falls from ∞ to 0, its right side is positive.
fn prove_a(sides: fn(Two, Two) -> [Two; 2]) -> Outcome {
    let by = |[q, lambda0]: [Two; 2]| sides(printed::eq53_k(q), lambda0);
    let range = [ratios(), Interval::new(1e-3, 1.0)];
    let apart = |lambda0: Expr| {
        let [left, right] = printed::eq53_sides(printed::eq53_k(Expr::symbol("q")), lambda0);
        left - right
    };
    let written = || {
        let f = apart(Expr::symbol("λ₀"));
        let either = Condition::Any(vec![sign(f, -1.0), slope(f, 1, -1.0)]);
        (["q", "λ₀"], vec![(Where::Rest, either)])
    };
    let falls = everywhere_written(written, range, |cell| {
        let [left, right] = by(Jet::variables(cell));
        let difference = left - right;
        let below = Said::of_sign(difference.value, -1.0);
        Said::any([below, Said::of_sign(difference.slope[1], -1.0)])
    })?;
    // At its ends, the lower one standing for all below.
    let written = || {
        // 1/1000 stands for all below: the left side is larger there.
        let both = [
            sign(apart(Expr::int(1) / Expr::int(1000)), 1.0),
            sign(apart(Expr::int(1)), -1.0),
        ];
        (["q"], vec![(Where::Rest, Condition::All(both.to_vec()))])
    };
    let ends = everywhere_written(written, [ratios()], |cell| {
        let difference = |lambda0| {
            let [left, right] = by([cell[0], lambda0].map(Jet::constant));
            (left - right).value
        };
        let at_least = Interval::new(0.0, 1e-3);
        match (
            difference(at_least).sign(),
            difference(Interval::int(1)).sign(),
        ) {
            (Some(1.0), Some(-1.0)) => Said::Holds,
            (Some(-1.0), _) | (_, Some(1.0)) => Said::Fails,
            _ => Said::Nothing,
        }
    })?;
    Ok(falls + ends)
}

/// (53) has one root.
pub fn a_once() -> Evidence {
    let compared = Compared::shown(
        r"(53) has one root in $0<\lambda_0<1$ for every $1\le q\le12$: with growing $\lambda_0$ the left side falls to 0 from above the right side",
    );
    certified(prove_a(printed::eq53_sides), Subject::Printed, compared)
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
    let written_arc = |edge| {
        let q = Expr::symbol("q");
        let lambda0 = self::on_a(q);
        arc_to(edge, [q, (q * lambda0).asin()])
    };
    let written = || {
        let arc = written_arc(Edge::Beginning);
        let first = Where::From(0, dyadic(1.0));
        (
            ["q"],
            vec![(first, slope(arc, 0, 1.0)), (Where::Rest, sign(arc, 1.0))],
        )
    };
    let before = everywhere_written(written, [Interval::new(1.0, y.hi())], |cell| {
        let jet = over(on(Edge::Beginning), cell);
        if cell[0].lo() == 1.0 {
            let corner = over(on(Edge::Beginning), &[Interval::int(1)]).value;
            Said::all([Said::of_zero(corner), Said::of_sign(jet.slope[0], 1.0)])
        } else {
            Said::of_sign(jet.value, 1.0)
        }
    })?;
    let written = || {
        (
            ["q"],
            vec![(Where::Rest, sign(written_arc(Edge::End), -1.0))],
        )
    };
    let beyond = everywhere_written(written, [Interval::new(y.lo(), 12.0)], |cell| {
        Said::of_sign(over(on(Edge::End), cell).value, -1.0)
    })?;
    Ok(before + beyond)
}

fn prove_order(on_a: fn(Jet<1>) -> Jet<1>, on_c: fn(Jet<1>) -> Jet<1>) -> Outcome {
    // C falls from 1, where D is; and on A, where the right side of (53) is positive, the sides are equal.
    let written = || {
        let q = Expr::symbol("q");
        let [_, right] = printed::eq53_sides(printed::eq53_k(q), Expr::int(1));
        let both = [sign(right, 1.0), slope(printed::eq55_lambda0(q), 0, -1.0)];
        (["q"], vec![(Where::Rest, Condition::All(both.to_vec()))])
    };
    let c = everywhere_written(written, [ratios()], |cell| {
        let q = Jet::constant(Interval::point(cell[0].mid()));
        let [left, right] = printed::eq53_sides(printed::eq53_k(q), on_a(q));
        let [_, all] = printed::eq53_sides(printed::eq53_k(cell[0]), Interval::int(1));
        let falls = Said::of_sign(over(|[q]| on_c(q), cell).slope[0], -1.0);
        let positive = Said::of_sign(all, 1.0);
        Said::all([Said::of_zero((left - right).value), positive, falls])
    })?;
    let b = prove_b(printed::eq54_sides)?;
    Ok(c + b + prove_e(corrected::e_sides)? + prove_a_lowest(on_a)?)
}

/// The order of the curves. Which motion lies between which of them it does not say.
pub fn order() -> Evidence {
    let compared = Compared::shown(
        r"$A<B<C<D$ for all $1<q<q_Y$ and $A<E<C<D$ for all $q_Y<q\le12$, with $A=B$ and $C=D$ at $q=1$, where the slopes of their differences have a sign",
    );
    let proof = prove_order(on_a, printed::eq55_lambda0);
    let proof = given(&exact::EQ54.proof(), given(&exact::E.proof(), proof));
    certified(proof, Subject::Corrected, compared).of_a_part()
}

/// Between E and C there is no backward motion: E is where the arc to the last moment is zero. About the rest of the
/// region's motion it says nothing.
pub fn e_below_c() -> Evidence {
    let compared = Compared::shown(
        r"the arc to the last moment at which the drive could pull backward is negative below E and positive between E and C, for every $q_Y<q\le12$",
    );
    let proof = given(&exact::E.proof(), prove_e(corrected::e_sides));
    certified(proof, Subject::Corrected, compared).of_a_part()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_statements_are_proved() {
        for evidence in [a_once(), b_once(), e_once(), order(), e_below_c()] {
            assert_eq!(
                evidence.worst,
                0.0,
                "{}: {}",
                evidence.comparison(),
                evidence.at
            );
        }
    }

    #[test]
    fn without_the_algebra_there_is_no_certificate() {
        let fails = Proof::impossible(
            "no",
            crate::exact::ExactError::UnknownSymbol {
                name: String::new(),
            },
        );
        assert!(given(&fails, Ok(3)).is_err());
        assert_eq!(given(&exact::E.proof(), Ok(3)).unwrap(), 3);
    }

    fn refused(proof: Outcome) {
        assert!(
            matches!(proof, Err(CertifiedError::False { .. })),
            "{proof:?}"
        );
    }

    #[test]
    fn mutated_statements_are_refused() {
        refused(prove_b(corrected::e_sides));
        refused(prove_e(printed::eq54_sides));
        refused(prove_b(|l, u| {
            let [left, right] = printed::eq54_sides(l, u);
            [left, right + l / Two::int(1_000_000)]
        }));
        refused(prove_corner(q_y().unwrap() + Interval::point(1e-12)));
        // A raised by a part in a thousand crosses B.
        refused(prove_a_lowest(|q| {
            on_a(q) * Jet::int(1001) / Jet::int(1000)
        }));
        // A with the right side's sign changed.
        refused(prove_a(|k, l| {
            let [left, right] = printed::eq53_sides(k, l);
            [left, -right]
        }));
        refused(prove_order(on_a, |q| q));
    }

    #[test]
    fn the_parts_of_a_statement_are_those_of_all_its_steps() {
        let [b, e] = [printed::eq54_sides, corrected::e_sides] as [Sides; 2];
        let corner = prove_corner(q_y().unwrap()).unwrap();
        let beginning = prove_beginning().unwrap();
        let single = |sides, edge, way| prove_single_root(sides, edge, way).unwrap();
        let parts = single(b, Edge::Beginning, -1.0) + beginning + corner;
        assert_eq!(prove_b(b).unwrap(), parts);
        let parts = single(e, Edge::End, 1.0) + corner;
        assert_eq!(prove_e(e).unwrap(), parts);
    }

    #[test]
    fn beyond_its_root_a_difference_may_rise_below_zero() {
        // l² − 3l/2 + 2/5 falls through its root and rises from 3/4 to −1/10 at 1.
        let sides = |_, l: Two| {
            let [half, rest] = [Two::int(1) / Two::int(2), Two::int(9) / Two::int(10)];
            [l.squared() - l - l * half + rest, half]
        };
        assert!(prove_a(sides).is_ok());
    }
}
