//! Each numbered equation of the paper's LaTeX, and each correction's, read into a tree, is the formula that the code computes with.
//!
//! What no formula says, a left side or a relation, is held by its letters against the plain text, which is in the claim's entry
//! or, where it is computed, in its snapshot alone.

use super::{
    compare::Same,
    printed_part::Library,
    table::{self, Line, Place},
    words,
};
use slipbook::claims::PAPER;
use slipbook::exact::latex::statements;
use std::collections::BTreeSet;

/// The numbered equations as printed, by their numbers.
pub fn printed() -> impl Iterator<Item = (&'static str, &'static str)> {
    PAPER
        .claims()
        .filter_map(|(_, claim)| Some((claim.id.strip_prefix("eq-")?, claim.latex)))
}

/// The lines of an equation: its own in the table, else the default.
pub fn lines(library: &Library, number: &'static str) -> Vec<Line> {
    let own = table::PRINTED.iter().filter(|line| line.0 == number);
    let own: Vec<Line> = own.copied().collect();
    match &library.numbered(number)[..] {
        [only] if own.is_empty() => vec![(number, 0, Place::Side(0, 1), only.name, &[])],
        _ => own,
    }
}

/// The lines of a correction.
pub fn corrected(id: &str) -> Vec<Line> {
    let own = table::CORRECTED.iter().filter(|line| line.0 == id);
    own.copied().collect()
}

/// The corrections in LaTeX and plain text, by the ids of the claims.
pub fn corrections() -> impl Iterator<Item = (&'static str, &'static str, &'static str)> {
    PAPER.claims().filter_map(|(_, claim)| {
        let correction = claim.correction?;
        Some((claim.id, correction.latex, correction.plain))
    })
}

/// Whether the letters of an equation are those of its row's plain text.
pub fn in_the_same_words(number: &str, latex: &str) -> bool {
    let printed = words::of_latex(latex);
    if let Some((_, left)) = table::OTHER_WORDS.iter().find(|row| row.0 == number) {
        return printed.starts_with(&words::of_plain(left));
    }
    let (_, claim) = PAPER.find(&format!("eq-{number}")).unwrap();
    // What a constant is, the print says in the text around it.
    let plain = claim.plain.trim_end_matches(", c constant");
    printed == words::of_plain(plain.trim_end_matches(", 𝐜 constant"))
}

#[test]
fn every_printed_equation_is_the_formula_of_the_code() {
    let library = Library::new();
    let mut measured = Vec::new();
    let mut failures = Vec::new();
    for (number, latex) in printed() {
        let lines = lines(&library, number);
        if lines.is_empty() {
            failures.push(format!("({number}) is held against nothing"));
        }
        for line in &lines {
            match library.hold(latex, line) {
                Ok(same) if same.contains(&Same::Measured) => measured.push(number),
                Ok(_) => {}
                Err(why) => failures.push(format!("({number}) {}: {why}", line.3)),
            }
        }
        if !in_the_same_words(number, latex) {
            failures.push(format!("({number}) reads otherwise in plain text"));
        }
    }
    assert!(failures.is_empty(), "{failures:#?}");
    // The square of a vector's size, which is a root, is known to the ring by no rule.
    assert_eq!(measured, ["106"]);
}

#[test]
fn every_formula_with_a_number_is_held_or_part_of_one_that_is() {
    let library = Library::new();
    let lines: Vec<Line> = printed()
        .flat_map(|(number, _)| lines(&library, number))
        .collect();
    let held: BTreeSet<&str> = lines
        .iter()
        .flat_map(|line| line.3.split([' ', '.']))
        .collect();
    let all = library.formulas.iter();
    let open: Vec<&str> = all
        .map(|formula| formula.name)
        .filter(|name| name.starts_with("eq") && !held.contains(name))
        .collect();
    // Both stand in eq143_psi.
    assert_eq!(open, ["eq143_exponent", "eq143_constant"]);
}

#[test]
fn every_correction_is_the_formula_of_the_code() {
    let library = Library::new();
    let mut failures = Vec::new();
    for (id, latex, plain) in corrections() {
        let lines = corrected(id);
        if lines.is_empty() && latex.contains('=') {
            failures.push(format!("{id} is held against nothing"));
        }
        for line in &lines {
            if let Err(why) = library.hold(latex, line) {
                failures.push(format!("{id} {}: {why}", line.3));
            }
        }
        if words::of_latex(latex) != words::of_plain(plain) {
            failures.push(format!("{id} reads otherwise in plain text"));
        }
    }
    assert!(failures.is_empty(), "{failures:#?}");
}

#[test]
fn every_line_of_the_tables_is_of_a_claim() {
    let numbered = table::PRINTED.iter().map(|line| format!("eq-{}", line.0));
    let ids = numbered.chain(table::CORRECTED.iter().map(|line| line.0.to_owned()));
    let known: BTreeSet<_> = PAPER.claims().map(|(_, claim)| claim.id).collect();
    let idle: BTreeSet<_> = ids.filter(|id| !known.contains(&**id)).collect();
    assert!(idle.is_empty(), "lines of table.rs of no claim: {idle:?}");
}

#[test]
fn every_formula_in_the_words_of_a_row_is_understood() {
    let mut failures = Vec::new();
    for (_, claim) in PAPER.claims().filter(|(_, claim)| claim.equation.is_none()) {
        for formula in claim.latex.split('$').skip(1).step_by(2) {
            if let Err(why) = statements(formula) {
                failures.push(format!("{}: {formula}: {why}", claim.id));
            }
        }
        let read = match claim.latex.contains('$') {
            true => words::of_latex(claim.latex),
            false => words::of_plain(claim.latex),
        };
        if read != words::of_plain(claim.plain) {
            failures.push(format!("{} reads otherwise in plain text", claim.id));
        }
    }
    assert!(failures.is_empty(), "{failures:#?}");
}
