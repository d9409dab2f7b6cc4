//! A formula as a syntax tree.

use crate::scalar::Scalar;
use std::cell::RefCell;
use std::collections::HashMap;
use std::fmt;
use std::marker::PhantomData;
use std::ops::{Add, Div, Mul, Neg, Sub};

/// A node of a formula's syntax tree: a handle into this thread's store, equal exactly if the trees are. It
/// cannot leave its thread.
#[derive(Clone, Copy, PartialEq, Eq, Hash)]
pub struct Expr {
    index: u32,
    here: PhantomData<*const ()>,
}

/// What a node is, with its children.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Node {
    /// A whole number.
    Int(i64),
    /// The circle's ratio.
    Pi,
    /// A named quantity.
    Symbol(&'static str),
    /// The negative of a tree.
    Neg(Expr),
    /// Two trees, joined.
    Binary(Binary, Expr, Expr),
    /// An elementary function of a tree.
    Call(Function, Expr),
}

/// How two trees are joined.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Binary {
    /// Left plus right.
    Add,
    /// Left minus right.
    Sub,
    /// Left times right.
    Mul,
    /// Left over right.
    Div,
    /// Left to the power right.
    Pow,
}

/// The elementary functions.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Function {
    /// Sine.
    Sin,
    /// Cosine.
    Cos,
    /// Tangent.
    Tan,
    /// Cotangent.
    Cot,
    /// Inverse sine.
    Asin,
    /// Inverse cosine.
    Acos,
    /// Hyperbolic sine.
    Sinh,
    /// Hyperbolic cosine.
    Cosh,
    /// Hyperbolic tangent.
    Tanh,
    /// Hyperbolic cotangent.
    Coth,
    /// Exponential function.
    Exp,
    /// Natural logarithm.
    Ln,
    /// Square root.
    Sqrt,
}

impl Function {
    /// The function's name, as it is printed.
    pub fn name(self) -> &'static str {
        match self {
            Function::Sin => "sin",
            Function::Cos => "cos",
            Function::Tan => "tan",
            Function::Cot => "cot",
            Function::Asin => "arcsin",
            Function::Acos => "arccos",
            Function::Sinh => "sinh",
            Function::Cosh => "cosh",
            Function::Tanh => "tanh",
            Function::Coth => "coth",
            Function::Exp => "exp",
            Function::Ln => "ln",
            Function::Sqrt => "√",
        }
    }
}

#[derive(Default)]
struct Store {
    nodes: Vec<Node>,
    index: HashMap<Node, u32>,
}

thread_local! {
    static STORE: RefCell<Store> = RefCell::default();
}

impl Expr {
    /// The tree with this node on top.
    pub fn new(node: Node) -> Self {
        let index = STORE.with_borrow_mut(|store| {
            if let Some(&index) = store.index.get(&node) {
                return index;
            }
            let index =
                u32::try_from(store.nodes.len()).expect("fewer than 2³² nodes fit in memory");
            store.nodes.push(node);
            store.index.insert(node, index);
            index
        });
        Expr {
            index,
            here: PhantomData,
        }
    }

    /// A named quantity, as in `Expr::symbol("λ")`.
    pub fn symbol(name: &'static str) -> Self {
        Self::new(Node::Symbol(name))
    }

    pub(super) fn index(self) -> u32 {
        self.index
    }

    pub(super) fn numbered(index: u32) -> Option<Self> {
        let here = PhantomData;
        let known = STORE.with_borrow(|store| (index as usize) < store.nodes.len());
        known.then_some(Expr { index, here })
    }

    /// The node on top, with its children.
    pub fn node(self) -> Node {
        STORE.with_borrow(|store| store.nodes[self.index as usize])
    }

