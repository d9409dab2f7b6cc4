//! Numbers enclosed, statements on whole ranges proved: every result comes with proved bounds. An
//! [`Interval`](interval::Interval) lies between two f64 and is fast; a [`Ball`](ball::Ball) has as many
//! digits as one asks for.
//!
//! - [`root`] and [`krawczyk`]: a root exists in a box and is the only one there;
//! - [`cover`]: an inequality, or the sign of a slope, holds on a whole range;
//! - [`flow`]: all motions from a box of starts;
//! - [`jet`] and [`taylor`]: formulas differentiated on the way; [`enclosure`]: certain digits.
//!
//! What could not be proved is an error that says where.

pub mod ball;
pub mod cover;
pub mod enclosure;
pub mod error;
pub mod flow;
pub mod interval;
pub mod jet;
pub mod krawczyk;
pub mod root;
pub mod taylor;
