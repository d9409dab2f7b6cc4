//! What an answer says and how many digits it has, and the calculators where no one number is held: `tests/suite/command/held.txt`
//! holds them against values from elsewhere.

mod constant;
mod sphere;
mod turntable;

use super::*;

#[derive(Clone, Debug)]
struct One(f64);

impl Fields for One {
    fn fields(&self) -> Vec<Field> {
        vec![Field::new("x", self.0)]
    }
}

/// Every entry, with other contents than any other.
#[test]
fn a_report_says_what_the_answer_does() {
    let of = |tau: f64| super::turntable::TurntableOutcome {
        outcome: "rest",
        sigma: Some(2.0 * tau),
        tau_rest: Some(tau),
    };
    let answer = Answer {
        best: of(0.25),
        by_formula: Some(of(0.2503)),
        by_motion: Some(of(0.75)),
        disagreement: Some(0.125),
        digits: Some(3),
        note: "by two ways".into(),
    };
    let entry =
        |tau: f64| serde_json::json!({ "outcome": "rest", "sigma": 2.0 * tau, "tau_rest": tau });
    let mut expected = entry(0.25);
    for (name, value) in [
        ("version", VERSION.into()),
        ("problem", "a problem".into()),
        (
            "units",
            serde_json::json!({ "sigma": "μg/Ω²", "tau_rest": "1/Ω" }),
        ),
        // To the three digits that are known.
        ("by_formula", entry(0.25)),
        ("by_motion", entry(0.75)),
        ("disagreement", 0.125.into()),
        ("digits", 3.into()),
        ("note", "by two ways".into()),
    ] {
        expected[name] = value;
    }
    assert_eq!(
        serde_json::to_value(answer.report("a problem")).unwrap(),
        expected
    );
}

/// To the digits that both have, and not at all where they have none.
#[test]
fn of_a_formula_that_is_not_the_best_way_only_what_is_right_is_written() {
    let of = |a| super::rest::Boundary { a };
    for (formula, written) in [
        (0.931_534, Value::Number(0.9315)),
        (0.938, Value::Number(0.9)),
        (0.4, Value::Missing),
    ] {
        let answer = Answer {
            best: of(0.931_51),
            by_formula: Some(of(formula)),
            by_motion: None,
            disagreement: None,
            digits: Some(5),
            note: String::new(),
        };
        let report = answer.report("");
        assert_eq!(report.by_formula.unwrap()[0].value, written, "{formula}");
        assert_eq!(report.fields[0].value, Value::Number(0.931_51));
    }
}

#[test]
fn digits_are_those_that_an_error_leaves() {
    for (error, expected) in [
        (0.0, 15),
        (3e-15, 14),
        (1e-12, 12),
        (2e-11, 10),
        (0.5, 0),
        (1.0, 0),
    ] {
        assert_eq!(digits(error), expected, "{error}");
    }
}

#[test]
fn no_more_digits_are_written_than_are_known() {
    // Value, scale, digits; as written.
    for (x, scale, digits, written) in [
        (0.123456789, 0.0, 4, 0.1235),
        (-123.456, 0.0, 2, -120.0),
        (0.00123456, 1.0, 4, 0.001),
        (0.00123456, 1.0, 2, 0.0),
        (9.9996, 0.0, 4, 10.0),
        (0.0, 1.0, 15, 0.0),
    ] {
        let field = Field::within(scale, "x", x).rounded(digits);
        assert_eq!(field.value, Value::Number(written), "{x} {scale} {digits}");
    }
    let unknown = Field::within(0.0, "x", 5.0).rounded(0);
    assert_eq!(unknown.value, Value::Missing);
    assert_eq!(known(5.15460131, 3e-7), (5.154601, 7));
    assert_eq!(known(0.5, 0.0), (0.5, 15));
    let word = Field::new("x", "rest");
    assert_eq!(word.rounded(3), word);
}

