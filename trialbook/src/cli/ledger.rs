//! The commands that try claims: the main job, `verify`, `show`, `list` and `errata`.

use super::table as columns;
use super::{
    deep::{Depth, deepened},
    ids::known_all,
    output::{VERSION, bom, complain, csv, json, say, show as shown},
    screen::{progress, screen},
};
use crate::book;
use crate::data::Folder;
use crate::ledger::{self, Difference, Entry, Ledger, Record, Row, Verdict};
use crate::numerics::error::plain;
use crate::publishing::{Edition, Failure, Format};
use crate::stop;
use crate::trials::{Claim, Paper, points::set_round};
use clap::builder::{PossibleValue, PossibleValuesParser};
use clap::{Args, ValueEnum};
use rayon::prelude::*;
use serde::Serialize;
use std::collections::BTreeSet;
use std::fmt::Write;
use std::path::Path;
use std::time::Instant;

/// Verdicts by their short names, or by the words that are printed.
pub(super) fn verdicts() -> PossibleValuesParser {
    let named = |verdict: Verdict| {
        let words = verdict.words();
        PossibleValue::new(verdict.slug()).alias(words).help(words)
    };
    PossibleValuesParser::new(Verdict::ALL.map(named))
}

pub(super) fn sections(paper: &Paper) -> PossibleValuesParser {
    let sections: BTreeSet<&str> = paper.claims().map(|(_, claim)| claim.section).collect();
    PossibleValuesParser::new(sections)
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(super) enum ErrataFormat {
    /// Plain text
    Text,
    /// A LaTeX document
    Latex,
    /// As with --json
    Json,
}

#[derive(Serialize)]
struct Claims<'a> {
    version: u32,
    recorded: Option<&'a str>,
    claims: Vec<Row<'a>>,
    differences: &'a [Difference],
    #[serde(skip_serializing_if = "Option::is_none")]
    book: Option<&'a Path>,
}

/// What a command that tries claims has at the end.
pub(super) struct Tried {
    ledger: Ledger,
    rounds: u32,
    differences: Vec<Difference>,
    /// Of which version the record is that it was read from, and what is said of that; nothing if claims were tried.
    recorded: Option<[String; 2]>,
    /// Whether somebody has stopped it before its end.
    stopped: bool,
}

impl Tried {
    fn new(paper: &'static Paper, ids: Option<&[&str]>, depth: &Depth) -> Result<Self, Failure> {
        stop::listen()?;
        let record = Record::parse(&paper.record)?;
        let ledger = with_progress(paper, ids);
        let (ledger, rounds) = deepened(ledger, ids.unwrap_or_default(), depth)?;
        let mut differences = record.differences(&ledger);
        let (all, done) = (wanted(paper, ids), ledger.entries.len());
        let stopped = done < all || rounds < depth.rounds;
        if ids.is_some() || stopped {
            differences.retain(|d| d.found.is_some());
        }
        if stopped {
            let rounds = match depth.rounds {
                1 => String::new(),
                of => format!(", {rounds} of {of} rounds made"),
            };
            complain("stopped", &format!("{done} of {all} claims tried{rounds}"));
        }
        Ok(Tried {
            ledger,
            rounds,
            differences,
            recorded: None,
            stopped,
        })
    }

    /// What is recorded of all claims, and `how` these can be tried. If nothing is recorded but the verdicts, they are tried.
    pub(super) fn recorded(edition: &Edition, how: &'static str) -> Result<Self, Failure> {
        if matches!(edition.paper.sheets, Folder::None) {
            return Self::new(edition.paper, None, &Depth::ONCE);
        }
        let version = format!("{} {}", edition.name, edition.version);
        let version = version.trim_end().to_owned();
        let note = format!("as recorded with {version}; {how} now");
        Ok(Tried {
            ledger: Ledger::recorded(edition.paper)?,
            rounds: 1,
            differences: Vec::new(),
            recorded: Some([version, note]),
            stopped: false,
        })
    }

