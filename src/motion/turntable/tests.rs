//! The three ways to the motion against each other, against a foreign integrator, and where the end is known.

use super::fate::{Escaping, Fate, fate};
use super::intrinsic::{Run, Start};
use super::*;
use crate::numerics::taylor::{System, TERMS};
use crate::numerics::{dop853, quadrature};
use std::f64::consts::{FRAC_PI_2, PI};

/// A start relative to the table: components uniform in [−size, size].
fn random(random: &mut fastrand::Rng, size: f64) -> State {
    let mut any = || size * (2.0 * random.f64() - 1.0);
    State {
        t: 0.0,
        x: [any(), any()],
        v: [any(), any()],
    }
}

/// Largest difference of two states, relative to their size where that is above 1.
fn apart(a: &State, b: &State) -> f64 {
    let size = 1f64.max(a.radius()).max(a.speed());
    let differences = [0, 1].map(|i| (a.x[i] - b.x[i]).abs().max((a.v[i] - b.v[i]).abs()));
    differences[0].max(differences[1]) / size
}

fn slow() -> Table {
    Table {
        omega: 0.7,
        mu: 0.3,
        g: 9.81,
        mass: 2.5,
    }
}

#[test]
fn both_frames_agree_through_many_turns() {
    let mut rng = fastrand::Rng::with_seed(41);
    let (mut rests, mut worst) = (0, 0f64);
    for table in [Table::default(), slow()] {
        let end = 12.0 * 2.0 * PI / table.omega;
        for _ in 0..60 {
            let start = random(&mut rng, 1.2 * table.length());
            let turning = rotating::run(&table, &start, end).unwrap();
            let still = inertial::run(&table, &table.to_laboratory(&start), end).unwrap();
            rests += usize::from(turning.resting_place().is_some());
            for i in 0..=100 {
                let t = end * f64::from(i) / 100.0;
                let here = turning.at(t).unwrap();
                let there = still.on_table(t).unwrap();
                worst = worst.max(apart(&here, &there));
            }
            assert!(worst < 1e-11, "{worst:e} {table:?} {start:?}");
            assert_eq!(turning.stops().len(), still.stops().len());
            for (a, b) in turning.stops().iter().zip(still.stops()) {
                assert!((a - b).abs() < 1e-11 * end, "{a} {b}");
            }
        }
    }
    assert!((20..100).contains(&rests), "{rests}");
}

#[test]
fn a_foreign_integrator_agrees() {
    let table = slow();
    let (omega, friction) = (table.omega, table.mu * table.g);
    let pull = |_: f64, s: &[f64; 4]| {
        let p = libm::hypot(s[2], s[3]);
        [
            s[2],
            s[3],
            omega * omega * s[0] + 2.0 * omega * s[3] - friction * s[2] / p,
            omega * omega * s[1] - 2.0 * omega * s[2] - friction * s[3] / p,
        ]
    };
    let start = State {
        t: 0.0,
        x: [7.0, -2.0],
        v: [1.0, 4.0],
    };
    let [x, y, u, v] = dop853::end(pull, 0.0, [7.0, -2.0, 1.0, 4.0], 9.0, 1e-14, 1e-14).unwrap();
    let foreign = State {
        t: 9.0,
        x: [x, y],
        v: [u, v],
    };
    let own = rotating::run(&table, &start, 9.0).unwrap().at(9.0).unwrap();
    assert!(apart(&own, &foreign) < 1e-11, "{own:?} {foreign:?}");
}

#[test]
fn without_friction_the_line_is_straight() {
    let table = Table { mu: 0.0, ..slow() };
    let start = State {
        t: 0.0,
        x: [1.0, 2.0],
        v: [-0.3, 0.4],
    };
    let begin = table.to_laboratory(&start);
    let paths = [
        rotating::run(&table, &start, 50.0).unwrap(),
        inertial::run(&table, &begin, 50.0).unwrap(),
    ];
    for path in paths {
        for t in [0.0, 0.1, 7.0, 49.9, 50.0] {
            let seen = table.to_laboratory(&path.on_table(t).unwrap());
            let line = [0, 1].map(|i| begin.x[i] + t * begin.v[i]);
            let straight = State {
                t,
                x: line,
                v: begin.v,
            };
            assert!(apart(&seen, &straight) < 1e-12, "{seen:?} {straight:?}");
        }
    }
}

