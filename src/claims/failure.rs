//! Why a motion, or a text, gives no number.

use super::values::NotDecimal;
use crate::motion::MotionError;
use crate::motion::drive::DriveError;
use trialbook::claims::runs::failures;

failures!(DriveError, MotionError, NotDecimal);
