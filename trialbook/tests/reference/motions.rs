//! The Taylor integrator against mpmath's solutions (`motions.py`).

use crate::table::{ball, number, rows};
use trialbook::certified::{ball::Ball, interval::Interval};
use trialbook::numerics::{
    double::Double,
    number::{Number, Real},
    series::{Series, power, product, sin_cos, sqrt, square},
    taylor::{Control, Integrator, Step, System, TERMS, integrate},
};

/// Unused ones are at rest at 0.
const MOST: usize = 4;

struct Law<'a> {
    name: &'a str,
    parameter: f64,
}

struct Room<T>([Vec<T>; 3]);

impl<T> Default for Room<T> {
    fn default() -> Self {
        Room([const { Vec::new() }; 3])
    }
}

impl<T: Number, const N: usize> System<T, MOST, N> for Law<'_> {
    type Work = Room<T>;

    fn begin(&self, t: &T, _: &[T; MOST], Room(room): &mut Room<T>) {
        *room = std::array::from_fn(|_| vec![T::from_f64(0.0); N]);
        if matches!(self.name, "wave" | "gauss") {
            (room[0][0], room[0][1]) = (t.clone(), T::from_f64(1.0));
        }
    }

    fn derivative(
        &self,
        k: usize,
        x: &[Series<T, N>; MOST],
        Room(room): &mut Room<T>,
    ) -> [T; MOST] {
        let times = |n: f64, x: T| T::from_f64(n) * x;
        let zero = || T::from_f64(0.0);
        let only_first = |c: f64| T::from_f64(if k == 0 { c } else { 0.0 });
        let p = self.parameter;
        // The squares of two components together, and a power of their sum.
        let mut length = |i: usize, exponent: f64| {
            room[0][k] = square(&x[i], k) + square(&x[i + 1], k);
            room[1][k] = power(&room[0], exponent, &room[1], k);
        };
        match self.name {
            "pull" => {
                length(0, -0.5);
                let [a, b] = [0, 1].map(|i| -times(p, product(&x[i], &room[1], k)));
                [only_first(1.0) + a, b, zero(), zero()]
            }
            "turn" => {
                length(2, -0.5);
                let [a, b] = [2, 3].map(|i| product(&x[i], &room[1], k));
                let [u, v] = [2, 3].map(|i| x[i][k].clone());
                let turned = [
                    x[0][k].clone() + times(2.0, v.clone()) - a,
                    x[1][k].clone() - times(2.0, u.clone()) - b,
                ];
                let [du, dv] = turned;
                [u, v, du, dv]
            }
            "kepler" => {
                length(0, -1.5);
                let [a, b] = [0, 1].map(|i| -product(&x[i], &room[1], k));
                [x[2][k].clone(), x[3][k].clone(), a, b]
            }
            "wave" | "pendulum" => {
                let of = if self.name == "wave" {
                    &room[0]
                } else {
                    &x[0][..]
                };
                let (s, c) = sin_cos(of, &room[1], &room[2], k);
                (room[1][k], room[2][k]) = (s.clone(), c);
                let pull = if self.name == "wave" {
                    s - only_first(p)
                } else {
                    -times(p, s)
                };
                [x[1][k].clone(), pull, zero(), zero()]
            }
            "growth" => [x[0][k].clone() - square(&x[0], k), zero(), zero(), zero()],
            "vanderpol" => {
                room[0][k] = square(&x[0], k);
                let rest = x[1][k].clone() - product(&room[0], &x[1], k);
                [
                    x[1][k].clone(),
                    times(p, rest) - x[0][k].clone(),
                    zero(),
                    zero(),
                ]
            }
            "lorenz" => {
                let [a, b, c] = [0, 1, 2].map(|i| x[i][k].clone());
                let fall = T::from_f64(8.0) / T::from_f64(3.0) * c;
                let ab = product(&x[0], &x[1], k);
                let bend = times(28.0, a.clone()) - product(&x[0], &x[2], k) - b.clone();
                [times(10.0, b - a), bend, ab - fall, zero()]
            }
            "gauss" => [
                times(-2.0, product(&room[0], &x[0], k)),
                zero(),
                zero(),
                zero(),
            ],
            "root" => {
                room[0][k] = square(&x[0], k) + only_first(1.0);
                room[1][k] = sqrt(&room[0], &room[1], k);
                [room[1][k].clone(), zero(), zero(), zero()]
            }
            other => panic!("no law {other}"),
        }
    }
}

