//! What pages say of files that the package does not have, `src/edition/words/counted.rs`; and what captions say in digits.

use super::{decimals::decimals, drawn::FIGURES};
use slipbook::claims::PAPER;
use slipbook::edition::EDITION;
use std::f64::consts::{PI, SQRT_2};
use std::fs::read_to_string;

#[test]
fn files_are_as_the_pages_have_them() {
    let equations = |example: &str| {
        let example = read_to_string(format!("trialbook/examples/{example}")).unwrap();
        let paper = example.split("mod corrected").next().unwrap();
        (1..100)
            .filter(|n| paper.contains(&format!("pub fn eq{n}_")))
            .count()
    };
    let certified = read_to_string("tests/data/digits/certified.csv").unwrap();
    let long = certified
        .lines()
        .skip(1)
        .map(|row| row.rsplit_once('.').unwrap().1.len());
    for (name, is) in [
        ("equations-of-the-stone", equations("fall.rs")),
        ("equations-of-drag", equations("drag/main.rs")),
        ("decimals-of-mpmath", long.min().unwrap() / 1000 * 1000),
    ] {
        let word = EDITION
            .words
            .iter()
            .copied()
            .flatten()
            .find(|word| word.name == name);
        assert_eq!((word.expect(name).is)().unwrap(), is as f64, "{name}");
    }
}

#[test]
fn every_decimal_in_a_caption_is_one_of_its_numbers() {
    let mut failures = Vec::new();
    for figure in FIGURES.iter() {
        let cells = figure.csv.split(['\n', ',']);
        let mut known: Vec<f64> = cells.filter_map(|cell| cell.parse().ok()).collect();
        known.extend(PAPER.values().filter_map(|value| value.number().ok()));
        known.extend([2.0, SQRT_2, PI, 4.0 * PI]);
        let drawn: Vec<_> = figure
            .svg
            .split(|c: char| !(c.is_ascii_digit() || c == '.'))
            .collect();
        for number in decimals(&format!("{} {}", figure.caption, figure.alt)) {
            let places = number.len() - number.find('.').unwrap() - 1;
            let is = |value: &f64| format!("{:.places$}", value.abs()) == number;
            if !known.iter().any(is) && !drawn.contains(&number) {
                failures.push(format!("{}: {number}", figure.id));
            }
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
