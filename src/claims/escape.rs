//! The turntable: escape: the claims.

pub(crate) mod bounds;
mod by_hand;
pub(crate) mod exact;
pub(crate) mod excepted;
pub mod growth;
pub mod onset;
pub(crate) mod steps;
pub mod straight;
pub mod trajectories;
mod values;

use prelude::*;

mod prelude {
    pub(super) use super::trajectories::ESCAPES;
    pub(super) use crate::claims::prelude::*;
    pub(super) use crate::claims::turntable::exact as turntable;
    pub(super) use crate::corrections::escape as corrected;
    pub(super) use crate::motion::turntable::Start;
    pub(super) use crate::motion::turntable::intrinsic::{Intrinsic, Run};
    pub(super) use crate::paper::escape as printed;
    pub(super) use crate::paper::turntable as motion;
}

/// The topic.
pub static TOPIC: Topic = Topic::new(
    "escape",
    "The turntable: escape",
    claims!("claims/escape.toml"),
    &[
        bounds::TRIALS,
        exact::TRIALS,
        exact::chains::TRIALS,
        exact::spiral::TRIALS,
        excepted::TRIALS,
        growth::TRIALS,
        onset::TRIALS,
        steps::TRIALS,
    ],
)
.sharing(SHARED)
.by_hand(&by_hand::CASES)
.numbers(&values::VALUES);
