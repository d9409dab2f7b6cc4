//! The value of a word at which a number of the answer is what it is to be.

use super::SceneError;
use crate::{MotionError, numerics::roots::root};

/// In how many steps a range is looked through.
pub const STEPS: u32 = 400;

/// Where a number is what it is to be, and where it jumps over that.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Found {
    /// Values at which it is.
    pub solutions: Vec<f64>,
    /// Values at which it jumps over it.
    pub jumps: Vec<f64>,
}

/// Looks from `low` to `high` for where `number` is `wanted`, in [`STEPS`] steps of equal ratios, or of equal length where `low`
/// is not positive: of two values closer together than one step, or where it is only touched, nothing may be seen. Values
/// without an answer are passed over.
///
/// Cost: some 500 answers as a rule.
///
/// # Errors
/// [`SceneError`] for a range that is none, and where no value has an answer that of the first.
pub fn find(
    number: impl Fn(f64) -> Result<f64, SceneError>,
    [low, high]: [f64; 2],
    wanted: f64,
) -> Result<Found, SceneError> {
    let fit = low < high && low.is_finite() && high.is_finite();
    super::check("low", low, fit, "less than high, and both finite")?;
    let point = |k: u32| {
        let share = f64::from(k) / f64::from(STEPS);
        if low > 0.0 {
            low * libm::pow(high / low, share)
        } else {
            low + share * (high - low)
        }
    };
    let off = |x| Ok(number(x)? - wanted);
    let tried: Vec<_> = (0..=STEPS).map(|k| (point(k), off(point(k)))).collect();
    if let Some((_, Err(error))) = tried.first()
        && tried.iter().all(|(_, value)| value.is_err())
    {
        return Err(SceneError::clone(error));
    }
    let mut found = Found::default();
    for pair in tried.windows(2) {
        let [(a, Ok(fa)), (b, Ok(fb))] = pair else {
            continue;
        };
        if *fa == 0.0 {
            found.solutions.push(*a);
        } else if *fb != 0.0 && (*fa > 0.0) != (*fb > 0.0) {
            let x = root(|x| off(x).unwrap_or(f64::NAN), *a, *b).map_err(MotionError::from)?;
            let near = off(x)?.abs() <= 1e-9 * wanted.abs().max(fa.abs().min(fb.abs()));
            let list = if near {
                &mut found.solutions
            } else {
                &mut found.jumps
            };
            list.push(x);
        }
    }
    if let Some((x, Ok(0.0))) = tried.last() {
        found.solutions.push(*x);
    }
    Ok(found)
}
