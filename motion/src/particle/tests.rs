//! Motions whose course is known without this integrator.

use super::*;
use crate::fitted::tests::noisy;
use crate::numerics::{series::value_slope, taylor::TERMS};
use crate::trajectory::SlideStep;
use crate::{Plane, Series, Signal};
use proptest::prelude::*;
use std::f64::consts::PI;

fn near(found: f64, expected: f64, relative: f64) {
    assert!(
        (found - expected).abs() <= relative * expected.abs(),
        "{found:e} {expected:e}"
    );
}

fn go(plane: &dyn Acceleration, friction: f64, v: [f64; 2], until: f64) -> Motion {
    run(plane, friction, State::moving(v), until).unwrap()
}

#[test]
fn one_dimension_by_hand() {
    // −A = (1, 0). Against it with μg = 1/2: slows at 3/2, from 3 in time 2 over 3, then runs back at 1/2.
    let plane = Plane::constant([-1.0, 0.0]);
    let motion = go(&plane, 0.5, [-3.0, 0.0], 6.0);
    assert_eq!(motion.stops().len(), 1);
    near(motion.stops()[0], 2.0, 4e-15);
    assert_eq!(motion.starts(), motion.stops());
    let slides = motion.phases().iter().map(|p| (p.kind, p.from, p.to));
    let stop = motion.stops()[0];
    assert!(slides.eq([(PhaseKind::Slide, 0.0, stop), (PhaseKind::Slide, stop, 6.0)]));
    near(motion.at(1.0).unwrap().v[0], -1.5, 4e-15);
    near(motion.at(4.0).unwrap().v[0], 1.0, 4e-15);
    near(motion.end().x[0], -3.0 + 0.25 * 16.0, 1e-13);
    assert_eq!(motion.end().v[1], 0.0);
    // μg = 2: it sticks there. With the pull: slows at 1.
    for (vx, friction, stop, way) in [
        (-3.0, 2.0, 1.0, -1.5),
        (3.0, 2.0, 3.0, 4.5),
        (-3.0, 1.0, 1.5, -2.25),
    ] {
        let motion = go(&plane, friction, [vx, 0.0], 100.0);
        near(motion.first_stop().unwrap(), stop, 4e-15);
        near(motion.end().x[0], way, 4e-15);
        assert_eq!(
            motion.phases().iter().map(|p| p.kind).collect::<Vec<_>>(),
            [PhaseKind::Slide, PhaseKind::Stick]
        );
        assert_eq!(motion.end().v, [0.0; 2]);
    }
    let motion = go(&plane, 1.0, [3.0, 0.0], 1e9);
    assert_eq!((motion.first_stop(), motion.end().v), (None, [3.0, 0.0]));
    let slow = (1.0 + 1e-9) - 1.0;
    let motion = go(&plane, 1.0 + 1e-9, [3.0, 0.0], 1e10);
    near(motion.first_stop().unwrap(), 3.0 / slow, 1e-13);
    let motion = go(&plane, 1.0 - 1e-9, [3.0, 0.0], 1e10);
    near(motion.end().v[0], 3.0 + (1.0 - (1.0 - 1e-9)) * 1e10, 1e-13);
}

#[test]
fn nearly_against_the_pull() {
    // The speed dips far below the offset 10⁻¹²; from there it goes as from a stop at 2/3·…: same end.
    let plane = Plane::constant([-1.0, 0.0]);
    let exact = go(&plane, 0.5, [-3.0, 0.0], 6.0).end();
    let near_by = go(&plane, 0.5, [-3.0, 3e-12], 6.0);
    assert!(near_by.stops().is_empty());
    assert!((near_by.end().v[0] - exact.v[0]).abs() < 1e-11 && near_by.end().v[1] > 0.0);
    // Both stop, at times that differ by the order of the offset squared.
    let exact = go(&plane, 1.5, [-3.0, 0.0], 6.0).first_stop().unwrap();
    let near_by = go(&plane, 1.5, [-3.0, 3e-12], 6.0).first_stop().unwrap();
    near(near_by, exact, 1e-14);
}

