//! From items to trees, by a lexicon.

use super::super::{Expr, Function, Node};
use super::list::{Item, Kind, items};
use super::{LatexError, Problem};
use crate::scalar::Scalar;

/// What a part of a formula means.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Value {
    /// A number.
    Number(Expr),
    /// A vector by its components along x, y and z.
    Vector([Expr; 3]),
}

impl Value {
    /// The tree of a number; `None` of a vector.
    pub fn number(self) -> Option<Expr> {
        match self {
            Value::Number(number) => Some(number),
            Value::Vector(_) => None,
        }
    }

    fn scaled(self, by: impl Fn(Expr) -> Expr) -> Self {
        match self {
            Value::Number(x) => Value::Number(by(x)),
            Value::Vector(x) => Value::Vector(x.map(by)),
        }
    }

    /// The size of a vector or number.
    pub fn size(self) -> Expr {
        match self {
            Value::Number(x) => x.squared().sqrt(),
            Value::Vector([x, y, z]) => (x.squared() + y.squared() + z.squared()).sqrt(),
        }
    }
}

/// What names mean. It begins with π and the unit vectors x̂, ŷ, ẑ.
#[derive(Debug, Clone)]
pub struct Lexicon {
    entries: Vec<(Vec<Item>, Value)>,
}

impl Default for Lexicon {
    fn default() -> Self {
        Self::new()
    }
}

impl Lexicon {
    /// π and the unit vectors.
    pub fn new() -> Self {
        let [zero, one] = [0, 1].map(Expr::int);
        let mut lexicon = Lexicon {
            entries: Vec::new(),
        };
        for (name, value) in [
            (r"\pi", Value::Number(Expr::pi())),
            (r"\hat{\bm x}", Value::Vector([one, zero, zero])),
            (r"\hat{\bm y}", Value::Vector([zero, one, zero])),
            (r"\hat{\bm z}", Value::Vector([zero, zero, one])),
        ] {
            // Names that are written here are understood.
            lexicon
                .entries
                .extend(items(name).map(|name| (name, value)));
        }
        lexicon
    }

    /// Gives a name a meaning, unless it has one. A name may be of several signs, such as `\frac{\mathrm d
    /// v}{\mathrm d t}` or `h(\phi)`; the longer one counts. One with operators counts only where it is the
    /// whole of a part.
    ///
    /// # Errors
    /// [`LatexError`] if the name is no LaTeX, or empty.
    pub fn add(&mut self, name: &str, value: Value) -> Result<(), LatexError> {
        let name = items(name)?;
        if name.is_empty() {
            return Err(Problem::Missing.at(0));
        }
        if !self.entries.iter().any(|(known, _)| *known == name) {
            self.entries.push((name, value));
        }
        Ok(())
    }

    /// `at` is where they should begin, if there are none.
    pub(super) fn read(&self, items: &[Item], at: usize) -> Result<Value, LatexError> {
        let whole = self.entries.iter().find(|(name, _)| *name == items);
        match whole {
            Some((_, value)) => Ok(*value),
            None => self.sum(items, at),
        }
    }

    fn number(&self, items: &[Item], at: usize) -> Result<Expr, LatexError> {
        let value = self.read(items, at)?;
        value.number().ok_or_else(|| Problem::Kind.at(at))
    }

    fn sum(&self, items: &[Item], at: usize) -> Result<Value, LatexError> {
        let mut sum: Option<Value> = None;
        let mut rest = items;
        let mut first = true;
        while !rest.is_empty() || first {
            let begin = rest.first().map_or(at, |item| item.at);
            let sign = rest.first().and_then(|item| match item.kind {
                Kind::Mark(sign @ ('+' | '-')) => Some(sign),
                _ => None,
            });
            rest = &rest[usize::from(sign.is_some())..];
            let sign_next = |item: &Item| matches!(item.kind, Kind::Mark('+' | '-'));
            let end = rest.iter().position(sign_next).unwrap_or(rest.len());
            let (term, after) = rest.split_at(end);
            rest = after;
            if !first && is_left_out(term) {
                continue;
            }
            first = false;
            let term = self.product(term, begin)?;
            sum = Some(match (sum, sign) {
                (None, Some('-')) => term.scaled(|x| -x),
                (None, _) => term,
                (Some(sum), Some('-')) => joined(sum, term, begin, |x, y| x - y)?,
                (Some(sum), _) => joined(sum, term, begin, |x, y| x + y)?,
            });
        }
        sum.ok_or_else(|| Problem::Missing.at(at))
    }

