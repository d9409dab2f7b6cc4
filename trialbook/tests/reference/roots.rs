//! The root-finder with values against mpmath's roots (`roots.py`).

use crate::table::{number, rows};
use trialbook::numerics::roots::root;

fn function(name: &str, k: f64, x: f64) -> f64 {
    match name {
        "cos" => libm::cos(x) - x,
        "exp" => libm::exp(x) - k,
        "lambert" => x * libm::exp(x) - k,
        "ninth" => libm::pow(x, 9.0) - k,
        "log" => libm::log(x) + k,
        "tan" => x * libm::cos(x) - libm::sin(x),
        "kepler" => x - k * libm::sin(x) - 1.0 / 1024.0,
        "step" => libm::tanh(1000.0 * (x - k)),
        "pole" => 1.0 / (x - k),
        "far" => x * x * x - k * x - 1.0,
        "flat" => libm::pow(x - k, 5.0),
        other => panic!("no function {other}"),
    }
}

/// The terms that cancel there, over the root and the slope.
fn condition(name: &str, k: f64, x: f64) -> f64 {
    match name {
        "exp" | "lambert" => 1.0 / x.abs().min(1.0),
        "log" => k,
        "tan" => 2.0,
        // The slope 1 − k cos x, where x and k sin x cancel.
        "kepler" => 2.0 / (1.0 - k * libm::cos(x)),
        _ => 1.0,
    }
}

#[test]
fn roots_are_those_of_mpmath() {
    let mut count = 0;
    for [name, k, low, high, exact] in rows(include_str!("roots.csv")) {
        let [k, low, high, exact] = [k, low, high, exact].map(number);
        for (low, high) in [(low, high), (high, low)] {
            let found = root(|x| function(name, k, x), low, high).expect("a root in its bracket");
            // Two units in the last place are promised, and the root is rounded too.
            let room = (2.5 + 2.0 * condition(name, k, exact)) * f64::EPSILON * exact.abs();
            assert!(
                (found - exact).abs() <= room,
                "{name} {k}: {found:e}, but {exact:e}"
            );
        }
        count += 1;
    }
    assert_eq!(count, 16);
}
