//! The running text: each formula, decimal and count in it is tried, or computed beside it, or listed as one that is not.

mod by_hand;
mod computed;
mod counts;
mod formulas;
mod given;
mod items;
mod letters;
mod numbers;
mod pages;
mod references;

use crate::hold::Library;
use formulas::{Found, Given, found};
use pages::{Block, sections};
use slipbook::claims::by_hand::CASES;
use std::collections::BTreeSet;

/// How the formulas are tried that do not hold as they stand, and those that nothing tries.
const FORMULAS: &str = include_str!("../../data/formulas.txt");
/// What counts and is not computed.
const COUNTS: &str = include_str!("../../data/counts.txt");

/// What the text refers to, and with which words.
const REFERENCES: &str = include_str!("../../data/references.txt");

/// The formulas of a paragraph, on one line each.
fn formulas_of(paragraph: &str) -> Vec<String> {
    let formulas = paragraph.split('$').skip(1).step_by(2);
    let flat = |formula: &str| formula.split_whitespace().collect::<Vec<_>>().join(" ");
    formulas.map(flat).collect()
}

/// All formulas of the pages: page, formula, and what is to be said of it where it stands.
fn formulas() -> Vec<(String, String, Option<Found>)> {
    let mut all = Vec::new();
    for section in sections() {
        for block in &section.blocks {
            let Block::Prose(text) = block else { continue };
            for paragraph in text.split("\n\n") {
                let mut given = Given::new();
                for formula in formulas_of(paragraph) {
                    let what = found(&formula, &mut given);
                    all.push((section.page.clone(), formula, what));
                }
            }
        }
    }
    all
}

/// Whether something may be wrong with a formula that relates nothing: it has an operator or a number.
fn says_something(formula: &str) -> bool {
    formula.contains(|c: char| c.is_ascii_digit() && c != '0' || "+-/^".contains(c))
        && !formula
            .trim_end_matches(|c: char| c.is_ascii_digit() || "{}c".contains(c))
            .ends_with('_')
}

/// The entries of the table: page, how it is tried, formula.
fn entries() -> Vec<(&'static str, &'static str, &'static str)> {
    let mut page = "";
    let mut entries = Vec::new();
    for line in FORMULAS.lines() {
        if let Some(next) = line.strip_prefix("# ") {
            page = next;
        } else if let Some((how, formula)) = line.split_once(" => ") {
            entries.push((page, how, formula));
        }
    }
    entries
}

