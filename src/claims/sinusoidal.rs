//! Sinusoidal acceleration: stick and slip: the claims.

mod argument;
pub(crate) mod attraction;
mod by_hand;
pub(crate) mod certified;
pub(crate) mod chains;
pub(crate) mod drawn;
pub(crate) mod exact;
pub(crate) mod excepted;
mod periodic;
pub(crate) mod phase_order;
mod phases;
pub(super) mod reference_motions;
pub(super) mod regimes;
mod rest_of_period;
mod second_stage;
mod slip;
mod threshold;
mod transverse;
pub(crate) mod transverse_decay;
mod units;
mod values;

use prelude::*;

mod prelude {
    pub(super) use super::reference_motions::{
        ORIGIN, Particle, Slip, drive, end_spread, lambda_c, phi_t2, settled,
    };
    pub(super) use crate::claims::general::two_frames::{eq1, eq2};
    pub(super) use crate::claims::prelude::*;
    pub(super) use crate::corrections::sinusoidal as corrected;
    pub(super) use crate::motion::drive::{
        Attractor, Drive, DriveState, Friction, Interval, PlanarState, Sign,
    };
    pub(super) use crate::numerics::number::Real;
    pub(super) use crate::paper::sinusoidal as printed;
}

pub(crate) static TOPIC: Topic = Topic::new(
    "sinusoidal",
    "Sinusoidal acceleration: stick and slip",
    claims!("claims/sinusoidal.toml"),
    &[
        transverse::TRIALS,
        argument::TRIALS,
        attraction::TRIALS,
        certified::TRIALS,
        chains::TRIALS,
        second_stage::TRIALS,
        drawn::TRIALS,
        exact::TRIALS,
        excepted::TRIALS,
        regimes::TRIALS,
        phase_order::TRIALS,
        periodic::TRIALS,
        phases::TRIALS,
        rest_of_period::TRIALS,
        slip::TRIALS,
        transverse_decay::TRIALS,
        threshold::TRIALS,
        units::TRIALS,
    ],
)
.sharing(SHARED)
.by_hand(&by_hand::CASES)
.numbers(&values::VALUES);
