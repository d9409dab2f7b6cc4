use super::*;
use crate::scalar::Scalar;
use proptest::prelude::*;
use std::f64::consts::PI;

const ORIGIN: DriveState = DriveState { phi: 0.0, w: 0.0 };

fn sine() -> Drive {
    Drive::new(<f64 as Scalar>::sin, &[]).unwrap()
}

fn friction(plus: f64, minus: f64) -> Friction {
    Friction::new(plus, minus).unwrap()
}

fn settle(drive: &Drive, plus: f64, minus: f64, start: DriveState) -> Attractor<'_> {
    let outcome = drive.attractor(friction(plus, minus), start, 200).unwrap();
    outcome.settled().expect("settles")
}

use Sign::{Negative, Positive, Rest};

/// Two points of h itself, composite Gauss–Legendre.
fn quadrature(h: impl Fn(f64) -> f64, a: f64, b: f64) -> f64 {
    let n = 4000;
    let half = 0.5 * (b - a) / n as f64;
    let offset = half / 3.0_f64.sqrt();
    (0..n)
        .map(|k| {
            let middle = a + (2 * k + 1) as f64 * half;
            half * (h(middle - offset) + h(middle + offset))
        })
        .sum()
}

#[test]
fn every_end_is_an_event_of_the_equation() {
    let h = |x: f64| Scalar::sin(x) + 0.6 * Scalar::cos(2.0 * x + 1.0);
    let drive = Drive::new(h, &[]).unwrap();
    let mut kinds = std::collections::BTreeSet::new();
    for i in 0..12 {
        for j in 0..12 {
            let (p, m) = (0.03 + 0.12 * i as f64, 0.05 + 0.11 * j as f64);
            let found = settle(&drive, p, m, ORIGIN);
            let list = found.intervals();
            kinds.insert(list.iter().map(|i| i.sign).collect::<Vec<_>>());
            for (k, now) in list.iter().enumerate() {
                let next = list[(k + 1) % list.len()].sign;
                let gained = quadrature(h, now.start, now.end);
                match now.sign {
                    Rest if list.len() == 1 => {
                        assert!((0..99).all(|k| (-m..=p).contains(&h(0.0635 * k as f64))));
                    }
                    Rest => {
                        let level = if next == Positive { p } else { -m };
                        assert!((h(now.end) - level).abs() < 1e-14, "{p} {m} {list:?}");
                    }
                    Positive => assert!((gained - p * now.length()).abs() < 1e-12),
                    Negative => assert!((gained + m * now.length()).abs() < 1e-12),
                }
                if now.sign != Rest && next == Rest {
                    assert!((-m - 1e-14..=p + 1e-14).contains(&h(now.end)));
                }
                let middle = 0.5 * (now.start + now.end);
                assert_eq!(Sign::of(found.w(middle)), now.sign);
            }
        }
    }
    assert!(kinds.len() >= 5, "{kinds:?}");
}

#[test]
fn a_kink_of_the_return_map_does_not_catch_the_acceleration() {
    let sum = |x: f64| Scalar::sin(x) + Scalar::sin(2.0 * x + 1.57);
    let drive = Drive::new(|x| 0.5 * sum(x), &[]).unwrap();
    for k in 0..40 {
        let lambda = 0.03 + 1e-4 * k as f64;
        for w in [0.5, 0.0, -0.1, -0.5] {
            let found = settle(&drive, lambda, lambda, DriveState { phi: 0.0, w });
            assert!(
                found.periods().followed < 40,
                "{lambda} {w} {:?}",
                found.periods()
            );
        }
    }
}

