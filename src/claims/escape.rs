//! The turntable: escape: the claims.

pub mod bounds;
pub mod exact;
pub mod excepted;
pub mod growth;
mod numbers;
pub mod onset;
pub mod steps;
pub mod straight;
pub mod trajectories;

use super::shared::SHARED;
use trialbook::prelude::{Topic, claims};

/// The topic.
pub static TOPIC: Topic = Topic::new(
    "escape",
    "The turntable: escape",
    claims!("claims/escape.toml"),
    &[
        bounds::TRIALS,
        exact::TRIALS,
        exact::chains::TRIALS,
        exact::spiral::TRIALS,
        excepted::TRIALS,
        growth::TRIALS,
        onset::TRIALS,
        steps::TRIALS,
    ],
)
.sharing(SHARED)
.by_hand(&numbers::CASES)
.numbers(&numbers::VALUES);
