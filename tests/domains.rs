//! What is claimed is claimed of something: for each claim a point, in sixteenths, within what it is stated for, at which all formulas of the
//! paper and of the corrections that it tries have values, by enclosure.

use insta::{Settings, assert_snapshot};
use slipbook::certified::interval::Interval;
use slipbook::claims::corners::DOMAINS;
use slipbook::claims::formulas::formulas;
use slipbook::seeded::Formula;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::path::Path;

/// The range of a symbol in a claim: as stated, else the open unit interval, where the paper's ratios lie.
fn range(claim: &str, letter: &str) -> [f64; 2] {
    let stated = DOMAINS
        .iter()
        .find(|domain| domain.claim == claim && domain.letter == letter);
    stated.map_or([0.0, 1.0], |domain| {
        let low = domain.low.max(domain.high.min(0.0) - 2.0);
        [low, domain.high.min(low + 2.0)]
    })
}

/// The sixteenths strictly within a range.
fn sixteenths([low, high]: [f64; 2]) -> Vec<f64> {
    let all = (-64..=96).map(|n| f64::from(n) / 16.0);
    all.filter(|x| low < *x && *x < high).collect()
}

/// The `n`th choice of a value: another one for each symbol.
fn value(claim: &str, letter: &str, n: usize) -> f64 {
    let among = sixteenths(range(claim, letter));
    let place = letter
        .bytes()
        .fold(n, |place, byte| 7 * place + usize::from(byte));
    among[place % among.len()]
}

/// Whether all components are numbers there.
fn has_value(claim: &str, formula: &Formula<Interval>, n: usize) -> bool {
    let letters = formula.symbols.iter();
    let point: Vec<_> = letters
        .map(|letter| Interval::point(value(claim, letter, n)))
        .collect();
    (formula.value)(&point)
        .into_iter()
        .all(Interval::is_bounded)
}

#[test]
fn every_claim_with_formulas_speaks_of_a_point() {
    let mut of_claim = BTreeMap::<String, Vec<_>>::new();
    for formula in formulas::<Interval>() {
        let claim = formula.claim().unwrap_or_else(|| formula.path.to_owned());
        of_claim.entry(claim).or_default().push(formula);
    }
    let mut record = String::new();
    for (claim, formulas) in &of_claim {
        let there = |n: &usize| formulas.iter().all(|formula| has_value(claim, formula, *n));
        let Some(n) = (0..200).find(there) else {
            let none: Vec<_> = formulas
                .iter()
                .filter(|f| !(0..200).any(|n| has_value(claim, f, n)))
                .map(|f| f.path)
                .collect();
            panic!("{claim}: {none:?}");
        };
        let letters = formulas.iter().flat_map(|formula| &formula.symbols);
        let point: BTreeMap<_, _> = letters
            .map(|letter| (*letter, value(claim, letter, n)))
            .collect();
        let point: Vec<_> = point
            .iter()
            .map(|(letter, x)| format!("{letter} = {x}"))
            .collect();
        writeln!(
            record,
            "{claim}: {} formulas at {}",
            formulas.len(),
            point.join(", ")
        )
        .unwrap();
    }
    let mut settings = Settings::clone_current();
    settings.set_snapshot_path(Path::new(env!("CARGO_MANIFEST_DIR")).join("snapshots"));
    settings.set_prepend_module_to_snapshot(false);
    settings.bind(|| assert_snapshot!("domains", record));
}
