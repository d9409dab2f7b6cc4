//! The value of a word at which a number of the answer is what it is to be.

use super::{Number, Scene, SceneError, Until};
use crate::{MotionError, numerics::roots::root};

/// In how many steps a range is looked through.
pub const STEPS: u32 = 400;

const NEAR: f64 = 1e-6;

/// Where a number is what it is to be, and where it jumps over that.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Found {
    /// Values at which it is, with the digits that are known.
    pub solutions: Vec<f64>,
    /// Values at which it jumps over it.
    pub jumps: Vec<f64>,
}

/// Where from `low` to `high` the number `name` of the end of `scene` is `wanted`, in [`STEPS`] steps of equal ratios, or of
/// equal length where `low` is not positive: of two values closer together than one step, or where it is only touched, nothing
/// may be seen. Values without an answer are passed over.
///
/// Cost: some 500 answers as a rule.
///
/// # Errors
/// [`SceneError`] for a range that is none, and where no value has an answer that of the first.
pub fn find(
    scene: impl Fn(f64) -> Result<(Scene, Until), SceneError>,
    [low, high]: [f64; 2],
    (name, wanted): (&str, f64),
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
    let off = |x| {
        let (scene, until) = scene(x)?;
        Ok(scene.number(until, name)? - wanted)
    };
    let rounded = |value, error| {
        let (name, unit) = ("", "");
        let found = Number {
            name,
            unit,
            value,
            error,
        };
        found.rounded().unwrap_or(value)
    };
    // With the digits that the number's error and its slope there leave.
    let known = |x: f64| {
        let (scene, until) = scene(x)?;
        let numbers = scene.answer(until)?.numbers;
        let own = numbers.iter().find(|number| number.name == name);
        let near = NEAR * (high - low);
        let slope = match (off(x - near), off(x + near)) {
            (Ok(before), Ok(after)) => (after - before) / (2.0 * near),
            _ => f64::NAN,
        };
        let error = own.map_or(f64::NAN, |number| number.error) / slope.abs();
        Ok::<_, SceneError>(rounded(x, error))
    };
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
            found.solutions.push(known(*a)?);
        } else if *fb != 0.0 && (*fa > 0.0) != (*fb > 0.0) {
            let x = root(|x| off(x).unwrap_or(f64::NAN), *a, *b).map_err(MotionError::from)?;
            let near = off(x)?.abs() <= 1e-9 * wanted.abs().max(fa.abs().min(fb.abs()));
            if near {
                found.solutions.push(known(x)?);
            } else {
                found.jumps.push(rounded(x, 0.0));
            }
        }
    }
    if let Some((x, Ok(0.0))) = tried.last() {
        found.solutions.push(known(*x)?);
    }
    Ok(found)
}
