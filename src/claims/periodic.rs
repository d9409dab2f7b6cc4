//! Any periodic acceleration: the claims.

pub mod chains;
pub mod critical_friction;
mod dissipation;
pub mod drawn;
pub mod drives;
pub mod exact;
mod numbers;
pub mod pulse_remarks;
mod pulses;
mod rest;
mod rest_share;
mod step_drive;
pub mod threshold;

use super::shared::SHARED;
use trialbook::prelude::{Topic, claims};

/// The topic.
pub static TOPIC: Topic = Topic::new(
    "periodic",
    "Any periodic acceleration",
    claims!("claims/periodic.toml"),
    &[
        pulse_remarks::TRIALS,
        critical_friction::TRIALS,
        chains::TRIALS,
        step_drive::TRIALS,
        drawn::TRIALS,
        exact::TRIALS,
        dissipation::TRIALS,
        rest_share::TRIALS,
        pulses::TRIALS,
        rest::TRIALS,
        threshold::TRIALS,
    ],
)
.sharing(SHARED)
.by_hand(&numbers::CASES);