    /// The record, or what some claims bring now.
    fn asked(
        edition: &Edition,
        ids: Option<&[&str]>,
        Now { now }: &Now,
        depth: &Depth,
    ) -> Result<Self, Failure> {
        match *now || depth.rounds > 1 {
            true => Self::new(edition.paper, ids, depth),
            false => Self::recorded(edition, "--try tries"),
        }
    }

    /// Says on standard error whether a letter or a table is from the record, or where it differs.
    fn note(&self) {
        if screen().quiet {
            return;
        }
        let record = self.recorded.iter().map(|[_, note]| note.as_str());
        for line in self.differing().lines().chain(record) {
            complain("note", line);
        }
    }

    fn version(&self) -> Option<&str> {
        self.recorded.as_ref().map(|[version, _]| version.as_str())
    }

    fn differing(&self) -> String {
        let words = |v: Option<Verdict>| v.map_or("no such claim", Verdict::words);
        let line = |d: &Difference| {
            let (recorded, found) = (words(d.recorded), words(d.found));
            format!("{}: recorded as {recorded}, found {found}\n", d.id)
        };
        let why = |d: &Difference| d.found.map(|_| format!("why: `show {}`\n", d.id));
        let why = self.differences.iter().find_map(why);
        self.differences.iter().map(line).chain(why).collect()
    }

    fn code(&self) -> u8 {
        match self.stopped {
            true => stop::STOPPED,
            false => u8::from(!self.differences.is_empty()),
        }
    }

    fn rows<'a>(&'a self, shown: &[&'a Entry], book: Option<&'a Path>) -> Claims<'a> {
        Claims {
            version: VERSION,
            recorded: self.version(),
            claims: shown.par_iter().map(|entry| entry.row()).collect(),
            differences: &self.differences,
            book,
        }
    }

    pub(super) fn all(&self) -> Vec<&Entry> {
        self.ledger.entries.iter().collect()
    }

    /// Answers with these claims, as text with these words; the exit code.
    pub(super) fn answered(
        &self,
        entries: &[&Entry],
        words: impl FnOnce() -> String,
        format: Format,
    ) -> Result<u8, Failure> {
        match format {
            Format::Text => shown(&words())?,
            Format::Json => json(&self.rows(entries, None))?,
            Format::Csv => {
                table(entries)?;
                self.note();
            }
        }
        Ok(self.code())
    }

    /// Table, differences and summary as text; where quiet is wanted, the differences alone.
    fn text(&self) -> String {
        let quiet = screen().quiet;
        let mut text = match quiet {
            true => String::new(),
            false => columns::table(&self.ledger.entries, &screen()),
        };
        text += &self.differing();
        if !quiet {
            let _ = writeln!(text, "\n{}", self.ledger.summary());
        }
        text
    }

    /// These claims in a list, and whether it is the record.
    pub(super) fn listed(&self, entries: &[&Entry]) -> String {
        let list = columns::list(entries, &screen());
        let end = match &self.recorded {
            Some([_, note]) => note,
            None => &self.as_recorded(),
        };
        format!("{list}\n{}{end}", self.differing())
    }

    /// How many claims are as recorded, in words.
    fn as_recorded(&self) -> String {
        let all = self.ledger.entries.len();
        let differ = self.differences.iter().filter(|d| d.found.is_some());
        let rounds = match self.rounds {
            1 => String::new(),
            rounds => format!(
                ", in {rounds} rounds and {} comparisons",
                self.ledger.points()
            ),
        };
        format!(
            "{} of {all} verdicts as recorded{rounds}",
            all - differ.count()
        )
    }
}

