//! The figures of the book: functions from data to a drawing with its numbers, made with the tools of
//! [`trialbook::figures`].
//!
//! A figure never computes physics. Whoever calls it integrates, counts or bisects, and hands plain data over; a function
//! here, such as [`constant::fig1`], turns them into a [`Figure`].

mod all;
pub mod anisotropic;
pub mod constant;
pub mod digits;
pub mod drift;
pub mod escape;
pub mod exam;
pub mod periodic;
pub mod rest;
pub mod sinusoidal;
pub mod solve;
pub mod sphere;
#[cfg(test)]
mod tests;
pub mod turntable;

pub use all::{AllFiguresError, all};

/// Which figure of the paper one of ours is drawn after: by its caption and the marks on its axes alone.
fn after(id: &str) -> String {
    let number = id.trim_start_matches("fig-");
    format!(
        "After figure {number} of the paper, by its caption and marks; its source has no pictures, and we have not seen that one."
    )
}