    /// Without a sign, with × or with /, joined by ·.
    fn product(&self, items: &[Item], at: usize) -> Result<Value, LatexError> {
        let mut product: Option<Value> = None;
        for run in items.split(|item| item.kind == Kind::Mark('·')) {
            let at = run.first().map_or(at, |item| item.at);
            let factor = self.run(run, at)?;
            product = Some(match (product, factor) {
                (None, factor) => factor,
                (Some(Value::Vector(a)), Value::Vector(b)) => {
                    Value::Number(a[0] * b[0] + a[1] * b[1] + a[2] * b[2])
                }
                (Some(product), factor) => multiplied(product, factor, at)?,
            });
        }
        product.ok_or_else(|| Problem::Missing.at(at))
    }

    fn run(&self, items: &[Item], at: usize) -> Result<Value, LatexError> {
        let mut rest = items;
        let mut product = self.operand(&mut rest, at)?;
        let mut divided = false;
        while let Some(next) = rest.first() {
            let at = next.at;
            match next.kind {
                Kind::Mark('/') => {
                    rest = &rest[1..];
                    let by = self.operand(&mut rest, at)?.number();
                    let by = by.ok_or_else(|| Problem::Kind.at(at))?;
                    product = product.scaled(|x| x / by);
                    divided = true;
                }
                Kind::Mark('×') => {
                    rest = &rest[1..];
                    let factor = self.operand(&mut rest, at)?;
                    product = match (product, factor) {
                        (Value::Vector(a), Value::Vector(b)) => Value::Vector([
                            a[1] * b[2] - a[2] * b[1],
                            a[2] * b[0] - a[0] * b[2],
                            a[0] * b[1] - a[1] * b[0],
                        ]),
                        _ => multiplied(product, factor, at)?,
                    };
                }
                // Does it belong to the divisor? Is it part of the number before it?
                _ if divided => return Err(Problem::Ambiguous.at(at)),
                Kind::Number(_) => return Err(Problem::Ambiguous.at(at)),
                _ => {
                    let factor = self.operand(&mut rest, at)?;
                    product = multiplied(product, factor, at)?;
                }
            }
        }
        Ok(product)
    }

    fn operand(&self, items: &mut &[Item], at: usize) -> Result<Value, LatexError> {
        if let [function, rest @ ..] = *items
            && let Kind::Function(name) = function.kind
        {
            *items = rest;
            return Ok(Value::Number(self.read_applied(
                name,
                items,
                function.at,
            )?));
        }
        let base = self.base(items, at)?;
        let Some(exponent) = self.exponent(items)? else {
            return Ok(base);
        };
        let base = base.number().ok_or_else(|| Problem::Kind.at(at))?;
        Ok(Value::Number(base.pow(exponent)))
    }

    fn exponent(&self, items: &mut &[Item]) -> Result<Option<Expr>, LatexError> {
        let [first, rest @ ..] = *items else {
            return Ok(None);
        };
        let Kind::Sup(exponent) = &first.kind else {
            return Ok(None);
        };
        *items = rest;
        self.number(exponent, first.at).map(Some)
    }

    fn read_applied(
        &self,
        function: Function,
        items: &mut &[Item],
        at: usize,
    ) -> Result<Expr, LatexError> {
        let exponent = self.exponent(items)?;
        let bracket = matches!(items.first().map(|i| &i.kind), Some(Kind::Bracket(_)));
        let argument = self.base(items, at)?.number();
        let argument = argument.ok_or_else(|| Problem::Kind.at(at))?;
        if let Some(next) = items.first() {
            let factor = matches!(
                next.kind,
                Kind::Letter(_) | Kind::Number(_) | Kind::Accent(..) | Kind::Fraction(..)
            );
            let power = matches!(next.kind, Kind::Sup(_));
            if power || factor && !bracket && !next.spaced {
                return Err(Problem::Ambiguous.at(next.at));
            }
        }
        let value = Expr::new(Node::Call(function, argument));
        let inverse = exponent == Some(-Expr::int(1));
        match (function, exponent) {
            (_, None) => Ok(value),
            (Function::Sin, _) if inverse => Ok(argument.asin()),
            (Function::Cos, _) if inverse => Ok(argument.acos()),
            _ if inverse => Err(Problem::Ambiguous.at(at)),
            (_, Some(exponent)) => Ok(value.pow(exponent)),
        }
    }

