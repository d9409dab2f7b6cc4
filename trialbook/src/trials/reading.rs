//! Whether evidence has read what it is about: a formula of its own claim, as printed or as corrected.

use super::formulas::Formulas;
use crate::evidence::{Evidence, Subject};

impl Formulas {
    /// True if the claim of this id has formulas of the kind that the evidence is about, and none of them was read for it.
    pub fn is_missing(&self, id: &str, evidence: &Evidence) -> bool {
        // What a condition excepts is a set of motions, whatever the formula says of it; a remark is about something else.
        if matches!(evidence.subject, Subject::Excepted | Subject::Remark) {
            return false;
        }
        let printed = evidence.subject != Subject::Corrected;
        let mut own = (self.numbers)();
        own.retain(|f| self.is_printed(f.path) == printed && f.claim().as_deref() == Some(id));
        !own.is_empty() && !own.iter().any(|f| evidence.read.contains(f.path))
    }
}
