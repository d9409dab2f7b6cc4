//! The tools that both the motions and the trials work with; none of them knows any physics. Motions are
//! integrated by their own Taylor series ([`taylor`]), over any [`number::Number`], and a foreign integrator
//! ([`dop853`]) checks that. Every door returns a typed error instead of a number that is not one, and none
//! can run forever.
// Where it is not built, its name leads to the feature that brings it.
#![cfg_attr(
    not(feature = "trials"),
    doc = "",
    doc = "[`dop853`]: crate#features",
    doc = "[`mod@eigenvalues`]: crate#features",
    doc = "[`fit`]: crate#features"
)]

#[cfg(feature = "trials")]
pub mod dop853;
pub mod double;
#[cfg(feature = "trials")]
pub mod eigenvalues;
pub mod error;
pub mod expression;
#[cfg(feature = "trials")]
pub mod fit;
pub mod lanes;
pub mod number;
pub mod quadrature;
pub mod roots;
pub mod series;
pub mod taylor;

pub use error::NumericsError;
