//! The calculators: their curves are those of the motion that they answer for, and their answers say how they were found.

use slipbook::claims::anisotropic::simulated::Curves;
use slipbook::paper::anisotropic::region;
use slipbook::solve::{
    Curve, SolveError, anisotropic, anisotropic::AnisotropicProblem, constant, periodic, rest,
    sinusoidal, sphere, turntable,
};
use std::f64::consts::{PI, TAU};

#[track_caller]
fn assert_near([x, y]: [f64; 2], [a, b]: [f64; 2], within: f64) {
    assert!(
        (x - a).abs() < within && (y - b).abs() < within,
        "({x}, {y}) and ({a}, {b})"
    );
}

/// Until rest, or for three times as long as the speed would last at the acceleration alone.
#[test]
fn the_velocity_is_shown_from_the_launch_to_its_end() {
    for (lambda, v0, theta0, accel) in [
        (1.5, 2.0, 2.5, 0.5),
        (0.4, 2.0, 1.0, 5.0),
        (1.0, 3.0, -2.0, 0.7),
    ] {
        let at = |t| constant::ConstantProblem {
            lambda,
            v0,
            theta0,
            accel,
            at: constant::At::Time(t),
        };
        let answer = at(0.0).solve().unwrap();
        let points = at(0.0).curve().unwrap().points;
        assert_near(
            points[0],
            [v0 * libm::cos(theta0), v0 * libm::sin(theta0)],
            1e-9,
        );
        let end = answer.best.stop_time.unwrap_or(3.0 * v0 / accel);
        let last = at(end).solve().unwrap().best;
        assert_near(points[points.len() - 1], [last.vx, last.vy], 1e-6);
        assert_eq!(answer.best.stop_time.is_some(), lambda > 1.0);
        let later = at(end + 1.0).curve().unwrap().points;
        let then = at(end + 1.0).solve().unwrap().best;
        assert_near(later[later.len() - 1], [then.vx, then.vy], 1e-6);
    }
}

#[test]
fn the_slip_is_shown_from_the_start_to_its_end() {
    for (gamma, u0, theta0) in [(0.3, 2.0, 2.0), (9.0, 3.0, 1.0)] {
        let at = |tau| sphere::SphereProblem {
            gamma,
            u0,
            theta0,
            kappa: 0.4,
            at: constant::At::Time(tau),
        };
        let answer = at(0.0).solve().unwrap();
        let points = at(0.0).curve().unwrap().points;
        assert_near(
            points[0],
            [u0 * libm::cos(theta0), u0 * libm::sin(theta0)],
            1e-9,
        );
        let end = answer.best.rolls_at.unwrap_or(3.0 * u0 / gamma);
        let last = at(end).solve().unwrap().best;
        assert_near(points[points.len() - 1], last.slip, 1e-6);
        let half = at(0.5 * end).solve().unwrap().best;
        assert_near(points[points.len() / 2], half.slip, 1e-9);
    }
}

/// From point to point w changes as h − λ₊ or h + λ₋ make it, or it rests.
fn obeys(curve: &Curve, h: impl Fn(f64) -> f64, plus: f64, minus: f64) {
    assert_eq!((curve.points[0][0], curve.points.len()), (0.0, 401));
    assert!((curve.points[400][0] - 2.0 * TAU).abs() < 1e-12);
    let mut moves = 0;
    for pair in curve.points.windows(2) {
        let ([from, w], [to, next]) = (pair[0], pair[1]);
        let step = to - from;
        assert!((step - 2.0 * TAU / 400.0).abs() < 1e-12);
        let rate = match (w, next) {
            (w, next) if w > 0.0 && next > 0.0 => -plus,
            (w, next) if w < 0.0 && next < 0.0 => minus,
            _ => continue,
        };
        moves += 1;
        let middle = (h(from + 1e-9) + 4.0 * h(0.5 * (from + to)) + h(to - 1e-9)) / 6.0;
        let jump = (h(to - 1e-9) - h(from + 1e-9)).abs() > 0.5;
        assert!(
            jump || (next - w - (middle + rate) * step).abs() < 1e-6,
            "at {from}: {w}, {next}"
        );
    }
    assert!(moves > 100);
}

