//! What a correction prints and the code has in parts.

use slipbook::corrections::{constant, escape};
use slipbook::exact::Expr;
use slipbook::scalar::Scalar;
use slipbook::seeded::Formula;

/// The time, whose code takes the logarithm of r.
fn time(x: &[Expr]) -> Vec<Expr> {
    vec![constant::time(x[0], x[1], x[2], x[3], x[4].ln())]
}

/// A law ∝ τ^(n/d) in the time τ − delay ln τ instead of τ, to first order in the delay.
fn late(law: fn(Expr) -> Expr, [n, d]: [i64; 2], tau: Expr) -> Vec<Expr> {
    let power = Expr::int(n) / Expr::int(d);
    let late = power * escape::delay::<Expr>() * tau.ln() / tau;
    vec![law(tau) * (Expr::int(1) - late)]
}

fn late_a(x: &[Expr]) -> Vec<Expr> {
    late(escape::a, [3, 2], x[0])
}

fn late_lag(x: &[Expr]) -> Vec<Expr> {
    late(escape::lag, [-1, 1], x[0])
}

fn late_rho(x: &[Expr]) -> Vec<Expr> {
    late(escape::rho, [2, 1], x[0])
}

fn late_s(x: &[Expr]) -> Vec<Expr> {
    late(escape::s, [3, 1], x[0])
}

pub fn joined() -> Vec<Formula<Expr>> {
    let formula = |path, arguments, symbols: &[&'static str], value| Formula {
        path,
        name: path,
        tried_in: None,
        arguments,
        lengths: vec![1; arguments.len()],
        symbols: symbols.to_vec(),
        value,
    };
    let late = |path, value| formula(path, &["tau"], &["τ"], value);
    vec![
        formula(
            "slipbook::corrections::constant::time_of_ln_r",
            &["lambda", "a", "v0", "theta0", "r"],
            &["λ", "A", "v₀", "θ₀", "r"],
            time,
        ),
        late("slipbook::corrections::escape::late_a", late_a),
        late("slipbook::corrections::escape::late_lag", late_lag),
        late("slipbook::corrections::escape::late_rho", late_rho),
        late("slipbook::corrections::escape::late_s", late_s),
    ]
}
