//! The answers as they stand, and what happens where the two ways part.

use super::*;
use std::sync::LazyLock;

/// Every task, sat once for all tests.
static SAT: LazyLock<Vec<(&str, Result<Sat, ExamError>)>> =
    LazyLock::new(|| TASKS.iter().map(|task| (task.id, task.sit())).collect());

#[test]
fn both_ways_agree_on_every_task() {
    let failed: Vec<_> = SAT
        .iter()
        .filter_map(|(_, sat)| sat.as_ref().err())
        .collect();
    assert!(failed.is_empty(), "{failed:#?}");
}

#[test]
fn a_number_is_known_to_twelve_digits_or_its_error_is_a_bound() {
    for (id, sat) in SAT.iter() {
        let sat = sat.as_ref().unwrap();
        let (Answer::Number(x), Some(error)) = (&sat.answer, sat.error) else {
            continue;
        };
        assert!(
            sat.basis == Basis::Certified || error <= 1e-11 * x.abs().max(1.0),
            "{}: {x} {error:e}",
            id
        );
    }
}

#[test]
fn the_answers_are_these() {
    let mut lines = Vec::new();
    for (id, sat) in SAT.iter() {
        let sat = sat.as_ref().unwrap();
        // Two digits short of what is claimed: the last ones differ from machine to machine.
        let text = match (&sat.answer, sat.error) {
            (Answer::Number(x), Some(error)) if error > 1e-15 => {
                let decimals = libm::floor(-libm::log10(error)) - 2.0;
                format!("{x:.0$}", decimals.clamp(0.0, 12.0) as usize)
            }
            (Answer::Number(x), _) => format!("{x:.12}"),
            _ => sat.text(),
        };
        lines.push(format!("{id} {text} {:?}", sat.basis));
    }
    insta::with_settings!({
        snapshot_path => concat!(env!("CARGO_MANIFEST_DIR"), "/../snapshots"),
        prepend_module_to_snapshot => false,
        omit_expression => true,
    }, { insta::assert_snapshot!("exam", lines.join("\n")) });
}

#[test]
fn ids_are_unique() {
    let ids: std::collections::BTreeSet<_> = TASKS.iter().map(|task| task.id).collect();
    assert_eq!(ids.len(), TASKS.len());
}

#[test]
fn an_answer_on_which_the_ways_differ_is_none() {
    let wrong = Task {
        other: fraction!(7 / 5),
        ..plane::STOP_TIME
    };
    assert!(matches!(
        wrong.sit(),
        Err(ExamError::Disagree {
            id: "stop-time",
            ..
        })
    ));
    let wrong = Task {
        other: Other::Integrated(|| Ok(Answer::Order("F".into()))),
        ..ratchet::ORDERS
    };
    assert!(matches!(wrong.sit(), Err(ExamError::Disagree { .. })));
}

#[test]
fn two_ways_agree_to_ten_digits_beside_the_width_of_an_enclosure() {
    let sat = |motion, other| {
        let task = Task {
            motion,
            other,
            ..plane::STOP_TIME
        };
        task.sit()
            .ok()
            .map(|sat| (sat.answer, sat.error.unwrap(), sat.basis))
    };
    let two = || Ok(Answer::Number(2.0));
    let certified = |x, error| Some((Answer::Number(x), error, Basis::Certified));
    let integrated = |x, error| Some((Answer::Number(x), error, Basis::Integrated));
    // The error of an enclosure is how far its ends are from its middle.
    assert_eq!(
        sat(two, Other::Within(|| Ok(Interval::new(1.5, 2.5)))),
        certified(2.0, 0.5)
    );
    assert_eq!(
        sat(two, Other::Within(|| Ok(Interval::new(2.0, 3.0)))),
        certified(2.5, 0.5)
    );
    assert_eq!(
        sat(two, Other::Within(|| Ok(Interval::new(2.125, 3.0)))),
        None
    );
    assert_eq!(
        sat(two, Other::Within(|| Ok(Interval::point(2.0 + 1e-10)))),
        certified(2.0 + 1e-10, 0.0)
    );
    assert_eq!(
        sat(two, Other::Within(|| Ok(Interval::point(2.0 + 3e-10)))),
        None
    );
    // That of two integrators is their difference, and never nothing.
    assert_eq!(
        sat(two, Other::Integrated(|| Ok(Answer::Number(2.0)))),
        integrated(2.0, 2e-13)
    );
    let near = 2.0_f64.next_up();
    assert_eq!(
        sat(
            two,
            Other::Integrated(|| Ok(Answer::Number(2.0_f64.next_up())))
        ),
        integrated(near, 2e-13)
    );
    let off = 2.0 + 1e-10;
    assert_eq!(
        sat(two, Other::Integrated(|| Ok(Answer::Number(2.0 + 1e-10)))),
        integrated(off, off - 2.0)
    );
    assert_eq!(
        sat(two, Other::Integrated(|| Ok(Answer::Number(2.0 + 3e-10)))),
        None
    );
    // Of large numbers it is the digits that count.
    let large = || Ok(Answer::Number(2e6));
    assert!(sat(large, Other::Integrated(|| Ok(Answer::Number(2e6 + 1e-4)))).is_some());
    assert_eq!(
        sat(large, Other::Integrated(|| Ok(Answer::Number(2e6 + 3e-4)))),
        None
    );
}

#[test]
fn no_more_digits_are_written_than_are_known() {
    let sat = |x: f64, error| Sat {
        answer: Answer::Number(x),
        error: Some(error),
        basis: Basis::Certified,
        motion: Answer::Number(x),
    };
    assert_eq!(sat(0.871_912_345_678, 1e-9).text(), "0.871912346");
    assert_eq!(sat(0.425, 1e-17).text(), "0.425");
    assert_eq!(sat(0.0, 0.0).text(), "0");
    assert_eq!(sat(95.123_456, 3e-3).text(), "95.12");
}