#[test]
fn mirrored_bit_for_bit() {
    let plane = Plane::rotating(Signal::constant(1.5), 1.0, 0.7);
    let mirror = Plane::rotating(Signal::constant(1.5), 1.0, 0.7);
    let mirror = Plane {
        y: mirror.y.times(-1.0),
        ..mirror
    };
    for v in [[0.0, 0.0], [-1.0, 0.4]] {
        let one = go(&plane, 0.9, v, 5.0);
        let two = run(&mirror, 0.9, State::moving([v[0], -v[1]]), 5.0).unwrap();
        assert_eq!(one.nodes().count(), two.nodes().count());
        for (a, b) in one.nodes().zip(two.nodes()) {
            assert_eq!(
                (a.t, a.v[0], a.x[0], a.v[1], a.x[1]),
                (b.t, b.v[0], b.x[0], -b.v[1], -b.x[1])
            );
        }
    }
}

#[test]
fn scaled_by_powers_of_two_bit_for_bit() {
    // Twice the time at the same accelerations: twice the speed, four times the way.
    let one = run_to_stop(
        &Plane::constant([0.3, -0.8]),
        1.1,
        State::moving([1.0, 0.3]),
        100.0,
    )
    .unwrap();
    let two = run_to_stop(
        &Plane::constant([0.3, -0.8]),
        1.1,
        State::moving([2.0, 0.6]),
        200.0,
    )
    .unwrap();
    assert_eq!(2.0 * one.first_stop().unwrap(), two.first_stop().unwrap());
    assert_eq!(4.0 * one.end().x[1], two.end().x[1]);
    let two = run_to_stop(
        &Plane::constant([8.0 * 0.3, 8.0 * -0.8]),
        8.0 * 1.1,
        State::moving([2.0, 0.6]),
        100.0,
    )
    .unwrap();
    assert_eq!(0.25 * one.first_stop().unwrap(), two.first_stop().unwrap());
}

#[test]
fn a_turning_pull_that_is_just_held_is_held() {
    // What rounding makes of the derivatives of |A|² sets nothing off. A little more does.
    for k in 0..20 {
        let starts = |amplitude, until| {
            let plane = Plane::rotating(Signal::constant(amplitude), 2.0, 0.3 * f64::from(k));
            let motion = go(&plane, 1.0, [0.0; 2], until);
            motion.starts().to_vec()
        };
        assert_eq!(starts(1.0, 2.0), [0.0; 0], "{k}");
        assert_eq!(starts(1.0 + 1e-12, 1e-6), [0.0], "{k}");
    }
}

#[test]
fn the_next_jump_is_found_from_just_before_each() {
    for (start, half) in [(0.1, 0.3), (-0.7, 0.1), (1e3, 1.0 / 3.0)] {
        let square = Signal::Square { start, half };
        for n in -300..300 {
            let jump = start + f64::from(n) * half;
            assert_eq!(square.next_break(jump.next_down()), Some(jump), "{n}");
            assert_eq!(
                square.next_break(jump),
                Some(start + f64::from(n + 1) * half),
                "{n}"
            );
        }
    }
}

#[test]
fn jumps_are_met_exactly() {
    // From rest at the jump to +1: v = −3/4 t, then slows at 5/4 to rest at 1.6, then the other way at 3/4 until 2: +0.3; there
    // slows at 5/4 until 2.24.
    let square = Plane::along(
        [1.0, 0.0],
        Signal::Square {
            start: 0.0,
            half: 1.0,
        },
    );
    let motion = go(&square, 0.25, [0.0; 2], 2.5);
    near(motion.at(1.0).unwrap().v[0], -0.75, 1e-14);
    near(motion.stops()[0], 1.6, 1e-14);
    near(motion.at(2.0).unwrap().v[0], 0.3, 1e-14);
    near(motion.stops()[1], 2.24, 1e-14);
    assert_eq!(motion.starts().len(), 3);
    let pulse = Plane::along(
        [0.0, -1e3],
        Signal::Pulse {
            from: 5.0,
            to: 5.001,
        },
    );
    let motion = go(&pulse, 1.0, [0.0; 2], 100.0);
    assert_eq!(motion.starts(), [5.0]);
    near(motion.stops()[0], 5.001 + 0.999, 1e-13);
    let bump = Plane::along(
        [0.0, -1.0],
        Signal::Gaussian {
            centre: 500.0,
            width: 0.01,
        },
    );
    let motion = go(&bump, 0.0, [1.0, 0.0], 1000.0);
    // Rounding of a time near 500 is 10⁻¹¹ of the width.
    near(motion.end().v[1], 0.01 * libm::sqrt(PI), 1e-12);
}

