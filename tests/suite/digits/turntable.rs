//! The turntable against an integration in numbers of 31 digits in the table's own axes: another law than the calculators', up to
//! where its steps become too short.

use super::{Room, TERMS, cases, tally::Tally};
use slipbook::motion::turntable::{Fate, boundary, fate};
use slipbook::numerics::{
    double::Double,
    number::Real,
    series::{product, sqrt, square, value},
    taylor::{Control, Integrator, Step, System},
};
use slipbook::solve::{
    known,
    turntable::{End, Horizon, Start, TurntableProblem},
};
use std::f64::consts::PI;

/// x′ = v, v′ = x + 2 v×ẑ − v/|v|, in a time s with dt = |v| ds; components t, x, y, v_x, v_y.
struct Table;

impl System<Double, 5, TERMS> for Table {
    type Work = Room<4>;

    fn begin(&self, _: &Double, _: &[Double; 5], _: &mut Room<4>) {}

    fn derivative(&self, k: usize, x: &[[Double; TERMS]; 5], room: &mut Room<4>) -> [Double; 5] {
        let [_, x, y, u, v] = x;
        let Room([squared, speed, along_x, along_y]) = room;
        squared[k] = square(u, k) + square(v, k);
        speed[k] = sqrt(squared, speed, k);
        along_x[k] = x[k] + v[k] + v[k];
        along_y[k] = y[k] - u[k] - u[k];
        [
            speed[k],
            product(speed, u, k),
            product(speed, v, k),
            product(speed, along_x, k) - u[k],
            product(speed, along_y, k) - v[k],
        ]
    }
}

fn size(x: Double, y: Double) -> f64 {
    x.hypot(y).to_f64()
}

type Follower = Integrator<'static, Table, Double, 5, TERMS>;

fn begin(rho: impl Into<Double>, p: impl Into<Double>, psi: f64) -> Follower {
    use slipbook::scalar::Scalar;
    let (rho, p, psi, zero) = (rho.into(), p.into(), Double::from(psi), Double::from(0.0));
    let (along, across) = (p * Scalar::cos(psi), -(p * Scalar::sin(psi)));
    Integrator::new(
        &Table,
        zero,
        [zero, rho, zero, along, across],
        Control::Each,
    )
}

/// Where it stops, and when; or the state at the time `until`. Nothing where it takes too long.
fn follow(rho: f64, p: f64, psi: f64, until: f64) -> Option<Result<[f64; 2], [f64; 4]>> {
    let mut integrator = begin(rho, p, psi);
    let mut step = Step::empty();
    for _ in 0..2000 {
        let &[t, x, y, u, v] = integrator.state();
        let speed = u.hypot(v);
        // So slow it does not matter how the deceleration changes.
        if speed.to_f64() < 1e-24 * p.min(1.0) {
            let pull = (x * u + y * v) / speed;
            let left = speed / (Double::from(1.0) - pull);
            let half = left * Double::from(0.5);
            return Some(Ok([size(x + half * u, y + half * v), (t + left).to_f64()]));
        }
        integrator.expand(&mut step).ok()?;
        let left = Double::from(until) - t;
        if (slipbook::numerics::series::change(&step.series[0], &Double::from(step.h)) - left)
            .to_f64()
            >= 0.0
        {
            let mut h = Double::from(0.0);
            for _ in 0..200 {
                let clock = value(&step.series[0], &h) - t;
                let rate = size(value(&step.series[3], &h), value(&step.series[4], &h));
                let change = (left - clock) / Double::from(rate);
                h = h + change;
                if change.to_f64().abs() < 1e-30 * step.h {
                    break;
                }
            }
            let [_, x, y, u, v] = step.at(&h).map(f64::from);
            return Some(Err([x, y, u, v]));
        }
        integrator.advance(&step);
    }
    None
}

/// When it is first at the distance `far`; nothing where that takes too long.
fn crosses(rho: f64, p: f64, psi: f64, far: f64) -> Option<f64> {
    let mut integrator = begin(rho, p, psi);
    let mut step = Step::empty();
    let beyond = |x: Double, y: Double| (x * x + y * y).to_f64() - far * far;
    for _ in 0..2000 {
        integrator.expand(&mut step).ok()?;
        let [_, x, y, u, v] = step.at(&Double::from(step.h));
        if beyond(x, y) >= 0.0 {
            let [mut low, mut high] = [0.0, step.h];
            while high - low > 2.0 * f64::EPSILON * high {
                let middle = 0.5 * (low + high);
                let [_, x, y, ..] = step.at(&Double::from(middle));
                *(if beyond(x, y) < 0.0 {
                    &mut low
                } else {
                    &mut high
                }) = middle;
            }
            return Some(step.at(&Double::from(low))[0].to_f64());
        }
        if u.hypot(v).to_f64() < 1e-12 {
            return None;
        }
        integrator.advance(&step);
    }
    None
}

