//! Printed formulas, in LaTeX, as syntax trees. A text is split into [`Statement`]s, these into [`Side`]s,
//! read with a [`Lexicon`] of names; a [`Value`] is a tree, or three for a vector. What is not understood is
//! an error that says where.
//!
//! ```
//! use trialbook::exact::Expr;
//! use trialbook::exact::latex::{Lexicon, Value, statements};
//!
//! let mut lexicon = Lexicon::new();
//! lexicon.add(r"\lambda_0", Value::Number(Expr::symbol("λ₀")))?;
//! let [printed] = &statements(r"-\pi\lambda_0+2\sqrt{1-\lambda_0^2}<0")?[..] else { panic!() };
//! let left = printed.sides[0].read(&lexicon)?;
//! assert_eq!(left.number().unwrap().to_string(), "−π λ₀ + 2 √(1 − λ₀^2)");
//! # Ok::<(), trialbook::exact::latex::LatexError>(())
//! ```
//!
//! How the paper's LaTeX is read where LaTeX leaves it open:
//!
//! - A subscript belongs to the name. What follows a name in parentheses is a factor, unless the lexicon knows both as one.
//! - A function without parentheses applies to the next name, number or fraction alone, and only if no further factor
//!   could belong to it: sin ϖt is not understood, sin(ϖt) is.
//! - A product without a sign and × bind more tightly than ·, so that ẑ·𝛒×𝐯 is ẑ·(𝛒×𝐯). After /, one factor follows.
//! - sin^{-1} and cos^{-1} are inverse functions, any other exponent of a function raises its value.
//! - What a formula leaves out, + ⋯, + o(…) or + O(…), counts nothing.

mod list;
mod read;
mod statement;
#[cfg(test)]
mod tests;

pub use list::Relation;
pub use read::{Lexicon, Value};
pub use statement::{Piece, Side, Statement, statements};

/// Why a text is not understood, and where.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("at character {at}: {problem}")]
pub struct LatexError {
    /// The character's number, from 0.
    pub at: usize,
    /// What is wrong there.
    pub problem: Problem,
}

/// What is not understood.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Problem {
    /// A command or character without a meaning here.
    #[error("{0} has no meaning here")]
    Unknown(String),
    /// A bracket that does not match another.
    #[error("a bracket that is not opened or not closed")]
    Bracket,
    /// More nested parts than a formula has.
    #[error("too many parts within each other")]
    TooDeep,
    /// A number with more digits than fit.
    #[error("the number is too long")]
    TooLong,
    /// An operand that is missing.
    #[error("something is missing")]
    Missing,
    /// A name that the lexicon does not have.
    #[error("the lexicon has no {0}")]
    Name(String),
    /// Something that could be read in more than one way.
    #[error("this can be read in more than one way")]
    Ambiguous,
    /// A vector for a number, or a number for a vector.
    #[error("a vector where a number belongs, or the reverse")]
    Kind,
}

impl Problem {
    fn at(self, at: usize) -> LatexError {
        LatexError { at, problem: self }
    }
}
