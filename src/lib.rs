//! Slipbook: a paper that checks itself.

pub mod claims;
pub mod corrections;
pub mod ledger;
pub mod motion;
pub mod numerics;
pub mod paper;
pub mod scalar;
