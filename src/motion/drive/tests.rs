use super::*;
use crate::scalar::Scalar;
use proptest::prelude::*;
use std::f64::consts::PI;

const ORIGIN: DriveState = DriveState { phi: 0.0, w: 0.0 };

fn sine() -> Drive {
    Drive::new(<f64 as Scalar>::sin, &[]).unwrap()
}

fn square() -> Drive {
    Drive::new(|x| if x < PI { 1.0 } else { -1.0 }, &[PI]).unwrap()
}

/// 1 and −1 on a share of the half periods, 0 in between.
fn pulses(share: f64) -> Drive {
    let h = move |x: f64| {
        let (sign, x) = if x < PI { (1.0, x) } else { (-1.0, x - PI) };
        if x < share * PI { sign } else { 0.0 }
    };
    Drive::new(h, &[share * PI, PI, PI + share * PI]).unwrap()
}

fn friction(plus: f64, minus: f64) -> Friction {
    Friction::new(plus, minus).unwrap()
}

fn settle(drive: &Drive, plus: f64, minus: f64, start: DriveState) -> Attractor<'_> {
    let outcome = drive.attractor(friction(plus, minus), start, 200).unwrap();
    outcome.settled().expect("settles")
}

#[track_caller]
fn assert_list(attractor: &Attractor, expected: &[(Sign, f64, f64)], tolerance: f64) {
    let found = attractor.intervals();
    assert_eq!(found.len(), expected.len(), "{found:?}");
    for (interval, (sign, start, end)) in found.iter().zip(expected) {
        assert_eq!(interval.sign, *sign, "{found:?}");
        assert!((interval.start - start).abs() < tolerance, "{found:?}");
        assert!((interval.end - end).abs() < tolerance, "{found:?}");
    }
}

use Sign::{Negative, Positive, Rest};

#[test]
fn square_wave_with_little_friction_by_hand() {
    // Slopes 1 − λ and −1 − λ while positive; half a period up to down, so (1−λ)(π − a) = (1+λ) a.
    for lambda in [0.05, 0.5, 0.9] {
        let drive = square();
        let found = settle(&drive, lambda, lambda, DriveState { phi: 1.0, w: 3.0 });
        let a = 0.5 * PI * (1.0 - lambda);
        assert_list(
            &found,
            &[(Positive, a, a + PI), (Negative, a + PI, a + TAU)],
            1e-13,
        );
        let top = found.largest();
        assert!((top.w.abs() - (1.0 - lambda) * (PI - a)).abs() < 1e-13);
        let shrink = (1.0 - lambda) / (1.0 + lambda);
        assert!((found.contraction() - shrink * shrink).abs() < 1e-14);
        assert!((found.margins().crossing - (1.0 - lambda)).abs() < 1e-14);
        assert!(found.displacement().abs() < 1e-12);
        assert!(found.residual() < 1e-13 && !found.grazes());
        // Half a period later, so that it is negative first: the list still begins where w rises.
        let drive = Drive::new(|x| if x < PI { -1.0 } else { 1.0 }, &[PI]).unwrap();
        let found = settle(&drive, lambda, lambda, DriveState { phi: 1.0, w: 3.0 });
        let (rise, fall) = (a + PI, a + TAU);
        assert_list(
            &found,
            &[(Positive, rise, fall), (Negative, fall, rise + TAU)],
            1e-13,
        );
    }
}