#[test]
fn a_user_function_is_an_acceleration() {
    let given = |t: f64| {
        let mut a = [[0.0; TERMS]; 2];
        (a[0][0], a[0][1]) = (-t, -1.0);
        a
    };
    let given = Series::new(given, [0.0, 3.0]).unwrap();
    let motion = go(&given, 0.0, [0.0, 1.0], 3.0);
    near(motion.end().v[0], 4.5, 1e-14);
}

#[test]
fn bad_input_is_named() {
    let plane = Plane::constant([1.0, 0.0]);
    let name = |result: Result<Motion, MotionError>| match result {
        Err(MotionError::Argument { name, .. }) => name,
        other => panic!("{other:?}"),
    };
    let start = State::moving([1.0, 0.0]);
    assert_eq!(name(run(&plane, -0.1, start, 1.0)), "friction");
    assert_eq!(name(run(&plane, f64::NAN, start, 1.0)), "friction");
    assert_eq!(name(run(&plane, 1.0, start, -1.0)), "until");
    assert_eq!(name(run(&plane, 1.0, start, f64::INFINITY)), "until");
    assert_eq!(
        name(run(&plane, 1.0, State::moving([1.0, f64::NAN]), 1.0)),
        "v_y of the start"
    );
    assert_eq!(
        name(run(&Plane::constant([f64::NAN, 0.0]), 1.0, start, 1.0)),
        "|A|"
    );
    let motion = run(&plane, 1.0, start, 1.0).unwrap();
    assert_eq!(name(motion.at(1.5).map(|_| motion.clone())), "t");
    assert_eq!(
        name(motion.first_along([0.0, 0.0]).map(|_| motion.clone())),
        "length of direction"
    );
    let busy = Plane::along(
        [1.0, 0.0],
        Signal::Square {
            start: 0.0,
            half: 1e-6,
        },
    );
    assert!(matches!(
        run(&busy, 0.1, start, 1e3),
        Err(MotionError::Steps { .. })
    ));
}

fn finite(state: State) -> bool {
    [state.t, state.v[0], state.v[1], state.x[0], state.x[1]]
        .iter()
        .all(|x| x.is_finite())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(200))]

    #[test]
    fn any_reasonable_motion_exists(
        a in prop::array::uniform2(-3.0..3.0),
        frequency in -5.0..5.0,
        friction in 0.0..4.0,
        v in prop::array::uniform2(-3.0..3.0),
    ) {
        let sine = Signal::Sine { frequency, phase: 1.0 };
        let plane = Plane { x: sine.times(a[0]), y: Signal::constant(a[1]) };
        let motion = go(&plane, friction, v, 10.0);
        let phases = motion.phases();
        prop_assert_eq!(phases[0].from, 0.0);
        prop_assert_eq!(phases[phases.len() - 1].to, 10.0);
        prop_assert!(phases.windows(2).all(|pair| pair[0].to == pair[1].from));
        for i in 0..=50 {
            let state = motion.at(0.2 * i as f64).unwrap();
            prop_assert!(finite(state));
        }
    }
}

/// Where |A| exceeds the friction 1 by e − c t², a slip lasts from −√(e/c) to 2√(e/c) and goes 9e²/(4c), but for parts of the
/// order of e.
#[test]
fn a_slip_takes_as_many_steps_however_slow_it_is() {
    for (k, turning) in [(2, 0.2), (3, -0.2), (4, 0.5), (6, 0.2), (8, 0.1)] {
        let e = libm::pow(10.0, -f64::from(k));
        let c = 1.0 - 0.5 * turning * turning;
        let plane = Plane {
            x: Signal::Polynomial(vec![1.0 + e, 0.0, -1.0]),
            y: Signal::Polynomial(vec![0.0, turning]),
        };
        let start = State {
            t: -0.9,
            ..State::moving([0.0; 2])
        };
        let motion = run(&plane, 1.0, start, 0.9).unwrap();
        let [begin, stop] = [motion.starts()[0], motion.stops()[0]];
        let half = libm::sqrt(e / c);
        near(stop - begin, 3.0 * half, 2.0 * e + 1e-8);
        near(-motion.end().x[0], 2.25 * e * e / c, 4.0 * e + 1e-7);
        let most = if k < 3 { 400 } else { 20 };
        assert!(motion.nodes().count() < most, "{e}");
    }
}

