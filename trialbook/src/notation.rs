//! Formulas as LaTeX and as plain text, and the way from each to the other.

#[cfg(feature = "book")]
mod ascii;
#[cfg(feature = "book")]
mod html;
mod latex;
pub(crate) mod letters;
mod numerals;
mod pieces;
mod plain;

#[cfg(feature = "book")]
pub use ascii::ascii;
#[cfg(feature = "book")]
pub use html::{Tag, tags, without_tags};
#[cfg(feature = "book")]
pub(crate) use latex::command;
#[cfg(feature = "book")]
pub use numerals::literals;
#[cfg(feature = "book")]
pub(crate) use numerals::word;
pub use numerals::{Says, number, said};
pub use pieces::{Piece, decimal, pieces};
pub use plain::{plain_formula, plain_words};
