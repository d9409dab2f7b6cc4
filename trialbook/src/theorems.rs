//! Theorems that a proof assistant's kernel has accepted, and the record of them.
//!
//! `eq_13` speaks of the whole of the claim `eq-13`; `eq_13__printed` and the like of a part, or of what is
//! wrong with it; `eq_13__occurs` shows that the hypotheses of `eq_13` can be met.

pub mod formulas;
pub mod prose;
pub mod record;
pub mod source;
pub mod term;

use crate::data::{Folder, Text};
use crate::trials::formulas::Formulas;
use record::Accepted;
use source::{Item, Sources};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::OnceLock;

/// The file that is written from the formulas.
pub const FORMULAS: &str = "Formulas.v";

/// A paper's theorems.
#[derive(Debug)]
pub struct Theorems {
    /// The files.
    pub files: Folder,
    /// The record of what was accepted.
    pub record: Text,
    known: OnceLock<Known>,
}

/// What is known of the theorems.
#[derive(Debug)]
pub struct Known {
    /// What the files say, with the formulas as they are now.
    pub sources: Sources,
    /// The record.
    pub record: Vec<Accepted>,
    /// The claims that try the formulas, by definition, and whether these are printed.
    pub formulas: BTreeMap<String, (String, bool)>,
    /// What is wrong with it.
    pub fault: Option<String>,
    /// Still what was accepted; found when first asked for.
    current: OnceLock<BTreeSet<String>>,
}

impl Theorems {
    /// Those of files, with the record of them.
    pub const fn new(files: Folder, record: Text) -> Self {
        Self {
            files,
            record,
            known: OnceLock::new(),
        }
    }

    /// What is known of them; read when it is first asked for.
    pub fn known(&self, of: &Formulas) -> &Known {
        self.known.get_or_init(|| {
            let trees = (of.trees)();
            let own = formulas::definitions(&trees, of.corrections);
            let formulas = formulas::tried(&trees, of);
            let files = self.files.texts(".v");
            let texts = files.iter().map(|(path, text)| match path.as_str() {
                FORMULAS => (FORMULAS, own.as_str()),
                path => (path, text.as_str()),
            });
            let sources = Sources::read(texts);
            let (record, fault) = match record::read(&self.record) {
                Ok(record) => (record, None),
                Err(fault) => (Vec::new(), Some(fault)),
            };
            Known {
                sources,
                record,
                formulas,
                fault,
                current: OnceLock::new(),
            }
        })
    }
}

/// The theorem that says the whole of a claim: `eq_13` of `eq-13`.
pub fn named(claim: &str) -> String {
    claim.replace('-', "_")
}

impl Known {
    /// What was accepted of a claim and is still what files and formulas say: the theorem of the whole first.
    pub fn of_claim(&self, claim: &str) -> Vec<(&Accepted, &Item)> {
        let name = named(claim);
        let own = |accepted: &&Accepted| accepted.name.split("__").next() == Some(&name);
        let mut all: Vec<_> = self
            .record
            .iter()
            .filter(own)
            .filter_map(|accepted| self.current(accepted))
            .collect();
        all.sort_by_key(|(accepted, _)| accepted.name != name);
        all
    }

    /// Whether a theorem restricts or refutes the claim as printed.
    pub fn refutes(&self, claim: &str) -> bool {
        self.accepts(&format!("{}__printed", named(claim)))
    }

    /// The same of those that belong to none of these claims.
    pub fn beside<'a>(&self, claims: impl Iterator<Item = &'a str>) -> Vec<(&Accepted, &Item)> {
        let claims: BTreeSet<String> = claims.map(named).collect();
        let none = |accepted: &&Accepted| {
            let mut parts = accepted.name.split("__");
            parts.next().is_some_and(|name| !claims.contains(name))
        };
        let all = self.record.iter().filter(none);
        all.filter_map(|accepted| self.current(accepted)).collect()
    }

    fn current<'a>(&'a self, accepted: &'a Accepted) -> Option<(&'a Accepted, &'a Item)> {
        let current = self.current.get_or_init(|| {
            let same = |accepted: &&Accepted| {
                let item = self.sources.proved(&accepted.name);
                item.is_some_and(|item| self.sources.mark(item) == accepted.mark)
            };
            let record = self.record.iter().filter(same);
            record.map(|accepted| accepted.name.clone()).collect()
        });
        let item = self.sources.proved(&accepted.name)?;
        current.contains(&accepted.name).then_some((accepted, item))
    }

    /// Whether the whole of a claim is a theorem.
    pub(crate) fn is_proved(&self, claim: &str) -> bool {
        self.accepts(&named(claim))
    }

    fn accepts(&self, name: &str) -> bool {
        let mut named = self.record.iter().filter(|accepted| accepted.name == name);
        named.any(|accepted| self.current(accepted).is_some())
    }

    /// The theorems for the record: those of these claims, and those that chapters bring beside them.
    pub fn wanted<'a>(&self, claims: impl Iterator<Item = &'a str>) -> Vec<&Item> {
        let claims: BTreeSet<String> = claims.map(named).collect();
        let wanted = |item: &&Item| {
            let mut parts = item.name.split("__");
            let of_claim = parts.next().is_some_and(|name| claims.contains(name));
            let beside = item.word == "Theorem" && !item.file.contains('/');
            item.is_proved() && (of_claim || beside) && !item.name.ends_with("__occurs")
        };
        self.sources.items.iter().filter(wanted).collect()
    }
}
