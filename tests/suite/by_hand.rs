//! The two numbers of each case by hand, worked out once more.

use crate::prose::pencil;
use slipbook::claims::PAPER;
use trialbook::trials::by_hand::Numbers;

#[test]
fn every_case_shows_a_difference() {
    for (claim, case) in PAPER.cases() {
        let Numbers { stated, found, .. } = case.computed;
        let (stated, found) = (stated().unwrap(), found().unwrap());
        let step = 0.1_f64.powi(case.digits as i32);
        assert!(
            (stated - found).abs() > 3.0 * step || case.digits == 0 && stated != found,
            "{}: {stated}, {found}",
            claim.id
        );
        let words = case.words().unwrap();
        assert!(!words.contains("{stated}") && !words.contains("{found}"));
        assert_eq!(words.matches('$').count() % 2, 0, "{words}");
    }
}

#[test]
fn the_two_numbers_of_a_case_are_those_of_pencil_and_paper() {
    let mut failures = Vec::new();
    for (claim, case) in PAPER.cases() {
        let id = claim.id;
        let [stated, found] = case.pencil.map(|said| pencil(id, said));
        let [left, right] = case.numbers().unwrap();
        let places = case.digits;
        let by_hand = [stated, found].map(|x| format!("{x:.places$}"));
        if by_hand != [left.clone(), right.clone()] {
            failures.push(format!(
                "{id}: by `pencil` {by_hand:?}, by formula and motion {left}, {right}"
            ));
        }
        let words = case.words().unwrap();
        if words.len() <= 100 || words.contains(['{', '}']) && !words.contains('$') {
            failures.push(format!("{id}: {words}"));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
