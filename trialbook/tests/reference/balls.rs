//! Balls against Arb (`balls.py`): each holds the range; of single numbers all but a few bits are known, and wide balls are not
//! much wider than they must be.

use crate::table::{ball, number, rows};
use trialbook::certified::{ball::Ball, interval::Interval};

const SPARE: usize = 64;

/// Exactly a single number, or all from `lo` to `hi`.
fn given(lo: &str, hi: &str, bits: usize) -> Ball {
    let x = Interval::new(number(lo), number(hi));
    let ball = Ball::enclosing(x, bits).expect("finite bounds");
    if lo == hi { ball.middle() } else { ball }
}

fn result(name: &str, x: &Ball, y: Option<&Ball>) -> Option<Ball> {
    let [sine, cosine] = x.sin_cos();
    match (name, y) {
        ("sin", None) => Some(sine),
        ("cos", None) => Some(cosine),
        ("sqrt", None) => x.sqrt(),
        ("asin", None) => x.asin(),
        ("+", Some(y)) => Some(x + y),
        ("-", Some(y)) => Some(x - y),
        ("*", Some(y)) => Some(x * y),
        ("/", Some(y)) => x.over(y),
        _ => panic!("no function {name}"),
    }
}

/// Cut off far behind the last bit.
fn holds(all: &Ball, decimals: &str) -> bool {
    let fine = all.bits() + SPARE;
    let exact = ball(decimals, fine);
    // As wide as what turning decimals into bits costs.
    let off = &exact - exact.middle();
    let room = &off + &off;
    exact.inside(&(all.with_bits(fine) + room))
}

fn spare_bits(name: &str) -> usize {
    match name {
        "+" | "-" => 0,
        "*" | "/" | "sqrt" | "sin" | "cos" => 2,
        // Up to 2⁻²⁶ before 1, where 13 bits are lost.
        "asin" => 8,
        other => panic!("no function {other}"),
    }
}

/// Against the range and the ball itself; and a few units for rounding.
fn is_narrow(name: &str, found: &Ball, x: Interval, range: Interval) -> bool {
    let most = match name {
        "+" | "-" => range.width(),
        // The product of the radii counts on both sides.
        "*" => 1.5 * range.width(),
        // The slope where the ball is steepest, over that where it is as steep as its range says.
        "/" | "asin" => 1.5 * range.width(),
        "sqrt" => 2.5 * range.width(),
        // Nowhere steeper than 1, and taken to be as steep as that.
        "sin" | "cos" => x.width(),
        other => panic!("no function {other}"),
    };
    let units = 16.0 * 2.0_f64.powi(-(found.bits().min(1000) as i32));
    // The interval itself has bounds of 53 bits.
    let bounds = 4.0 * f64::EPSILON * range.magnitude().max(1.0);
    found.interval().width() <= most + units + bounds
}

#[test]
fn every_range_is_enclosed_and_few_bits_are_lost() {
    let (mut single, mut wide, mut none) = (0, 0, 0);
    for [name, lo, hi, lo2, hi2, bits, least, most] in rows(include_str!("balls.csv")) {
        let bits = bits.parse().expect("bits");
        let x = given(lo, hi, bits);
        let y = (!lo2.is_empty()).then(|| given(lo2, hi2, bits));
        let found = result(name, &x, y.as_ref());
        let case = format!("{name} [{lo}, {hi}] [{lo2}, {hi2}] to {bits} bits: {found:?}");
        let ends = match name {
            "sqrt" => lo != hi && number(lo) <= 0.0,
            "asin" => lo != hi && number(lo).abs().max(number(hi).abs()) >= 1.0,
            _ => false,
        };
        let Some(found) = found else {
            assert!(least.is_empty() || ends, "not told: {case}");
            none += 1;
            continue;
        };
        assert!(!least.is_empty(), "there is no value: {case}");
        assert!(holds(&found, least) && holds(&found, most), "{case}");
        if lo == hi && lo2 == hi2 {
            assert!(
                found.known_bits() + spare_bits(name) >= bits,
                "too wide: {case}"
            );
            single += 1;
        } else {
            let [least, most, lo, hi] = [least, most, lo, hi].map(number);
            let (x, range) = (Interval::new(lo, hi), Interval::new(least, most));
            assert!(is_narrow(name, &found, x, range), "too wide: {case}");
            wide += 1;
        }
    }
    assert!(
        single > 700 && wide > 250 && none > 300,
        "{single} {wide} {none}"
    );
}