#[test]
fn neutral_motions_are_said_to_be_neutral() {
    let drive = sine();
    for w in [0.0, 0.3, -4.0] {
        let start = DriveState { phi: 0.0, w };
        let found = settle(&drive, 0.0, 0.0, start);
        assert!((found.w(0.0) - w).abs() < 1e-13);
        assert!((found.w(PI) - w - 2.0).abs() < 1e-13);
        assert_eq!(found.contraction(), 1.0);
    }
    let still = Drive::new(|_| 0.0, &[]).unwrap();
    let found = settle(&still, 0.0, 5e-324, DriveState { phi: 0.0, w: -0.9 });
    assert_eq!(found.w(1.0), -0.9);
    // The mean is exactly the friction: from below, the motion climbs to the one that touches zero.
    let biased = Drive::new(|x| if x < PI { 1.5 } else { -0.5 }, &[PI]).unwrap();
    let found = settle(&biased, 0.5, 3.0, DriveState { phi: 0.0, w: -9.0 });
    assert!((0..99).all(|k| found.w(0.0635 * k as f64) >= 0.0));
    assert!((found.largest().w - PI).abs() < 1e-9, "{found:?}");
    assert!(found.w(0.0).abs() < 1e-9);
}

#[test]
fn advancing_in_parts_is_advancing_at_once() {
    let drive = Drive::new(|x| Scalar::sin(x) + 0.7 * Scalar::sin(2.0 * x), &[]).unwrap();
    let friction = friction(0.4, 0.3);
    let start = DriveState { phi: -3.0, w: 0.2 };
    let whole = drive.advance(friction, start, 20.0).unwrap();
    let mut state = start;
    for k in 1..=46 {
        state = drive
            .advance(friction, state, -3.0 + 0.5 * k as f64)
            .unwrap()
            .end;
    }
    assert!((whole.end.w - state.w).abs() < 1e-13);
    assert_eq!(whole.intervals[0].start, -3.0);
    assert_eq!(whole.intervals.last().unwrap().end, 20.0);
    let still = drive.advance(friction, start, -3.0).unwrap();
    assert_eq!((still.end, still.intervals.len()), (start, 0));
}

proptest! {
    #[test]
    fn any_drive_settles_or_drifts(
        mean in -0.4..0.4f64,
        a in prop::array::uniform3(-1.0..1.0f64),
        b in prop::array::uniform3(-1.0..1.0f64),
        jump in prop::option::of((0.0..TAU, -1.0..1.0f64)),
        p in prop_oneof![Just(0.0), 0.0..2.0f64, 0.0..1e-3f64],
        m in prop_oneof![Just(0.0), 0.0..2.0f64, 0.0..1e-3f64],
        phi in -10.0..10.0f64,
        w in prop_oneof![Just(0.0), -3.0..3.0f64, -1e6..1e6f64],
    ) {
        let h = |x: f64| {
            let smooth: f64 = (0..3)
                .map(|k| {
                    let x = (k + 1) as f64 * x;
                    a[k] * Scalar::sin(x) + b[k] * Scalar::cos(x)
                })
                .sum();
            mean + smooth + jump.map_or(0.0, |(at, by)| if x < at { by } else { 0.0 })
        };
        let breaks: Vec<f64> = jump.iter().map(|j| j.0).collect();
        let drive = Drive::new(h, &breaks).unwrap();
        let friction = friction(p, m);
        match drive.attractor(friction, DriveState { phi, w }, 300).unwrap() {
            Outcome::Drifts { per_period } => {
                prop_assert!(drive.mean() > p && per_period > 0.0 || drive.mean() < -m && per_period < 0.0);
            }
            Outcome::Settles(found) => {
                prop_assert!((-m - 1e-14..=p + 1e-14).contains(&drive.mean()));
                let list = found.intervals();
                prop_assert!((0.0..TAU).contains(&list[0].start));
                let mut net = 0.0;
                for (k, now) in list.iter().enumerate() {
                    prop_assert!(now.length() > 0.0);
                    let end = list.get(k + 1).map_or(list[0].start + TAU, |next| next.start);
                    prop_assert!((now.end - end).abs() < 4e-15);
                    net += match now.sign {
                        Rest => 0.0,
                        Positive => -p * now.length(),
                        Negative => m * now.length(),
                    };
                    net += match now.sign {
                        Rest => 0.0,
                        _ => drive.shape().antiderivative(now.end) - drive.shape().antiderivative(now.start),
                    };
                }
                prop_assert!(net.abs() < 1e-11, "{net}");
                let after = drive.strobe(friction, DriveState { phi, w: found.w(phi) }, 3).unwrap();
                let allowed = 1e-11 + 10.0 * found.residual();
                prop_assert!((after[3] - after[0]).abs() < allowed, "{after:?} {found:?}");
                let margins = found.margins();
                for value in [margins.shortest, margins.dip, margins.crossing, margins.hold] {
                    prop_assert!(value >= -1e-12);
                }
                prop_assert!(found.displacement().is_finite() && found.largest().w.is_finite());
                prop_assert!((0.0..=1.0).contains(&found.contraction()));
            }
        }
    }
}

