//! Section 2.2, on the whole range of λ₀: the bracket of φ̃₂, and the one change at λ_c.
//!
//! *The bracket.* The slope of (32)'s left side by φ is sin φ − λ₀: positive from φ₁ to φ₂, where the sine is above
//! its value λ₀ at both ends, and negative from φ₂ to φ₄, where it is below. The left side is 0 at φ₁. If it is
//! positive at φ₂ and negative at φ₄, it has therefore exactly one zero between φ₁ and φ₄, and that is between φ₂
//! and φ₄. Both signs are found by subdivision in b, λ₀ = cos b, but for the ends:
//!
//! - b → 0 (λ₀ → 1): at φ₂ the left side is 2 (sin b − b cos b) = Σ ± 4k b²ᵏ⁺¹/(2k+1)!, whose terms alternate and
//!   fall, so that it lies between 2b³/3 − b⁵/15 and 2b³/3;
//! - b → π/2 (λ₀ → 0): at φ₄ it is 0 at λ₀ = 0, and its slope by b is positive.

use crate::certified::cover::{Said, everywhere};
use crate::certified::error::CertifiedError;
use crate::certified::interval::{Interval, PI};
use crate::certified::jet::{Jet, over};
use crate::claims::enclosed::{certified, numbers, on_balls};
use crate::evidence::{Evidence, Subject};
use crate::exact::Expr;
use crate::paper::sinusoidal as printed;
use crate::scalar::Scalar;

type One = Jet<1>;
type Outcome = Result<usize, CertifiedError>;

/// λ_c on an f64's both sides.
const NEAR_CRITICAL: f64 = 1e-14;

fn formulas(lambda0: One) -> [One; 3] {
    [
        printed::eq27_phi1(lambda0),
        printed::eq28_phi2(lambda0),
        printed::eq30_phi4(lambda0),
    ]
}

/// φ₂ < φ̃₂ < φ₄, from the phases φ₁, φ₂, φ₄ and (32)'s left side as functions of λ₀, φ₁ and φ.
fn prove_bracket(phases: fn(One) -> [One; 3], left: fn(One, One, One) -> One) -> Outcome {
    // Where the series takes over, and up to where it is held against the formula.
    let (least, most) = (0.125, 0.25);
    let right_angle = PI / Interval::int(2);
    let at = |which: usize| {
        move |[b]: [One; 1]| {
            let lambda0 = b.cos();
            let phases = phases(lambda0);
            left(lambda0, phases[0], phases[which])
        }
    };
    let second = everywhere([Interval::new(least, right_angle.hi())], |cell| {
        Said::of_sign(over(at(1), cell).value, 1.0)
    })?;
    let series = everywhere([Interval::new(least, most)], |cell| {
        let b = cell[0];
        let value = over(at(1), cell).value / (b * b.squared());
        let low = Interval::ratio(2, 3) - b.squared() / Interval::int(15);
        let allowed = low.hull(Interval::ratio(2, 3)).widened(1e-9);
        match value.meet(allowed) {
            None => Said::Fails,
            Some(_) if value.width() < 0.1 => Said::Holds,
            Some(_) => Said::Nothing,
        }
    })?;
    let range = Interval::new(0.0, right_angle.hi());
    let fourth = everywhere([range], |cell| {
        let jet = over(at(2), cell);
        if cell[0].hi() == range.hi() {
            Said::of_sign(jet.slope[0], 1.0)
        } else {
            Said::of_sign(jet.value, -1.0)
        }
    })?;
    Ok(second + series + fourth)
}

/// φ₂ < φ̃₂ < φ₄.
pub fn bracket() -> Evidence {
    let compared = "the signs of (32) at φ₂ and φ₄ for all 0 < λ₀ < 1: by subdivision, for 1 − λ₀ below 0.008 by a series whose remainder is bounded, and as λ₀ → 0 by the slope";
    let proof = prove_bracket(formulas, printed::eq32_left);
    certified(proof, Subject::Printed, compared)
}

/// (32) has one solution between φ₁ and φ₄.
pub fn one_end() -> Evidence {
    let compared = "(32) rises from 0 at φ₁ to φ₂, is positive there, falls from there on and is negative at φ₄: one solution in between for every 0 < λ₀ < 1";
    let proof = prove_bracket(formulas, printed::eq32_left);
    certified(proof, Subject::Printed, compared)
}

