//! What the trials and proofs of several topics use.

pub use super::shared::SHARED;
pub use super::tolerances::*;
pub use crate::exact::{Derivation, Function, Series};
pub use crate::motion::{Motion, MotionError, PhaseKind, Plane, Signal, State, run};
pub use crate::numerics::double::Double;
pub use crate::numerics::quadrature::{integral_within, sum};
pub use std::f64::consts::{FRAC_PI_2, PI, TAU};
pub use trialbook::certified::error::CertifiedError;
pub use trialbook::evidence::Route::*;
pub use trialbook::prelude::*;
pub use trialbook::trials::by_hand::Numbers;
pub use trialbook::trials::runs::Derived;
pub use trialbook::trials::values::Number;

/// The list of a module's trials, as its constant `TRIALS`, by which its topic has them: see [`trials!`].
macro_rules! attempts {
    ($($all:tt)*) => {
        pub(in crate::claims) const TRIALS: &[trialbook::prelude::Attempt] =
            trialbook::prelude::trials![$($all)*];
    };
}
pub(in crate::claims) use attempts;

/// A whole number in a formula.
pub fn int(n: i64) -> Expr {
    Expr::int(n)
}

/// A symbol in a formula.
pub fn symbol(name: &'static str) -> Expr {
    Expr::symbol(name)
}

/// Symbols in a formula.
pub fn symbols<const N: usize>(names: [&'static str; N]) -> [Expr; N] {
    Expr::symbols(names)
}

/// π in a formula.
pub fn pi() -> Expr {
    Expr::pi()
}
