//! What several cases are found with.

use crate::exam::ExamError;
use crate::motion::State;
use crate::numerics::roots::root;

pub(super) type Found<T = f64> = Result<T, ExamError>;

/// Cases: the source, what is asked, the number, its unit, and ours; where the two differ, why.
macro_rules! cases {
    ($($source:ident, $asked:literal, $printed:expr, $unit:literal, $ours:expr $(, $why:expr)?;)*) => {
        [$(Case {
            source: &$source,
            asked: $asked,
            printed: $printed,
            unit: $unit,
            why: [$($why,)? ""][0],
            ours: $ours,
        }),*]
    };
}

/// Sources: a name, what it is, and what of it was read.
macro_rules! sources {
    ($($name:ident: $title:literal, $read:literal;)*) => {
        $(pub(super) static $name: Source = Source { title: $title, read: $read };)*
    };
}

pub(super) use {cases, sources};

pub(super) fn zero_of(mut f: impl FnMut(f64) -> Found, low: f64, high: f64) -> Found {
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
pub(super) fn border(moved: impl Fn(f64) -> Found<bool>, mut low: f64, mut high: f64) -> Found {
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

pub(super) fn moving(v: f64) -> State {
    State::moving([v, 0.0])
}