/// That `f` falls with λ₀ on `range`, and changes its sign within [`NEAR_CRITICAL`] of `critical`.
fn prove_one_change(f: fn(One) -> One, critical: Interval, range: Interval) -> Outcome {
    let parts = everywhere([range], |cell| {
        Said::of_sign(f(Jet::variables(cell)[0]).slope[0], -1.0)
    })?;
    let signs = [(-NEAR_CRITICAL, 1.0), (NEAR_CRITICAL, -1.0)];
    let mut changes = 0;
    for (off, wanted) in signs {
        let at = critical + Interval::point(off);
        changes += everywhere([at], |cell| {
            Said::of_sign(over(|[x]| f(x), cell).value, wanted)
        })?;
    }
    Ok(parts + changes)
}

/// (35) changes its sign once, at λ_c of (37).
pub fn threshold() -> Evidence {
    let compared =
        "the left side of (35) falls for all 0 ≤ λ₀ ≤ 1 and changes its sign within 1e-14 of (37)";
    let range = Interval::new(0.0, 1.0);
    let proof = prove_one_change(printed::eq35_left, printed::eq37_lambda_c(), range);
    certified(proof, Subject::Printed, compared)
}

/// φ̃₁ − φ₁.
fn turn(lambda0: One) -> One {
    let [later, earlier] =
        printed::eq41_sides(printed::eq39_phi_t1(lambda0), printed::eq27_phi1(lambda0));
    later - earlier
}

/// (41) holds exactly below λ_c.
pub fn turns() -> Evidence {
    let compared = "φ̃₁ − φ₁ falls for all 0 ≤ λ₀ ≤ (1 − 1e-12) 2/π, beyond which φ̃₁ falls to 0 and φ₁ goes on rising, and changes its sign within 1e-14 of (37)";
    let end = Interval::int(2) / PI * Interval::point(1.0 - 1e-12);
    let range = Interval::new(0.0, end.lo());
    let proof = prove_one_change(turn, printed::eq37_lambda_c(), range);
    certified(proof, Subject::Printed, compared)
}

/// (37), fifty digits.
pub fn lambda_c() -> Evidence {
    let compared = "(37) to 50 digits with the enclosure of the one friction in (0.48, 0.56) under which an arc of Newton's law ends half a period after it began";
    numbers(["lambda-c"], Subject::Printed, compared, |bits| {
        [on_balls(printed::eq37_lambda_c::<Expr>(), bits, &|_| None)]
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::certified::ball::Ball;

    #[test]
    fn the_statements_are_proved() {
        for evidence in [bracket(), one_end(), threshold(), turns(), lambda_c()] {
            assert_eq!(
                evidence.worst, 0.0,
                "{}: {}",
                evidence.compared, evidence.at
            );
        }
    }

    fn refused(proof: Outcome) {
        assert!(
            matches!(proof, Err(CertifiedError::False { .. })),
            "{proof:?}"
        );
    }

    #[test]
    fn mutated_statements_are_refused() {
        let less: fn(_, _, _) -> _ = |l, a, b| printed::eq32_left(l, a, b) - l / One::int(1000);
        let double: fn(_, _, _) -> _ = |l: One, a, b| printed::eq32_left(l + l, a, b);
        refused(prove_bracket(formulas, less));
        refused(prove_bracket(formulas, double));
        refused(prove_bracket(
            |l| {
                let [a, b, d] = formulas(l);
                [a, d, b]
            },
            printed::eq32_left,
        ));
        let whole = Interval::new(0.0, 1.0);
        let critical = printed::eq37_lambda_c::<Interval>();
        let off = critical + Interval::point(1e-13);
        refused(prove_one_change(printed::eq35_left, off, whole));
        refused(prove_one_change(
            |l| -printed::eq35_left(l),
            critical,
            whole,
        ));
        refused(prove_one_change(turn, off, Interval::new(0.0, 0.6)));
    }

    #[test]
    fn a_wrong_digit_is_refused() {
        let stated = |bits: usize| {
            let small = Ball::ratio(1, 10_i64.pow(16), bits)?;
            let tiny = &(&small * &small) * &small;
            Some(on_balls(printed::eq37_lambda_c::<Expr>(), bits, &|_| None)? + tiny)
        };
        let evidence = numbers(["lambda-c"], Subject::Printed, "", |bits| [stated(bits)]);
        assert_eq!(evidence.worst, f64::INFINITY);
    }
}
