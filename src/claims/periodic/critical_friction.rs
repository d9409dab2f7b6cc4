//! That some λ_c divides large friction, with rests, from small friction, without: above the mean of |h| there are rests, and none
//! where |h| exceeds the friction wherever H is near its median.
//!
//! H is an antiderivative of h, and c its median: H is above c for half of each period at most, and below c for half at most.

use super::chains::{h, never_part, rate, slows, with_sign};
use super::prelude::*;
use super::step_drive::CHANGES;
use crate::claims::general::contraction::never_farther_apart;
use crate::claims::general::strong_drives::MOVES;
use crate::claims::general::two_frames::eq2;

pub(crate) const THRESHOLD: Statement<(Expr, Expr, [Expr; 2])> = Statement::shown(
    Printed,
    r"for every piecewise continuous $h$ of the period $2\pi$, at each phase one of its one-sided limits, with the largest size 1, which is smaller for some time, and which, if its mean $m$ is 0, does not vanish, nor has the limit 0 from one side, where its antiderivative $H$ is at its median $c$: from every start, with any velocity across, there is rest for some time and motion for some time in every late period if $\langle\lvert h\rvert\rangle<\lambda_0<1$, and from some time on no rest if $0<\lambda_0<\min(\delta,\eta/\pi)$, where $\lvert h\rvert\ge\delta$ wherever $\lvert H-c\rvert\le\eta$, or if $m\ne0$ and $0<\lambda_0<\lvert m\rvert$. So there is a least number $\lambda_\mathrm c$ such that all $\lambda_0$ between it and 1 have rests, with $0<\lambda_\mathrm c<1$; and for one $h$ the behaviour changes at two more values at least",
    || (eq2(), rate(), printed::s23_rests()),
    |(law, rate, kinds)| Proof::for_both_signs(|sign| threshold(law, rate, kinds, sign)),
);

fn ring(sign: i64) -> Result<Ring, ExactError> {
    let mut ring = Ring::of(["λ₀", "M", "m", "𝔴₀", "n", "H", "c", "ℓ", "P", "η"]);
    ring.angle("ψ");
    let w = ring.symbol("𝔴");
    ring.root_is(&w.pow(2), 2, &(&w * &Rational::int(sign)))?;
    Ok(ring)
}

fn threshold(law: Expr, rate: Expr, [little, much]: [Expr; 2], sign: i64) -> Proof {
    Proof::in_ring("Between small and large friction", ring(sign), |p| {
        p.rests_on(&never_part(rate))?;
        p.rests_on(&never_farther_apart())?;
        p.rests_on(&slows(law))?;
        rest_on(p, &[&MOVES])?;
        with_sign(p, sign);
        above_the_mean(p, rate, sign)?;
        let stated = p.read("What is stated for much friction, 1 for rests", much)?;
        p.reads_as(&stated, "", int(1))?;
        near_the_median(p, rate, sign)?;
        against_a_mean(p, rate, sign)?;
        p.vanishes("What is stated for little friction, 0 for none", little)?;
        p.note(
            "Let λ_c be the least number such that for each λ₀ between it and 1 there are rests in every late period, from every start",
            "it is M at most, and not below the λ₀ for which there are none",
        );
        rest_on(p, &[&CHANGES])
    })
}

/// M < λ₀ < 1: rests.
fn above_the_mean(p: &mut Prover<'_>, rate: Expr, sign: i64) -> Result<(), Obstacle> {
    let [lambda0, mean, start, n] = symbols(["λ₀", "M", "𝔴₀", "n"]);
    let period = 2 * pi();
    let signed = int(sign);
    p.identity(
        ("d|𝔴|/dφ by (26)", signed * rate),
        ("at most |h| − λ₀", signed * h() - lambda0),
    )?;
    let gain = period * (mean - lambda0);
    p.vanishes(
        "With the speed 𝔴₀ at first, after n = 𝔴₀/(2π (λ₀ − M)) periods without rest there is left at most",
        start + gain * (start / (period * (lambda0 - mean))),
    )?;
    p.identity(
        (
            "From 0, where a rest ends, a period without rest would leave at most",
            (start + gain * n).with("𝔴₀", int(0)).with("n", int(1)),
        ),
        ("negative, as no size is", -(period * (lambda0 - mean))),
    )?;
    Ok(())
}

