//! The record of what the kernel has accepted, made of what `coqc` prints.

use super::source::{Item, Sources};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::{self, Write};

/// What a theorem speaks of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, serde::Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Speaks {
    /// Of motions: of what moves by Newton's law with friction.
    Motion,
    /// Of numbers, with a bound that the kernel has computed.
    Bound,
    /// Of formulas.
    Identity,
}

impl Speaks {
    const ALL: [Self; 3] = [Self::Motion, Self::Bound, Self::Identity];

    /// The word.
    pub fn word(self) -> &'static str {
        match self {
            Self::Motion => "motion",
            Self::Bound => "bound",
            Self::Identity => "identity",
        }
    }
}

/// A theorem that the kernel has accepted.
#[derive(Debug, Clone, PartialEq, serde::Serialize)]
pub struct Accepted {
    /// Its name.
    pub name: String,
    /// Its file.
    pub file: String,
    /// What it speaks of.
    pub speaks: Speaks,
    /// Whether it is shown that its hypotheses can be met.
    pub occurs: bool,
    /// On what it rests beside the logic: `classical reals`, `primitive integers`, and by name whatever else.
    pub axioms: Vec<String>,
    /// How long it took, in seconds.
    pub seconds: f64,
    /// The [mark](Sources::mark) of what was accepted.
    #[serde(skip)]
    pub mark: u64,
    /// The statement, as `coqc` prints it.
    pub statement: String,
}

const CLASSICAL: [&str; 4] = [
    "sig_not_dec",
    "sig_forall_dec",
    "functional_extensionality_dep",
    "classic",
];
const INTEGERS: [&str; 2] = ["PrimInt63.", "Uint63."];
/// The names of both.
pub const AXIOMS: [&str; 2] = ["classical reals", "primitive integers"];

impl fmt::Display for Accepted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            name,
            file,
            occurs,
            seconds,
            mark,
            ..
        } = self;
        let (word, axioms) = (self.speaks.word(), self.axioms.join(" + "));
        let occurs = if *occurs { "occurs" } else { "" };
        writeln!(
            f,
            "{name}; {file}; {word}; {occurs}; {axioms}; {seconds:.1} s; {mark:016x}"
        )?;
        for line in self.statement.lines() {
            writeln!(f, "  {line}")?;
        }
        Ok(())
    }
}

/// Reads a record; a line that is none is an error.
///
/// # Errors
/// The line.
pub fn read(text: &str) -> Result<Vec<Accepted>, String> {
    let mut all: Vec<Accepted> = Vec::new();
    for line in text.lines() {
        match (line.strip_prefix("  "), all.last_mut()) {
            (Some(said), Some(last)) => {
                let line = if last.statement.is_empty() { "" } else { "\n" };
                last.statement += &format!("{line}{said}");
            }
            _ => all.push(
                head(line)
                    .ok_or_else(|| format!("the record of theorems has the line {line:?}"))?,
            ),
        }
    }
    Ok(all)
}

fn head(line: &str) -> Option<Accepted> {
    let cells: Vec<_> = line.split("; ").collect();
    let [name, file, speaks, occurs, axioms, seconds, mark] = cells[..] else {
        return None;
    };
    Some(Accepted {
        name: name.to_owned(),
        file: file.to_owned(),
        speaks: Speaks::ALL.into_iter().find(|of| of.word() == speaks)?,
        occurs: occurs == "occurs",
        axioms: axioms
            .split(" + ")
            .filter(|axiom| !axiom.is_empty())
            .map(str::to_owned)
            .collect(),
        seconds: seconds.strip_suffix(" s")?.parse().ok()?,
        mark: u64::from_str_radix(mark, 16).ok()?,
        statement: String::new(),
    })
}

const NEXT: &str = "== ";
const ALL: &str = "=== ";