fn start(rng: &mut fastrand::Rng) -> [f64; 3] {
    let small = |rng: &mut fastrand::Rng, most: f64| 10f64.powf(-most * rng.f64());
    let psi = match rng.u8(0..8) {
        0 => [0.0, PI, -PI, 0.5 * PI, -0.5 * PI][rng.usize(0..5)],
        1 => small(rng, 12.0),
        _ => PI * (2.0 * rng.f64() - 1.0),
    };
    match rng.u8(0..8) {
        0..=3 => [1.3 * rng.f64(), 2.0 * rng.f64(), psi],
        // As far as this integration gets.
        4 => {
            let gap = small(rng, 2.0);
            [1.0 - gap, gap * 3.0 * rng.f64(), psi]
        }
        5 => [rng.f64(), small(rng, 20.0), psi],
        6 => [small(rng, 9.0), rng.f64(), psi],
        // Close to the border, by some distance.
        _ => {
            let (alpha, psi) = (0.02 + 2.0 * rng.f64(), psi);
            let a = boundary(alpha, psi).unwrap() * (1.0 - small(rng, 6.0));
            [a * alpha.cosh(), a * alpha.sinh(), psi]
        }
    }
}

#[test]
fn rest_by_another_law_in_other_variables() {
    let mut rng = fastrand::Rng::with_seed(20);
    let [mut rests, mut place, mut time] = [(); 3].map(|()| Tally::default());
    let mut alone = [(); 2].map(|()| Tally::default());
    let wanted = cases(150);
    let horizon = Horizon {
        rho: 100.0,
        tau: 1e3,
    };
    while rests.cases() < wanted {
        let [rho, p, psi] = start(&mut rng);
        let case = format!("{rho:?} {p:?} {psi:?}");
        let problem = TurntableProblem::Polar { rho, p, psi };
        let found = follow(rho, p, psi, 30.0);
        let Some(Ok([sigma, tau])) = found else {
            if let Some(Err([x, y, ..])) = found
                && x.hypot(y) > 2.0
            {
                assert_eq!(problem.fate().unwrap().best.outcome, "escape", "{case}");
            }
            continue;
        };
        let exact = |name: &str| match name {
            "outcome" => Some("rest".to_owned()),
            "sigma" => Some(format!("{sigma:?}")),
            _ => Some(format!("{tau:?}")),
        };
        rests.answer(&problem.fate().unwrap(), exact, &case);
        let start = Start::polar(rho, p, psi).unwrap();
        let Fate::Rest {
            sigma: s,
            tau: t,
            error,
            tau_error,
        } = fate(&start).unwrap()
        else {
            panic!("{case}")
        };
        alone[0].number(s, known(s, error), sigma, &case);
        alone[1].number(t, known(t, tau_error), tau, &case);
        let [
            Ok(End::Rest {
                sigma: s,
                sigma_error,
                tau: t,
                tau_error,
            }),
        ] = horizon.follow_alone(&[start]).unwrap()[..]
        else {
            panic!("{case}")
        };
        place.number(s, known(s, sigma_error), sigma, &case);
        time.number(t, known(t, tau_error), tau, &case);
    }
    let all = wanted >= 10_000;
    let closed = [
        rests.closes("turntable: rest", all),
        place.closes("ensemble: distance of rest", all),
        time.closes("ensemble: time", all),
        alone[0].closes("library: distance of rest", all),
        alone[1].closes("library: time", all),
    ];
    assert_eq!(closed, [true; 5]);
}

#[test]
fn escape_by_another_law_in_other_variables() {
    let mut rng = fastrand::Rng::with_seed(24);
    let mut tally = Tally::default();
    let wanted = cases(100);
    while tally.cases() < wanted {
        let [rho, p, psi] = start(&mut rng);
        let far = 10f64.powf(0.5 + 2.5 * rng.f64());
        let Some(exact) = crosses(rho, p, psi, far) else {
            continue;
        };
        let horizon = Horizon { rho: far, tau: 1e3 };
        let start = Start::polar(rho, p, psi).unwrap();
        let case = format!("{rho:?} {p:?} {psi:?} {far:?}");
        let [Ok(End::Far { tau, tau_error })] = horizon.follow_alone(&[start]).unwrap()[..] else {
            panic!("{case}")
        };
        tally.number(tau, known(tau, tau_error), exact, &case);
    }
    assert!(tally.closes("ensemble: time of escape", wanted >= 10_000));
}

