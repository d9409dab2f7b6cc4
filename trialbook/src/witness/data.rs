//! The shapes of witnesses, as they are written.

use serde::Serialize;

/// What one proof leaves.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
pub enum Witness {
    /// Differences that are zero in a ring.
    Identity(Identity),
    /// One common root of functions in a box.
    Root(Root),
    /// Two numbers that agree.
    Number(Number),
    /// A statement on a whole range.
    Range(Cover),
    /// A motion and its end.
    Motion(Motion),
}

/// From a number to another: `["m*2^e", "m*2^e"]`, exactly.
pub type Interval = (String, String);

/// That functions have exactly one common root in a box, and where it is.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Root {
    /// The variables' names.
    pub variables: Vec<String>,
    /// The functions, as many as there are variables.
    pub functions: Vec<Tree>,
    /// The box in which the root exists and is the only one.
    pub within: Vec<Interval>,
    /// The functions' values at the box's corners where all variables are least, and greatest: the nearest whole multiples of
    /// 2⁻³⁰.
    pub corners: [Vec<String>; 2],
    /// A matrix that is about the inverse of that of the slopes.
    pub preconditioner: Vec<Vec<String>>,
    /// The root, to the nearest whole multiple of the power of two that is written.
    pub root: Vec<String>,
}

/// Two numbers that are the same, or a decimal and the number it is rounded from, where the variables have the values of a
/// root.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Number {
    /// The place of the root in the list of witnesses.
    pub root: usize,
    /// What is stated.
    pub stated: Tree,
    /// What is found.
    pub found: Tree,
}

/// What is asked of a part of a range: that a coefficient of a formula's Taylor series about every point has a sign.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Condition {
    /// The formula.
    pub formula: Tree,
    /// The number of the variable that the series goes by; 0 for the power 0.
    pub by: usize,
    /// The power: 0 for the value, 1 for the slope.
    pub power: usize,
    /// The sign, 1 or −1.
    pub sign: i32,
    /// The coefficients up to that power in the middle of the first part that is asked: the nearest whole multiples of 2⁻³⁰.
    pub middle: Vec<String>,
}

/// To which parts of a range conditions are put.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Where {
    /// To all that are left.
    Rest,
    /// To those that begin there, in the variable of this number.
    From(usize, String),
    /// To those that end below, in the variable of this number.
    Below(usize, String),
}

/// What is asked of some parts of a range.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Case {
    /// Of which.
    pub of: Where,
    /// Whether one of the conditions is enough, which the part names.
    pub choice: bool,
    /// The conditions.
    pub conditions: Vec<Condition>,
}

/// A part of a range.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Piece {
    /// From where to where.
    pub at: Vec<Interval>,
    /// Which of the conditions it fulfils, where there is a choice.
    pub by: Option<usize>,
}

/// That each part of a range fulfils what is asked of it; the parts leave no gap.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Cover {
    /// The variables' names.
    pub variables: Vec<String>,
    /// The range.
    pub within: Vec<Interval>,
    /// What is asked: to each part is put the first case that goes with it.
    pub cases: Vec<Case>,
    /// The parts.
    pub parts: Vec<Piece>,
}

/// A step of a motion.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Step {
    /// Its length.
    pub length: String,
    /// What the motion does not leave meanwhile.
    pub walls: Vec<Interval>,
    /// Where it is in the end.
    pub state: Vec<Interval>,
}

/// All motions from a box of starts, and what becomes of them.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Motion {
    /// The names of the parts of the state.
    pub variables: Vec<String>,
    /// Their rates.
    pub law: Vec<Tree>,
    /// Numbers of the start.
    pub numbers: Vec<(String, Tree)>,
    /// Where the motions begin, as formulas of these.
    pub from: Vec<Tree>,
    /// Where they begin, enclosed.
    pub start: Vec<Interval>,
    /// The steps.
    pub steps: Vec<Step>,
    /// What becomes of them: a name.
    pub end: String,
    /// Of which functions of the last state that is the consequence: each list of signs is enough.
    pub decides: Vec<(Tree, i32)>,
}

