//! Theorems about every drive h of size 1 at most, by (26) with h for the sine, and about the pulses at their two
//! extremes.

use super::exact::{EQ44, EQ46};
use super::prelude::*;
use crate::claims::general::chains::STOPS;
use crate::claims::general::two_frames::eq2_proof;
use crate::corrections::periodic as corrected;
use crate::paper::sinusoidal::eq26_rate;

/// d𝔴/dφ by (26) where h is the sine of some angle ψ: any number from −1 to 1 is one.
pub(super) fn rate() -> Expr {
    let [lambda0, psi, w] = symbols(["λ₀", "ψ", "𝔴"]);
    eq26_rate(lambda0, psi, w)
}

fn ring(sign: i64) -> Result<Ring, ExactError> {
    let mut ring = Ring::of(["λ₀", "η", "φ", "𝔴₀", "s", "m", "E", "h"]);
    ring.angle("ψ");
    let w = ring.symbol("𝔴");
    ring.root_is(&w.pow(2), 2, &(&w * &Rational::int(sign)))?;
    Ok(ring)
}

pub(in crate::claims) fn side(sign: i64) -> &'static str {
    if sign > 0 { "𝔴 > 0" } else { "𝔴 < 0" }
}

/// Which [`Proof::for_both_signs`] carries out.
pub(super) fn with_sign(p: &mut Prover<'_>, sign: i64) {
    p.note(
        "The proof is for either sign of 𝔴, here for",
        format!("{}; h is sin ψ, any number from −1 to 1", side(sign)),
    );
}

/// The drive in the place of the sine, any number from −1 to 1.
pub(super) fn h() -> Expr {
    symbol("ψ").sin()
}

/// By (26) two velocities under one h come no farther apart, and closer by 2λ₀ while they have opposite signs.
pub(super) fn never_part(rate: Expr) -> Proof {
    Proof::for_both_signs(|sign| {
        let ring = || -> Result<Ring, ExactError> {
            let mut ring = Ring::new();
            ring.symbol("λ₀");
            ring.angle("ψ");
            for (name, sign) in [("𝔴", sign), ("𝔴₁", sign), ("𝔴₂", -sign)] {
                let w = ring.symbol(name);
                ring.root_is(&w.pow(2), 2, &(&w * &Rational::int(sign)))?;
            }
            Ok(ring)
        };
        Proof::in_ring(
            "Two velocities under one drive h along the line",
            ring(),
            |p| {
                p.shows("By (26) with any h, |h| ≤ 1, for the sine: the distance of two velocities along x stays while they have the same sense, falls at the rate 2λ₀ while they have opposite ones, and does not grow while one particle rests.");
                with_sign(p, sign);
                let [lambda0, same, other] = symbols(["λ₀", "𝔴₁", "𝔴₂"]);
                p.vanishes("d(𝔴 − 𝔴₁)/dφ by (26)", rate - rate.with("𝔴", same))?;
                let signed = int(sign);
                let closer = signed * (rate - rate.with("𝔴", other));
                p.identity(
                    ("The rate of the distance of 𝔴 from 𝔴₂", closer),
                    ("", -(2 * lambda0)),
                )?;
                p.identity(
                    ("That of its distance from 0", signed * rate),
                    (
                        "not positive while another particle rests, as |h| ≤ λ₀ then",
                        signed * h() - lambda0,
                    ),
                )
            },
        )
    })
}

pub(super) fn slows(law: Expr) -> Proof {
    let ring = || -> Result<Ring, ExactError> {
        let mut ring = Ring::new();
        let [_, vx, vy] = ring.symbols(["λ₀", "v_x", "v_y"]);
        ring.angle("ψ");
        ring.root(&(vx.pow(2) + vy.pow(2)), 2)?;
        Ok(ring)
    };
    Proof::in_ring("The speed under h and friction", ring(), |p| {
        p.shows("Under a drive h along x, whatever v_y is: dv/dφ = h v_x/v − λ₀, which is |h| − λ₀ at most.");
        p.rests_on(&eq2_proof(law))?;
        let [lambda0, vx, vy] = symbols(["λ₀", "v_x", "v_y"]);
        let speed = (vx.squared() + vy.squared()).sqrt();
        let in_units = law.with("μ", lambda0).with("g", int(1));
        let driven = in_units.with("A_x", -h()).with("A_y", int(0));
        p.identity(("dv/dφ by (2)", driven), ("", h() * vx / speed - lambda0))?;
        p.identity(
            ("1 − (v_x/v)²", 1 - (vx / speed).squared()),
            (
                "a square, so that v_x/v is 1 at most",
                (vy / speed).squared(),
            ),
        )
    })
}

