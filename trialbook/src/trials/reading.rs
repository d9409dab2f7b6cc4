//! Whether evidence has read a formula of its own claim.

use super::Claim;
use super::formulas::Formulas;
use crate::evidence::{Evidence, Subject};

impl Formulas {
    /// The claim has formulas of the evidence's kind, and none was read for it.
    pub fn is_missing(&self, claim: &Claim, evidence: &Evidence) -> bool {
        // What a condition excepts is a set of motions, whatever the formula says of it; a remark is about something else.
        if matches!(evidence.subject, Subject::Excepted | Subject::Remark) {
            return false;
        }
        let printed = evidence.subject != Subject::Corrected && !claim.ours;
        let mut own = (self.numbers)();
        own.retain(|f| {
            self.is_printed(f.path) == printed && f.claim().as_deref() == Some(claim.id)
        });
        !own.is_empty() && !own.iter().any(|f| evidence.read.contains(f.path))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evidence::{Compared, Route, Tolerance};
    use crate::seeded::Formula;
    use crate::trials::{Topic, read::File};

    #[test]
    fn a_claim_of_ours_has_to_read_its_formula() {
        let formulas = Formulas {
            numbers: || {
                vec![Formula {
                    path: "own::corrections::twice",
                    name: "twice",
                    tried_in: Some("s1-twice"),
                    arguments: &[],
                    lengths: Vec::new(),
                    symbols: Vec::new(),
                    value: |_| vec![2.0],
                }]
            },
            ..Formulas::NONE
        };
        const NONE: Tolerance = Tolerance {
            name: "NONE",
            value: 0.0,
            reason: "",
        };
        let compared = Compared::one("$a$", "$b$");
        let evidence = Evidence::new(Route::Root, Subject::Printed, compared, NONE);
        let file = File::here("[s1-twice]\ntitle = 'a'\nlatex = 'a'");
        let claim = Topic::new("", "", file, &[]).claims()[0];
        let read = Evidence {
            read: ["own::corrections::twice"].into(),
            ..evidence.clone()
        };
        for (ours, evidence, missing) in [
            (false, &evidence, false),
            (true, &evidence, true),
            (true, &read, false),
        ] {
            assert_eq!(
                formulas.is_missing(&Claim { ours, ..claim }, evidence),
                missing
            );
        }
    }
}
