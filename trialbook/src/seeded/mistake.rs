//! Which mistake is seeded where, on each thread.

use super::{Corner, reading};
use crate::scalar::Scalar;
use std::cell::Cell;

/// What is changed at a place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Mistake {
    /// The sign.
    Sign,
    /// A factor of 2.
    Factor,
    /// An argument, for the one of this number.
    Symbol(usize),
    /// An exponent or a whole number, one more; sin for cos and the like; a product for a quotient.
    More,
    /// A whole number or the exponent of a square, one less; the other sign of an exponent; 1 for π.
    Less,
    /// An inverse function on its other branch: over the upper half of its range, or the lower.
    Branch(bool),
    /// Of the value, not at a place: one part in this number too much; too little where negative.
    Part(i64),
    /// Of the value, not at a place: a hundredth too much where the argument of this number is in the corner.
    Corner(&'static Corner, usize),
}

impl Mistake {
    pub(super) fn part<S: Scalar>(self, arguments: &[S]) -> Option<i64> {
        match self {
            Mistake::Part(part) => Some(part),
            Mistake::Corner(corner, i) => {
                let here = arguments[i].nearest().is_some_and(|x| corner.holds(x));
                here.then_some(100)
            }
            _ => None,
        }
    }
}

/// A place of an evaluation: where an argument is read, or what an operation gives.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Place {
    /// The argument of this number is read.
    Argument(usize),
    /// An operation: whether it can be done with [`Mistake::More`], and with [`Mistake::Less`].
    Operation([bool; 2]),
    /// An inverse function, which can be done with [`Mistake::More`] and [`Mistake::Branch`].
    Inverse,
}

impl Place {
    pub(super) fn mistakes(self, arguments: usize) -> Vec<Mistake> {
        let mut all = vec![Mistake::Sign, Mistake::Factor];
        match self {
            Place::Argument(here) => {
                all.push(Mistake::More);
                let others = (0..arguments).filter(|other| *other != here);
                all.extend(others.map(Mistake::Symbol));
            }
            Place::Operation([more, less]) => {
                all.extend(more.then_some(Mistake::More));
                all.extend(less.then_some(Mistake::Less));
            }
            Place::Inverse => all.push(Mistake::More),
        }
        all
    }
}

/// A mistake at a place of a formula.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Seed {
    /// The formula's path: `some_crate::some_topic::eq13_time`.
    pub formula: &'static str,
    /// The number of the place, in the order of evaluation.
    pub place: usize,
    /// The mistake.
    pub mistake: Mistake,
}

impl Seed {
    /// A mistake of the value, at no place.
    pub fn of_value(formula: &'static str, mistake: Mistake) -> Self {
        Seed {
            formula,
            place: usize::MAX,
            mistake,
        }
    }
}

thread_local! {
    pub(crate) static SEED: Cell<Option<Seed>> = const { Cell::new(None) };
    /// And the one that is wanted.
    static PASSED: Cell<(usize, usize)> = const { Cell::new((0, usize::MAX)) };
    static PLACE: Cell<Option<Place>> = const { Cell::new(None) };
}

/// Calls `f` with the mistake seeded on this thread, and on no other.
pub fn with<T>(seed: Seed, f: impl FnOnce() -> T) -> T {
    struct Before(Option<Seed>);
    impl Drop for Before {
        fn drop(&mut self) {
            SEED.set(self.0);
        }
    }
    let _before = Before(SEED.replace(Some(seed)));
    f()
}

/// Calls `f` with no mistake seeded on this thread.
pub fn without<T>(f: impl FnOnce() -> T) -> T {
    let seed = SEED.take();
    let value = f();
    SEED.set(seed);
    value
}

/// True if a mistake is seeded in one of these formulas.
pub(crate) fn is_in_any(formulas: &std::collections::BTreeSet<&'static str>) -> bool {
    SEED.get()
        .is_some_and(|seed| formulas.contains(seed.formula))
}

/// The formula of this path is read: true if a mistake is seeded in it.
pub fn is_in(formula: &'static str) -> bool {
    reading::note(formula);
    SEED.get().is_some_and(|seed| seed.formula == formula)
}

/// The places that `evaluation` of the formula of this path passes, in order.
pub fn places(formula: &'static str, evaluation: impl Fn()) -> Vec<Place> {
    // Where it is made it does no harm: only the place is of interest.
    let mistake = Mistake::Branch(true);
    let pass = |place| {
        let seed = Seed {
            formula,
            place,
            mistake,
        };
        PLACE.set(None);
        with(seed, &evaluation);
        PLACE.take()
    };
    (0..).map_while(pass).collect()
}

pub(super) fn begin() {
    PASSED.set((0, SEED.get().map_or(usize::MAX, |seed| seed.place)));
}

#[inline]
pub(super) fn pass(place: Place) -> Option<Mistake> {
    let (passed, wanted) = PASSED.get();
    PASSED.set((passed + 1, wanted));
    if passed != wanted {
        return None;
    }
    PLACE.set(Some(place));
    SEED.get().map(|seed| seed.mistake)
}
