//! Reads the claims of a topic from its file: TOML, one table for each claim, in the paper's order.
//!
//! ```toml
//! section = "2.1"                         # of all claims that name no other
//! [conditions]                            # those that several claims have, by the name by which they are named
//! late = { stated = '$t\to\infty$' }
//! [reasons]                               # what is said more than once: why something is excused, or argued
//! half = "what is compared is at most half the unit"
//!
//! [eq-18]                                 # the number of an equation is that of its id, and so is a figure's
//! title = "terminal velocity"
//! latex = 'v_x(\infty)=\frac{v_0}{2}'     # as printed; of a claim in words, our words with the formulas in `$…$`
//! conditions = ["late", { degenerate = '$v_0>0$: at rest it is $0/0$' }]
//! domain = { "θ" = [0, 3.14] }            # the values of a symbol for which it is stated, if not for all
//! from = ["eq-17"]                        # what it is derived from or refers to
//! trials = ["limits::eq18_limit", { trial = "exact::EQ18", coarse = { eq18_speed = "half" } }]
//! corrected = 'v_x(\infty)=v_0'           # what is right in its place
//! ```
//!
//! An entry may also have `kind`, `section`, `plain` and `corrected-plain`, where the plain text that is computed reads badly,
//! `argument`, `unproved`, `by-hand`, `values`, `survivors`, `cornered` and `unread`: as [`Claim`] has them. A reason of
//! a single word is a name. Text in `'''…'''` may be broken into lines.

use super::attempt::Attempt;
use super::by_hand::ByHand;
use super::points::mixed;
use super::values::Value;
use super::{Claim, Condition, Correction, Excuse, Sort, Topic};
use crate::data::Text;
use crate::evidence::{Change, Kind};
use crate::notation::{plain_formula, plain_words};
use crate::seeded::Corner;
use serde::Deserialize;
use std::cell::RefCell;
use std::collections::{BTreeMap, BTreeSet};
use std::panic::Location;
use toml::Spanned;
use toml::de::{DeTable, DeValue, ValueDeserializer};

/// A file of claims.
#[derive(Debug, Clone, Copy)]
pub struct File {
    /// Where it is, from the crate's folder.
    pub path: &'static str,
    /// What it says.
    pub text: Text,
    /// How many lines of the file stand above the text.
    pub above: usize,
}

/// A file of claims, by its path from the crate's folder: `claims!("claims/rest.toml")`.
#[macro_export]
macro_rules! claims {
    ($path:literal) => {
        $crate::trials::read::File {
            path: $path,
            text: $crate::data::text!($path),
            above: 0,
        }
    };
}

pub use claims;

impl File {
    /// A text that begins in the line below that in which this is called, as it is formatted.
    #[track_caller]
    pub const fn here(text: &'static str) -> Self {
        let place = Location::caller();
        Self {
            path: place.file(),
            text: Text::Built(text),
            above: place.line() as usize,
        }
    }

    pub(super) fn error(&self, line: usize, fault: Fault) -> ReadError {
        ReadError {
            file: self.path.to_owned(),
            line,
            fault,
        }
    }

    /// What TOML says of the text, where it does not say where, of this place.
    fn form(&self, at: usize, error: &toml::de::Error) -> ReadError {
        let at = error.span().map_or(at, |span| span.start);
        self.error(self.line(at), Fault::Form(error.message().to_owned()))
    }

    /// The line, from 1, of a place in the text.
    fn line(&self, at: usize) -> usize {
        self.above + 1 + {
            let before = &self.text.as_bytes()[..at];
            before.iter().filter(|byte| **byte == b'\n').count()
        }
    }
}

/// What is wrong in a file of claims, or with what it names.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{file}, line {line}: {fault}")]
pub struct ReadError {
    /// The file.
    pub file: String,
    /// The line, from 1.
    pub line: usize,
    /// What is wrong there.
    pub fault: Fault,
}

/// What can be wrong.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum Fault {
    /// It is no TOML, or an entry has a field that no entry has, or lacks one, or has something else in it.
    #[error("{0}")]
    Form(String),
    /// A name that stands for nothing.
    #[error("there is no {what} `{name}`")]
    Unknown {
        /// What it was to name.
        what: &'static str,
        /// The name.
        name: String,
    },
    /// What no claim names.
    #[error("no claim names the {what} `{name}`")]
    Unused {
        /// What it is.
        what: &'static str,
        /// Its name.
        name: String,
    },
    /// A claim that is there already.
    #[error("a second claim `{0}`")]
    Twice(String),
}

