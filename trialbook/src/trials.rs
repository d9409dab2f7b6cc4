//! What a claim is, and how it is tried. Whether it holds, the [ledger](crate::ledger) judges.

pub mod attempt;
pub mod by_hand;
mod change;
pub mod compare;
pub mod enclosed;
pub mod excepted;
pub mod formulas;
pub mod points;
pub mod read;
pub mod reading;
pub mod runs;
pub mod statement;
pub mod tolerances;
pub mod values;
pub mod variants;

use crate::data::Text;
use crate::evidence::{Change, Kind};
use {
    crate::data::Folder,
    crate::seeded::Corner,
    crate::theorems::{Known, Theorems},
    attempt::Attempt,
    by_hand::{ByHand, Numbers},
    formulas::Formulas,
    read::{Fault, File, Read, ReadError, unused},
    std::collections::BTreeSet,
    std::sync::OnceLock,
    values::{Number, Value},
};

/// Of which commit a record is, by its head `# As of commit …, date: columns`; else empty.
pub fn as_of(record: &str) -> &str {
    let head = record
        .lines()
        .next()
        .and_then(|line| line.strip_prefix("# "));
    head.and_then(|head| head.split_once(": "))
        .map_or("", |(as_of, _)| as_of)
}

/// A condition under which a claim is tried, how it is read, or a remark.
#[derive(Debug, Clone, Copy, PartialEq, Eq, serde::Serialize)]
pub struct Condition {
    /// The condition, as LaTeX inside `$…$` and plain words.
    pub text: &'static str,
    /// Who says it, and what it excepts.
    pub sort: Sort,
}

#[derive(
    Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, serde::Serialize, serde::Deserialize,
)]
#[serde(rename_all = "lowercase")]
pub enum Sort {
    /// The paper states it.
    Stated,
    /// The paper does not; it excepts degenerate points: a set with empty interior, or one on which the claim has no value. A
    /// trial on [`Subject::Excepted`](crate::evidence::Subject::Excepted) has to find that.
    Degenerate,
    /// Taken for granted throughout and stated once by the book; excepts degenerate points, as
    /// [`Self::Degenerate`]. A claim that needs nothing else is confirmed.
    Convention,
    /// The paper does not, and what it excepts has an inside.
    Substance,
    /// How we read words that can be read in more than one way: no effect on the verdict.
    Reading,
    /// What we add beside the claim; a trial on [`Subject::Remark`](crate::evidence::Subject::Remark) has to
    /// find it so.
    Remark,
}

impl Sort {
    /// Who says so, in words; `ours` of a claim that the paper does not have.
    pub fn words(self, ours: bool) -> &'static str {
        match self {
            Sort::Stated if ours => "stated with it",
            Sort::Stated => "stated in the paper",
            Sort::Degenerate => "not stated in the paper; it excepts degenerate points only",
            Sort::Convention => "a convention for the whole paper",
            Sort::Substance => "not stated in the paper",
            Sort::Reading => "our reading",
            Sort::Remark => "our remark",
        }
    }

    /// The claim needs it, and the paper does not state it with the claim.
    pub(crate) fn is_added(self) -> bool {
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
    /// As [`Claim::reads`], of what is right.
    #[serde(skip)]
    pub reads: &'static [&'static str],
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
    /// A consequence of our own, which is not printed; its formulas stand with the corrections.
    pub ours: bool,
    /// Ids of earlier books whose addresses lead here.
    pub was: &'static [&'static str],
    /// Words and phrases by which the search finds it too, with `; ` between them.
    pub aliases: &'static str,
    /// What it is about, in a few words.
    pub title: &'static str,
    /// The statement in LaTeX: the formula as printed, or our words with the formulas in `$…$`.
    pub latex: &'static str,
    /// The statement in plain text, for terminals and snapshots.
    pub plain: &'static str,
    /// Which part of the statement is which formula of the code.
    pub reads: &'static [&'static str],
    /// The conditions under which it is stated or has to be read.
    pub conditions: &'static [Condition],
    /// Ids of the claims that it is derived from or refers to.
    pub depends_on: &'static [&'static str],
    /// What replaces it, where it fails.
    pub correction: Option<Correction>,
    /// Why what its trials prove is enough; empty where the proof itself says it.
    pub argument: &'static str,
    /// How it is tried.
    pub trials: &'static [Attempt],
    /// What is missing, where no theorem says the whole of it.
    pub unproved: Option<&'static str>,
    /// Why it fails, with a case to check by hand.
    pub by_hand: Option<ByHand>,
    /// Where one sees it fail: the address of an explorer, such as `rest.html#explore-rest?rho=0.5`, and what
    /// one watches there.
    pub watch: Option<[&'static str; 2]>,
    /// The numbers by which it can be found.
    pub values: &'static [Value],
    /// The wrong variants of its formulas that no trial rejects, by their text.
    pub survivors: &'static [Excuse],
    /// The values of symbols for which it is stated, where those are not all.
    pub domain: &'static [Corner],
    /// The mistakes in a corner that no measurement notices, by their text.
    pub cornered: &'static [Excuse],
    /// Its formulas that no agreeing measurement reads.
    pub unread: &'static [Excuse],
}

