//! Formulas without idle parts: no zero added, no factor one, no sign inside a number.

use super::expr::{Binary, Expr, Function, Node};

/// The formula with whole numbers for the symbols that `value` knows, without what changes nothing.
pub fn folded(formula: Expr, value: &dyn Fn(&str) -> Option<i64>) -> Expr {
    let of = |x: Expr| folded(x, value);
    match formula.node() {
        Node::Int(_) | Node::Pi => formula,
        Node::Symbol(name) => value(name).map_or(formula, int),
        Node::Neg(x) => negative(of(x)),
        Node::Binary(op, x, y) => joined(op, of(x), of(y)),
        Node::Call(function, x) => called(function, of(x)),
    }
}

fn int(n: i64) -> Expr {
    Expr::new(Node::Int(n))
}

fn number(x: Expr) -> Option<i64> {
    match x.node() {
        Node::Int(n) => Some(n),
        _ => None,
    }
}

fn negative(x: Expr) -> Expr {
    match x.node() {
        Node::Int(n) => n.checked_neg().map_or_else(|| Expr::new(Node::Neg(x)), int),
        Node::Neg(x) => x,
        _ => Expr::new(Node::Neg(x)),
    }
}

fn joined(op: Binary, x: Expr, y: Expr) -> Expr {
    let as_it_is = || Expr::new(Node::Binary(op, x, y));
    let whole = |n: Option<i64>| n.map_or_else(as_it_is, int);
    match (op, number(x), number(y)) {
        (Binary::Add, Some(n), Some(m)) => whole(n.checked_add(m)),
        (Binary::Sub, Some(n), Some(m)) => whole(n.checked_sub(m)),
        (Binary::Mul, Some(n), Some(m)) => whole(n.checked_mul(m)),
        (Binary::Div, Some(n), Some(m)) if n.checked_rem(m) == Some(0) => whole(n.checked_div(m)),
        (Binary::Add, Some(0), _) | (Binary::Mul, Some(1), _) => y,
        (Binary::Add | Binary::Sub, _, Some(0))
        | (Binary::Mul | Binary::Div | Binary::Pow, _, Some(1)) => x,
        (Binary::Mul, Some(0), _) | (Binary::Mul, _, Some(0)) | (Binary::Div, Some(0), _) => int(0),
        (Binary::Sub, Some(0), _) | (Binary::Mul, Some(-1), _) => negative(y),
        (Binary::Mul | Binary::Div, _, Some(-1)) => negative(x),
        (Binary::Pow, _, Some(0)) | (Binary::Pow, Some(1), _) => int(1),
        // The sign of a number stands outside.
        (Binary::Mul | Binary::Div, Some(n), _) if n < 0 => negative(joined(op, negative(x), y)),
        (Binary::Mul | Binary::Div, _, Some(n)) if n < 0 => negative(joined(op, x, negative(y))),
        (Binary::Add, Some(n), _) if n < 0 => joined(Binary::Sub, y, negative(x)),
        (Binary::Add, _, Some(n)) if n < 0 => joined(Binary::Sub, x, negative(y)),
        (Binary::Sub, _, Some(n)) if n < 0 => joined(Binary::Add, x, negative(y)),
        (Binary::Sub, Some(n), _) if n < 0 => negative(joined(Binary::Add, negative(x), y)),
        _ => as_it_is(),
    }
}

fn called(function: Function, x: Expr) -> Expr {
    use Function::{Asin, Cos, Cosh, Exp, Ln, Sin, Sinh, Sqrt, Tan, Tanh};
    match (function, number(x)) {
        (Sin | Tan | Asin | Sinh | Tanh | Sqrt, Some(0)) | (Ln, Some(1)) => int(0),
        (Cos | Cosh | Exp, Some(0)) | (Sqrt, Some(1)) => int(1),
        _ => Expr::new(Node::Call(function, x)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::Scalar;

    #[test]
    fn what_changes_nothing_is_left_out_and_nothing_else() {
        let [a, x, y] = ["a", "x", "y"].map(Expr::symbol);
        let value = |name: &str| (name == "a").then_some(0);
        for (formula, expected) in [
            (x + a * y, x),
            (x - a, x),
            (a - x, -x),
            (-(a - x), x),
            (x * a.cos(), x),
            (y / (a - int(1)), -y),
            ((x + a).sin() + a.sin(), x.sin()),
            (x.pow(a + int(1)), x),
            (x.pow(a), int(1)),
            (int(3) * int(4) - a, int(12)),
            (int(i64::MAX) + int(1), int(i64::MAX) + int(1)),
            (x * y - y, x * y - y),
            (x + int(-2), x - int(2)),
            (int(-2) + x, x - int(2)),
            (x - int(-2), x + int(2)),
            (int(-2) - x, -(int(2) + x)),
            (int(-2) * x, -(int(2) * x)),
            (x / int(-2), -(x / int(2))),
            (int(-2) / int(-3), int(2) / int(3)),
            (x / a, x / int(0)),
            (x * (int(-4) / int(2)), -(x * int(2))),
        ] {
            assert_eq!(folded(formula, &value), expected, "{formula}");
        }
    }
}
