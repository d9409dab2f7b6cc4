//! The decimals in the cases by hand, worked out once more.

use super::{
    formulas::{Found, Given, found, number, read},
    numbers::decimals,
    text::{bare, formulas_of},
};
use crate::LEDGER;
use slipbook::claims::PAPER;
use slipbook::corrections::rest::{boundary_a, boundary_least};
use slipbook::exact::latex::statements;
use slipbook::ledger::Format;
use std::f64::consts::{FRAC_1_PI, FRAC_PI_2, PI, SQRT_2, TAU};

/// The friction, where the drive pulls backward, and the forward motion at the end of that: λ₀ and what follows it.
fn wedge(q: f64, lambda: f64) -> [f64; 7] {
    let (begin, end) = (lambda.asin(), TAU - (q * lambda).asin());
    let (cosine, other) = (begin.cos(), end.cos());
    let speed = cosine - other - lambda * (end - begin);
    [
        cosine,
        other,
        lambda,
        end,
        begin,
        speed,
        PI + (q * lambda).asin(),
    ]
}

/// The decimals of the reason and the case of a claim.
fn by_hand(claim: &str) -> Vec<f64> {
    let s = 0.75_f64.sqrt();
    match claim {
        "s22-vy-two-stages" => vec![(s + FRAC_1_PI) / (s - FRAC_1_PI)],
        "s24-region-2" => {
            let q = PAPER.value("y-q").unwrap();
            let [cosine, other, lambda, end, begin, speed, from] = wedge(9.0, 0.1);
            let taken = [
                q.number().unwrap(),
                lambda,
                9.0 * lambda,
                from,
                end,
                begin,
                end,
            ];
            [&taken[..], &[cosine, other, lambda, end, begin, speed]].concat()
        }
        "eq-134" => {
            let lag = 2.0 / 1200.0 * (1.0 + 0.75 * SQRT_2 * 1200_f64.ln() / 1200.0);
            vec![lag, FRAC_PI_2 - lag]
        }
        "eq-55" => vec![0.9 / 9.0],
        "fig-5" => {
            let q = 6.5;
            let [cosine, other, lambda, end, begin, speed, _] = wedge(q, 0.15);
            let taken = [q, lambda, 1.0 / q, q * lambda, end, begin];
            [&taken[..], &[cosine, other, lambda, end, begin, speed]].concat()
        }
        // v²/(2μg).
        "eq-106" | "s4-coriolis-no-work" => vec![25.0 / (2.0 * 0.5 * 10.0)],
        // The last but one is a start between the printed and the true boundary.
        "s4-envelope-is-boundary" => vec![0.1, 0.2, 1.0 - 0.1, 0.88, boundary_a(0.1, 0.2)],
        // α, and ψ = 2α.
        "eq-147" => vec![0.1, 1.0 - 0.1, 2.0 * 0.1, boundary_least(0.1)],
        _ => Vec::new(),
    }
}

#[test]
fn the_decimals_of_the_cases_are_those_of_pencil_and_paper() {
    let mut tried = 0;
    let cases = PAPER.cases().map(|(claim, case)| {
        let text = format!("{} {} {}", case.wrong, case.reason, case.case);
        (claim.id, text, by_hand(claim.id))
    });
    // The letter takes its examples from the cases.
    let all = PAPER.cases().flat_map(|(claim, _)| by_hand(claim.id));
    let letter = ("the letter", bare(&PAPER.letter), all.collect());
    for (place, text, by_hand) in cases.chain([letter]) {
        for number in decimals(&text) {
            let places = number.len() - number.find('.').unwrap() - 1;
            let known = by_hand
                .iter()
                .any(|value| number == format!("{value:.places$}"));
            assert!(by_hand.is_empty() || known, "{place}: {number}");
            tried += usize::from(known);
        }
    }
    assert!(tried > 0);
    let (_, envelope) = PAPER.find("s4-envelope-is-boundary").unwrap();
    let numbers = envelope.by_hand.unwrap().computed;
    let between = [
        (numbers.stated)().unwrap(),
        0.88,
        (numbers.found)().unwrap(),
    ];
    assert!(
        between.windows(2).all(|pair| pair[0] < pair[1]),
        "{between:?}"
    );
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
        // A name that is given twice may mean the first or the last.
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

/// Where what is right has a value at what a case gives, the case shows it, and so does the letter if it has the case's number.
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
        // A name that is given twice means the first.
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
            // What it says its names are is given, too.
            found(&formula, &mut given);
            // A letter alone says nothing; what follows says what letters stand for.
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
