//! Any periodic acceleration: the claims.

pub mod again;
pub mod borders;
pub mod chains;
mod changes;
pub mod drawn;
pub mod drives;
pub mod exact;
mod losses;
mod mostly;
mod pulses;
mod rest;
pub mod threshold;

use super::{SHARED, by_hand};
use trialbook::claims::Topic;
use trialbook::claims::read::claims;

/// The topic.
pub static TOPIC: Topic = Topic::new(
    "periodic",
    "Any periodic acceleration",
    claims!("../../claims/periodic.toml"),
    &[
        again::TRIALS,
        borders::TRIALS,
        chains::TRIALS,
        changes::TRIALS,
        drawn::TRIALS,
        exact::TRIALS,
        losses::TRIALS,
        mostly::TRIALS,
        pulses::TRIALS,
        rest::TRIALS,
        threshold::TRIALS,
    ],
)
.sharing(SHARED)
.by_hand(&by_hand::PERIODIC);
