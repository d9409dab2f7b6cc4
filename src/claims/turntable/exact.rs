//! The turntable, exactly: proofs of (86) to (125).
//!
//! That friction alone acts in the laboratory proves (86), (86) proves (89), and (89) all that follows. All holds
//! for a particle that slides, p > 0, and off the axis, ρ > 0, where a formula divides by p or ρ.

pub(crate) mod components;
pub(crate) mod definitions;
pub(crate) mod energy;
pub(crate) mod fixed;
pub(crate) mod frames;
pub(crate) mod hyperbolic;
mod setting;
#[cfg(test)]
mod tests;

use super::prelude::*;
pub(crate) use components::*;
pub(crate) use definitions::*;
pub(crate) use energy::*;
pub(crate) use fixed::*;
pub(crate) use frames::*;
pub(crate) use hyperbolic::*;
pub(crate) use setting::Setting;

/// A statement about the turntable: formulas, or the two components of one.
pub(crate) type Vectorial = Statement<Vec<Expr>>;

const RATE: Compared = Compared::one("the printed rate", "the rate by (89), exactly");

fn prove(
    title: &str,
    setting: Result<Setting, ExactError>,
    steps: impl FnOnce(&mut Prover<'_>, &Setting) -> Result<(), Obstacle>,
) -> Proof {
    match setting {
        Err(error) => Proof::impossible(title, error),
        Ok(setting) => Proof::of(title, &setting.ring, |p| {
            p.note("Law of motion", setting.law);
            steps(p, &setting)
        }),
    }
}

fn vectors() -> [[Expr; 2]; 2] {
    [symbols(["x", "y"]), symbols(["u", "v"])]
}

#[track_caller]
const fn changes(
    subject: Subject,
    formulas: fn() -> Vec<Expr>,
    prove: fn(Vec<Expr>) -> Proof,
) -> Vectorial {
    Vectorial::new(subject, RATE, formulas, prove)
}

/// The printed rate of something against its rate by (89).
fn rate(
    title: &str,
    setting: Result<Setting, ExactError>,
    of: &'static str,
    printed: &[Expr],
) -> Proof {
    prove(title, setting, |p, setting| {
        let own = p.ring().named(of)?;
        let found = p.derivative("Its rate by (89)", &own, &setting.motion)?;
        let printed = p.read("The printed rate", printed[0])?;
        p.equal("The rate by (89) is the printed one", &found, &printed)
    })
}