struct Case {
    law: Law<'static>,
    time: f64,
    start: Vec<f64>,
    end: Vec<&'static str>,
}

fn cases() -> Vec<Case> {
    let mut cases: Vec<Case> = Vec::new();
    let mut begun = Vec::new();
    for [name, parameter, time, start, end] in rows(include_str!("motions.csv")) {
        let components = match name {
            "turn" | "kepler" => 4,
            "lorenz" => 3,
            "growth" | "gauss" | "root" => 1,
            _ => 2,
        };
        if begun.last().is_none_or(|left| *left == 0) {
            let law = Law {
                name,
                parameter: number(parameter),
            };
            cases.push(Case {
                law,
                time: number(time),
                start: Vec::new(),
                end: Vec::new(),
            });
            begun.push(components);
        }
        let (case, left) = (cases.last_mut(), begun.last_mut());
        if let (Some(case), Some(left)) = (case, left) {
            case.start.push(number(start));
            case.end.push(end);
            *left -= 1;
        }
    }
    cases
}

/// The nearest double and what it lacks.
fn double(decimals: &str) -> Double {
    let near = number(decimals);
    let single = Ball::enclosing(Interval::point(near), 300).expect("a finite number");
    let lacks = ball(decimals, 300) - single.middle();
    // An interval tells 90 bits after the point.
    let shift = Ball::int(1 << 50, 0);
    let shifted = lacks * &shift * &shift;
    Double::from(near) + Double::from(shifted.interval().mid() * 2.0_f64.powi(-100))
}

fn padded<T: Number>(start: &[f64]) -> [T; MOST] {
    std::array::from_fn(|i| T::from_f64(start.get(i).copied().unwrap_or(0.0)))
}

/// Some for each step, and those at the start count for more where motions part, or where what ends small began large.
fn parting(name: &str) -> f64 {
    match name {
        "lorenz" | "kepler" | "gauss" => 300.0,
        _ => 30.0,
    }
}

#[test]
fn ends_in_doubles_are_those_of_mpmath() {
    let cases = cases();
    assert!(!cases.is_empty());
    for Case {
        law,
        time,
        start,
        end,
    } in cases
    {
        let run = integrate::<_, MOST, TERMS>(&law, 0.0, padded(&start), time, Control::Each, 1000);
        let found = run.expect("a motion without end").end;
        let size = end.iter().map(|x| number(x).abs()).fold(0.0, f64::max);
        for (i, exact) in end.iter().enumerate() {
            let off = (found[i] - number(exact)).abs() / size / f64::EPSILON;
            assert!(
                off <= parting(law.name),
                "{} {i}: {}, but {exact}: {off}",
                law.name,
                found[i]
            );
        }
    }
}

#[test]
fn ends_in_numbers_of_31_digits_are_those_of_mpmath() {
    for Case {
        law,
        time,
        start,
        end,
    } in cases()
    {
        let zero = Double::from(0.0);
        let mut run =
            Integrator::<_, Double, MOST, 44>::new(&law, zero, padded(&start), Control::Each);
        let mut step = Step::empty();
        let mut found = None;
        for _ in 0..1000 {
            run.expand(&mut step).expect("finite coefficients");
            let left = Double::from(time) - *run.t();
            if step.h >= left.to_f64() {
                found = Some(step.at(&left));
                break;
            }
            run.advance(&step);
        }
        let found = found.expect("an end within so many steps");
        let size = end.iter().map(|x| number(x).abs()).fold(0.0, f64::max);
        for (found, exact) in found.iter().zip(&end) {
            let exact = double(exact);
            let off = (*found - exact).to_f64().abs() / size;
            assert!(off <= 1e-32 * parting(law.name), "{}: {off:e}", law.name);
        }
    }
}