    fn base(&self, items: &mut &[Item], at: usize) -> Result<Value, LatexError> {
        if let Some(value) = self.read_named(items) {
            return Ok(value);
        }
        let Some((first, rest)) = items.split_first() else {
            return Err(Problem::Missing.at(at));
        };
        let at = first.at;
        *items = rest;
        match &first.kind {
            Kind::Number(digits) => decimal(digits, at).map(Value::Number),
            Kind::Bracket(inner) => self.read(inner, at),
            Kind::Absolute(inner) => Ok(Value::Number(self.read(inner, at)?.size())),
            Kind::Root(inner) => Ok(Value::Number(self.number(inner, at)?.sqrt())),
            Kind::Fraction(above, below) => {
                let below = self.number(below, at)?;
                Ok(self.read(above, at)?.scaled(|x| x / below))
            }
            Kind::Letter(name) => Err(Problem::Name(name.clone()).at(at)),
            Kind::Accent(accent, _) => Err(Problem::Name(format!("name with {accent}")).at(at)),
            _ => Err(Problem::Missing.at(at)),
        }
    }

    fn read_named(&self, items: &mut &[Item]) -> Option<Value> {
        let operator = |item: &Item| matches!(item.kind, Kind::Mark(_));
        let fits = |name: &&(Vec<Item>, Value)| {
            let (name, _) = name;
            let subscript = items.get(name.len()).map(|item| &item.kind);
            items.starts_with(name)
                && !name.iter().any(operator)
                && !matches!(subscript, Some(Kind::Sub(_)))
        };
        let (name, value) = self
            .entries
            .iter()
            .filter(fits)
            .max_by_key(|(name, _)| name.len())?;
        *items = &items[name.len()..];
        Some(*value)
    }
}

/// ⋯, o(…), O(…).
fn is_left_out(term: &[Item]) -> bool {
    match term {
        [dots] => dots.kind == Kind::Mark('⋯'),
        [order, of] => {
            let order = matches!(&order.kind, Kind::Letter(name) if name == "o" || name == "O");
            order && matches!(of.kind, Kind::Bracket(_))
        }
        _ => false,
    }
}

fn joined(
    a: Value,
    b: Value,
    at: usize,
    join: impl Fn(Expr, Expr) -> Expr,
) -> Result<Value, LatexError> {
    match (a, b) {
        (Value::Number(a), Value::Number(b)) => Ok(Value::Number(join(a, b))),
        (Value::Vector(a), Value::Vector(b)) => {
            Ok(Value::Vector(std::array::from_fn(|i| join(a[i], b[i]))))
        }
        _ => Err(Problem::Kind.at(at)),
    }
}

fn multiplied(a: Value, b: Value, at: usize) -> Result<Value, LatexError> {
    match (a, b) {
        (Value::Number(a), b) => Ok(b.scaled(|x| a * x)),
        (a, Value::Number(b)) => Ok(a.scaled(|x| x * b)),
        (Value::Vector(_), Value::Vector(_)) => Err(Problem::Kind.at(at)),
    }
}

fn decimal(digits: &str, at: usize) -> Result<Expr, LatexError> {
    let long = || Problem::TooLong.at(at);
    let (whole, decimals) = digits.split_once('.').unwrap_or((digits, ""));
    let number: i64 = [whole, decimals].concat().parse().map_err(|_| long())?;
    let number = Expr::int(number);
    if decimals.is_empty() {
        return Ok(number);
    }
    let places = u32::try_from(decimals.len()).map_err(|_| long())?;
    Ok(number / Expr::int(10_i64.checked_pow(places).ok_or_else(long)?))
}
