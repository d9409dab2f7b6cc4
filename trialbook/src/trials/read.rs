//! Reads the claims of a topic from its file: TOML, one table for each claim.
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
//! `argument`, `unproved`, `by-hand`, `values`, `survivors`, `cornered`, `unread`, `ours`, `was`, `aliases`, `watch`, `reads` and
//! `corrected-reads`: as [`Claim`] has them. A reason of a single word is a name. Text in `'''…'''` may be broken into lines.
//! A field without effect is refused.

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
    /// A field that would be ignored.
    #[error("`{field}` has no effect: {why}")]
    Idle {
        /// The field.
        field: &'static str,
        /// Why not, and what to do.
        why: &'static str,
    },
}

impl Fault {
    pub(super) fn unknown(what: &'static str, name: &str) -> Self {
        Self::Unknown {
            what,
            name: name.to_owned(),
        }
    }
}

#[derive(Debug)]
pub(crate) struct Read {
    pub claims: &'static [Claim],
    /// Each with its line, also of those that are no claims.
    pub ids: Vec<(usize, &'static str)>,
    pub from: Vec<(usize, &'static str)>,
    pub was: Vec<(usize, &'static str)>,
    pub used: Used,
    pub faults: Vec<ReadError>,
    /// Something may be missing of what is named.
    pub broken: bool,
}

#[derive(Default)]
struct Common {
    section: &'static str,
    section_line: usize,
    conditions: BTreeMap<Spanned<String>, Said>,
    reasons: BTreeMap<Spanned<String>, String>,
    /// Some of it may be missing, as it cannot be read.
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
    pencil: [String; 2],
    #[serde(default)]
    decimals: Vec<String>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields, rename_all = "kebab-case")]
struct Entry {
    section: Option<Spanned<String>>,
    kind: Option<Spanned<Kind>>,
    ours: Option<Spanned<bool>>,
    #[serde(default)]
    was: Vec<Spanned<String>>,
    aliases: Option<Spanned<String>>,
    title: Spanned<String>,
    latex: Spanned<String>,
    plain: Option<Spanned<String>>,
    #[serde(default)]
    reads: Vec<Spanned<String>>,
    #[serde(default)]
    conditions: Vec<Spanned<Given>>,
    #[serde(default)]
    domain: BTreeMap<Spanned<String>, [f64; 2]>,
    #[serde(default)]
    from: Vec<Spanned<String>>,
    corrected: Option<Spanned<String>>,
    corrected_plain: Option<Spanned<String>>,
    #[serde(default)]
    corrected_reads: Vec<Spanned<String>>,
    argument: Option<Spanned<String>>,
    #[serde(default)]
    trials: Vec<Spanned<Tried>>,
    unproved: Option<Spanned<String>>,
    by_hand: Option<Spanned<Worked>>,
    watch: Option<Spanned<[String; 2]>>,
    #[serde(default)]
    values: BTreeMap<Spanned<String>, Shown>,
    #[serde(default)]
    survivors: BTreeMap<String, Spanned<String>>,
    #[serde(default)]
    cornered: BTreeMap<String, Spanned<String>>,
    #[serde(default)]
    unread: BTreeMap<String, Spanned<String>>,
}

/// Leaked, its lines joined.
fn text(text: String) -> &'static str {
    text.trim_end().replace('\n', " ").leak()
}

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

type Row = (usize, &'static str, Option<Entry>);

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
            "section" => {
                common.section = text(value(file, row, faults).unwrap_or_default());
                common.section_line = line;
            }
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

pub(super) type Used = BTreeSet<(&'static str, String)>;

pub(super) fn unused(file: &File, used: &BTreeSet<&(&'static str, String)>) -> Vec<ReadError> {
    let (common, entries) = entries(file, &mut Vec::new());
    let section = Some(common.section_line).filter(|line| *line > 0);
    let foreign = entries.iter().map(|(line, ..)| *line).chain(section);
    let mut told = common.unused(file, &|name| used.contains(name));
    told.extend(foreign.map(|line| {
        let why = "a shared file has conditions and reasons: move it to the file of its topic";
        let field = "an entry or a section";
        file.error(line, Fault::Idle { field, why })
    }));
    told
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
        let (mut claims, mut from, mut was) = (Vec::new(), Vec::new(), Vec::new());
        let ids = entries.iter().map(|(line, id, _)| (*line, *id)).collect();
        let own = |(.., entry): &Row| entry.as_ref().is_some_and(|entry| entry.section.is_some());
        if reader.common.section_line > 0 && entries.iter().all(own) {
            let (line, why) = (
                reader.common.section_line,
                "each entry has its own: leave it out",
            );
            let field = "section";
            let fault = topic.file.error(line, Fault::Idle { field, why });
            reader.faults.borrow_mut().push(fault);
        }
        for (_, id, entry) in entries {
            let Some(entry) = entry else { continue };
            claims.push(reader.claim(id, entry, [&mut from, &mut was]));
        }
        let used = reader.used.take();
        if readable {
            reader.all_used(&used);
        }
        Self {
            claims: claims.leak(),
            ids,
            from,
            was,
            used,
            broken: reader.common.broken || reader.shared.broken,
            faults: reader.faults.into_inner(),
        }
    }
}

fn each<T, U>(list: impl IntoIterator<Item = T>, of: impl FnMut(T) -> Option<U>) -> &'static [U] {
    list.into_iter().filter_map(of).collect::<Vec<_>>().leak()
}

const PAIR: &str = "pair of numbers of the case of";

impl Reader<'_> {
    fn fault(&self, at: usize, fault: Fault) {
        let file = &self.topic.file;
        let fault = file.error(file.line(at), fault);
        self.faults.borrow_mut().push(fault);
    }

    fn named<T>(&self, at: usize, what: &'static str, name: &str, found: Option<T>) -> Option<T> {
        self.used.borrow_mut().insert((what, name.to_owned()));
        let broken = self.common.broken || self.shared.broken;
        if found.is_none() && !(broken && matches!(what, "condition" | "reason")) {
            self.fault(at, Fault::unknown(what, name));
        }
        found
    }

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

    fn common<T>(&self, of: impl Fn(&Common) -> Option<&T>) -> Option<&T> {
        of(&self.common).or_else(|| of(&self.shared))
    }

    fn claim(
        &self,
        id: &'static str,
        entry: Entry,
        [from, was]: [&mut Vec<(usize, &'static str)>; 2],
    ) -> Claim {
        let file = &self.topic.file;
        self.idle_fields(&entry);
        let lined = |list: Vec<_>, known: &mut Vec<_>| {
            each(list, |id: Spanned<String>| {
                let (line, id) = (file.line(id.span().start), text(id.into_inner()));
                known.push((line, id));
                Some(id)
            })
        };
        // A `$` counts formulas there.
        let texts = |list| each(list, |said: Spanned<String>| Some(text(said.into_inner())));
        let equation = id
            .strip_prefix("eq-")
            .and_then(|number| number.parse().ok());
        let plain = |field, given: Option<Spanned<String>>, latex: &str| {
            let computed: &str = match equation.is_some() && !latex.contains('$') {
                true => plain_formula(latex).leak(),
                false => plain_words(latex).leak(),
            };
            let Some(given) = given else {
                return computed;
            };
            let (at, given) = (given.span().start, self.spanned(given));
            self.idle(
                given == computed,
                at,
                field,
                "it is what is computed: leave it out",
            );
            given
        };
        let latex = self.spanned(entry.latex);
        let correction = entry.corrected.map(|right| {
            let right = self.spanned(right);
            Correction {
                change: Change::between(latex, right),
                latex: right,
                plain: plain("corrected-plain", entry.corrected_plain, right),
                reads: texts(entry.corrected_reads),
            }
        });
        let usual = match id {
            _ if equation.is_some() => Kind::Equation,
            _ if id.starts_with("fig-") => Kind::Figure,
            _ => Kind::Property,
        };
        let all = entry.trials.len();
        let trials = each(entry.trials.into_iter().zip(0..), |(tried, nth)| {
            let seat = mixed(id.bytes().map(u64::from).chain([nth]));
            let attempt = self.attempt(tried)?;
            Some(Attempt { seat, ..attempt })
        });
        let unproved = trials.iter().all(|trial| trial.statement().is_none());
        if let (Some(why), true) = (&entry.argument, unproved && trials.len() == all) {
            let told = "none of its trials is a proof: leave it out";
            self.idle(true, why.span().start, "argument", told);
        }
        Claim {
            id,
            section: entry.section.map_or(self.common.section, |own| {
                let (at, own) = (own.span().start, text(own.into_inner()));
                let same = own == self.common.section;
                self.idle(same, at, "section", "it is that of the file: leave it out");
                own
            }),
            equation,
            kind: entry.kind.map_or(usual, |kind| {
                let same = *kind.get_ref() == usual;
                self.idle(same, kind.span().start, "kind", "its id says so: leave it out");
                kind.into_inner()
            }),
            ours: entry.ours.is_some_and(|ours| {
                if usual != Kind::Property {
                    let told = "the equations and figures of the paper are not ours: give it an id of its own";
                    self.fault(ours.span().start, Fault::Form(told.to_owned()));
                }
                ours.into_inner()
            }),
            was: lined(entry.was, was),
            aliases: entry.aliases.map_or("", |said| self.spanned(said)),
            watch: entry.watch.map(|watch| {
                let at = watch.span().start;
                watch.into_inner().map(|said| self.text(at, said))
            }),
            title: self.spanned(entry.title),
            latex,
            plain: plain("plain", entry.plain, latex),
            reads: texts(entry.reads),
            depends_on: lined(entry.from, from),
            conditions: each(entry.conditions, |given| self.condition(given)),
            domain: each(entry.domain, |(letter, [low, high])| {
                let all = [low, high] == [f64::NEG_INFINITY, f64::INFINITY];
                let why = "every number is in it: leave it out";
                self.idle(all, letter.span().start, "domain", why);
                if low.is_nan() || high.is_nan() || low >= high {
                    let told = "a domain is two numbers, the lower one first".to_owned();
                    self.fault(letter.span().start, Fault::Form(told));
                }
                let letter = text(letter.into_inner());
                Some(Corner { letter, low, high })
            }),
            correction,
            argument: entry.argument.map_or("", |why| self.reason(why)),
            trials,
            unproved: entry.unproved.map(|why| self.reason(why)),
            by_hand: entry.by_hand.and_then(|case| self.by_hand(id, case)),
            values: each(entry.values, |(name, shown)| self.value(id, &name, shown)),
            survivors: self.excuses(entry.survivors),
            cornered: self.excuses(entry.cornered),
            unread: self.excuses(entry.unread),
        }
    }

    fn idle(&self, is: bool, at: usize, field: &'static str, why: &'static str) {
        if is {
            self.fault(at, Fault::Idle { field, why });
        }
    }

    fn idle_fields(&self, entry: &Entry) {
        let at = |field: &Option<Spanned<String>>| field.as_ref().map(|f| f.span().start);
        let first = |list: &[Spanned<String>]| list.first().map(|f| f.span().start);
        let by_hand = entry.by_hand.as_ref().map(|case| case.span().start);
        let watch = entry.watch.as_ref().map(|watch| watch.span().start);
        let ours = entry.ours.as_ref().map(|ours| ours.span().start);
        let is_ours = entry.ours.as_ref().is_some_and(|ours| *ours.get_ref());
        let is_defined = matches!(&entry.kind, Some(kind) if *kind.get_ref() == Kind::Definition);
        let [no_correction, no_case] = [entry.corrected.is_none(), entry.by_hand.is_none()];
        let as_printed =
            matches!(&entry.corrected, Some(right) if right.get_ref() == entry.latex.get_ref());
        let not_corrected = "there is no `corrected`: add it, or leave this out";
        let not_printed =
            "what is ours is not printed and has no correction: mend `latex`, and leave this out";
        for (is, field, at, why) in [
            (
                no_correction,
                "corrected-plain",
                at(&entry.corrected_plain),
                not_corrected,
            ),
            (
                no_correction,
                "corrected-reads",
                first(&entry.corrected_reads),
                not_corrected,
            ),
            (
                as_printed,
                "corrected",
                at(&entry.corrected),
                "it is what is printed: leave it out",
            ),
            (
                no_case,
                "watch",
                watch,
                "it is shown with the case by hand: add `by-hand`, or leave it out",
            ),
            (is_ours, "corrected", at(&entry.corrected), not_printed),
            (is_ours, "by-hand", by_hand, not_printed),
            (is_ours, "reads", first(&entry.reads), not_printed),
            (
                !is_ours,
                "ours",
                ours,
                "what is not ours does not say so: leave it out",
            ),
            (
                is_defined,
                "unproved",
                at(&entry.unproved),
                "nothing of a definition is to be proved: leave it out",
            ),
        ] {
            if let (true, Some(at)) = (is, at) {
                self.fault(at, Fault::Idle { field, why });
            }
        }
        let mut said = BTreeSet::new();
        for given in &entry.conditions {
            let text = match given.get_ref() {
                Given::Named(name) => name.clone(),
                Given::Said(said) => format!("{said:?}"),
            };
            let twice = !said.insert(text);
            self.idle(
                twice,
                given.span().start,
                "conditions",
                "it has this one twice: leave one out",
            );
        }
        let mut known = BTreeSet::new();
        for on in &entry.from {
            let twice = !known.insert(on.get_ref());
            self.idle(
                twice,
                on.span().start,
                "from",
                "it names this claim twice: leave one out",
            );
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
        let [coarse, spared] = [&excused.coarse, &excused.spared].map(|all| !all.is_empty());
        let proof = attempt.statement().is_some();
        self.idle(
            coarse && proof,
            at.start,
            "coarse",
            "a proof has no tolerance: leave it out",
        );
        let why = "it is said of proofs, and this is none: leave it out";
        self.idle(spared && !proof, at.start, "spared", why);
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
            pencil,
            decimals,
        } = case.into_inner();
        let [wrong, reason, case] = [wrong, reason, case].map(|said| self.text(at, said));
        for (place, field) in [("{stated}", "stated"), ("{found}", "found")] {
            let told = format!("the `case` does not show its number `{{{field}}}`");
            if !case.contains(place) {
                self.fault(at, Fault::Form(told));
            }
        }
        Some(ByHand {
            wrong,
            reason,
            case,
            digits: digits.into(),
            pencil: pencil.map(|said| self.text(at, said)),
            decimals: each(decimals, |said| Some(self.text(at, said))),
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
    use crate::evidence::{Evidence, Subject};
    use crate::trials::attempt::trials;
    use crate::trials::by_hand::Numbers;
    use crate::trials::statement::Statement;
    use crate::trials::values::Number;
    use crate::trials::{Paper, listed};

    fn fall() -> Evidence {
        unreachable!("nobody tries it")
    }

    fn rise() -> Evidence {
        unreachable!("nobody tries it")
    }

    const WHOLE: &str = include_str!("read/fall.toml");

    const SHOWN: Statement<()> = Statement::shown(
        Subject::Printed,
        "it falls",
        || (),
        |()| unreachable!("nobody proves it"),
    );

    const TRIALS: &[&[Attempt]] = &[trials![fall, rise, &SHOWN]];

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
        let [speed, picture, own] = topic.claims() else {
            panic!("three claims")
        };
        assert!(own.ours && !speed.ours && own.kind_name() == "property, derived here");
        assert_eq!(
            (speed.aliases, speed.reads, picture.was, speed.watch),
            (
                "how fast; rate",
                &["side 0.1: speed"][..],
                &["fig-0"][..],
                Some(["fall.html#explore-fall?v=0", "it fall"])
            )
        );
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
            (correction.change, correction.plain, correction.reads),
            (Change::Sign, "v = −gt", &["side 0.1: right"][..])
        );
        let half = "it is half of it";
        let [rise, fall, _] = speed.trials else {
            panic!("three trials")
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
        let case = speed.by_hand.unwrap();
        assert_eq!(case.words().unwrap(), "Printed: 1.0. Found: 1.0");
        assert_eq!((case.pencil, case.decimals), (["1", "2/2"], &["3/2"][..]));
        assert!(topic.lines().map(|(line, claim)| (line, claim.id)).eq([
            (7, "eq-7"),
            (32, "fig-1"),
            (39, "s1-own")
        ]));
    }

    #[test]
    fn a_fault_is_told_with_its_line() {
        for fault in include_str!("read/faults.txt").lines() {
            let [from, to, told] = fault.split(" => ").collect::<Vec<_>>()[..] else {
                panic!("{fault}")
            };
            let text = WHOLE.replacen(from, &to.replace('§', "\n"), 1);
            assert_ne!(text, WHOLE, "{from}");
            let topics = vec![&*Box::leak(Box::new(topic(&text)))].leak();
            let paper = Paper {
                topics,
                ..Paper::BLANK
            };
            let error = listed(&paper.check());
            assert!(error.contains(told), "{from}: {error}");
        }
    }

    /// What is missing as something cannot be read is no fault.
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
        let second = second
            .replace("s1-own", "s1-other")
            .replace("fig-0", "fig-8");
        let second = second.replace("title = \"a picture\"", "titel = \"a picture\"");
        let first = WHOLE
            .replace("\"late\"", "\"soon\"")
            .replace("[\"fig-1\"]", "[\"fig-9\"]");
        let told = told([&first.replace("tests::rise", "tests::raise"), &second]);
        let all = [
            "fall.toml, line 13: there is no claim `fig-9`",
            "fall.toml, line 20: there is no trial `tests::raise`",
            "fall.toml, line 24: there is no pair of numbers of the case of `eq-8`",
            "fall.toml, line 34: unknown field `titel`",
            "shared.toml, line 1: a `$` has no partner",
        ];
        let begins = told
            .lines()
            .zip(all)
            .all(|(line, begin)| line.starts_with(begin));
        assert!(begins && told.lines().count() == all.len(), "{told}");
    }

    #[test]
    fn what_a_file_says_in_vain_is_told() {
        const OWN: &str = "[s1-a]\nsection = '2'\ntitle = 'a'\nlatex = 'a'";
        let told = |text: &str, shared: &'static str| {
            let shared = File {
                path: "shared.toml",
                text: Text::Built(shared),
                above: 0,
            };
            let topics = vec![&*Box::leak(Box::new(topic(text).sharing(shared)))].leak();
            let paper = Paper {
                topics,
                ..Paper::BLANK
            };
            listed(&paper.check())
        };
        let section = told(&format!("section = '1'\n{OWN}"), "");
        assert!(
            section.contains("fall.toml, line 1: `section` has no effect: each entry"),
            "{section}"
        );
        for (text, line) in [(OWN, 1), ("\nsection = '3'", 2)] {
            let told = told(WHOLE, text);
            assert!(
                told.starts_with(&format!("shared.toml, line {line}: ")),
                "{told}"
            );
        }
    }
}
