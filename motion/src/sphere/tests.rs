//! The sphere by hand, and in what it conserves.

use super::*;
use crate::fitted::tests::noisy;
use crate::{Friction, Plane, Signal, State, run};
use proptest::prelude::*;

fn ball(v: [f64; 2], omega: [f64; 3]) -> Ball {
    Ball {
        t: 0.0,
        x: [0.0; 2],
        v,
        omega,
    }
}

fn odd() -> Sphere {
    Sphere {
        mass: 2.3,
        radius: 0.7,
        inertia: 0.4 * 2.3 * 0.49,
        mu: 0.35,
        g: 9.81,
    }
}

fn still() -> Plane {
    Plane::constant([0.0; 2])
}

/// As one that friction holds with what it has on that point; late in a record too, where times are rounded by more than forces.
#[test]
fn the_lowest_point_moves_as_a_block() {
    let sphere = Sphere {
        mu: 0.56,
        ..Sphere::with_kappa(0.4)
    };
    for (seed, from) in [(1, 0.0), (2, 600.0), (3, 6e3), (4, 6e4)] {
        let plane = noisy(from, 1000, seed);
        let until = plane.times()[1];
        let start = Ball {
            t: from,
            ..ball([0.0; 2], [0.0; 3])
        };
        let holding = 0.56 + 0.04 * f64::from(seed as u32 - 1);
        let rolled = sphere.run_held(holding, &plane, &start, until).unwrap();
        let rest = State {
            t: from,
            ..State::moving([0.0; 2])
        };
        let friction = Friction {
            kinetic: 1.96,
            holding: 3.5 * holding,
        };
        let moved = run(&plane, friction, rest, until).unwrap();
        assert!(!moved.stops().is_empty(), "{seed}");
        for k in 0..1998 {
            let t = from + 0.001 * f64::from(k);
            let (slip, v) = (rolled.slip(t).unwrap(), moved.at(t).unwrap().v);
            let off = libm::hypot(slip[0] - v[0], slip[1] - v[1]);
            assert!(off < 1e-12 * (1.0 + from), "{seed} {t}: {off:e}");
        }
    }
}

#[test]
fn a_ball_set_down_sliding_ends_rolling() {
    // Angular momentum about the line of contact stays. v₀ − v_end = μg t.
    for (kappa, part) in [
        (0.4, 5.0 / 7.0),
        (2.0 / 3.0, 0.6),
        (1.0, 0.5),
        (1e-3, 1000.0 / 1001.0),
    ] {
        let sphere = Sphere {
            inertia: kappa * 2.3 * 0.49,
            ..odd()
        };
        let motion = sphere
            .run(&still(), &ball([3.0, -4.0], [0.0, 0.0, 2.0]), 5.0)
            .unwrap();
        let end = motion.end();
        assert!((end.v[0] - 3.0 * part).abs() < 1e-13 && (end.v[1] + 4.0 * part).abs() < 1e-13);
        let time = 5.0 * (1.0 - part) / (0.35 * 9.81);
        let [first] = motion.transitions() else {
            unreachable!("{:?}", motion.transitions())
        };
        assert!(
            (first.t - time).abs() < 1e-13 && first.to == Contact::Rolling,
            "{first:?}"
        );
        let way = 5.0 * time - 0.5 * 0.35 * 9.81 * time * time + 5.0 * part * (5.0 - time);
        assert!((libm::hypot(end.x[0], end.x[1]) - way).abs() < 1e-12);
        let expected = sphere.rolling(end.v, 2.0);
        assert!(
            (0..3).all(|i| (end.omega[i] - expected[i]).abs() < 1e-12),
            "{end:?}"
        );
        assert_eq!(motion.contact(0.5 * time).unwrap(), Contact::Sliding);
        assert_eq!(motion.contact(1.01 * time).unwrap(), Contact::Rolling);
    }
}