/// Each with the friction that brings closest to rest, halved until the difference tells how far they are from the motion.
#[test]
fn a_noisy_record_moves_a_block_as_short_steps_do() {
    for seed in 0..4 {
        let plane = noisy(0.0, 600, seed);
        let holding = 1.96 + 0.1 * f64::from(seed as u32);
        let stepped = |parts: u32| {
            let h = 0.002 / f64::from(parts);
            let (mut v, mut x) = ([0.0_f64; 2], [0.0_f64; 2]);
            for k in 0..599 * parts {
                let a = plane.coefficients((f64::from(k) + 0.5) * h).map(|c| c[0]);
                if v == [0.0; 2] && libm::hypot(a[0], a[1]) <= holding {
                    continue;
                }
                let free = [0, 1].map(|i| v[i] - h * a[i]);
                let speed = libm::hypot(free[0], free[1]);
                let kept = (1.0 - 1.96 * h / speed).max(0.0);
                for i in 0..2 {
                    x[i] += 0.5 * h * (v[i] + kept * free[i]);
                    v[i] = kept * free[i];
                }
            }
            [v[0], v[1], x[0], x[1]]
        };
        let [coarse, fine] = [stepped(40), stepped(80)];
        let friction = Friction {
            kinetic: 1.96,
            holding,
        };
        let motion = run(&plane, friction, State::moving([0.0; 2]), 0.002 * 599.0).unwrap();
        let State { v, x, .. } = motion.end();
        assert!(!motion.stops().is_empty() && x[0].abs() > 1e-2);
        for (i, found) in [v[0], v[1], x[0], x[1]].into_iter().enumerate() {
            let step = (coarse[i] - fine[i]).abs();
            let off = (found - fine[i]).abs();
            // What holds more lets go with a force that the steps meet one too late.
            let late = 0.002 / 80.0 * (holding - 1.96);
            assert!(
                off <= 2.0 * step + late + 1e-9,
                "{seed} {i}: {off:e} {step:e}"
            );
        }
    }
}

#[test]
fn pieces_join_and_series_in_time_obey_the_law() {
    let mut creeps = 0;
    for seed in 4..40 {
        let plane = noisy(0.0, 400, seed);
        let motion = go(&plane, 1.96, [0.0; 2], 0.002 * 399.0);
        let mut before = [0.0; 2];
        for piece in &motion.pieces {
            let [begin, end] = match piece {
                Piece::Slide(step) => [0.0, step.h].map(|s| step.state(s, 0.0).v),
                Piece::Arc(arc) => [arc.from, arc.to].map(|t| piece.at(t).unwrap().v),
                Piece::Rest { .. } => [[0.0; 2]; 2],
            };
            for i in 0..2 {
                let off = (begin[i] - before[i]).abs();
                let speed = libm::hypot(begin[0], begin[1]);
                let allowed = if speed > 0.0 { 1e-13 * speed } else { 1e-18 };
                assert!(off <= allowed, "{begin:?} {before:?}");
            }
            before = end;
            // The last arc of a slide proper is below rounding, and straight.
            let Piece::Arc(arc) = piece else { continue };
            if arc.v[0][2] == 0.0 {
                continue;
            }
            creeps += u32::from(begin != [0.0; 2]);
            for part in [0.1, 0.5, 0.9] {
                let tau = part * (arc.to - arc.from);
                let [(x, dx), (y, dy)] = arc.v.each_ref().map(|v| value_slope(v, tau));
                let speed = libm::hypot(x, y);
                let a = plane.coefficients(arc.from + tau).map(|c| c[0]);
                for off in [dx + a[0] + 1.96 * x / speed, dy + a[1] + 1.96 * y / speed] {
                    assert!(off.abs() < 1e-11, "{begin:?}: {off:e}");
                }
            }
        }
    }
    assert!(creeps > 20, "{creeps}");
}

