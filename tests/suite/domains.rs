//! For each claim a point within what it is stated for, at which all formulas that it tries have values, by enclosure: in
//! sixteenths, but for the phases that follow from λ₀.

use slipbook::claims::{PAPER, formulas::formulas};
use slipbook::numerics::roots::root;
use slipbook::seeded::Formula;
use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};
use trialbook::certified::interval::Interval;

/// As stated, else the open unit interval, where the paper's ratios lie.
fn range(claim: &str, letter: &str) -> [f64; 2] {
    match (claim, letter) {
        ("eq-36", "λ₀") => return [0.54, 1.0],
        ("eq-41", "λ₀") => return [0.0, 0.53],
        _ => {}
    }
    let domain = PAPER.find(claim).map_or(&[][..], |(_, claim)| claim.domain);
    let stated = domain.iter().find(|part| part.letter == letter);
    stated.map_or([0.0, 1.0], |part| {
        let low = part.low.max(part.high.min(0.0) - 2.0);
        [low, part.high.min(low + 2.0)]
    })
}

fn sixteenths([low, high]: [f64; 2]) -> Vec<f64> {
    let all = (-64..=96).map(|n| f64::from(n) / 16.0);
    all.filter(|x| low < *x && *x < high).collect()
}

/// Another one for each symbol. The phases are those of the `n`th λ₀.
fn value(claim: &str, letter: &str, n: usize) -> f64 {
    let lambda0 = || value(claim, "λ₀", n);
    match letter {
        "φ₁" => return lambda0().asin(),
        "φ₃" => return lambda0().asin() + PI,
        "φ̃₁" => return (0.5 * PI * lambda0()).acos(),
        "φ̃₂" => {
            let (begin, lambda0) = (lambda0().asin(), lambda0());
            let lost = |phi: f64| begin.cos() - phi.cos() - lambda0 * (phi - begin);
            return root(lost, PI - begin, TAU).unwrap();
        }
        _ => {}
    }
    let among = sixteenths(range(claim, letter));
    let place = letter
        .bytes()
        .fold(n, |place, byte| 7 * place + usize::from(byte));
    among[place % among.len()]
}

/// By the claim's own inequality, or a condition between two symbols.
fn is_of_domain(claim: &str, n: usize) -> bool {
    let value = |letter| value(claim, letter, n);
    let of = PAPER.claims().find(|(_, of)| of.id == claim);
    let stated = of.map_or(&[][..], |(_, of)| of.conditions);
    let when = |text: &str| {
        stated
            .iter()
            .any(|condition| condition.text.starts_with(text))
    };
    let slower = value("p") < value("ρ");
    match claim {
        "eq-41" => value("φ̃₁") > value("φ₁"),
        "eq-110" => slower,
        "eq-116" => !slower,
        "eq-31" | "s22-rest-of-period" => (value("φ₁")..=value("φ̃₂")).contains(&value("φ")),
        "eq-33" => value("φ̃₂") < value("φ₃"),
        _ => !(when(r"$p<\rho$") && !slower || when(r"$p>\rho$") && slower),
    }
}

fn has_value(claim: &str, formula: &Formula<Interval>, n: usize) -> bool {
    let letters = formula.symbols.iter();
    let point: Vec<_> = letters
        .map(|letter| Interval::point(value(claim, letter, n)))
        .collect();
    (formula.value)(&point)
        .into_iter()
        .all(Interval::is_bounded)
}

#[test]
fn every_claim_with_formulas_speaks_of_a_point() {
    let mut of_claim = BTreeMap::<String, Vec<_>>::new();
    for formula in formulas::<Interval>() {
        let claim = formula.claim().unwrap_or_else(|| formula.path.to_owned());
        of_claim.entry(claim).or_default().push(formula);
    }
    for (_, claim) in PAPER.claims() {
        let read = |letter| {
            let formulas = of_claim.get(claim.id).into_iter().flatten();
            formulas
                .flat_map(|formula| &formula.symbols)
                .any(|of| *of == letter)
        };
        let other = claim.domain.iter().find(|part| !read(part.letter));
        assert_eq!(other, None, "no formula of {} reads it", claim.id);
    }
    for (claim, formulas) in &of_claim {
        let there = |n: &usize| {
            is_of_domain(claim, *n) && formulas.iter().all(|formula| has_value(claim, formula, *n))
        };
        let none = formulas
            .iter()
            .filter(|f| !(0..200).any(|n| has_value(claim, f, n)))
            .map(|f| f.path);
        let none: Vec<_> = none.collect();
        assert!((0..200).any(|n| there(&n)), "{claim}: {none:?}");
    }
}
