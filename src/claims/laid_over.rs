//! What the paper predicts where the motion does something else, to be laid over the pictures of the motion.

use crate::corrections::escape as late;
use crate::paper::{anisotropic, escape, rest, turntable};

/// The curve of an explorer, by its name: of `turntable`, `rest` and `record` (ρ, p) on the envelope (147); of `anisotropic`
/// (q, λ₀) on curve C, beyond Y too. Of `escape` five, over as many values of log₁₀ τ each: ρ/τ² by (136), (π/2 − ψ) τ by (134),
/// A²/τ³ by (132), cosh α cosh 2α/A by (129), and τ times the rate of α that (128) gives where A and α are by then. None for the others.
pub(crate) fn printed(name: &str) -> Vec<[f64; 2]> {
    match name {
        "record" | "turntable" | "rest" => steps(0.0, 1.3, 130)
            .map(|alpha| {
                let a = rest::eq147_a(alpha);
                let place = [turntable::eq112_rho(a, alpha), turntable::eq111_p(a, alpha)];
                place.map(shown)
            })
            .collect(),
        "escape" => {
            let lines: [fn(f64) -> f64; 5] = [
                |tau| escape::eq136_rho(tau) / (tau * tau),
                |tau| escape::eq134_lag(tau) * tau,
                |tau| escape::eq132_a(tau).powi(2) / tau.powi(3),
                |_| 1.0,
                |tau| tau * escape::eq128_alpha_rate(late::alpha(tau), late::a(tau)),
            ];
            let along = |line: fn(f64) -> f64| {
                steps(0.5, 4.0, 35).map(move |x| [x, shown(line(10f64.powf(x)))])
            };
            lines.into_iter().flat_map(along).collect()
        }
        "anisotropic" => steps(1.0, 12.0, 110)
            .map(|q| [q, anisotropic::eq55_lambda0(q)])
            .collect(),
        _ => Vec::new(),
    }
}

/// As far as a picture shows it, and the four digits beside it.
fn shown(x: f64) -> f64 {
    (x * 1e7).round() / 1e7
}

/// `n + 1` numbers at equal distances.
fn steps(from: f64, to: f64, n: u32) -> impl Iterator<Item = f64> {
    (0..=n).map(move |i| from + (to - from) * f64::from(i) / f64::from(n))
}
