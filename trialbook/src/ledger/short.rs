//! What is wrong with a claim, in the sentence that begins its verdict.

use super::{Entry, Verdict};
use crate::claims::Sort;

impl Entry {
    /// `Misprint: the sign of the second term.`, `Follows from a false (128): the factor.`, `Needs a condition: …`; nothing
    /// for a claim that stands. The verdict is computed; the words behind the colon are data. Formulas in `$…$`.
    pub fn in_short(&self) -> Option<String> {
        let verdict = self.judgement.verdict;
        let begins = match verdict {
            Verdict::Misprint => "Misprint".to_owned(),
            Verdict::Misderived | Verdict::Refuted => "False".to_owned(),
            Verdict::Inherited => format!("Follows from a false {}", self.sources()),
            Verdict::Conditional => "Needs a condition".to_owned(),
            _ => return None,
        };
        let conditions = || {
            let conditions = self.claim.conditions.iter();
            let missing = conditions.filter(|c| c.sort == Sort::Substance);
            let texts: Vec<_> = missing.map(|c| c.text).collect();
            texts.join("; ")
        };
        let wrong = match verdict {
            Verdict::Conditional => conditions(),
            _ => self.paper.case(self.claim.id)?.wrong.to_owned(),
        };
        Some(format!("{begins}: {wrong}."))
    }

    /// What the wrong claims are called from which its error comes.
    fn sources(&self) -> String {
        let ids = self.judgement.inherits.iter();
        let names = ids.map(|id| {
            let mut claims = self.paper.claims();
            let found = claims.find(|(_, claim)| claim.id == id);
            found.map_or_else(|| id.clone(), |(_, claim)| claim.name())
        });
        let names: Vec<_> = names.collect();
        match names.split_last() {
            Some((last, others)) if !others.is_empty() => {
                format!("{} and {last}", others.join(", "))
            }
            _ => names.concat(),
        }
    }
}
