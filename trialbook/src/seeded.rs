//! Seeded mistakes: a formula evaluated with one place changed, to see that its trials reject it.
//!
//! A formula written inside `formulas!` is what stands there, except on a thread on which [`with`] has seeded a
//! mistake in it. Then its arguments become [`Seeded`] numbers, which count the places that the evaluation passes
//! and change the chosen one. So a mistake reaches every kind of [`Scalar`](crate::scalar::Scalar) alike, numbers
//! and trees, and a trial cannot tell it from a misprint. What [`reading`] watches is noted too: which formulas it reads.
// Where it is not built, its name leads to the feature that brings it.
#![cfg_attr(
    not(feature = "trials"),
    doc = "",
    doc = "[`with`]: crate#features",
    doc = "[`Seeded`]: crate#features",
    doc = "[`reading`]: crate#features"
)]

#[cfg(feature = "trials")]
mod corner;
#[cfg(feature = "trials")]
mod number;
#[cfg(feature = "trials")]
mod parts;
#[cfg(feature = "trials")]
pub mod reading;

#[cfg(feature = "trials")]
pub use corner::Corner;
#[cfg(feature = "trials")]
pub use number::{Seeded, evaluate};
#[cfg(feature = "trials")]
pub use parts::{Formula, Parts, Symbol, letters, symbol};

#[cfg(feature = "trials")]
use std::cell::Cell;

/// What is changed at a place.
#[cfg(feature = "trials")]
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
    /// Not at a place but of the value: as large a part of it too much as one over this number; too little where it is
    /// negative.
    Part(i64),
    /// Not at a place but of the value: a hundredth too much where the argument of this number is in the corner.
    Corner(&'static Corner, usize),
}

