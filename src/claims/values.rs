//! The numbers that the paper's claims state or imply, and a search among them.

mod search;

pub use search::{Match, NotDecimal, find};

use crate::claims::anisotropic::runs::touching;
use crate::claims::compare::Failure;
use crate::claims::solve::sinusoidal::Problem;
use crate::corrections::{escape as corrected, sinusoidal as decay};
use crate::motion::turntable::{critical_radius, critical_speed};
use crate::paper::{escape, rest, sinusoidal as printed, sphere};
use std::f64::consts::PI;

/// A number that claims carry.
#[derive(Debug, Clone, PartialEq)]
pub struct Named {
    /// Its symbol.
    pub symbol: &'static str,
    /// What it is.
    pub meaning: &'static str,
    /// Ids of the claims that state it or rest on it.
    pub claims: &'static [&'static str],
    /// Its value in decimals, to as many digits as are known, not rounded in the last one.
    pub decimals: String,
}

/// Significant digits that a value computed in floating point is believed to have.
const BELIEVED: usize = 14;
/// The same for a value found by bisection on a motion.
const BISECTED: usize = 11;

/// All numbers, computed.
///
/// # Errors
/// An equation or a motion that cannot be solved, which does not happen.
pub fn values() -> Result<Vec<Named>, Failure> {
    let mut all = Vec::new();
    let mut add = |symbol, value: f64, digits, meaning, claims| {
        all.push(Named {
            symbol,
            meaning,
            claims,
            decimals: decimals(value, digits),
        });
    };
    let mut exact = |symbol, value, meaning, claims| add(symbol, value, BELIEVED, meaning, claims);
    let lambda_c: f64 = printed::eq37_lambda_c();
    exact(
        "λ_c",
        lambda_c,
        "critical friction of the sinusoidal drive",
        &["eq-36", "eq-37", "eq-40", "eq-57", "s24-X"],
    );
    let [weak, strong] = [1.0 / PI, libm::sqrt(0.5)];
    let swing = |lambda0| Problem { lambda0 }.solve().map(|answer| answer.best);
    let (small, large) = (swing(weak)?, swing(strong)?);
    exact("1/π", weak, "λ₀ of the small-friction figure", &["fig-3"]);
    exact(
        "φ̃₁(1/π)",
        printed::eq39_phi_t1(weak),
        "where forward motion begins at λ₀ = 1/π",
        &["eq-39", "fig-3"],
    );
    exact(
        "𝔴_max(1/π)",
        small.w_max,
        "largest velocity at λ₀ = 1/π",
        &["eq-38", "fig-3"],
    );
    exact(
        "1/√2",
        strong,
        "λ₀ of the large-friction figure; slope of the printed boundary",
        &["fig-4", "eq-147"],
    );
    exact(
        "φ₁(1/√2)",
        printed::eq27_phi1(strong),
        "where a rest ends at λ₀ = 1/√2",
        &["eq-27", "fig-4"],
    );
    exact(
        "φ₂(1/√2)",
        printed::eq28_phi2(strong),
        "where forward motion is fastest at λ₀ = 1/√2",
        &["eq-28", "fig-4"],
    );
    exact(
        "φ₃(1/√2)",
        printed::eq29_phi3(strong),
        "where the second rest ends at λ₀ = 1/√2",
        &["eq-29", "fig-4"],
    );
    exact(
        "φ₄(1/√2)",
        printed::eq30_phi4(strong),
        "the last phase at which drive and friction are equal at λ₀ = 1/√2",
        &["eq-30", "fig-4"],
    );
    exact(
        "φ̃₂(1/√2)",
        large.positive_end.unwrap_or(f64::NAN),
        "where forward motion ends at λ₀ = 1/√2",
        &["eq-32", "eq-33", "fig-4"],
    );
    exact(
        "𝔴_max(1/√2)",
        large.w_max,
        "largest velocity at λ₀ = 1/√2",
        &["eq-31", "fig-4"],
    );
    exact(
        "contraction(1/π)",
        decay::contraction(weak),
        "by what factor a distance to the motion at λ₀ = 1/π shrinks in a period",
        &["eq-38", "s22-attractor-ignores-vy"],
    );
    let y = touching()?;
    exact(
        "q of Y",
        y,
        "where the curves B and C touch",
        &["eq-58", "s24-Y", "eq-54", "eq-55"],
    );
    exact(
        "λ₀ of Y",
        1.0 / y,
        "where the curves B and C touch",
        &["eq-58", "s24-Y", "eq-54", "eq-55"],
    );
    exact(
        "tan x = x",
        libm::sqrt(y * y - 1.0),
        "the root that gives Y",
        &["eq-58", "s24-Y"],
    );
    exact(
        "b, solid",
        sphere::eq67_factor(0.4),
        "friction factor of a solid sphere",
        &["eq-67"],
    );
    exact(
        "b, hollow",
        sphere::eq67_factor(2.0 / 3.0),
        "friction factor of a hollow sphere",
        &["eq-67"],
    );
    exact(
        "A/τ^(3/2), printed",
        escape::eq132_a(1.0),
        "prefactor of (132) as printed",
        &["eq-132"],
    );
    exact(
        "A/τ^(3/2)",
        corrected::a(1.0),
        "prefactor that replaces that of (132)",
        &["eq-132"],
    );
    exact(
        "e^2α/τ, printed",
        libm::exp(2.0 * escape::eq133_alpha(1.0)),
        "prefactor in (133) as printed",
        &["eq-133"],
    );
    exact(
        "√2",
        corrected::winding(),
        "prefactor in what replaces (133); windings per unit of ln τ",
        &["eq-133", "eq-128"],
    );
    exact(
        "(π/2 − ψ) τ",
        corrected::lag(1.0),
        "what replaces (134)",
        &["eq-134"],
    );
    exact(
        "√3",
        escape::eq134_lag(1.0),
        "prefactor of (134) as printed",
        &["eq-134"],
    );
    exact(
        "ρ/τ², printed",
        escape::eq136_rho(1.0),
        "prefactor of (135) and (136) as printed",
        &["eq-135", "eq-136"],
    );
    exact(
        "ρ/τ²",
        corrected::amplitude(),
        "prefactor that replaces that of (135) and (136)",
        &["eq-135", "eq-136"],
    );
    exact(
        "s/τ³, printed",
        escape::eq137_s(1.0),
        "prefactor of (137) as printed",
        &["eq-137"],
    );
    exact(
        "s/τ³",
        corrected::s(1.0),
        "prefactor that replaces that of (137)",
        &["eq-137"],
    );
    exact(
        "3√2/4",
        corrected::delay(),
        "cosh α cosh 2α over A at large times; lag of time per unit of ln τ",
        &["eq-129"],
    );
    exact(
        "A by (147) at α = 1",
        rest::eq147_a(1.0),
        "the printed boundary at α = 1",
        &["eq-147"],
    );
    exact(
        "7/6",
        crate::corrections::rest::boundary_curvature(0.0),
        "coefficient of α² on the boundary at ψ = 0",
        &["eq-147", "s4-envelope-is-boundary"],
    );
    add(
        "ρ_c",
        critical_radius()?,
        BISECTED,
        "the largest distance at which a particle put down at rest comes to rest",
        &["s4-rest-radius", "s4-envelope-is-boundary"],
    );
    add(
        "p_c",
        critical_speed()?,
        BISECTED,
        "the largest speed of a launch from the axis that comes to rest",
        &["s4-rest-radius", "s4-envelope-is-boundary"],
    );
    Ok(all)
}

/// A value to so many significant digits, the rest cut off.
fn decimals(value: f64, digits: usize) -> String {
    let exponent = libm::floor(libm::log10(value.abs())) as i32;
    let places = (digits as i32 - 1 - exponent).max(0) as usize;
    // Two digits more, so that rounding does not reach those that are kept.
    let mut text = format!("{value:.*}", places + 2);
    text.truncate(text.len() - 2);
    text
}
