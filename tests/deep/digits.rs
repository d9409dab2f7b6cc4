//! The record of how many digits the calculators claim and know, each tried with ten thousand cases.

use std::collections::BTreeMap;

#[test]
fn ten_thousand_cases_of_every_calculator_are_recorded() {
    let mut cases: BTreeMap<&str, [usize; 2]> = BTreeMap::new();
    for line in include_str!("../../snapshots/digits.csv").lines().skip(1) {
        let cells: Vec<&str> = line.split(',').collect();
        let [claimed, least, n] = [1, 2, 3].map(|i| cells[i].parse::<usize>().unwrap());
        assert!(claimed <= 15 && least <= 15, "{line}");
        let [all, modest] = cases.entry(cells[0]).or_default();
        *all += n;
        *modest += if claimed + 2 < least { n } else { 0 };
    }
    assert!(!cases.is_empty());
    for (kind, [all, modest]) in cases {
        assert!(
            all >= 9_000 && 10 * modest <= all,
            "{kind}: {all}, {modest}"
        );
    }
}