/// λ₀ > 1: rest.
pub(crate) const REST_ABOVE_ONE: Statement<(Expr, [Expr; 2])> = Statement::shown(
    Printed,
    r"for every $h$ with $\lvert h\rvert\le1$, every $\lambda_0>1$ and every start (26) with $h$ for the sine gives $\mathrm d\lvert\mathfrak w\rvert/\mathrm d\phi\le1-\lambda_0<0$, so that the particle is at rest after $\lvert\mathfrak w_0\rvert/(\lambda_0-1)$ at the latest, and stays, as $\lvert h\rvert<\lambda_0$",
    || (rate(), printed::s23_rest_sides::tree()),
    |(rate, sides)| Proof::for_both_signs(|sign| rest_above_one(rate, sides, sign)),
);

fn rest_above_one(rate: Expr, [left, right]: [Expr; 2], sign: i64) -> Proof {
    Proof::in_ring("Very large friction: rest", ring(sign), |p| {
        rest_on(p, &[&STOPS])?;
        let [psi, start] = symbols(["ψ", "𝔴₀"]);
        with_sign(p, sign);
        let signed = int(sign);
        let speed = p.read("d|𝔴|/dφ by (26)", signed * rate)?;
        let room = p.read("The left less the right side", left - right)? - &speed;
        let half = psi / 2;
        let square = (half.sin() - signed * half.cos()).squared();
        let square = p.read("A square, which is not negative", square)?;
        p.equal("That less the rate is the square", &room, &square)?;
        let time = start / (right - left);
        p.vanishes(
            "The line |𝔴₀| − d φ at φ = |𝔴₀|/d, d being the right less the left side, with 𝔴₀ for its size",
            start - (right - left) * time,
        )?;
        Ok(())
    })
}

pub(crate) const MOSTLY_AT_REST: Statement<(Expr, Expr)> = Statement::shown(
    Printed,
    r"for every $h$ with $\lvert h\rvert\le1$ and every start, with $\lambda_0=1-s^2$: as $\mathrm d\lvert\mathfrak w\rvert/\mathrm d\phi\le\lvert h\rvert-\lambda_0$ by (26) and $\lvert\mathfrak w\rvert\ge0$, at large times the phases at which it moves although $\lvert h\rvert\le1-s$ are, in the mean over many periods, at most $s/(1-s)$ of all; the phases with $\lvert h\rvert>1-s$ shrink to those with $\lvert h\rvert=1$, which have no length if they are single instants, so that the share of rest tends to 1",
    || (rate(), printed::s23_late_share()),
    |(rate, share)| Proof::for_both_signs(|sign| mostly_at_rest(rate, share, sign)),
);

