//! What formulas are made of, laid out flat: arguments and values as lists of numbers.

use super::{Mistake, Place, Seed, places};
use crate::scalar::Scalar;

/// A formula by its name and on flat lists.
#[derive(Clone)]
pub struct Formula<S> {
    /// Its path: `some_crate::some_topic::eq13_time`.
    pub path: &'static str,
    /// Its name: `eq13_time`.
    pub name: &'static str,
    /// The id of the claim that tries it, if its name has no number.
    pub tried_in: Option<&'static str>,
    /// The names of its arguments.
    pub arguments: &'static [&'static str],
    /// How many components each of them has.
    pub lengths: Vec<usize>,
    /// The letters of its arguments; one for each component of a vector.
    pub symbols: Vec<&'static str>,
    /// Its value at as many arguments, component by component.
    pub value: fn(&[S]) -> Vec<S>,
}

impl<S> Formula<S> {
    /// The claim that tries it: of the number in its name, or as declared.
    pub fn claim(&self) -> Option<String> {
        let number = self
            .name
            .strip_prefix("eq")
            .and_then(|rest| rest.split('_').next());
        number
            .map(|n| format!("eq-{n}"))
            .or_else(|| self.tried_in.map(str::to_owned))
    }

    /// Every mistake at every place that the evaluation passes.
    pub fn seeds(&self, arguments: &[S]) -> Vec<Seed> {
        let passed = places(self.path, || drop((self.value)(arguments)));
        let of_place = |(place, kind): (usize, &Place)| {
            let mistakes = kind.mistakes(arguments.len()).into_iter();
            mistakes.map(move |mistake| (place, mistake))
        };
        let all = passed.iter().enumerate().flat_map(of_place);
        all.map(|(place, mistake)| Seed {
            formula: self.path,
            place,
            mistake,
        })
        .collect()
    }

    /// Its inverse functions on their other branches, over either half.
    pub fn branches(&self, arguments: &[S]) -> Vec<Seed> {
        let passed = places(self.path, || drop((self.value)(arguments)));
        let inverse = passed.iter().enumerate();
        let inverse = inverse.filter(|(_, place)| **place == Place::Inverse);
        let of_place = |(place, _)| {
            [false, true].map(|upper| Seed {
                formula: self.path,
                place,
                mistake: Mistake::Branch(upper),
            })
        };
        inverse.flat_map(of_place).collect()
    }
}

/// A number, or an array of numbers.
pub trait Parts<S> {
    /// How many numbers it has.
    const COUNT: usize;
    /// Of the next numbers.
    fn of(next: &mut dyn FnMut() -> S) -> Self;
    /// Lays its numbers behind others.
    fn lay(self, behind: &mut Vec<S>);
}

impl<S: Scalar> Parts<S> for S {
    const COUNT: usize = 1;
    fn of(next: &mut dyn FnMut() -> S) -> Self {
        next()
    }
    fn lay(self, behind: &mut Vec<S>) {
        behind.push(self);
    }
}

impl<S: Scalar, const N: usize> Parts<S> for [S; N] {
    const COUNT: usize = N;
    fn of(next: &mut dyn FnMut() -> S) -> Self {
        std::array::from_fn(|_| next())
    }
    fn lay(self, behind: &mut Vec<S>) {
        behind.extend(self);
    }
}

/// A symbol of formulas.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Symbol {
    /// The topic in which the name means this; empty where it means this in every other topic.
    pub topic: &'static str,
    /// The argument's name.
    pub argument: &'static str,
    /// Its letter, as plain text.
    pub plain: &'static str,
    /// The letters of its components, or of the quantity and its rate.
    pub parts: &'static [&'static str],
    /// Its letter in LaTeX.
    pub latex: &'static str,
    /// What it means, with mathematics between dollar signs.
    pub meaning: &'static str,
    /// Its unit in words; "1" if it is dimensionless.
    pub unit: &'static str,
    /// The id of the claim that introduces it.
    pub claim: &'static str,
}

/// The symbol of an argument of a formula in this module.
pub fn symbol(all: &'static [Symbol], module: &str, argument: &str) -> Option<&'static Symbol> {
    let topic = module.rsplit("::").next();
    let named = |own: bool| {
        let topic = if own { topic } else { Some("") };
        all.iter()
            .find(|s| s.argument == argument && Some(s.topic) == topic)
    };
    named(true).or_else(|| named(false))
}

/// The letters of an argument's numbers: its own for one number, else those of its parts; undeclared, its
/// name for each.
pub fn letters(
    all: &'static [Symbol],
    module: &str,
    argument: &'static str,
    count: usize,
) -> Vec<&'static str> {
    match symbol(all, module, argument) {
        Some(symbol) if count == 1 => vec![symbol.plain],
        Some(symbol) if symbol.parts.len() >= count => symbol.parts[..count].to_vec(),
        _ => vec![argument; count],
    }
}
