//! The search among the known numbers.

use slipbook::claims::{PAPER, values::search};
use slipbook::numerics::expression::expression;
use std::collections::BTreeSet;

/// Name, how many digits are right, the first wrong one and where it stands.
fn found(number: &str) -> Vec<(&'static str, usize, Option<usize>, Option<usize>)> {
    let all = search(PAPER.values(), number).unwrap();
    all.iter()
        .map(|m| (m.name, m.right, m.first_wrong, m.column))
        .collect()
}

#[test]
fn a_number_is_found_by_its_digits_sign_and_size() {
    for (number, right) in [
        ("0.537", 3),
        ("0.5370", 4),
        ("5.37029e-1", 6),
        ("0.53702927", 8),
        (".5370292721", 10),
        ("+0.537029E0", 6),
    ] {
        assert_eq!(found(number), [("lambda-c", right, None, None)], "{number}");
    }
    assert_eq!(found("0.53703"), [("lambda-c", 5, None, None)]);
    assert_eq!(found("0.5370293"), [("lambda-c", 7, None, None)]);
    assert_eq!(found("0.07856742013"), [("s", 10, None, None)]);
    assert_eq!(found("0.53709"), [("lambda-c", 4, Some(5), Some(6))]);
    // Two right digits are too few.
    assert!(found("0.53802927").is_empty());
    assert_eq!(found("5.3712e-1"), [("lambda-c", 3, Some(4), Some(4))]);
    for other in ["-0.537029", "5.37029", "0.0537029", "537.029", "0.537029e1"] {
        assert!(found(other).is_empty(), "{other}");
    }
    assert_eq!(found("0.537029272149999")[0].0, "lambda-c");
    // One digit has to be all of it.
    assert!(found("0.22").len() > 1);
    assert!(found("0.2").is_empty() && found("1").is_empty());
    assert_eq!(found("0.5"), [("boundary-slope", 1, None, None)]);
    // Closed forms have no end.
    let digits = "0.0785674201318386138223";
    assert_eq!(found(digits), [("s", 21, None, None)]);
    for no_number in [
        "",
        "x",
        "0.5.3",
        "inf",
        "NaN",
        "0",
        "0.000",
        "1e",
        "1e99999999999",
    ] {
        assert!(search(PAPER.values(), no_number).is_err(), "{no_number}");
    }
}

#[test]
fn every_value_has_its_digits() {
    let ids: BTreeSet<_> = PAPER.values().map(|value| value.id).collect();
    assert_eq!(ids.len(), PAPER.values().count());
    for value in PAPER.values() {
        let shown: f64 = value.shown().unwrap().parse().unwrap();
        let half = 0.5 * libm::exp10(-(value.decimals as f64));
        let off = (shown - value.number().unwrap()).abs();
        assert!(off <= half * (1.0 + 1e-9), "{}: {shown}", value.id);
        if let Some(enclosure) = value.enclosure {
            let [number, middle] = [value.number().unwrap(), enclosure.interval().unwrap().mid()];
            let off = (number - middle).abs();
            assert!(
                off < 1e-11 * middle.abs(),
                "{}: {number}, {middle}",
                value.id
            );
        }

        if let Some(form) = value.closed {
            let closed: f64 = expression(form, |digits| digits.parse().ok()).unwrap();
            let number = value.number().unwrap();
            assert!(
                (closed - number).abs() < 1e-12 * number.abs(),
                "{}",
                value.id
            );
        }

        // Cut off; nines may be rounded up if there are two of them or more.
        let digits = value.digits().unwrap();
        let significant = digits.trim_start_matches(['-', '0', '.']).replace('.', "");
        assert_eq!(significant.len(), value.known(), "{} {digits}", value.id);
        let number = value.number().unwrap();
        let cut = number - digits.parse::<f64>().unwrap();
        let unit = libm::exp10(-(digits.split_once('.').unwrap().1.len() as f64));
        // The work number is rounded too.
        let rounding = 4.0 * f64::EPSILON * number.abs();
        assert!(
            cut >= -0.005 * unit - rounding && cut < unit + rounding,
            "{} {number} {digits}",
            value.id
        );
    }
    // 1/√2 = 0.70710678118654752440|08…, e^(√2 π) = 85.0196952232…, 7/6 = 1.1666…; 14/33 = 0.4242…
    for (id, cut, rounded) in [
        (
            "fig-4-friction",
            "0.70710678118654752440",
            "0.70710678118654752440",
        ),
        ("turn", "85.019695223207217582", "85.019695223207217583"),
        ("y-q-printed", "4.6030000000000000000", "4.603"),
        ("b-solid", "3.5000000000000000000", "3.5"),
        (
            "boundary-curvature",
            "1.1666666666666666666",
            "1.1666666666666666667",
        ),
        (
            "slip-end",
            "0.42424242424242424242",
            "0.42424242424242424242",
        ),
        ("critical-speed", "1.1653079259", "1.1653079259"),
    ] {
        let value = PAPER.value(id).unwrap();
        assert_eq!(value.digits().unwrap(), cut);
        assert_eq!(value.rounded().unwrap(), rounded);
    }
}