#[test]
fn a_driven_motion_is_shown_for_two_periods() {
    for lambda0 in [0.2, 0.7] {
        let curve = sinusoidal::SinusoidalProblem { lambda0 }.curve().unwrap();
        obeys(&curve, libm::sin, lambda0, lambda0);
        for eta in [0.0, 0.3, 0.7, 1.0] {
            let h = |phi: f64| {
                let phi = phi.rem_euclid(TAU);
                let (sign, phi) = if phi < PI {
                    (1.0, phi)
                } else {
                    (-1.0, phi - PI)
                };
                if phi < eta * PI { sign } else { 0.0 }
            };
            let curve = periodic::PeriodicProblem { eta, lambda0 }.curve().unwrap();
            if eta == 0.0 {
                assert!(curve.points.iter().all(|p| p[1] == 0.0));
            } else {
                obeys(&curve, h, lambda0, lambda0);
            }
        }
        for q in [0.5, 1.2] {
            let curve = anisotropic::AnisotropicProblem { q, lambda0 }
                .curve()
                .unwrap();
            obeys(&curve, libm::sin, lambda0, q * lambda0);
        }
    }
}

#[test]
fn a_plane_that_is_rougher_forward_moves_as_one_that_is_rougher_backward_does() {
    for (q, lambda0) in [
        (2.0, 0.1),
        (2.0, 0.3),
        (2.0, 0.45),
        (6.0, 0.12),
        (3.0, 0.9),
        (2.0, 1.2),
    ] {
        let there = anisotropic::AnisotropicProblem { q, lambda0 }
            .solve()
            .unwrap();
        let back = anisotropic::AnisotropicProblem {
            q: 1.0 / q,
            lambda0: q * lambda0,
        }
        .solve()
        .unwrap();
        let (a, b) = (there.best, back.best);
        assert_eq!(a.region, b.region);
        assert!((a.positive - b.negative).abs() < 1e-9 && (a.negative - b.positive).abs() < 1e-9);
        assert!(
            (a.drift_per_period + b.drift_per_period).abs() < 1e-9,
            "{a:?} {b:?}"
        );
        assert!(back.note.contains("exchanged") && !there.note.contains("exchanged"));
        // Above E and below C the paper's list has another name for it.
        let lacks = a.region == "IV" && q * lambda0 < 1.0;
        assert_eq!(
            there.note.contains("lacks the curve E"),
            lacks,
            "{q} {lambda0}: {}",
            there.note
        );
    }
    let beyond_y = anisotropic::AnisotropicProblem {
        q: 9.0,
        lambda0: 0.1,
    }
    .solve()
    .unwrap();
    assert_eq!(beyond_y.best.region, "IV");
    assert!(beyond_y.note.contains("lacks the curve E"));
}

#[test]
fn the_boundary_is_compared_with_its_expansion_and_shown_as_it_is() {
    for (alpha, psi) in [(1e-3, 0.5), (0.3, -1.0), (1.0, 2.0), (1.7, 0.4)] {
        let problem = rest::BoundaryProblem { alpha, psi };
        let answer = problem.solve().unwrap();
        let a = answer.best.a;
        assert_eq!(answer.by_motion.map(|m| m.a), Some(a));
        let formula = answer.by_formula.map(|f| f.a);
        assert_eq!(formula.is_some(), alpha <= 0.3, "α = {alpha}");
        let differs = formula.map(|f| (f - a).abs() / f.abs().max(a.abs()));
        assert_eq!(answer.disagreement, differs);
        let points = problem.curve().unwrap().points;
        assert_eq!(
            (points.len(), points[0], points[40][0]),
            (41, [0.0, 1.0], alpha.max(1.0))
        );
        for [alpha, a] in [points[1], points[20], points[40]] {
            let exact = rest::BoundaryProblem { alpha, psi }.solve().unwrap().best.a;
            assert!((a - exact).abs() < 2e-4 * exact, "{alpha}: {a}, {exact}");
        }
    }
    // So near to rest the bisection and the expansion are one.
    let near = rest::BoundaryProblem {
        alpha: 1e-6,
        psi: 0.5,
    }
    .solve()
    .unwrap();
    assert_eq!(near.by_motion, Some(near.best));
    assert!(near.disagreement < Some(1e-15), "{near:?}");
}

