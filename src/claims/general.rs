//! Sliding on an accelerating plane: the claims.

mod accelerations;
pub(crate) mod chains;
pub(super) mod contraction;
mod examples;
pub(crate) mod excepted;
mod properties;
pub(crate) mod strong_drives;
pub(crate) mod two_frames;

use prelude::*;

mod prelude {
    pub(super) use super::two_frames::{NAMES, eq1, eq1_proof};
    pub(super) use crate::claims::prelude::*;
    pub(super) use crate::motion::{Acceleration, Phase};
    pub(super) use crate::paper::general as printed;
}

pub(crate) static TOPIC: Topic = Topic::new(
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
