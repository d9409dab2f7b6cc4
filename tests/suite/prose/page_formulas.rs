//! The formulas on the pages: as they stand, and those that hold where something is given, held against the code.

use super::formulas::{Found, Given, found};
use super::given;
use super::mistakes::{mistakes, pieces};
use super::printed_part::Library;
use super::text::{formulas_of, sections};

/// How formulas are tried that do not hold as they stand.
const FORMULAS: &str = include_str!("../../data/formulas.txt");

/// The entries of the table: page, what is given, formula.
fn entries() -> Vec<(&'static str, &'static str, &'static str)> {
    let mut page = "";
    let mut entries = Vec::new();
    for line in FORMULAS.lines() {
        if let Some(next) = line.strip_prefix("# ") {
            page = next;
        } else if let Some((givens, formula)) = line.split_once(" => ") {
            entries.push((page, givens, formula));
        }
    }
    entries
}

/// All formulas of the pages: page, formula, and what is to be said of it where it stands.
fn formulas() -> Vec<(String, String, Option<Found>)> {
    let mut all = Vec::new();
    for section in sections() {
        for paragraph in section.prose().flat_map(|text| text.split("\n\n")) {
            let mut given = Given::new();
            for formula in formulas_of(paragraph) {
                let what = found(&formula, &mut given);
                all.push((section.page.clone(), formula, what));
            }
        }
    }
    all
}

/// How many pieces of two formulas differ, or are in one of them only.
fn distance(a: &str, b: &str) -> usize {
    let [a, b] = [a, b].map(|latex| {
        pieces(latex)
            .into_iter()
            .map(|(_, piece)| piece)
            .filter(|piece| *piece != " ")
            .collect::<Vec<_>>()
    });
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.iter().enumerate() {
        let mut before = std::mem::replace(&mut row[0], i + 1);
        for (j, y) in b.iter().enumerate() {
            let least = (before + usize::from(x != y))
                .min(row[j] + 1)
                .min(row[j + 1] + 1);
            before = std::mem::replace(&mut row[j + 1], least);
        }
    }
    row[b.len()]
}

/// What stands before the first sign of a relation.
fn left(latex: &str) -> Option<&str> {
    Some(latex.split_once(['=', '<', '>'])?.0)
}

/// Whether a formula may be meant to be one that is listed; of a short one that stands there as it is listed, the left side has to be the
/// same, too.
fn is_meant(formula: &str, listed: &str, stands: bool) -> bool {
    let apart = distance(formula, listed);
    match pieces(formula).len().min(pieces(listed).len()) {
        8.. => apart <= 2,
        _ => apart <= 1 && (!stands || left(formula).is_some() && left(formula) == left(listed)),
    }
}

/// What is wrong with a page that has these formulas.
fn failures(
    library: &Library,
    entries: &[(&str, &str, &str)],
    formulas: &[(String, String, Option<Found>)],
) -> Vec<String> {
    let mut failures = Vec::new();
    for (page, formula, what) in formulas {
        if let Some(Found::Wrong(why)) = what {
            failures.push(format!("{page}: {formula}: {why}"));
        }
        let of_page = || entries.iter().filter(|(of, ..)| of == page);
        if matches!(what, Some(Found::Holds | Found::Wrong(_)))
            || of_page().any(|(.., listed)| listed == formula)
        {
            continue;
        }
        let stands = |listed: &str| {
            formulas
                .iter()
                .any(|(of, formula, _)| of == page && formula == listed)
        };
        let near: Vec<_> = of_page()
            .filter(|(.., listed)| is_meant(formula, listed, stands(listed)))
            .collect();
        let holds = near
            .iter()
            .any(|(_, givens, _)| given::hold(library, givens, formula).is_ok());
        if let (Some((.., listed)), false) = (near.first(), holds) {
            failures.push(format!(
                "{page}: {formula} does not hold, which would be {listed}"
            ));
        }
    }
    failures
}

#[test]
fn every_formula_on_a_page_holds() {
    let (library, entries, formulas) = (Library::new(), entries(), formulas());
    let mut failures = failures(&library, &entries, &formulas);
    let mut there = 0;
    for (page, givens, formula) in &entries {
        if formulas
            .iter()
            .any(|(of, found, _)| of == page && found == formula)
        {
            there += 1;
        } else {
            println!("{page}: it no longer says {formula}");
        }
        if let Err(why) = given::hold(&library, givens, formula) {
            failures.push(format!("{page}: {formula} where {givens}: {why}"));
        }
    }
    println!("{there} of {} formulas are still there", entries.len());
    assert!(
        failures.is_empty() && 2 * there > entries.len(),
        "{}",
        failures.join("\n")
    );
}

#[test]
fn a_slip_in_a_formula_is_seen() {
    let (library, entries, formulas) = (Library::new(), entries(), formulas());
    for (page, givens, formula) in &entries {
        let formula = formula.trim_end_matches(['.', ',', ' ', ':']);
        let slip = format!("{formula}+1");
        assert!(
            given::hold(&library, givens, &slip).is_err(),
            "{page}: {slip}"
        );
    }
    // On a page, in the place of the formula. What is left out after dots or in an order, nothing tries.
    let (mut seen, mut all) = (0, 0);
    for (page, formula, _) in &formulas {
        let listed = |formula: &str| {
            entries
                .iter()
                .any(|(of, _, listed)| of == page && *listed == formula)
        };
        let slips = mistakes(formula);
        let Some(slip) = slips.last().filter(|slip| listed(formula) && !listed(slip)) else {
            continue;
        };
        let what = found(slip, &mut Given::new());
        let failures = failures(&library, &entries, &[(page.clone(), slip.clone(), what)]);
        if failures.is_empty() {
            println!("{page}: not seen: {slip}");
        }
        seen += usize::from(!failures.is_empty());
        all += 1;
    }
    println!("{seen} of {all} slips on the pages are seen");
    assert!(5 * seen > 4 * all);
}
