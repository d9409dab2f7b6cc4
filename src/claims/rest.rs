//! The turntable: rest: the claims.

pub mod approach;
pub mod boundary;
pub mod certified;
mod dichotomy;
pub mod exact;
pub mod excepted;
pub mod fates;
mod numbers;
pub mod radius;
pub mod surfaces;
pub mod trajectories;

use super::shared::SHARED;
use trialbook::prelude::{Topic, claims};

/// The topic.
pub static TOPIC: Topic = Topic::new(
    "rest",
    "The turntable: rest",
    claims!("claims/rest.toml"),
    &[
        approach::TRIALS,
        boundary::TRIALS,
        certified::TRIALS,
        dichotomy::TRIALS,
        exact::TRIALS,
        exact::arrivals::TRIALS,
        exact::barriers::TRIALS,
        exact::boundary::TRIALS,
        exact::chains::TRIALS,
        exact::least::TRIALS,
        exact::saddle::TRIALS,
        exact::series::TRIALS,
        exact::surfaces::TRIALS,
        excepted::TRIALS,
        radius::TRIALS,
        surfaces::TRIALS,
    ],
)
.sharing(SHARED)
.by_hand(&numbers::CASES)
.numbers(&numbers::VALUES);
