//! Numbers enclosed, statements on whole ranges proved.
//!
//! Nothing here is "accurate": every result comes with bounds, and the bounds are proved by the way in which they were
//! computed. An [`Interval`](interval::Interval) lies between two f64 and is fast; a [`Ball`](ball::Ball) has as many
//! digits as one asks for. On them rest
//!
//! - [`root`] and [`krawczyk`]: a root exists in a box and is the only one there;
//! - [`cover`]: an inequality, or the sign of a slope, holds on a whole range;
//! - [`flow`]: all motions from a box of starts, by an integrator that bounds what it leaves out.
//!
//! [`jet`] differentiates formulas on the way, [`taylor`] more than once. An [`enclosure`] gives a number's
//! certain digits.
//!
//! What could not be proved is an error that says where, never a guess.

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
