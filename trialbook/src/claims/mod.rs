//! What a claim is, and how it is tried.
//!
//! A claim is data; a trial is a function that returns [`Evidence`](crate::evidence::Evidence), or a statement that is
//! proved. Whether a claim holds is not said here: the [ledger](crate::ledger) judges.

#[cfg(feature = "trials")]
pub mod attempt;
#[cfg(feature = "trials")]
pub mod by_hand;
#[cfg(feature = "trials")]
pub mod compare;
#[cfg(feature = "trials")]
pub mod enclosed;
#[cfg(feature = "trials")]
pub mod excepted;
#[cfg(feature = "trials")]
pub mod formulas;
#[cfg(feature = "trials")]
pub mod measured;
#[cfg(feature = "trials")]
pub mod points;
#[cfg(feature = "trials")]
pub mod reading;
#[cfg(feature = "trials")]
pub mod runs;
#[cfg(feature = "trials")]
pub mod statement;
#[cfg(feature = "trials")]
pub mod tolerances;
#[cfg(feature = "trials")]
pub mod values;
#[cfg(feature = "trials")]
pub mod variants;

use crate::evidence::{Change, Kind};
#[cfg(feature = "trials")]
use {
    attempt::Attempt,
    by_hand::ByHand,
    formulas::Formulas,
    measured::Measured,
    values::Value,
    variants::{Spared, Survivor, Unread},
};

/// Of which commit a record is, by its head `# As of commit …, date: columns`; empty for another head.
pub fn as_of(record: &str) -> &str {
    let head = record
        .lines()
        .next()
        .and_then(|line| line.strip_prefix("# "));
    head.and_then(|head| head.split_once(": "))
        .map_or("", |(as_of, _)| as_of)
}

/// A condition under which a claim is tried, or what else has to be known beside it: how it is read, what we remark.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
pub struct Condition {
    /// The condition, as LaTeX inside `$…$` and plain words.
    pub text: &'static str,
    /// Who says it, and what it excepts.
    pub sort: Sort,
}

/// What sort of condition it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Sort {
    /// The paper states it.
    Stated,
    /// The paper does not; it excepts degenerate points: a set with empty interior, or one on which the claim has no value. A
    /// trial on [`Subject::Excepted`](crate::evidence::Subject::Excepted) has to find that.
    Degenerate,
    /// The paper takes it for granted throughout, so that the book states it once; it excepts degenerate points, as a trial on
    /// [`Subject::Excepted`](crate::evidence::Subject::Excepted) has to find. A claim that needs nothing else is confirmed.
    Convention,
    /// The paper does not, and what it excepts has an inside.
    Substance,
    /// How we read words that can be read in more than one way. It is no condition, and has no effect on the verdict.
    Reading,
    /// What we add beside the claim. It is no condition either; a trial on
    /// [`Subject::Remark`](crate::evidence::Subject::Remark) has to find it so.
    Remark,
}

impl Sort {
    /// Who says so, in words.
    pub fn words(self) -> &'static str {
        match self {
            Sort::Stated => "stated in the paper",
            Sort::Degenerate => "not stated in the paper; it excepts degenerate points only",
            Sort::Convention => "a convention for the whole paper",
            Sort::Substance => "not stated in the paper",
            Sort::Reading => "our reading",
            Sort::Remark => "our remark",
        }
    }

    /// True if the claim needs it, and the paper does not state it with the claim.
    pub fn is_added(self) -> bool {
        self.is_degenerate() || self == Sort::Substance
    }

    /// True if it is needed, and excepts degenerate points only.
    pub fn is_degenerate(self) -> bool {
        matches!(self, Sort::Degenerate | Sort::Convention)
    }
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
    /// What no program checks of its proof, in words: why what is checked is enough. Empty where that is the whole statement,
    /// and where the proof itself says it between its steps.
    pub argument: &'static str,
    /// How it is tried.
    #[cfg(feature = "trials")]
    pub trials: &'static [Attempt],
}

impl Claim {
    /// What a row need not say: a property without a number, no conditions, no correction, no trials.
    #[cfg(feature = "trials")]
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
        argument: "",
        trials: &[],
    };

    /// A numbered equation, by its id, its section, its title and the formula as printed. The number is that of the id.
    ///
    /// ```
    /// use trialbook::claims::Claim;
    ///
    /// const DRAG: Claim = Claim::equation("eq-6", "1", "drag", "F=kv");
    /// assert_eq!((DRAG.equation, DRAG.trials.len()), (Some(6), 0));
    /// ```
    #[cfg(feature = "trials")]
    pub const fn equation(
        id: &'static str,
        section: &'static str,
        title: &'static str,
        latex: &'static str,
    ) -> Self {
        Claim {
            id,
            section,
            equation: number_of(id),
            kind: Kind::Equation,
            title,
            latex,
            plain: latex,
            ..Self::BLANK
        }
    }

    /// The same, tried so.
    #[cfg(feature = "trials")]
    pub const fn tried(self, trials: &'static [Attempt]) -> Self {
        Claim { trials, ..self }
    }

    /// The same, with what is right in its place; the formula serves as plain text too.
    #[cfg(feature = "trials")]
    pub const fn corrected(self, change: Change, latex: &'static str) -> Self {
        let plain = latex;
        let correction = Some(Correction {
            change,
            latex,
            plain,
        });
        Claim { correction, ..self }
    }

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