impl Fault {
    pub(super) fn unknown(what: &'static str, name: &str) -> Self {
        Self::Unknown {
            what,
            name: name.to_owned(),
        }
    }
}

/// What a file says.
#[derive(Debug)]
pub(crate) struct Read {
    /// The claims.
    pub claims: &'static [Claim],
    /// The ids of all entries, each with its line, also of those that are no claims.
    pub ids: Vec<(usize, &'static str)>,
    /// The claims that they name, each with its line.
    pub from: Vec<(usize, &'static str)>,
    /// The names that they use.
    pub used: Used,
    /// What is wrong.
    pub faults: Vec<ReadError>,
    /// Whether something may be missing of what is named.
    pub broken: bool,
}

/// What several claims have in common.
#[derive(Default)]
struct Common {
    section: &'static str,
    conditions: BTreeMap<Spanned<String>, Said>,
    reasons: BTreeMap<Spanned<String>, String>,
    /// Whether some of it may be missing, as it cannot be read.
    broken: bool,
}

/// A condition by its sort: `{ stated = '…' }`.
type Said = BTreeMap<Sort, String>;

#[derive(Deserialize)]
#[serde(
    untagged,
    expecting = "the name of a condition, or `{ sort = 'text' }`"
)]
enum Given {
    Named(String),
    Said(Said),
}

#[derive(Deserialize)]
#[serde(
    untagged,
    expecting = "the name of a trial, or `{ trial = \"name\", … }`, with `idle`, `elsewhere`, `coarse` or `spared`"
)]
enum Tried {
    Named(String),
    Excused(Excused),
}