#[test]
fn a_state_by_another_law_in_other_variables() {
    let mut rng = fastrand::Rng::with_seed(21);
    let mut tally = Tally::default();
    let wanted = cases(100);
    while tally.cases() < wanted {
        let [rho, p, psi] = start(&mut rng);
        let until = match rng.u8(0..4) {
            0 => 20.0 * rng.f64(),
            1 => 10f64.powf(-6.0 * rng.f64()),
            _ => 2.0 * rng.f64(),
        };
        let case = format!("{rho:?} {p:?} {psi:?} {until:?}");
        let Some(Err([x, y, u, v])) = follow(rho, p, psi, until) else {
            continue;
        };
        let numbers = [
            ("x", x),
            ("y", y),
            ("vx", u),
            ("vy", v),
            ("rho", x.hypot(y)),
            ("p", u.hypot(v)),
            ("psi", (u * y - v * x).atan2(u * x + v * y)),
        ];
        let exact = |name: &str| {
            let number = numbers.iter().find(|(own, _)| *own == name);
            number.map(|(_, x)| format!("{x:?}"))
        };
        tally.answer(
            &TurntableProblem::Polar { rho, p, psi }.at(until).unwrap(),
            exact,
            &case,
        );
    }
    assert!(tally.closes("turntable: at a time", wanted >= 10_000));
}

/// Where the slow motion with this small p runs into p = w = 0, by the power series of p w w′ = ζ² and p w ζ′ = p + ζ − wζ with w
/// = p + …, ζ = −p + ….
fn border(p: Double) -> Double {
    let (mut w, mut zeta) = (
        vec![0.0.into(), 1.0.into()],
        vec![0.0.into(), (-1.0).into()],
    );
    let (mut sum, mut last, mut power) = (p, p.to_f64(), p);
    for n in 2..150_usize {
        let times = |k: usize| Double::from(k as f64);
        let folded = |a: &[Double], b: &[Double], from: usize| {
            let products = (from..n).map(|i| a[i] * b[n + 1 - i]);
            products.fold(Double::from(0.0), |sum, x| sum + x)
        };
        let slopes = (1..n).map(|i| w[i] * times(n - i + 1) * zeta[n - i]);
        let next = slopes.fold(Double::from(0.0), |sum: Double, x| sum + x);
        let first = (folded(&zeta, &zeta, 2) - next - next) / times(n + 1);
        let term = first - folded(&w, &w, 2) * 0.5.into();
        w.push(term);
        zeta.push(next);
        power = power * p;
        let size = (term * power).to_f64().abs();
        if size > last {
            break;
        }
        (sum, last) = (sum + term * power, size);
    }
    sum
}

/// At last by the side of the border on which the slow motion lies.
fn rests(rho: Double, p: Double, psi: f64) -> bool {
    let one = Double::from(1.0);
    let mut integrator = begin(rho, p, psi);
    let mut step = Step::empty();
    let mut settling = 0.0;
    loop {
        let &[_, x, y, u, v] = integrator.state();
        let (p, rho) = (u.hypot(v), x.hypot(y));
        let w = one - (x * u + y * v) / p;
        if w.to_f64() <= 0.0 {
            return false;
        }
        if p.to_f64() < 0.7 * (one - rho).to_f64() {
            return true;
        }
        if settling > 60.0 && p.to_f64() < 0.02 {
            return (w - border(p)).to_f64() > 0.0;
        }
        integrator.expand(&mut step).unwrap();
        integrator.advance(&step);
        let near = p.to_f64().max(w.to_f64()) < 0.05;
        settling = if near { settling + step.h } else { 0.0 };
    }
}

#[test]
fn the_boundary_has_rest_below_and_escape_above() {
    use slipbook::scalar::Scalar;
    use slipbook::solve::rest::BoundaryProblem;
    let mut rng = fastrand::Rng::with_seed(22);
    let [mut solved, mut library] = [(); 2].map(|()| Tally::default());
    let wanted = cases(60);
    while solved.cases() < wanted {
        let alpha = 10f64.powf(-6.0 + 7.0 * rng.f64());
        let psi = PI * (2.0 * rng.f64() - 1.0);
        let case = format!("{alpha:?} {psi:?}");
        let answer = BoundaryProblem { alpha, psi }.solve().unwrap();
        let a = answer.best.a;
        let rests = |part: f64| {
            let a = Double::from(a) + (a * part).into();
            let alpha = Double::from(alpha);
            rests(a * Scalar::cosh(alpha), a * Scalar::sinh(alpha), psi)
        };
        let off = [2e-16, 1e-15, 1e-14]
            .into_iter()
            .find(|off| rests(-off) && !rests(*off));
        let exact = off.map_or(f64::NAN, |off| a * (1.0 + off));
        solved.answer(&answer, |_| Some(format!("{exact:?}")), &case);
        let near = boundary(alpha, psi).unwrap();
        library.number(near, known(near, 1e-13), a, &case);
    }
    let all = wanted >= 10_000;
    let closed = [
        solved.closes("turntable: boundary", all),
        library.closes("library: boundary", all),
    ];
    assert_eq!(closed, [true; 2]);
}
