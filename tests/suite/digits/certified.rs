//! The certified numbers against those of a foreign program, to the last of a thousand decimals.

use super::vectors::rows;
use slipbook::claims::PAPER;

#[test]
fn every_certified_number_has_its_thousand_decimals() {
    let mut known = Vec::new();
    rows("certified", usize::MAX, |row| {
        let name = row.text("name");
        let value = PAPER
            .value(name)
            .unwrap_or_else(|| panic!("no value {name}"));
        for (column, digits) in [("fifty", 50), ("thousand", 1000)] {
            let found = value.decimal(digits).unwrap();
            assert_eq!(found, row.text(column), "{name} to {digits} decimals");
        }
        known.push(name.to_owned());
    });
    let mut all: Vec<_> = PAPER
        .values()
        .filter(|value| value.enclosure.is_some())
        .map(|value| value.id)
        .collect();
    all.sort_unstable();
    known.sort_unstable();
    assert_eq!(known, all);
}
