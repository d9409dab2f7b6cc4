//! Mistakes are seeded in what the trials read: each trial notices one at least, and what it finds stays where it is.

use libtest_mimic::{Arguments, Failed, Trial};
use slipbook::claims::distrust::{Excuse, IDLE, LEANING};
use slipbook::claims::variants::Variant;
use slipbook::claims::{PAPER, Topic};
use slipbook::evidence::Outcome;
use slipbook::ledger::Ledger;
use slipbook::ledger::distrust::{Extent, Tried};
use std::collections::BTreeSet;
use std::sync::Arc;

fn main() {
    // Each uses all cores.
    let arguments = Arguments {
        test_threads: Some(1),
        ..Arguments::from_args()
    };
    let variants = Arc::new(PAPER.formulas.variants());
    let trial = |topic: &'static Topic| {
        let variants = Arc::clone(&variants);
        Trial::test(topic.stem, move || distrusted(topic, &variants))
    };
    let trials = PAPER.topics.iter().map(trial).collect();
    libtest_mimic::run(&arguments, trials).exit();
}

fn distrusted(topic: &Topic, variants: &[Variant]) -> Result<(), Failed> {
    let ids: Vec<_> = topic.claims.iter().map(|claim| claim.id).collect();
    let ledger = Ledger::try_some(&PAPER, &ids, |_| {});
    let tried = ledger.distrust(variants, Extent::Few, || {});
    let agrees = |t: &Tried| ledger.entries[t.entry].evidence[t.trial].outcome() == Outcome::Agrees;
    let idle = |t: &&Tried| agrees(t) && t.rejected() == 0;
    let leaning = |t: &&Tried| t.leans_on().is_some();
    let named = |t: &Tried| {
        let entry = &ledger.entries[t.entry];
        (entry.claim.id, entry.evidence[t.trial].trial)
    };
    let lists: [(BTreeSet<_>, _); 2] = [
        (tried.iter().filter(idle).map(named).collect(), IDLE),
        (tried.iter().filter(leaning).map(named).collect(), LEANING),
    ];
    let said = ["notice nothing", "find something else"];
    let wrong: Vec<_> = said
        .into_iter()
        .zip(lists)
        .filter_map(|(said, (found, excused))| differ(topic, said, found, excused))
        .collect();
    if wrong.is_empty() {
        return Ok(());
    }
    Err(wrong.join("\n").into())
}

fn differ(
    topic: &Topic,
    said: &str,
    found: BTreeSet<(&'static str, &'static str)>,
    excused: &[Excuse],
) -> Option<String> {
    let of_topic = |id: &str| topic.claims.iter().any(|claim| claim.id == id);
    let excused = excused.iter().filter(|(id, ..)| of_topic(id));
    let excused: BTreeSet<_> = excused.map(|(id, trial, _)| (*id, *trial)).collect();
    let both: Vec<_> = found.symmetric_difference(&excused).collect();
    (!both.is_empty())
        .then(|| format!("{said} without a reason, or have one for nothing: {both:#?}"))
}
