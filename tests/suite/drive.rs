//! Bad input for the periodic drive: a typed error that names the parameter and its range, or a result that says that the motion
//! drifts. Never a panic, never a hang.

use slipbook::motion::drive::{Drive, DriveError, DriveState, Friction, Outcome};
use slipbook::numerics::piecewise::PiecewiseError;
use std::cell::Cell;
use std::f64::consts::{PI, TAU};

const REST: DriveState = DriveState { phi: 0.0, w: 0.0 };

fn sine() -> Drive {
    Drive::new(libm::sin, &[]).unwrap()
}

fn half() -> Friction {
    Friction::new(0.5, 0.5).unwrap()
}

#[track_caller]
fn assert_names<T>(result: Result<T, DriveError>, expected: &str, range: &str) {
    match result {
        Err(error @ DriveError::Parameter { name, .. }) => {
            assert_eq!(name, expected);
            let text = error.to_string();
            assert!(text.contains(expected) && text.contains(range), "{text}");
        }
        Err(other) => panic!("another error: {other}"),
        Ok(_) => panic!("{expected} was accepted"),
    }
}

#[test]
fn friction_below_zero_or_no_number_is_named() {
    for bad in [-1e-300, -0.3, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_names(Friction::new(bad, 0.5), "lambda_plus", "[0, ∞)");
        assert_names(Friction::new(0.5, bad), "lambda_minus", "[0, ∞)");
    }
    // λ₋ = qλ₀ with q < 0.
    let (q, lambda) = (-2.0, 0.3);
    assert_names(Friction::new(lambda, q * lambda), "lambda_minus", "[0, ∞)");
    // No friction at all is a friction, from either side of zero.
    assert!(Friction::new(0.0, -0.0).is_ok());
}

#[test]
fn a_start_that_is_no_number_or_too_large_is_named() {
    let drive = sine();
    for bad in [f64::NAN, f64::INFINITY, -f64::INFINITY, 1e300, -1e10] {
        let phi = DriveState { phi: bad, w: 0.0 };
        let w = DriveState { phi: 0.0, w: bad };
        assert_names(drive.attractor(half(), phi, 50), "phi", "finite");
        assert_names(drive.attractor(half(), w, 50), "w", "finite");
        assert_names(drive.advance(half(), w, 10.0), "w", "finite");
        assert_names(drive.strobe(half(), phi, 3), "phi", "finite");
        assert_names(
            drive.attractors_agree(half(), &[REST, w], 50),
            "w",
            "finite",
        );
    }
}

#[test]
fn an_end_that_does_not_come_after_the_start_is_named() {
    let drive = sine();
    for bad in [-1e-3, f64::NAN, f64::INFINITY, 1e9] {
        assert_names(
            drive.advance(half(), REST, bad),
            "until",
            "[phi, phi + 1e5]",
        );
    }
}

#[test]
fn a_drive_without_a_finite_value_is_refused_where_it_has_none() {
    let nowhere = Drive::new(|_| f64::NAN, &[]);
    assert!(matches!(
        nowhere,
        Err(DriveError::Shape(PiecewiseError::NotFinite { .. }))
    ));
    let infinite = Drive::new(|phi| if phi < PI { 1.0 } else { f64::INFINITY }, &[PI]);
    assert!(matches!(
        infinite,
        Err(DriveError::Shape(PiecewiseError::NotFinite { at, value }))
            if (PI..TAU).contains(&at) && value == f64::INFINITY
    ));
    let overflowing = Drive::new(|phi| libm::exp(1e4 * libm::sin(phi)), &[]);
    assert!(matches!(
        overflowing,
        Err(DriveError::Shape(PiecewiseError::NotFinite { .. }))
    ));
}

