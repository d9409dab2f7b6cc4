//! A sphere that slips and rolls: the claims.

pub(crate) mod angle;
mod any_drive;
mod by_hand;
mod definitions;
pub(crate) mod driven;
mod every_drive;
pub(crate) mod exact;
pub(crate) mod excepted;
mod rates;
mod scaling;
mod spheres;
mod values;

use prelude::*;

mod prelude {
    pub(super) use super::spheres::{Followed, braking, sphere, weighed};
    pub(super) use crate::claims::prelude::*;
    pub(super) use crate::corrections::sphere as corrected;
    pub(super) use crate::motion::drive::{Drive, Sign};
    pub(super) use crate::motion::sphere::{Ball, BallMotion, Contact, Directed, Sphere};
    pub(super) use crate::paper::sphere as printed;
}

pub(crate) static TOPIC: Topic = Topic::new(
    "sphere",
    "A sphere that slips and rolls",
    claims!("claims/sphere.toml"),
    &[
        angle::TRIALS,
        any_drive::TRIALS,
        definitions::TRIALS,
        driven::TRIALS,
        every_drive::TRIALS,
        exact::angle::TRIALS,
        exact::body::TRIALS,
        exact::newton::TRIALS,
        exact::carried::TRIALS,
        excepted::TRIALS,
        rates::TRIALS,
        scaling::TRIALS,
        super::sinusoidal::excepted::TRIALS,
    ],
)
.sharing(SHARED)
.by_hand(&by_hand::CASES)
.numbers(&values::VALUES);