#[test]
fn the_path_on_the_table_is_shown_until_rest_or_for_the_time_asked() {
    let resting = turntable::TurntableProblem::Polar {
        rho: 0.2,
        p: 0.4,
        psi: 1.0,
    };
    let answer = resting.fate().unwrap();
    let (sigma, time) = (answer.best.sigma.unwrap(), answer.best.tau_rest.unwrap());
    assert!(answer.disagreement.is_some_and(|d| d < 1e-9) && answer.by_motion == Some(answer.best));
    let points = resting.curve(None).unwrap().points;
    let [x, y] = points[points.len() - 1];
    assert!((libm::hypot(x, y) - sigma).abs() < 1e-9);
    for (k, point) in points.iter().enumerate().step_by(150) {
        let moment = resting.at(time * k as f64 / 600.0).unwrap().best;
        assert_near(*point, moment.position, 1e-9);
    }
    let escaping = turntable::TurntableProblem::Polar {
        rho: 1.5,
        p: 1.0,
        psi: 0.2,
    };
    let answer = escaping.fate().unwrap();
    assert_eq!(
        (answer.best.outcome, answer.best.sigma, answer.best.tau_rest),
        ("escape", None, None)
    );
    assert_eq!((answer.disagreement, answer.digits), (None, None));
    let points = escaping.curve(Some(2.0)).unwrap().points;
    assert_near(points[600], escaping.at(2.0).unwrap().best.position, 1e-9);
    assert!(matches!(
        escaping.at(-1.0),
        Err(SolveError::Parameter { .. })
    ));
}

#[test]
fn the_disagreement_of_an_answer_is_that_of_its_two_ways() {
    for lambda0 in [0.1, 0.3, 0.6, 0.8] {
        let answer = sinusoidal::SinusoidalProblem { lambda0 }.solve().unwrap();
        let (a, b) = (answer.by_formula.unwrap(), answer.by_motion.unwrap());
        let relative = |a: f64, b: f64| {
            if a == b {
                0.0
            } else {
                (a - b).abs() / a.abs().max(b.abs())
            }
        };
        let worst = [
            relative(a.positive_start.unwrap(), b.positive_start.unwrap()),
            relative(a.positive_end.unwrap(), b.positive_end.unwrap()),
            relative(a.rest_fraction, b.rest_fraction),
            relative(a.w_max, b.w_max),
        ];
        let worst = worst.into_iter().fold(0.0, f64::max);
        assert_eq!(answer.disagreement, Some(worst));
        assert!(worst < 1e-9, "{lambda0}: {worst}");
        assert_eq!(answer.digits, Some(15));
    }
}

#[test]
fn the_note_says_where_the_printed_list_errs() {
    let mut random = fastrand::Rng::with_seed(55);
    let mut erring = 0;
    for i in 0..300 {
        let q = 1.0 + 20.0 * random.f64();
        // Every third point lies between the curve E and C, or close below C.
        let reach = if i % 3 == 0 { 1.0 } else { 1.3 * q };
        let lambda0 = (0.01 + reach * random.f64()) / q;
        let answer = AnisotropicProblem { q, lambda0 }.solve().unwrap();
        let listed = region(lambda0, &Curves::at(q).unwrap().printed).unwrap();
        let errs = ["I", "II", "III", "IV", "V"][listed - 1] != answer.best.region;
        erring += usize::from(errs);
        assert_eq!(
            answer.note.contains("printed list"),
            errs,
            "q = {q}, λ₀ = {lambda0}"
        );
    }
    assert!(erring > 20, "{erring}");
    // On C itself, qλ₀ = 1, where powers of two leave no rounding, the list is right.
    for q in [2.0, 4.0, 8.0, 16.0] {
        let answer = AnisotropicProblem {
            q,
            lambda0: 1.0 / q,
        };
        let answer = answer.solve().unwrap();
        assert_eq!((answer.best.region, answer.best.negative), ("IV", 0.0));
        assert!(
            !answer.note.contains("printed list"),
            "{q}: {}",
            answer.note
        );
    }
}
