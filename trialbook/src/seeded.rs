//! Seeded mistakes: a formula evaluated with one place changed, to see that its trials reject it. On a thread
//! on which [`with`] has seeded one, the arguments of a formula in `formulas!` are [`Seeded`] numbers, which
//! count the places passed and change the chosen one.
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
mod mistake;
#[cfg(feature = "trials")]
mod number;
#[cfg(feature = "trials")]
mod parts;
#[cfg(feature = "trials")]
pub mod reading;

#[cfg(feature = "trials")]
pub(crate) use mistake::is_in_any;
#[cfg(feature = "trials")]
pub use {
    corner::Corner,
    mistake::{Mistake, Place, Seed, is_in, places, with, without},
    number::{Seeded, evaluate},
    parts::{Formula, Parts, Symbol, letters, symbol},
};

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

/// Formulas in which a mistake can be seeded, and `formulas()`, the list of them: generic over `S: Scalar`,
/// arguments and value of type `S` or arrays of `S`, the letters those of the symbols. A formula whose name
/// has no number says which claim tries it, if one does: `claim "some-id";`.
///
/// `eq13_time::tree()` is the formula `eq13_time` as a tree; `eq13_time::parts()` the same as a list, also
/// where it is no vector.
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
                lengths: vec![$(<$type as Parts<S>>::COUNT),*],
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
