//! The boundary between rest and escape, by bisection on the [fate](mod@super::fate).

use super::fate::rests;
use super::intrinsic::Start;
use crate::error::MotionError;
use std::sync::LazyLock;

/// Bisects `start` between a value from which the particle rests and one from which it escapes, until they are
/// neighbours to `width`, or rounding decides.
///
/// Cost: at most 130 fates, each of at most [`STEPS`](super::fate::STEPS) steps.
///
/// # Errors
/// [`MotionError::Argument`] when the particle does not rest at `rest` or does not escape at `escape`, or the width
/// is not positive; and the errors of `start`.
pub fn between(
    start: impl Fn(f64) -> Result<Start, MotionError>,
    rest: f64,
    escape: f64,
    width: f64,
) -> Result<f64, MotionError> {
    super::argument("width", width, width > 0.0, "positive")?;
    let at = |x: f64| rests(&start(x)?);
    super::argument(
        "rest",
        rest,
        at(rest)? == Some(true),
        "a start from which the particle rests",
    )?;
    let escapes = at(escape)? == Some(false);
    super::argument(
        "escape",
        escape,
        escapes,
        "a start from which the particle escapes",
    )?;
    let (mut rest, mut escape) = (rest, escape);
    // Twice the binary digits of a number are more than enough.
    for _ in 0..128 {
        let middle = 0.5 * (rest + escape);
        if (escape - rest).abs() <= width {
            break;
        }
        match at(middle)? {
            Some(true) => rest = middle,
            Some(false) => escape = middle,
            None => return Ok(middle),
        }
    }
    Ok(0.5 * (rest + escape))
}

/// Width to which bisections go.
const WIDTH: f64 = 1e-13;

/// The A at which states p = A sinh α, ρ = A cosh α with the given α and ψ pass from rest to escape, to 10⁻¹³;
/// everything dimensionless. Newton's law gives the bracket: where p + ρ = A exp(α) < 1 the particle rests, where
/// ρ² − p² = A² ≥ 1 it does not (see [`fate`](mod@super::fate)).
///
/// # Errors
/// [`MotionError::Argument`] for α outside [10⁻⁶, 10] or ψ not finite.
pub fn boundary(alpha: f64, psi: f64) -> Result<f64, MotionError> {
    super::argument(
        "alpha",
        alpha,
        (1e-6..=10.0).contains(&alpha),
        "between 1e-6 and 10",
    )?;
    let least = (1.0 - 1e-9) * libm::exp(-alpha);
    between(
        |a| Start::hyperbolic(a, alpha, psi),
        least,
        1.0 + 1e-9,
        WIDTH,
    )
}

/// The largest distance from the axis (in units of μg/Ω²) from which a particle put down at rest in the laboratory
/// comes to rest on the table; computed once.
///
/// # Errors
/// None that is known; those of the integration.
pub fn critical_radius() -> Result<f64, MotionError> {
    static RADIUS: LazyLock<Result<f64, MotionError>> =
        LazyLock::new(|| between(Start::put_down, 0.1, 10.0, WIDTH));
    RADIUS.clone()
}

/// The largest speed (in units of μg/Ω) with which a particle launched from the axis comes to rest on the table;
/// computed once.
///
/// # Errors
/// None that is known; those of the integration.
pub fn critical_speed() -> Result<f64, MotionError> {
    static SPEED: LazyLock<Result<f64, MotionError>> =
        LazyLock::new(|| between(Start::launched, 0.1, 10.0, WIDTH));
    SPEED.clone()
}
