//! A sphere that slips and rolls: the claims.

pub mod angle;
mod any_drive;
mod definitions;
pub mod driven;
mod every_drive;
pub mod exact;
pub mod excepted;
mod numbers;
mod rates;
mod scaling;
mod spheres;

use super::shared::SHARED;
use trialbook::prelude::{Topic, claims};

/// The topic.
pub static TOPIC: Topic = Topic::new(
    "sphere",
    "A sphere that slips and rolls",
    claims!("claims/sphere.toml"),
    &[
        angle::TRIALS,
        any_drive::TRIALS,
        definitions::TRIALS,
        driven::TRIALS,
        every_drive::TRIALS,
        exact::TRIALS,
        exact::carried::TRIALS,
        excepted::TRIALS,
        rates::TRIALS,
        scaling::TRIALS,
        super::sinusoidal::excepted::TRIALS,
    ],
)
.sharing(SHARED)
.by_hand(&numbers::CASES)
.numbers(&numbers::VALUES);
