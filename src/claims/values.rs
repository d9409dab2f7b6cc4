//! The numbers by which a claim can be found: how each is computed, and how it is enclosed where a closed form or an equation
//! of the drive encloses it. What they are, and to which claims they belong, is in the claims' entries.

use super::anisotropic::simulated::touching;
use super::escape::growth;
use super::sinusoidal::reference_motions::{ORIGIN, settled};
use crate::certified::numbers;
use crate::corrections::{anisotropic as added, escape as corrected, rest as boundary};
use crate::motion::turntable;
use crate::paper::{anisotropic, escape, rest, sinusoidal, sphere};
use std::f64::consts::{FRAC_1_PI, FRAC_1_SQRT_2, PI, SQRT_2, TAU};
use trialbook::certified::ball::Ball;
use trialbook::certified::enclosure::Enclosure;
use trialbook::certified::error::CertifiedError;
use trialbook::claims::enclosed::on_balls;
use trialbook::claims::runs::Runs;
pub use trialbook::claims::values::{Form, Match, NotDecimal, Number, Value, decimal_of, search};
use trialbook::prelude::*;

/// Of `sinusoidal`.
pub static SINUSOIDAL: [Number; 14] = [
    Number::new("lambda-c", || Ok(sinusoidal::eq37_lambda_c())).within(numbers::LAMBDA_C),
    Number::new("fig-3-start", || Ok(sinusoidal::eq39_phi_t1(FRAC_1_PI))),
    Number::new("fig-3-largest", || largest(FRAC_1_PI)),
    Number::new("fig-4-largest", || largest(FRAC_1_SQRT_2)),
    Number::new("phi-1", || Ok(sinusoidal::eq27_phi1(FRAC_1_SQRT_2))),
    Number::new("phi-2", || Ok(sinusoidal::eq28_phi2(FRAC_1_SQRT_2))),
    Number::new("phi-3", || Ok(sinusoidal::eq29_phi3(FRAC_1_SQRT_2))),
    Number::new("phi-4", || Ok(sinusoidal::eq30_phi4(FRAC_1_SQRT_2))),
    Number::new("fig-3-friction", || Ok(FRAC_1_PI)),
    Number::new("fig-4-friction", || Ok(FRAC_1_SQRT_2)),
    Number::enclosed("critical-phase", numbers::CRITICAL_PHASE),
    Number::enclosed("fig-4-slip-end", numbers::SLIP_END_FIG_4),
    Number::enclosed("slip-end-0.6", numbers::SLIP_END_3_5),
    Number::enclosed("slip-end-0.9", numbers::SLIP_END_9_10),
];

/// Of `anisotropic`.
pub static ANISOTROPIC: [Number; 13] = [
    Number::new("y-q-printed", || Ok(anisotropic::eq58_y::<f64>()[0])),
    Number::new("y-lambda-printed", || Ok(anisotropic::eq58_y::<f64>()[1])),
    Number::new("y-q", touching).within(numbers::Q_Y),
    Number::new("y-lambda", || Ok(1.0 / touching()?)).within(numbers::LAMBDA_Y),
    Number::new("contact", || Ok(added::contact(touching()?))).within(numbers::CONTACT),
    Number::new("y-root", || touching().map(|q| libm::sqrt(q * q - 1.0))).within(numbers::X_Y),
    Number::enclosed("curve-a-2", numbers::A_2),
    Number::enclosed("curve-a-6", numbers::A_6),
    Number::enclosed("curve-a-12", numbers::A_12),
    Number::enclosed("curve-b-2", numbers::B_2),
    Number::enclosed("curve-b-3", numbers::B_3),
    Number::enclosed("curve-e-6", numbers::E_6),
    Number::enclosed("curve-e-12", numbers::E_12),
];

/// Of `sphere`.
pub static SPHERE: [Number; 4] = [
    Number::new("kappa-solid", || Ok(2.0 / 5.0)),
    Number::new("b-solid", || Ok(sphere::eq67_factor(0.4))),
    Number::new("b-hollow", || Ok(sphere::eq67_factor(2.0 / 3.0))),
    Number::new("slip-end", || Ok(14.0 / 33.0)),
];

/// Of `escape`.
pub static ESCAPE: [Number; 11] = [
    Number::new("a-printed", || Ok(escape::eq132_a(1.0)))
        .within(Enclosure(|bits| closed(escape::eq132_a(one()), bits))),
    Number::new("a", || Ok(growth::corrected_size()))
        .within(Enclosure(|bits| closed(corrected::a(one()), bits))),
    Number::new("alpha-printed", || Ok(escape::eq133_alpha(1.0))),
    Number::new("alpha", || Ok(corrected::alpha(1.0))),
    Number::new("p-printed", || Ok(growth::printed_speed()))
        .within(Enclosure(|bits| closed(escape::eq135_p(one()), bits))),
    Number::new("p", || Ok(growth::corrected_speed()))
        .within(Enclosure(|bits| closed(corrected::rho(one()), bits))),
    Number::new("s-printed", || Ok(escape::eq137_s(1.0)))
        .within(Enclosure(|bits| closed(escape::eq137_s(one()), bits))),
    Number::new("s", || Ok(corrected::s(1.0)))
        .within(Enclosure(|bits| closed(corrected::s(one()), bits))),
    Number::new("turn", || Ok(libm::exp(TAU / SQRT_2))),
    Number::new("delay", || Ok(corrected::delay()))
        .within(Enclosure(|bits| closed(corrected::delay(), bits))),
    Number::new("winding", || Ok(corrected::winding()))
        .within(Enclosure(|bits| closed(corrected::winding(), bits))),
];

