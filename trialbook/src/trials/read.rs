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
//! `argument`, `whole`, `unproved`, `by-hand`, `values`, `survivors`, `cornered` and `unread`: as [`Claim`] has them. A reason of
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

    /// The line, from 1, of a place in the text.
    fn line(&self, at: usize) -> usize {
        let before = self.text.bytes().take(at);
        self.above + 1 + before.filter(|byte| *byte == b'\n').count()
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
    /// The lines in which they begin, from 1.
    pub lines: Vec<usize>,
    /// The claims that they name, each with its line.
    pub from: Vec<(usize, &'static str)>,
    /// The names that they use.
    pub used: Used,
}

/// What several claims have in common.
#[derive(Default)]
struct Common {
    section: &'static str,
    conditions: BTreeMap<Spanned<String>, Said>,
    reasons: BTreeMap<Spanned<String>, String>,
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
    decimals: usize,
    meaning: String,
    closed: Option<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Worked {
    wrong: String,
    reason: String,
    case: String,
    digits: usize,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
struct Entry {
    section: Option<String>,
    kind: Option<Kind>,
    title: String,
    latex: String,
    plain: Option<String>,
    #[serde(default)]
    conditions: Vec<Spanned<Given>>,
    #[serde(default)]
    domain: BTreeMap<String, [f64; 2]>,
    #[serde(default)]
    from: Vec<Spanned<String>>,
    corrected: Option<String>,
    corrected_plain: Option<String>,
    argument: Option<Spanned<String>>,
    #[serde(default)]
    whole: bool,
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

fn value<T: for<'de> Deserialize<'de>>(
    file: &File,
    value: Spanned<DeValue<'_>>,
) -> Result<T, ReadError> {
    let begin = value.span().start;
    T::deserialize(ValueDeserializer::from(value)).map_err(|error| {
        let at = error.span().map_or(begin, |span| span.start);
        file.error(file.line(at), Fault::Form(error.message().to_owned()))
    })
}

/// An entry with its id, and with the line in which it begins.
type Row = (usize, &'static str, Entry);

/// What claims have in common, and the entries in their order.
fn entries(file: &File) -> Result<(Common, Vec<Row>), ReadError> {
    let read = file.text.read();
    let read = read.map_err(|error| file.error(1, Fault::Form(error.to_string())))?;
    let table = DeTable::parse(read).map_err(|error| {
        let at = error.span().map_or(0, |span| span.start);
        file.error(file.line(at), Fault::Form(error.message().to_owned()))
    })?;
    let mut rows: Vec<_> = table.into_inner().into_iter().collect();
    rows.sort_by_key(|(key, _)| key.span().start);
    let (mut common, mut entries) = (Common::default(), Vec::new());
    for (key, row) in rows {
        let line = file.line(key.span().start);
        match &**key.get_ref() {
            "section" => common.section = text(value(file, row)?),
            "conditions" => common.conditions = value(file, row)?,
            "reasons" => common.reasons = value(file, row)?,
            id => entries.push((line, text(id.to_owned()), value(file, row)?)),
        }
    }
    Ok((common, entries))
}

/// What names were used, each with what it names.
pub(super) type Used = BTreeSet<(&'static str, String)>;

/// Whether all that a shared file offers is used.
pub(super) fn all_used(
    file: &File,
    used: &BTreeSet<&(&'static str, String)>,
) -> Result<(), ReadError> {
    entries(file)?.0.unused(file, &|name| used.contains(name))
}

impl Common {
    fn unused(
        &self,
        file: &File,
        used: &dyn Fn(&(&'static str, String)) -> bool,
    ) -> Result<(), ReadError> {
        let conditions = self.conditions.keys().map(|name| ("condition", name));
        let mut all = conditions.chain(self.reasons.keys().map(|name| ("reason", name)));
        match all.find(|(what, name)| !used(&(what, name.get_ref().clone()))) {
            None => Ok(()),
            Some((what, name)) => {
                let (line, name) = (file.line(name.span().start), name.get_ref().clone());
                Err(file.error(line, Fault::Unused { what, name }))
            }
        }
    }
}

/// What is needed to make sense of the entries of a topic.
struct Reader<'a> {
    topic: &'a Topic,
    common: Common,
    shared: Common,
    used: RefCell<Used>,
}

impl Read {
    pub(super) fn of(topic: &Topic) -> Result<Self, ReadError> {
        let (common, entries) = entries(&topic.file)?;
        let shared = topic.shared.as_ref().map(self::entries).transpose()?;
        let reader = Reader {
            topic,
            common,
            shared: shared.map(|(common, _)| common).unwrap_or_default(),
            used: RefCell::default(),
        };
        let (mut claims, mut lines, mut from) = (Vec::new(), Vec::new(), Vec::new());
        for (line, id, entry) in entries {
            claims.push(reader.claim(id, entry, &mut from)?);
            lines.push(line);
        }
        let used = reader.used.take();
        reader.all_used(&used)?;
        Ok(Self {
            claims: claims.leak(),
            lines,
            from,
            used,
        })
    }
}

/// What each of the list stands for.
fn each<T, U>(
    list: impl IntoIterator<Item = T>,
    of: impl FnMut(T) -> Result<U, ReadError>,
) -> Result<&'static [U], ReadError> {
    let all: Result<Vec<_>, _> = list.into_iter().map(of).collect();
    Ok(all?.leak())
}

/// The pair of numbers of a case by hand.
const PAIR: &str = "pair of numbers of the case of";

impl Reader<'_> {
    /// What a name stands for: what was found under it.
    fn named<T>(
        &self,
        at: usize,
        what: &'static str,
        name: &str,
        found: Option<T>,
    ) -> Result<T, ReadError> {
        self.used.borrow_mut().insert((what, name.to_owned()));
        let file = &self.topic.file;
        found.ok_or_else(|| file.error(file.line(at), Fault::unknown(what, name)))
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
    ) -> Result<Claim, ReadError> {
        let file = &self.topic.file;
        let equation = id
            .strip_prefix("eq-")
            .and_then(|number| number.parse().ok());
        let plain = |given: Option<String>, latex: &str| match given {
            Some(given) => text(given),
            None if equation.is_some() && !latex.contains('$') => plain_formula(latex).leak(),
            None => plain_words(latex).leak(),
        };
        let latex = text(entry.latex);
        let correction = entry.corrected.map(|right| {
            let right = text(right);
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
        let reason = |why: Option<_>| why.map(|why| self.reason(why)).transpose();
        Ok(Claim {
            id,
            section: entry.section.map_or(self.common.section, text),
            equation,
            kind: entry.kind.unwrap_or(usual),
            title: text(entry.title),
            latex,
            plain: plain(entry.plain, latex),
            depends_on: each(entry.from, |on| {
                let (line, on) = (file.line(on.span().start), text(on.into_inner()));
                from.push((line, on));
                Ok(on)
            })?,
            conditions: each(entry.conditions, |given| self.condition(given))?,
            domain: each(entry.domain, |(letter, [low, high])| {
                let letter = text(letter);
                Ok(Corner { letter, low, high })
            })?,
            correction,
            argument: reason(entry.argument)?.unwrap_or_default(),
            whole: entry.whole,
            trials: each(entry.trials.into_iter().zip(0..), |(tried, nth)| {
                let seat = mixed(id.bytes().map(u64::from).chain([nth]));
                let attempt = self.attempt(tried)?;
                Ok(Attempt { seat, ..attempt })
            })?,
            unproved: reason(entry.unproved)?,
            by_hand: entry
                .by_hand
                .map(|case| self.by_hand(id, case))
                .transpose()?,
            values: each(entry.values, |(name, shown)| self.value(id, &name, shown))?,
            survivors: self.excuses(entry.survivors)?,
            cornered: self.excuses(entry.cornered)?,
            unread: self.excuses(entry.unread)?,
        })
    }

    fn condition(&self, given: Spanned<Given>) -> Result<Condition, ReadError> {
        let at = given.span().start;
        let said = match given.into_inner() {
            Given::Said(said) => said,
            Given::Named(name) => {
                let known = self.common(|common| common.conditions.get(&*name));
                self.named(at, "condition", &name, known)?.clone()
            }
        };
        let mut all = said.into_iter();
        match (all.next(), all.next()) {
            (Some((sort, said)), None) => Ok(Condition {
                text: text(said),
                sort,
            }),
            _ => self.named(at, "condition with", "none or several sorts", None),
        }
    }

    /// A reason as it stands, or by its name, which is a single word.
    fn reason(&self, why: Spanned<String>) -> Result<&'static str, ReadError> {
        let (at, why) = (why.span().start, why.into_inner());
        if why.trim().contains(' ') {
            return Ok(text(why));
        }
        let known = self.common(|common| common.reasons.get(&*why));
        Ok(text(self.named(at, "reason", &why, known)?.clone()))
    }

    fn excuses(
        &self,
        all: BTreeMap<String, Spanned<String>>,
    ) -> Result<&'static [Excuse], ReadError> {
        each(all, |(of, why)| {
            let (of, why) = (text(of), self.reason(why)?);
            Ok(Excuse { of, why })
        })
    }

    fn attempt(&self, tried: Spanned<Tried>) -> Result<Attempt, ReadError> {
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
        let reason = |why: Option<_>| why.map(|why| self.reason(here(why))).transpose();
        let excuses = |all: BTreeMap<_, _>| {
            self.excuses(all.into_iter().map(|(of, why)| (of, here(why))).collect())
        };
        Ok(Attempt {
            idle: reason(excused.idle)?,
            elsewhere: reason(excused.elsewhere)?,
            coarse: excuses(excused.coarse)?,
            spared: excuses(excused.spared)?,
            ..*attempt
        })
    }

    fn by_hand(&self, id: &str, case: Spanned<Worked>) -> Result<ByHand, ReadError> {
        let at = case.span().start;
        let computed = self.topic.cases.iter().find(|numbers| numbers.claim == id);
        let Worked {
            wrong,
            reason,
            case,
            digits,
        } = case.into_inner();
        Ok(ByHand {
            wrong: text(wrong),
            reason: text(reason),
            case: text(case),
            digits,
            computed: *self.named(at, PAIR, id, computed)?,
        })
    }

    fn value(
        &self,
        id: &'static str,
        name: &Spanned<String>,
        shown: Shown,
    ) -> Result<Value, ReadError> {
        let (at, name) = (name.span().start, name.get_ref());
        let number = self.topic.numbers.iter().find(|number| number.id == name);
        let number = *self.named(at, "number", name, number)?;
        let (meaning, closed) = (text(shown.meaning), shown.closed.map(text));
        Ok(Value::new(number, id, shown.decimals, meaning, closed))
    }

    /// Whether all that there is to be named is named.
    fn all_used(&self, used: &Used) -> Result<(), ReadError> {
        let is_used = |name: &_| used.contains(name);
        self.common.unused(&self.topic.file, &is_used)?;
        let trials = self.topic.attempts();
        let trials = trials.map(|trial| ("trial", trial.name(), trial.place));
        let cases = self.topic.cases.iter();
        let cases = cases.map(|case| (PAIR, case.claim, case.place));
        let numbers = self.topic.numbers.iter();
        let numbers = numbers.map(|number| ("number", number.id, number.place));
        let mut all = trials.chain(cases).chain(numbers);
        match all.find(|(what, name, _)| !is_used(&(what, (*name).to_owned()))) {
            None => Ok(()),
            Some((what, name, place)) => Err(ReadError {
                file: place.file().to_owned(),
                line: place.line() as usize,
                fault: Fault::Unused {
                    what,
                    name: name.to_owned(),
                },
            }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evidence::Evidence;
    use crate::trials::attempt::trials;
    use crate::trials::by_hand::Numbers;
    use crate::trials::values::Number;

    fn fall() -> Evidence {
        unreachable!("nobody tries it")
    }

    fn rise() -> Evidence {
        unreachable!("nobody tries it")
    }

    const WHOLE: &str = r#"
section = "1"
[conditions]
late = { stated = '$t>0$' }
[reasons]
half = "it is half of it"

[eq-7]
title = "speed"
latex = 'v=gt'
conditions = ["late", { reading = "read so" }]
from = ["fig-1"]
corrected = 'v=-gt'
argument = """
It is
so."""
domain."τ" = [-inf, 0]
trials = ["tests::rise", { trial = "tests::fall", idle = "half", coarse = { g = "for this" } }]
survivors.g = "half"
values.g = { decimals = 2, meaning = "gravity", closed = "9.81" }
[eq-7.by-hand]
wrong = "the sign"
reason = "It falls"
case = "Printed: {stated}. Found: {found}"
digits = 1

[fig-1]
section = "2"
title = "a picture"
latex = "Of $v$."
unproved = "it is a picture"
"#;

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
        let place = file!();
        for (from, to, told) in [
            (
                "title = \"speed\"",
                "titel = \"speed\"",
                "fall.toml, line 9: unknown field `titel`",
            ),
            (
                "latex = 'v=gt'\n",
                "",
                "fall.toml, line 8: missing field `latex`",
            ),
            ("latex = 'v=gt'", "latex = 'v=gt", "fall.toml, line 10: "),
            (
                "[\"late\", {",
                "[\"latte\", {",
                "fall.toml, line 11: there is no condition `latte`",
            ),
            (
                "[\"late\", {",
                "[{",
                "fall.toml, line 4: no claim names the condition `late`",
            ),
            (
                "{ reading =",
                "{ read =",
                "fall.toml, line 11: the name of a condition, or `{ sort = 'text' }`",
            ),
            (
                "\"tests::rise\", ",
                "",
                "no claim names the trial `tests::rise`",
            ),
            (
                "tests::rise",
                "tests::raise",
                "fall.toml, line 18: there is no trial `tests::raise`",
            ),
            (
                "idle = \"half\"",
                "idle = \"halve\"",
                "fall.toml, line 18: there is no reason `halve`",
            ),
            (
                "survivors.g = \"half\"",
                "survivors.g = \"halve\"",
                "fall.toml, line 19: there is no reason `halve`",
            ),
            (
                "values.g =",
                "values.h =",
                "fall.toml, line 20: there is no number `h`",
            ),
            (
                "[eq-7.by-hand]",
                "[fig-1.by-hand]",
                "fall.toml, line 21: there is no pair of numbers of the case of `fig-1`",
            ),
        ] {
            let text = WHOLE.replace(from, to);
            assert_ne!(text, WHOLE, "{from}");
            let error = topic(&text).read().unwrap_err().to_string();
            assert!(error.contains(told), "{from}: {error}");
            assert!(
                !told.starts_with("no claim names the trial") || error.starts_with(place),
                "{error}"
            );
        }
    }
}
