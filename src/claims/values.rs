//! The numbers by which a claim can be found: computed, each with the claim that it belongs to, and enclosed where a
//! closed form or an equation of the drive encloses it.

use super::anisotropic::simulated::touching;
use super::compare::Failure;
use super::enclosed::on_balls;
use super::escape::growth;
use super::sinusoidal::settled::{ORIGIN, settled};
use crate::certified::ball::Ball;
use crate::certified::enclosure::Enclosure;
use crate::certified::error::CertifiedError;
use crate::certified::numbers;
use crate::claims::runs::Runs;
use crate::corrections::{anisotropic as added, escape as corrected, rest as boundary};
use crate::exact::Expr;
use crate::motion::turntable;
use crate::paper::{anisotropic, escape, rest, sinusoidal, sphere};
use crate::scalar::Scalar;
use std::f64::consts::{FRAC_1_PI, FRAC_1_SQRT_2, PI, SQRT_2, TAU};
pub use trialbook::claims::values::{Form, Match, NotDecimal, Value, decimal_of, search};

/// All numbers, in the paper's order.
pub static VALUES: [Value; 48] = [
    Value::new(
        "lambda-c",
        "eq-37",
        10,
        "$\\lambda_\\mathrm{c}$, the friction from which on the shaken particle rests",
        || Ok(sinusoidal::eq37_lambda_c()),
    )
    .within(numbers::LAMBDA_C)
    .closed("2/sqrt(4+pi^2)"),
    Value::new(
        "fig-3-start",
        "eq-39",
        4,
        "$\\tilde\\phi_1$ at $\\lambda_0=1/\\pi$",
        || Ok(sinusoidal::eq39_phi_t1(FRAC_1_PI)),
    )
    .closed("pi/3"),
    Value::new(
        "fig-3-largest",
        "fig-3",
        3,
        "largest $\\mathfrak w$ at $\\lambda_0=1/\\pi$",
        || largest(FRAC_1_PI),
    )
    .closed("1/2 + cos(asin(1/pi)) - (2*pi/3 - asin(1/pi))/pi"),
    Value::new(
        "fig-4-largest",
        "fig-4",
        4,
        "largest $\\mathfrak w$ at $\\lambda_0=1/\\sqrt2$",
        || largest(FRAC_1_SQRT_2),
    )
    .closed("sqrt(2)*(1 - pi/4)"),
    Value::new("y-q-printed", "eq-58", 3, "$q$ of Y, as printed", || {
        Ok(anisotropic::eq58_y::<f64>()[0])
    })
    .closed("4.603"),
    Value::new(
        "y-lambda-printed",
        "eq-58",
        3,
        "$\\lambda_0$ of Y, as printed",
        || Ok(anisotropic::eq58_y::<f64>()[1]),
    )
    .closed("0.217"),
    Value::new(
        "y-q",
        "s24-Y",
        12,
        "$q$ of Y, where B and C touch",
        touching,
    )
    .within(numbers::Q_Y),
    Value::new("y-lambda", "s24-Y", 12, "$\\lambda_0$ of Y", || {
        Ok(1.0 / touching()?)
    })
    .within(numbers::LAMBDA_Y),
    Value::new(
        "contact",
        "s24-Y",
        6,
        "how fast B leaves C at Y: $1/q-\\lambda_0$ over $(q-q_Y)^2$",
        || Ok(added::contact(touching()?)),
    )
    .within(numbers::CONTACT),
    Value::new(
        "kappa-solid",
        "eq-67",
        1,
        "$\\kappa=I/(mR^2)$ of a solid sphere",
        || Ok(2.0 / 5.0),
    )
    .closed("2/5"),
    Value::new(
        "b-solid",
        "eq-67",
        1,
        "$b$ of a solid sphere, $\\kappa=\\frac25$",
        || Ok(sphere::eq67_factor(0.4)),
    )
    .closed("7/2"),
    Value::new(
        "b-hollow",
        "eq-67",
        1,
        "$b$ of a thin shell, $\\kappa=\\frac23$",
        || Ok(sphere::eq67_factor(2.0 / 3.0)),
    )
    .closed("5/2"),
    Value::new(
        "slip-end",
        "eq-82",
        4,
        "the time $\\frac{14}{33}$ at which the sphere of the example ceases to slip",
        || Ok(14.0 / 33.0),
    )
    .closed("14/33"),
    Value::new(
        "a-printed",
        "eq-132",
        6,
        "$A/\\tau^{3/2}$ in an escape, as printed: $2/\\sqrt{27}$",
        || Ok(escape::eq132_a(1.0)),
    )
    .within(Enclosure(|bits| closed(escape::eq132_a(one()), bits)))
    .closed("2/sqrt(27)"),
    Value::new(
        "a",
        "eq-132",
        6,
        "$A/\\tau^{3/2}$ in an escape: $\\frac13 2^{1/4}$",
        || Ok(growth::corrected_size()),
    )
    .within(Enclosure(|bits| closed(corrected::a(one()), bits)))
    .closed("sqrt(sqrt(2))/3"),
    Value::new(
        "alpha-printed",
        "eq-133",
        6,
        "$\\alpha-\\frac12\\ln\\tau$ in an escape, as printed: $\\frac12\\ln\\frac43$",
        || Ok(escape::eq133_alpha(1.0)),
    )
    .closed("ln(4/3)/2"),
    Value::new(
        "alpha",
        "eq-133",
        6,
        "$\\alpha-\\frac12\\ln\\tau$ in an escape: $\\frac14\\ln2$",
        || Ok(corrected::alpha(1.0)),
    )
    .closed("ln(2)/4"),
    Value::new(
        "p-printed",
        "eq-135",
        6,
        "$p/\\tau^2$ in an escape, as printed: $\\frac29$",
        || Ok(growth::printed_speed()),
    )
    .within(Enclosure(|bits| closed(escape::eq135_p(one()), bits)))
    .closed("2/9"),
    Value::new(
        "p",
        "eq-135",
        6,
        "$p/\\tau^2$ and $\\rho/\\tau^2$ in an escape: $1/(3\\sqrt2)$",
        || Ok(growth::corrected_speed()),
    )
    .within(Enclosure(|bits| closed(corrected::rho(one()), bits)))
    .closed("1/(3*sqrt(2))"),
    Value::new(
        "s-printed",
        "eq-137",
        6,
        "$s/\\tau^3$ in an escape, as printed: $\\frac2{27}$",
        || Ok(escape::eq137_s(1.0)),
    )
    .within(Enclosure(|bits| closed(escape::eq137_s(one()), bits)))
    .closed("2/27"),
    Value::new(
        "s",
        "eq-137",
        6,
        "$s/\\tau^3$ in an escape: $1/(9\\sqrt2)$",
        || Ok(corrected::s(1.0)),
    )
    .within(Enclosure(|bits| closed(corrected::s(one()), bits)))
    .closed("1/(9*sqrt(2))"),
    Value::new(
        "turn",
        "eq-136",
        0,
        "the factor in $\\tau$ over which an escape goes once around the axis: $\\mathrm e^{2\\pi/\\sqrt2}$",
        || Ok(libm::exp(TAU / SQRT_2)),
    )
    .closed("exp(sqrt(2)*pi)"),
    Value::new(
        "delay",
        "eq-135",
        6,
        "the lag of the escape's clock over $\\ln\\tau$: $\\frac34\\sqrt2$",
        || Ok(corrected::delay()),
    )
    .within(Enclosure(|bits| closed(corrected::delay(), bits)))
    .closed("3*sqrt(2)/4"),
    Value::new(
        "critical-radius",
        "s4-rest-radius",
        10,
        "how far from the axis a particle at rest in the laboratory may be put down and come to rest, over $\\mu g/\\Omega^2$",
        || Ok(turntable::critical_radius()?),
    ),
    Value::new(
        "critical-speed",
        "s4-rest-radius",
        10,
        "how fast a particle may leave the axis and come to rest, over $\\mu g/\\Omega$",
        || Ok(turntable::critical_speed()?),
    ),
    Value::new(
        "envelope",
        "eq-147",
        4,
        "$A$ on the printed boundary at $\\alpha=0.1$",
        || Ok(rest::eq147_a(0.1)),
    )
    .closed("(1 - 0.1/sqrt(2))^2"),
    Value::new(
        "boundary",
        "s4-envelope-is-boundary",
        4,
        "$A$ on the boundary at $\\alpha=0.1$, $\\psi=0.2$",
        boundary_example,
    ),
    Value::new(
        "boundary-slope",
        "s4-envelope-is-boundary",
        4,
        "$-\\mathrm dA/\\mathrm d\\alpha$ of the boundary at $\\alpha=0$, $\\psi=\\pi/2$",
        || Ok(boundary::boundary_slope(PI / 2.0)),
    )
    .closed("1/2"),
    Value::new(
        "phi-1",
        "eq-27",
        4,
        "$\\phi_1$ at $\\lambda_0=1/\\sqrt2$",
        || Ok(sinusoidal::eq27_phi1(FRAC_1_SQRT_2)),
    )
    .closed("pi/4"),
    Value::new(
        "phi-2",
        "eq-28",
        4,
        "$\\phi_2$ at $\\lambda_0=1/\\sqrt2$",
        || Ok(sinusoidal::eq28_phi2(FRAC_1_SQRT_2)),
    )
    .closed("3*pi/4"),
    Value::new(
        "phi-3",
        "eq-29",
        4,
        "$\\phi_3$ at $\\lambda_0=1/\\sqrt2$",
        || Ok(sinusoidal::eq29_phi3(FRAC_1_SQRT_2)),
    )
    .closed("5*pi/4"),
    Value::new(
        "phi-4",
        "eq-30",
        4,
        "$\\phi_4$ at $\\lambda_0=1/\\sqrt2$",
        || Ok(sinusoidal::eq30_phi4(FRAC_1_SQRT_2)),
    )
    .closed("7*pi/4"),
    Value::new(
        "fig-3-friction",
        "fig-3",
        4,
        "$1/\\pi$, the friction of Figure 3",
        || Ok(FRAC_1_PI),
    )
    .closed("1/pi"),
    Value::new(
        "fig-4-friction",
        "fig-4",
        4,
        "$1/\\sqrt2$, the friction of Figure 4",
        || Ok(FRAC_1_SQRT_2),
    )
    .closed("1/sqrt(2)"),
    Value::new(
        "y-root",
        "s24-Y",
        12,
        "$x$ of Y: the least positive root of $\\tan x=x$",
        || touching().map(|q| libm::sqrt(q * q - 1.0)),
    )
    .within(numbers::X_Y),
    Value::new(
        "boundary-curvature",
        "s4-envelope-is-boundary",
        4,
        "the coefficient $\\frac76$ of $\\alpha^2$ on the boundary at $\\psi=0$",
        || Ok(boundary::boundary_curvature(0.0)),
    )
    .closed("7/6"),
    Value::new(
        "winding",
        "eq-136",
        6,
        "the angle by which an escape circles the axis, in the laboratory, over $\\ln\\tau$: $\\sqrt2$",
        || Ok(corrected::winding()),
    )
    .within(Enclosure(|bits| closed(corrected::winding(), bits)))
    .closed("sqrt(2)"),
    Value::enclosed(
        "critical-phase",
        "eq-37",
        10,
        "$\\sin^{-1}\\lambda_\\mathrm{c}$, the phase at which the slip begins at the critical friction",
        numbers::CRITICAL_PHASE,
    )
    .closed("asin(2/sqrt(4+pi^2))"),
    Value::enclosed(
        "fig-4-slip-end",
        "eq-32",
        10,
        "$\\tilde\\phi_2$ at $\\lambda_0=1/\\sqrt2$, where the forward slip ends",
        numbers::SLIP_END_FIG_4,
    ),
    Value::enclosed(
        "slip-end-0.6",
        "eq-32",
        10,
        "$\\tilde\\phi_2$ at $\\lambda_0=\\frac35$, where the forward slip ends",
        numbers::SLIP_END_3_5,
    ),
    Value::enclosed(
        "slip-end-0.9",
        "eq-32",
        10,
        "$\\tilde\\phi_2$ at $\\lambda_0=\\frac9{10}$, where the forward slip ends",
        numbers::SLIP_END_9_10,
    ),
    Value::enclosed(
        "curve-a-2",
        "eq-53",
        10,
        "$\\lambda_0$ of A at $q=2$",
        numbers::A_2,
    ),
    Value::enclosed(
        "curve-a-6",
        "eq-53",
        10,
        "$\\lambda_0$ of A at $q=6$",
        numbers::A_6,
    ),
    Value::enclosed(
        "curve-a-12",
        "eq-53",
        10,
        "$\\lambda_0$ of A at $q=12$",
        numbers::A_12,
    ),
    Value::enclosed(
        "curve-b-2",
        "eq-54",
        10,
        "$\\lambda_0$ of B at $q=2$",
        numbers::B_2,
    ),
    Value::enclosed(
        "curve-b-3",
        "eq-54",
        10,
        "$\\lambda_0$ of B at $q=3$",
        numbers::B_3,
    ),
    Value::enclosed(
        "curve-e-6",
        "s24-region-2",
        10,
        "$\\lambda_0$ of E at $q=6$",
        numbers::E_6,
    ),
    Value::enclosed(
        "curve-e-12",
        "s24-region-2",
        10,
        "$\\lambda_0$ of E at $q=12$",
        numbers::E_12,
    ),
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
    use super::*;
    use crate::claims::PAPER;
    use crate::numerics::expression::expression;
    use std::collections::BTreeSet;

    #[test]
    fn every_value_belongs_to_a_claim_and_has_its_digits() {
        let ids: BTreeSet<_> = VALUES.iter().map(|value| value.id).collect();
        assert_eq!(ids.len(), VALUES.len());
        for value in &VALUES {
            assert!(PAPER.find(value.claim).is_some(), "{}", value.id);
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
