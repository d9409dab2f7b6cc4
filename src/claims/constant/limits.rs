//! Trials of (15) to (20): no friction, critical friction, and the time of stopping.

use super::runs::{Stop, Turn, launch_free, settled, stops, turns_where};
use crate::claims::compare::{Failure, Pair, Trial};
use crate::claims::conditioned::Conditioned;
use crate::claims::tolerances::TERMINAL;
use crate::corrections::constant as corrected;
use crate::evidence::{Evidence, Route, Subject};
use crate::numerics::quadrature::integrate;
use crate::paper::constant as printed;
use crate::scalar::Scalar;
