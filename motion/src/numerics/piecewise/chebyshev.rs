//! Interpolation of one smooth part at Chebyshev's points, turned into powers from its left end.

use crate::numerics::series::value;
use std::f64::consts::PI;
use std::sync::LazyLock;

pub(super) const POINTS: usize = 16;
/// As a share of the largest value.
const NOISE: f64 = 3e-16;
/// Of the last two coefficients, as a share of the largest value.
const RESOLVED: f64 = 1e-15;
/// As shares of the part, between the interpolation points.
const CHECKS: [f64; 4] = [0.004, 0.171, 0.463, 0.921];

/// cos(πn/2N) for a full turn, N the number of points.
static COSINES: LazyLock<[f64; 4 * POINTS]> =
    LazyLock::new(|| std::array::from_fn(|n| libm::cos(PI * n as f64 / (2 * POINTS) as f64)));

#[derive(Debug, Clone)]
pub struct Fit {
    pub start: f64,
    pub end: f64,
    /// Of the powers of the distance from the left end.
    pub coefficients: Vec<f64>,
    /// Some roundings of the largest value, and of the argument where the function is steep.
    pub tolerance: f64,
    /// At twenty points it misses no more.
    pub resolved: bool,
}

/// Interpolates on [a, b] a function whose largest value is about `size` and whose arguments are known to `blur`. The points
/// are inside, so that a jump at an end does no harm.
///
/// # Errors
/// The function's.
pub fn interpolate<E>(
    function: &impl Fn(f64) -> Result<f64, E>,
    [a, b]: [f64; 2],
    size: f64,
    blur: f64,
) -> Result<Fit, E> {
    let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
    let cosines = &*COSINES;
    let node = |j: usize| cosines[2 * j + 1];
    let mut values = [0.0; POINTS];
    for (j, value) in values.iter_mut().enumerate() {
        *value = function((middle + half * node(j)).clamp(a, b))?;
    }
    let flat = values.iter().all(|v| *v == values[0]);
    let mut series = [0.0; POINTS];
    if flat {
        series[0] = values[0];
    } else {
        for (k, coefficient) in series.iter_mut().enumerate() {
            let sum: f64 = (0..POINTS)
                .map(|j| values[j] * cosines[k * (2 * j + 1) % cosines.len()])
                .sum();
            *coefficient = sum * if k == 0 { 1.0 } else { 2.0 } / POINTS as f64;
        }
    }
    let steepest = (1..POINTS)
        .map(|j| {
            let width = half * (node(j - 1) - node(j));
            (values[j] - values[j - 1]).abs() / width
        })
        .fold(0.0, f64::max);
    let blur = blur * steepest;
    let tail = series[POINTS - 2].abs().max(series[POINTS - 1].abs());
    let used = 1 + series
        .iter()
        .rposition(|c| c.abs() > NOISE * size + 0.5 * blur)
        .unwrap_or(0);
    let coefficients = powers(&series[..used], b - a);
    let tolerance = 4.0 * (RESOLVED * size + blur);
    let mut resolved = tail <= RESOLVED * size + blur;
    for check in CHECKS {
        let s = (b - a) * check;
        resolved &= (function(a + s)? - value(&coefficients, &s)).abs() <= tolerance;
    }
    Ok(Fit {
        start: a,
        end: b,
        coefficients,
        tolerance,
        resolved,
    })
}

/// Σ aₖ Tₖ(2s/length − 1) as a polynomial in s.
fn powers(series: &[f64], length: f64) -> Vec<f64> {
    // T₀ = 1, T₁ = 2t − 1, T₍ₖ₊₁₎ = 2 (2t − 1) Tₖ − T₍ₖ₋₁₎ in t = s/length.
    let n = series.len();
    let mut sum = vec![0.0; n];
    let mut previous = vec![0.0; n];
    let mut current = vec![0.0; n];
    current[0] = 1.0;
    for (k, a) in series.iter().enumerate() {
        for (total, c) in sum.iter_mut().zip(&current) {
            *total += a * c;
        }
        let factor = if k == 0 { 1.0 } else { 2.0 };
        let mut next = vec![0.0; n];
        for i in 0..n {
            let shifted = if i > 0 { 2.0 * current[i - 1] } else { 0.0 };
            next[i] = factor * (shifted - current[i]) - if k == 0 { 0.0 } else { previous[i] };
        }
        previous = std::mem::replace(&mut current, next);
    }
    let mut power = 1.0;
    for c in &mut sum {
        *c /= power;
        power *= length;
    }
    sum
}
