//! The tools that both the motions and the trials work with; none of them knows any physics.
//!
//! Most motions here are integrated by their own Taylor series ([`taylor`]): the right-hand sides are
//! made of few elementary functions, whose coefficients follow from each other by short recurrences
//! ([`series`]). A step of order 26 is long, its error is known from its last coefficients, and the step
//! itself is a polynomial, so that a value between two nodes ([`taylor::Step::at`]) and the time of an
//! event are as good as the nodes. The same code works over any [`number::Number`], such as numbers of
//! twice the width ([`mod@double`]), in which the rounding of an `f64` is seen.
//!
//! Whoever integrates with one's own code alone proves little, so there is a second, foreign integrator
//! ([`dop853`]). Integrals go through a Gauss–Legendre rule, or an adaptive Gauss–Kronrod one where that does not
//! suffice ([`quadrature`]), equations in one unknown through bracketing root-finders ([`roots`]), fits through a QR
//! decomposition ([`fit`]), the growth of small deviations through eigenvalues ([`mod@eigenvalues`]).
//!
//! Every door returns a typed error instead of a number that is not one, and none of them can run forever.
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
