//! Trials of the laws of growth: limits, exponents and first corrections, from motions followed to τ = 10⁸.
//!
//! A quantity over its power of τ tends to its limit as a series in 1/τ and ln τ, because the law holds in a time
//! that lags behind τ by a multiple of ln τ (see [`crate::corrections::escape`]); a fit that knows only powers
//! stalls. Oscillations fall as τ^(−5/2) and are below 10⁻¹² here.

use super::trajectories::{Escape, LATE, Late, a, alpha, escapes};
use crate::claims::tolerances::{ESCAPE_CORRECTION, ESCAPE_LIMIT};
use crate::corrections::escape as corrected;
use crate::evidence::{Evidence, Route, Subject};
use crate::motion::turntable::Start;
use crate::numerics::fit::fit;
use crate::paper::escape as printed;
use trialbook::claims::attempt::{Attempt, trials};
use trialbook::claims::compare::{Compared, Failure, Pair, Trial};

/// What is followed: a number at a late moment of a motion.
pub type Quantity = fn(&Late) -> f64;

/// The limit for τ → ∞ and the coefficient of (ln τ)/τ, with their standard errors.
#[derive(Debug, Clone, Copy)]
pub struct Limit {
    /// The limit.
    pub value: f64,
    /// Its standard error.
    pub error: f64,
    /// The coefficient of (ln τ)/τ.
    pub log: f64,
    /// Its standard error.
    pub log_error: f64,
}

const TERMS: [&dyn Fn(f64) -> f64; 6] = [
    &|_| 1.0,
    &|t| libm::log(t) / t,
    &|t| 1.0 / t,
    &|t| libm::log(t) * libm::log(t) / (t * t),
    &|t| libm::log(t) / (t * t),
    &|t| 1.0 / (t * t),
];

/// The limit of a quantity, fitted over the last two decades.
///
/// # Errors
/// Those of the motion and of the fit.
pub fn limit(escape: &Escape, quantity: Quantity) -> Result<Limit, Failure> {
    let data: Vec<_> = escape.late.iter().map(|l| (l.tau, quantity(l))).collect();
    let fit = fit(&data, &TERMS)?;
    Ok(Limit {
        value: fit.coefficients[0],
        error: fit.errors[0],
        log: fit.coefficients[1],
        log_error: fit.errors[1],
    })
}

/// The exponent n of a quantity that grows as τⁿ, and its standard error.
///
/// # Errors
/// Those of the motion and of the fit.
pub fn exponent(escape: &Escape, quantity: Quantity) -> Result<(f64, f64), Failure> {
    let logarithms = escape.late.iter().map(|l| (l.tau, libm::log(quantity(l))));
    let data: Vec<_> = logarithms.collect();
    let logarithm = |t: f64| libm::log(t);
    let mut basis: Vec<&dyn Fn(f64) -> f64> = vec![&logarithm];
    basis.extend(TERMS);
    let fit = fit(&data, &basis)?;
    Ok((fit.coefficients[0], fit.errors[0]))
}

