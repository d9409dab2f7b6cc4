//! Numbers enclosed, statements on whole ranges proved.

pub mod ball;
pub mod cover;
pub mod drive;
pub mod error;
pub mod flow;
pub mod interval;
pub mod jet;
pub mod krawczyk;
pub mod root;
pub mod turntable;
pub mod values;
