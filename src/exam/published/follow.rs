//! What several cases are found with.

use crate::exam::ExamError;
use crate::motion::State;
use crate::numerics::roots::root;

/// What stands twice: a case without a reason, since none is needed.
macro_rules! case {
    ($source:ident, $asked:literal, $printed:expr, $unit:literal, $ours:expr) => {
        case!($source, $asked, $printed, $unit, $ours, "")
    };
    ($source:ident, $asked:literal, $printed:expr, $unit:literal, $ours:expr, $why:expr) => {
        Case {
            source: &$source,
            asked: $asked,
            printed: $printed,
            unit: $unit,
            why: $why,
            ours: $ours,
        }
    };
}

pub(super) use case;

/// A root of something that may fail.
pub(super) fn zero_of(
    mut f: impl FnMut(f64) -> Result<f64, ExamError>,
    low: f64,
    high: f64,
) -> Result<f64, ExamError> {
    let mut failed = None;
    let found = root(
        |x| {
            f(x).unwrap_or_else(|error| {
                failed = Some(error);
                f64::NAN
            })
        },
        low,
        high,
    );
    match failed {
        Some(error) => Err(error),
        None => Ok(found?),
    }
}

/// The border between bodies that stay and bodies that move, to 10⁻⁹ of its size, more than any of the sources has.
pub(super) fn border(
    moved: impl Fn(f64) -> Result<bool, ExamError>,
    mut low: f64,
    mut high: f64,
) -> Result<f64, ExamError> {
    let of_low = moved(low)?;
    while high - low > 1e-9 * high {
        let middle = 0.5 * (low + high);
        match moved(middle)? == of_low {
            true => low = middle,
            false => high = middle,
        }
    }
    Ok(0.5 * (low + high))
}

/// A body at the origin with a velocity along x.
pub(super) fn moving(v: f64) -> State {
    State::moving([v, 0.0])
}
