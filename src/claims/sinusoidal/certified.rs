//! Section 2.2, on the whole range of λ₀: the bracket of φ̃₂, and the one change at λ_c.
//!
//! *The bracket.* The slope of (32)'s left side by φ, sin φ − λ₀, is positive from φ₁ to φ₂ and negative from φ₂ to
//! φ₄, and the left side is 0 at φ₁. If it is positive at φ₂ and negative at φ₄, it has exactly one zero between φ₁
//! and φ₄, beyond φ₂. Both signs are found by subdivision in φ₁, λ₀ = sin φ₁. As λ₀ → 1 the left side at φ₂ vanishes
//! to the third order, as λ₀ → 0 the one at φ₄ to the first: there the first coefficient that is left of its power
//! series, enclosed on all of the part next to the end, bounds the remainder.
//!
//! *The change.* φ̃₁ has no slope by λ₀ at its end, λ₀ = 2/π. By φ̃₁ itself, λ₀ = 2 cos φ̃₁/π, everything has one,
//! from φ̃₁ = 0 to λ₀ = 0, φ̃₁ = π/2.

mod premises;

use super::prelude::*;
use crate::validated::numbers::LAMBDA_C;
use premises::by_phi1;
use trialbook::certified::cover::{Said, everywhere};
use trialbook::certified::interval::Interval;
use trialbook::certified::jet::{Jet, over};
use trialbook::certified::taylor::Taylor;
use trialbook::trials::enclosed::{certified, numbers, on_balls, resting_on};

type One = Jet<1>;
type Outcome = Result<usize, CertifiedError>;

/// λ_c on an f64's both sides.
const NEAR_CRITICAL: f64 = 1e-14;

/// From 0 to a right angle.
fn angles() -> Interval {
    Interval::new(0.0, (Interval::pi() / Interval::int(2)).hi())
}

/// That a function of b has the sign of `wanted` for 0 < b ≤ π/2, if at 0 it vanishes with its first `order` − 1
/// derivatives.
fn prove_sign(f: Expr, order: usize, wanted: f64) -> Outcome {
    fn at<S: Scalar>(f: Expr, b: S, unknown: S) -> S {
        f.evaluate(&|_| Some(b)).unwrap_or(unknown)
    }
    everywhere([angles()], |cell| {
        let quantity = if cell[0].lo() == 0.0 {
            let b = Taylor::<4>::variable(cell[0]);
            at(f, b, Taylor::UNKNOWN).coefficients()[order]
        } else {
            over(|[b]| at(f, b, Jet::constant(Interval::WHOLE)), cell).value
        };
        Said::of_sign(quantity, wanted)
    })
}

fn phases() -> [Expr; 3] {
    let lambda0 = symbol("λ₀");
    [
        printed::eq27_phi1(lambda0),
        printed::eq28_phi2(lambda0),
        printed::eq30_phi4(lambda0),
    ]
}

fn left() -> Expr {
    let [lambda0, phi1, phi] = ["λ₀", "φ₁", "φ"].map(symbol);
    printed::eq32_left(lambda0, phi1, phi)
}

/// φ₂ < φ̃₂ < φ₄.
fn prove_bracket(phases: [Expr; 3], left: Expr, compared: Compared) -> Evidence {
    let at = |phi1: Expr, which: usize| {
        let phi = by_phi1(phi1)[which];
        let left = left.with("φ", phi);
        left.with("φ₁", phi1).with("λ₀", phi1.sin())
    };
    let b = symbol("b");
    // From the end at which each vanishes: λ₀ = 1, and λ₀ = 0.
    let second = at(pi() / 2 - b, 1);
    let fourth = at(b, 2);
    let premises = [
        premises::phases(phases, left),
        premises::vanishing(second, 3),
        premises::vanishing(fourth, 1),
    ];
    let signs = || Ok(prove_sign(second, 3, 1.0)? + prove_sign(fourth, 1, -1.0)?);
    resting_on(&premises, signs, Printed, compared)
}

pub(crate) fn bracket() -> Evidence {
    let compared = Compared::shown(
        r"(32) has its signs at $\phi_2$ and $\phi_4$ for all $0<\lambda_0<1$, by subdivision, and next to $\lambda_0=1$ and $\lambda_0=0$ by series whose remainders are bounded",
    );
    prove_bracket(phases(), left(), compared)
}