/// p/τ².
pub fn speed(l: &Late) -> f64 {
    l.state.p() / (l.tau * l.tau)
}
/// ρ/τ².
pub fn distance(l: &Late) -> f64 {
    l.state.rho() / (l.tau * l.tau)
}
/// s/τ³.
pub fn way(l: &Late) -> f64 {
    l.state.s / (l.tau * l.tau * l.tau)
}
/// A/τ^(3/2).
pub fn size(l: &Late) -> f64 {
    a(&l.state) / (l.tau * libm::sqrt(l.tau))
}
/// α − ½ ln τ.
pub fn excess(l: &Late) -> f64 {
    alpha(&l.state) - 0.5 * libm::log(l.tau)
}
/// (π/2 − ψ) τ.
pub fn lag(l: &Late) -> f64 {
    l.state.lag() * l.tau
}
/// α − ⅓ ln A.
pub fn alpha_by_a(l: &Late) -> f64 {
    alpha(&l.state) - libm::log(a(&l.state)) / 3.0
}
/// τ dα/dτ.
pub fn alpha_rate(l: &Late) -> f64 {
    l.tau * l.alpha_rate
}
/// dA/dτ over A^(1/3).
pub fn a_rate(l: &Late) -> f64 {
    l.a_rate / libm::cbrt(a(&l.state))
}
/// cosh α cosh 2α over A, where (129) has 1.
pub fn product(l: &Late) -> f64 {
    let alpha = alpha(&l.state);
    libm::cosh(alpha) * libm::cosh(2.0 * alpha) / a(&l.state)
}
/// τ times the rate at which the particle circles the axis in the laboratory: 1 more than on the table, put together from
/// components that do not cancel.
fn winding(l: &Late) -> f64 {
    let Start { p, xi, zeta } = l.state.parts;
    l.tau * (xi * xi + (zeta - p) * zeta) / l.state.rho().powi(2)
}
/// What (129) has for A, over A.
fn eq129(l: &Late) -> f64 {
    printed::eq129_a(alpha(&l.state)) / a(&l.state)
}
/// (128) times τ.
pub fn eq128(l: &Late) -> f64 {
    l.tau * printed::eq128_alpha_rate(alpha(&l.state), a(&l.state))
}
/// What replaces (128), times τ.
fn corrected128(l: &Late) -> f64 {
    l.tau * corrected::alpha_rate(alpha(&l.state), a(&l.state))
}
/// A²/2, as (138) has it, over s.
fn eq138(l: &Late) -> f64 {
    printed::eq138_s(a(&l.state)) / l.state.s
}

/// The limit of p/τ² as printed.
pub fn printed_speed() -> f64 {
    printed::eq135_p(1.0)
}
/// The limit of p/τ² as corrected.
pub fn corrected_speed() -> f64 {
    corrected::rho(LATE) / (LATE * LATE)
}
/// The coefficient of (ln τ)/τ in p/τ², over the limit.
pub fn corrected_speed_log() -> f64 {
    -2.0 * corrected::delay::<f64>()
}
/// The limit of A/τ^(3/2) as printed.
pub fn printed_size() -> f64 {
    printed::eq132_a(1.0)
}
/// The limit of A/τ^(3/2) as corrected.
pub fn corrected_size() -> f64 {
    corrected::a(LATE) / libm::pow(LATE, 1.5)
}
/// The limit of (π/2 − ψ) τ as corrected.
pub fn corrected_lag() -> f64 {
    corrected::lag(LATE) * LATE
}

/// A stated limit against the limit of what the motion does.
fn against(
    subject: Subject,
    compared: Compared,
    quantity: Quantity,
    stated: impl Fn(&Escape) -> Result<f64, Failure>,
) -> Evidence {
    let trial = Trial::by(Route::Limit, subject, compared, ESCAPE_LIMIT);
    trial.over(escapes(), |flight| {
        let flight = flight?;
        let found = limit(flight, quantity)?;
        Ok(Pair {
            at: flight.launch.at(),
            // A formula of which there is no limit states nothing.
            stated: stated(flight).unwrap_or(f64::NAN),
            found: found.value,
            scale: 1.0,
        })
    })
}

/// The limit of the ratio of an equation's sides, of which one is the motion's own, against 1.
fn sides(compared: Compared, ratio: Quantity) -> Evidence {
    let trial = Trial::by(Route::Limit, Subject::Printed, compared, ESCAPE_LIMIT);
    trial.over(escapes(), |flight| {
        let flight = flight?;
        Ok(Pair {
            at: flight.launch.at(),
            stated: limit(flight, ratio).map_or(f64::NAN, |limit| limit.value),
            found: 1.0,
            scale: 1.0,
        })
    })
}

