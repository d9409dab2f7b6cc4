//! Enclosures on intervals against Arb's ranges (`intervals.py`): each holds the range, and is no wider than is said here.

use crate::table::{number, rows};
use trialbook::certified::interval::Interval;
use trialbook::scalar::Scalar;

/// Beyond this only −1 and 1 bound the sine and the cosine.
const FARTHEST: f64 = 1e5;

/// The exponential beyond ±700, and the logarithm beyond 10^±290, is only bounded by these.
const SMALL: f64 = 1e-300;
const LARGE: f64 = 1e300;

enum Room {
    Step,
    Within(f64),
    Any,
}

type Function = fn(Interval) -> Interval;

fn unary(name: &str) -> Function {
    match name {
        "sin" => Scalar::sin,
        "cos" => Scalar::cos,
        "tan" => Scalar::tan,
        "cot" => Scalar::cot,
        "asin" => Scalar::asin,
        "acos" => Scalar::acos,
        "sinh" => Scalar::sinh,
        "cosh" => Scalar::cosh,
        "tanh" => Scalar::tanh,
        "coth" => Scalar::coth,
        "exp" => Scalar::exp,
        "exp_m1" => Scalar::exp_m1,
        "ln" => Scalar::ln,
        "ln_1p" => Scalar::ln_1p,
        "sqrt" => Scalar::sqrt,
        "squared" => Scalar::squared,
        other => panic!("no function {other}"),
    }
}

fn binary(name: &str, x: Interval, y: Interval) -> Interval {
    match name {
        "+" => x + y,
        "-" => x - y,
        "*" => x * y,
        "/" => x / y,
        "pow" => x.pow(y),
        other => panic!("no operation {other}"),
    }
}

fn room(name: &str, x: Interval, y: Option<Interval>, bound: f64) -> Room {
    let size = bound.abs();
    let is_point = x.lo() == x.hi();
    // In the last place of the bound, of a number of order one, and of the larger of the two.
    let (relative, absolute) = (f64::EPSILON * size, f64::EPSILON);
    let larger = relative.max(absolute);
    // π/2 is known to 86 bits after the point, and taken off as often as it goes into the argument.
    let turned = x.magnitude() * 2.0_f64.powi(-84);
    match name {
        "+" | "-" | "*" | "/" | "sqrt" | "squared" => Room::Step,
        "sin" | "cos" | "tan" | "cot" if x.magnitude() > FARTHEST => Room::Any,
        "sin" | "cos" => Room::Within(4.0 * relative + turned),
        // A quotient of two enclosures is wider than the range on a wide interval.
        "tan" | "cot" | "tanh" | "coth" if !is_point => Room::Any,
        "tan" | "cot" => Room::Within(8.0 * relative + 2.0 * (turned + turned * size * size)),
        // Beyond 3/4 twice that of another number.
        "asin" => Room::Within(8.0 * relative),
        // A right angle less the inverse sine.
        "acos" => Room::Within(8.0 * absolute),
        "exp" | "cosh" | "sinh" | "exp_m1" | "tanh" | "coth" if x.magnitude() > 700.0 => Room::Any,
        "exp" | "cosh" => Room::Within(4.0 * relative),
        // Differences of numbers of order one or more.
        "sinh" | "exp_m1" => Room::Within(4.0 * larger),
        "tanh" => Room::Within(10.0 * absolute),
        "coth" if size < 1e7 => Room::Within(10.0 * absolute * (1.0 + size * size)),
        "ln" | "pow" if x.lo() < 1e-290 || x.hi() > 1e290 => Room::Any,
        "ln_1p" if x.hi() > 1e289 => Room::Any,
        "ln" => Room::Within(4.0 * larger),
        // Below 1/2 a unit in the last place of 1 + x counts for more.
        "ln_1p" => Room::Within(4.0 * larger / (1.0 + x.lo()).min(1.0)),
        // exp(y ln x), and what the exponent is off by.
        "pow" => {
            let exponent = y.map_or(0.0, Interval::magnitude) * x.ln().magnitude().max(1.0);
            if !(SMALL..=LARGE).contains(&size) || exponent > 700.0 {
                Room::Any
            } else {
                Room::Within(relative * (8.0 + 8.0 * exponent))
            }
        }
        _ => Room::Any,
    }
}

fn is_tight(found: f64, best: f64, room: &Room) -> bool {
    match room {
        Room::Step => found == best || found == best.next_down(),
        // The least numbers have no fractions of themselves.
        Room::Within(far) => best - found <= far + 4.0 * f64::from_bits(1) || found == best,
        Room::Any => true,
    }
}

#[test]
fn every_range_is_enclosed_and_by_no_more_than_is_said() {
    let (mut told, mut none) = (0, 0);
    for [name, lo, hi, lo2, hi2, least, most] in rows(include_str!("intervals.csv")) {
        let x = Interval::new(number(lo), number(hi));
        let y = (!lo2.is_empty()).then(|| Interval::new(number(lo2), number(hi2)));
        let found = y.map_or_else(|| unary(name)(x), |y| binary(name, x, y));
        let case = format!("{name} {x:?} {y:?} = {found:?}, and Arb says [{least}, {most}]");
        if least.is_empty() {
            // No value somewhere; of quotients one bound may be known.
            let quotient = ["/", "tan", "cot", "tanh", "coth"].contains(&name);
            assert!(
                !found.is_bounded() && (quotient || found == Interval::WHOLE),
                "{case}"
            );
            none += 1;
            continue;
        }
        let [least, most] = [least, most].map(number);
        assert!(
            found.lo() <= least && most <= found.hi(),
            "not enclosed: {case}"
        );
        let rooms = [least, most].map(|bound| room(name, x, y, bound));
        assert!(is_tight(found.lo(), least, &rooms[0]), "too low: {case}");
        assert!(is_tight(-found.hi(), -most, &rooms[1]), "too high: {case}");
        told += usize::from(rooms.iter().all(|room| !matches!(room, Room::Any)));
    }
    assert!(told > 4500 && none > 300, "{told} {none}");
}

#[test]
fn what_is_too_far_to_be_told_is_bounded_as_is_said() {
    let mut far = 0;
    for [name, lo, hi, ..] in rows::<7>(include_str!("intervals.csv")) {
        let x = Interval::new(number(lo), number(hi));
        let found = match name {
            "sin" | "cos" if x.lo() > FARTHEST || x.hi() < -FARTHEST => {
                assert!(
                    unary(name)(x).within(Interval::new(-1.0, 1.0)),
                    "{name} {x:?}"
                );
                true
            }
            "exp" if x.lo() > 700.0 => x.exp().lo() >= LARGE,
            "exp" if x.hi() < -700.0 => x.exp().within(Interval::new(0.0, SMALL)),
            _ => continue,
        };
        assert!(found, "{name} {x:?}");
        far += 1;
    }
    assert!(far > 50, "{far}");
}
