//! The two numbers of each case by hand. The words are in the claims' entries.

use super::prelude::*;
use super::pulse_remarks::friction;

/// What the printed formula says, and what the motion does.
pub(super) static CASES: [Numbers; 1] = [Numbers::new(
    "s23-nonzero-again",
    || {
        Ok(printed::s23_nonzero_again(friction([
            0.5,
            0.25,
            0.75 * PI,
        ])?))
    },
    || Ok(pulses(0.5)?.h(0.75 * PI)),
)];
