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
pub mod periodic;
pub mod rest;
pub mod sinusoidal;
pub mod solve;
pub mod sphere;
#[cfg(test)]
mod tests;
pub mod turntable;

pub use all::{AllFiguresError, all};
pub use trialbook::figures::{
    Align, Area, Axis, BLANK, Cell, Curve, Figure, FigureError, Marker, Note, Panel, Plot, Points,
    Raster, Rule, Stroke, Table,
};