#[test]
fn friction_takes_what_the_energy_loses() {
    let table = slow();
    let start = State {
        t: 0.0,
        x: [3.0, 1.0],
        v: [-1.0, -4.0],
    };
    let path = rotating::run(&table, &start, 12.0).unwrap();
    let [begin, end] = [0.0, 12.0].map(|t| table.energy(&path.at(t).unwrap()));
    let speed = |t: f64| path.at(t).map_or(f64::NAN, |s| s.speed());
    let way = quadrature::integral(speed, 0.0, path.stops().first().map_or(12.0, |t| *t)).unwrap();
    let loss = table.mass * table.mu * table.g * way.value;
    assert!(
        (begin - end - loss).abs() < 1e-10 * loss,
        "{begin} {end} {loss}"
    );
}

#[test]
fn the_mirror_image_turns_the_other_way() {
    let table = slow();
    let image = Table {
        omega: -table.omega,
        ..table
    };
    let start = State {
        t: 0.0,
        x: [3.0, 1.0],
        v: [-1.0, -4.0],
    };
    let mirrored = |s: State| State {
        x: [s.x[0], -s.x[1]],
        v: [s.v[0], -s.v[1]],
        ..s
    };
    let path = rotating::run(&table, &start, 20.0).unwrap();
    let other = inertial::run(&image, &image.to_laboratory(&mirrored(start)), 20.0).unwrap();
    for t in [1.0, 3.0, 20.0] {
        let expected = mirrored(path.at(t).unwrap());
        assert!(apart(&other.on_table(t).unwrap(), &expected) < 1e-11);
    }
}

#[test]
fn from_rest_it_stays_or_goes_outwards() {
    let table = Table::default();
    let at = |r: f64| State {
        t: 0.0,
        x: [0.6 * r, 0.8 * r],
        v: [0.0; 2],
    };
    for r in [0.0, 0.5, 1.0] {
        let path = rotating::run(&table, &at(r), 5.0).unwrap();
        assert_eq!(path.at(5.0).unwrap().x, at(r).x);
    }
    for r in [1.001, 1.2, 4.0] {
        let turning = rotating::run(&table, &at(r), 8.0).unwrap();
        let still = inertial::run(&table, &table.to_laboratory(&at(r)), 8.0).unwrap();
        for t in [1e-3, 0.1, 1.0, 8.0] {
            let (a, b) = (turning.at(t).unwrap(), still.on_table(t).unwrap());
            assert!(apart(&a, &b) < 1e-11, "{r} {t} {a:?} {b:?}");
        }
        // Straight outwards at first, by the unbalanced part of the pull.
        let early = turning.at(1e-3).unwrap();
        assert!(
            (early.speed() / ((r - 1.0) * 1e-3) - 1.0).abs() < 1e-5,
            "{early:?}"
        );
        let escapes = fate(&Start::cartesian(at(r).x, [0.0; 2]).unwrap()).unwrap();
        assert!(matches!(
            escapes,
            Fate::Escape {
                because: Escaping::Energy,
                ..
            }
        ));
    }
}

