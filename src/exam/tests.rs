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
        snapshot_path => concat!(env!("CARGO_MANIFEST_DIR"), "/snapshots"),
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
