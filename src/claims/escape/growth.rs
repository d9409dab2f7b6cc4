//! Trials of the laws of growth: limits, exponents and first corrections, from motions followed to τ = 10⁸.
//!
//! A quantity over its power of τ tends to its limit as a series in 1/τ and ln τ (see
//! [`crate::corrections::escape`]); a fit that knows only powers stalls. Oscillations fall as τ^(−5/2) and are below
//! 10⁻¹² here.

use super::prelude::*;
use super::trajectories::{Escape, LATE, Late, a, alpha};
use crate::numerics::fit::fit;

/// What is followed: a number at a late moment of a motion.
pub type Quantity = fn(&Late) -> f64;

/// The limit for τ → ∞, and how it is approached.
#[derive(Debug, Clone, Copy)]
pub struct Limit {
    /// The limit.
    pub value: f64,
    /// The coefficient of (ln τ)/τ.
    pub log: f64,
}

/// What is fitted, by the time τ.
pub const TERMS: [&dyn Fn(f64) -> f64; 6] = [
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
        log: fit.coefficients[1],
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

/// What is followed, with its name.
pub type Named = (&'static str, Quantity);

/// α − ½ ln τ.
pub(crate) const EXCESS: Named = (r"$\alpha-\frac12\ln\tau$", |l| {
    alpha(&l.state) - 0.5 * libm::log(l.tau)
});
/// α − ⅓ ln A.
pub(crate) const ALPHA_BY_A: Named = (r"$\alpha-\frac13\ln A$", |l| {
    alpha(&l.state) - libm::log(a(&l.state)) / 3.0
});
/// τ dα/dτ.
pub(crate) const ALPHA_RATE: Named = (r"$\tau\,\mathrm d\alpha/\mathrm d\tau$", |l| {
    l.tau * l.alpha_rate
});
/// dA/dτ over A^(1/3).
pub(crate) const A_RATE: Named = (r"$(\mathrm dA/\mathrm d\tau)/A^{1/3}$", |l| {
    l.a_rate / libm::cbrt(a(&l.state))
});
/// cosh α cosh 2α over A, where (129) has 1.
pub const PRODUCT: Named = (r"$\cosh\alpha\cosh2\alpha/A$", |l| {
    let alpha = alpha(&l.state);
    libm::cosh(alpha) * libm::cosh(2.0 * alpha) / a(&l.state)
});
/// In the laboratory: a rate of 1 more than on the table, put together from components that do not cancel.
const WINDING: Named = (
    r"$\tau$ times the rate of turn about the axis, in the laboratory,",
    |l| {
        let Start { p, xi, zeta } = l.state.parts;
        l.tau * (xi * xi + (zeta - p) * zeta) / l.state.rho().powi(2)
    },
);

/// (128) times τ.
pub(crate) const EQ128: Named = (r"$\tau$ times (128)", |l| {
    l.tau * printed::eq128_alpha_rate(alpha(&l.state), a(&l.state))
});
const CORRECTED128: Named = (r"$\tau(\sqrt2/\cosh2\alpha-\cosh\alpha/A)$", |l| {
    l.tau * corrected::alpha_rate(alpha(&l.state), a(&l.state))
});
/// A²/2, as (138) has it, over s.
fn eq138(l: &Late) -> f64 {
    printed::eq138_s(a(&l.state)) / l.state.s
}

/// What grows as a power of τ.
pub struct Power {
    symbol: &'static str,
    power: f64,
    /// What is left of a law of it where the power is taken out, in words.
    rest: &'static str,
    /// The same of the motion.
    pub over: Named,
}

/// p.
pub const SPEED: Power = Power {
    symbol: "$p$",
    power: 2.0,
    rest: r" over $\tau^2$",
    over: (r"$p/\tau^2$", |l| l.state.p() / (l.tau * l.tau)),
};
/// ρ.
pub const DISTANCE: Power = Power {
    symbol: r"$\rho$",
    over: (r"$\rho/\tau^2$", |l| l.state.rho() / (l.tau * l.tau)),
    ..SPEED
};
/// s.
pub(crate) const WAY: Power = Power {
    symbol: "$s$",
    power: 3.0,
    rest: r" over $\tau^3$",
    over: (r"$s/\tau^3$", |l| l.state.s / (l.tau * l.tau * l.tau)),
};
/// A.
pub const SIZE: Power = Power {
    symbol: "$A$",
    power: 1.5,
    rest: r" over $\tau^{3/2}$",
    over: (r"$A/\tau^{3/2}$", |l| {
        a(&l.state) / (l.tau * libm::sqrt(l.tau))
    }),
};
/// π/2 − ψ.
pub(crate) const LAG: Power = Power {
    symbol: r"$\pi/2-\psi$",
    power: -1.0,
    rest: r" times $\tau$, at $\tau=10^8$,",
    over: (r"$(\pi/2-\psi)\tau$", |l| l.state.lag() * l.tau),
};

/// The limits of p/τ², A/τ^(3/2) and (π/2 − ψ) τ, as corrected.
pub(crate) fn corrected_limits() -> [f64; 3] {
    let [speed, size] = [
        SPEED.prefactor(corrected::rho),
        SIZE.prefactor(corrected::a),
    ];
    [speed, size, LAG.prefactor(corrected::lag)]
}
/// The first two as printed.
pub(crate) fn printed_limits() -> [f64; 2] {
    [printed::eq135_p(1.0), printed::eq132_a(1.0)]
}

impl Power {
    fn prefactor(&self, law: fn(f64) -> f64) -> f64 {
        law(LATE) / libm::pow(LATE, self.power)
    }

    /// The coefficient of (ln τ)/τ, over the limit: the law holds in a time that is late.
    pub(crate) fn corrected_log(&self) -> f64 {
        -self.power * corrected::delay::<f64>()
    }

    fn printed(&self, law: &'static str, formula: fn(f64) -> f64) -> Evidence {
        let value = self.prefactor(formula);
        tends([law, self.rest, ""], Printed, self.over, |_| value)
    }

    fn corrected(&self, stated: &'static str, formula: fn(f64) -> f64) -> Evidence {
        limits(Corrected, self.over, stated, self.prefactor(formula))
    }

    fn exponent(&self, law: &'static str, subject: Subject, formula: fn(f64) -> f64) -> Evidence {
        let compared = Compared::composed(
            [r"the exponent of $\tau$ in ", law, ""],
            ["that in ", self.symbol, " of the motion"],
        );
        each(compared, subject, ESCAPE_LIMIT, |flight| {
            let (found, _) = exponent(flight, self.over.1)?;
            let stated = libm::log(formula(LATE) / formula(1.0)) / libm::log(LATE);
            Ok([stated, found + self.power])
        })
    }

    fn delay(&self, stated: &'static str) -> Evidence {
        let coefficient = r"the coefficient of $(\ln\tau)/\tau$ in ";
        let (name, quantity) = self.over;
        let compared =
            Compared::composed([stated, "", ""], [coefficient, name, ", over the limit"]);
        each(compared, Corrected, ESCAPE_CORRECTION, |flight| {
            let found = limit(flight, quantity)?;
            Ok([self.corrected_log(), found.log / found.value])
        })
    }
}

fn each(
    compared: Compared,
    subject: Subject,
    tolerance: Tolerance,
    pair: impl Fn(&Escape) -> Result<[f64; 2], Failure>,
) -> Evidence {
    Trial::by(Route::Limit, subject, compared, tolerance).each(
        ESCAPES.each(),
        Escape::at,
        |flight| {
            let [stated, found] = pair(flight)?;
            Ok([stated, found, 1.0])
        },
    )
}

fn tends(
    stated: [&'static str; 3],
    subject: Subject,
    (name, quantity): Named,
    value: impl Fn(&Escape) -> f64,
) -> Evidence {
    let late = r" of the motion, for $\tau\to\infty$";
    let compared = Compared::composed(stated, [name, late, ""]);
    each(compared, subject, ESCAPE_LIMIT, |flight| {
        Ok([value(flight), limit(flight, quantity)?.value])
    })
}

/// What is stated of every escape, one value for all, against the limit of what its motion does.
pub fn limits(subject: Subject, named: Named, stated: &'static str, value: f64) -> Evidence {
    tends([stated, "", ""], subject, named, |_| value)
}

/// The limit of a formula, evaluated along the motion; one that has none states nothing.
fn followed(flight: &Escape, formula: Quantity) -> f64 {
    limit(flight, formula).map_or(f64::NAN, |limit| limit.value)
}

fn following(subject: Subject, named: Named, (stated, formula): Named) -> Evidence {
    tends([stated, "", ""], subject, named, |flight| {
        followed(flight, formula)
    })
}

/// The limit of the ratio of an equation's sides, of which one is the motion's own, against 1.
fn sides(ratio: &'static str, formula: Quantity) -> Evidence {
    let compared = Compared::composed([ratio, r", for $\tau\to\infty$,", ""], ["1", "", ""]);
    each(compared, Printed, ESCAPE_LIMIT, |flight| {
        Ok([followed(flight, formula), 1.0])
    })
}

attempts![
    eq128_limit | corrected128_limit = following(ALPHA_RATE)((EQ128) | (CORRECTED128)),
    eq129_limit = sides(PRODUCT.0, |l| printed::eq129_a(alpha(&l.state))
        / a(&l.state)),
    corrected129_limit = limits(
        Corrected,
        PRODUCT,
        r"$3\sqrt2/4$",
        corrected::product_over_a()
    ),
    eq130_limit | corrected130_limit = limits(ALPHA_BY_A)(
        (
            r"(130) less $\frac13\ln A$",
            printed::eq130_alpha(LATE) - libm::log(LATE) / 3.0
        ) | (
            r"$\frac13\ln(3\sqrt2)$",
            corrected::alpha_by_a(LATE) - libm::log(LATE) / 3.0
        )
    ),
    eq131_limit | corrected131_limit = limits(A_RATE)(
        (
            "(131) over $A^{1/3}$",
            printed::eq131_a_rate(LATE) / libm::cbrt(LATE)
        ) | (
            r"$\frac12(3\sqrt2)^{1/3}$",
            corrected::a_rate(LATE) / libm::cbrt(LATE)
        )
    ),
    eq132_limit = SIZE.printed("(132)", printed::eq132_a),
    eq132_exponent = SIZE.exponent("(132)", Printed, printed::eq132_a),
    corrected132_limit = SIZE.corrected("$2^{1/4}/3$", corrected::a),
    corrected132_delay = SIZE.delay(r"$-9\sqrt2/8$"),
    eq133_limit | corrected133_limit = limits(EXCESS)(
        (
            r"(133) less $\frac12\ln\tau$",
            printed::eq133_alpha(LATE) - 0.5 * libm::log(LATE)
        ) | (
            r"$\frac12\ln\sqrt2$",
            corrected::alpha(LATE) - 0.5 * libm::log(LATE)
        )
    ),
    eq134_exponent = LAG.exponent("(134)", Printed, printed::eq134_lag),
    eq134_limit = LAG.printed("(134)", printed::eq134_lag),
    corrected134_exponent = LAG.exponent(r"$2/\tau$", Corrected, corrected::lag),
    corrected134_limit = LAG.corrected("the stated 2", corrected::lag),
    corrected134_delay = LAG.delay(r"$3\sqrt2/4$"),
    eq135_limit = SPEED.printed("(135)", printed::eq135_p),
    eq135_exponent = SPEED.exponent("(135)", Printed, printed::eq135_p),
    corrected135_limit = SPEED.corrected(r"$1/(3\sqrt2)$", corrected::rho),
    corrected135_delay = SPEED.delay(r"$-3\sqrt2/2$"),
    eq136_limit = DISTANCE.printed("(136)", printed::eq136_rho),
    eq136_exponent = DISTANCE.exponent("(136)", Printed, printed::eq136_rho),
    corrected136_limit = DISTANCE.corrected(r"$1/(3\sqrt2)$", corrected::rho),
    corrected136_delay = DISTANCE.delay(r"$-3\sqrt2/2$"),
    winding_limit = limits(Remark, WINDING, r"$\sqrt2$", corrected::winding()),
    eq137_limit = WAY.printed("(137)", printed::eq137_s),
    eq137_exponent = WAY.exponent("(137)", Printed, printed::eq137_s),
    corrected137_limit = WAY.corrected(r"$1/(9\sqrt2)$", corrected::s),
    corrected137_delay = WAY.delay(r"$-9\sqrt2/4$"),
    eq138_limit = sides("$(A^2/2)/s$", eq138)
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::escape::trajectories::Launch;
    use crate::motion::turntable::intrinsic::Run;

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
