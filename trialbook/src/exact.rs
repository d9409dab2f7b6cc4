//! Proofs in exact arithmetic: identities among a paper's formulas.
//!
//! A formula is read as a tree ([`Expr`]), put into a differential ring ([`Ring`]) where sines, exponentials,
//! powers and roots are rational functions of a few generators, and tested for zero; or read as a power
//! [`Series`]. A [`Proof`] keeps the steps for a reader.

mod calculus;
mod constant_folding;
mod error;
mod expand;
mod expr;
mod factor;
pub mod latex;
mod linear;
mod origin;
mod polynomial;
mod proof;
mod rational;
mod read;
mod ring;
mod series;

pub use calculus::Derivation;
pub use constant_folding::folded;
pub use error::ExactError;
pub use expr::{Binary, Expr, Function, Node};
pub use polynomial::Polynomial;
#[cfg(feature = "book")]
pub(crate) use proof::NORMAL;
pub use proof::{Obstacle, Proof, Prover, Step};
pub use rational::Rational;
pub use ring::Ring;
pub use series::Series;
