//! The judge: what follows from a claim's evidence.

mod verdict;

pub use verdict::{Judgement, Verdict, in_view_of, judge};
