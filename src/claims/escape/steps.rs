//! The steps from (128) to (137), each by itself: what the printed predecessor gives, with what is printed.

use super::trajectories::{a, alpha, escapes};
use crate::claims::tolerances::{QUADRATURE, ROOT};
use crate::evidence::{Evidence, Route, Subject, Tolerance};
use crate::numerics::quadrature::integral;
use crate::paper::{escape as printed, turntable};
use std::f64::consts::FRAC_PI_2;
use trialbook::claims::attempt::{Attempt, trials};
use trialbook::claims::compare::{Compared, Failure, Pair, Trial};
use trialbook::claims::points::Points;

/// Compares what is printed with what its predecessors give, relatively, at twenty values in a range of powers of ten.
fn step(
    route: Route,
    compared: Compared,
    tolerance: Tolerance,
    (name, [low, high]): (&str, [f64; 2]),
    pair: impl Fn(f64) -> Result<[f64; 2], Failure>,
) -> Evidence {
    let points = Points::stream(702).within(20, [[low, high]]);
    let trial = Trial::by(route, Subject::Step, compared, tolerance);
    let points = points.into_iter().map(|[power]| [libm::exp10(power)]);
    trial.at([name], points, 1.0, |[x]| {
        let [stated, found] = pair(x)?;
        Ok([stated / found, 1.0])
    })
}

/// (129) from (128): a step that is wrong by itself. It puts 0 for dα/dτ, which is a third of cosh α/A at late times.
pub fn eq129() -> Evidence {
    let compared = Compared::one(
        r"(128) over $(\cosh\alpha)/A$ at the $A$ of (129), where it vanishes,",
        r"$\mathrm d\alpha/\mathrm d\tau$ of the motion over $(\cosh\alpha)/A$, late in escapes",
    );
    let trial = Trial::by(Route::Limit, Subject::Step, compared, ROOT);
    trial.over(escapes(), |escape| {
        let escape = escape?;
        let late = escape.late.first().ok_or("no late moment")?;
        let (size, alpha) = (a(&late.state), alpha(&late.state));
        let stated = printed::eq129_a(alpha);
        Ok(Pair {
            at: format!("{}, τ = {:.1e}", escape.launch.at(), late.tau),
            stated: printed::eq128_alpha_rate(alpha, stated) * stated / alpha.cosh(),
            found: late.alpha_rate * size / alpha.cosh(),
            scale: 1.0,
        })
    })
}

/// (130) from (129), where α is large.
pub fn eq130() -> Evidence {
    let compared = Compared::one("(130) at the $A$ of (129)", r"$\alpha$");
    step(Route::Limit, compared, ROOT, ("α", [1.26, 2.0]), |alpha| {
        Ok([printed::eq130_alpha(printed::eq129_a(alpha)), alpha])
    })
}

/// (131) from (113) and (130), where A is large.
pub fn eq131() -> Evidence {
    let compared = Compared::one("(131)", r"(113) at the $\alpha$ of (130)");
    step(Route::Limit, compared, ROOT, ("A", [20.0, 40.0]), |a| {
        let rate = turntable::eq113_a_rate(printed::eq130_alpha(a));
        Ok([printed::eq131_a_rate(a), rate])
    })
}

/// (132) from (131): its integral.
pub fn eq132() -> Evidence {
    let compared = Compared::one(
        r"the gain of $A$ by (132) from $\tau$ to $2\tau$",
        "the integral of (131) there",
    );
    step(
        Route::Quadrature,
        compared,
        QUADRATURE,
        ("τ", [-1.0, 1.0]),
        |tau| {
            let gained = printed::eq132_a(2.0 * tau) - printed::eq132_a(tau);
            let rate = |t: f64| printed::eq131_a_rate(printed::eq132_a(t));
            let found = integral(rate, tau, 2.0 * tau);
            Ok([gained, found.map_or(f64::NAN, |sum| sum.value)])
        },
    )
}

/// (133) from (130) and (132).
pub fn eq133() -> Evidence {
    let compared = Compared::one("(133)", "(130) at the $A$ of (132)");
    step(Route::Limit, compared, ROOT, ("τ", [1.0, 8.0]), |tau| {
        let found = printed::eq130_alpha(printed::eq132_a(tau));
        Ok([printed::eq133_alpha(tau), found])
    })
}

/// (134) from (124) and (133): a step that is wrong by itself. tanh 2α → 1 − 2 exp(−4α) is the sine of an angle that
/// misses π/2 by 2 exp(−2α), not by 2 exp(−α).
pub fn eq134() -> Evidence {
    let compared = Compared::one(
        r"what $\psi$ lacks of $\pi/2$ by (134)",
        r"what it lacks by (124) at the $\alpha$ of (133)",
    );
    step(Route::Limit, compared, ROOT, ("τ", [1.0, 3.0]), |tau| {
        let psi = turntable::eq124_psi1(printed::eq133_alpha(tau));
        Ok([printed::eq134_lag(tau), FRAC_PI_2 - psi])
    })
}

/// (135) from (111), (132) and (133).
pub fn eq135() -> Evidence {
    let compared = Compared::one("(135)", r"(111) at $A$ of (132) and $\alpha$ of (133)");
    step(Route::Limit, compared, ROOT, ("τ", [14.0, 24.0]), |tau| {
        let found = turntable::eq111_p(printed::eq132_a(tau), printed::eq133_alpha(tau));
        Ok([printed::eq135_p(tau), found])
    })
}

/// (136) from (112), (132) and (133).
pub fn eq136() -> Evidence {
    let compared = Compared::one("(136)", r"(112) at $A$ of (132) and $\alpha$ of (133)");
    step(Route::Limit, compared, ROOT, ("τ", [14.0, 24.0]), |tau| {
        let found = turntable::eq112_rho(printed::eq132_a(tau), printed::eq133_alpha(tau));
        Ok([printed::eq136_rho(tau), found])
    })
}

/// (137) from (105) and (135): the integral of the speed.
pub fn eq137() -> Evidence {
    let compared = Compared::one(
        r"the gain of $s$ by (137) from $\tau$ to $2\tau$",
        "the integral of (105) there, with $p$ from (135)",
    );
    step(
        Route::Quadrature,
        compared,
        QUADRATURE,
        ("τ", [-1.0, 1.0]),
        |tau| {
            let gained = printed::eq137_s(2.0 * tau) - printed::eq137_s(tau);
            let speed = |t: f64| turntable::eq105_arc_rate(printed::eq135_p(t));
            let found = integral(speed, tau, 2.0 * tau);
            Ok([gained, found.map_or(f64::NAN, |sum| sum.value)])
        },
    )
}

pub(super) const TRIALS: &[Attempt] = trials![
    eq129, eq130, eq131, eq132, eq133, eq134, eq135, eq136, eq137
];
