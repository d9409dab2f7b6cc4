//! What formulas are made of, laid out flat: arguments and values as lists of numbers.

use crate::scalar::Scalar;

/// A formula by its name and on flat lists.
pub struct Formula<S> {
    /// Its path: `slipbook::paper::constant::eq13_time`.
    pub path: &'static str,
    /// Its name: `eq13_time`.
    pub name: &'static str,
    /// The names of its arguments; one for each component of a vector.
    pub symbols: Vec<&'static str>,
    /// Its value at as many arguments, component by component.
    pub value: fn(&[S]) -> Vec<S>,
}

/// A number, or an array of numbers.
pub trait Parts<S> {
    /// How many numbers it has.
    const COUNT: usize;
    /// Of the next numbers.
    fn of(next: &mut dyn FnMut() -> S) -> Self;
    /// Its numbers.
    fn parts(self) -> Vec<S>;
}

impl<S: Scalar> Parts<S> for S {
    const COUNT: usize = 1;
    fn of(next: &mut dyn FnMut() -> S) -> Self {
        next()
    }
    fn parts(self) -> Vec<S> {
        vec![self]
    }
}

impl<S: Scalar, const N: usize> Parts<S> for [S; N] {
    const COUNT: usize = N;
    fn of(next: &mut dyn FnMut() -> S) -> Self {
        std::array::from_fn(|_| next())
    }
    fn parts(self) -> Vec<S> {
        self.to_vec()
    }
}

/// The names of an argument's numbers: its own where it is one number, else the first ones of `numbered`.
pub fn symbols(count: usize, name: &'static str, numbered: &[&'static str]) -> Vec<&'static str> {
    if count == 1 {
        vec![name]
    } else {
        numbered[..count].to_vec()
    }
}