#[derive(Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct Excused {
    trial: String,
    idle: Option<String>,
    elsewhere: Option<String>,
    #[serde(default)]
    coarse: BTreeMap<String, String>,
    #[serde(default)]
    spared: BTreeMap<String, String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Shown {
    // Of more than 65,535 places no number can be written.
    decimals: u8,
    meaning: String,
    closed: Option<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Worked {
    wrong: String,
    reason: String,
    case: String,
    digits: u8,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
struct Entry {
    section: Option<String>,
    kind: Option<Kind>,
    title: Spanned<String>,
    latex: Spanned<String>,
    plain: Option<Spanned<String>>,
    #[serde(default)]
    conditions: Vec<Spanned<Given>>,
    #[serde(default)]
    domain: BTreeMap<Spanned<String>, [f64; 2]>,
    #[serde(default)]
    from: Vec<Spanned<String>>,
    corrected: Option<Spanned<String>>,
    corrected_plain: Option<Spanned<String>>,
    argument: Option<Spanned<String>>,
    #[serde(default)]
    trials: Vec<Spanned<Tried>>,
    unproved: Option<Spanned<String>>,
    by_hand: Option<Spanned<Worked>>,
    #[serde(default)]
    values: BTreeMap<Spanned<String>, Shown>,
    #[serde(default)]
    survivors: BTreeMap<String, Spanned<String>>,
    #[serde(default)]
    cornered: BTreeMap<String, Spanned<String>>,
    #[serde(default)]
    unread: BTreeMap<String, Spanned<String>>,
}

/// A text for as long as the program runs, its lines joined.
fn text(text: String) -> &'static str {
    text.trim_end().replace('\n', " ").leak()
}

/// What is wrong with a text, if anything is.
fn slip(text: &str) -> Option<Fault> {
    let what = match text {
        _ if text.trim().is_empty() => "an empty text",
        _ if !text.matches('$').count().is_multiple_of(2) => "a `$` has no partner",
        _ => return None,
    };
    Some(Fault::Form(what.to_owned()))
}

fn value<T: for<'de> Deserialize<'de>>(
    file: &File,
    value: Spanned<DeValue<'_>>,
    faults: &mut Vec<ReadError>,
) -> Option<T> {
    let begin = value.span().start;
    let value = T::deserialize(ValueDeserializer::from(value));
    value
        .map_err(|error| faults.push(file.form(begin, &error)))
        .ok()
}

/// An entry with its id, and with the line in which it begins; nothing where it cannot be read.
type Row = (usize, &'static str, Option<Entry>);

/// What claims have in common, and the entries in their order.
fn entries(file: &File, faults: &mut Vec<ReadError>) -> (Common, Vec<Row>) {
    let read = file.text.read().unwrap_or_else(|error| {
        faults.push(file.error(1, Fault::Form(error.to_string())));
        ""
    });
    let (table, errors) = DeTable::parse_recoverable(read);
    faults.extend(errors.iter().map(|error| file.form(0, error)));
    let mut rows: Vec<_> = table.into_inner().into_iter().collect();
    rows.sort_by_key(|(key, _)| key.span().start);
    let (mut common, mut entries) = (Common::default(), Vec::new());
    common.broken = !errors.is_empty();
    for (key, row) in rows {
        let (line, before) = (file.line(key.span().start), faults.len());
        match &**key.get_ref() {
            "section" => common.section = text(value(file, row, faults).unwrap_or_default()),
            "conditions" => common.conditions = value(file, row, faults).unwrap_or_default(),
            "reasons" => common.reasons = value(file, row, faults).unwrap_or_default(),
            id => {
                entries.push((line, text(id.to_owned()), value(file, row, faults)));
                continue;
            }
        }
        common.broken |= faults.len() > before;
    }
    let each = common.conditions.iter();
    let said = each.flat_map(|(name, said)| said.values().map(move |text| (name, text)));
    let said = said.chain(&common.reasons);
    let slips = said.filter_map(|(name, text)| Some((name.span().start, slip(text)?)));
    faults.extend(slips.map(|(at, slip)| file.error(file.line(at), slip)));
    (common, entries)
}

/// What names were used, each with what it names.
pub(super) type Used = BTreeSet<(&'static str, String)>;

/// What a shared file offers and nobody uses.
pub(super) fn unused(file: &File, used: &BTreeSet<&(&'static str, String)>) -> Vec<ReadError> {
    let (common, _) = entries(file, &mut Vec::new());
    common.unused(file, &|name| used.contains(name))
}

impl Common {
    fn unused(
        &self,
        file: &File,
        used: &dyn Fn(&(&'static str, String)) -> bool,
    ) -> Vec<ReadError> {
        let conditions = self.conditions.keys().map(|name| ("condition", name));
        let all = conditions.chain(self.reasons.keys().map(|name| ("reason", name)));
        let idle = all.filter(|(what, name)| !used(&(what, name.get_ref().clone())));
        let told = idle.map(|(what, name)| {
            let (line, name) = (file.line(name.span().start), name.get_ref().clone());
            file.error(line, Fault::Unused { what, name })
        });
        told.collect()
    }
}

/// What is needed to make sense of the entries of a topic.
struct Reader<'a> {
    topic: &'a Topic,
    common: Common,
    shared: Common,
    used: RefCell<Used>,
    faults: RefCell<Vec<ReadError>>,
}

impl Read {
    pub(super) fn of(topic: &Topic) -> Self {
        let mut faults = Vec::new();
        let (common, entries) = entries(&topic.file, &mut faults);
        let shared = topic.shared.as_ref();
        let shared = shared.map(|file| self::entries(file, &mut faults).0);
        let readable = faults.is_empty();
        let reader = Reader {
            topic,
            common,
            shared: shared.unwrap_or_default(),
            used: RefCell::default(),
            faults: RefCell::new(faults),
        };
        let (mut claims, mut from) = (Vec::new(), Vec::new());
        let ids = entries.iter().map(|(line, id, _)| (*line, *id)).collect();
        for (_, id, entry) in entries {
            let Some(entry) = entry else { continue };
            claims.push(reader.claim(id, entry, &mut from));
        }
        let used = reader.used.take();
        if readable {
            reader.all_used(&used);
        }
        Self {
            claims: claims.leak(),
            ids,
            from,
            used,
            broken: reader.common.broken || reader.shared.broken,
            faults: reader.faults.into_inner(),
        }
    }
}

/// What each of the list stands for, if it does for anything.
fn each<T, U>(list: impl IntoIterator<Item = T>, of: impl FnMut(T) -> Option<U>) -> &'static [U] {
    list.into_iter().filter_map(of).collect::<Vec<_>>().leak()
}

/// The pair of numbers of a case by hand.
const PAIR: &str = "pair of numbers of the case of";

impl Reader<'_> {
    fn fault(&self, at: usize, fault: Fault) {
        let file = &self.topic.file;
        let fault = file.error(file.line(at), fault);
        self.faults.borrow_mut().push(fault);
    }

    /// What a name stands for: what was found under it.
    fn named<T>(&self, at: usize, what: &'static str, name: &str, found: Option<T>) -> Option<T> {
        self.used.borrow_mut().insert((what, name.to_owned()));
        let broken = self.common.broken || self.shared.broken;
        if found.is_none() && !(broken && matches!(what, "condition" | "reason")) {
            self.fault(at, Fault::unknown(what, name));
        }
        found
    }

    /// A text that stands at this place.
    fn text(&self, at: usize, said: String) -> &'static str {
        let said = text(said);
        if let Some(slip) = slip(said) {
            self.fault(at, slip);
        }
        said
    }

    fn spanned(&self, said: Spanned<String>) -> &'static str {
        self.text(said.span().start, said.into_inner())
    }

    /// What is common to the claims of the topic, or of several topics.
    fn common<T>(&self, of: impl Fn(&Common) -> Option<&T>) -> Option<&T> {
        of(&self.common).or_else(|| of(&self.shared))
    }

    fn claim(
        &self,
        id: &'static str,
        entry: Entry,
        from: &mut Vec<(usize, &'static str)>,
    ) -> Claim {
        let file = &self.topic.file;
        let equation = id
            .strip_prefix("eq-")
            .and_then(|number| number.parse().ok());
        let plain = |given: Option<_>, latex: &str| match given {
            Some(given) => self.spanned(given),
            None if equation.is_some() && !latex.contains('$') => plain_formula(latex).leak(),
            None => plain_words(latex).leak(),
        };
        let latex = self.spanned(entry.latex);
        let correction = entry.corrected.map(|right| {
            let right = self.spanned(right);
            Correction {
                change: Change::between(latex, right),
                latex: right,
                plain: plain(entry.corrected_plain, right),
            }
        });
        let usual = match id {
            _ if equation.is_some() => Kind::Equation,
            _ if id.starts_with("fig-") => Kind::Figure,
            _ => Kind::Property,
        };
        Claim {
            id,
            section: entry.section.map_or(self.common.section, text),
            equation,
            kind: entry.kind.unwrap_or(usual),
            title: self.spanned(entry.title),
            latex,
            plain: plain(entry.plain, latex),
            depends_on: each(entry.from, |on| {
                let (line, on) = (file.line(on.span().start), text(on.into_inner()));
                from.push((line, on));
                Some(on)
            }),
            conditions: each(entry.conditions, |given| self.condition(given)),
            domain: each(entry.domain, |(letter, [low, high])| {
                if low.is_nan() || high.is_nan() || low >= high {
                    let told = "a domain is two numbers, the lower one first".to_owned();
                    self.fault(letter.span().start, Fault::Form(told));
                }
                let letter = text(letter.into_inner());
                Some(Corner { letter, low, high })
            }),
            correction,
            argument: entry.argument.map_or("", |why| self.reason(why)),
            trials: each(entry.trials.into_iter().zip(0..), |(tried, nth)| {
                let seat = mixed(id.bytes().map(u64::from).chain([nth]));
                let attempt = self.attempt(tried)?;
                Some(Attempt { seat, ..attempt })
            }),
            unproved: entry.unproved.map(|why| self.reason(why)),
            by_hand: entry.by_hand.and_then(|case| self.by_hand(id, case)),
            values: each(entry.values, |(name, shown)| self.value(id, &name, shown)),
            survivors: self.excuses(entry.survivors),
            cornered: self.excuses(entry.cornered),
            unread: self.excuses(entry.unread),
        }
    }

    fn condition(&self, given: Spanned<Given>) -> Option<Condition> {
        let at = given.span().start;
        let said = match given.into_inner() {
            Given::Said(said) => {
                let slips = said.values().filter_map(|said| slip(said));
                slips.for_each(|slip| self.fault(at, slip));
                said
            }
            Given::Named(name) => {
                let known = self.common(|common| common.conditions.get(&*name));
                self.named(at, "condition", &name, known)?.clone()
            }
        };
        let mut all = said.into_iter();
        match (all.next(), all.next()) {
            (Some((sort, said)), None) => Some(Condition {
                text: text(said),
                sort,
            }),
            _ => self.named(at, "condition with", "none or several sorts", None),
        }
    }

    /// A reason as it stands, or by its name, which is a single word.
    fn reason(&self, why: Spanned<String>) -> &'static str {
        if why.get_ref().trim().contains(' ') {
            return self.spanned(why);
        }
        let (at, why) = (why.span().start, why.into_inner());
        let known = self.common(|common| common.reasons.get(&*why));
        self.named(at, "reason", &why, known)
            .map_or("", |why| text(why.clone()))
    }

    fn excuses(&self, all: BTreeMap<String, Spanned<String>>) -> &'static [Excuse] {
        each(all, |(of, why)| {
            let (of, why) = (text(of), self.reason(why));
            Some(Excuse { of, why })
        })
    }

    fn attempt(&self, tried: Spanned<Tried>) -> Option<Attempt> {
        let at = tried.span();
        let excused = match tried.into_inner() {
            Tried::Named(trial) => Excused {
                trial,
                ..Excused::default()
            },
            Tried::Excused(excused) => excused,
        };
        let name = &excused.trial;
        let listed = self.topic.attempts().find(|attempt| attempt.name() == name);
        let attempt = self.named(at.start, "trial", name, listed)?;
        // Where in the entry a reason stands is not known within a list.
        let here = |why: String| Spanned::new(at.clone(), why);
        let reason = |why: Option<_>| why.map(|why| self.reason(here(why)));
        let excuses = |all: BTreeMap<_, _>| {
            self.excuses(all.into_iter().map(|(of, why)| (of, here(why))).collect())
        };
        Some(Attempt {
            idle: reason(excused.idle),
            elsewhere: reason(excused.elsewhere),
            coarse: excuses(excused.coarse),
            spared: excuses(excused.spared),
            ..*attempt
        })
    }

    fn by_hand(&self, id: &str, case: Spanned<Worked>) -> Option<ByHand> {
        let at = case.span().start;
        let computed = self.topic.cases.iter().find(|numbers| numbers.claim == id);
        let Worked {
            wrong,
            reason,
            case,
            digits,
        } = case.into_inner();
        let [wrong, reason, case] = [wrong, reason, case].map(|said| self.text(at, said));
        Some(ByHand {
            wrong,
            reason,
            case,
            digits: digits.into(),
            computed: *self.named(at, PAIR, id, computed)?,
        })
    }

    fn value(&self, id: &'static str, name: &Spanned<String>, shown: Shown) -> Option<Value> {
        let (at, name) = (name.span().start, name.get_ref());
        let number = self.topic.numbers.iter().find(|number| number.id == name);
        let number = *self.named(at, "number", name, number)?;
        let meaning = self.text(at, shown.meaning);
        let closed = shown.closed.map(|form| self.text(at, form));
        Some(Value::new(
            number,
            id,
            shown.decimals.into(),
            meaning,
            closed,
        ))
    }

    /// Whether all that there is to be named is named.
    fn all_used(&self, used: &Used) {
        let is_used = |name: &_| used.contains(name);
        let unused = self.common.unused(&self.topic.file, &is_used);
        let trials = self.topic.attempts();
        let trials = trials.map(|trial| ("trial", trial.name(), trial.place));
        let cases = self.topic.cases.iter();
        let cases = cases.map(|case| (PAIR, case.claim, case.place));
        let numbers = self.topic.numbers.iter();
        let numbers = numbers.map(|number| ("number", number.id, number.place));
        let all = trials.chain(cases).chain(numbers);
        let idle = all.filter(|(what, name, _)| !is_used(&(what, (*name).to_owned())));
        let idle = idle.map(|(what, name, place)| ReadError {
            file: place.file().to_owned(),
            line: place.line() as usize,
            fault: Fault::Unused {
                what,
                name: name.to_owned(),
            },
        });
        self.faults
            .borrow_mut()
            .extend(unused.into_iter().chain(idle));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evidence::Evidence;
    use crate::trials::attempt::trials;
    use crate::trials::by_hand::Numbers;
    use crate::trials::values::Number;
    use crate::trials::{Paper, listed};

    fn fall() -> Evidence {
        unreachable!("nobody tries it")
    }

    fn rise() -> Evidence {
        unreachable!("nobody tries it")
    }

    const WHOLE: &str = include_str!("read/fall.toml");

    const TRIALS: &[&[Attempt]] = &[trials![fall, rise]];

    fn topic(text: &str) -> Topic {
        let text = text.to_owned().leak();
        let numbers = || Ok(1.0);
        let cases = Box::leak(Box::new([Numbers::new("eq-7", numbers, numbers)]));
        let values = Box::leak(Box::new([Number::new("g", numbers)]));
        Topic::new(
            "fall",
            "The fall",
            File {
                path: "fall.toml",
                text: Text::Built(text),
                above: 0,
            },
            TRIALS,
        )
        .by_hand(cases)
        .numbers(values)
    }

    #[test]
    fn an_entry_says_what_the_claim_is() {
        let topic = topic(WHOLE);
        let [speed, picture] = topic.claims() else {
            panic!("two claims")
        };
        assert_eq!(
            (speed.id, speed.equation, speed.kind, speed.section),
            ("eq-7", Some(7), Kind::Equation, "1")
        );
        assert_eq!(
            (picture.id, picture.equation, picture.kind, picture.section),
            ("fig-1", None, Kind::Figure, "2")
        );
        assert_eq!(
            (speed.plain, picture.plain, picture.unproved),
            ("v = gt", "Of v.", Some("it is a picture"))
        );
        let conditions = [("$t>0$", Sort::Stated), ("read so", Sort::Reading)];
        assert_eq!(
            speed.conditions,
            conditions.map(|(text, sort)| Condition { text, sort })
        );
        assert_eq!(
            (speed.depends_on, speed.argument),
            (&["fig-1"][..], "It is so.")
        );
        let correction = speed.correction.unwrap();
        assert_eq!(
            (correction.change, correction.plain),
            (Change::Sign, "v = −gt")
        );
        let half = "it is half of it";
        let [rise, fall] = speed.trials else {
            panic!("two trials")
        };
        assert_eq!(
            (rise.name(), rise.idle, fall.name(), fall.idle),
            ("tests::rise", None, "tests::fall", Some(half))
        );
        assert_eq!(
            fall.coarse,
            [Excuse {
                of: "g",
                why: "for this"
            }]
        );
        let (low, high) = (f64::NEG_INFINITY, 0.0);
        let letter = "τ";
        assert_eq!(speed.domain, [Corner { letter, low, high }]);
        assert_eq!(speed.survivors, [Excuse { of: "g", why: half }]);
        assert_eq!(
            (
                speed.values[0].id,
                speed.values[0].claim,
                speed.values[0].closed
            ),
            ("g", "eq-7", Some("9.81"))
        );
        assert_eq!(
            speed.by_hand.unwrap().words().unwrap(),
            "Printed: 1.0. Found: 1.0"
        );
        assert!(
            topic
                .lines()
                .map(|(line, claim)| (line, claim.id))
                .eq([(8, "eq-7"), (27, "fig-1")])
        );
    }

    /// Whatever is wrong is told with its file and line.
    #[test]
    fn a_fault_is_told_with_its_line() {
        for fault in include_str!("read/faults.txt").lines() {
            let [from, to, told] = fault.split(" => ").collect::<Vec<_>>()[..] else {
                panic!("{fault}")
            };
            let text = WHOLE.replacen(from, to, 1);
            assert_ne!(text, WHOLE, "{from}");
            let error = listed(&topic(&text).read().faults);
            assert!(error.contains(told), "{from}: {error}");
        }
    }

    /// All at once, each once, however many topics share a file; what is missing as something cannot be read is no fault.
    #[test]
    fn faults_are_gathered() {
        const SHARED: File = File {
            path: "shared.toml",
            text: Text::Built(
                "conditions.soon = { stated = '$t' }\nreasons.idle = 'used by nobody'",
            ),
            above: 0,
        };
        let told = |texts: [&str; 2]| {
            let topics = texts.map(|text| &*Box::leak(Box::new(topic(text).sharing(SHARED))));
            let topics = topics.to_vec().leak();
            listed(
                &Paper {
                    topics,
                    ..Paper::BLANK
                }
                .check(),
            )
        };
        let second = WHOLE.replace("eq-7", "eq-8").replace("fig-1", "fig-2");
        let second = second.replace("title = \"a picture\"", "titel = \"a picture\"");
        let first = WHOLE
            .replace("\"late\"", "\"soon\"")
            .replace("[\"fig-1\"]", "[\"fig-9\"]");
        let told = told([&first.replace("tests::rise", "tests::raise"), &second]);
        let all = [
            "fall.toml, line 12: there is no claim `fig-9`",
            "fall.toml, line 18: there is no trial `tests::raise`",
            "fall.toml, line 21: there is no pair of numbers of the case of `eq-8`",
            "fall.toml, line 29: unknown field `titel`",
            "shared.toml, line 1: a `$` has no partner",
        ];
        let begins = told
            .lines()
            .zip(all)
            .all(|(line, begin)| line.starts_with(begin));
        assert!(begins && told.lines().count() == all.len(), "{told}");
    }
}