/// A few steps a row, whatever the luck.
#[test]
fn a_long_record_is_run_through() {
    for seed in 20..23 {
        let plane = noisy(0.0, 30_000, seed);
        let motion = go(&plane, 1.96, [0.0; 2], 0.002 * 29_999.0);
        assert!(motion.stops().len() > 100);
        let steps = motion.nodes().count();
        assert!((30_000..150_000).contains(&steps), "{steps}");
    }
}

#[test]
fn a_line_is_a_line_in_any_direction() {
    let drive = |angle: f64| {
        let size = 1.757235;
        let direction = [size * libm::cos(angle), size * libm::sin(angle)];
        let signal = Signal::Sine {
            frequency: 0.985496,
            phase: 0.3,
        };
        let start = State::moving([0.0; 2]);
        run(&Plane::along(direction, signal), 1.0, start, 200.0).unwrap()
    };
    let straight = drive(0.0);
    for i in 1..20 {
        let angle = 0.3 * f64::from(i);
        let (c, s) = (libm::cos(angle), libm::sin(angle));
        let turned = drive(angle);
        for t in [40.0, 75.0, 110.0, 161.0, 200.0] {
            let (v, w) = (turned.at(t).unwrap().v, straight.at(t).unwrap().v);
            assert!((v[0] * c + v[1] * s - w[0]).abs() < 1e-12, "{angle} {t}");
            assert!((v[1] * c - v[0] * s).abs() < 1e-13, "{angle} {t}");
        }
    }
}

#[test]
fn phases_end_where_the_particle_stands_still_and_only_there() {
    let list = |motion: &Motion| -> Vec<_> {
        let phases = motion.phases().iter();
        phases.map(|p| (p.kind, p.from, p.to)).collect()
    };
    let turning = Plane::rotating(Signal::constant(2.0), 1.0, 0.0);
    let motion = go(&turning, 0.5, [0.0; 2], 40.0);
    assert_eq!(list(&motion), [(PhaseKind::Slide, 0.0, 40.0)]);
    let ramp = Plane {
        x: Signal::constant(0.0),
        y: Signal::Polynomial(vec![0.0, -0.5]),
    };
    let motion = go(&ramp, 1.0, [0.0; 2], 5.0);
    let [
        (PhaseKind::Stick, 0.0, release),
        (PhaseKind::Slide, from, 5.0),
    ] = list(&motion)[..]
    else {
        panic!("{:?}", motion.phases())
    };
    assert_eq!((release, from), (motion.starts()[0], motion.starts()[0]));
    // All the way y = (t − 2)³/12, in the first moments too.
    for t in [2.01, 2.1, 2.3, 3.0, 5.0] {
        let State { x, v, .. } = motion.at(t).unwrap();
        let way = (t - 2.0) * (t - 2.0) * (t - 2.0) / 12.0;
        assert!((x[1] - way).abs() < 1e-14 * (1.0 + way), "{t} {x:?} {way}");
        assert!((v[1] - 0.25 * (t - 2.0) * (t - 2.0)).abs() < 1e-14 * (1.0 + way));
        assert_eq!((x[0], v[0]), (0.0, 0.0));
    }
    // Against the pull and back: stopped for no time at t = 2, but stopped.
    let plane = Plane::constant([-1.0, 0.0]);
    let motion = go(&plane, 0.5, [-3.0, 0.0], 6.0);
    let stop = motion.stops()[0];
    let expected = [(PhaseKind::Slide, 0.0, stop), (PhaseKind::Slide, stop, 6.0)];
    assert_eq!(list(&motion), expected);
}

