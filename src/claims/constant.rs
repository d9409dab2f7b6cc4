//! Constant acceleration: the claims.

mod by_hand;
mod definitions;
pub(crate) mod drawn;
pub mod exact;
pub(crate) mod excepted;
mod extremes;
pub(crate) mod final_direction;
mod from_rest;
mod hodograph;
mod incline;
pub(super) mod launches;
mod limits;
mod only_constant;
mod time;

use prelude::*;

mod prelude {
    pub(super) use super::launches::{TURNS, Turn};
    pub(super) use crate::claims::prelude::*;
    pub(super) use crate::corrections::constant as corrected;
    pub(super) use crate::paper::constant as printed;
}

/// The topic.
pub static TOPIC: Topic = Topic::new(
    "constant",
    "Constant acceleration",
    claims!("claims/constant.toml"),
    &[
        definitions::TRIALS,
        drawn::TRIALS,
        exact::TRIALS,
        exact::alignment::TRIALS,
        exact::cases::TRIALS,
        exact::incline::TRIALS,
        exact::sliding::TRIALS,
        excepted::TRIALS,
        extremes::TRIALS,
        from_rest::TRIALS,
        hodograph::TRIALS,
        incline::TRIALS,
        limits::TRIALS,
        only_constant::TRIALS,
        final_direction::TRIALS,
        time::TRIALS,
    ],
)
.sharing(SHARED)
.by_hand(&by_hand::CASES);