    /// Named quantities, one for each name.
    pub fn symbols<const N: usize>(names: [&'static str; N]) -> [Self; N] {
        names.map(Self::symbol)
    }

    /// The tree with `value` wherever the symbol `name` stood.
    pub fn with(self, name: &str, value: Expr) -> Self {
        match self.node() {
            Node::Symbol(n) if n == name => value,
            Node::Symbol(_) | Node::Int(_) | Node::Pi => self,
            Node::Neg(x) => Self::new(Node::Neg(x.with(name, value))),
            Node::Call(f, x) => Self::new(Node::Call(f, x.with(name, value))),
            Node::Binary(op, x, y) => {
                Self::new(Node::Binary(op, x.with(name, value), y.with(name, value)))
            }
        }
    }

    /// The formula's value; `None` if a symbol has none.
    pub fn evaluate<S: Scalar>(self, value: &dyn Fn(&str) -> Option<S>) -> Option<S> {
        Some(match self.node() {
            Node::Int(n) => S::int(n),
            Node::Pi => S::pi(),
            Node::Symbol(name) => value(name)?,
            Node::Neg(x) => -x.evaluate(value)?,
            Node::Binary(op, x, y) => {
                let (x, y) = (x.evaluate(value)?, y.evaluate(value)?);
                match op {
                    Binary::Add => x + y,
                    Binary::Sub => x - y,
                    Binary::Mul => x * y,
                    Binary::Div => x / y,
                    Binary::Pow => x.pow(y),
                }
            }
            Node::Call(function, x) => {
                let x = x.evaluate(value)?;
                match function {
                    Function::Sin => x.sin(),
                    Function::Cos => x.cos(),
                    Function::Tan => x.tan(),
                    Function::Cot => x.cot(),
                    Function::Asin => x.asin(),
                    Function::Acos => x.acos(),
                    Function::Sinh => x.sinh(),
                    Function::Cosh => x.cosh(),
                    Function::Tanh => x.tanh(),
                    Function::Coth => x.coth(),
                    Function::Exp => x.exp(),
                    Function::Ln => x.ln(),
                    Function::Sqrt => x.sqrt(),
                }
            }
        })
    }

    fn join(self, op: Binary, other: Self) -> Self {
        Self::new(Node::Binary(op, self, other))
    }

    fn call(self, function: Function) -> Self {
        Self::new(Node::Call(function, self))
    }

    /// From sums (1) to single symbols (5).
    fn strength(self) -> u8 {
        match self.node() {
            Node::Binary(Binary::Add | Binary::Sub, ..) => 1,
            Node::Neg(_) => 2,
            Node::Int(n) if n < 0 => 2,
            Node::Binary(Binary::Mul, x, y) if x == y => 4,
            Node::Binary(Binary::Mul | Binary::Div, ..) => 3,
            Node::Binary(Binary::Pow, ..) => 4,
            Node::Symbol(name) if letters_meet(name) => 4,
            Node::Call(..) | Node::Int(_) | Node::Pi | Node::Symbol(_) => 5,
        }
    }

    fn write(self, f: &mut fmt::Formatter<'_>, at_least: u8) -> fmt::Result {
        if self.strength() < at_least {
            write!(f, "({self})")
        } else {
            write!(f, "{self}")
        }
    }
}

/// Outside brackets.
fn letters_meet(name: &str) -> bool {
    let index = |c: char| ('ₐ'..='ₜ').contains(&c);
    let letter = name.chars().map(|c| c.is_alphabetic() && !index(c));
    letter
        .clone()
        .zip(letter.skip(1))
        .any(|pair| pair == (true, true))
        && !name.starts_with('(')
}

/// The formula in plain text, with as few parentheses as it needs.
impl fmt::Display for Expr {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.node() {
            Node::Int(n) => write!(f, "{n}"),
            Node::Pi => write!(f, "π"),
            Node::Symbol(name) => write!(f, "{name}"),
            Node::Neg(x) => {
                write!(f, "−")?;
                x.write(f, 3)
            }
            Node::Call(function, x) => write!(f, "{}({x})", function.name()),
            Node::Binary(Binary::Mul, x, y) if x == y => {
                x.write(f, 5)?;
                write!(f, "^2")
            }
            Node::Binary(op, x, y) => {
                let (sign, left, right) = match op {
                    Binary::Add => (" + ", 1, 2),
                    Binary::Sub => (" − ", 1, 2),
                    Binary::Mul => (" ", 3, 4),
                    Binary::Div => ("/", 3, 4),
                    Binary::Pow => ("^", 5, 5),
                };
                x.write(f, left)?;
                write!(f, "{sign}")?;
                y.write(f, right)
            }
        }
    }
}

