//! What replaces a printed formula that fails, or that has no value where the motion has one.
//!
//! Same stems as in [`crate::paper`]; every entry is tried in `crate::claims` like a printed formula.

pub mod anisotropic;
pub mod constant;
pub mod escape;
pub mod periodic;
pub mod rest;
pub mod sinusoidal;
pub mod sphere;
pub mod turntable;