fn prove_slope(f: impl Fn(One) -> One, way: f64, range: Interval) -> Outcome {
    everywhere([range], |cell| {
        Said::of_sign(f(Jet::variables(cell)[0]).slope[0], way)
    })
}

/// That a function of λ₀ changes from positive to negative within [`NEAR_CRITICAL`] of `critical`.
fn prove_change(f: fn(One) -> One, critical: Interval) -> Outcome {
    let mut parts = 0;
    for (off, wanted) in [(-NEAR_CRITICAL, 1.0), (NEAR_CRITICAL, -1.0)] {
        let at = critical + Interval::point(off);
        parts += everywhere([at], |cell| {
            Said::of_sign(over(|[x]| f(x), cell).value, wanted)
        })?;
    }
    Ok(parts)
}

fn prove_threshold(left: fn(One) -> One, critical: Interval) -> Outcome {
    let falls = prove_slope(left, -1.0, Interval::new(0.0, 1.0))?;
    Ok(falls + prove_change(left, critical)?)
}

pub(crate) fn threshold() -> Evidence {
    let compared = Compared::shown(
        r"the left side of (35) falls for all $0\le\lambda_0\le1$ and changes its sign within $10^{-14}$ of (37)",
    );
    let proof = prove_threshold(printed::eq35_left, printed::eq37_lambda_c());
    certified(proof, Printed, compared)
}

/// φ̃₁ − φ₁.
fn turn<S: Scalar>(lambda0: S) -> S {
    let [later, earlier] =
        printed::eq41_sides(printed::eq39_phi_t1(lambda0), printed::eq27_phi1(lambda0));
    later - earlier
}

/// The same by φ̃₁.
fn turn_by_itself<S: Scalar>(phi_t1: S) -> S {
    let lambda0 = S::int(2) * phi_t1.cos() / S::pi();
    let [later, earlier] = printed::eq41_sides(phi_t1, printed::eq27_phi1(lambda0));
    later - earlier
}

fn prove_turns(phi_t1: Expr, critical: Interval, compared: Compared) -> Evidence {
    let change = || {
        let falls = prove_slope(turn_by_itself::<One>, 1.0, angles())?;
        Ok(falls + prove_change(turn, critical)?)
    };
    resting_on(&[premises::turn(phi_t1)], change, Printed, compared)
}

pub(crate) fn turns() -> Evidence {
    let compared = Compared::shown(
        r"$\tilde\phi_1-\phi_1$ falls for all $0\le\lambda_0\le2/\pi$, both ends included, by its slope in $\tilde\phi_1$, and changes its sign within $10^{-14}$ of (37)",
    );
    let phi_t1 = printed::eq39_phi_t1::tree();
    prove_turns(phi_t1, printed::eq37_lambda_c(), compared)
}

/// (37), fifty digits.
pub(crate) fn lambda_c() -> Evidence {
    let compared = Compared::one(
        "(37), to 50 digits,",
        r"the enclosure of $\sin\phi_1$ for the one $\phi_1$ in $(0.5,0.6)$ from which an arc of Newton's law ends half a period later",
    );
    numbers([("lambda-c", LAMBDA_C)], Printed, compared, |bits| {
        [on_balls(printed::eq37_lambda_c::<Expr>(), bits, &|_| None)]
    })
}

attempts![
    one_end = {
        let compared = Compared::shown(
            r"(32) rises from 0 at $\phi_1$ to $\phi_2$, is positive there, falls from there on and is negative at $\phi_4$: it has one solution in between for every $0<\lambda_0<1$",
        );
        prove_bracket(phases(), left(), compared)
    },
    threshold,
    lambda_c,
    turns,
    bracket,
    // φ̃₂ = φ₄ without friction, where (32) has the solution 2π.
    bracket_outside = {
        let zero = int(0);
        let end = printed::eq30_phi4(zero);
        let left = printed::eq32_left(zero, printed::eq27_phi1(zero), end);
        Trial::by(
            Certified,
            Outside,
            Compared::constant(
                r"1, for $\tilde\phi_2<\phi_4$",
                r"whether $\phi_4$ is no solution of (32) (1 if so)",
            )
            .over(r"$\lambda_0=0$"),
            NONE,
        )
        .over([premises::solution(left)], |proof| {
            Ok(Pair::plain("λ₀ = 0".into(), 1.0, is(!proof.holds())))
        })
    }
];

