//! Constant acceleration: the claims.

mod definitions;
pub mod drawn;
pub mod exact;
pub mod excepted;
mod extremes;
mod from_rest;
mod hodograph;
mod incline;
mod launches;
mod limits;
mod only_constant;
pub mod sense;
mod time;

use super::{SHARED, by_hand};
use trialbook::claims::Topic;
use trialbook::claims::read::claims;

/// The topic.
pub static TOPIC: Topic = Topic::new(
    "constant",
    "Constant acceleration",
    claims!("../../claims/constant.toml"),
    &[
        definitions::TRIALS,
        drawn::TRIALS,
        exact::TRIALS,
        excepted::TRIALS,
        extremes::TRIALS,
        from_rest::TRIALS,
        hodograph::TRIALS,
        incline::TRIALS,
        limits::TRIALS,
        only_constant::TRIALS,
        sense::TRIALS,
        time::TRIALS,
    ],
)
.sharing(SHARED)
.by_hand(&by_hand::CONSTANT);