/// The number of an equation in its id.
#[cfg(feature = "trials")]
const fn number_of(id: &str) -> Option<u16> {
    let Some((head, digits)) = id.as_bytes().split_at_checked("eq-".len()) else {
        return None;
    };
    if !matches!(head, b"eq-") {
        return None;
    }
    match str::from_utf8(digits) {
        Ok(digits) => match u16::from_str_radix(digits, 10) {
            Ok(number) => Some(number),
            Err(_) => None,
        },
        Err(_) => None,
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

impl Topic {
    /// A topic by its stem, its title and its claims.
    pub const fn new(stem: &'static str, title: &'static str, claims: &'static [Claim]) -> Self {
        Self {
            stem,
            title,
            claims,
        }
    }
}

/// A paper: what it claims, and all that belongs to its claims.
#[derive(Debug)]
pub struct Paper {
    /// Its title.
    pub title: &'static str,
    /// Its authors.
    pub authors: &'static str,
    /// Where it can be found: a journal's reference or a number of an archive.
    pub reference: &'static str,
    /// A letter to its authors or its journal, as [`Ledger::letter`](crate::ledger::Ledger::letter) reads it; empty for none.
    pub letter: &'static str,
    /// Its claims, by topics in its own order.
    pub topics: &'static [Topic],
    /// The recorded verdicts: a line `id: verdict` for each claim.
    pub record: &'static str,
    /// How many wrong variants are rejected, as recorded: a line `id: n of m` for each claim with a formula.
    pub tallies: &'static str,
    /// The record of a deep run; empty if none was made.
    #[cfg(feature = "trials")]
    pub deep: &'static str,
    /// The record of a check of its certificates by another engine; empty if there was none.
    #[cfg(feature = "trials")]
    pub certified: &'static str,
    /// Its formulas.
    #[cfg(feature = "trials")]
    pub formulas: Formulas,
    /// Why claims fail, with cases to check by hand.
    #[cfg(feature = "trials")]
    pub cases: &'static [ByHand],
    /// The numbers by which claims can be found.
    #[cfg(feature = "trials")]
    pub values: &'static [Value],
    /// Why claims have no proof.
    #[cfg(feature = "trials")]
    pub measured: &'static [Measured],
    /// The wrong variants that no trial rejects.
    #[cfg(feature = "trials")]
    pub survivors: &'static [Survivor],
    /// The mistakes in a corner that no measurement notices.
    #[cfg(feature = "trials")]
    pub cornered: &'static [Survivor],
    /// The formulas with mistakes in a corner that no measurement reads.
    #[cfg(feature = "trials")]
    pub unread: &'static [Unread],
    /// The formulas of which a proof does not reject every wrong variant.
    #[cfg(feature = "trials")]
    pub spared: &'static [Spared],
}

impl Paper {
    /// What a paper need not have: all but its title, its topics and its record.
    #[cfg(feature = "trials")]
    pub const BLANK: Paper = Paper {
        title: "",
        authors: "",
        reference: "",
        letter: "",
        topics: &[],
        record: "",
        tallies: "",
        deep: "",
        certified: "",
        formulas: Formulas::NONE,
        cases: &[],
        values: &[],
        measured: &[],
        survivors: &[],
        cornered: &[],
        unread: &[],
        spared: &[],
    };

    /// All claims with their topics, in the order of the topics.
    pub fn claims(&self) -> impl Iterator<Item = (&'static Topic, &'static Claim)> + use<> {
        let of = |topic: &'static Topic| topic.claims.iter().map(move |claim| (topic, claim));
        self.topics.iter().flat_map(of)
    }

    /// The claim of this id, with its topic.
    pub fn find(&self, id: &str) -> Option<(&'static Topic, &'static Claim)> {
        self.claims().find(|(_, claim)| claim.id == id)
    }

    /// The case by hand of the claim of this id, if it has one.
    #[cfg(feature = "trials")]
    pub fn case(&self, id: &str) -> Option<&'static ByHand> {
        self.cases.iter().find(|case| case.claim == id)
    }

    /// The number of this short name.
    #[cfg(feature = "trials")]
    pub fn value(&self, id: &str) -> Option<&'static Value> {
        self.values.iter().find(|value| value.id == id)
    }
}

#[cfg(all(test, feature = "trials"))]
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
