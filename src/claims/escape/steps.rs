//! The steps from (128) to (137), each by itself: what the printed predecessor gives, with what is printed.

use super::prelude::*;
use super::trajectories::{a, alpha};
use crate::paper::turntable;

/// What is printed against what its predecessors give, relatively, at twenty values in a range of powers of ten.
fn step(
    words: [&'static str; 2],
    range: (&str, [f64; 2]),
    pair: impl Fn(f64) -> [f64; 2],
) -> Evidence {
    relatively(Limit, words, ROOT, range, pair)
}

/// What a printed law gains from τ to 2τ against the integral of its rate.
fn summed(
    words: [&'static str; 2],
    law: impl Fn(f64) -> f64,
    rate: impl Fn(f64) -> f64,
) -> Evidence {
    let range = ("τ", [-1.0, 1.0]);
    relatively(Quadrature, words, QUADRATURE, range, |tau| {
        let found = integral(&rate, tau, 2.0 * tau);
        let gained = law(2.0 * tau) - law(tau);
        [gained, found.map_or(f64::NAN, |sum| sum.value)]
    })
}

fn relatively(
    route: Route,
    [stated, found]: [&'static str; 2],
    tolerance: Tolerance,
    (name, [low, high]): (&str, [f64; 2]),
    pair: impl Fn(f64) -> [f64; 2],
) -> Evidence {
    let points = Points::here().within(20, [[low, high]]);
    let trial = Trial::by(route, Step, [stated, found], tolerance);
    let points = points.into_iter().map(|[power]| [libm::exp10(power)]);
    trial.at([name], points, 1.0, |[x]| {
        let [stated, found] = pair(x);
        Ok([stated / found, 1.0])
    })
}

/// (129) from (128): a step that is wrong by itself. It puts 0 for dα/dτ, which is a third of cosh α/A at late times.
pub(crate) fn eq129() -> Evidence {
    let trial = Trial::by(
        Limit,
        Step,
        [
            r"(128) over $(\cosh\alpha)/A$ at the $A$ of (129), where it vanishes,",
            r"$\mathrm d\alpha/\mathrm d\tau$ of the motion over $(\cosh\alpha)/A$, late in escapes",
        ],
        ROOT,
    );
    trial.over(ESCAPES.each(), |escape| {
        let escape = escape?;
        let late = escape.late.first().ok_or("no late moment")?;
        let (size, alpha) = (a(&late.state), alpha(&late.state));
        let stated = printed::eq129_a(alpha);
        Ok(Pair::plain(
            format!("{}, τ = {:.1e}", escape.launch.at(), late.tau),
            printed::eq128_alpha_rate(alpha, stated) * stated / alpha.cosh(),
            late.alpha_rate * size / alpha.cosh(),
        ))
    })
}

attempts![
    eq129,
    // Where α is large.
    eq130 = step(
        ["(130) at the $A$ of (129)", r"$\alpha$"],
        ("α", [1.26, 2.0]),
        |alpha| { [printed::eq130_alpha(printed::eq129_a(alpha)), alpha] }
    ),
    // Where A is large.
    eq131 = step(
        ["(131)", r"(113) at the $\alpha$ of (130)"],
        ("A", [20.0, 40.0]),
        |a| {
            let rate = turntable::eq113_a_rate(printed::eq130_alpha(a));
            [printed::eq131_a_rate(a), rate]
        }
    ),
    eq132 = summed(
        [
            r"the gain of $A$ by (132) from $\tau$ to $2\tau$",
            "the integral of (131) there",
        ],
        printed::eq132_a,
        |t| printed::eq131_a_rate(printed::eq132_a(t)),
    ),
    eq133 = step(
        ["(133)", "(130) at the $A$ of (132)"],
        ("τ", [1.0, 8.0]),
        |tau| {
            let found = printed::eq130_alpha(printed::eq132_a(tau));
            [printed::eq133_alpha(tau), found]
        }
    ),
    // From (124) and (133): a step that is wrong by itself. tanh 2α → 1 − 2 exp(−4α) is the sine of an angle that misses π/2
    // by 2 exp(−2α), not by 2 exp(−α).
    eq134 = step(
        [
            r"what $\psi$ lacks of $\pi/2$ by (134)",
            r"what it lacks by (124) at the $\alpha$ of (133)",
        ],
        ("τ", [1.0, 3.0]),
        |tau| {
            let psi = turntable::eq124_psi1(printed::eq133_alpha(tau));
            [printed::eq134_lag(tau), FRAC_PI_2 - psi]
        },
    ),
    eq135 = step(
        ["(135)", r"(111) at $A$ of (132) and $\alpha$ of (133)"],
        ("τ", [14.0, 24.0]),
        |tau| {
            let found = turntable::eq111_p(printed::eq132_a(tau), printed::eq133_alpha(tau));
            [printed::eq135_p(tau), found]
        },
    ),
    eq136 = step(
        ["(136)", r"(112) at $A$ of (132) and $\alpha$ of (133)"],
        ("τ", [14.0, 24.0]),
        |tau| {
            let found = turntable::eq112_rho(printed::eq132_a(tau), printed::eq133_alpha(tau));
            [printed::eq136_rho(tau), found]
        },
    ),
    eq137 = summed(
        [
            r"the gain of $s$ by (137) from $\tau$ to $2\tau$",
            "the integral of (105) there, with $p$ from (135)",
        ],
        printed::eq137_s,
        |t| turntable::eq105_arc_rate(printed::eq135_p(t)),
    )
];
