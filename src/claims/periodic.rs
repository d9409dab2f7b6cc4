//! Any periodic acceleration: the claims.

mod by_hand;
pub(crate) mod chains;
pub(crate) mod critical_friction;
mod dissipation;
pub mod drawn;
pub(crate) mod drives;
pub(crate) mod exact;
pub(crate) mod pulse_remarks;
mod pulses;
mod rest;
mod rest_share;
mod step_drive;
pub(crate) mod threshold;

use prelude::*;

mod prelude {
    pub(super) use super::drives::{Harmonics, Phase, pulses};
    pub(super) use crate::claims::prelude::*;
    pub(super) use crate::corrections::periodic as supplied;
    pub(super) use crate::motion::drive::{
        Attractor, Drive, DriveError, DriveState, Friction, Sign,
    };
    pub(super) use crate::paper::periodic as printed;
}

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
.by_hand(&by_hand::CASES);
