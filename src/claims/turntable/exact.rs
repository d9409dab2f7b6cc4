//! The turntable, exactly: proofs of (86) to (125).
//!
//! What is entered here is that friction alone acts in the laboratory; it proves (86), (86) proves (89), and (89)
//! all that follows. The printed formulas come from [`crate::paper::turntable`], as trees. All holds for a
//! particle that slides, p > 0, and off the axis, ρ > 0, where a formula divides by p or ρ.

mod components;
mod definitions;
mod energy;
mod fixed;
mod frames;
mod hyperbolic;
mod setting;
#[cfg(test)]
mod tests;

use crate::claims::compare::proved;
use crate::evidence::{Evidence, Subject};
use crate::exact::{ExactError, Expr, Obstacle, Proof, Prover};
pub use setting::Setting;

/// Printed formulas and the way to prove them.
#[derive(Debug, Clone, Copy)]
pub struct Statement {
    /// Id of the claim; `corrected-106` for a correction.
    pub id: &'static str,
    /// The formulas, or the two components of one.
    pub printed: fn() -> Vec<Expr>,
    /// Tries to prove what the claim says of formulas that stand in the printed ones' place.
    pub prove: fn(&[Expr]) -> Proof,
    /// Where the formulas are read.
    pub setting: fn() -> Result<Setting, ExactError>,
    /// True if the claim only says that the formula keeps its value.
    pub invariant: bool,
}

impl Statement {
    /// The proof of the formulas as they stand.
    pub fn proof(&self) -> Proof {
        (self.prove)(&(self.printed)())
    }
}

/// All statements about the turntable that are proved.
pub const STATEMENTS: &[Statement] = &[
    Statement {
        setting: Setting::dimensional,
        ..statement("eq-86", frames::eq86, frames::prove_eq86)
    },
    Statement {
        setting: Setting::dimensional,
        ..statement("eq-87", frames::eq87, frames::prove_eq87)
    },
    Statement {
        setting: Setting::dimensional,
        ..statement("eq-88", frames::eq88, frames::prove_eq88)
    },
    statement("eq-89", frames::eq89, frames::prove_eq89),
    statement("eq-90", frames::eq90, frames::prove_eq90),
    statement("eq-91", frames::eq91, frames::prove_eq91),
    statement("eq-92", frames::eq92, frames::prove_eq92),
    polar("eq-93", definitions::eq93, definitions::prove_eq93),
    polar("eq-94", definitions::eq94, definitions::prove_eq94),
    polar("eq-95", definitions::eq95, definitions::prove_eq95),
    polar("eq-96", components::eq96, components::prove_eq96),
    polar("eq-97", components::eq97, components::prove_eq97),
    polar("eq-98", components::eq98, components::prove_eq98),
    polar("eq-99", components::eq99, components::prove_eq99),
    polar("eq-100", components::eq100, components::prove_eq100),
    polar("eq-101", components::eq101, components::prove_eq101),
    polar("eq-102", components::eq102, components::prove_eq102),
    polar("eq-103", energy::eq103, energy::prove_eq103),
    Statement {
        invariant: true,
        ..polar("eq-104", energy::eq104, energy::prove_eq104)
    },
    Statement {
        invariant: true,
        setting: Setting::dimensional,
        ..statement("corrected-106", energy::corrected_106, energy::prove_106)
    },
    polar("eq-107", components::eq107, components::prove_eq107),
    polar("eq-108", components::eq108, components::prove_eq108),
    polar("eq-109", components::eq109, components::prove_eq109),
    slower("eq-110", definitions::eq110, definitions::prove_eq110),
    slower("eq-111", definitions::eq111, definitions::prove_eq111),
    slower("eq-112", definitions::eq112, definitions::prove_eq112),
    slower("eq-113", hyperbolic::eq113, hyperbolic::prove_eq113),
    slower("eq-114", hyperbolic::eq114, hyperbolic::prove_eq114),
    slower("eq-115", hyperbolic::eq115, hyperbolic::prove_eq115),
    faster("eq-116", definitions::eq116, definitions::prove_eq116),
    faster("eq-117", definitions::eq117, definitions::prove_eq117),
    faster("eq-118", definitions::eq118, definitions::prove_eq118),
    faster("eq-119", hyperbolic::eq119, hyperbolic::prove_eq119),
    faster("eq-120", hyperbolic::eq120, hyperbolic::prove_eq120),
    faster("eq-121", hyperbolic::eq121, hyperbolic::prove_eq121),
    continued("eq-122", hyperbolic::eq122, hyperbolic::prove_eq122),
    continued("eq-123", hyperbolic::eq123, hyperbolic::prove_eq123),
    fixed_point("eq-124", fixed::eq124, fixed::prove_zero),
    fixed_point("eq-125", fixed::eq125, fixed::prove_zero),
    Statement {
        setting: Setting::dimensional,
        ..statement("s4-mirror", frames::eq86, frames::prove_mirror)
    },
    Statement {
        setting: Setting::dimensional,
        ..statement("corrected-work", energy::works, energy::prove_works)
    },
    fixed_point("s4-quasi-fixed-stability", fixed::slope, fixed::prove_slope),
];

