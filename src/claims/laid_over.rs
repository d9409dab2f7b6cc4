//! What the paper predicts where the motion does something else, to be laid over the pictures of the motion.

use crate::paper::{anisotropic, escape, rest, turntable};

/// The curve of an explorer, by its name: of `turntable`, `rest` and `record` (ρ, p) on the envelope (147); of `escape`
/// (log₁₀ τ, ρ/τ²) by (136); of `anisotropic` (q, λ₀) on curve C, beyond Y too. None for the others.
pub fn printed(name: &str) -> Vec<[f64; 2]> {
    match name {
        "record" | "turntable" | "rest" => steps(0.0, 1.3, 130)
            .map(|alpha| {
                let a = rest::eq147_a(alpha);
                let place = [turntable::eq112_rho(a, alpha), turntable::eq111_p(a, alpha)];
                // As far as a picture shows it.
                place.map(|x: f64| (x * 1e5).round() / 1e5)
            })
            .collect(),
        "escape" => [0.5, 4.0].map(|x| [x, escape::eq136_rho(1.0)]).into(),
        "anisotropic" => steps(1.0, 12.0, 110)
            .map(|q| [q, anisotropic::eq55_lambda0(q)])
            .collect(),
        _ => Vec::new(),
    }
}

/// `n + 1` numbers at equal distances.
fn steps(from: f64, to: f64, n: u32) -> impl Iterator<Item = f64> {
    (0..=n).map(move |i| from + (to - from) * f64::from(i) / f64::from(n))
}