#[test]
fn rolling_needs_the_plane_to_be_gentle() {
    // Rolling takes F = mA/(1 + 1/κ): for κ = 0.4 the limit |A| = 3.5 μg. Then v = −A t (1 − 1/3.5).
    let sphere = Sphere::with_kappa(0.4);
    let gentle = sphere
        .run(&Plane::constant([3.4, 0.0]), &ball([0.0; 2], [0.0; 3]), 2.0)
        .unwrap();
    assert!(gentle.transitions().is_empty());
    assert_eq!(gentle.contact(1.0).unwrap(), Contact::Rolling);
    assert!((gentle.end().v[0] + 2.0 * 3.4 * 2.5 / 3.5).abs() < 1e-14);
    // Above, friction is μmg whatever A: v = −(A − μg) t, ω_y = −(5/2)(…)t by its torque.
    let rough = sphere
        .run(&Plane::constant([3.6, 0.0]), &ball([0.0; 2], [0.0; 3]), 2.0)
        .unwrap();
    assert_eq!(rough.contact(1.0).unwrap(), Contact::Sliding);
    assert!(
        (rough.end().v[0] + 2.0 * 2.6).abs() < 1e-13,
        "{:?}",
        rough.end()
    );
    assert!(
        (rough.end().omega[1] + 2.0 * 2.5).abs() < 1e-13,
        "{:?}",
        rough.end()
    );
    // A growing as t: released at A = 3.5.
    let ramp = Plane {
        x: Signal::Polynomial(vec![0.0, 1.0]),
        y: Signal::constant(0.0),
    };
    let motion = sphere.run(&ramp, &ball([0.0; 2], [0.0; 3]), 6.0).unwrap();
    let [release] = motion.transitions() else {
        unreachable!("{:?}", motion.transitions())
    };
    assert!((release.t - 3.5).abs() < 1e-13 && release.to == Contact::Sliding);
    let before = -0.5 * 3.5 * 3.5 * 2.5 / 3.5;
    let after = -(0.5 * (36.0 - 3.5 * 3.5) - 2.5);
    assert!(
        (motion.end().v[0] - before - after).abs() < 1e-12,
        "{:?}",
        motion.end()
    );
}

#[test]
fn bad_input_is_named() {
    let name = |sphere: Sphere, start: Ball, until: f64| match sphere.run(&still(), &start, until) {
        Err(MotionError::Argument { name, .. }) => name,
        other => unreachable!("{other:?}"),
    };
    let rest = ball([0.0; 2], [0.0; 3]);
    assert_eq!(
        name(
            Sphere {
                mass: -1.0,
                ..odd()
            },
            rest,
            1.0
        ),
        "mass"
    );
    assert_eq!(
        name(
            Sphere {
                mu: f64::NAN,
                ..odd()
            },
            rest,
            1.0
        ),
        "mu"
    );
    let loose = odd().run_held(0.34, &still(), &rest, 1.0);
    assert!(matches!(
        loose,
        Err(MotionError::Argument {
            name: "holding",
            ..
        })
    ));
    assert_eq!(name(Sphere::with_kappa(0.0), rest, 1.0), "inertia");
    assert_eq!(name(Sphere::with_kappa(1.1), rest, 1.0), "kappa");
    assert_eq!(name(odd(), rest, -1.0), "until");
    assert_eq!(name(odd(), ball([f64::NAN, 0.0], [0.0; 3]), 1.0), "v_x");
    assert_eq!(
        name(odd(), ball([0.0; 2], [0.0, 0.0, f64::INFINITY]), 1.0),
        "omega_z"
    );
    assert!(odd().run(&still(), &rest, 1.0).unwrap().at(2.0).is_err());
    let motion = odd().run(&still(), &rest, 0.0).unwrap();
    assert_eq!(motion.at(0.0).unwrap(), rest);
}

