//! The table of mistakes in the physics, beside the list from which the tool in `mutants` makes them.
//!
//! The tool makes them and tries the ledger with each; that takes minutes. This test asks that the table has the whole list,
//! and that each mistake in it changes a verdict.

use std::collections::BTreeSet;
use std::fs;

const TABLE: &str = include_str!("../snapshots/physics.csv");

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
