//! The curves that `--plot` draws go through the answers.

use crate::claims::solve::constant::At;
use crate::claims::solve::{Curve, constant, periodic, rest, sinusoidal, sphere, turntable};
use std::f64::consts::{PI, TAU};

#[track_caller]
fn near(a: [f64; 2], b: [f64; 2], within: f64) {
    assert!(
        libm::hypot(a[0] - b[0], a[1] - b[1]) <= within,
        "{a:?} {b:?}"
    );
}

fn ends(curve: &Curve) -> [[f64; 2]; 2] {
    [curve.points[0], curve.points[curve.points.len() - 1]]
}

#[test]
fn velocities_run_from_the_launch_to_the_stop_or_for_three_times_v0_over_a() {
    let launch = |lambda: f64| constant::Problem {
        lambda,
        v0: 4.0,
        theta0: 1.0,
        accel: 0.5,
        at: At::Time(0.1),
    };
    let start = [4.0 * libm::cos(1.0), 4.0 * libm::sin(1.0)];
    let stopping = launch(3.0).curve().unwrap();
    near(ends(&stopping)[0], start, 1e-12);
    near(ends(&stopping)[1], [0.0; 2], 1e-9);
    // Without friction a particle falls along x with A = 1/2, here for a time of 24.
    let falling = launch(0.0).curve().unwrap();
    near(ends(&falling)[0], start, 1e-12);
    near(ends(&falling)[1], [start[0] + 12.0, start[1]], 1e-9);
    let half = [start[0] + 6.0, start[1]];
    assert!(
        falling
            .points
            .iter()
            .any(|v| libm::hypot(v[0] - half[0], v[1] - half[1]) < 1e-9)
    );
    // The moment asked for is shown, however late.
    let late = constant::Problem {
        at: At::Time(40.0),
        ..launch(0.0)
    };
    near(
        ends(&late.curve().unwrap())[1],
        [start[0] + 20.0, start[1]],
        1e-9,
    );
}

#[test]
fn slips_run_until_the_sphere_rolls_or_for_three_times_u0_over_gamma() {
    let launch = |gamma, at| sphere::Problem {
        gamma,
        u0: 2.0,
        theta0: 1.0,
        kappa: 0.4,
        at: At::Time(at),
    };
    let start = [2.0 * libm::cos(1.0), 2.0 * libm::sin(1.0)];
    let rolling = launch(1.0, 0.1).curve().unwrap();
    near(ends(&rolling)[0], start, 1e-12);
    near(ends(&rolling)[1], [0.0; 2], 1e-9);
    for (at, shown) in [(0.1, 0.6), (0.9, 0.9)] {
        let sliding = launch(10.0, at).curve().unwrap();
        let then = launch(10.0, shown).solve().unwrap().best.slip;
        near(ends(&sliding)[1], then, 1e-11);
        assert_eq!(sliding.points.len(), 401);
    }
}

#[test]
fn large_time_motions_are_shown_for_two_periods() {
    let sine = sinusoidal::Problem { lambda0: 0.7 };
    let pulse = periodic::Problem {
        eta: 0.4,
        lambda0: 0.6,
    };
    for (curve, most) in [
        (sine.curve().unwrap(), sine.solve().unwrap().best.w_max),
        (pulse.curve().unwrap(), pulse.solve().unwrap().best.w_max),
    ] {
        assert_eq!(curve.points.len(), 401);
        for (k, [phi, w]) in curve.points.iter().enumerate() {
            assert!((phi - k as f64 * TAU / 200.0).abs() < 1e-12);
            // Half a period later the velocity is the opposite.
            let later = curve.points[(k + 100) % 400];
            assert!((w + later[1]).abs() < 1e-12, "{phi}");
        }
        let highest = curve.points.iter().map(|p| p[1]).fold(0.0, f64::max);
        assert!(highest <= most && highest > 0.97 * most, "{highest} {most}");
    }
}

#[test]
fn the_boundary_is_drawn_from_rest_to_one_or_farther() {
    for (alpha, most) in [(0.2, 1.0), (2.0, 2.0)] {
        let curve = rest::Problem { alpha, psi: 0.5 }.curve().unwrap();
        near(curve.points[0], [0.0, 1.0], 0.0);
        assert_eq!(curve.points.len(), 41);
        for k in [10, 25, 40] {
            let alpha = most * k as f64 / 40.0;
            let a = rest::Problem { alpha, psi: 0.5 }.solve().unwrap().best.a;
            near(curve.points[k], [alpha, a], 1.5e-4 * a);
        }
    }
}

#[test]
fn paths_end_where_the_particle_rests() {
    let start = turntable::Problem::Polar {
        rho: 0.5,
        p: 0.4,
        psi: 1.0,
    };
    let sigma = start.fate().unwrap().best.sigma.unwrap();
    let [from, to] = ends(&start.curve(None).unwrap());
    near(from, [0.5, 0.0], 1e-15);
    assert!((libm::hypot(to[0], to[1]) - sigma).abs() < 1e-9);
    let short = start.curve(Some(0.1)).unwrap();
    let then = start.at(0.1).unwrap().best.position;
    near(ends(&short)[1], then, 1e-11);
    // What does not rest is shown for a while.
    let away = turntable::Problem::Polar {
        rho: 2.0,
        p: 0.4,
        psi: PI / 3.0,
    };
    let [_, last] = ends(&away.curve(None).unwrap());
    assert!(libm::hypot(last[0], last[1]) > 4.0, "{last:?}");
}
