//! The figures.

use slipbook::figures::all;
use std::sync::LazyLock;
use trialbook::plotting::Figure;

/// All figures.
pub static FIGURES: LazyLock<Vec<Figure>> = LazyLock::new(|| all().unwrap());
