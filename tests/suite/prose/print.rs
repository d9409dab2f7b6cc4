//! Each numbered equation of the paper's LaTeX, and each correction's, is the formula that the code computes with.
//!
//! Left sides and relations are held by their letters against the plain text.

use super::{
    compare::Same,
    corrections,
    printed_part::Library,
    reads::{Held, held},
    words,
};
use slipbook::claims::PAPER;
use slipbook::exact::latex::statements;
use std::collections::BTreeSet;

fn failures(texts: &[Held], measured: &mut Vec<&'static str>) -> Vec<String> {
    let library = Library::new();
    let mut failures = Vec::new();
    for held in texts {
        let at = &held.at;
        if held.lines.is_empty() && (!held.corrected || held.latex.contains('=')) {
            failures.push(format!(
                "{at} is held against nothing: say which part is which formula"
            ));
        }
        for line in &held.lines {
            match library.hold(held.latex, line) {
                Ok(same) if same.contains(&Same::Measured) => measured.push(held.id),
                Ok(_) => {}
                Err(why) => failures.push(format!("{at}, {}: {why}", line.formulas)),
            }
        }
        if !held.says(held.latex) {
            failures.push(format!("{at} reads otherwise in plain text"));
        }
    }
    failures
}

#[test]
fn every_printed_equation_is_the_formula_of_the_code() {
    let (texts, mut failures) = held(&Library::new(), false);
    let mut measured = Vec::new();
    failures.extend(self::failures(&texts, &mut measured));
    assert!(failures.is_empty(), "{failures:#?}");
    // The square of a vector's size, which is a root, is known to the ring by no rule.
    assert_eq!(measured, ["eq-106"]);
}

#[test]
fn every_formula_with_a_number_is_held_or_part_of_one_that_is() {
    let library = Library::new();
    let [printed, right] = [false, true].map(|corrected| held(&library, corrected).0);
    let formulas = |texts: &[Held]| -> BTreeSet<&str> {
        let lines = texts.iter().flat_map(|held| &held.lines);
        lines
            .flat_map(|line| line.formulas.split([' ', '.']))
            .collect()
    };
    let of_print = formulas(&printed);
    let all = library.formulas.iter();
    let open: Vec<&str> = all
        .map(|formula| formula.name)
        .filter(|name| name.starts_with("eq") && !of_print.contains(name))
        .collect();
    // Both stand in eq143_psi.
    assert_eq!(open, ["eq143_exponent", "eq143_constant"]);
    let of_right = formulas(&right);
    let idle = corrections::joined().into_iter().filter(|formula| {
        !of_right
            .iter()
            .any(|name| formula.path.ends_with(&format!("::{name}")))
    });
    let idle: Vec<_> = idle.map(|formula| formula.path).collect();
    assert!(
        idle.is_empty(),
        "no claim reads what corrections.rs joins: {idle:?}"
    );
}

#[test]
fn every_correction_is_the_formula_of_the_code() {
    let (texts, mut failures) = held(&Library::new(), true);
    failures.extend(self::failures(&texts, &mut Vec::new()));
    assert!(failures.is_empty(), "{failures:#?}");
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
