//! That the comparison can fail: slips of the pen in the prints, mistakes in the formulas of the code.

use super::{
    compare, meaning,
    mistakes::mistakes,
    printed_part::Library,
    reads::{Held, held},
};
use slipbook::claims::formulas::formulas;
use slipbook::exact::Expr;
use slipbook::seeded::{self, Formula};

/// By the reader; by a formula of the code; by the words alone.
#[derive(Debug, Default, PartialEq)]
struct Noticed {
    not_understood: usize,
    by_formula: usize,
    by_words: usize,
}

impl Noticed {
    fn all(&mut self, library: &Library, held: &Held) -> Vec<String> {
        let lines = &held.lines;
        let mut missed = Vec::new();
        for slip in mistakes(held.latex) {
            if !lines.iter().all(|line| library.reads(&slip, line)) {
                self.not_understood += 1;
            } else if !lines.iter().all(|line| library.agrees(&slip, line)) {
                self.by_formula += 1;
            } else if !held.says(&slip) {
                self.by_words += 1;
            } else {
                missed.push(format!("{} {slip}", held.at));
            }
        }
        missed
    }
}

#[test]
fn every_slip_of_the_pen_is_noticed() {
    let library = Library::new();
    let mut noticed = Noticed::default();
    let mut missed = Vec::new();
    for corrected in [false, true] {
        for held in held(&library, corrected).0 {
            missed.extend(noticed.all(&library, &held));
        }
    }
    println!("{noticed:?}");
    assert!(missed.is_empty(), "{missed:#?}");
}

#[derive(Debug, Default)]
struct Seeded {
    noticed: usize,
    /// With all its values right.
    equivalent: usize,
    missed: Vec<String>,
}

impl Seeded {
    fn seed(&mut self, formula: &Formula<Expr>, agrees: impl Fn() -> bool) {
        let letters: Vec<_> = formula.symbols.iter().map(|s| Expr::symbol(s)).collect();
        let right = meaning::tree(formula);
        for seed in formula.seeds(&letters) {
            if !seeded::with(seed, &agrees) {
                self.noticed += 1;
                continue;
            }
            let wrong = seeded::with(seed, || meaning::tree(formula));
            let mut pairs = right.iter().zip(&wrong);
            if pairs.all(|(a, b)| compare::differ(*a, *b).is_none()) {
                self.equivalent += 1;
            } else {
                self.missed.push(formula.name.to_owned());
            }
        }
    }
}

#[test]
fn every_mistake_in_a_formula_of_the_paper_is_noticed() {
    let library = Library::new();
    let mut all = Seeded::default();
    for held in held(&library, false).0 {
        let Some(number) = held.id.strip_prefix("eq-") else {
            continue;
        };
        for formula in library.numbered(number) {
            let lines = held.lines.iter();
            all.seed(formula, || {
                lines.clone().all(|line| library.agrees(held.latex, line))
            });
        }
    }
    // The first two right sides of (102) stand in lines without a number.
    all.missed.retain(|name| name != "eq102_rate");
    println!("in the paper's formulas: {all:?}");
    assert!(all.missed.is_empty());
}

#[test]
fn every_mistake_in_a_correction_that_is_printed_is_noticed() {
    let library = Library::new();
    let texts = held(&library, true).0;
    let mut all = Seeded::default();
    let (mut printed, mut not_printed) = (0, 0);
    for formula in formulas::<Expr>() {
        let Some(name) = formula.path.strip_prefix("slipbook::corrections::") else {
            continue;
        };
        let lines = texts
            .iter()
            .flat_map(|held| held.lines.iter().map(|line| (held.latex, line)));
        let own_topic = lines.filter(|(_, line)| topic(line.formulas) == topic(name));
        let mut own = Seeded::default();
        own.seed(&formula, || {
            own_topic
                .clone()
                .all(|(latex, line)| library.agrees(latex, line))
        });
        // Some formulas serve another that is printed.
        if own.noticed == 0 {
            not_printed += 1;
        } else {
            printed += 1;
            all.noticed += own.noticed;
            all.equivalent += own.equivalent;
            all.missed.extend(own.missed);
        }
    }
    println!("in the corrections' formulas: {all:?}");
    println!("{printed} are printed, {not_printed} are not");
    assert!(all.missed.is_empty() && printed > 10);
}

fn topic(path: &str) -> Option<&str> {
    path.rsplit("::").nth(1)
}
