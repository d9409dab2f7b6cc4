//! The two numbers of each case by hand. The words are in the claims' entries.

use super::final_direction::sense_of_sliding;
use super::prelude::*;

/// What the printed formula says, and what the motion does.
pub(super) static CASES: [Numbers; 1] = [Numbers::new(
    "s21-along-acceleration",
    || Ok(printed::s21_late_sense()),
    sense_of_sliding,
)];
