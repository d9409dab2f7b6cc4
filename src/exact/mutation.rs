//! Every formula that differs from a given one in a single place: what a proof must not prove.

use super::expr::{Binary, Expr, Node};
use crate::scalar::Scalar;
use std::collections::BTreeSet;

/// A formula with one place changed.
#[derive(Debug, Clone)]
pub struct Mutation {
    /// What was changed into what.
    pub change: String,
    /// The changed formula.
    pub formula: Expr,
}

/// All single mutations of a formula, at every place of its tree:
///
/// - a whole number one more and one less; the whole formula twice;
/// - the sign of each term and of each negated factor;
/// - a sum for a difference, a product for a quotient, and the reverse; a square for its root;
/// - an exponent one more, or with the other sign;
/// - sin for cos, tan for cot, sinh for cosh, tanh for coth, arcsin for arccos, and the reverse; a square
///   root left out;
/// - a symbol for each other symbol of the formula.
///
/// None is equal to the formula as a tree; some may be equal in value.
pub fn mutations(formula: Expr) -> Vec<Mutation> {
    let mut found = Vec::new();
    let mut seen = BTreeSet::from([formula.to_string()]);
    let mut add = |from: Expr, to: Expr, whole: Expr| {
        if seen.insert(whole.to_string()) {
            let change = format!("{to} for {from}");
            found.push(Mutation {
                change,
                formula: whole,
            });
        }
    };
    add(formula, -formula, -formula);
    let twice = Expr::int(2) * formula;
    add(formula, twice, twice);
    at_every_place(formula, &formula.symbols(), &|whole| whole, &mut add);
    found
}

fn at_every_place(
    here: Expr,
    symbols: &BTreeSet<&'static str>,
    rebuild: &dyn Fn(Expr) -> Expr,
    add: &mut dyn FnMut(Expr, Expr, Expr),
) {
    for other in changes(here, symbols) {
        add(here, other, rebuild(other));
    }
    match here.node() {
        Node::Int(_) | Node::Pi | Node::Symbol(_) => {}
        Node::Neg(x) => at_every_place(x, symbols, &|x| rebuild(-x), add),
        Node::Call(f, x) => {
            at_every_place(x, symbols, &|x| rebuild(Expr::new(Node::Call(f, x))), add);
        }
        Node::Binary(op, x, y) => {
            let join = |x, y| rebuild(Expr::new(Node::Binary(op, x, y)));
            at_every_place(x, symbols, &|x| join(x, y), add);
            at_every_place(y, symbols, &|y| join(x, y), add);
        }
    }
}

/// What may stand at a place instead.
fn changes(here: Expr, symbols: &BTreeSet<&'static str>) -> Vec<Expr> {
    let one = Expr::int(1);
    match here.node() {
        Node::Int(n) => vec![
            Expr::int(n.saturating_add(1)),
            Expr::int(n.saturating_sub(1)),
        ],
        Node::Pi => vec![one, -here],
        Node::Symbol(name) => {
            let others = symbols.iter().filter(|other| **other != name);
            others.map(|other| Expr::symbol(other)).collect()
        }
        Node::Neg(x) => vec![x],
        Node::Call(f, x) => match f.sibling() {
            Some(sibling) => vec![Expr::new(Node::Call(sibling, x))],
            None => vec![x],
        },
        Node::Binary(op, x, y) => match op {
            Binary::Add => vec![x - y, -x + y],
            Binary::Sub => vec![x + y, -x - y],
            Binary::Mul if x == y => vec![x, x * y * x],
            Binary::Mul => vec![x / y],
            Binary::Div => vec![x * y],
            Binary::Pow => vec![x.pow(-y), x.pow(y + one), x],
        },
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_place_of_a_small_formula_is_changed() {
        let [a, b] = ["a", "b"].map(Expr::symbol);
        let texts: Vec<_> = mutations(a.sin() - Expr::int(3) * b)
            .into_iter()
            .map(|m| m.formula.to_string())
            .collect();
        for expected in [
            "−(sin(a) − 3 b)",
            "2 (sin(a) − 3 b)",
            "sin(a) + 3 b",
            "−sin(a) − 3 b",
            "cos(a) − 3 b",
            "sin(b) − 3 b",
            "sin(a) − 3/b",
            "sin(a) − 4 b",
            "sin(a) − 2 b",
            "sin(a) − 3 a",
        ] {
            assert!(
                texts.iter().any(|t| t == expected),
                "{expected} is missing: {texts:?}"
            );
        }
        assert_eq!(texts.len(), 10);
    }

    #[test]
    fn signs_and_squares_are_changed_within() {
        let a = Expr::symbol("a");
        let all = |formula: Expr| -> Vec<[String; 2]> {
            let found = mutations(formula).into_iter();
            found.map(|m| [m.change, m.formula.to_string()]).collect()
        };
        let expected = [
            ["−(−sin(a)) for −sin(a)", "−(−sin(a))"],
            ["2 (−sin(a)) for −sin(a)", "2 (−sin(a))"],
            ["sin(a) for −sin(a)", "sin(a)"],
            ["cos(a) for sin(a)", "−cos(a)"],
        ];
        assert_eq!(all(-a.sin()), expected);
        let square = all(a * a);
        let has = |text: &str| square.iter().any(|[_, formula]| formula == text);
        assert!(has("a") && has("a^2 a") && !has("a/a"), "{square:?}");
    }
}