/// What need not be noticed, and why not.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Excuse {
    /// The formula by its name, or the mistake by its text.
    pub of: &'static str,
    /// The reason.
    pub why: &'static str,
}

impl Claim {
    /// What sort of statement it is, in a word; of one of our own, that too.
    pub(crate) fn kind_name(&self) -> String {
        let own = if self.ours { ", derived here" } else { "" };
        self.kind.name().to_owned() + own
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

/// A topic: a chapter of the book, and the stem of its files.
#[derive(Debug)]
pub struct Topic {
    /// Stem of the files: `constant`.
    pub stem: &'static str,
    /// Title of the chapter.
    pub title: &'static str,
    /// The file of its claims.
    pub file: File,
    shared: Option<File>,
    trials: &'static [&'static [Attempt]],
    cases: &'static [Numbers],
    numbers: &'static [Number],
    read: OnceLock<Read>,
}

impl Topic {
    /// A topic by stem, title, claims and the lists of trials that they name.
    pub const fn new(
        stem: &'static str,
        title: &'static str,
        file: File,
        trials: &'static [&'static [Attempt]],
    ) -> Self {
        Self {
            stem,
            title,
            file,
            shared: None,
            trials,
            cases: &[],
            numbers: &[],
            read: OnceLock::new(),
        }
    }

    /// The same, with conditions and reasons from a file that others use too.
    pub const fn sharing(mut self, file: File) -> Self {
        self.shared = Some(file);
        self
    }

    /// The same, with the numbers of its cases by hand.
    pub const fn by_hand(mut self, cases: &'static [Numbers]) -> Self {
        self.cases = cases;
        self
    }

    /// The same, with the numbers by which its claims can be found.
    pub const fn numbers(mut self, numbers: &'static [Number]) -> Self {
        self.numbers = numbers;
        self
    }

    /// Its claims, in the paper's order; read when first asked for.
    ///
    /// # Panics
    /// If something is wrong in its file: [`Paper::check`] says what.
    pub fn claims(&self) -> &'static [Claim] {
        let Read { claims, faults, .. } = self.read();
        assert!(faults.is_empty(), "{}", listed(faults));
        claims
    }

    #[cfg(feature = "book")]
    pub(crate) fn lines(&self) -> impl Iterator<Item = (usize, &'static Claim)> {
        let ids = self.read().ids.iter();
        ids.filter_map(|(line, id)| Some((*line, self.claims().iter().find(|c| c.id == *id)?)))
    }

    fn attempts(&self) -> impl Iterator<Item = &'static Attempt> + use<> {
        self.trials.iter().copied().flatten()
    }

    fn read(&self) -> &Read {
        self.read.get_or_init(|| Read::of(self))
    }
}

pub(crate) fn listed(faults: &[ReadError]) -> String {
    let lines: Vec<_> = faults.iter().map(ReadError::to_string).collect();
    lines.join("\n")
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
    /// A letter to its authors or its journal, as `Ledger::letter` reads it; empty for none.
    pub letter: Text,
    /// Its claims, by topics in its own order.
    pub topics: &'static [&'static Topic],
    /// The recorded verdicts: a line `id: verdict` for each claim.
    pub record: Text,
    /// The recorded sheets, `<topic>/<id>.snap` as `Entry::snapshot` writes them; may be none.
    pub sheets: Folder,
    /// A test puts every wrong variant to the trials; no other passes than the claims' survivors.
    pub tries_variants: bool,
    /// The record of a deep run; empty if none was made.
    pub deep: Text,
    /// Its theorems before a proof assistant's kernel.
    pub theorems: &'static Theorems,
    /// Its formulas.
    pub formulas: Formulas,
}

const NONE: Text = Text::Built("");
static NO_THEOREMS: Theorems = Theorems::new(Folder::None, NONE);

impl Paper {
    /// What is known of its theorems.
    pub fn known_theorems(&self) -> &Known {
        self.theorems.known(&self.formulas)
    }

