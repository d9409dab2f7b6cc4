//! What a claim is, and how it is tried.
//!
//! A claim is data; a trial is a function that returns [`Evidence`](crate::evidence::Evidence), or a statement that is
//! proved. Whether a claim holds is not said here: the [ledger](crate::ledger) judges.

#[cfg(feature = "book")]
pub mod attempt;
#[cfg(feature = "book")]
pub mod by_hand;
#[cfg(feature = "book")]
pub mod compare;
#[cfg(feature = "book")]
pub mod conditioned;
#[cfg(feature = "book")]
pub mod enclosed;
#[cfg(feature = "book")]
pub mod formulas;
#[cfg(feature = "book")]
pub mod measured;
mod paper;
#[cfg(feature = "book")]
pub mod points;
#[cfg(feature = "book")]
pub mod reading;
#[cfg(feature = "book")]
pub mod runs;
#[cfg(feature = "book")]
pub mod statement;
#[cfg(feature = "book")]
pub mod tolerances;
#[cfg(feature = "book")]
pub mod values;
#[cfg(feature = "book")]
pub mod variants;

pub use paper::Paper;

use crate::evidence::{Change, Kind};
#[cfg(feature = "book")]
use attempt::Attempt;

/// A condition under which a claim is tried.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
pub struct Condition {
    /// The condition, as LaTeX inside `$…$` and plain words.
    pub text: &'static str,
    /// True if the paper states it, false if we had to add it.
    pub stated: bool,
}

/// What replaces a claim that fails.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
pub struct Correction {
    /// How much it changes.
    pub change: Change,
    /// What is right, in LaTeX.
    pub latex: &'static str,
    /// What is right, in plain text.
    pub plain: &'static str,
}

/// One claim of the paper.
#[derive(Debug, Clone, Copy)]
pub struct Claim {
    /// Permanent id: `eq-13`, `s22-no-rest-below`, `fig-3`.
    pub id: &'static str,
    /// Section of the paper: `2.1`.
    pub section: &'static str,
    /// Number of the equation, for a numbered one.
    pub equation: Option<u16>,
    /// What sort of statement it is.
    pub kind: Kind,
    /// What it is about, in a few words.
    pub title: &'static str,
    /// The statement in LaTeX: the formula as printed, or our words with the formulas in `$…$`.
    pub latex: &'static str,
    /// The statement in plain text, for terminals and snapshots.
    pub plain: &'static str,
    /// The conditions under which it is stated or has to be read.
    pub conditions: &'static [Condition],
    /// Ids of the claims that it is derived from or refers to.
    pub depends_on: &'static [&'static str],
    /// What replaces it, where it fails.
    pub correction: Option<Correction>,
    /// How it is tried.
    #[cfg(feature = "book")]
    pub trials: &'static [Attempt],
}

impl Claim {
    /// What a row need not say: a property without a number, no conditions, no correction, no trials.
    #[cfg(feature = "book")]
    pub const BLANK: Claim = Claim {
        id: "",
        section: "",
        equation: None,
        kind: Kind::Property,
        title: "",
        latex: "",
        plain: "",
        conditions: &[],
        depends_on: &[],
        correction: None,
        trials: &[],
    };

    /// What the claim is called for short: `(11)`, `Figure 3`, or its title; formulas in `$…$`.
    pub fn name(&self) -> String {
        match (self.equation, self.kind) {
            (Some(number), _) => format!("({number})"),
            (None, Kind::Figure) => format!("Figure {}", self.id.trim_start_matches("fig-")),
            (None, _) if self.title.is_empty() => self.id.to_owned(),
            (None, _) => self.title.to_owned(),
        }
    }
}

/// A topic: a chapter of the book, and the stem of its files in every room.
#[derive(Debug, Clone, Copy)]
pub struct Topic {
    /// Stem of the files: `constant`.
    pub stem: &'static str,
    /// Title of the chapter.
    pub title: &'static str,
    /// Its claims, in the paper's order.
    pub claims: &'static [Claim],
}

#[cfg(all(test, feature = "book"))]
mod tests {
    use super::*;

    #[test]
    fn a_claim_is_called_by_its_number_its_figure_its_title_or_its_id() {
        let claim = Claim {
            id: "fig-3",
            ..Claim::BLANK
        };
        let title = "Rest";
        let numbered = Some(11);
        for (claim, name) in [
            (claim, "fig-3"),
            (Claim { title, ..claim }, "Rest"),
            (
                Claim {
                    kind: Kind::Figure,
                    title,
                    ..claim
                },
                "Figure 3",
            ),
            (
                Claim {
                    equation: numbered,
                    title,
                    ..claim
                },
                "(11)",
            ),
        ] {
            assert_eq!(claim.name(), name);
        }
    }
}
