//! Slipbook: a paper that checks itself.

pub mod book;
pub mod claims;
pub mod corrections;
pub mod figures;
pub mod ledger;
pub mod paper;
pub mod scalar;