#[test]
fn square_wave_with_unequal_friction_by_hand() {
    // Up at a, down at b: (1−p)(π−a) = (1+p)(b−π) and (1−m)(2π−b) = (1+m) a.
    for (p, m) in [(0.3, 0.6), (0.6, 0.3)] {
        let (k, l) = ((1.0 - p) / (1.0 + p), (1.0 - m) / (1.0 + m));
        let a = l * PI * (1.0 - k) / (1.0 - k * l);
        let b = PI + k * (PI - a);
        let drive = square();
        let found = settle(&drive, p, m, ORIGIN);
        assert_list(&found, &[(Positive, a, b), (Negative, b, a + TAU)], 1e-13);
        // Two triangles: displacement is half of base times height.
        let area =
            0.5 * (b - a) * (1.0 - p) * (PI - a) - 0.5 * (a + TAU - b) * (1.0 - m) * (TAU - b);
        assert!((found.displacement() - area).abs() < 1e-12);
        // A small dw is dφ (1 − p) where it rises and dφ (1 + p) where it falls to the next zero; and so below.
        assert!((found.contraction() - k * l).abs() < 1e-14);
        let margins = found.margins();
        assert!((margins.crossing - (1.0 - f64::max(p, m))).abs() < 1e-14);
        let shortest = f64::min(b - a, a + TAU - b);
        assert!((margins.shortest - shortest).abs() < 1e-13);
    }
}

#[test]
fn pulses_with_rest_by_hand() {
    // Up with slope 0.2 to π/2, down with slope −0.8: zero after another π/8.
    let drive = pulses(0.5);
    let found = settle(&drive, 0.8, 0.8, DriveState { phi: 4.0, w: -1.0 });
    let stop = 0.625 * PI;
    assert_list(
        &found,
        &[
            (Positive, 0.0, stop),
            (Rest, stop, PI),
            (Negative, PI, PI + stop),
            (Rest, PI + stop, TAU),
        ],
        1e-13,
    );
    assert!((found.largest().w.abs() - 0.1 * PI).abs() < 1e-13);
    assert!((found.w(0.25 * PI) - 0.05 * PI).abs() < 1e-14);
    assert!((found.w(0.25 * PI - TAU) - 0.05 * PI).abs() < 1e-13);
    assert_eq!(found.w(0.8 * PI), 0.0);
    assert!((found.w(1.55 * PI) + 0.06 * PI).abs() < 1e-13);
    assert!((found.margins().shortest - 0.375 * PI).abs() < 1e-13);
    assert_eq!(found.contraction(), 0.0);
}

