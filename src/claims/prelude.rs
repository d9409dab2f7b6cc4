//! What the trials and proofs of several topics use.

pub(super) use super::shared::SHARED;
pub(super) use super::tolerances::*;
pub(super) use crate::exact::{Derivation, Function, Series};
pub(super) use crate::motion::{Motion, MotionError, PhaseKind, Plane, Signal, State, run};
pub(super) use crate::numerics::double::Double;
pub(super) use crate::numerics::quadrature::{integral_within, sum};
pub(super) use std::f64::consts::{FRAC_PI_2, PI, TAU};
pub(super) use trialbook::certified::error::CertifiedError;
pub(super) use trialbook::evidence::Route::*;
pub(super) use trialbook::prelude::*;
pub(super) use trialbook::trials::by_hand::Numbers;
pub(super) use trialbook::trials::runs::Derived;
pub(super) use trialbook::trials::values::Number;

/// The list of a module's trials, as its constant `TRIALS`, by which its topic has them: see [`trials!`].
macro_rules! attempts {
    ($($all:tt)*) => {
        pub(in crate::claims) const TRIALS: &[trialbook::prelude::Attempt] =
            trialbook::prelude::trials![$($all)*];
    };
}
pub(in crate::claims) use attempts;

pub(super) fn int(n: i64) -> Expr {
    Expr::int(n)
}

pub(super) fn symbol(name: &'static str) -> Expr {
    Expr::symbol(name)
}

pub(super) fn symbols<const N: usize>(names: [&'static str; N]) -> [Expr; N] {
    Expr::symbols(names)
}

pub(super) fn pi() -> Expr {
    Expr::pi()
}
