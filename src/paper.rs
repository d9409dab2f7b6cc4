//! The formulas as printed, errors included, under the paper's symbols.
//!
//! One file per topic, one function per formula, named after its number: (13) is `eq13_time`.
//! A formula is generic over [`Scalar`](crate::scalar::Scalar): the same line of code is evaluated as a
//! number and read as a syntax tree. Nothing is mended here; what replaces a formula that fails stands
//! under the same stem in [`crate::corrections`].

pub mod anisotropic;
pub mod constant;
pub mod escape;
pub mod general;
pub mod periodic;
pub mod rest;
pub mod sinusoidal;
pub mod sphere;
pub mod turntable;