#[test]
fn the_first_of_the_neutral_motions_is_found_from_below_and_above() {
    // From below, two zeros per period: accelerated, and past the motion that touches zero where h is curved so. It touches where
    // h jumps up, at φ = 0.
    for slope in [0.6, -0.6] {
        for side in [1.0, -1.0] {
            let h = move |x: f64| {
                side * if x < PI {
                    1.5
                } else {
                    -0.5 + slope * (x / PI - 1.5)
                }
            };
            let drive = Drive::new(h, &[PI]).unwrap();
            let (plus, minus) = if side > 0.0 { (0.5, 0.1) } else { (0.1, 0.5) };
            for w in [-0.3, -2.0, -9.0] {
                let start = DriveState {
                    phi: 0.0,
                    w: side * w,
                };
                let found = settle(&drive, plus, minus, start);
                assert!(found.w(0.0).abs() < 1e-12, "{found:?}");
                assert!((found.w(PI) - side * PI).abs() < 1e-12, "{found:?}");
            }
        }
    }
}

#[test]
fn lengths_of_zero_inside_a_stretch_are_noticed() {
    let marks = |list: &[f64]| -> Vec<Mark> {
        let signs = [Positive, Rest, Negative].into_iter().cycle();
        let pairs = list.iter().zip(signs);
        pairs.map(|(&phi, sign)| Mark { phi, sign }).collect()
    };
    let drops = |list: &[f64]| intervals::drops_one(&marks(list), 7.0);
    assert!(drops(&[1.0, 2.0, 2.0]) && drops(&[0.5, 1.0, 3.0, 3.0, 4.0]));
    assert!(!drops(&[1.0, 2.0, 3.0]) && !drops(&[1.0]));
    assert!(drops(&[0.125, 0.5, 0.5 + 0.9e-14]) && !drops(&[0.125, 0.5, 0.5 + 1.1e-14]));
    assert!(!drops(&[1.0, 1.0, 2.0]) && !drops(&[1.0, 7.0, 7.0]));
}

#[test]
fn a_drive_that_comes_back_to_the_friction_at_a_jump_has_stopped_the_motion() {
    // h = x − 1/2 up to 1, λ = 1/2, w = 1/4 at 0: w = 1/4 − x + x²/2 vanishes at 1 − √½.
    let h = |x: f64| if x < 1.0 { x - 0.5 } else { -0.4 };
    for side in [1.0, -1.0] {
        let drive = Drive::new(move |x| side * h(x), &[1.0]).unwrap();
        let start = DriveState {
            phi: 0.0,
            w: 0.25 * side,
        };
        let path = drive.advance(friction(0.5, 0.5), start, 1.0).unwrap();
        assert_eq!((path.end.w, path.contraction), (0.0, 0.0));
        let [moving, rest] = path.intervals[..] else {
            panic!("{path:?}")
        };
        assert!((moving.end - (1.0 - libm::sqrt(0.5))).abs() < 1e-14);
        assert_eq!((rest.sign, rest.end), (Rest, 1.0));
    }
}

#[test]
fn what_touches_zero_where_the_drive_is_back_at_the_level_grazes() {
    for side in [1.0, -1.0] {
        let h = move |x: f64| side * if x < 1.0 { x - 0.5 } else { 1.5 };
        let drive = Drive::new(h, &[1.0]).unwrap();
        for (w, touches, sign) in [(0.5, true, 1.0), (0.51, false, 1.0), (0.49, false, 0.0)] {
            let mut walker = Walker::new(&drive, friction(0.5, 0.5), 0.0, side * w);
            walker.run_to(drive.shape().locate(1.0), &mut Vec::new());
            assert_eq!(walker.touches(), touches, "{w}");
            let now = side * walker.w();
            assert!((now - sign * (w - 0.5)).abs() < 1e-15, "{w} {now}");
        }
    }
}