/// A stated exponent against the exponent of what the motion does.
fn powers(
    subject: Subject,
    compared: Compared,
    quantity: Quantity,
    taken_out: f64,
    law: fn(f64) -> f64,
) -> Evidence {
    let trial = Trial::by(Route::Limit, subject, compared, ESCAPE_LIMIT);
    trial.over(escapes(), |flight| {
        let flight = flight?;
        let (found, _) = exponent(flight, quantity)?;
        Ok(Pair {
            at: flight.launch.at(),
            stated: libm::log(law(LATE) / law(1.0)) / libm::log(LATE),
            found: found + taken_out,
            scale: 1.0,
        })
    })
}

/// The coefficient of (ln τ)/τ, relative to the limit, against `power` times the delay of the law's own time.
fn delays(compared: Compared, quantity: Quantity, power: f64) -> Evidence {
    let trial = Trial::by(
        Route::Limit,
        Subject::Corrected,
        compared,
        ESCAPE_CORRECTION,
    );
    trial.over(escapes(), |flight| {
        let flight = flight?;
        let found = limit(flight, quantity)?;
        Ok(Pair {
            at: flight.launch.at(),
            stated: -power * corrected::delay::<f64>(),
            found: found.log / found.value,
            scale: 1.0,
        })
    })
}

