//! Why a motion gives no number.

use crate::motion::MotionError;
use crate::motion::drive::DriveError;
use trialbook::trials::runs::failures;

failures!(DriveError, MotionError);
