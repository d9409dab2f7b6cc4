//! What a correction prints and the code has in parts.

use slipbook::corrections::{constant, escape};
use slipbook::exact::Expr;
use slipbook::scalar::Scalar;

/// The time, whose code takes the logarithm of r.
pub fn time(x: &[Expr]) -> Vec<Expr> {
    vec![constant::time(x[0], x[1], x[2], x[3], x[4].ln())]
}

/// A law ∝ τ^(n/d) in the time τ − delay ln τ instead of τ, to first order in the delay.
fn late(law: fn(Expr) -> Expr, [n, d]: [i64; 2], tau: Expr) -> Vec<Expr> {
    let power = Expr::int(n) / Expr::int(d);
    let late = power * escape::delay::<Expr>() * tau.ln() / tau;
    vec![law(tau) * (Expr::int(1) - late)]
}

pub fn late_a(x: &[Expr]) -> Vec<Expr> {
    late(escape::a, [3, 2], x[0])
}

pub fn late_lag(x: &[Expr]) -> Vec<Expr> {
    late(escape::lag, [-1, 1], x[0])
}

pub fn late_rho(x: &[Expr]) -> Vec<Expr> {
    late(escape::rho, [2, 1], x[0])
}

pub fn late_s(x: &[Expr]) -> Vec<Expr> {
    late(escape::s, [3, 1], x[0])
}
