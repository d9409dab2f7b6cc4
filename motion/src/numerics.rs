//! The tools of [`trialbook::numerics`], and what only motions need: many starts at once (`batch`), the times of events
//! ([`events`]), functions by pieces ([`piecewise`]).

pub(crate) mod batch;
pub mod events;
pub mod piecewise;

pub use trialbook::numerics::*;

/// NaN of nothing; of an even number the upper one of both in the middle.
pub(crate) fn median(numbers: impl Iterator<Item = f64>) -> f64 {
    let mut all: Vec<_> = numbers.collect();
    if all.is_empty() {
        return f64::NAN;
    }
    let middle = all.len() / 2;
    *all.select_nth_unstable_by(middle, f64::total_cmp).1
}
