//! Motions on the plane, of the sphere and on the turntable: near their stops, along their directions, and where they
//! leave the numbers.

use slipbook::motion::{
    MotionError, Plane, Signal, State, run, sphere, turntable,
    turntable::{Path, Table, inertial, rotating},
};
use slipbook::numerics::NumericsError;

fn table() -> Table {
    Table {
        omega: 1.3,
        mu: 0.5,
        g: 10.0,
        mass: 2.0,
    }
}

fn both(start: &turntable::State, until: f64) -> [Path; 2] {
    let table = table();
    let outside = table.to_laboratory(start);
    [
        rotating::run(&table, start, until).unwrap(),
        inertial::run(&table, &outside, until).unwrap(),
    ]
}

#[test]
fn the_last_way_to_a_stop_is_that_of_a_constant_force() {
    for (x, v) in [
        ([0.3, 0.1], [0.8, -0.4]),
        ([-0.5, 0.2], [-0.3, 0.9]),
        ([0.0, 0.0], [1.0, 0.0]),
    ] {
        let start = turntable::State { t: 0.5, x, v };
        for path in both(&start, 20.0) {
            let stop = *path.stops().last().unwrap();
            let place = path.resting_place().unwrap();
            let at = |before: f64| path.on_table(stop - before).unwrap();
            let slowing = |s: &turntable::State| {
                let along = (s.x[0] * s.v[0] + s.x[1] * s.v[1]) / s.speed();
                table().friction() - table().omega * table().omega * along
            };
            let times: Vec<_> = (16..96)
                .map(|k| libm::pow(10.0, -0.125 * f64::from(k)))
                .collect();
            for pair in times.windows(2) {
                let (early, late) = (at(pair[0]), at(pair[1]));
                let time = late.t - early.t;
                let lost = early.speed() - late.speed();
                let expected = 0.5 * (slowing(&early) + slowing(&late)) * time;
                // It turns a little, and times are rounded.
                let close = |a: f64, b: f64| (a - b).abs() < 3e-3 * b.abs() + 1e-14;
                assert!(
                    close(lost, expected),
                    "{:e}: {lost:e} {expected:e}",
                    pair[0]
                );
                for i in 0..2 {
                    let way = late.x[i] - early.x[i];
                    let expected = 0.5 * (early.v[i] + late.v[i]) * time;
                    assert!(
                        (way - expected).abs() < 2e-2 * lost * time + 1e-15,
                        "{:e}: {way:e} {expected:e}",
                        pair[0]
                    );
                }
                let left = libm::hypot(late.x[0] - place[0], late.x[1] - place[1]);
                assert!(
                    left <= late.speed() * pair[1] + 1e-15,
                    "{:e}: {left:e}",
                    pair[1]
                );
            }
            for after in [0.0, 1e-9, 1.0] {
                let resting = path.on_table(stop + after).unwrap();
                let off = libm::hypot(resting.x[0] - place[0], resting.x[1] - place[1]);
                assert!(
                    resting.speed() < 1e-13 && off < 1e-13,
                    "{after}: {resting:?}"
                );
            }
            assert_eq!(path.end(), 20.0);
        }
        let [a, b] = both(&start, 20.0);
        let (a, b) = (a.stops().last().unwrap(), b.stops().last().unwrap());
        assert!((a - b).abs() < 1e-12, "{a} {b}");
    }
}

#[test]
fn a_table_beyond_its_range_is_refused_by_name() {
    let good = table();
    assert!(good.check().is_ok());
    let refused = [
        (
            "omega",
            Table {
                omega: f64::INFINITY,
                ..good
            },
        ),
        (
            "omega",
            Table {
                omega: -2e50,
                ..good
            },
        ),
        ("mu", Table { mu: -0.1, ..good }),
        (
            "mu",
            Table {
                mu: f64::NAN,
                ..good
            },
        ),
        ("g", Table { g: 0.0, ..good }),
        ("g", Table { g: -9.8, ..good }),
        ("g", Table { g: 2e50, ..good }),
        ("mass", Table { mass: 0.0, ..good }),
        (
            "mass",
            Table {
                mass: f64::INFINITY,
                ..good
            },
        ),
    ];
    for (expected, table) in refused {
        let told = table.check();
        assert!(
            matches!(told, Err(MotionError::Argument { name, .. }) if name == expected),
            "{table:?}: {told:?}"
        );
    }
    let still = Table {
        omega: 0.0,
        mu: 0.0,
        ..good
    };
    assert!(still.check().is_ok());
}