#[test]
fn fate_finds_the_resting_place_of_the_full_motion() {
    let table = Table::default();
    let mut rng = fastrand::Rng::with_seed(5);
    let mut rests = 0;
    for _ in 0..200 {
        let start = random(&mut rng, 1.0);
        let path = rotating::run(&table, &start, 60.0).unwrap();
        match fate(&Start::cartesian(start.x, start.v).unwrap()).unwrap() {
            Fate::Rest {
                sigma,
                tau,
                error,
                tau_error,
            } => {
                rests += 1;
                let [x, y] = path.resting_place().unwrap();
                let stop = path.stops()[0];
                assert!(
                    (libm::hypot(x, y) - sigma).abs() < error + 1e-12,
                    "{start:?} {sigma}"
                );
                assert!((stop - tau).abs() < tau_error + 1e-10, "{stop} {tau}");
            }
            Fate::Escape { .. } => {
                assert!(path.resting_place().is_none(), "{start:?}");
                assert!(path.at(60.0).unwrap().radius() > 10.0, "{start:?}");
            }
            Fate::Undecided { .. } => unreachable!("{start:?}"),
        }
    }
    assert!((50..180).contains(&rests), "{rests}");
}

#[test]
fn components_along_the_velocity_are_those_of_the_full_motion() {
    let start = State {
        t: 0.0,
        x: [0.4, -0.9],
        v: [1.1, 0.3],
    };
    let path = rotating::run(&Table::default(), &start, 40.0).unwrap();
    let run = Run::new(&Start::cartesian(start.x, start.v).unwrap(), 40.0).unwrap();
    for t in [0.3, 2.0, 11.0, 40.0] {
        let (state, parts) = (path.at(t).unwrap(), run.at(t).unwrap());
        let [x, y] = state.x;
        let [u, v] = state.v;
        let angle = libm::atan2(u * y - v * x, u * x + v * y);
        let turned = libm::atan2(v, u) - libm::atan2(0.3, 1.1) - parts.turned;
        assert!((parts.p() / state.speed() - 1.0).abs() < 1e-12);
        assert!((parts.rho() / state.radius() - 1.0).abs() < 1e-12);
        assert!(
            (parts.psi() - angle).abs() < 1e-11,
            "{} {angle}",
            parts.psi()
        );
        assert!((parts.lag() + parts.psi() - FRAC_PI_2).abs() < 1e-15);
        assert!(
            (turned - 2.0 * PI * libm::round(turned / (2.0 * PI))).abs() < 1e-10,
            "{turned}"
        );
    }
}

#[test]
fn a_long_escape_keeps_its_work_and_energy() {
    let start = Start::put_down(2.0).unwrap();
    let run = Run::new(&start, 1e6).unwrap();
    for state in run.nodes() {
        let gained = state.parts.energy() - start.energy();
        assert!(
            (gained - 2.0 * state.s).abs() <= 1e-12 * (1.0 + 2.0 * state.s),
            "{state:?}"
        );
    }
    let end = run.end();
    assert!((end.tau - 1e6).abs() < 1e-9 && end.a().unwrap() > 1e8 && end.alpha().unwrap() > 6.0);
}

#[test]
fn the_boundary_parts_rest_from_escape() {
    for (alpha, psi) in [(0.3, 0.4), (0.3, -2.0), (0.05, FRAC_PI_2), (0.003, 1.0)] {
        let a = boundary(alpha, psi).unwrap();
        let near = |a: f64| fate(&Start::hyperbolic(a, alpha, psi).unwrap()).unwrap();
        for i in 0..200 {
            // Ever closer from both sides.
            let away = 0.2 * libm::pow(0.9, f64::from(i)) + 2e-12;
            assert!(matches!(near(a - away), Fate::Rest { .. }), "{a} {away}");
            assert!(matches!(near(a + away), Fate::Escape { .. }), "{a} {away}");
        }
    }
    // By the inertial frame: the particle put down in the laboratory and the one launched from the axis.
    let table = Table::default();
    let rests = |state: State| {
        inertial::run(&table, &state, 200.0)
            .unwrap()
            .resting_place()
            .is_some()
    };
    let (r, u) = (critical_radius().unwrap(), critical_speed().unwrap());
    for (factor, expected) in [(1.0 - 1e-5, true), (1.0 + 1e-5, false)] {
        assert_eq!(
            rests(State {
                t: 0.0,
                x: [r * factor, 0.0],
                v: [0.0; 2]
            }),
            expected
        );
        assert_eq!(
            rests(State {
                t: 0.0,
                x: [0.0; 2],
                v: [u * factor, 0.0]
            }),
            expected
        );
    }
}

