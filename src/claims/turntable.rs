//! The turntable: equations: the claims.

mod analytic_continuation;
mod by_hand;
mod complex;
mod definitions;
pub(crate) mod drawn;
mod energy;
pub(crate) mod exact;
pub(crate) mod excepted;
pub(crate) mod fixed;
mod frames;
pub(crate) mod projections;
mod rates;
mod singular_starts;
mod start_and_stop;
pub(crate) mod trajectories;

use prelude::*;

mod prelude {
    pub(super) use super::trajectories::{
        ANY, ELL, FASTER, P, Quantity, RHO, Stretch, View, XI, stretches,
    };
    pub(super) use crate::claims::prelude::*;
    pub(super) use crate::corrections::turntable as corrections;
    pub(super) use crate::motion::turntable::intrinsic::Run;
    pub(super) use crate::motion::turntable::{
        Intrinsic, Path, Start, State, Table, inertial, rotating,
    };
    pub(super) use crate::paper::turntable as printed;
}

pub(crate) static TOPIC: Topic = Topic::new(
    "turntable",
    "The turntable: equations",
    claims!("claims/turntable.toml"),
    &[
        analytic_continuation::TRIALS,
        definitions::TRIALS,
        drawn::TRIALS,
        start_and_stop::TRIALS,
        energy::TRIALS,
        exact::components::TRIALS,
        exact::definitions::TRIALS,
        exact::energy::TRIALS,
        exact::fixed::TRIALS,
        exact::frames::TRIALS,
        exact::hyperbolic::TRIALS,
        excepted::TRIALS,
        fixed::TRIALS,
        frames::TRIALS,
        projections::TRIALS,
        rates::TRIALS,
        singular_starts::TRIALS,
    ],
)
.sharing(SHARED)
.by_hand(&by_hand::CASES);
