//! What the names of a printed formula mean: the arguments of the formula that it is held against.

use super::printed_part::Library;
use slipbook::exact::{
    Expr,
    latex::{LatexError, Lexicon, Statement, Value},
};
use slipbook::scalar::Scalar;
use slipbook::seeded::{Formula, symbol};
use slipbook::symbols::SYMBOLS;

/// Its arguments by the table of symbols, then names with a meaning of their own.
pub fn lexicon(
    library: &Library,
    formula: Option<&Formula<Expr>>,
    own: &[(&str, &str)],
    statements: &[Statement],
) -> Result<Lexicon, String> {
    let error = |e: LatexError| e.to_string();
    let mut lexicon = Lexicon::new();
    let arguments = formula.map(arguments).unwrap_or_default();
    for (name, meaning) in own {
        let argument = arguments.iter().find(|a| a.name == *meaning);
        let component = || {
            let mut letters = arguments.iter().flat_map(|a| &a.parts);
            letters.find(|letter| *letter == meaning)
        };
        let value = if let Some(number) = meaning.strip_prefix('@') {
            let statement = number.parse().ok().and_then(|n: usize| statements.get(n));
            let right = statement.and_then(|statement| statement.sides.get(1));
            let right =
                right.ok_or_else(|| format!("`{meaning}` is no statement with a right side"))?;
            let inner = self::lexicon(library, formula, &[], &[])?;
            right.read(&inner).map_err(error)?
        } else if let Some(argument) = argument {
            argument.value()
        } else if let Some(letter) = component() {
            Value::Number(Expr::symbol(letter))
        } else if let Ok(number) = meaning.parse() {
            Value::Number(Expr::int(number))
        } else {
            Value::Number(tree(library.find(meaning)?)[0])
        };
        lexicon.add(name, value).map_err(error)?;
    }
    for argument in &arguments {
        argument.name(&mut lexicon).map_err(error)?;
    }
    for argument in &arguments {
        argument.size(&mut lexicon).map_err(error)?;
    }
    Ok(lexicon)
}

pub fn tree(formula: &Formula<Expr>) -> Vec<Expr> {
    let letters: Vec<_> = formula
        .symbols
        .iter()
        .map(|letter| Expr::symbol(letter))
        .collect();
    (formula.value)(&letters)
}

struct Argument {
    name: &'static str,
    latex: &'static str,
    parts: Vec<&'static str>,
}

fn arguments(formula: &Formula<Expr>) -> Vec<Argument> {
    let module = formula
        .path
        .rsplit_once("::")
        .map_or("", |(module, _)| module);
    let mut letters = &formula.symbols[..];
    let mut found = Vec::new();
    for name in formula.arguments {
        let symbol = symbol(SYMBOLS, module, name).expect("a declared symbol");
        let common = symbol.parts.iter().zip(letters).take_while(|(a, b)| a == b);
        // Even if a pair of the same name begins with it.
        let count = match common.count() {
            0 | 1 => 1,
            count => count,
        };
        let (own, rest) = letters.split_at(count);
        letters = rest;
        found.push(Argument {
            name,
            latex: symbol.latex,
            parts: own.to_vec(),
        });
    }
    found
}

impl Argument {
    fn value(&self) -> Value {
        let part = |i: usize| {
            self.parts
                .get(i)
                .map_or(Expr::int(0), |letter| Expr::symbol(letter))
        };
        if self.parts.len() > 1 {
            Value::Vector([0, 1, 2].map(part))
        } else {
            Value::Number(part(0))
        }
    }

    fn unbold(&self) -> Option<String> {
        let bold = self.latex.strip_prefix(r"\bm")?;
        Some(bold.trim().to_owned())
    }

    fn name(&self, lexicon: &mut Lexicon) -> Result<(), LatexError> {
        if self.parts.len() > 1 && !self.latex.contains(r"\bm") {
            // No vector, but a quantity and its rate.
            let [quantity, rate] = [0, 1].map(|i| Value::Number(Expr::symbol(self.parts[i])));
            lexicon.add(self.latex, quantity)?;
            return lexicon.add(&format!(r"\dot{{{}}}", self.latex), rate);
        }
        let unbold = self.unbold().filter(|_| self.parts.len() == 1);
        lexicon.add(unbold.as_deref().unwrap_or(self.latex), self.value())?;
        if let Some(of) = self.latex.strip_prefix(r"\dot") {
            let slope = format!(
                r"\frac{{\mathrm d {}}}{{\mathrm d t}}",
                of.trim_matches(['{', '}'])
            );
            lexicon.add(&slope, self.value())?;
        }
        Ok(())
    }

    fn size(&self, lexicon: &mut Lexicon) -> Result<(), LatexError> {
        match self.unbold() {
            Some(name) if self.parts.len() > 1 => {
                lexicon.add(&name, Value::Number(self.value().size()))
            }
            _ => Ok(()),
        }
    }
}
