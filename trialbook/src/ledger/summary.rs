//! A claim in a line: what is wrong with it, and how that or the contrary is known.

use super::{
    Entry, Standing, Verdict,
    sentences::{count, rounded_up},
};
use crate::evidence::{Outcome, Subject};
use crate::trials::Sort;

impl Entry {
    /// `Misprint: the sign of the second term.`, `Inherits the error of (128): the factor.`, `Needs a
    /// condition: …`; nothing for a claim that stands. Formulas in `$…$`.
    pub fn in_short(&self) -> Option<String> {
        let verdict = self.judgement.verdict;
        let begins = match verdict {
            Verdict::Misprint => "Misprint".to_owned(),
            Verdict::Misderived | Verdict::Refuted => "False".to_owned(),
            Verdict::Inherited => format!("Inherits the error of {}", self.sources()),
            Verdict::Conditional => "Needs a condition".to_owned(),
            _ => return None,
        };
        let wrong = match verdict {
            Verdict::Conditional => self.missing(),
            _ => self.claim.by_hand?.wrong.to_owned(),
        };
        Some(format!("{begins}: {wrong}."))
    }

    pub(super) fn missing(&self) -> String {
        let conditions = self.claim.conditions.iter();
        let missing = conditions.filter(|c| c.sort == Sort::Substance);
        let texts: Vec<_> = missing.map(|c| c.text).collect();
        texts.join("; ")
    }

    /// How it is known: `proved; 1,394 comparisons agree to 2e-13`. Of a claim that fails, how often it fails
    /// comes first.
    pub fn brief(&self) -> String {
        let fails = self.judgement.verdict.is_wrong();
        let measured = |subjects: &'static [Subject], outcome: Outcome| {
            let of = self.measured().filter(|e| subjects.contains(&e.subject));
            of.filter(move |e| e.outcome() == outcome)
        };
        let mut parts = Vec::new();
        let holds: &[Subject] = if fails {
            let against = || measured(&[Subject::Printed], Outcome::Disagrees);
            let failed: usize = against().map(|e| e.failed).sum();
            if failed > 0 {
                let points = count(against().map(|e| e.points).sum());
                let failed = count(failed);
                parts.push(format!("as printed {failed} of {points} comparisons fail"));
            }
            &[Subject::Corrected]
        } else {
            &[Subject::Printed, Subject::Within]
        };
        let agreeing = || measured(holds, Outcome::Agrees);
        let standing = self.standing().filter(|of| *of != Standing::Measured);
        let mut known: Vec<_> = standing
            .map(|of| of.word().to_owned())
            .into_iter()
            .collect();
        let points: usize = agreeing().map(|e| e.points).sum();
        if points > 0 {
            let worst = agreeing().map(|e| e.worst).fold(0.0, f64::max);
            let to = match worst {
                0.0 => String::new(),
                worst => format!(" to {}", rounded_up(worst)),
            };
            let plural = if points == 1 { " agrees" } else { "s agree" };
            known.push(format!("{} comparison{plural}{to}", count(points)));
        }
        if fails && !known.is_empty() {
            parts.push(format!("as corrected: {}", known.join(", ")));
        } else {
            parts.extend(known);
        }
        match parts.is_empty() {
            true => "no trial speaks for the whole of it".to_owned(),
            false => parts.join("; "),
        }
    }

    fn sources(&self) -> String {
        let ids = self.judgement.inherits.iter();
        let names = ids.map(|id| {
            let found = self.paper.find(id);
            let name = found.map_or_else(|| id.clone(), |(_, claim)| claim.name());
            // A title may explain itself behind a colon.
            name.split(':').next().unwrap_or_default().to_owned()
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