/// Verifies everything and writes the book.
pub(super) fn main_job(
    edition: &Edition,
    out: &Path,
    depth: &Depth,
    format: Format,
) -> Result<u8, Failure> {
    let start = Instant::now();
    book::check(edition, out)?;
    let drawn = || {
        let figures = (edition.figures)()?;
        let frame = book::Frame::new(edition, &figures, out)?;
        Ok::<_, Failure>((figures, frame))
    };
    let (tried, drawn) = rayon::join(|| Tried::new(edition.paper, None, depth), drawn);
    let (tried, (figures, frame)) = (tried?, drawn?);
    if tried.stopped {
        return tried.answered(&tried.all(), || tried.text(), format);
    }
    let first_page = frame.fill(&tried.ledger, &figures)?;
    let words = || {
        format!(
            "{}{} comparisons in {:.1} s; {}\nThe book: {}",
            tried.text(),
            tried.ledger.points(),
            start.elapsed().as_secs_f64(),
            tried.as_recorded(),
            first_page.display()
        )
    };
    match format {
        Format::Text if screen().quiet => {
            say(&format!("{}{}", tried.text(), first_page.display()))?
        }
        Format::Json => json(&tried.rows(&tried.all(), Some(&first_page)))?,
        _ => return tried.answered(&tried.all(), words, format),
    }
    Ok(tried.code())
}

pub(super) fn verify(
    edition: &Edition,
    ids: &[String],
    depth: &Depth,
    format: Format,
) -> Result<u8, Failure> {
    let known = known_all(edition, ids)?;
    let tried = Tried::new(edition.paper, (!ids.is_empty()).then_some(&known), depth)?;
    let words = || tried.text() + &tried.as_recorded();
    tried.answered(&tried.all(), words, format)
}

/// Prints what a round of a run in depth brings for the claims of these ids, or for all.
pub(super) fn round(edition: &Edition, ids: &[String], round: u64) -> Result<u8, Failure> {
    set_round(round);
    let known = known_all(edition, ids)?;
    let ledger = match &known[..] {
        [] => Ledger::try_all(edition.paper, |_| {}),
        ids => Ledger::try_some(edition.paper, ids, |_| {}),
    };
    say(&ledger.round())?;
    Ok(0)
}

/// Prints the record of a deep run.
pub(super) fn record(paper: &'static Paper, made: &str, depth: &Depth) -> Result<u8, Failure> {
    let tried = Tried::new(paper, None, depth)?;
    say(&tried.ledger.record(made, tried.rounds))?;
    Ok(tried.code())
}

pub(super) fn show(
    edition: &Edition,
    ids: &[String],
    depth: &Depth,
    format: Format,
) -> Result<u8, Failure> {
    let tried = Tried::new(edition.paper, Some(&known_all(edition, ids)?), depth)?;
    let painted = |entry: &Entry| {
        let verdict = entry.judgement.verdict;
        let line = |words: &str| format!("\nverdict: {words}\n");
        let words = verdict.words();
        let with = line(&screen().paint(verdict, words));
        entry.sheet().replacen(&line(words), &with, 1)
    };
    let sheets = || tried.ledger.entries.iter().map(painted);
    let words = || sheets().collect::<Vec<_>>().join("\n\n");
    tried.answered(&tried.all(), words, format)
}

/// Which claims are listed, and of what.
#[derive(Args)]
pub(super) struct List {
    /// Only claims of this verdict, as it is printed or by its short name, or of one of several between commas
    #[arg(long, value_parser = verdicts(), value_delimiter = ',')]
    verdict: Vec<String>,
    /// Only claims of this section of the paper, or of one of several between commas
    #[arg(long, value_delimiter = ',')]
    section: Vec<String>,
    #[command(flatten)]
    now: Now,
}

/// Whether `list` and `errata` try.
#[derive(Args)]
struct Now {
    /// Try the claims now, in place of what is recorded, and say where a verdict differs
    #[arg(long = "try")]
    now: bool,
}

