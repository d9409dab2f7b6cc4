//! The tools of [`trialbook::numerics`], and what only motions need: many starts at once (`batch`), the times of events
//! ([`events`]), functions by pieces ([`piecewise`]).

pub(crate) mod batch;
pub mod events;
pub mod piecewise;

pub use trialbook::numerics::*;
