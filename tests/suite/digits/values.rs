//! The numbers that are known, and the search for them, against forty digits.

use super::{cases, vectors::rows};
use slipbook::claims::{PAPER, values::search};
use slipbook::motion::turntable::{critical_radius, critical_speed};
use std::collections::BTreeSet;

#[test]
fn every_known_number_has_its_digits() {
    let mut known = BTreeSet::from(["boundary", "kappa-solid"].map(str::to_owned));
    for (table, column) in [
        ("certified", "name"),
        ("constants", "name"),
        ("values", "id"),
    ] {
        rows(table, usize::MAX, |row| {
            known.insert(row.text(column).to_owned());
        });
    }
    let values: BTreeSet<_> = PAPER.values().map(|value| value.id.to_owned()).collect();
    assert_eq!(values, known);
    rows("values", usize::MAX, |row| {
        let (id, exact) = (row.text("id"), row.text("value"));
        let value = PAPER.value(id).unwrap_or_else(|| panic!("no value {id}"));
        let digits = value.digits().unwrap();
        let decimals = digits.split_once('.').map_or(0, |(_, part)| part.len());
        let whole = exact
            .split_once('.')
            .map_or(exact.len(), |(whole, _)| whole.len());
        // Cut off, or with nines rounded up.
        let cut = &exact[..(whole + 1 + decimals).min(exact.len())];
        let whole_of = |text: &str| text.replace('.', "").parse::<i128>().unwrap();
        let off = (whole_of(&digits) - whole_of(cut)).abs();
        assert!(off <= 1, "{id}: {digits}, right is {exact}");
    });
}

#[test]
fn critical_radius_and_speed_are_those_of_the_foreign_program() {
    let mut found = 0;
    rows("constants", usize::MAX, |row| {
        let value = match row.text("name") {
            "critical-radius" => critical_radius(),
            "critical-speed" => critical_speed(),
            other => panic!("{other}"),
        };
        let exact = row.number("value");
        assert!((value.unwrap() - exact).abs() < 1e-12, "{exact}");
        found += 1;
    });
    assert_eq!(found, 2);
}

#[test]
fn the_first_wrong_digit_is_found() {
    let mut exact: Vec<(String, String)> = Vec::new();
    rows("values", usize::MAX, |row| {
        exact.push((row.text("id").to_owned(), row.text("value").to_owned()));
    });
    let mut rng = fastrand::Rng::with_seed(20);
    let mut wrong = 0;
    for _ in 0..cases(1000) {
        let (id, digits) = &exact[rng.usize(..exact.len())];
        let places: Vec<usize> = (0..digits.len())
            .filter(|i| digits.as_bytes()[*i].is_ascii_digit())
            .skip_while(|i| digits.as_bytes()[*i] == b'0')
            .collect();
        let length = rng.usize(4..=places.len().min(10));
        let mut given: Vec<u8> = digits.as_bytes()[..=places[length - 1]].to_vec();
        // Off by five: no rounding leads there.
        let changed = rng.bool().then(|| rng.usize(3..length));
        if let Some(place) = changed {
            let digit = &mut given[places[place]];
            *digit = b'0' + (*digit - b'0' + 5) % 10;
        }
        let given = String::from_utf8(given).unwrap();
        let matches = search(PAPER.values(), &given).unwrap();
        let own = matches.iter().find(|found| found.name == *id);
        match (changed, own) {
            (None, Some(found)) => assert_eq!(
                (found.right, found.first_wrong),
                (length, None),
                "{id} {given}"
            ),
            (Some(place), Some(found)) => {
                assert_eq!(found.first_wrong, Some(place + 1), "{id} {given}");
                wrong += 1;
            }
            // Another has more of these digits.
            (Some(_), None) => assert!(!matches.is_empty(), "{id} {given}"),
            (None, None) => panic!("{id} {given}"),
        }
    }
    assert!(wrong > 100);
}
