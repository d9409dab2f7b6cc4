use super::*;
use crate::scalar::Scalar;
use std::f64::consts::PI;

#[test]
fn a_sine_needs_few_pieces_and_is_exact() {
    let sine = Piecewise::fit(<f64 as Scalar>::sin, &[]).unwrap();
    assert!(sine.pieces().len() <= 8, "{}", sine.pieces().len());
    assert!(sine.integral().abs() < 1e-15);
    for k in 0..1000 {
        let x = -7.0 + 0.02 * k as f64;
        assert!((sine.value(x) - Scalar::sin(x)).abs() < 2e-15);
        assert!((sine.antiderivative(x) - (1.0 - Scalar::cos(x))).abs() < 2e-15);
    }
}

#[test]
fn pieces_are_monotone_and_join() {
    let f =
        |x: f64| Scalar::sin(x) + 0.7 * Scalar::sin(5.0 * x + 0.3) - 0.2 * Scalar::cos(11.0 * x);
    let fit = Piecewise::fit(f, &[]).unwrap();
    let mut end = 0.0;
    for piece in fit.pieces() {
        assert!((piece.start() - end).abs() < 1e-15);
        end = piece.start() + piece.length();
        let up = (piece.right() - piece.left()).signum();
        let mut last = piece.left();
        for k in 1..=50 {
            let value = piece.value(piece.length() * k as f64 / 50.0);
            assert!(up * (value - last) > -1e-15);
            last = value;
        }
    }
    assert!((end - TAU).abs() < 1e-15);
}

#[test]
fn short_integrals_keep_their_relative_accuracy() {
    // 1e-12/6 − 1e-20/120. A difference of antiderivatives would be wrong by about 1e-16.
    let fit = Piecewise::fit(|x| 1.0 - Scalar::cos(x), &[]).unwrap();
    let s = 1e-4;
    let integral = s * fit.pieces()[0].secant(0.0).mean(s);
    let series = s.powi(3) / 6.0 - s.powi(5) / 120.0;
    assert!(
        (integral - series).abs() < 1e-15 * s,
        "{integral:e} {series:e}"
    );
}

#[test]
fn level_crossings_are_those_of_the_inverse_sine() {
    let sine = Piecewise::fit(<f64 as Scalar>::sin, &[]).unwrap();
    let first = sine
        .pieces()
        .iter()
        .find(|p| p.left() < 0.4 && p.right() > 0.4)
        .unwrap();
    let found = first.start() + first.crossing(0.4, 0.0, first.length());
    assert!((found - 0.4.asin()).abs() < 1e-15);
    assert_eq!(first.crossing(7.0, 0.0, first.length()), first.length());
}

#[test]
fn jumps_are_kept_sharp() {
    let h = |x: f64| {
        if x < 1.0 {
            2.0
        } else if x < 4.0 {
            x
        } else {
            -1.0
        }
    };
    let fit = Piecewise::fit(h, &[4.0, 1.0 + TAU]).unwrap();
    assert_eq!(fit.pieces().len(), 3);
    assert_eq!(fit.value(1.0), 1.0);
    assert_eq!(fit.value(4.0), -1.0);
    assert!((fit.integral() - (2.0 + 7.5 - (TAU - 4.0))).abs() < 4e-15);
}

/// Smooth or with listed jumps, on what is flat or not, wherever it lies.
#[test]
fn a_short_pulse_is_seen() {
    let width = TAU / 1000.0;
    for i in 0..200 {
        let middle = 0.1 + 0.03 * f64::from(i);
        let pulse = |x: f64| libm::exp(-libm::pow(5.0 * (x - middle) / width, 2.0));
        let area = width / 5.0 * libm::sqrt(PI);
        for slope in [0.0, 0.3] {
            let fit = Piecewise::fit(|x| pulse(x) + slope * Scalar::sin(x), &[]).unwrap();
            assert!((fit.integral() - area).abs() < 1e-12, "{middle} {slope}");
        }
    }
    let jumps = |x: f64| f64::from(u8::from((2.0..2.0 + width).contains(&x)));
    assert!(Piecewise::fit(jumps, &[]).is_err());
    let listed = Piecewise::fit(jumps, &[2.0, 2.0 + width]).unwrap();
    assert!((listed.integral() - width).abs() < 1e-14);
}

#[test]
fn bad_functions_are_named() {
    let unlisted = Piecewise::fit(|x| if x < 1.0 { 0.0 } else { 1.0 }, &[]);
    assert!(matches!(unlisted, Err(PiecewiseError::Unresolved { at }) if (at - 1.0).abs() < 1e-9));
    let pole = Piecewise::fit(|x| 1.0 / (x - PI), &[]);
    assert!(pole.is_err());
    let nan = Piecewise::fit(|_| f64::NAN, &[]);
    assert!(matches!(nan, Err(PiecewiseError::NotFinite { .. })));
    let infinite = Piecewise::fit(|x| if x == 0.0 { f64::INFINITY } else { 1.0 }, &[]);
    assert!(matches!(infinite, Err(PiecewiseError::NotFinite { at, .. }) if at == 0.0));
    assert!(matches!(
        Piecewise::fit(|_| 1.0, &[f64::NAN]),
        Err(PiecewiseError::Break { .. })
    ));
}