    /// The ids of its claims, in order.
    pub fn claim_ids(&self) -> impl Iterator<Item = &'static str> {
        self.claims().map(|(_, claim)| claim.id)
    }

    /// All but its title, its topics and its record may be blank.
    pub const BLANK: Paper = Paper {
        title: "",
        authors: "",
        reference: "",
        letter: NONE,
        topics: &[],
        record: NONE,
        sheets: Folder::None,
        tries_variants: false,
        deep: NONE,
        theorems: &NO_THEOREMS,
        formulas: Formulas::NONE,
    };

    /// All claims with their topics, in the order of the topics.
    pub fn claims(&self) -> impl Iterator<Item = (&'static Topic, &'static Claim)> + use<> {
        let of = |topic: &&'static Topic| {
            let topic = *topic;
            topic.claims().iter().map(move |claim| (topic, claim))
        };
        self.topics.iter().flat_map(of)
    }

    #[cfg(feature = "book")]
    pub(crate) fn ids(&self) -> Option<BTreeSet<&'static str>> {
        let reads = || self.topics.iter().map(|topic| topic.read());
        let whole = reads().all(|read| !read.broken);
        whole.then(|| {
            reads()
                .flat_map(|read| read.ids.iter().map(|(_, id)| *id))
                .collect()
        })
    }

    /// The claim of this id, with its topic.
    pub fn find(&self, id: &str) -> Option<(&'static Topic, &'static Claim)> {
        self.claims().find(|(_, claim)| claim.id == id)
    }

    /// The numbers by which its claims can be found.
    pub fn values(&self) -> impl Iterator<Item = &'static Value> + use<> {
        self.claims().flat_map(|(_, claim)| claim.values)
    }

    /// The number of this short name.
    pub fn value(&self, id: &str) -> Option<&'static Value> {
        self.values().find(|value| value.id == id)
    }

    /// The cases by hand, with their claims.
    pub fn cases(&self) -> impl Iterator<Item = (&'static Claim, &'static ByHand)> + use<> {
        self.claims()
            .filter_map(|(_, claim)| Some((claim, claim.by_hand.as_ref()?)))
    }

    /// The reasons why claims have no proof, each with its claims.
    pub fn unproved(&self) -> Vec<(&'static str, Vec<&'static Claim>)> {
        let mut reasons: Vec<(&str, Vec<_>)> = Vec::new();
        for (claim, why) in self
            .claims()
            .filter_map(|(_, claim)| Some((claim, claim.unproved?)))
        {
            match reasons.iter_mut().find(|(known, _)| *known == why) {
                Some((_, claims)) => claims.push(claim),
                None => reasons.push((why, vec![claim])),
            }
        }
        reasons
    }

    /// What is wrong in the files of its claims: what cannot be read, or is named and not there, or there and
    /// not named.
    pub fn check(&self) -> Vec<ReadError> {
        let reads = self.topics.iter().map(|topic| (&topic.file, topic.read()));
        let reads: Vec<_> = reads.collect();
        let all = reads
            .iter()
            .flat_map(|(_, read)| read.faults.iter().cloned());
        let mut faults: Vec<_> = all.collect();
        let all: BTreeSet<_> = reads
            .iter()
            .flat_map(|(_, read)| read.ids.iter().map(|(_, id)| id))
            .collect();
        let mut ids = BTreeSet::new();
        let lists: [fn(&Read) -> &[_]; 2] = [|read| &read.ids, |read| &read.was];
        for list in lists {
            for (file, read) in &reads {
                let twice = list(read).iter().filter(|(_, id)| !ids.insert(*id));
                faults
                    .extend(twice.map(|(line, id)| file.error(*line, Fault::Twice((*id).into()))));
            }
        }
        // In a file that is broken there may be more.
        if !reads.iter().any(|(_, read)| read.broken) {
            for (file, read) in &reads {
                let nobody = read.from.iter().filter(|(_, id)| !all.contains(id));
                let unknown =
                    |(line, id): &(usize, &str)| file.error(*line, Fault::unknown("claim", id));
                faults.extend(nobody.map(unknown));
            }
        }
        if faults.is_empty() {
            let used = reads.iter().flat_map(|(_, read)| &read.used).collect();
            let shared = self.topics.iter().filter_map(|topic| topic.shared);
            faults.extend(shared.flat_map(|file| unused(&file, &used)));
        }
        faults.sort_by(|a, b| (&a.file, a.line).cmp(&(&b.file, b.line)));
        faults.dedup();
        faults
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_claim_is_called_by_its_number_its_figure_its_title_or_its_id() {
        let file = File::here(
            "[fig-3]\ntitle = 'Rest'\nlatex = 'a'\n[eq-11]\ntitle = 'Rest'\nlatex = 'a'",
        );
        let [figure, equation] = Topic::new("", "", file, &[]).claims() else {
            panic!("two claims")
        };
        let words = Claim {
            kind: Kind::Property,
            ..*figure
        };
        for (claim, name) in [
            (Claim { title: "", ..words }, "fig-3"),
            (words, "Rest"),
            (*figure, "Figure 3"),
            (*equation, "(11)"),
        ] {
            assert_eq!(claim.name(), name);
        }
    }
}