#[cfg(feature = "trials")]
impl Mistake {
    /// What of the value is too much, as in [`Mistake::Part`], at these arguments.
    fn part<S: crate::scalar::Scalar>(self, arguments: &[S]) -> Option<i64> {
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

/// A place that an evaluation passes: where an argument is read, or what an operation gives.
#[cfg(feature = "trials")]
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Place {
    /// The argument of this number is read.
    Argument(usize),
    /// An operation: whether it can be done with [`Mistake::More`], and with [`Mistake::Less`].
    Operation([bool; 2]),
    /// An inverse function, which can be done with [`Mistake::More`] and [`Mistake::Branch`].
    Inverse,
}

#[cfg(feature = "trials")]
impl Place {
    /// The mistakes that can be made here, in a formula with so many arguments.
    fn mistakes(self, arguments: usize) -> Vec<Mistake> {
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
#[cfg(feature = "trials")]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Seed {
    /// The formula's path: `some_crate::some_topic::eq13_time`.
    pub formula: &'static str,
    /// The number of the place, in the order of evaluation.
    pub place: usize,
    /// The mistake.
    pub mistake: Mistake,
}

#[cfg(feature = "trials")]
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

#[cfg(feature = "trials")]
thread_local! {
    static SEED: Cell<Option<Seed>> = const { Cell::new(None) };
    /// How many places the evaluation has passed, and the one that is wanted.
    static PASSED: Cell<(usize, usize)> = const { Cell::new((0, usize::MAX)) };
    /// That place.
    static PLACE: Cell<Option<Place>> = const { Cell::new(None) };
}

/// Calls `f` with the mistake seeded on this thread, and on no other.
#[cfg(feature = "trials")]
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
#[cfg(feature = "trials")]
pub fn without<T>(f: impl FnOnce() -> T) -> T {
    let seed = SEED.take();
    let value = f();
    SEED.set(seed);
    value
}

/// True if a mistake is seeded in one of these formulas.
#[cfg(feature = "trials")]
pub fn is_in_any(formulas: &std::collections::BTreeSet<&'static str>) -> bool {
    SEED.get()
        .is_some_and(|seed| formulas.contains(seed.formula))
}

/// The formula of this path is read: true if a mistake is seeded in it.
#[cfg(feature = "trials")]
pub fn is_in(formula: &'static str) -> bool {
    reading::note(formula);
    SEED.get().is_some_and(|seed| seed.formula == formula)
}

/// The places that `evaluation` of the formula of this path passes, in order.
#[cfg(feature = "trials")]
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

/// An evaluation with the seeded mistake begins.
#[cfg(feature = "trials")]
fn begin() {
    PASSED.set((0, SEED.get().map_or(usize::MAX, |seed| seed.place)));
}

/// Passes a place: the mistake to make there, if any.
#[cfg(feature = "trials")]
#[inline]
fn pass(place: Place) -> Option<Mistake> {
    let (passed, wanted) = PASSED.get();
    PASSED.set((passed + 1, wanted));
    if passed != wanted {
        return None;
    }
    PLACE.set(Some(place));
    SEED.get().map(|seed| seed.mistake)
}

/// Code of [`formulas!`] for mistakes that are seeded: with this crate's feature, whatever features the formulas' own crate has.
#[cfg(feature = "trials")]
#[doc(hidden)]
#[macro_export]
macro_rules! where_seeded {
    ($($code:tt)*) => { $($code)* };
}

/// Nothing: without the feature no mistake is seeded.
#[cfg(not(feature = "trials"))]
#[doc(hidden)]
#[macro_export]
macro_rules! where_seeded {
    ($($code:tt)*) => {};
}

/// Formulas in which a mistake can be seeded, and `formulas()`, the list of them. Each is generic over `S: Scalar`,
/// its arguments and its value are of type `S` or arrays of `S`. The arguments' letters are those of the symbols. A
/// formula whose name has no number says before it which claim tries it, `claim "some-id";`, if one does.
///
/// `eq13_time::tree()` is the formula `eq13_time` as a tree, in the letters of its arguments; `eq13_time::parts()` the
/// same as a list, which has one tree for a formula that is no vector.
#[macro_export]
macro_rules! formulas {
    (symbols $symbols:expr; $(
        $(#[$about:meta])*
        $(claim $claim:literal;)?
        pub fn $name:ident<S: Scalar>($($argument:ident: $type:ty),* $(,)?) -> $value:ty $body:block
    )*) => {
        $(
            $(#[$about])*
            pub fn $name<S: Scalar>($($argument: $type),*) -> $value {
                fn written<S: Scalar>($($argument: $type),*) -> $value $body
                $crate::where_seeded! {
                    if $crate::seeded::is_in(concat!(module_path!(), "::", stringify!($name))) {
                        use $crate::seeded;
                        let arguments = &mut Vec::<S>::with_capacity(0 $(+ <$type as seeded::Parts<S>>::COUNT)*);
                        $(seeded::Parts::lay($argument, arguments);)*
                        return seeded::evaluate(arguments, |_next| {
                            written::<seeded::Seeded<'_, S>>($({ let $argument = seeded::Parts::of(_next); $argument }),*)
                        });
                    }
                }
                written($($argument),*)
            }

            $crate::where_seeded! {
            // Not every formula is wanted as a tree, nor has its value a type with a name.
            #[allow(dead_code, unused_imports)]
            #[doc(hidden)]
            pub mod $name {
                use super::*;
                type S = $crate::exact::Expr;

                /// The formula as a tree, in the letters of its arguments.
                pub fn tree() -> $value {
                    use $crate::seeded::{Parts, letters};
                    let own: [Vec<_>; 0 $(+ { stringify!($argument); 1 })*] = [$(letters(
                        $symbols,
                        super::MODULE,
                        stringify!($argument),
                        <$type as Parts<S>>::COUNT,
                    )),*];
                    let mut _own = own.into_iter().flatten();
                    let _next = &mut || S::symbol(_own.next().expect("one for each number"));
                    super::$name::<S>($({ let $argument = Parts::of(_next); $argument }),*)
                }

                /// The same, laid flat.
                pub fn parts() -> Vec<S> {
                    let mut parts = Vec::new();
                    $crate::seeded::Parts::lay(tree(), &mut parts);
                    parts
                }
            }
            }
        )*

        $crate::where_seeded! {
        const MODULE: &str = module_path!();

        /// The formulas of this file.
        pub fn formulas<S: Scalar>() -> Vec<$crate::seeded::Formula<S>> {
            use $crate::seeded::{Formula, Parts, letters};
            vec![$(Formula {
                path: concat!(module_path!(), "::", stringify!($name)),
                name: stringify!($name),
                tried_in: [$(Some($claim),)? None][0],
                arguments: &[$(stringify!($argument)),*],
                symbols: [Vec::new(), $(letters(
                    $symbols,
                    MODULE,
                    stringify!($argument),
                    <$type as Parts<S>>::COUNT,
                )),*].concat(),
                value: |_arguments| {
                    let mut _arguments = _arguments.iter().copied();
                    let _next = &mut || _arguments.next().expect("one for each symbol");
                    let mut parts = Vec::with_capacity(<$value as Parts<S>>::COUNT);
                    Parts::lay($name::<S>($({ let $argument = Parts::of(_next); $argument }),*), &mut parts);
                    parts
                },
            }),*]
        }
        }
    };
}
pub use formulas;