proptest! {
    #[test]
    fn what_friction_cannot_change_stays(
        kappa in 0.05..1.0f64, v in prop::array::uniform2(-3.0..3.0f64),
        omega in prop::array::uniform3(-3.0..3.0f64), a in 0.0..6.0f64, frequency in 0.1..3.0f64,
    ) {
        let sphere = Sphere::with_kappa(kappa);
        let plane = Plane::rotating(Signal::constant(a), frequency, 0.0);
        let motion = sphere.run(&plane, &ball(v, omega), 8.0).unwrap();
        let end = motion.end();
        prop_assert_eq!(end.omega[2], omega[2]);
        // About the contact friction has no torque: m R×v − Iω changes by −A alone, here by an integral known.
        let (s, c) = libm::sincos(8.0 * frequency);
        let gained = [-a * s / frequency, -a * (1.0 - c) / frequency];
        for i in 0..2 {
            let along = |v: [f64; 2], o: [f64; 3]| v[i] + kappa * [o[1], -o[0]][i];
            let difference = along(end.v, end.omega) - along(v, omega) - gained[i];
            prop_assert!(difference.abs() < 1e-11, "{}", difference);
        }
        let (slip, contact) = (motion.slip(8.0).unwrap(), sphere.contact(&end));
        for i in 0..2 {
            prop_assert!((slip[i] - contact[i]).abs() < 1e-11, "{:?} {:?}", slip, contact);
        }
    }
}

#[test]
fn a_release_along_a_slanting_line_is_one_along_x() {
    let sphere = Sphere::with_kappa(0.88);
    let swing = |direction: [f64; 2]| {
        let (frequency, phase) = (1.3, 0.0);
        Plane::along(direction, Signal::Sine { frequency, phase }.times(4.0))
    };
    let start = ball([0.0; 2], [0.0; 3]);
    let straight = sphere.run(&swing([1.0, 0.0]), &start, 9.0).unwrap();
    for k in 1..40 {
        let angle = 0.157 * f64::from(k);
        let [c, s] = [libm::cos(angle), libm::sin(angle)];
        let slanting = sphere.run(&swing([c, s]), &start, 9.0).unwrap();
        for t in [1.0, 2.0, 4.0, 6.0, 9.0] {
            let (own, other) = (straight.at(t).unwrap(), slanting.at(t).unwrap());
            for (along, turned) in [(own.x[0], other.x), (own.v[0], other.v)] {
                let apart = libm::hypot(turned[0] - c * along, turned[1] - s * along);
                assert!(apart < 1e-11, "angle {angle}, t = {t}: {apart:e}");
            }
        }
    }
}

#[test]
fn what_a_start_is_counts_from_the_start() {
    let sphere = Sphere::with_kappa(0.4);
    for (v, contact) in [([1.0, 0.0], Contact::Sliding), ([0.0; 2], Contact::Rolling)] {
        let motion = sphere.run(&still(), &ball(v, [0.0; 3]), 0.0).unwrap();
        assert_eq!(motion.contact(0.0).unwrap(), contact);
    }
    // Nothing changes where it slides from the start.
    for plane in [
        Plane::constant([3.6, 0.0]),
        Plane::rotating(Signal::constant(4.0), 1.0, 0.3),
    ] {
        let motion = sphere.run(&plane, &ball([0.0; 2], [0.0; 3]), 2.0).unwrap();
        assert_eq!(motion.contact(0.0).unwrap(), Contact::Sliding);
        assert!(motion.transitions().is_empty(), "{motion:?}");
    }
}

#[test]
fn a_contact_velocity_counts_beside_the_velocities_of_which_it_is_the_sum() {
    // v = 10⁶ and ωR = 10³·10³: below 10⁻¹⁴·2·10⁶ their difference is rounding.
    let sphere = Sphere {
        radius: 1e3,
        inertia: 0.4e6,
        ..Sphere::with_kappa(0.4)
    };
    for (c, contact) in [(1.5e-8, Contact::Rolling), (2.5e-8, Contact::Sliding)] {
        let start = ball([1e6 + c, 0.0], [0.0, 1e3, 0.0]);
        let motion = sphere.run(&still(), &start, 1.0).unwrap();
        assert_eq!(motion.contact(0.0).unwrap(), contact, "{c}");
    }
}

#[test]
fn a_pull_at_the_limit_that_hardly_grows_is_rolled_on() {
    // Within 10⁻⁸ A grows by 10⁻¹⁴, which is below rounding; within 1 it is not.
    let sphere = Sphere::with_kappa(0.4);
    let plane = Plane::along([1.0, 0.0], Signal::Polynomial(vec![3.5, 1e-6]));
    for (until, contact) in [(1e-8, Contact::Rolling), (1.0, Contact::Sliding)] {
        let motion = sphere
            .run(&plane, &ball([0.0; 2], [0.0; 3]), until)
            .unwrap();
        assert_eq!(motion.contact(0.0).unwrap(), contact);
    }
}