/// Composite Gauss-Legendre quadrature of h itself, two points.
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
fn the_approach_has_the_stated_rate_and_length() {
    let drive = sine();
    for lambda in [0.02, 0.1, 0.3, 0.5] {
        let start = DriveState { phi: 0.7, w: 2.5 };
        let found = settle(&drive, lambda, lambda, start);
        let values = drive.strobe(friction(lambda, lambda), start, 2000).unwrap();
        let limit = found.w(0.7);
        assert!((values[2000] - limit).abs() < 1e-11);
        // Among the last distances that are well above rounding, the ratio is the contraction rate.
        let k = values
            .iter()
            .rposition(|w| (w - limit).abs() > 1e-7)
            .unwrap();
        let ratio = (values[k + 1] - limit) / (values[k] - limit);
        assert!((ratio - found.contraction()).abs() < 1e-5, "{ratio}");
        let plain = values
            .windows(2)
            .position(|w| (w[1] - w[0]).abs() <= 1e-12)
            .unwrap() as f64;
        let stated = found.periods().plain.unwrap() as f64;
        assert!(
            (stated - plain).abs() <= 0.15 * plain + 2.0,
            "{stated} {plain}"
        );
    }
    let rest = settle(&drive, 0.8, 0.8, DriveState { phi: 0.0, w: 0.7 }).periods();
    assert_eq!((rest.followed, rest.plain), (2, Some(2)));
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
fn a_mean_above_friction_drifts() {
    let drive = Drive::new(|x| 0.5 + Scalar::sin(x), &[]).unwrap();
    for w in [0.0, -7.0, 1e6] {
        let start = DriveState { phi: 2.0, w };
        let outcome = drive.attractor(friction(0.3, 2.0), start, 100).unwrap();
        let Outcome::Drifts { per_period } = outcome else {
            panic!("must drift")
        };
        assert!((per_period - 0.2 * TAU).abs() < 1e-14);
        assert!(matches!(
            drive.attractor(friction(0.51, 2.0), start, 100).unwrap(),
            Outcome::Settles(_)
        ));
    }
    // A small mean and no friction: thousands of periods until it keeps one sign, but not to be waited for.
    let slow = Drive::new(|x| Scalar::cos(2.0 * x) - 2e-5, &[]).unwrap();
    let outcome = slow.attractor(friction(0.0, 0.0), ORIGIN, 60).unwrap();
    assert!(
        matches!(outcome, Outcome::Drifts { per_period } if (per_period + 4e-5 * PI).abs() < 1e-14)
    );
    let down = Drive::new(|x| -0.5 + Scalar::sin(x), &[]).unwrap();
    let outcome = down.attractor(friction(2.0, 0.3), ORIGIN, 100).unwrap();
    assert!(matches!(outcome, Outcome::Drifts { per_period } if per_period < 0.0));
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
    // So little friction that it takes more periods than there are numbers.
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
fn thresholds_are_as_decided() {
    let drive = sine();
    for lambda in [1.0, 1.0 + 1e-9, 7.0] {
        let found = settle(&drive, lambda, lambda, DriveState { phi: 1.0, w: 20.0 });
        assert_list(&found, &[(Rest, 0.0, TAU)], 1e-15);
        assert!(
            (found.margins().hold - (lambda - 1.0)).abs() < 1e-14,
            "{:?}",
            found.margins()
        );
    }
    // Just below, h − λ = δ − x²/2 + x⁴/24 near the top: from −√(2δ) to 2√(2δ) and, in the next order,
    // longer by the share 0.15 δ.
    for delta in [1e-4, 1e-6, 1e-9, 1e-11] {
        let found = settle(&drive, 1.0 - delta, 1.0 - delta, ORIGIN);
        let list = found.intervals();
        let signs: Vec<Sign> = list.iter().map(|i| i.sign).collect();
        assert_eq!(signs, [Positive, Rest, Negative, Rest]);
        let expected = 3.0 * (2.0 * delta).sqrt() * (1.0 + 0.15 * delta);
        assert!((list[0].length() / expected - 1.0).abs() < delta * delta + 1e-15 / delta);
        assert!((list[2].length() - list[0].length()).abs() < 1e-15 / delta);
    }
}

#[test]
fn a_minimum_of_the_speed_decides_between_one_and_two_intervals() {
    // h = 1, a dip to −b on [1, 2], 1 again to 3, then −1: w at 2 is (1 − λ) − (b + λ).
    let drive = |b: f64| {
        let h = move |x: f64| {
            if x < 1.0 {
                1.0
            } else if x < 2.0 {
                -b
            } else if x < 3.0 {
                1.0
            } else {
                -1.0
            }
        };
        Drive::new(h, &[1.0, 2.0, 3.0]).unwrap()
    };
    for gap in [1e-3, 1e-6, 1e-9, 1e-12] {
        let above = drive(0.4 - gap);
        let found = settle(&above, 0.3, 1.5, ORIGIN);
        assert_eq!(found.intervals().len(), 2);
        assert!((found.margins().dip - gap).abs() < 1e-15);
        let below = drive(0.4 + gap);
        let found = settle(&below, 0.3, 1.5, ORIGIN);
        assert_eq!(found.intervals().len(), 4);
        // It rests from the zero at slope −0.7 − gap until the jump.
        assert!((found.margins().shortest - gap / (0.7 + gap)).abs() < 3e-15);
    }
    let touching = drive(0.4);
    let found = settle(&touching, 0.3, 1.5, ORIGIN);
    assert_eq!(found.intervals().len(), 2);
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
                // Over one period w returns.
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
fn the_approach_from_close_by_is_counted_too() {
    let drive = sine();
    for lambda in [0.1, 0.3] {
        let far = settle(&drive, lambda, lambda, DriveState { phi: 0.7, w: 2.5 });
        for apart in [1e-3, 1e-6, -1e-6] {
            let start = DriveState {
                phi: 0.7,
                w: far.w(0.7) + apart,
            };
            let found = settle(&drive, lambda, lambda, start);
            let values = drive.strobe(friction(lambda, lambda), start, 400).unwrap();
            let pairs = values.windows(2);
            let plain = pairs
                .map(|w| (w[1] - w[0]).abs())
                .position(|c| c <= 1e-12)
                .unwrap();
            let stated = found.periods().plain.unwrap();
            assert!(stated.abs_diff(plain as u64) <= 2, "{stated} {plain}");
        }
    }
}

#[test]
fn the_first_of_the_neutral_motions_is_found_from_below_and_above() {
    // The mean is the friction on the way up. From below, two zeros per period: accelerated, and past the motion
    // that touches zero where h is curved so. It touches where h jumps up, at φ = 0.
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
fn a_motion_that_touches_zero_is_listed_from_there() {
    let biased = Drive::new(|x| if x < PI { 1.5 } else { -0.5 }, &[PI]).unwrap();
    for phi in [0.0, 1.0, 4.0] {
        let found = settle(&biased, 0.5, 3.0, DriveState { phi, w: -9.0 });
        assert_list(&found, &[(Positive, 0.0, TAU)], 1e-13);
        assert!(found.w(0.0).abs() < 1e-13);
        // What happens at the ends of the stretch, here at 0, is no graze.
        assert_eq!(found.grazes(), phi > 0.0);
    }
}

#[test]
fn the_residual_is_what_the_last_period_changed() {
    // A mean that is next to nothing, without friction: w grows by it every period.
    let drive = Drive::new(|x| if x < PI { 1.0 } else { f64::EPSILON - 1.0 }, &[PI]).unwrap();
    let found = settle(&drive, 0.0, 0.0, DriveState { phi: 0.0, w: 3.0 });
    assert!(found.residual() > 0.0);
    assert_eq!(found.residual(), (drive.mean() * TAU).abs());
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
    // Not at the ends.
    assert!(!drops(&[1.0, 1.0, 2.0]) && !drops(&[1.0, 7.0, 7.0]));
}

#[test]
fn a_rest_under_a_steady_drive_holds_by_what_is_left() {
    for h in [0.3, -0.3] {
        let drive = Drive::new(move |_| h, &[]).unwrap();
        let found = settle(&drive, 0.5, 0.6, ORIGIN);
        let expected = if h > 0.0 { 0.2 } else { 0.3 };
        assert!(
            (found.margins().hold - expected).abs() < 1e-15,
            "{:?}",
            found.margins()
        );
    }
}

#[test]
fn a_motion_of_one_sign_dips_where_the_drive_passes_the_friction() {
    // h = sin(φ − 1) without friction, w = 5 at 0.5: least at φ = 1, by cos 0.5.
    let drive = Drive::new(|x| Scalar::sin(x - 1.0), &[]).unwrap();
    for side in [1.0, -1.0] {
        let phi = if side > 0.0 { 0.5 } else { 0.5 + PI };
        let found = settle(&drive, 0.0, 0.0, DriveState { phi, w: 5.0 * side });
        let dip = 4.0 + libm::cos(0.5);
        assert!(
            (found.margins().dip - dip).abs() < 1e-14,
            "{:?}",
            found.margins()
        );
    }
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
    // h = x − 1/2 up to 1, λ = 1/2: w = w₀ − x + x²/2 is w₀ − 1/2 there.
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

#[test]
fn a_rest_holds_by_what_a_jump_leaves() {
    // 0, then a jump to the level of the drive, from where it falls evenly to 0 again.
    for (level, hold) in [(0.4, 0.1), (0.5, 0.0)] {
        for side in [1.0, -1.0] {
            let h = move |x: f64| match x < 1.0 {
                true => 0.0,
                false => side * level * (TAU - x) / (TAU - 1.0),
            };
            let drive = Drive::new(h, &[1.0]).unwrap();
            let (p, m) = if side > 0.0 { (0.5, 0.8) } else { (0.8, 0.5) };
            let found = settle(&drive, p, m, ORIGIN);
            assert_list(&found, &[(Rest, 0.0, TAU)], 1e-15);
            let margins = found.margins();
            assert!((margins.hold - hold).abs() < 1e-15, "{level} {margins:?}");
        }
    }
}