/// A file that asks `coqc` for the statements of these theorems and for what they rest on. A question takes a
/// second, so theorems not recorded to compute are asked together, each said to rest on all: too much, never
/// too little.
pub fn questions(sources: &Sources, theorems: &[&Item], before: &[Accepted]) -> String {
    let path = |item: &Item| {
        format!(
            "Slipbook.{}.{}",
            item.file.trim_end_matches(".v").replace('/', "."),
            item.name
        )
    };
    let (computing, others): (Vec<&Item>, Vec<&Item>) = theorems.iter().partition(|item| {
        let mut recorded = before.iter().filter(|accepted| accepted.name == item.name);
        let plain = recorded.any(|accepted| accepted.axioms.iter().all(|a| a == AXIOMS[0]));
        !plain && sources.requires(&item.file, "Interval")
    });
    let files: BTreeSet<_> = theorems
        .iter()
        .map(|item| item.file.trim_end_matches(".v").replace('/', "."))
        .collect();
    let mut asked =
        String::from("Require Import Reals.\nFrom Coquelicot Require Import Coquelicot.\n");
    for file in files {
        let _ = writeln!(asked, "Require Slipbook.{file}.");
    }
    asked += "From Slipbook Require Import Motion.\nOpen Scope R_scope.\nSet Printing Width 110.\n";
    for item in theorems {
        let _ = writeln!(
            asked,
            "Goal True. idtac \"{NEXT}{}\". Abort.\nCheck @{}.",
            item.name,
            path(item)
        );
    }
    for (i, group) in computing
        .into_iter()
        .map(|item| vec![item])
        .chain([others])
        .enumerate()
    {
        let names: Vec<_> = group.iter().map(|item| item.name.as_str()).collect();
        let all: Vec<_> = group
            .iter()
            .map(|item| format!("@{}", path(item)))
            .collect();
        let _ = writeln!(
            asked,
            "Goal True. idtac \"{ALL}{}\". Abort.\nDefinition all_{i} := ({}, tt).\nPrint Assumptions all_{i}.",
            names.join(" "),
            all.join(", ")
        );
    }
    asked
}

/// The record by what `coqc` has answered, and for each file what `-time` prints.
///
/// # Errors
/// What is missing in the answers.
pub fn made(
    sources: &Sources,
    answers: &str,
    times: &BTreeMap<String, String>,
    before: &[Accepted],
) -> Result<Vec<Accepted>, String> {
    let (statements, rests) = answers.split_at(answers.find(ALL).unwrap_or(answers.len()));
    let mut axioms: BTreeMap<&str, Vec<String>> = BTreeMap::new();
    for group in rests.split(ALL).skip(1) {
        let (names, list) = group.split_once('\n').unwrap_or((group, ""));
        let own = list
            .split_once("Axioms:")
            .map_or(Vec::new(), |(_, list)| axioms_of(list));
        axioms.extend(names.split(' ').map(|name| (name, own.clone())));
    }
    let mut all = Vec::new();
    for answer in statements.split(NEXT).skip(1) {
        let (name, said) = answer.split_once('\n').unwrap_or((answer, ""));
        let none = || format!("no answer for {name}");
        let item = sources.proved(name).ok_or_else(none)?;
        let (_, statement) = said.split_once(" : ").ok_or_else(none)?;
        let margin = statement
            .lines()
            .skip(1)
            .filter(|line| !line.trim().is_empty());
        let margin = margin
            .map(|line| line.len() - line.trim_start().len())
            .min()
            .unwrap_or_default();
        let lines = statement
            .trim_end()
            .lines()
            .map(|line| match line.starts_with(' ') {
                true => &line[margin..],
                false => line,
            });
        let statement = lines.collect::<Vec<_>>().join("\n");
        let axioms = axioms.get(name).ok_or_else(none)?.clone();
        let mark = sources.mark(item);
        let known = before
            .iter()
            .find(|old| old.name == name && old.mark == mark);
        let took = || {
            times
                .get(&item.file)
                .map_or(0.0, |text| seconds(text, item.span))
        };
        all.push(Accepted {
            name: name.to_owned(),
            file: item.file.clone(),
            speaks: speaks(sources, item, &axioms),
            occurs: sources.items.iter().any(|other| {
                other.name == format!("{name}__occurs")
                    && other.text.ends_with(&format!("ltac:(occurs {name})"))
            }),
            // A time that is measured anew is no news.
            seconds: known.map_or_else(took, |old| old.seconds),
            axioms,
            mark,
            statement,
        });
    }
    Ok(all)
}