pub(super) fn list(
    edition: &Edition,
    asked: &List,
    depth: &Depth,
    format: Format,
) -> Result<u8, Failure> {
    let sections = &asked.section;
    let of_section = |claim: &Claim| {
        let is = |section: &String| section == claim.section;
        sections.is_empty() || sections.iter().any(is)
    };
    let ids = edition.paper.claims().map(|(_, claim)| claim);
    let ids: Vec<_> = ids.filter(|c| of_section(c)).map(|c| c.id).collect();
    let some = (!sections.is_empty()).then_some(&ids[..]);
    let tried = Tried::asked(edition, some, &asked.now, depth)?;
    let fits = |e: &&Entry| {
        let of = e.judgement.verdict;
        let is = |named: &String| [of.slug(), of.words()].contains(&named.as_str());
        of_section(e.claim) && (asked.verdict.is_empty() || asked.verdict.iter().any(is))
    };
    let listed: Vec<_> = tried.ledger.entries.iter().filter(fits).collect();
    let words = || match listed.is_empty() {
        true => "there is no such claim".to_owned(),
        false => tried.listed(&listed),
    };
    tried.answered(&listed, words, format)
}

/// How the errata are printed, and of what.
#[derive(Args)]
pub(super) struct Errata {
    #[command(flatten)]
    now: Now,
    /// How to print it
    #[arg(long, value_enum, default_value_t = ErrataFormat::Text, conflicts_with_all = ["json", "csv"])]
    format: ErrataFormat,
    /// All that has to be changed, with every trial, instead of the comment of two pages
    #[arg(long, conflicts_with_all = ["json", "csv"])]
    supplement: bool,
    /// Who signs it, in place of "[name, affiliation and address]"
    #[arg(long, value_name = "NAME/AFFILIATION", conflicts_with_all = ["json", "csv"])]
    from: Option<String>,
    /// Where the program can be found, in place of "[address of the code]"
    #[arg(long, value_name = "ADDRESS", conflicts_with_all = ["json", "csv"])]
    code: Option<String>,
}

pub(super) fn print_errata(
    edition: &Edition,
    asked: &Errata,
    depth: &Depth,
    format: Format,
) -> Result<u8, Failure> {
    let (from, code) = (asked.from.as_deref(), asked.code.as_deref());
    if asked.format == ErrataFormat::Json && (asked.supplement || from.or(code).is_some()) {
        return Err("--supplement, --from and --code go with --format text or latex".into());
    }
    let tried = Tried::asked(edition, None, &asked.now, depth)?;
    if tried.stopped {
        return Ok(tried.code());
    }
    let ledger = &tried.ledger;
    let letter = |format: ledger::Format| {
        let sent = match asked.supplement {
            true => ledger.supplement(format),
            false => ledger.letter(format),
        };
        sent.map(|sent| format.signed(sent, from, code))
    };
    match (asked.format, format) {
        (ErrataFormat::Json, _) | (_, Format::Json) => {
            json(&serde_json::json!({
                "version": VERSION,
                "recorded": tried.version(),
                "errata": ledger.errata()?,
            }))?;
            return Ok(tried.code());
        }
        (_, Format::Csv) => {
            say(&(bom().to_owned() + &book::register(edition, &ledger.errata()?)?))?;
        }
        (ErrataFormat::Latex, _) => say(&letter(ledger::Format::Latex)?)?,
        (ErrataFormat::Text, _) => shown(&letter(ledger::Format::Text)?)?,
    }
    tried.note();
    Ok(tried.code())
}

fn table(entries: &[&Entry]) -> Result<(), Failure> {
    let headers = [
        "id",
        "section",
        "equation",
        "kind",
        "verdict",
        "formula",
        "routes",
        "points",
        "worst",
        "tolerance",
    ];
    let row = |entry: &&Entry| {
        let (claim, worst) = (entry.claim, entry.worst());
        let number = |x: Option<f64>| x.map_or(String::new(), plain);
        vec![
            claim.id.to_owned(),
            claim.section.to_owned(),
            claim.equation.map_or(String::new(), |n| n.to_string()),
            claim.kind.name().to_owned(),
            entry.judgement.verdict.slug().to_owned(),
            claim.plain.to_owned(),
            entry.routes(),
            entry.points().to_string(),
            number(worst.map(|e| e.worst)),
            number(worst.map(|e| e.tolerance.value)),
        ]
    };
    csv(&headers, entries.iter().map(row))
}

