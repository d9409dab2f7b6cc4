//! Sliding on an accelerating plane: the claims.

pub(super) mod apart;
pub mod chains;
mod examples;
pub mod excepted;
pub mod law;
mod planes;
mod properties;
pub mod strong;

use super::SHARED;
use trialbook::claims::Topic;
use trialbook::claims::read::claims;

/// The topic.
pub static TOPIC: Topic = Topic::new(
    "general",
    "Sliding on an accelerating plane",
    claims!("../../claims/general.toml"),
    &[
        chains::TRIALS,
        excepted::TRIALS,
        law::TRIALS,
        properties::TRIALS,
        strong::TRIALS,
    ],
)
.sharing(SHARED);