/// The proof of the formula with this id.
pub fn proof(id: &str) -> Option<Proof> {
    STATEMENTS.iter().find(|s| s.id == id).map(Statement::proof)
}

/// Rests a proof on those of the formulas with these ids.
///
/// # Errors
/// [`Obstacle`] if one of them has no proof, or none that holds.
pub fn given(p: &mut Prover<'_>, ids: &[&str]) -> Result<(), Obstacle> {
    for id in ids {
        let name = (*id).to_owned();
        let known = proof(id).ok_or(ExactError::UnknownSymbol { name })?;
        p.rests_on(&known)?;
    }
    Ok(())
}

type Formulas = fn() -> Vec<Expr>;
type Attempt = fn(&[Expr]) -> Proof;

const fn statement(id: &'static str, printed: Formulas, prove: Attempt) -> Statement {
    Statement {
        id,
        printed,
        prove,
        setting: Setting::cartesian,
        invariant: false,
    }
}

const fn polar(id: &'static str, printed: Formulas, prove: Attempt) -> Statement {
    Statement {
        setting: Setting::polar,
        ..statement(id, printed, prove)
    }
}

const fn slower(id: &'static str, printed: Formulas, prove: Attempt) -> Statement {
    Statement {
        setting: Setting::slower,
        ..statement(id, printed, prove)
    }
}

const fn faster(id: &'static str, printed: Formulas, prove: Attempt) -> Statement {
    Statement {
        setting: Setting::faster,
        ..statement(id, printed, prove)
    }
}

const fn continued(id: &'static str, printed: Formulas, prove: Attempt) -> Statement {
    Statement {
        setting: Setting::continued,
        ..statement(id, printed, prove)
    }
}

const fn fixed_point(id: &'static str, printed: Formulas, prove: Attempt) -> Statement {
    Statement {
        setting: Setting::fixed,
        ..statement(id, printed, prove)
    }
}

/// A proof in a setting.
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

fn symbols<const N: usize>(names: [&'static str; N]) -> [Expr; N] {
    names.map(Expr::symbol)
}

/// Position and velocity in Cartesian components.
fn vectors() -> [[Expr; 2]; 2] {
    [symbols(["x", "y"]), symbols(["u", "v"])]
}

/// Evidence of the proof of the formula with this id.
pub fn evidence(id: &str, subject: Subject, compared: &'static str) -> Evidence {
    let proof = proof(id).unwrap_or_else(|| {
        let name = id.to_owned();
        Proof::impossible(id, ExactError::UnknownSymbol { name })
    });
    proved(&proof, subject, compared)
}

/// Evidence of (106) as printed.
pub fn printed_106() -> Evidence {
    let proof = energy::prove_106(&energy::printed_106());
    proved(
        &proof,
        Subject::Printed,
        "the rate of (106) along (86) with 0",
    )
}

/// Evidence of the work as printed.
pub fn printed_work() -> Evidence {
    let proof = energy::prove_works(&energy::printed_works());
    let compared = "the power of the Coriolis force with 0, and the rate of −mgs with the power of friction, in (86)";
    proved(&proof, Subject::Printed, compared)
}