/// μg = 1 and μ_s g = 3/2. A pull t/2 lets go at 3, with a force of 1/2: v = (t² − 9)/4 − (t − 3). A pull 6/5 holds what has
/// stopped, and does not if it has to be 11/10.
#[test]
fn what_rests_is_held_by_more_than_what_slides_is_braked() {
    let friction = |holding| Friction {
        kinetic: 1.0,
        holding,
    };
    let rest = State::moving([0.0; 2]);
    for e in [[1.0, 0.0], [0.0, -1.0], [0.6, 0.8]] {
        let pull = |along| Plane::along(e.map(|c| -c), Signal::Polynomial(along));
        let ramp = run(&pull(vec![0.0, 0.5]), friction(1.5), rest, 5.0).unwrap();
        assert!((ramp.starts()[0] - 3.0).abs() < 1e-14, "{ramp:?}");
        for (t, v) in [(3.0, 0.0), (3.1, 0.0525), (5.0, 2.0)] {
            let found = ramp.at(t).unwrap().v;
            assert!((found[0] * e[0] + found[1] * e[1] - v).abs() < 1e-13, "{t}");
        }
        let way = ramp.end().x[0] * e[0] + ramp.end().x[1] * e[1];
        near(way, 98.0 / 12.0 - 4.5 - 2.0, 1e-13);
        let against = State::moving(e.map(|c| -3.0 * c));
        for (holding, v) in [(1.5, 0.0), (1.2, 0.0), (1.1, 0.2 * (5.0 - 3.0 / 2.2))] {
            let motion = run(&pull(vec![1.2]), friction(holding), against, 5.0).unwrap();
            near(motion.first_stop().unwrap(), 3.0 / 2.2, 1e-14);
            assert!((motion.end().speed() - v).abs() < 1e-13, "{holding}");
            assert_eq!(
                run_to_stop(&pull(vec![1.2]), friction(holding), against, 5.0)
                    .unwrap()
                    .stops(),
                motion.stops()
            );
        }
        let sudden = run(&pull(vec![1.6]), friction(1.5), rest, 5.0).unwrap();
        near(sudden.end().speed(), 0.6 * 5.0, 1e-13);
    }
    for holding in [0.9, f64::NAN, 1e51] {
        let refused = run(&Plane::constant([0.0; 2]), friction(holding), rest, 1.0);
        assert!(matches!(
            refused,
            Err(MotionError::Argument {
                name: "holding",
                ..
            })
        ));
    }
}

#[test]
fn a_velocity_across_that_is_next_to_nothing_is_nothing() {
    let still = Plane::constant([0.0; 2]);
    for (small, kept) in [(3e-85, true), (3e-95, false), (-3e-95, false)] {
        for i in [0, 1] {
            let mut v = [1.0; 2];
            v[i] = small;
            let motion = go(&still, 0.5, v, 1.0);
            let State { v, x, .. } = motion.end();
            assert_eq!((v[i] != 0.0, x[i] != 0.0), (kept, kept), "{v:?} {x:?}");
            near(v[1 - i], 0.5, 1e-14);
        }
    }
}

/// A pull that grows ever so slowly sets it in motion, one that falls does not.
#[test]
fn the_slowest_growth_releases() {
    for rate in [1e-9, 1e-12] {
        let pull = |rate: f64| Plane::along([-1.0, 0.0], Signal::Polynomial(vec![1.0, rate]));
        let end = go(&pull(rate), 1.0, [0.0; 2], 2.0).end();
        near(end.v[0], 2.0 * rate, 1e-3);
        let held = go(&pull(-rate), 1.0, [0.0; 2], 2.0).end();
        assert_eq!(held.v, [0.0; 2]);
    }
}

#[test]
fn the_slowest_turning_shows() {
    let across = |rate: f64| {
        let turning = |t: f64| {
            let mut a = [[0.0; TERMS]; 2];
            (a[0][0], a[0][1]) = (-1.0 - t, -1.0);
            (a[1][0], a[1][1]) = (-rate * t, -rate);
            a
        };
        let plane = Series::new(turning, [0.0, 2.0]).unwrap();
        go(&plane, 1.0, [0.0; 2], 1.0).end().v[1] / rate
    };
    let plain = across(1e-4);
    assert!(plain > 0.0);
    for rate in [1e-8, 1e-11] {
        near(across(rate), plain, 1e-6);
    }
}