/// Of `rest`.
pub static REST: [Number; 6] = [
    Number::new("critical-radius", || Ok(turntable::critical_radius()?)),
    Number::new("critical-speed", || Ok(turntable::critical_speed()?)),
    Number::new("envelope", || Ok(rest::eq147_a(0.1))),
    Number::new("boundary", boundary_example),
    Number::new("boundary-slope", || Ok(boundary::boundary_slope(PI / 2.0))),
    Number::new("boundary-curvature", || {
        Ok(boundary::boundary_curvature(0.0))
    }),
];

fn one() -> Expr {
    Expr::int(1)
}

/// A formula without symbols, enclosed.
fn closed(formula: Expr, bits: usize) -> Result<Ball, CertifiedError> {
    let ball = on_balls(formula, bits + 8, &|_| None).map(|ball| ball.with_bits(bits));
    ball.ok_or_else(|| CertifiedError::unproved("the formula has no ball", &[]))
}

/// A on the boundary at α = 0.1, ψ = 0.2; computed once.
///
/// # Errors
/// A motion that cannot be followed.
pub fn boundary_example() -> Result<f64, Failure> {
    static A: Runs<f64> = Runs::new(|| Ok(turntable::boundary(0.1, 0.2)?));
    A.get().copied()
}

/// The largest velocity of the periodic motion under a sine.
fn largest(lambda: f64) -> Result<f64, Failure> {
    Ok(settled(lambda, ORIGIN)?.largest().w.abs())
}

#[cfg(test)]
mod tests {
    use crate::claims::PAPER;
    use crate::numerics::expression::expression;
    use std::collections::BTreeSet;

    #[test]
    fn every_value_has_its_digits() {
        let ids: BTreeSet<_> = PAPER.values().map(|value| value.id).collect();
        assert_eq!(ids.len(), PAPER.values().count());
        for value in PAPER.values() {
            let shown: f64 = value.shown().unwrap().parse().unwrap();
            let half = 0.5 * libm::exp10(-(value.decimals as f64));
            let off = (shown - value.number().unwrap()).abs();
            assert!(off <= half * (1.0 + 1e-9), "{}: {shown}", value.id);
            if let Some(enclosure) = value.enclosure {
                let [number, middle] =
                    [value.number().unwrap(), enclosure.interval().unwrap().mid()];
                let off = (number - middle).abs();
                assert!(
                    off < 1e-11 * middle.abs(),
                    "{}: {number}, {middle}",
                    value.id
                );
            }

            if let Some(form) = value.closed {
                let closed: f64 = expression(form, |digits| digits.parse().ok()).unwrap();
                let number = value.number().unwrap();
                assert!(
                    (closed - number).abs() < 1e-12 * number.abs(),
                    "{}",
                    value.id
                );
            }

            // As many digits as are known, cut off; nines may be rounded up if there are two of them or more.
            let digits = value.digits().unwrap();
            let significant = digits.trim_start_matches(['-', '0', '.']).replace('.', "");
            assert_eq!(significant.len(), value.known(), "{} {digits}", value.id);
            let number = value.number().unwrap();
            let cut = number - digits.parse::<f64>().unwrap();
            let unit = libm::exp10(-(digits.split_once('.').unwrap().1.len() as f64));
            // The work number is rounded too.
            let rounding = 4.0 * f64::EPSILON * number.abs();
            assert!(
                cut >= -0.005 * unit - rounding && cut < unit + rounding,
                "{} {number} {digits}",
                value.id
            );
        }
        // 1/√2 = 0.70710678118654752440|08…, e^(√2 π) = 85.0196952232…, 7/6 = 1.1666…; 14/33 = 0.4242…
        for (id, cut, rounded) in [
            (
                "fig-4-friction",
                "0.70710678118654752440",
                "0.70710678118654752440",
            ),
            ("turn", "85.019695223207217582", "85.019695223207217583"),
            ("y-q-printed", "4.6030000000000000000", "4.603"),
            ("b-solid", "3.5000000000000000000", "3.5"),
            (
                "boundary-curvature",
                "1.1666666666666666666",
                "1.1666666666666666667",
            ),
            (
                "slip-end",
                "0.42424242424242424242",
                "0.42424242424242424242",
            ),
            ("critical-speed", "1.1653079259", "1.1653079259"),
        ] {
            let value = PAPER.value(id).unwrap();
            assert_eq!(value.digits().unwrap(), cut);
            assert_eq!(value.rounded().unwrap(), rounded);
        }
    }
}
