//! The [exam](slipbook_motion::exam) for engines and solvers, as data for who grades them, what they made of it, and numbers that
//! others have published.

pub mod package;
pub mod published;
pub mod results;

pub use slipbook_motion::exam::*;
