//! The ways to the motion against each other, and where the end is known.

use super::fate::{Fate, fate};
use super::intrinsic::{Run, Start};
use super::*;
use crate::numerics::taylor::{System, TERMS};
use std::f64::consts::{FRAC_PI_2, PI};

/// Relative to their size where that is above 1.
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
fn the_boundary_parts_rest_from_escape() {
    for (alpha, psi) in [(0.3, 0.4), (0.3, -2.0), (0.05, FRAC_PI_2), (0.003, 1.0)] {
        let a = boundary(alpha, psi).unwrap();
        let near = |a: f64| fate(&Start::hyperbolic(a, alpha, psi).unwrap()).unwrap();
        for i in 0..200 {
            let away = 0.2 * libm::pow(0.9, f64::from(i)) + 2e-12;
            assert!(matches!(near(a - away), Fate::Rest { .. }), "{a} {away}");
            assert!(matches!(near(a + away), Fate::Escape { .. }), "{a} {away}");
        }
    }
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
    use crate::MotionError::Argument;
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

/// μg = 1 and μ_s g = 5/4, Ω = 1: at rest at 6/5 a particle stays, at 13/10 it sets out.
#[test]
fn static_friction_holds_farther_out() {
    let table = Table::default();
    for (radius, rests) in [(0.9, true), (1.2, true), (1.25, true), (1.3, false)] {
        let start = State {
            x: [0.6 * radius, -0.8 * radius],
            ..State::moving([0.0; 2])
        };
        let held = rotating::run_held(&table, 1.25, &start, 2.0).unwrap();
        assert_eq!(held.resting_place(), rests.then_some(start.x), "{radius}");
        let free = rotating::run(&table, &start, 2.0).unwrap();
        assert_eq!(held == free, radius != 1.2 && radius != 1.25, "{radius}");
    }
    let refused = rotating::run_held(&table, 0.9, &State::moving([0.0; 2]), 1.0);
    assert!(matches!(
        refused,
        Err(MotionError::Argument {
            name: "holding",
            ..
        })
    ));
}
