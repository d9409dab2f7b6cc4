//! What the trials and proofs of several topics use.

pub use super::tolerances::*;
pub use crate::exact::{Derivation, Function, Series};
pub use crate::motion::{Motion, MotionError, PhaseKind, Plane, Signal, State, run};
pub use crate::numerics::double::Double;
pub use crate::numerics::quadrature::{integral_within, sum};
pub use std::f64::consts::{FRAC_PI_2, PI, TAU};
pub use trialbook::prelude::*;