#[cfg(test)]
mod tests {
    use super::*;

    const NOTHING: Compared = Compared::shown("");
    use crate::claims::PAPER;
    use crate::seeded::with;
    use trialbook::certified::ball::Ball;

    fn assert_refused(evidence: &Evidence) {
        assert_eq!(evidence.worst, f64::INFINITY, "{}", evidence.at);
    }

    #[test]
    fn a_changed_bracket_is_refused() {
        let [a, b, d] = phases();
        assert_refused(&prove_bracket([a, d, b], left(), NOTHING));
        let lambda0 = symbol("λ₀");
        let far = 1 - lambda0.squared();
        for [n, m, k, l] in [
            [2, 1, 1, 2],
            [1, 1000, 1, 0],
            [1, 100, 1, 1],
            [1, 100, 0, 2],
        ] {
            let off = lambda0.pow(int(k)) * far.pow(int(l));
            let off = int(n) * off / int(m);
            assert_refused(&prove_bracket(phases(), left() - off, NOTHING));
        }
        let holds = || prove_bracket(phases(), left(), NOTHING).worst == 0.0;
        let kept = PAPER.formulas.variants_of("eq32_left").into_iter();
        let kept = kept.filter(|variant| with(variant.seed, holds));
        let kept: Vec<_> = kept.map(|variant| variant.text).collect();
        assert!(kept.is_empty(), "{kept:?}");
    }

    #[test]
    fn a_changed_change_is_refused() {
        let critical = printed::eq37_lambda_c::<Interval>();
        let off = critical + Interval::point(1e-13);
        let threshold =
            |left, critical| certified(prove_threshold(left, critical), Printed, NOTHING);
        assert_refused(&threshold(printed::eq35_left, off));
        assert_refused(&threshold(|l| -printed::eq35_left(l), critical));
        let phi_t1 = printed::eq39_phi_t1::tree();
        assert_refused(&prove_turns(phi_t1, off, NOTHING));
        for variant in PAPER.formulas.variants_of("eq39_phi_t1") {
            let phi_t1 = || printed::eq39_phi_t1::tree();
            let evidence = prove_turns(with(variant.seed, phi_t1), critical, NOTHING);
            assert_ne!(evidence.worst, 0.0, "{}", variant.text);
        }
    }

    #[test]
    fn a_wrong_digit_is_refused() {
        let stated = |bits: usize| {
            let small = Ball::ratio(1, 10_i64.pow(16), bits)?;
            let tiny = &(&small * &small) * &small;
            Some(on_balls(printed::eq37_lambda_c::<Expr>(), bits, &|_| None)? + tiny)
        };
        let evidence = numbers([("lambda-c", LAMBDA_C)], Printed, NOTHING, |bits| {
            [stated(bits)]
        });
        assert_eq!(evidence.worst, f64::INFINITY);
    }

    #[test]
    fn the_turn_by_itself_is_the_turn_by_the_friction() {
        for k in 0..=15 {
            let phi = Interval::ratio(k, 10);
            let lambda0 = Interval::int(2) * phi.cos() / Interval::pi();
            let by_friction = if k == 0 {
                // φ̃₁ = 0 less the phase at λ₀ = 2/π.
                -lambda0.asin()
            } else {
                turn(One::constant(lambda0)).value
            };
            let by_itself = turn_by_itself(One::constant(phi)).value;
            assert!(
                by_itself.meet(by_friction).is_some(),
                "{by_itself} {by_friction}"
            );
            assert!(by_itself.width() < 1e-13, "{by_itself}");
        }
    }

    #[test]
    fn one_order_more_than_vanishes_is_looked_at() {
        let b = symbol("b");
        let proof = premises::vanishing(b - b.sin(), 3);
        assert!(proof.holds(), "{proof}");
        assert_eq!(proof.steps()[0].gives, "b − sin(b) = [1/6] b^3 + O(b^5)");
        let proof = premises::vanishing(1 - b.cos(), 2);
        assert_eq!(proof.steps()[0].gives, "1 − cos(b) = [1/2] b^2 + O(b^4)");
        assert!(!premises::vanishing(b - b.sin(), 4).holds());
    }
}