#[test]
fn defined_at_every_edge() {
    let fate_of = |rho, p, psi| fate(&Start::polar(rho, p, psi).unwrap()).unwrap();
    assert_eq!(
        fate_of(0.0, 0.0, 0.0),
        Fate::Rest {
            sigma: 0.0,
            tau: 0.0,
            error: 0.0,
            tau_error: 0.0
        }
    );
    assert_eq!(
        fate_of(1.0, 0.0, 2.0),
        Fate::Rest {
            sigma: 1.0,
            tau: 0.0,
            error: 0.0,
            tau_error: 0.0
        }
    );
    assert!(matches!(fate_of(1.5, 0.0, 0.0), Fate::Escape { .. }));
    // p = ρ, p > ρ, the axis, straight inwards.
    assert!(matches!(fate_of(0.3, 0.3, 1.0), Fate::Rest { .. }));
    assert!(matches!(fate_of(3.0, 3.0, 1.0), Fate::Escape { .. }));
    assert!(matches!(fate_of(0.1, 2.0, 1.0), Fate::Escape { .. }));
    assert!(matches!(fate_of(0.0, 0.5, 0.0), Fate::Rest { .. }));
    assert!(
        matches!(fate_of(0.9, 1e-9, PI), Fate::Rest { sigma, .. } if (sigma - 0.9).abs() < 1e-12)
    );
    assert!(matches!(fate_of(1.2, 1e-9, PI), Fate::Escape { .. }));
}

#[test]
fn bad_input_is_named() {
    use crate::motion::MotionError::Argument;
    assert!(matches!(
        Start::polar(-1.0, 1.0, 0.0),
        Err(Argument { name: "rho", .. })
    ));
    assert!(matches!(
        Start::polar(1.0, f64::NAN, 0.0),
        Err(Argument { name: "p", .. })
    ));
    assert!(matches!(
        Start::polar(1.0, 1.0, f64::INFINITY),
        Err(Argument { name: "psi", .. })
    ));
    assert!(matches!(
        Start::hyperbolic(-1.0, 1.0, 0.0),
        Err(Argument { name: "A", .. })
    ));
    assert!(matches!(
        boundary(0.0, 0.0),
        Err(Argument { name: "alpha", .. })
    ));
    let start = State {
        t: 0.0,
        x: [1.0, 0.0],
        v: [0.0; 2],
    };
    let bad = Table {
        mu: -1.0,
        ..Table::default()
    };
    assert!(matches!(
        rotating::run(&bad, &start, 1.0),
        Err(Argument { name: "mu", .. })
    ));
    let late = inertial::run(&Table::default(), &start, -1.0);
    assert!(matches!(late, Err(Argument { name: "until", .. })));
    let by_hand = Start {
        p: 1.0,
        xi: f64::NAN,
        zeta: 0.0,
    };
    assert!(matches!(fate(&by_hand), Err(Argument { name: "xi", .. })));
    assert!(
        rotating::run(&Table::default(), &start, 1.0)
            .unwrap()
            .at(1.1)
            .is_err()
    );
}

proptest::proptest! {
    #[test]
    fn nothing_panics_and_nothing_is_not_a_number(
        size in -12.0..6.0f64, ratio in -12.0..12.0f64, psi in -4.0..4.0f64,
    ) {
        let rho = libm::exp10(size);
        let start = Start::polar(rho, (rho * libm::exp10(ratio)).min(1e9), psi).unwrap();
        match fate(&start) {
            Ok(Fate::Rest { sigma, tau, error, tau_error }) => {
                proptest::prop_assert!(sigma <= 1.0 && tau >= 0.0 && error < 0.01 && tau_error >= 0.0)
            }
            Ok(Fate::Escape { tau, .. } | Fate::Undecided { tau, .. }) => proptest::prop_assert!(tau >= 0.0),
            Err(error) => proptest::prop_assert!(false, "{error}"),
        }
        if let Ok(run) = Run::new(&start, 100.0) {
            for state in run.nodes() {
                proptest::prop_assert!(state.p().is_finite() && state.rho().is_finite() && state.tau.is_finite());
            }
        }
    }
}