#[test]
fn a_drive_that_is_not_piecewise_smooth_is_refused_after_bounded_work() {
    const MOST: u64 = 100_000;
    let asked = Cell::new(0_u64);
    let shapes: [fn(f64) -> f64; 4] = [
        // A jump and a kink that are not listed, a pole, an edge like a root.
        |phi| if phi < 2.0 { 1.0 } else { -1.0 },
        |phi| (phi - 2.0).abs(),
        |phi| 1.0 / (phi - 2.0),
        |phi| libm::sqrt((phi - 2.0).abs()),
    ];
    for h in shapes {
        asked.set(0);
        let guarded = |phi: f64| {
            asked.set(asked.get() + 1);
            // An endless fit is ended here, and fails the test below.
            if asked.get() > MOST { f64::NAN } else { h(phi) }
        };
        let error = Drive::new(guarded, &[]).expect_err("must be refused");
        assert!(asked.get() <= MOST, "asked {} times", asked.get());
        let text = error.to_string();
        assert!(
            text.contains("near 2") || text.contains("near 1.99"),
            "{text}"
        );
    }
}

#[test]
fn breaks_that_are_no_number_are_named_and_others_are_taken_modulo_a_period() {
    for bad in [f64::NAN, f64::INFINITY] {
        let error = Drive::new(libm::sin, &[1.0, bad]).unwrap_err();
        assert!(error.to_string().contains("break"), "{error}");
    }
    let square = |phi: f64| if phi < PI { 1.0 } else { -1.0 };
    let drive = Drive::new(square, &[PI + TAU, -PI, PI, 0.0, TAU]).unwrap();
    assert_eq!(drive.mean(), 0.0);
}

#[test]
fn a_mean_above_the_friction_drifts_and_says_how_fast() {
    for (mean, lambda) in [(0.3, 0.1), (-0.3, 0.1), (1e-3, 0.0), (0.5, 0.5 - 1e-9)] {
        let drive = Drive::new(|phi| mean + libm::sin(phi), &[]).unwrap();
        let friction = Friction::new(lambda, lambda).unwrap();
        for w in [0.0, 5.0, -5.0, 1e9, -1e9] {
            let outcome = drive.attractor(friction, DriveState { phi: 1.0, w }, 100);
            let Ok(Outcome::Drifts { per_period }) = outcome else {
                panic!("mean {mean}, friction {lambda}, from {w}: {outcome:?}");
            };
            let expected = TAU * mean.signum() * (mean.abs() - lambda);
            assert!((per_period - expected).abs() < 1e-14, "{per_period}");
        }
    }
}

#[test]
fn no_period_and_one_are_too_few() {
    let drive = sine();
    for few in [0, 1] {
        let outcome = drive.attractor(half(), REST, few);
        let told = matches!(outcome, Err(DriveError::NotSettled { periods, .. }) if periods == few);
        assert!(told, "{few}: {outcome:?}");
    }
}

#[test]
fn a_drive_that_vanishes_lets_everything_stop_if_there_is_friction() {
    let none = Drive::new(|_| 0.0, &[]).unwrap();
    let start = DriveState { phi: 1.0, w: -3.0 };
    let stopped = none
        .attractor(half(), start, 10)
        .unwrap()
        .settled()
        .unwrap();
    assert_eq!(stopped.w(1.0), 0.0);
    let smooth = Friction::new(0.0, 0.0).unwrap();
    let coasting = none
        .attractor(smooth, start, 10)
        .unwrap()
        .settled()
        .unwrap();
    assert_eq!((coasting.w(1.0), coasting.contraction()), (-3.0, 1.0));
}

#[test]
fn tiny_and_huge_drives_are_the_same_in_their_own_units() {
    let reference = sine();
    let expected = reference.attractor(half(), REST, 100).unwrap();
    let expected = expected.settled().unwrap();
    for size in [1e-12, 1e-3, 1e6] {
        let drive = Drive::new(|phi| size * libm::sin(phi), &[]).unwrap();
        let friction = Friction::new(0.5 * size, 0.5 * size).unwrap();
        let found = drive.attractor(friction, REST, 100).unwrap();
        let found = found.settled().unwrap();
        assert_eq!(found.intervals().len(), expected.intervals().len());
        for k in 0..32 {
            let phi = TAU * f64::from(k) / 32.0;
            let difference = found.w(phi) / size - expected.w(phi);
            assert!(difference.abs() < 1e-12, "{size} {phi} {difference}");
        }
    }
}
