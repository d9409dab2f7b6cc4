//! The turntable: equations: the claims.

mod complex;
mod continued;
mod definitions;
pub mod drawn;
mod ends;
mod energy;
pub mod exact;
pub mod excepted;
pub mod fixed;
mod frames;
pub mod projections;
mod rates;
mod standstill;
pub mod stretches;

use super::{SHARED, by_hand};
use trialbook::claims::Topic;
use trialbook::claims::read::claims;

/// The topic.
pub static TOPIC: Topic = Topic::new(
    "turntable",
    "The turntable: equations",
    claims!("../../claims/turntable.toml"),
    &[
        continued::TRIALS,
        definitions::TRIALS,
        drawn::TRIALS,
        ends::TRIALS,
        energy::TRIALS,
        exact::TRIALS,
        excepted::TRIALS,
        fixed::TRIALS,
        frames::TRIALS,
        projections::TRIALS,
        rates::TRIALS,
        standstill::TRIALS,
    ],
)
.sharing(SHARED)
.by_hand(&by_hand::TURNTABLE);