/// m = 0 and little friction: no rest.
fn near_the_median(p: &mut Prover<'_>, rate: Expr, sign: i64) -> Result<(), Obstacle> {
    let [lambda0, m, level, median, w] = symbols(["λ₀", "m", "H", "c", "𝔴"]);
    let [length, forward, near] = symbols(["ℓ", "P", "η"]);
    let [zero, two, pi] = [int(0), int(2), pi()];
    let signed = int(sign);
    let falls = two * pi * signed * (rate - h() + m);
    p.identity(
        (
            "In a period of one sign |𝔴| changes by 2π times its rate by (26), with m for h",
            falls.with("m", zero),
        ),
        ("", -(two * pi * lambda0)),
    )?;

    let motion = [("𝔴", p.ring().read(rate)?), ("H", p.ring().read(h())?)];
    let motion = p.ring().along(&motion)?;
    let friction = p.read("G = 𝔴 − (H − c)", w - (level - median))?;
    let slope = p.derivative("Its rate by (26), with h for that of H", &friction, &motion)?;
    p.reads_as(
        &slope,
        "the other way round for the other sign, and no larger in size during a rest",
        -(signed * lambda0),
    )?;
    let room = pi.squared() - length * (two * pi - length);
    p.identity(
        (
            "Let ℓ be the phase from one place to another in a period: π² less ℓ (2π − ℓ)",
            room,
        ),
        ("a square, which is not negative", (pi - length).squared()),
    )?;
    p.identity(
        (
            "Let 𝔴 > 0 for the phase P in each period, in which G then rises by at most",
            lambda0 * (two * pi - forward) - lambda0 * forward,
        ),
        (
            "so that P ≤ π, as G returns",
            -(two * lambda0 * (forward - pi)),
        ),
    )?;
    let margin = near - pi * lambda0;
    p.identity(
        (
            "For λ₀ < η/π let E = η − πλ₀, which is positive; E and πλ₀",
            margin + pi * lambda0,
        ),
        ("", near),
    )?;
    Ok(())
}

/// 0 < λ₀ < |m|: no rest either.
fn against_a_mean(p: &mut Prover<'_>, rate: Expr, sign: i64) -> Result<(), Obstacle> {
    let lambda0 = symbol("λ₀");
    let signed = int(sign);
    for (says, way) in [("m > 0", 1), ("m < 0", -1)] {
        let way = int(way);
        p.note("The case", says);
        let beyond = way * rate - (way * h() - lambda0);
        let stated = lambda0 * (1 - way * signed);
        p.identity(
            (
                "The rate of ±𝔴 by (26), with the sign of m, less ±h − λ₀",
                beyond,
            ),
            ("0 or 2λ₀, not negative", stated),
        )?;
    }
    Ok(())
}

attempts![&THRESHOLD];

#[cfg(test)]
mod tests {
    use super::*;

    fn small() -> Expr {
        symbol("λ₀") / int(1_000_000)
    }

    /// Each argument by itself needs the friction of (26), which is as strong at every velocity.
    #[test]
    fn each_part_refuses_a_friction_that_grows_with_the_velocity() {
        let w = symbol("𝔴");
        let (rate, wrong) = (rate(), rate() - small() * w);
        type Steps = fn(&mut Prover<'_>, Expr, i64) -> Result<(), Obstacle>;
        let parts: [Steps; 3] = [above_the_mean, near_the_median, against_a_mean];
        for steps in parts {
            for sign in [1, -1] {
                let holds =
                    |rate| Proof::in_ring("A part", ring(sign), |p| steps(p, rate, sign)).holds();
                assert!(holds(rate));
                assert!(!holds(wrong));
            }
        }
    }
}
