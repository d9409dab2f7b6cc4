//! Anisotropic friction: the claims.

mod by_hand;
pub mod census;
pub(crate) mod certified;
mod corners;
mod curves;
pub(crate) mod drawn;
pub mod drift;
pub(crate) mod exact;
mod frictions;
mod mirror;
pub(crate) mod motions;
pub(crate) mod panels;
mod regions;
pub(crate) mod rows;
pub mod simulated;
mod slips;
mod transverse;
mod transverse_decay;
mod values;

use prelude::*;

mod prelude {
    pub(super) use super::rows::{Row, rows};
    pub(super) use super::simulated::{
        Curves, START, attractor, attractor_from, corrected_list, listed_digits, own_y,
        printed_list, simulated, touching,
    };
    pub(super) use crate::claims::prelude::*;
    pub(super) use crate::corrections::anisotropic as corrected;
    pub(super) use crate::motion::drive::{Attractor, DriveState, Friction, Interval, Sign};
    pub(super) use crate::paper::anisotropic as printed;
}

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
.by_hand(&by_hand::CASES)
.numbers(&values::VALUES);
