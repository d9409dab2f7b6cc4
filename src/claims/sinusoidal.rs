//! Sinusoidal acceleration: stick and slip: the claims.

mod across;
mod argument;
pub mod attraction;
pub mod certified;
pub mod chains;
mod decay;
pub mod drawn;
pub mod exact;
pub mod excepted;
mod kinds;
pub mod order;
mod periodic;
mod phases;
mod rest_of_period;
pub(super) mod settled;
mod slip;
pub mod stages;
mod threshold;
mod units;

use super::{SHARED, by_hand, values};
use trialbook::claims::Topic;
use trialbook::claims::read::claims;

/// The topic.
pub static TOPIC: Topic = Topic::new(
    "sinusoidal",
    "Sinusoidal acceleration: stick and slip",
    claims!("../../claims/sinusoidal.toml"),
    &[
        across::TRIALS,
        argument::TRIALS,
        attraction::TRIALS,
        certified::TRIALS,
        chains::TRIALS,
        decay::TRIALS,
        drawn::TRIALS,
        exact::TRIALS,
        excepted::TRIALS,
        kinds::TRIALS,
        order::TRIALS,
        periodic::TRIALS,
        phases::TRIALS,
        rest_of_period::TRIALS,
        slip::TRIALS,
        stages::TRIALS,
        threshold::TRIALS,
        units::TRIALS,
    ],
)
.sharing(SHARED)
.by_hand(&by_hand::SINUSOIDAL)
.numbers(&values::SINUSOIDAL);
