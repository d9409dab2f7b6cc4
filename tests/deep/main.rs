//! The record of the deep run, held against the trials as they are now, but for those that are gone or new since its commit.
//! `.ci/deep records` runs this, `cargo test` alone does not.

mod digits;
mod distrust;
mod fates;

use slipbook::claims::PAPER;
use slipbook::evidence::Outcome;
use slipbook::ledger::{Ledger, deep::Deep};
use std::collections::BTreeMap;
use std::sync::LazyLock;

static LEDGERS: LazyLock<[Ledger; 2]> = LazyLock::new(|| {
    let now = Ledger::try_all(&PAPER, |_| {});
    let record = Deep::read(&PAPER.deep).expect("there is a record of a deep run");
    assert!(record.comparisons >= 10_000_000, "{}", record.comparisons);
    let deep = record.in_place_of(&now);
    [now, deep]
});

#[test]
fn outcomes_and_verdicts_are_those_of_a_usual_run() {
    let [now, deep] = &*LEDGERS;
    let mut compared = 0;
    for (now, deep) in now.entries.iter().zip(&deep.entries) {
        let mut evidence = now.evidence.clone();
        for (i, (key, deep)) in deep.keyed().enumerate() {
            if deep.points > 0 && !deep.route.is_proof() {
                assert!(deep.points >= evidence[i].points, "{key}");
                assert_eq!(deep.outcome(), evidence[i].outcome(), "{key}");
                evidence[i] = deep.clone();
                compared += 1;
            }
        }
        let [usual, deep] = [&now.evidence, &evidence].map(|e| now.claim.judged(e).verdict);
        assert_eq!(deep, usual, "{}", now.claim.id);
    }
    assert!(compared > 0, "no line of the record is of a trial");
}

const SLACK: f64 = 10.0;

/// A tolerance is that of a method, for the hardest case. Each trial has to notice a mistake of twice its tolerance (`.ci/deep
/// distrust`).
#[test]
fn no_tolerance_is_far_looser_than_the_worst_that_it_admits() {
    let [_, deep] = &*LEDGERS;
    let mut worst = BTreeMap::<&str, (f64, f64)>::new();
    let evidence = deep.entries.iter().flat_map(|entry| &entry.evidence);
    for e in evidence.filter(|e| !e.route.is_proof() && e.outcome() == Outcome::Agrees) {
        let (tolerance, so_far) = worst.entry(e.tolerance.name).or_default();
        (*tolerance, *so_far) = (e.tolerance.value, so_far.max(e.worst));
    }
    worst.retain(|_, (tolerance, worst)| *tolerance > SLACK * *worst);
    assert!(
        worst.is_empty(),
        "too loose, each with the worst: {worst:#?}"
    );
}