fn mostly_at_rest(rate: Expr, share: Expr, sign: i64) -> Proof {
    Proof::in_ring("Rest for most of the time", ring(sign), |p| {
        let [lambda0, psi, s, m, e] = symbols(["λ₀", "ψ", "s", "m", "E"]);
        with_sign(p, sign);
        p.identity(
            ("d|𝔴|/dφ by (26)", int(sign) * rate),
            ("at most |h| − λ₀", int(sign) * psi.sin() - lambda0),
        )?;
        p.note("While the particle rests", "|𝔴| stays 0");

        let friction = 1 - s.squared();
        let fast = p.read("With λ₀ = 1 − s², |h| − λ₀ is at most 1 − λ₀", 1 - friction)?;
        let slow = p.read("Where |h| ≤ 1 − s, it is at most", 1 - s - friction)?;
        let stated = p.read("−s (1 − s)", -(s * (1 - s)))?;
        p.equal("The last two are equal", &slow, &stated)?;
        let gain = p.read(
            "2π s² − m s (1 − s)",
            2 * pi() * s.squared() - m * s * (1 - s),
        )?;
        let by_parts = &p.ring().read(2 * pi())? * &fast + &p.ring().read(m)? * &slow;
        p.equal("It is what is not negative", &by_parts, &gain)?;
        let bound = 2 * pi() * s / (1 - s);
        p.reads_as(
            &gain,
            "s (1 − s) times what m is below 2πs/(1 − s)",
            s * (1 - s) * (bound - m),
        )?;
        let rest = p.read("The share of rest is at least", 1 - bound / (2 * pi()) - e)?;
        let [small, share_of_strong] = [s, e].map(|x| p.ring().read(x));
        let zero = Rational::int(0);
        let late = p
            .ring()
            .put(&rest, &[(&small?, &zero), (&share_of_strong?, &zero)])?;
        let share = p.read("The stated limit of the share", share)?;
        p.equal("It is the share of rest at s = 0 and E = 0", &share, &late)
    })
}

fn normalised(([pulse, gap], largest): ([Expr; 2], Expr)) -> Proof {
    let h = symbol("h");
    Proof::in_ring("The size of the pulses", ring(1), |p| {
        let length = p.read("The length of a pulse by (42)", printed::eq42_end::tree())?;
        let growth = p.slope("Its rate with η", &length, "η")?;
        p.reads_as(&growth, "positive", pi())?;
        let eta = p.ring().named("η")?;
        let none = p.ring().put(&length, &[(&eta, &Rational::int(0))])?;
        p.zero("The length is 0 at η = 0", &none)?;
        let size = p.read("The stated size", largest)?;
        p.reads_as(&size, "h in a pulse by (42)", pulse)?;
        let none = p.read("In a gap", gap)?;
        p.zero("h is 0", &none)?;
        let own = p.read("The square of h", h.squared())?;
        p.reads_as(
            &own,
            "the same, mirrored by (43)",
            printed::eq43_h(h).squared(),
        )
    })
}

/// What (42), (43) and (46) give at a share of pulses.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pulses {
    /// h in a pulse and in a gap, then the same half a period later.
    h: [Expr; 4],
    end: Expr,
    /// λ_c.
    critical: Expr,
}

fn pulses() -> Pulses {
    Pulses {
        h: drive(),
        end: printed::eq42_end::tree(),
        critical: critical(),
    }
}

fn drive() -> [Expr; 4] {
    let [pulse, gap] = printed::eq42_cases();
    [pulse, gap, printed::eq43_h(pulse), printed::eq43_h(gap)]
}

fn critical() -> Expr {
    printed::eq46_lambda_c::tree()
}

fn extremes(rate: Expr, pulses: Pulses, sign: i64) -> Proof {
    Proof::in_ring("The two extremes of the pulses", ring(sign), |p| {
        let [lambda0, start] = symbols(["λ₀", "𝔴₀"]);
        let [zero, one] = [0, 1].map(int);
        let at = |formula: Expr, eta: Expr| formula.with("η", eta);
        with_sign(p, sign);

        p.identity(
            ("At η = 1 a pulse ends at", at(pulses.end, one)),
            ("half a period", pi()),
        )?;
        for (says, h, way) in [
            ("h in a pulse", pulses.h[0], 1),
            ("h half a period later", pulses.h[2], -1),
        ] {
            let h = p.read(says, h)?;
            p.equal(&format!("It is {way}"), &h, &Rational::int(way))?;
        }
        let critical = p.read("λ_c at η = 1", at(pulses.critical, one))?;
        p.equal(
            "It is 1, above which all rests",
            &critical,
            &Rational::int(1),
        )?;

        p.vanishes("At η = 0 a pulse ends at", at(pulses.end, zero))?;
        for (says, h) in [
            ("h in a gap", pulses.h[1]),
            ("h half a period later", pulses.h[3]),
        ] {
            p.vanishes(says, h)?;
        }
        p.identity(
            (
                "d|𝔴|/dφ by (26) with h = 0",
                int(sign) * rate.with("ψ", zero),
            ),
            ("", -lambda0),
        )?;
        p.vanishes(
            "The size left after |𝔴₀|/λ₀, with 𝔴₀ for its size",
            start - lambda0 * (start / lambda0),
        )?;
        let critical = p.read("λ_c at η = 0", at(pulses.critical, zero))?;
        p.zero("It is 0, below which no λ₀ is", &critical)
    })
}

