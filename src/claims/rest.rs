//! The turntable: rest: the claims.

pub(crate) mod approach;
pub(crate) mod boundary;
mod by_hand;
pub(crate) mod certified;
mod dichotomy;
pub(crate) mod exact;
pub(crate) mod excepted;
pub mod fates;
pub(crate) mod radius;
pub(crate) mod surfaces;
pub(crate) mod trajectories;
mod values;

use prelude::*;

mod prelude {
    pub(super) use crate::claims::prelude::*;
    pub(super) use crate::claims::turntable::exact as turntable;
    pub(super) use crate::corrections::rest as corrected;
    pub(super) use crate::motion::turntable::boundary::between;
    pub(super) use crate::motion::turntable::intrinsic::Run;
    pub(super) use crate::motion::turntable::{Fate, Path, Start, State, Table, fate, inertial};
    pub(super) use crate::paper::rest as printed;
    pub(super) use crate::paper::turntable as motion;
}

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
.by_hand(&by_hand::CASES)
.numbers(&values::VALUES);
