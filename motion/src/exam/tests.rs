//! The answers as they stand, and what happens where the two ways part.

use super::*;
use crate::numerics::error::plain;
use crate::turntable::{Start, intrinsic::Run};
use std::f64::consts::PI;
use std::sync::LazyLock;

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
fn an_escape_goes_as_its_question_says() {
    let tau = 1e6;
    let start = Start::put_down(1.5).unwrap();
    let rho = Run::new(&start, tau).unwrap().end().rho();
    assert!((rho / (tau * tau) * 3.0 * std::f64::consts::SQRT_2 - 1.0).abs() < 1e-3);
    assert!(
        TASKS
            .iter()
            .any(|task| task.question.contains("grows as t²/(3√2)"))
    );
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
        // Two digits short: the last ones differ from machine to machine.
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

/// Within the task's interval, and 10⁻⁹ of the answer, or of 1.
fn holds(answer: &Answer, sat: &Sat) -> bool {
    match (answer, sat.interval()) {
        (Answer::Number(x), Some([lo, hi])) => {
            let wide = 1e-9 * lo.abs().max(1.0);
            (lo - wide..=hi + wide).contains(x)
        }
        (answer, _) => *answer == sat.answer,
    }
}

#[test]
fn every_scene_gives_the_answer_of_its_task() {
    for (task, (_, sat)) in TASKS.iter().zip(SAT.iter()) {
        let run = task.posed.run().unwrap();
        let sat = sat.as_ref().unwrap();
        assert!(holds(&run, sat), "{}: {run} {}", task.id, sat.answer);
    }
}

#[test]
fn a_wrong_word_in_a_scene_is_noticed() {
    let mut noticed = 0;
    for (task, (_, sat)) in TASKS.iter().zip(SAT.iter()) {
        // They rest or come back elsewhere too; a search takes long.
        if ["creep", "mirror", "orders"].contains(&task.id) || task.posed.scan.is_some() {
            continue;
        }
        let (body, words) = task.posed.words();
        for k in 0..words.len() {
            let (name, text) = words[k];
            let Ok(number) = text.parse::<f64>() else {
                continue;
            };
            if name == "radius" {
                continue;
            }
            let text = plain(number * (1.0 + 1e-6));
            let scene = words.iter().map(|(other, was)| match *other == name {
                true => format!(" {name}={text}"),
                false if was.is_empty() => format!(" {other}"),
                false => format!(" {other}={was}"),
            });
            let scene: String = [body.to_owned()].into_iter().chain(scene).collect();
            let wrong = posed::Posed {
                scene: scene.leak(),
                ..task.posed
            };
            let run = wrong.run().unwrap();
            assert!(!holds(&run, sat.as_ref().unwrap()), "{}: {name}", task.id);
            noticed += 1;
        }
    }
    assert!(noticed > 30, "{noticed}");
}

#[test]
fn the_answers_of_grids_are_those_of_closed_forms() {
    let posed = |id| {
        let field = posed::FIELDS.iter().find(|field| field.id == id);
        let task = TASKS.iter().find(|task| task.id == id);
        field.map(|f| f.posed).or(task.map(|t| t.posed)).unwrap()
    };
    let g = 9.81;
    let ramp = |mu: f64, ratio: f64| {
        let (s, c) = (mu * ratio).atan().sin_cos();
        (0.5 * g * (s - mu * c)).max(0.0)
    };
    // With u = tan(θ/2) the hodograph is C u^(λ − 1) (1 + u²).
    let thrown = |lambda: f64, angle: f64| {
        if angle == 0.0 || angle == PI {
            return 0.5 / (lambda - angle.cos());
        }
        let u = (0.5 * angle).tan();
        let c = 1.0 / (u.powf(lambda - 1.0) * (1.0 + u * u));
        let term = |k: f64| u.powf(k) / k;
        let x = c * c * (term(2.0 * lambda - 2.0) - term(2.0 * lambda + 2.0));
        let y = 2.0 * c * c * (term(2.0 * lambda - 1.0) + term(2.0 * lambda + 1.0));
        x.hypot(y)
    };
    type Closed<'a> = &'a dyn Fn(f64, f64) -> f64;
    let all: [(&str, Closed); 5] = [
        ("ramp", &ramp),
        ("stopping-distance", &|mu, v| v * v / (2.0 * mu * g)),
        ("creep", &|_, _| 0.0),
        ("stop-place", &thrown),
        ("slip-time", &|mu, v| 2.0 * v / (7.0 * mu)),
    ];
    for (id, closed) in all {
        let cells = posed(id).cells().unwrap();
        assert!(cells.len() >= 20, "{id}");
        for cell in cells {
            let ([lo, hi], right) = (cell.interval.unwrap(), closed(cell.at[0], cell.at[1]));
            // The closed forms have rounding errors of their own.
            let own = 1e-13 * right.max(0.01);
            assert!(
                lo <= right + own && right - own <= hi,
                "{id} {:?}: {lo} {hi} {right}",
                cell.at
            );
            assert!(
                hi - lo <= 1e-10 * right.max(1e-2),
                "{id} {:?}: {lo} {hi}",
                cell.at
            );
        }
    }
}
