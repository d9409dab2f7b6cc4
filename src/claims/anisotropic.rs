//! Anisotropic friction: the claims.

pub mod census;
pub mod certified;
mod corners;
mod curves;
pub mod drawn;
pub mod drift;
pub mod exact;
mod frictions;
mod mirror;
pub mod motions;
mod numbers;
pub mod panels;
mod regions;
pub mod rows;
pub mod simulated;
mod slips;
mod transverse;
mod transverse_decay;

use super::shared::SHARED;
use trialbook::prelude::{Topic, claims};

/// The topic.
pub static TOPIC: Topic = Topic::new(
    "anisotropic",
    "Anisotropic friction",
    claims!("claims/anisotropic.toml"),
    &[
        transverse::TRIALS,
        certified::TRIALS,
        certified::points::TRIALS,
        corners::TRIALS,
        curves::TRIALS,
        transverse_decay::TRIALS,
        exact::TRIALS,
        frictions::TRIALS,
        mirror::TRIALS,
        motions::TRIALS,
        panels::TRIALS,
        regions::TRIALS,
        slips::TRIALS,
        super::sinusoidal::excepted::TRIALS,
    ],
)
.sharing(SHARED)
.by_hand(&numbers::CASES)
.numbers(&numbers::VALUES);