/// Without friction the velocity is known at every time.
#[test]
fn a_velocity_has_a_direction_when_it_first_points_there() {
    let start = State {
        t: 2.0,
        v: [-1.0, 0.5],
        x: [0.0; 2],
    };
    let free = run(&Plane::constant([-1.0, 0.0]), 0.0, start, 8.0).unwrap();
    for angle in [2.5_f64, 2.0, 1.5, 1.0, 0.3, 0.1] {
        let n = [3.0 * libm::cos(angle), 3.0 * libm::sin(angle)];
        let expected = 2.0 + 1.0 + 0.5 * n[0] / n[1];
        let found = free.first_along(n).unwrap();
        if (2.0..=8.0).contains(&expected) {
            let found = found.unwrap();
            assert!(
                (found.t - expected).abs() < 1e-13,
                "{angle}: {found:?}, {expected}"
            );
            assert!(
                (found.v[0] - (found.t - 3.0)).abs() < 1e-13 && (found.v[1] - 0.5).abs() < 1e-14
            );
        } else {
            assert_eq!(found, None, "{angle}");
        }
        assert_eq!(free.first_along([-n[0], -n[1]]).unwrap(), None);
    }
    assert_eq!(free.first_along([-2.0, 1.0]).unwrap().unwrap().t, 2.0);
    let start = State {
        t: 0.0,
        v: [0.0; 2],
        x: [0.0; 2],
    };
    let swing = Plane::along(
        [1.0, 0.0],
        Signal::Sine {
            frequency: 1.0,
            phase: 0.0,
        },
    );
    let motion = run(&swing, 0.1, start, 20.0).unwrap();
    let to = |x: f64| motion.first_along([x, 0.0]).unwrap().unwrap();
    let sets_out = libm::asin(0.1);
    assert!((to(-1.0).t - sets_out).abs() < 1e-13, "{:?}", to(-1.0));
    assert_eq!(to(-1.0).v, [0.0; 2]);
    let back = to(1.0).t;
    assert!(
        back > 3.0
            && motion.at(back + 1e-6).unwrap().v[0] > 0.0
            && motion.at(back - 1e-6).unwrap().v[0] < 0.0
    );
}

/// The place or the velocity is a number for some of the time only.
#[test]
fn a_motion_that_leaves_the_numbers_is_an_error() {
    let beyond = |error| {
        matches!(
            error,
            MotionError::Numerics(NumericsError::NotFinite { .. })
        )
    };
    // At 10¹⁰ v = −10²⁵⁰ t⁴/4 is −10²⁹⁰/4; at 10¹⁴ it is a number still, but x = v t/5 is none.
    let growing = Plane::along([1.0, 0.0], Signal::Polynomial(vec![2.0, 0.0, 0.0, 1e250]));
    let start = State {
        t: 0.0,
        v: [0.0; 2],
        x: [0.0; 2],
    };
    let motion = run(&growing, 1.0, start, 1e10).unwrap();
    assert!((motion.end().v[0] / -2.5e289 - 1.0).abs() < 1e-14);
    assert!(beyond(run(&growing, 1.0, start, 1e14).unwrap_err()));

    // The ball slides, and v is −10³⁰⁰ t but for a friction of 1.
    let strong = Plane::constant([0.0, 1e300]);
    let still = sphere::Ball {
        t: 0.0,
        x: [0.0; 2],
        v: [0.0; 2],
        omega: [0.0; 3],
    };
    let ball = sphere::Sphere::with_kappa(0.4);
    let motion = ball.run(&strong, &still, 100.0).unwrap();
    assert!((motion.end().v[1] / -1e302 - 1.0).abs() < 1e-14);
    assert!(beyond(ball.run(&strong, &still, 1e9).unwrap_err()));
}