#[test]
fn a_formula_is_trusted_where_rounding_explains_what_the_motion_says() {
    let said = |[given, rounded, beside]: [f64; 3]| Said {
        given: One(given),
        rounded: One(rounded),
        beside: vec![One(beside)],
    };
    let digits = |motions: [f64; 2], rounding| {
        let motions = motions.map(One);
        Answer::by_both(said([2.0; 3]), motions, rounding, "")
            .unwrap()
            .digits
    };
    // Two motions that differ by as much, or by nothing; and a rounding in their own units.
    assert_eq!(digits([2.0 + 2e-9, 2.0 - 2e-9], 0.0), Some(15));
    assert_eq!(digits([2.0 + 1e-9, 2.0 + 1e-9], 0.0), Some(9));
    assert_eq!(digits([2.0 + 2e-9, 2.0 + 2e-9], 1e-8), Some(15));
    assert_eq!(digits([2.0 + 1e-12, 2.0 + 1e-12], 0.0), Some(15));
    // What rounding the start changes is held against the motion from the rounded start.
    let [near, far] = [[2.1, 2.1], [2.0, 2.0]].map(|motions| {
        Answer::by_both(said([2.0, 2.1, 2.1]), motions.map(One), 0.0, "by").unwrap()
    });
    assert_eq!(
        (near.best.0, near.digits, far.digits),
        (2.0, Some(15), Some(1))
    );
    assert_eq!(near.note, format!("by; {NEXT_TO_IT}"));
    // What moves the formula as much as the motion differs explains it.
    let beside = said([2.0, 2.0, 2.0 + 1e-9]);
    let nudged = Answer::by_both(beside, [2.0 + 9e-10; 2].map(One), 0.0, "").unwrap();
    assert_eq!(nudged.digits, Some(15));
    let alone = Answer::by_either(said([2.0, 2.1, 2.1]), None, 0.0, "").unwrap();
    assert_eq!((alone.digits, alone.disagreement), (Some(15), None));
}

#[test]
fn a_wide_motion_is_trusted_as_far_as_narrower_numbers_explain_the_second() {
    // How far the second is off, what the nudge and what the rounding moves; digits.
    for (off, nudged, rounded, expected) in [
        (0.0, 0.0, 0.0, 15),
        (0.0, 2e-9, 0.0, 8),
        // Within what two integrations differ anyway, or what the nudge or the rounding explains.
        (9e-10, 1e-14, 0.0, 14),
        (1e-6, 1e-20, 0.0, 15),
        (1e-6, 0.0, 1e-6, 15),
        // By nothing that is known.
        (9e-7, 0.0, 0.0, 6),
        (9e-7, 1e-23, 4e-7, 6),
        (0.3, 1e-20, 1e-3, 0),
    ] {
        let moved = [vec![nudged], vec![rounded]];
        let answer = Answer::by_wide_motion(One(1.0), &One(1.0 - off), moved, "").unwrap();
        assert_eq!(answer.digits, Some(expected), "{off} {nudged} {rounded}");
    }
}

#[test]
fn zero_has_no_sign_and_differs_from_nothing_but_other_values() {
    let Value::Number(zero) = Value::from(-0.0) else {
        panic!("a number")
    };
    assert!(zero.is_sign_positive());
    let field = |value: Value| Field::within(0.0, "x", value);
    let values = [
        Value::Number(0.0),
        Value::Number(2.0),
        Value::Word("rest"),
        Value::Word("escape"),
        Value::Missing,
    ];
    for (i, a) in values.into_iter().enumerate() {
        for (j, b) in values.into_iter().enumerate() {
            let words = matches!((a, b), (Value::Word(_), Value::Word(_)));
            let expected = if i == j || words { 0.0 } else { 1.0 };
            assert_eq!(field(a).difference(&field(b)), expected, "{a:?} {b:?}");
            assert_eq!(field(a).is_seen_beside(&field(b)), i != j, "{a:?} {b:?}");
        }
    }
    let (two, three) = (Value::Number(2.0), Value::Number(3.0));
    assert_eq!(field(two).difference(&field(three)), 1.0 / 3.0);
    let wide = Field::within(10.0, "x", 3.0);
    assert_eq!(field(two).difference(&wide), 0.1);
    assert_eq!(wide.difference(&field(two)), 0.1);
}

#[test]
fn what_is_known_is_within_a_unit_of_its_last_digit() {
    let mut random = fastrand::Rng::with_seed(9);
    for _ in 0..20_000 {
        let value = libm::exp10(6.0 * random.f64() - 3.0);
        let error = value * libm::exp10(-13.0 * random.f64());
        let (shown, digits) = known(value, error);
        let unit = libm::exp10((power_of_ten(value) + 1 - i64::from(digits)) as f64);
        for truth in [value - error, value + error] {
            let off = (shown - truth).abs();
            assert!(
                digits == 0 || off < unit * (1.0 + 1e-6),
                "{value} {error} {shown}"
            );
        }
    }
}