/// (128): τ dα/dτ.
fn eq128_limit() -> Evidence {
    let compared = Compared::one(
        r"$\tau$ times (128)",
        r"$\tau\,\mathrm d\alpha/\mathrm d\tau$ of the motion, for $\tau\to\infty$",
    );
    against(Subject::Printed, compared, alpha_rate, |f| {
        Ok(limit(f, eq128)?.value)
    })
}
/// The same of what replaces it.
fn corrected128_limit() -> Evidence {
    let compared = Compared::one(
        r"$\tau(\sqrt2/\cosh2\alpha-\cosh\alpha/A)$",
        r"$\tau\,\mathrm d\alpha/\mathrm d\tau$ of the motion, for $\tau\to\infty$",
    );
    against(Subject::Corrected, compared, alpha_rate, |f| {
        Ok(limit(f, corrected128)?.value)
    })
}
/// (129): the ratio of its two sides.
fn eq129_limit() -> Evidence {
    let compared = Compared::one(r"$\cosh\alpha\cosh2\alpha/A$, for $\tau\to\infty$,", "1");
    sides(compared, eq129)
}
/// The same of what replaces it.
fn corrected129_limit() -> Evidence {
    let compared = Compared::one(
        r"$3\sqrt2/4$",
        r"$\cosh\alpha\cosh2\alpha/A$ of the motion, for $\tau\to\infty$",
    );
    against(Subject::Corrected, compared, product, |_| {
        Ok(corrected::product_over_a())
    })
}
/// (130): what is added to ⅓ ln A.
fn eq130_limit() -> Evidence {
    let compared = Compared::one(
        r"(130) less $\frac13\ln A$",
        r"$\alpha-\frac13\ln A$ of the motion, for $\tau\to\infty$",
    );
    against(Subject::Printed, compared, alpha_by_a, |_| {
        Ok(printed::eq130_alpha(LATE) - libm::log(LATE) / 3.0)
    })
}
/// The same of what replaces it.
fn corrected130_limit() -> Evidence {
    let compared = Compared::one(
        r"$\frac13\ln(3\sqrt2)$",
        r"$\alpha-\frac13\ln A$ of the motion, for $\tau\to\infty$",
    );
    against(Subject::Corrected, compared, alpha_by_a, |_| {
        Ok(corrected::alpha_by_a(LATE) - libm::log(LATE) / 3.0)
    })
}
/// (131): the factor of A^(1/3).
fn eq131_limit() -> Evidence {
    let compared = Compared::one(
        "(131) over $A^{1/3}$",
        r"$(\mathrm dA/\mathrm d\tau)/A^{1/3}$ of the motion, for $\tau\to\infty$",
    );
    against(Subject::Printed, compared, a_rate, |_| {
        Ok(printed::eq131_a_rate(LATE) / libm::cbrt(LATE))
    })
}
/// The same of what replaces it.
fn corrected131_limit() -> Evidence {
    let compared = Compared::one(
        r"$\frac12(3\sqrt2)^{1/3}$",
        r"$(\mathrm dA/\mathrm d\tau)/A^{1/3}$ of the motion, for $\tau\to\infty$",
    );
    against(Subject::Corrected, compared, a_rate, |_| {
        Ok(corrected::a_rate(LATE) / libm::cbrt(LATE))
    })
}
/// (132): the prefactor.
fn eq132_limit() -> Evidence {
    let compared = Compared::one(
        r"(132) over $\tau^{3/2}$",
        r"$A/\tau^{3/2}$ of the motion, for $\tau\to\infty$",
    );
    against(Subject::Printed, compared, size, |_| Ok(printed_size()))
}
/// (132): the exponent.
fn eq132_exponent() -> Evidence {
    let compared = Compared::one(
        r"the exponent of $\tau$ in (132)",
        "that in $A$ of the motion",
    );
    powers(Subject::Printed, compared, size, 1.5, printed::eq132_a)
}
/// The prefactor of what replaces it.
fn corrected132_limit() -> Evidence {
    let compared = Compared::one(
        "$2^{1/4}/3$",
        r"$A/\tau^{3/2}$ of the motion, for $\tau\to\infty$",
    );
    against(Subject::Corrected, compared, size, |_| Ok(corrected_size()))
}
/// Its first correction.
fn corrected132_delay() -> Evidence {
    let compared = Compared::one(
        r"$-9\sqrt2/8$",
        r"the coefficient of $(\ln\tau)/\tau$ in $A/\tau^{3/2}$, over the limit",
    );
    delays(compared, size, 1.5)
}
/// (133): what is added to ½ ln τ.
fn eq133_limit() -> Evidence {
    let compared = Compared::one(
        r"(133) less $\frac12\ln\tau$",
        r"$\alpha-\frac12\ln\tau$ of the motion, for $\tau\to\infty$",
    );
    against(Subject::Printed, compared, excess, |_| {
        Ok(printed::eq133_alpha(LATE) - 0.5 * libm::log(LATE))
    })
}
/// The same of what replaces it.
fn corrected133_limit() -> Evidence {
    let compared = Compared::one(
        r"$\frac12\ln\sqrt2$",
        r"$\alpha-\frac12\ln\tau$ of the motion, for $\tau\to\infty$",
    );
    against(Subject::Corrected, compared, excess, |_| {
        Ok(corrected::alpha(LATE) - 0.5 * libm::log(LATE))
    })
}
/// (134): the exponent of π/2 − ψ.
fn eq134_exponent() -> Evidence {
    let compared = Compared::one(
        r"the exponent of $\tau$ in $\pi/2-\psi$ by (134)",
        "that of the motion",
    );
    powers(Subject::Printed, compared, lag, -1.0, printed::eq134_lag)
}
/// (134) as a whole, late.
fn eq134_limit() -> Evidence {
    let compared = Compared::one(
        r"$(\pi/2-\psi)\tau$ by (134), at $\tau=10^8$,",
        r"$(\pi/2-\psi)\tau$ of the motion, for $\tau\to\infty$",
    );
    against(Subject::Printed, compared, lag, |_| {
        Ok(printed::eq134_lag(LATE) * LATE)
    })
}
/// The exponent of what replaces it.
fn corrected134_exponent() -> Evidence {
    let compared = Compared::constant(
        "the stated $-1$",
        r"the exponent of $\tau$ in $\pi/2-\psi$ of the motion",
    );
    powers(Subject::Corrected, compared, lag, -1.0, corrected::lag)
}
/// Its prefactor.
fn corrected134_limit() -> Evidence {
    let compared = Compared::constant(
        "the stated 2",
        r"$(\pi/2-\psi)\tau$ of the motion, for $\tau\to\infty$,",
    );
    against(Subject::Corrected, compared, lag, |_| Ok(corrected_lag()))
}
/// Its first correction.
fn corrected134_delay() -> Evidence {
    let compared = Compared::one(
        r"$3\sqrt2/4$",
        r"the coefficient of $(\ln\tau)/\tau$ in $(\pi/2-\psi)\tau$, over the limit",
    );
    delays(compared, lag, -1.0)
}
/// (135): the prefactor.
fn eq135_limit() -> Evidence {
    let compared = Compared::one(
        r"(135) over $\tau^2$",
        r"$p/\tau^2$ of the motion, for $\tau\to\infty$",
    );
    against(Subject::Printed, compared, speed, |_| Ok(printed_speed()))
}
/// (135): the exponent.
fn eq135_exponent() -> Evidence {
    let compared = Compared::one(
        r"the exponent of $\tau$ in (135)",
        "that in $p$ of the motion",
    );
    powers(Subject::Printed, compared, speed, 2.0, printed::eq135_p)
}
/// The prefactor of what replaces it.
fn corrected135_limit() -> Evidence {
    let compared = Compared::one(
        r"$1/(3\sqrt2)$",
        r"$p/\tau^2$ of the motion, for $\tau\to\infty$",
    );
    against(Subject::Corrected, compared, speed, |_| {
        Ok(corrected_speed())
    })
}
/// Its first correction.
fn corrected135_delay() -> Evidence {
    let compared = Compared::one(
        r"$-3\sqrt2/2$",
        r"the coefficient of $(\ln\tau)/\tau$ in $p/\tau^2$, over the limit",
    );
    delays(compared, speed, 2.0)
}
/// (136): the prefactor.
fn eq136_limit() -> Evidence {
    let compared = Compared::one(
        r"(136) over $\tau^2$",
        r"$\rho/\tau^2$ of the motion, for $\tau\to\infty$",
    );
    against(Subject::Printed, compared, distance, |_| {
        Ok(printed::eq136_rho(1.0))
    })
}
/// (136): the exponent.
fn eq136_exponent() -> Evidence {
    let compared = Compared::one(
        r"the exponent of $\tau$ in (136)",
        r"that in $\rho$ of the motion",
    );
    powers(
        Subject::Printed,
        compared,
        distance,
        2.0,
        printed::eq136_rho,
    )
}
/// The prefactor of what replaces it.
fn corrected136_limit() -> Evidence {
    let compared = Compared::one(
        r"$1/(3\sqrt2)$",
        r"$\rho/\tau^2$ of the motion, for $\tau\to\infty$",
    );
    against(Subject::Corrected, compared, distance, |_| {
        Ok(corrected_speed())
    })
}
/// Its first correction.
fn corrected136_delay() -> Evidence {
    let compared = Compared::one(
        r"$-3\sqrt2/2$",
        r"the coefficient of $(\ln\tau)/\tau$ in $\rho/\tau^2$, over the limit",
    );
    delays(compared, distance, 2.0)
}
/// The turn of the spiral.
fn winding_limit() -> Evidence {
    let compared = Compared::one(
        r"$\sqrt2$",
        r"$\tau$ times the rate at which the particle circles the axis in the laboratory, for $\tau\to\infty$",
    );
    against(Subject::Remark, compared, winding, |_| {
        Ok(corrected::winding())
    })
}
/// (137): the prefactor.
fn eq137_limit() -> Evidence {
    let compared = Compared::one(
        r"(137) over $\tau^3$",
        r"$s/\tau^3$ of the motion, for $\tau\to\infty$",
    );
    against(Subject::Printed, compared, way, |_| {
        Ok(printed::eq137_s(1.0))
    })
}
/// (137): the exponent.
fn eq137_exponent() -> Evidence {
    let compared = Compared::one(
        r"the exponent of $\tau$ in (137)",
        "that in $s$ of the motion",
    );
    powers(Subject::Printed, compared, way, 3.0, printed::eq137_s)
}
/// The prefactor of what replaces it.
fn corrected137_limit() -> Evidence {
    let compared = Compared::one(
        r"$1/(9\sqrt2)$",
        r"$s/\tau^3$ of the motion, for $\tau\to\infty$",
    );
    against(Subject::Corrected, compared, way, |_| {
        Ok(corrected::s(LATE) / libm::pow(LATE, 3.0))
    })
}
/// Its first correction.
fn corrected137_delay() -> Evidence {
    let compared = Compared::one(
        r"$-9\sqrt2/4$",
        r"the coefficient of $(\ln\tau)/\tau$ in $s/\tau^3$, over the limit",
    );
    delays(compared, way, 3.0)
}
/// (138): the ratio of its two sides.
fn eq138_limit() -> Evidence {
    let compared = Compared::one(r"$(A^2/2)/s$, for $\tau\to\infty$,", "1");
    sides(compared, eq138)
}

