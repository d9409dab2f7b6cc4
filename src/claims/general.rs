//! Sliding on an accelerating plane: the claims.

mod accelerations;
pub mod chains;
pub(super) mod contraction;
mod examples;
pub mod excepted;
mod properties;
pub mod strong_drives;
pub mod two_frames;

use prelude::*;

/// What the topic's modules use.
mod prelude {
    pub(super) use super::two_frames::{NAMES, eq1, eq1_proof};
    pub(super) use crate::claims::prelude::*;
    pub(super) use crate::motion::{Acceleration, Phase};
    pub(super) use crate::paper::general as printed;
}

/// The topic.
pub static TOPIC: Topic = Topic::new(
    "general",
    "Sliding on an accelerating plane",
    claims!("claims/general.toml"),
    &[
        chains::TRIALS,
        excepted::TRIALS,
        two_frames::TRIALS,
        properties::TRIALS,
        strong_drives::TRIALS,
    ],
)
.sharing(SHARED);
