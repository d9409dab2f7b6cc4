//! The integrator on motions whose ends are known without it.

use super::*;
use crate::numerics::{
    dop853,
    roots::root,
    series::{power, product, square},
};
use std::f64::consts::PI;

struct Kepler;

impl System<f64, 4, TERMS> for Kepler {
    type Work = [[f64; TERMS]; 2];
    fn begin(&self, _: &f64, _: &[f64; 4], _: &mut Self::Work) {}
    fn derivative(&self, k: usize, x: &[[f64; TERMS]; 4], work: &mut Self::Work) -> [f64; 4] {
        let [square_of_r, force] = work;
        square_of_r[k] = square(&x[0], k) + square(&x[1], k);
        force[k] = power(square_of_r, -1.5, force, k);
        [
            x[2][k],
            x[3][k],
            -product(&x[0], force, k),
            -product(&x[1], force, k),
        ]
    }
}

/// Pericentre of the orbit with semi-major axis 1, eccentricity 0.6: period 2π.
const PERICENTRE: [f64; 4] = [0.4, 0.0, 0.0, 2.0];

fn orbit(t: f64) -> [f64; 4] {
    let mut anomaly = t;
    for _ in 0..100 {
        anomaly -= (anomaly - 0.6 * libm::sin(anomaly) - t) / (1.0 - 0.6 * libm::cos(anomaly));
    }
    let (s, c) = libm::sincos(anomaly);
    let rate = 1.0 / (1.0 - 0.6 * c);
    [c - 0.6, 0.8 * s, -s * rate, 0.8 * c * rate]
}

fn distance(a: [f64; 4], b: [f64; 4]) -> f64 {
    (0..4).map(|i| (a[i] - b[i]).abs()).fold(0.0, f64::max)
}

#[test]
fn kepler_over_ten_periods() {
    let end = 20.0 * PI;
    for control in [Control::Each, Control::Largest] {
        let path = integrate(&Kepler, 0.0, PERICENTRE, end, control, 10_000).unwrap();
        // Rounding of the force near ten pericentres, half a unit in the last place a step, shifts the time by
        // some 3·10⁻¹³, and the velocity turns by 6.25 per unit of time.
        assert!(distance(path.end, PERICENTRE) < 2e-12, "{:?}", path.end);
        let dense = (0..2000)
            .map(|i| end * i as f64 / 2000.0)
            .map(|t| {
                distance(
                    path.at(t).unwrap(),
                    orbit(t - 2.0 * PI * libm::floor(t / (2.0 * PI))),
                )
            })
            .fold(0.0, f64::max);
        assert!(dense < 2e-12, "{dense:e}");
        // y falls through zero at the apocentres, rises at the pericentres.
        let mut crossings = Vec::new();
        for step in &path.steps {
            let y = |s| value(&step.series[1], &s);
            if y(0.0) * y(step.h) < 0.0 {
                crossings.push((step.t + root(y, 0.0, step.h).unwrap(), y(step.h) > 0.0));
            }
        }
        for (i, (t, rises)) in crossings.iter().enumerate().take(19) {
            let expected = PI * (i + 1) as f64;
            assert!((t - expected).abs() < 1e-10 * expected.max(5.0), "{i} {t}");
            assert_eq!(*rises, i % 2 == 1);
        }
    }
}

#[test]
fn backwards_is_back() {
    let there = integrate(&Kepler, 0.0, PERICENTRE, 5.0, Control::Each, 1000).unwrap();
    let back = integrate(&Kepler, 5.0, there.end, 0.0, Control::Each, 1000).unwrap();
    assert!(distance(back.end, PERICENTRE) < 1e-14);
    assert!(distance(back.at(2.0).unwrap(), orbit(2.0)) < 1e-14);
    assert!(matches!(back.at(5.1), Err(NumericsError::Outside { .. })));
    assert!(there.at(f64::NAN).is_err());
}

