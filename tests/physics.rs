//! The table of mistakes in the physics, beside the list from which the tool in `mutants` makes them.
//!
//! The tool makes them and tries the ledger with each; that takes minutes. These tests ask that the table has the whole list,
//! that each mistake in it changes a verdict, and that each trial reacts to one.

use slipbook::claims::PAPER;
use slipbook::evidence::Sides;
use slipbook::ledger::Ledger;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;

const TABLE: &str = include_str!("../snapshots/physics.csv");
const REACTIONS: &str = include_str!("../snapshots/reactions.csv");
const EXCUSES: &str = include_str!("data/reads_no_motion.txt");

#[test]
fn every_mistake_of_the_list_changes_a_verdict() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/mutants/physics");
    let mut listed = BTreeSet::new();
    for file in fs::read_dir(folder).unwrap() {
        let text = fs::read_to_string(file.unwrap().path()).unwrap();
        let names = text.lines().filter_map(|line| line.strip_prefix("= "));
        listed.extend(names.map(str::to_owned));
    }
    let mut made = BTreeSet::new();
    for line in TABLE.lines().skip(1) {
        let name = line.split(',').next().unwrap();
        // The sentence may have commas; what follows it has none.
        let count: usize = line.rsplit(',').nth(2).unwrap().parse().unwrap();
        assert!(count > 0 && made.insert(name.to_owned()), "{line}");
    }
    assert_eq!(made, listed);
    assert!(made.len() >= 60);
}

/// Every measured trial reacts to a mistake in the motion: it comes to another result, or finds something else where it looked. One
/// that does not might have its found side typed by hand, or its stated side taken from what is found. Both, and the scales, are those of the
/// recorded run of the mistakes to the last bit, so that none can be changed afterwards.
#[test]
fn every_trial_reads_the_motion_or_says_what_else() {
    let excuses: BTreeMap<&str, &str> = EXCUSES
        .lines()
        .filter(|line| !line.starts_with('#'))
        .map(|line| line.split_once(": ").unwrap())
        .collect();
    let excuse = |trial: &'static str| {
        let room = trial.split_once("::").map_or("", |(room, _)| room);
        [trial, room]
            .into_iter()
            .find(|name| excuses.contains_key(name))
    };
    let mut used = BTreeSet::new();
    let mut recorded = Vec::new();
    for line in REACTIONS.lines().skip(1) {
        let mut cells = line.rsplitn(3, ',').skip(1);
        let (mistakes, there) = (cells.next().unwrap(), cells.next().unwrap());
        let [id, trial] = [0, 1].map(|n| line.split(',').nth(n).unwrap());
        recorded.push(there.to_owned());
        if mistakes == "0" {
            let excuse = excuse(trial);
            assert!(excuse.is_some(), "{id}: {trial} reacts to no mistake");
            used.extend(excuse);
        }
    }
    let listed: BTreeSet<&str> = excuses.keys().copied().collect();
    assert_eq!(listed, used, "an excuse is needed no more");
    let ledger = Ledger::try_all(&PAPER, |_| {});
    let trials = ledger.entries.iter().flat_map(|entry| {
        let measured = entry.evidence.iter().filter(|e| !e.route.is_proof());
        measured.map(|e| {
            let (id, route) = (entry.claim.id, e.route.name());
            let Sides {
                found,
                stated,
                scale,
            } = e.sides;
            format!(
                "{id},{},{route},{found:016x},{stated:016x},{scale:016x}",
                e.trial
            )
        })
    });
    let (there, recorded): (BTreeSet<_>, BTreeSet<_>) =
        (trials.collect(), recorded.into_iter().collect());
    let other: Vec<_> = there.symmetric_difference(&recorded).collect();
    assert!(
        other.is_empty(),
        "since the mistakes were last tried (mutants, --bin physics), these find something else: {other:#?}"
    );
}