#[test]
fn the_last_moments_before_a_rest_are_steadily_braked() {
    use super::path::{Frame, Leg, Path};
    let table = slow();
    let state = State {
        t: 1.0,
        x: [0.3, 0.4],
        v: [0.2, -0.1],
    };
    let (to, place) = (1.5, [0.35, 0.375]);
    let path = |frame| Path {
        table,
        frame,
        legs: vec![Leg::Stopping { state, to }, Leg::Rest { from: to, place }],
        stops: vec![to],
        start: 1.0,
        end: 2.5,
    };
    let turning = path(Frame::Table);
    assert_eq!((turning.end(), turning.stops()), (2.5, &[1.5][..]));
    assert_eq!(turning.resting_place(), Some(place));
    // v falls in proportion to the time left, from (0.2, −0.1) in half a unit of time.
    for (t, x, v) in [
        (1.0, [0.3, 0.4], [0.2, -0.1]),
        (1.125, [0.321875, 0.3890625], [0.15, -0.075]),
        (1.25, [0.3375, 0.38125], [0.1, -0.05]),
        (1.5, place, [0.0; 2]),
        (2.5, place, [0.0; 2]),
    ] {
        let expected = State { t, x, v };
        assert!(apart(&turning.at(t).unwrap(), &expected) < 1e-15, "{t}");
        let laboratory = path(Frame::Laboratory);
        let seen = laboratory.at(t).unwrap();
        assert!(apart(&seen, &table.to_laboratory(&expected)) < 1e-14, "{t}");
        assert!(
            apart(&laboratory.on_table(t).unwrap(), &expected) < 1e-14,
            "{t}"
        );
    }
    for t in [0.999, 2.501, f64::NAN] {
        assert!(turning.at(t).is_err());
    }
}

#[test]
fn the_first_moments_are_those_in_the_laboratory() {
    // At another angular velocity than 1, in a general direction, and not from the time 0 on.
    let table = Table {
        omega: -1.7,
        mu: 0.4,
        ..slow()
    };
    let place = [0.9 * table.length(), -1.2 * table.length()];
    let start = State {
        t: 0.8,
        x: place,
        v: [0.0; 2],
    };
    let on_table = rotating::run(&table, &start, 2.0).unwrap();
    let outside = inertial::run(&table, &table.to_laboratory(&start), 2.0).unwrap();
    let later = State { t: 5.8, ..start };
    let shifted = rotating::run(&table, &later, 7.0).unwrap();
    for k in 0..40 {
        let t = 0.8 + 0.03 * f64::from(k);
        let state = on_table.at(t).unwrap();
        let size = state.radius() + state.speed();
        let other = outside.on_table(t).unwrap();
        assert!(apart(&state, &other) < 1e-12 * size, "{state:?} {other:?}");
        // The law knows no time: later, the same happens.
        let other = State {
            t,
            ..shifted.at(t + 5.0).unwrap()
        };
        assert!(apart(&state, &other) < 1e-12 * size, "{state:?} {other:?}");
    }
}

#[test]
fn the_boundary_of_slow_inward_motion_is_the_largest_rest() {
    // At p = 10⁻⁶ straight inwards: w = 1 − ξ = 2, the way is S = p²/4, and σ² = A² + p²/2.
    let found = boundary(1e-6, std::f64::consts::PI).unwrap();
    assert!((found - (1.0 - 0.25e-12)).abs() < 1e-12, "{found:e}");
}

#[test]
fn without_friction_the_time_is_that_of_the_integration() {
    let free = Table {
        mu: 0.0,
        ..Table::default()
    };
    let state = [[0.3; TERMS]; 5];
    let mut work = Default::default();
    let rates = [0, 1, 2].map(|k| free.derivative(k, &state, &mut work)[0]);
    assert_eq!(rates, [1.0, 0.0, 0.0]);
}
