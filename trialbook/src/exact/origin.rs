//! How the elements of a proof came about: what is equal as it stands proves nothing.

use super::constant_folding::folded;
use super::expr::{Expr, Node};
use super::rational::{Made, Rational};
use super::ring::{Ring, Rule};
use std::collections::BTreeSet;

/// With whole numbers for the symbols that stand for such, and without idle parts.
fn named(formula: Expr, ring: &Ring) -> Expr {
    folded(formula, &|name| {
        let value = ring.named(name).ok()?.as_integer()?;
        i64::try_from(value).ok()
    })
}

/// Both were given so, or read from one formula.
pub(super) fn is_plain(x: &Rational, y: &Rational, difference: &Rational, ring: &Ring) -> bool {
    // The formula, if it was read from more than a name or a number.
    let of = |x: &Rational| match x.made() {
        Made::Given => Some(None),
        Made::Read(formula) => {
            let formula = named(Expr::numbered(formula)?, ring);
            let leaf = matches!(formula.node(), Node::Pi | Node::Symbol(_)) || is_number(formula);
            Some((!leaf).then_some(formula))
        }
        Made::Formed => None,
    };
    match (of(x), of(y)) {
        (Some(None), Some(None)) => difference.is_literally_zero(),
        (Some(x), Some(y)) => x == y,
        _ => false,
    }
}

fn is_number(formula: Expr) -> bool {
    match formula.node() {
        Node::Int(_) => true,
        Node::Neg(x) => is_number(x),
        Node::Binary(_, x, y) => is_number(x) && is_number(y),
        _ => false,
    }
}

pub(super) fn below(rule: &Rule) -> BTreeSet<usize> {
    match rule {
        Rule::Constant | Rule::Free => BTreeSet::new(),
        Rule::HalfTangent { angle: of } | Rule::HalfExponential { argument: of } => [*of].into(),
        Rule::Power { base, exponent } => base.generators().chain(exponent.generators()).collect(),
        Rule::Root { radicand, .. } => radicand.generators().collect(),
        Rule::Logarithm { of } => of.generators().collect(),
    }
}

pub(super) fn made_of(ring: &Ring, mut these: BTreeSet<usize>) -> BTreeSet<usize> {
    for g in (0..ring.rules.len()).rev() {
        if these.contains(&g) {
            these.extend(below(&ring.rules[g]));
        }
    }
    these
}
