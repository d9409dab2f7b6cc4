//! The judge, on evidence of your own: the same rules that the book's verdicts follow.
//!
//! `cargo run --no-default-features --example ledger`

use slipbook::evidence::{Change, Evidence, Kind, Route, Subject, Tolerance};
use slipbook::ledger::judge;

fn evidence(route: Route, subject: Subject, worst: f64) -> Evidence {
    const SIX_DIGITS: Tolerance = Tolerance {
        name: "SIX_DIGITS",
        value: 1e-6,
        reason: "six digits were read off",
    };
    Evidence {
        points: 100,
        worst,
        at: "x = 1".into(),
        ..Evidence::new(route, subject, "a formula with a measurement", SIX_DIGITS)
    }
}

fn main() {
    use Route::{Integration, Quadrature};
    use Subject::{Corrected, Printed};
    let one_way = [evidence(Integration, Printed, 1e-9)];
    let two_ways = [
        evidence(Integration, Printed, 1e-9),
        evidence(Quadrature, Printed, 1e-8),
    ];
    let wrong_sign = [
        evidence(Integration, Printed, 2.0),
        evidence(Integration, Corrected, 1e-9),
        evidence(Quadrature, Corrected, 1e-8),
    ];
    for (name, change, evidence) in [
        ("tried in one way", None, &one_way[..]),
        ("tried in two ways", None, &two_ways),
        ("wrong sign", Some(Change::Sign), &wrong_sign),
    ] {
        let judgement = judge(Kind::Equation, change, evidence);
        println!(
            "{name}: {} ({})",
            judgement.verdict.words(),
            judgement.ground
        );
    }
}
