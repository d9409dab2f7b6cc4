//! Mistakes are seeded in what the trials read: each trial notices one at least, and what it finds stays where it is.

use libtest_mimic::{Arguments, Failed, Trial};
use slipbook::claims::distrust::IDLE;
use slipbook::claims::variants::Variant;
use slipbook::claims::{PAPER, Topic};
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
    let named = |t: &&Tried| {
        let entry = &ledger.entries[t.entry];
        (entry.claim.id, entry.evidence[t.trial].trial)
    };
    let leaning: Vec<_> = tried.iter().filter(|t| t.leans_on().is_some()).collect();
    let leaning: Vec<_> = leaning.iter().map(named).collect();
    let idle = tried.iter().filter(|t| t.agrees && t.rejected() == 0);
    let idle: BTreeSet<_> = idle.map(|t| named(&t)).collect();
    let of_topic = |id: &str| topic.claims.iter().any(|claim| claim.id == id);
    let excused = IDLE.iter().filter(|idle| of_topic(idle.claim));
    let excused: BTreeSet<_> = excused.map(|idle| (idle.claim, idle.trial)).collect();
    let wrong: Vec<_> = idle.symmetric_difference(&excused).collect();
    if leaning.is_empty() && wrong.is_empty() {
        return Ok(());
    }
    Err(format!(
        "notice nothing without a reason, or have one for nothing: {wrong:#?}; find something else: {leaning:#?}"
    )
    .into())
}