fn nonzero_again(rate: Expr, h: [Expr; 4], critical: Expr, again: Expr, sign: i64) -> Proof {
    Proof::in_ring("What becomes nonzero again", ring(sign), |p| {
        let [lambda0, psi] = symbols(["λ₀", "ψ"]);
        with_sign(p, sign);
        p.identity(
            ("d𝔴/dφ by (26) without friction", rate.with("λ₀", int(0))),
            ("what is said to become nonzero again", again),
        )?;
        p.vanishes("h in the gap", h[1])?;
        p.vanishes("What is said, with that h", again.with("ψ", int(0)))?;
        let pulse = p.read("h in the pulse from π on", h[2])?;
        p.equal("It is not 0, but −1", &pulse, &Rational::int(-1))?;
        p.identity(
            ("What friction gives by (26)", rate - psi.sin()),
            (
                "λ₀ against the velocity, at every h",
                -(int(sign) * lambda0),
            ),
        )?;
        rest_on(p, &[&EQ44, &EQ46])?;
        let [_, stop] = printed::eq44_ends::tree();
        let excess = pi() * (lambda0 - critical) / lambda0;
        p.identity(
            ("π less the end of the slip by (44)", pi() - stop),
            ("positive for λ₀ > λ_c only", excess),
        )
    })
}

attempts![
    &REST_ABOVE_ONE,
    &MOSTLY_AT_REST,
    &AGAIN = Statement::shown(
        Corrected,
        r"for every $\lambda_0>0$ and every $\eta$ between 0 and 1: what (26) gives a particle without friction is $h$, by (42) 0 in the gap before $\pi$ and by (43) $-1$ in the pulse behind it; friction gives one that still slides $\mp\lambda_0$, before $\pi$ as after it. By (44) the slip ends before that if $\lambda_0>\eta$, which is $\lambda_\mathrm c$ of (46), and not otherwise",
        || {
            let h = symbol("ψ").sin();
            (rate(), drive(), critical(), corrected::nonzero_again(h))
        },
        |(rate, h, critical, again)| {
            Proof::for_both_signs(|sign| nonzero_again(rate, h, critical, again, sign))
        }
    ),
    &NORMALISED = Statement::shown(
        Within,
        r"for every $\eta>0$ the pulse of (42), which has the length $\eta\pi>0$, has the stated size, and the gap and both mirrored by (43) have none that is larger",
        || (printed::eq42_cases(), printed::s23_largest()),
        normalised
    ),
    &EXTREMES = Statement::shown(
        Within,
        r"at $\eta=1$ the pulses of (42), (43) leave no gap, so that $\lvert h\rvert=1>\lambda_0$ at all times for every $\lambda_0<1$ and nothing rests, and $\lambda_\mathrm c$ of (46) is 1; at $\eta=0$ they have no length, so that $h=0$, for every $\lambda_0>0$ the particle is at rest after $\lvert\mathfrak w_0\rvert/\lambda_0$ by (26) and stays, and $\lambda_\mathrm c$ is 0",
        || (rate(), pulses()),
        |(rate, pulses)| Proof::for_both_signs(|sign| extremes(rate, pulses, sign))
    )
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::general::two_frames::eq2;

    /// The friction of (26) is as strong at every velocity.
    #[test]
    fn a_friction_that_grows_with_the_velocity_is_refused() {
        assert!(never_part(rate()).holds());
        assert!(!never_part(rate() - symbol("λ₀") * symbol("𝔴")).holds());
        assert!(slows(eq2()).holds());
        assert!(!slows(eq2() - symbol("v_x") * symbol("g")).holds());
    }
}