/// A formula as a nested list: `["+", "x", ["sin", "y"]]`. A leaf is a whole number, `π`, or the name of a quantity.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(untagged)]
pub enum Tree {
    /// A number or a name.
    Leaf(String),
    /// An operation and what it is done to.
    Node(Vec<Tree>),
}

/// Terms: each a whole coefficient, and the exponents of the generators 0, 1, 2, …
pub type Polynomial = Vec<(String, Vec<u32>)>;

/// An element of a ring: a polynomial over a whole number and powers of polynomials.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Element {
    /// What stands above the line.
    pub above: Polynomial,
    /// The number below it.
    pub number: String,
    /// The factors below it, with their powers.
    pub below: Vec<(Polynomial, u32)>,
}

/// What a generator is.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(tag = "rule", rename_all = "kebab-case")]
pub enum Generator {
    /// π, the generator 0.
    Pi,
    /// A free quantity.
    Free {
        /// Its name.
        name: String,
    },
    /// tan(θ/2).
    HalfTangent {
        /// The generator θ.
        of: usize,
    },
    /// exp(α/2).
    HalfExponential {
        /// The generator α.
        of: usize,
    },
    /// A power with an exponent that is no number.
    Power {
        /// What is raised; positive.
        of: Element,
        /// The exponent.
        to: Element,
    },
    /// A positive root.
    Root {
        /// The radicand; positive.
        of: Element,
        /// The degree.
        degree: u32,
    },
    /// A natural logarithm.
    Logarithm {
        /// What it is taken of; positive.
        of: Element,
    },
}

/// of^to = is, for positive values.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Power {
    /// What is raised.
    pub of: Element,
    /// The exponent.
    pub to: Element,
    /// The power.
    pub is: Element,
}

/// function(of) = is.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Inverse {
    /// `arcsin` or `arccos`.
    pub function: String,
    /// Its argument.
    pub of: Element,
    /// The angle.
    pub is: Element,
}

/// How one of a proof's elements came about, from those before it in the list.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Part {
    /// Given as it is.
    Element(Element),
    /// A formula, read.
    Read(Tree),
    /// Two, added.
    Sum(usize, usize),
    /// The second taken from the first.
    Difference(usize, usize),
    /// Two, multiplied.
    Product(usize, usize),
    /// The first over the second.
    Quotient(usize, usize),
    /// The negative of one.
    Negative(usize),
    /// The first to the power of the second.
    Raised(usize, usize),
    /// The derivative of one, where free generators have these rates and all others of them none.
    Derivative(usize, Vec<(usize, usize)>),
    /// One with values put in for generators.
    Put(usize, Vec<(usize, usize)>),
    /// A formula's power series: the series of some of its symbols, each with the lowest power and its coefficients.
    Series(Tree, Vec<(String, i64, Vec<usize>)>),
    /// The coefficient of a power in a series.
    Coefficient(usize, i64),
}

/// Two elements that are equal.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Equal {
    /// What is compared.
    pub says: String,
    /// One of them.
    pub left: usize,
    /// The other; `None` for zero.
    pub right: Option<usize>,
}

/// A proof in a ring, or a disproof.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Identity {
    /// What is proved.
    pub title: String,
    /// The titles of the proofs that it rests on.
    pub given: Vec<String>,
    /// The ring's generators.
    pub generators: Vec<Generator>,
    /// What each name in a formula stands for.
    pub symbols: Vec<(String, Element)>,
    /// Powers that are known.
    pub powers: Vec<Power>,
    /// Inverse functions that are known.
    pub inverses: Vec<Inverse>,
    /// The elements that the proof forms.
    pub parts: Vec<Part>,
    /// What each of them is, worked out; `None` for what is given as it is, for series, and for what was not worked out.
    pub gives: Vec<Option<Element>>,
    /// What it demands.
    pub equal: Vec<Equal>,
    /// Whether the last of these does not hold: a proof that something is wrong.
    pub fails: bool,
}