#[test]
fn every_formula_in_the_text_is_tried_or_listed() {
    let (library, entries) = (Library::new(), entries());
    let mut used = BTreeSet::new();
    let mut failures = Vec::new();
    for (page, formula, what) in formulas() {
        match what {
            Some(Found::Holds) => continue,
            Some(Found::Wrong(why)) => failures.push(format!("{page}: {formula}: {why}")),
            None if !says_something(&formula) => continue,
            _ => {}
        }
        let place = |(of, _, listed): &(&str, &str, &str)| *of == page && *listed == formula;
        match entries.iter().position(place) {
            Some(entry) => drop(used.insert(entry)),
            None => failures.push(format!("{page}: nothing tries {formula}")),
        }
    }
    for (i, (page, how, formula)) in entries.iter().enumerate() {
        if !used.contains(&i) {
            failures.push(format!("{page}: listed, but not there: {formula}"));
        }
        if !given::NOT_TRIED.contains(how)
            && let Err(why) = given::hold(&library, how, formula)
        {
            failures.push(format!("{page}: {formula} where {how}: {why}"));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn a_slip_in_a_formula_that_is_tried_is_seen() {
    let library = Library::new();
    let tried = entries()
        .into_iter()
        .filter(|(_, how, _)| !given::NOT_TRIED.contains(how));
    for (page, how, formula) in tried {
        let formula = formula.trim_end_matches(['.', ',', ' ', ':']);
        let slip = format!("{formula}+1");
        assert!(given::hold(&library, how, &slip).is_err(), "{page}: {slip}");
    }
}

#[test]
fn every_decimal_in_the_text_stands_in_the_code_beside_it() {
    let failures: Vec<String> = sections().iter().flat_map(numbers::unvouched).collect();
    assert!(
        failures.is_empty(),
        "numbers from nowhere:\n{}",
        failures.join("\n")
    );
}

#[test]
fn every_count_in_the_text_is_computed_or_listed() {
    let mut failures = Vec::new();
    let mut used = BTreeSet::new();
    for section in sections() {
        let listed = counts::listed(COUNTS, &section.page);
        let mut of_page = Vec::new();
        failures.extend(counts::uncounted(&section, &listed, &mut of_page));
        used.extend(of_page.into_iter().map(|i| listed[i]));
    }
    let all = COUNTS.lines().skip_while(|line| !line.starts_with('#'));
    failures.extend(
        all.clone()
            .filter(|line| !counts::is_well_listed(line))
            .map(|line| format!("not to be listed so: {line}")),
    );
    let all = all.filter_map(counts::row).filter(|(by, _)| *by != "value");
    failures.extend(
        all.filter(|row| !used.contains(row))
            .map(|row| format!("listed, but not there: {row:?}")),
    );
    let text = |page: &str| -> String {
        let sections = sections()
            .into_iter()
            .filter(|section| section.page == page);
        let blocks = sections.flat_map(|section| section.blocks);
        blocks.fold(String::new(), |all, block| match block {
            Block::Prose(text) => all + &counts::flat(&text).replace('\n', " "),
            Block::Code(_) => all,
        })
    };
    for (page, words, count) in computed::COMPUTED {
        let words = words.replace("{}", &count());
        if !text(page).contains(&words) {
            failures.push(format!("{page}: it should say \"{words}\""));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn every_list_is_as_long_as_the_page_says() {
    let mut failures = Vec::new();
    for (page, text) in pages::pages() {
        let listed = counts::listed(COUNTS, &page);
        for (how, words) in listed {
            if items::LISTS.contains(&how)
                && let Some(why) = items::miscounted(&text, how, words)
            {
                failures.push(format!("{page}: {words}: {why}"));
            }
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn the_arithmetic_of_the_cases_by_hand_is_right() {
    let mut failures = Vec::new();
    for case in &CASES {
        for text in [case.reason.to_owned(), case.words().unwrap()] {
            // A name that is given twice may mean the first or the last.
            let (mut given, mut first) = (Given::new(), Given::new());
            for formula in formulas_of(&text) {
                let last = found(&formula, &mut given);
                let by_first = found(&formula, &mut Given::with(first.clone()));
                first.complete(&given);
                if let (Some(Found::Wrong(why)), Some(Found::Wrong(_))) = (last, by_first) {
                    failures.push(format!("{}: {formula}: {why}", case.claim));
                }
            }
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn every_value_in_the_text_stands_where_it_is_listed() {
    let mut failures = Vec::new();
    for (page, text) in pages::one_line() {
        let listed = counts::listed(COUNTS, &page);
        let values = listed.iter().filter(|(by, _)| *by == "value");
        let left = values.fold(text, |left, (_, words)| left.replace(words, ""));
        for open in ["{{value ", "{{count "] {
            let rest = left
                .split(open)
                .skip(1)
                .filter_map(|rest| rest.split("}}").next());
            failures.extend(rest.map(|name| format!("{page}: {open}{name}}}}}")));
        }
    }
    assert!(
        failures.is_empty(),
        "not where they are listed:\n{}",
        failures.join("\n")
    );
}

#[test]
fn every_reference_stands_with_the_words_that_are_listed() {
    let mut failures = Vec::new();
    for (page, text) in pages::with_code() {
        let listed = counts::listed(REFERENCES, &page);
        let mut left: Vec<&str> = listed.iter().map(|(_, words)| *words).collect();
        for words in references::around(&text) {
            match left.iter().position(|known| *known == words) {
                Some(i) => drop(left.remove(i)),
                None => failures.push(format!("{page}: text: {words}")),
            }
        }
        let gone = left.into_iter();
        failures.extend(gone.map(|words| format!("{page}: listed, but not there: {words}")));
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
