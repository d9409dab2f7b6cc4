//! The formulas as definitions of Rocq, from their trees.

use crate::exact::{Binary, Expr, Function, Node};
use crate::seeded::Formula;
use crate::trials::formulas::Formulas;
use std::collections::BTreeMap;
use std::fmt::Write;

/// Functions that Rocq's library has not.
const HEAD: &str = "\
(* Every formula of the paper as printed, errors included (eqNN_...), and of what replaces or adds to them (right_...): written by
   `slipbook theorems --formulas` from the formulas that its trials evaluate, and held against them by its tests. *)
Require Import Reals.
Open Scope R_scope.
Definition cot x := cos x / sin x.
Definition coth x := cosh x / sinh x.
";

/// No argument may be called so.
const KEYWORDS: [&str; 14] = [
    "as", "at", "end", "exists", "fix", "for", "forall", "fun", "if", "in", "let", "match", "then",
    "with",
];

/// What stands in a place needs brackets if it binds less.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Level {
    Sum,
    Product,
    Opposite,
    Power,
    Atom,
}

/// Definitions for all formulas; those of the corrections, with `corrections` in their paths, begin with
/// `right`.
pub fn definitions(formulas: &[Formula<Expr>], corrections: &str) -> String {
    let mut file = HEAD.to_owned();
    for formula in formulas {
        let arguments = arguments(formula);
        let binders = match arguments.join(" ") {
            none if none.is_empty() => none,
            names => format!(" ({names} : R)"),
        };
        let own = |symbol: &'static str| {
            let at = formula.symbols.iter().position(|own| *own == symbol);
            at.map_or(symbol, |at| &arguments[at])
        };
        for (name, part) in parts(formula, corrections) {
            let mut body = String::new();
            written(part, Level::Sum, &own, &mut body);
            let _ = writeln!(file, "Definition {name}{binders} : R := {body}.");
        }
    }
    file
}

fn parts(formula: &Formula<Expr>, corrections: &str) -> Vec<(String, Expr)> {
    let symbols: Vec<_> = formula
        .symbols
        .iter()
        .map(|name| Expr::symbol(name))
        .collect();
    let parts = (formula.value)(&symbols);
    let name = name(formula, corrections);
    match parts.as_slice() {
        [whole] => vec![(name, *whole)],
        _ => (1..)
            .zip(parts)
            .map(|(i, part)| (format!("{name}_{i}"), part))
            .collect(),
    }
}

pub(super) fn tried(
    trees: &[Formula<Expr>],
    formulas: &Formulas,
) -> BTreeMap<String, (String, bool)> {
    let of_one = |formula: &Formula<Expr>| {
        let claim = formula.claim()?;
        let printed = formulas.is_printed(formula.path);
        let parts = parts(formula, formulas.corrections).into_iter();
        Some(
            parts
                .map(|(name, _)| (name, (claim.clone(), printed)))
                .collect::<Vec<_>>(),
        )
    };
    trees.iter().filter_map(of_one).flatten().collect()
}

/// `eq13_time`; `right_turntable_constant`.
fn name(formula: &Formula<Expr>, corrections: &str) -> String {
    match formula.path.split_once(corrections) {
        None => formula.name.to_owned(),
        Some((_, path)) => format!("right_{}", path.replace("::", "_")),
    }
}

fn arguments(formula: &Formula<Expr>) -> Vec<String> {
    let each = formula.arguments.iter().zip(&formula.lengths);
    let of_one = |(argument, length): (&&str, &usize)| {
        let keyword = if KEYWORDS.contains(argument) { "_" } else { "" };
        let of = |i| match length {
            1 => format!("{argument}{keyword}"),
            _ => format!("{argument}_{i}"),
        };
        (1..=*length).map(of).collect::<Vec<_>>()
    };
    each.flat_map(of_one).collect()
}

fn written<'a>(tree: Expr, place: Level, name: &dyn Fn(&'static str) -> &'a str, out: &mut String) {
    let own = match tree.node() {
        Node::Int(n) if n < 0 => Level::Opposite,
        Node::Int(_) | Node::Pi | Node::Symbol(_) => Level::Atom,
        Node::Neg(_) => Level::Opposite,
        Node::Binary(Binary::Add | Binary::Sub, ..) => Level::Sum,
        Node::Binary(Binary::Mul, x, y) if x == y => Level::Power,
        Node::Binary(Binary::Mul | Binary::Div, ..) => Level::Product,
        Node::Binary(Binary::Pow, ..) | Node::Call(..) => Level::Power,
    };
    let bracketed = own < place;
    if bracketed {
        out.push('(');
    }
    match tree.node() {
        Node::Int(n) if n < 0 => *out += &format!("- {}", n.unsigned_abs()),
        Node::Int(n) => *out += &n.to_string(),
        Node::Pi => *out += "PI",
        Node::Symbol(symbol) => *out += name(symbol),
        Node::Neg(x) => {
            *out += "- ";
            written(x, Level::Opposite, name, out);
        }
        Node::Binary(Binary::Pow, x, y) => match y.node() {
            Node::Int(n @ 0..) => {
                written(x, Level::Atom, name, out);
                *out += &format!(" ^ {n}");
            }
            _ => call("Rpower", &[x, y], name, out),
        },
        Node::Binary(Binary::Mul, x, y) if x == y => {
            written(x, Level::Atom, name, out);
            *out += " ^ 2";
        }
        Node::Binary(join, x, y) => {
            let (sign, next) = match join {
                Binary::Add => (" + ", Level::Product),
                Binary::Sub => (" - ", Level::Product),
                Binary::Mul => (" * ", Level::Power),
                _ => (" / ", Level::Power),
            };
            written(x, own, name, out);
            *out += sign;
            written(y, next, name, out);
        }
        Node::Call(function, x) => {
            let function = match function {
                Function::Asin => "asin",
                Function::Acos => "acos",
                Function::Sqrt => "sqrt",
                other => other.name(),
            };
            call(function, &[x], name, out);
        }
    }
    if bracketed {
        out.push(')');
    }
}

fn call<'a>(function: &str, of: &[Expr], name: &dyn Fn(&'static str) -> &'a str, out: &mut String) {
    *out += function;
    for x in of {
        out.push(' ');
        written(*x, Level::Atom, name, out);
    }
}