/// How many claims these are, or all.
fn wanted(paper: &Paper, ids: Option<&[&str]>) -> usize {
    let all = || paper.claims().count();
    ids.map_or_else(all, <[_]>::len)
}

/// Tries claims with a progress bar, which shows on a terminal only.
fn with_progress(paper: &'static Paper, ids: Option<&[&str]>) -> Ledger {
    let length = wanted(paper, ids) as u64;
    let bar = progress(length, "{bar:40} {pos}/{len} claims  {msg}");
    let done = |claim: &Claim| {
        bar.set_message(claim.id);
        // Neighbours are tried too where a verdict may rest on theirs.
        if ids.is_none_or(|ids| ids.contains(&claim.id)) {
            bar.inc(1);
        }
    };
    let ledger = match ids {
        Some(ids) => Ledger::try_some(paper, ids, done),
        None => Ledger::try_all(paper, done),
    };
    bar.finish_and_clear();
    ledger
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::ledger::example;

    #[test]
    fn a_difference_names_what_is_recorded_and_what_is_found() {
        let (right, wrong) = (Some(Verdict::Confirmed), Some(Verdict::Misprint));
        for (recorded, found, named, said) in [
            (
                right,
                wrong,
                r#""recorded":"confirmed","found":"misprint""#,
                "confirmed, found misprint",
            ),
            (
                None,
                right,
                r#""recorded":null,"found":"confirmed""#,
                "no such claim, found confirmed",
            ),
        ] {
            let id = "eq-8".to_owned();
            let differences = vec![Difference {
                id,
                recorded,
                found,
            }];
            let tried = Tried {
                ledger: example::ledger(),
                rounds: 1,
                differences,
                recorded: None,
                stopped: false,
            };
            let rows = serde_json::to_string(&tried.rows(&[], None)).unwrap();
            assert!(
                rows.contains(&format!(r#"[{{"id":"eq-8",{named}}}]"#)),
                "{rows}"
            );
            let said = format!("eq-8: recorded as {said}\n");
            assert!(tried.text().contains(&said), "{}", tried.text());
            assert_eq!(tried.code(), 1);
        }
    }

    /// Also where the record lacks a claim. What is not asked for counts only where everything is.
    #[test]
    fn each_command_that_tries_claims_tells_of_a_difference_by_its_exit_code() {
        let codes = |kept: &str| {
            let record = crate::data::Text::Built(kept.to_owned().leak());
            let paper: &'static Paper = Box::leak(Box::new(Paper {
                record,
                topics: example::PAPER.topics,
                ..Paper::BLANK
            }));
            let (edition, csv) = (Edition::of("example", paper), Format::Csv);
            let depth = Depth::ONCE;
            let [ids, misprint, second] = ["eq-8", "misprint", "2"].map(|word| [word.to_owned()]);
            let listed = |verdict: &[String], section: &[String], now| {
                let asked = List {
                    verdict: verdict.to_vec(),
                    section: section.to_vec(),
                    now: Now { now },
                };
                list(&edition, &asked, &depth, csv)
            };
            [
                verify(&edition, &ids, &depth, csv),
                show(&edition, &ids, &depth, csv),
                listed(&[], &second, true),
                listed(&misprint, &second, true),
                verify(&edition, &[], &depth, csv),
                listed(&misprint, &[], true),
                super::record(paper, "2026-01-01", &depth),
                // Where the verdicts alone are recorded, it tries too.
                listed(&[], &[], false),
            ]
            .map(Result::unwrap)
        };
        let all = Record::text_of(&example::ledger());
        let own = "eq-8: confirmed\n";
        assert!(all.contains(own));
        assert_eq!(codes(&all), [0; 8]);
        assert_eq!(codes(&all.replace(own, "eq-8: refuted\n")), [1; 8]);
        assert_eq!(codes(&all.replace(own, "")), [1; 8]);
        let more = all + "eq-99: confirmed\n";
        assert_eq!(codes(&more), [0, 0, 0, 0, 1, 1, 1, 1]);
    }
}