pub(super) const TRIALS: &[Attempt] = trials![
    eq128_limit,
    corrected128_limit,
    eq129_limit,
    corrected129_limit,
    eq130_limit,
    corrected130_limit,
    eq131_limit,
    corrected131_limit,
    eq132_limit,
    eq132_exponent,
    corrected132_limit,
    corrected132_delay,
    eq133_limit,
    corrected133_limit,
    eq134_exponent,
    eq134_limit,
    corrected134_exponent,
    corrected134_limit,
    corrected134_delay,
    eq135_limit,
    eq135_exponent,
    corrected135_limit,
    corrected135_delay,
    eq136_limit,
    eq136_exponent,
    corrected136_limit,
    corrected136_delay,
    winding_limit,
    eq137_limit,
    eq137_exponent,
    corrected137_limit,
    corrected137_delay,
    eq138_limit
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::escape::trajectories::Launch;
    use crate::motion::turntable::intrinsic::Run;

    /// The moments of an escape, with one and the same state.
    fn moments(run: Run, launch: Launch) -> Escape {
        let late = |i: i32| Late {
            tau: LATE * libm::pow(1e-3, f64::from(i) / 48.0),
            state: run.end(),
            alpha_rate: 0.0,
            a_rate: 0.0,
        };
        let late = (0..48).map(late).collect();
        Escape { launch, run, late }
    }

    #[test]
    fn powers_of_the_time_have_their_exponents() {
        let launch = Launch {
            a: 1.5,
            alpha: 0.5,
            psi: 0.3,
        };
        let run = Run::new(&launch.start().unwrap(), 1.0).unwrap();
        let escape = moments(run, launch);
        let powers: [(Quantity, f64); 3] = [
            (|l| l.tau * l.tau, 2.0),
            (|l| 3.0 * libm::sqrt(l.tau), 0.5),
            (|l| 2.0 / l.tau, -1.0),
        ];
        for (quantity, power) in powers {
            let (found, error) = exponent(&escape, quantity).unwrap();
            assert!((found - power).abs() < 1e-9, "{found} for {power}");
            assert!(error < 1e-9, "{error}");
        }
    }

    /// A² = A₀² + 2s, so that s/(A²/2) = 1 − A₀²/A².
    #[test]
    fn the_way_is_half_of_what_the_square_gains() {
        let start = Start::hyperbolic(1.5, 0.5, 0.3).unwrap();
        let late = Late {
            tau: 2.0,
            state: Run::new(&start, 2.0).unwrap().end(),
            alpha_rate: 0.0,
            a_rate: 0.0,
        };
        let size = a(&late.state);
        let expected = 1.0 - 1.5 * 1.5 / (size * size);
        assert!(expected < 0.9);
        assert!((1.0 / eq138(&late) - expected).abs() < 1e-12);
    }
}
