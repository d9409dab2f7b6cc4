use super::*;
use crate::scalar::Scalar;
use proptest::prelude::*;
use std::f64::consts::PI;

fn sine() -> Drive {
    Drive::new(<f64 as Scalar>::sin, &[]).unwrap()
}

#[test]
fn a_passage_through_zero_multiplies_the_logarithm() {
    // w_x falls through zero where h = −1. Across the layer a falls and b rises at constant rates, so ln w_y is multiplied by (1
    // + λ)/(1 − λ), up to terms that do not grow with it.
    let drive = Drive::new(|x| if x < PI { 1.0 } else { -1.0 }, &[PI]).unwrap();
    for lambda in [0.1, 0.4] {
        let through = |ln_w_y: f64| {
            let start = PlanarState {
                phi: 3.5,
                w_x: 0.3,
                ln_w_y,
            };
            drive.planar(lambda, start, &[4.5]).unwrap()[0].ln_w_y
        };
        let slope = (through(-3000.0) - through(-2000.0)) / -1000.0;
        let expected = (1.0 + lambda) / (1.0 - lambda);
        assert!((slope / expected - 1.0).abs() < 1e-12, "{slope} {expected}");
        // Nothing happens at the depth where the linear law takes over.
        let shallow = (through(-40.0) - through(-20.0)) / -20.0;
        assert!(
            (shallow / expected - 1.0).abs() < 1e-9,
            "{shallow} {expected}"
        );
    }
}

#[test]
fn without_drive_and_friction_nothing_changes() {
    let drive = Drive::new(|_| 0.0, &[]).unwrap();
    let start = PlanarState {
        phi: 0.0,
        w_x: -0.5,
        ln_w_y: 0.0,
    };
    for state in drive.planar(0.0, start, &[0.0, 1.0, 20.0]).unwrap() {
        assert!((state.w_x + 0.5).abs() < 1e-15 && state.ln_w_y.abs() < 1e-15);
    }
}

#[test]
fn bad_input_is_named() {
    let drive = sine();
    let start = PlanarState {
        phi: 0.0,
        w_x: 0.2,
        ln_w_y: 1.0,
    };
    assert!(drive.planar(-1.0, start, &[1.0]).is_err());
    assert!(drive.planar(0.5, start, &[1.0, 0.5]).is_err());
    assert!(drive.planar(0.5, start, &[f64::NAN]).is_err());
    let huge = PlanarState {
        ln_w_y: 1e3,
        ..start
    };
    assert!(drive.planar(0.5, huge, &[1.0]).is_err());
}

proptest! {
    #[test]
    fn never_panics_and_falls_for_ever(
        lambda in prop_oneof![Just(0.0), 0.0..1.5f64],
        phase in 0.0..TAU,
        second in -1.0..1.0f64,
        w_x in prop_oneof![Just(0.0), -2.0..2.0f64],
        ln_w_y in prop_oneof![-5.0..3.0f64, -2000.0..-5.0f64],
    ) {
        let drive = Drive::new(|x| Scalar::sin(x) + second * Scalar::sin(2.0 * x), &[]).unwrap();
        let start = PlanarState { phi: phase, w_x, ln_w_y };
        let phases: Vec<f64> = (0..60).map(|k| phase + 0.3 * k as f64).collect();
        let states = drive.planar(lambda, start, &phases).unwrap();
        prop_assert!(states.iter().all(|s| s.w_x.is_finite()));
        for pair in states.windows(2) {
            let (before, after) = (pair[0].ln_w_y, pair[1].ln_w_y);
            let rounding = 1e-13 * (1.0 + after.abs());
            prop_assert!(after == f64::NEG_INFINITY || after <= before + rounding);
        }
    }
}

#[test]
fn where_it_has_stopped_it_rests_in_whatever_turn() {
    // With λ = 0.8 on a sine, which is stronger between 0.927 and 2.214: it stops soon after that.
    let drive = sine();
    let friction = Friction::new(0.8, 0.8).unwrap();
    let turn = |k: usize| TAU * k as f64;
    for k in [0, 3, 40] {
        let start = PlanarState {
            phi: turn(k),
            w_x: -2.8,
            ln_w_y: -0.6,
        };
        let phases = [2.2, 2.6, 4.5].map(|phi| phi + turn(k));
        let [moving, resting, later] = drive.planar(0.8, start, &phases).unwrap()[..] else {
            panic!()
        };
        assert!(moving.w_x != 0.0, "{moving:?}");
        assert_eq!((resting.w_x, resting.ln_w_y), (0.0, f64::NEG_INFINITY));
        let rest = DriveState { phi: 2.6, w: 0.0 };
        let expected = drive.advance(friction, rest, 4.5).unwrap().end.w;
        assert!(expected < -0.04 && (later.w_x - expected).abs() < 1e-12);
    }
}

#[test]
fn phases_far_out_count_from_the_start() {
    let start = PlanarState {
        phi: 6e4,
        w_x: 0.2,
        ln_w_y: 0.0,
    };
    let [end] = sine().planar(0.3, start, &[6e4 + 1.0]).unwrap()[..] else {
        panic!()
    };
    let near = PlanarState {
        phi: 6e4_f64.rem_euclid(TAU),
        ..start
    };
    let [expected] = sine().planar(0.3, near, &[near.phi + 1.0]).unwrap()[..] else {
        panic!()
    };
    assert!((end.w_x - expected.w_x).abs() < 1e-10);
    assert!((end.ln_w_y - expected.ln_w_y).abs() < 1e-10);
    assert!(sine().planar(0.3, start, &[1.7e5]).is_err());
}