fn speaks(sources: &Sources, item: &Item, axioms: &[String]) -> Speaks {
    let moves = |i: &usize| sources.items[*i].word == "Record";
    if sources.behind(item).iter().any(moves) {
        Speaks::Motion
    } else if axioms.iter().any(|axiom| axiom == AXIOMS[1]) {
        Speaks::Bound
    } else {
        Speaks::Identity
    }
}

fn axioms_of(list: &str) -> Vec<String> {
    let names = list.lines().filter(|line| !line.starts_with(' '));
    let names = names.filter_map(|line| line.split_whitespace().next());
    let short = |name: &str| {
        let own = name.rsplit('.').next().unwrap_or(name);
        if CLASSICAL.contains(&own) {
            AXIOMS[0].to_owned()
        } else if INTEGERS.iter().any(|of| name.starts_with(of)) {
            AXIOMS[1].to_owned()
        } else {
            name.to_owned()
        }
    };
    let all: BTreeSet<_> = names.map(short).collect();
    all.into_iter().collect()
}

/// By lines `Chars 12 - 40 [Lemma~x] 0.01 secs (…)`.
fn seconds(times: &str, [from, to]: [usize; 2]) -> f64 {
    let of_line = |line: &str| {
        let mut words = line.strip_prefix("Chars ")?.split(' ');
        let (at, took) = (
            words.next()?.parse::<usize>().ok()?,
            line.rsplit_once("] ")?.1.split(' ').next()?,
        );
        (from..to)
            .contains(&at)
            .then_some(took.parse::<f64>().ok()?)
    };
    times.lines().filter_map(of_line).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    const FILE: &str = "Record motion (v : R) := {}.\nTheorem eq_1 v : motion v -> 0 <= v. Proof. auto. Qed.\nLemma eq_1__occurs : ltac:(occurs eq_1). Proof. auto. Qed.\n\
        Theorem eq_2 : 0 < 1. Proof. lra. Qed.\n";

    #[test]
    fn a_record_is_read_as_it_was_written() {
        let sources = Sources::read([("A.v", FILE)].into_iter());
        let theorems: Vec<_> = sources
            .items
            .iter()
            .filter(|item| item.word == "Theorem")
            .collect();
        let asked = questions(&sources, &theorems, &[]);
        assert!(asked.contains("Check @Slipbook.A.eq_2.") && asked.contains("Require Slipbook.A."));
        let answers = "== eq_1\neq_1\n     : forall v : R,\n       motion v ->\n         0 <= v\n== eq_2\neq_2\n     : 0 < 1\n\
            === eq_2\nall_0 = x\nAxioms:\nUint63.add_spec : x\nMine.odd : False\n=== eq_1\nAxioms:\nClassicalDedekindReals.sig_not_dec : forall P\n  more\n";
        let times = [(
            "A.v".to_owned(),
            format!(
                "Chars {} - 99 [Theorem~eq_1] 1.25 secs (1.2u)\nChars 1 - 2 [Record] 9. secs (0u)\n",
                FILE.find("Theorem").unwrap()
            ),
        )];
        let made = made(&sources, answers, &times.into(), &[]).unwrap();
        assert_eq!(made[0].statement, "forall v : R,\nmotion v ->\n  0 <= v");
        assert_eq!(
            (made[0].speaks, made[0].occurs, made[0].seconds),
            (Speaks::Motion, true, 1.25)
        );
        assert_eq!(made[0].axioms, AXIOMS[..1]);
        assert_eq!((made[1].speaks, made[1].occurs), (Speaks::Bound, false));
        assert_eq!(made[1].axioms, ["Mine.odd", AXIOMS[1]]);
        let text: String = made.iter().map(ToString::to_string).collect();
        let back = read(&text).unwrap();
        assert_eq!(
            back.iter().map(ToString::to_string).collect::<String>(),
            text
        );
        assert!(read("nonsense\n").unwrap_err().contains("nonsense"));
    }
}
