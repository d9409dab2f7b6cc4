//! The decimals in the cases by hand, worked out once more.

use super::{
    decimals::decimals,
    formulas::{Found, Given, found, number, read},
    text::{bare, formulas_of},
};
use crate::LEDGER;
use slipbook::claims::PAPER;
use slipbook::exact::latex::statements;
use slipbook::ledger::Format;
use slipbook::numerics::expression::expression;
use trialbook::trials::by_hand::ByHand;

fn by_hand(place: &str, case: &ByHand) -> Vec<f64> {
    let value = |said: &&'static str| match PAPER.value(said) {
        Some(value) => value.number().unwrap(),
        None => pencil(place, said),
    };
    case.decimals.iter().map(value).collect()
}

pub fn pencil(place: &str, said: &str) -> f64 {
    let number = expression(said, |digits| digits.parse().ok());
    number.unwrap_or_else(|why| panic!("the case by hand of {place}: {why}"))
}

#[test]
fn the_decimals_of_the_cases_are_those_of_pencil_and_paper() {
    let mut failures = Vec::new();
    let cases = PAPER.cases().map(|(claim, case)| {
        let text = format!("{} {} {}", case.wrong, case.reason, case.case);
        (claim.id, text, by_hand(claim.id, case))
    });
    let all = PAPER
        .cases()
        .flat_map(|(claim, case)| by_hand(claim.id, case));
    let letter = ("the letter", bare(&PAPER.letter), all.collect());
    for (place, text, known) in cases.chain([letter]) {
        let said = decimals(&text);
        let is = |number: &str, value: f64| {
            let places = number.len() - number.find('.').unwrap() - 1;
            number == format!("{value:.places$}")
        };
        for number in &said {
            if !known.iter().any(|value| is(number, *value)) {
                failures.push(format!("{place}: `decimals` has none for {number}"));
            }
        }
        let idle = known
            .iter()
            .filter(|value| !said.iter().any(|number| is(number, **value)));
        let idle = idle.filter(|_| place != "the letter");
        failures
            .extend(idle.map(|value| format!("{place}: `decimals` has {value}, the text has not")));
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn the_start_of_a_case_lies_between_the_printed_and_the_true_boundary() {
    let envelope = PAPER
        .find("s4-envelope-is-boundary")
        .and_then(|(_, claim)| claim.by_hand);
    let [stated, found] = envelope
        .expect("the claim is gone: take this test out")
        .numbers()
        .unwrap();
    let between = [&*stated, "0.88", &*found].map(|x| x.parse::<f64>().unwrap());
    assert!(between.is_sorted_by(|a, b| a < b), "{between:?}");
}

#[test]
fn the_arithmetic_of_the_cases_by_hand_is_right() {
    let mut failures = Vec::new();
    let letter = LEDGER.letter(Format::Latex).unwrap();
    let letter = letter
        .split("\n\n")
        .map(|text| ("the letter", text.to_owned()));
    let cases = PAPER.cases().flat_map(|(claim, case)| {
        [case.reason.to_owned(), case.words().unwrap()].map(|text| (claim.id, text))
    });
    for (place, text) in cases.chain(letter) {
        // A name given twice may mean the first or the last.
        let (mut given, mut first) = (Given::new(), Given::new());
        for formula in formulas_of(&text) {
            let last = found(&formula, &mut given);
            let by_first = found(&formula, &mut Given::with(first.clone()));
            first.complete(&given);
            if let (Some(Found::Wrong(why)), Some(Found::Wrong(_))) = (last, by_first) {
                failures.push(format!("{place}: {formula}: {why}"));
            }
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn what_is_right_is_worked_out_where_its_case_is() {
    let letter = LEDGER.letter(Format::Text).unwrap();
    let mut tried = 0;
    for (claim, case) in PAPER.cases() {
        let (words, mut given) = (case.words().unwrap(), Given::new());
        // What a case finds in a limit is no value at its numbers.
        if words.contains(r"\to0") {
            continue;
        }
        let mut first = Given::new();
        for formula in formulas_of(&words) {
            found(&formula, &mut given);
            first.complete(&given);
        }
        let mut given = first;
        let right = claim.correction.map_or("", |right| right.latex);
        let right = right.replace(r"+\cdots", "").replace(r"+O(\alpha^3)", "");
        let formulas = match right.contains('$') {
            true => formulas_of(&right),
            false => right
                .split(r"\quad\text")
                .take(1)
                .map(str::to_owned)
                .collect(),
        };
        for formula in formulas {
            found(&formula, &mut given);
            // What follows says what letters stand for.
            if formula
                .trim()
                .trim_start_matches('\\')
                .chars()
                .all(char::is_alphabetic)
            {
                continue;
            }
            for statement in statements(&formula).unwrap_or_default().iter().take(1) {
                let side = statement.sides.last().unwrap();
                let value = |given: &Given| number(read(&formula, side, given).ok()?);
                let (Some(value), None) = (value(&given), value(&Given::new())) else {
                    continue;
                };
                let shown = format!("{value:.*}", case.digits);
                let sent = PAPER.letter.contains(&format!("found {}}}", claim.id));
                let told = words.contains(&shown) && (!sent || letter.contains(&shown));
                assert!(told, "{}: {formula} is {shown}", claim.id);
                tried += 1;
            }
        }
    }
    assert!(tried > 3, "{tried}");
}
