//! Numbers enclosed, statements on whole ranges proved.

pub mod ball;
pub mod error;
pub mod interval;
pub mod root;
