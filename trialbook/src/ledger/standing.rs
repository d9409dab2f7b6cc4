//! How a claim is known: proved, argued or measured.

use super::{Entry, Ledger};
use crate::evidence::{Evidence, Kind};
use serde::Serialize;

/// How what a verdict rests on is known.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Standing {
    /// The whole is a theorem that a proof assistant's kernel has accepted, of the formulas as they are.
    Proved,
    /// The program has checked the steps of a proof; what joins them is said in words.
    Argued,
    /// It was compared at many points, by independent routes.
    Measured,
    /// It says what something is called: there is nothing to prove.
    Defined,
}

impl Standing {
    /// All of them, the strongest first.
    pub const ALL: [Self; 4] = [Self::Proved, Self::Argued, Self::Measured, Self::Defined];

    /// The word.
    pub fn word(self) -> &'static str {
        match self {
            Self::Proved => "proved",
            Self::Argued => "argued",
            Self::Measured => "measured",
            Self::Defined => "defined",
        }
    }
}

impl Evidence {
    /// Whether sentences join the steps of the proof.
    pub(crate) fn is_in_words(&self) -> bool {
        self.route.is_proof() && self.compared.found().is_none()
    }
}

impl Entry {
    /// What is built without trials reads no record of any.
    fn is_theorem(&self) -> bool {
        self.paper.known_theorems().is_proved(self.claim.id)
    }

    /// How what the verdict rests on is known; nothing if undecided.
    pub fn standing(&self) -> Option<Standing> {
        let (claim, whole) = (self.claim, self.whole());
        if whole.is_empty() {
            None
        } else if claim.kind == Kind::Definition {
            Some(Standing::Defined)
        } else if self.is_theorem() {
            Some(Standing::Proved)
        } else if whole
            .iter()
            .any(|e| e.is_in_words() || e.route.is_proof() && !claim.argument.is_empty())
        {
            Some(Standing::Argued)
        } else {
            Some(Standing::Measured)
        }
    }
}

impl Ledger {
    /// How many claims are known in this way.
    pub fn known(&self, by: Standing) -> usize {
        let known = self.entries.iter().filter(|e| e.standing() == Some(by));
        known.count()
    }
}
