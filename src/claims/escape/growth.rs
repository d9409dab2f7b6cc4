//! Trials of the laws of growth: limits, exponents and first corrections, from motions followed to τ = 10⁸.
//!
//! A quantity over its power of τ tends to its limit as a series in 1/τ and ln τ, because the law holds in a time
//! that lags behind τ by a multiple of ln τ (see [`crate::corrections::escape`]); a fit that knows only powers
//! stalls. Oscillations fall as τ^(−5/2) and are below 10⁻¹² here.

use super::trajectories::{Escape, LATE, Late, a, alpha, escapes};
use crate::claims::tolerances::{ESCAPE_CORRECTION, ESCAPE_LIMIT};
use crate::corrections::escape as corrected;
use crate::evidence::Subject::{Corrected, Printed};
use crate::motion::turntable::Start;
use crate::numerics::fit::fit;
use crate::paper::escape as printed;
use trialbook::prelude::*;

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

/// What is followed, with its name.
pub type Named = (&'static str, Quantity);

const SPEED: Named = (r"$p/\tau^2$", speed);
const DISTANCE: Named = (r"$\rho/\tau^2$", distance);
const WAY: Named = (r"$s/\tau^3$", way);
/// What A is over its power of τ.
pub const SIZE: Named = (r"$A/\tau^{3/2}$", size);
const EXCESS: Named = (r"$\alpha-\frac12\ln\tau$", excess);
const LAG: Named = (r"$(\pi/2-\psi)\tau$", lag);
const ALPHA_BY_A: Named = (r"$\alpha-\frac13\ln A$", alpha_by_a);
/// What α grows by, per unit of ln τ.
pub const ALPHA_RATE: Named = (r"$\tau\,\mathrm d\alpha/\mathrm d\tau$", alpha_rate);
const A_RATE: Named = (r"$(\mathrm dA/\mathrm d\tau)/A^{1/3}$", a_rate);
const PRODUCT: Named = (r"$\cosh\alpha\cosh2\alpha/A$", product);
const WINDING: Named = (
    r"$\tau$ times the rate of turn about the axis, in the laboratory,",
    winding,
);

/// What is stated and what is found for each escape.
fn each(
    compared: Compared,
    subject: Subject,
    tolerance: Tolerance,
    pair: impl Fn(&Escape) -> Result<[f64; 2], Failure>,
) -> Evidence {
    let trial = Trial::by(Route::Limit, subject, compared, tolerance);
    trial.each(escapes(), Escape::at, |flight| {
        let [stated, found] = pair(flight)?;
        Ok([stated, found, 1.0])
    })
}

const LATE_MOTION: &str = r" of the motion, for $\tau\to\infty$";

/// A stated limit against the limit of what the motion does.
pub fn limits(
    stated: &'static str,
    subject: Subject,
    (name, quantity): Named,
    value: f64,
) -> Evidence {
    let compared = Compared::composed([stated, "", ""], [name, LATE_MOTION, ""]);
    each(compared, subject, ESCAPE_LIMIT, |flight| {
        Ok([value, limit(flight, quantity)?.value])
    })
}

/// The limit of a formula, evaluated along the motion; one that has none states nothing.
fn followed(flight: &Escape, formula: Quantity) -> f64 {
    limit(flight, formula).map_or(f64::NAN, |limit| limit.value)
}

/// The same of a formula that is followed along the motion.
fn following(
    stated: &'static str,
    subject: Subject,
    (name, quantity): Named,
    formula: Quantity,
) -> Evidence {
    let compared = Compared::composed([stated, "", ""], [name, LATE_MOTION, ""]);
    each(compared, subject, ESCAPE_LIMIT, |flight| {
        let found = limit(flight, quantity)?.value;
        Ok([followed(flight, formula), found])
    })
}

/// The limit of the ratio of an equation's sides, of which one is the motion's own, against 1.
fn sides(ratio: &'static str, formula: Quantity) -> Evidence {
    let compared = Compared::composed([ratio, r", for $\tau\to\infty$,", ""], ["1", "", ""]);
    each(compared, Printed, ESCAPE_LIMIT, |flight| {
        Ok([followed(flight, formula), 1.0])
    })
}

/// A stated exponent against that of what the motion does, of which a power of τ is taken out.
fn exponents(
    stated: &'static str,
    subject: Subject,
    found: &'static str,
    (_, quantity): Named,
    taken_out: f64,
    law: fn(f64) -> f64,
) -> Evidence {
    let compared = Compared::composed(
        [r"the exponent of $\tau$ in ", stated, ""],
        ["that in ", found, " of the motion"],
    );
    each(compared, subject, ESCAPE_LIMIT, |flight| {
        let (found, _) = exponent(flight, quantity)?;
        let stated = libm::log(law(LATE) / law(1.0)) / libm::log(LATE);
        Ok([stated, found + taken_out])
    })
}

/// The coefficient of (ln τ)/τ, relative to the limit, against `power` times the delay of the law's own time.
fn delays(stated: &'static str, (name, quantity): Named, power: f64) -> Evidence {
    let compared = Compared::composed(
        [stated, "", ""],
        [
            r"the coefficient of $(\ln\tau)/\tau$ in ",
            name,
            ", over the limit",
        ],
    );
    each(compared, Corrected, ESCAPE_CORRECTION, |flight| {
        let found = limit(flight, quantity)?;
        let delay = corrected::delay::<f64>();
        Ok([-power * delay, found.log / found.value])
    })
}

pub(super) const TRIALS: &[Attempt] = trials![
    eq128_limit = following(r"$\tau$ times (128)", Printed, ALPHA_RATE, eq128),
    corrected128_limit = following(
        r"$\tau(\sqrt2/\cosh2\alpha-\cosh\alpha/A)$",
        Corrected,
        ALPHA_RATE,
        corrected128
    ),
    eq129_limit = sides(r"$\cosh\alpha\cosh2\alpha/A$", eq129),
    corrected129_limit = limits(
        r"$3\sqrt2/4$",
        Corrected,
        PRODUCT,
        corrected::product_over_a()
    ),
    eq130_limit = limits(
        r"(130) less $\frac13\ln A$",
        Printed,
        ALPHA_BY_A,
        printed::eq130_alpha(LATE) - libm::log(LATE) / 3.0
    ),
    corrected130_limit = limits(
        r"$\frac13\ln(3\sqrt2)$",
        Corrected,
        ALPHA_BY_A,
        corrected::alpha_by_a(LATE) - libm::log(LATE) / 3.0
    ),
    eq131_limit = limits(
        "(131) over $A^{1/3}$",
        Printed,
        A_RATE,
        printed::eq131_a_rate(LATE) / libm::cbrt(LATE)
    ),
    corrected131_limit = limits(
        r"$\frac12(3\sqrt2)^{1/3}$",
        Corrected,
        A_RATE,
        corrected::a_rate(LATE) / libm::cbrt(LATE)
    ),
    eq132_limit = limits(r"(132) over $\tau^{3/2}$", Printed, SIZE, printed_size()),
    eq132_exponent = exponents("(132)", Printed, "$A$", SIZE, 1.5, printed::eq132_a),
    corrected132_limit = limits("$2^{1/4}/3$", Corrected, SIZE, corrected_size()),
    corrected132_delay = delays(r"$-9\sqrt2/8$", SIZE, 1.5),
    eq133_limit = limits(
        r"(133) less $\frac12\ln\tau$",
        Printed,
        EXCESS,
        printed::eq133_alpha(LATE) - 0.5 * libm::log(LATE)
    ),
    corrected133_limit = limits(
        r"$\frac12\ln\sqrt2$",
        Corrected,
        EXCESS,
        corrected::alpha(LATE) - 0.5 * libm::log(LATE)
    ),
    eq134_exponent = exponents(
        "(134)",
        Printed,
        r"$\pi/2-\psi$",
        LAG,
        -1.0,
        printed::eq134_lag
    ),
    eq134_limit = limits(
        r"(134) times $\tau$, at $\tau=10^8$,",
        Printed,
        LAG,
        printed::eq134_lag(LATE) * LATE
    ),
    corrected134_exponent = exponents(
        r"$2/\tau$",
        Corrected,
        r"$\pi/2-\psi$",
        LAG,
        -1.0,
        corrected::lag
    ),
    corrected134_limit = limits("the stated 2", Corrected, LAG, corrected_lag()),
    corrected134_delay = delays(r"$3\sqrt2/4$", LAG, -1.0),
    eq135_limit = limits(r"(135) over $\tau^2$", Printed, SPEED, printed_speed()),
    eq135_exponent = exponents("(135)", Printed, "$p$", SPEED, 2.0, printed::eq135_p),
    corrected135_limit = limits(r"$1/(3\sqrt2)$", Corrected, SPEED, corrected_speed()),
    corrected135_delay = delays(r"$-3\sqrt2/2$", SPEED, 2.0),
    eq136_limit = limits(
        r"(136) over $\tau^2$",
        Printed,
        DISTANCE,
        printed::eq136_rho(1.0)
    ),
    eq136_exponent = exponents(
        "(136)",
        Printed,
        r"$\rho$",
        DISTANCE,
        2.0,
        printed::eq136_rho
    ),
    corrected136_limit = limits(r"$1/(3\sqrt2)$", Corrected, DISTANCE, corrected_speed()),
    corrected136_delay = delays(r"$-3\sqrt2/2$", DISTANCE, 2.0),
    winding_limit = limits(r"$\sqrt2$", Subject::Remark, WINDING, corrected::winding()),
    eq137_limit = limits(r"(137) over $\tau^3$", Printed, WAY, printed::eq137_s(1.0)),
    eq137_exponent = exponents("(137)", Printed, "$s$", WAY, 3.0, printed::eq137_s),
    corrected137_limit = limits(
        r"$1/(9\sqrt2)$",
        Corrected,
        WAY,
        corrected::s(LATE) / libm::pow(LATE, 3.0)
    ),
    corrected137_delay = delays(r"$-9\sqrt2/4$", WAY, 3.0),
    eq138_limit = sides("$(A^2/2)/s$", eq138),
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