#[test]
fn a_slip_across_that_is_next_to_nothing_is_nothing() {
    let sphere = Sphere::with_kappa(0.4);
    for (small, kept) in [(1.234e-85, true), (1.234e-95, false)] {
        for i in [0, 1] {
            let mut v = [1.0; 2];
            v[i] = small;
            let motion = sphere.run(&still(), &ball(v, [0.0; 3]), 1.0).unwrap();
            let slip = motion.slip(0.28).unwrap();
            assert!((slip[1 - i] - 0.02).abs() < 1e-14, "{slip:?}");
            assert_eq!(slip[i] != 0.0, kept, "{slip:?}");
        }
    }
}

#[test]
fn a_direction_that_begins_to_turn_late_turns_by_the_law() {
    // From rest under A = (4, 5 t⁷): the angle of the slip is a series in t⁷, of which many terms are zero.
    let plane = Plane {
        x: Signal::constant(4.0),
        y: Signal::Polynomial(vec![0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 5.0]),
    };
    let start = Ball {
        t: 0.0,
        x: [0.0; 2],
        v: [0.0; 2],
        omega: [0.0; 3],
    };
    let motion = Sphere::with_kappa(0.4).run(&plane, &start, 2.0).unwrap();
    for t in [0.2, 0.5, 0.8, 1.0, 1.3, 1.6, 1.9] {
        let [before, after] = [t - 1e-4, t + 1e-4].map(|t| motion.at(t).unwrap().v);
        let [x, y] = motion.slip(t).unwrap();
        let slip = libm::hypot(x, y);
        let a = [4.0, 5.0 * libm::pow(t, 7.0)];
        for (i, c) in [x, y].into_iter().enumerate() {
            let rate = (after[i] - before[i]) / 2e-4;
            let law = -a[i] - c / slip;
            assert!(
                (rate - law).abs() < 1e-5 * (1.0 + law.abs()),
                "{t}: {rate} {law}"
            );
        }
    }
}

/// At the time T under A = sin(t − T + asin 0.999) with the limit 0.999: also where a step of the square is over sooner.
#[test]
fn it_is_let_go_however_long_it_has_rolled() {
    let level = 0.999;
    let sphere = Sphere {
        mu: level / 3.5,
        ..Sphere::with_kappa(0.4)
    };
    for k in 1..=30 {
        let time = 0.1 * f64::from(k);
        let sine = Signal::Sine {
            frequency: 1.0,
            phase: libm::asin(level) - time,
        };
        let plane = Plane::along([0.6, -0.8], sine);
        let motion = sphere
            .run(&plane, &ball([0.0; 2], [0.0; 3]), time + 0.01)
            .unwrap();
        let [release] = motion.transitions() else {
            unreachable!("{time} {:?}", motion.transitions())
        };
        assert!((release.t - time).abs() < 1e-12, "{time} {release:?}");
    }
}

/// Thrown against a pull that needs 6/5 for rolling, it stops to slide after |c|/(bμg + A), b = 7/2; then it rolls if static
/// friction is 5/4, and slips back if it is 11/10.
#[test]
fn what_has_stopped_to_slide_rolls_as_long_as_static_friction_holds() {
    let sphere = Sphere {
        mu: 0.02,
        ..Sphere::with_kappa(0.4)
    };
    for k in 0..12 {
        let (s, c) = libm::sincos(0.5 * f64::from(k));
        let plane = Plane::constant([-4.2 * c, -4.2 * s]);
        let start = ball([-c, -s], [0.0; 3]);
        for (holding, to) in [(1.25, Contact::Rolling), (1.1, Contact::Sliding)] {
            let motion = sphere.run_held(holding, &plane, &start, 2.0).unwrap();
            assert_eq!(motion.contact(1.0).unwrap(), to, "{k}");
            if to == Contact::Rolling {
                let [stop] = motion.transitions() else {
                    unreachable!("{motion:?}")
                };
                assert!((stop.t - 1.0 / 4.27).abs() < 1e-12, "{stop:?}");
            }
        }
    }
}