#[test]
fn the_foreign_integrator_agrees() {
    let pull = |_: f64, x: &[f64; 4]| {
        let r3 = libm::pow(x[0] * x[0] + x[1] * x[1], 1.5);
        [x[2], x[3], -x[0] / r3, -x[1] / r3]
    };
    let foreign = dop853::end(pull, 0.0, PERICENTRE, 7.0, 1e-14, 1e-14).unwrap();
    let path = integrate(&Kepler, 0.0, PERICENTRE, 7.0, Control::Each, 1000).unwrap();
    assert!(
        distance(path.end, foreign) < 1e-11,
        "{foreign:?} {:?}",
        path.end
    );
    assert!(distance(path.end, orbit(7.0)) < 1e-14);
}

/// x′ = −x and x′ = 2t: relative accuracy through many decades, and a series that ends.
struct Decay;

impl System<f64, 2, TERMS> for Decay {
    type Work = [f64; 1];
    fn begin(&self, t: &f64, _: &[f64; 2], work: &mut Self::Work) {
        *work = [*t];
    }
    fn derivative(&self, k: usize, x: &[[f64; TERMS]; 2], work: &mut Self::Work) -> [f64; 2] {
        let time = [2.0 * work[0], 2.0];
        [-x[0][k], time.get(k).copied().unwrap_or(0.0)]
    }
}

#[test]
fn small_components_keep_their_digits() {
    let path = integrate(&Decay, 0.0, [1.0, 0.0], 100.0, Control::Each, 1000).unwrap();
    assert!((path.end[0] / libm::exp(-100.0) - 1.0).abs() < 1e-13);
    assert!((path.end[1] - 1e4).abs() < 1e-11);
}

/// x′ = x², infinite at t = 1/x(0).
struct BlowUp;

impl System<f64, 1, TERMS> for BlowUp {
    type Work = ();
    fn begin(&self, _: &f64, _: &[f64; 1], (): &mut ()) {}
    fn derivative(&self, k: usize, x: &[[f64; TERMS]; 1], (): &mut ()) -> [f64; 1] {
        [square(&x[0], k)]
    }
}

#[test]
fn no_hang_and_no_nan() {
    let run = |to| integrate(&BlowUp, 0.0, [1.0], to, Control::Each, 500);
    assert!((run(0.999).unwrap().end[0] - 1000.0).abs() < 1e-9);
    assert!(matches!(
        run(2.0),
        Err(NumericsError::Limit { .. } | NumericsError::NotFinite { .. })
    ));
    assert!(matches!(
        run(f64::NAN),
        Err(NumericsError::Argument { name: "to", .. })
    ));
    let bad = integrate(&BlowUp, 0.0, [f64::NAN], 1.0, Control::Each, 500);
    assert!(matches!(bad, Err(NumericsError::NotFinite { .. })));
    let nowhere = integrate(&BlowUp, 1.0, [f64::INFINITY], 1.0, Control::Each, 500);
    assert!(matches!(
        nowhere,
        Err(NumericsError::NotFinite { at: 1.0, .. })
    ));
}

#[test]
fn a_series_may_be_longer_than_the_table_of_inverses() {
    // (1/2)ᵏ, whose terms pass the tolerance 2⁻⁶⁰ over a length that its last ones give.
    let x: Vec<f64> = (0..100).map(|k| libm::pow(0.5, f64::from(k))).collect();
    let h = reach(&x);
    assert!((1.0..2.0).contains(&h), "{h}");
    for n in 1..100 {
        let third = Number::over(&0.3, n);
        assert!((third * n as f64 - 0.3).abs() < 1e-16, "{n}: {third}");
    }
}

#[test]
fn a_series_with_gaps_or_a_late_beginning_is_not_trusted_for_ever() {
    // Of terms of equal size, between t⁷ and t²⁸, and between t⁶ and t²⁸: trusted to 2^(−60/21) and 2^(−60/22).
    let gaps: Vec<f64> = (0..30)
        .map(|k| if k > 0 && k % 7 == 0 { 1.0 } else { 0.0 })
        .collect();
    let late: Vec<f64> = (0..30).map(|k| if k < 6 { 0.0 } else { 1.0 }).collect();
    for (series, length) in [(gaps, 21.0), (late, 22.0)] {
        let expected = libm::exp2(-60.0 / length);
        let found = reach(&series);
        assert!((found / expected - 1.0).abs() < 0.01, "{found} {expected}");
    }
    // A polynomial is.
    let mut ends = [0.0; 30];
    ends[9] = 1.0;
    assert_eq!(reach(&ends), f64::INFINITY);
}