impl fmt::Debug for Expr {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{self}")
    }
}

impl Add for Expr {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        self.join(Binary::Add, other)
    }
}

impl Sub for Expr {
    type Output = Self;
    fn sub(self, other: Self) -> Self {
        self.join(Binary::Sub, other)
    }
}

impl Mul for Expr {
    type Output = Self;
    fn mul(self, other: Self) -> Self {
        self.join(Binary::Mul, other)
    }
}

impl Div for Expr {
    type Output = Self;
    fn div(self, other: Self) -> Self {
        self.join(Binary::Div, other)
    }
}

macro_rules! with_whole_numbers {
    ($($operator:ident $method:ident),*) => {
        $(
            impl $operator<i64> for Expr {
                type Output = Self;
                fn $method(self, other: i64) -> Self {
                    self.$method(Expr::int(other))
                }
            }

            impl $operator<Expr> for i64 {
                type Output = Expr;
                fn $method(self, other: Expr) -> Expr {
                    Expr::int(self).$method(other)
                }
            }
        )*
    };
}
with_whole_numbers!(Add add, Sub sub, Mul mul, Div div);

impl Neg for Expr {
    type Output = Self;
    fn neg(self) -> Self {
        Self::new(Node::Neg(self))
    }
}

impl Scalar for Expr {
    fn int(n: i64) -> Self {
        Self::new(Node::Int(n))
    }
    fn pi() -> Self {
        Self::new(Node::Pi)
    }
    fn sin(self) -> Self {
        self.call(Function::Sin)
    }
    fn cos(self) -> Self {
        self.call(Function::Cos)
    }
    fn asin(self) -> Self {
        self.call(Function::Asin)
    }
    fn acos(self) -> Self {
        self.call(Function::Acos)
    }
    fn sinh(self) -> Self {
        self.call(Function::Sinh)
    }
    fn cosh(self) -> Self {
        self.call(Function::Cosh)
    }
    fn exp(self) -> Self {
        self.call(Function::Exp)
    }
    fn ln(self) -> Self {
        self.call(Function::Ln)
    }
    fn sqrt(self) -> Self {
        self.call(Function::Sqrt)
    }
    fn pow(self, exponent: Self) -> Self {
        self.join(Binary::Pow, exponent)
    }
    fn tan(self) -> Self {
        self.call(Function::Tan)
    }
    fn cot(self) -> Self {
        self.call(Function::Cot)
    }
    fn tanh(self) -> Self {
        self.call(Function::Tanh)
    }
    fn coth(self) -> Self {
        self.call(Function::Coth)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn prints_no_more_parentheses_than_needed() {
        let [a, b, c] = ["a", "b", "c"].map(Expr::symbol);
        assert_eq!((a - (b - c)).to_string(), "a − (b − c)");
        assert_eq!(((a - b) - c).to_string(), "a − b − c");
        assert_eq!((a / (b * c)).to_string(), "a/(b c)");
        assert_eq!((a * (b + c)).squared().to_string(), "(a (b + c))^2");
        assert_eq!((-(a + b)).to_string(), "−(a + b)");
        assert_eq!(Expr::symbol("qλ₀").squared().to_string(), "(qλ₀)^2");
        assert_eq!(
            (a / Expr::int(2)).tan().pow(-b).to_string(),
            "tan(a/2)^(−b)"
        );
    }

    #[test]
    fn equal_trees_are_equal_handles() {
        let [a, b] = ["a", "b"].map(Expr::symbol);
        assert_eq!(a.sin() + b, a.sin() + b);
        assert_ne!(a.sin() + b, b + a.sin());
        assert_eq!((a.sin() + b).with("a", b), b.sin() + b);
    }
}
