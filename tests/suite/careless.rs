//! The public functions that take numbers or text, with any. Each has to answer with an error or with finite numbers, after
//! bounded work; none may panic.
//!
//! `PROPTEST_CASES` sets how often each is asked.

mod calculators;
mod drive;
mod formulas;
mod numerics;
mod particle;
mod scene;
mod sphere;
mod text;
mod turntable;

use proptest::prelude::*;
use std::f64::consts::PI;

fn config() -> ProptestConfig {
    let set = std::env::var_os("PROPTEST_CASES").is_some();
    let asked = ProptestConfig::default();
    ProptestConfig {
        cases: if set { asked.cases } else { 64 },
        // Most is out of range for a start.
        max_local_rejects: u32::MAX,
        failure_persistence: None,
        ..asked
    }
}

/// Any bit pattern, or a number of ordinary size, or one at an edge.
fn any() -> impl Strategy<Value = f64> {
    let edges = vec![
        0.0,
        -0.0,
        1.0,
        -1.0,
        PI,
        5e-324,
        1e-20,
        1e20,
        f64::MAX,
        f64::INFINITY,
        f64::NAN,
    ];
    prop_oneof![
        2 => prop::num::f64::ANY,
        8 => -4.0..4.0,
        2 => prop::sample::select(edges),
        2 => (-20.0..20.0).prop_map(libm::exp10),
    ]
}

/// Up to so many of [`any`].
fn some(most: usize) -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(any(), 0..=most)
}

/// Each is [`any`], or all but one are of ordinary size, so that one alone is at fault.
fn each<const N: usize>() -> impl Strategy<Value = [f64; N]> {
    let one = (prop::collection::vec(-4.0..4.0, N), 0..N, any());
    let mostly = one.prop_map(|(mut list, at, odd)| {
        list[at] = odd;
        list
    });
    prop_oneof![prop::collection::vec(any(), N), mostly]
        .prop_map(|list| std::array::from_fn(|i| list[i]))
}

/// [`each`], or zeros, which do not come about by chance.
fn or_zeros<const N: usize>() -> impl Strategy<Value = [f64; N]> {
    prop_oneof![2 => each(), 1 => Just([0.0; N])]
}

fn on_the_way(low: f64, high: f64, part: f64) -> f64 {
    (low + part * (high - low)).clamp(low, high)
}

fn finite(numbers: &[f64]) -> bool {
    numbers.iter().all(|x| x.is_finite())
}

/// With two parameters: smooth, with poles, kinks, jumps and no value at all.
const SHAPES: [fn(f64, f64, f64) -> f64; 8] = [
    |a, b, x| a * x + b,
    |a, b, x| a * x * x * x - b,
    |a, b, x| a / (x - b),
    |a, b, x| a * libm::exp(b * x),
    |a, b, x| a * libm::sin(b * x),
    |a, b, x| a * libm::sqrt(x - b),
    |a, b, x| if x < b { a } else { -1.0 },
    |a, b, x| a * (x - b).abs(),
];
