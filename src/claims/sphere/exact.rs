//! Section 3, exactly: proofs from the laws of Newton and Euler for a rigid sphere, component by component.
//!
//! Only those laws and Coulomb's friction are entered here, at the contact point below the centre; the printed
//! formulas come from [`crate::paper::sphere`], as trees.

mod angle;
mod body;
mod laws;
#[cfg(test)]
mod tests;

use crate::claims::compare::proved;
use crate::evidence::{Evidence, Subject};
use crate::exact::{ExactError, Expr, Proof};

/// Components of a vector, as trees; a scalar has one.
pub type Components = Vec<Expr>;

/// A printed formula and the way to prove it.
#[derive(Debug, Clone, Copy)]
pub struct Statement {
    /// Id of the claim; `corrected-75` for a correction.
    pub id: &'static str,
    /// The formula.
    pub printed: fn() -> Components,
    /// Tries to prove what the claim says of a formula that stands in the printed one's place.
    pub prove: fn(Components) -> Proof,
}

impl Statement {
    /// The proof of the formula as it stands.
    pub fn proof(&self) -> Proof {
        (self.prove)((self.printed)())
    }
}

const fn statement(
    id: &'static str,
    printed: fn() -> Components,
    prove: fn(Components) -> Proof,
) -> Statement {
    Statement { id, printed, prove }
}

/// All statements of section 3 that are proved, or, for (75), (82) and (83), tried as printed and as corrected.
pub const STATEMENTS: &[Statement] = &[
    statement("eq-59", laws::eq59, laws::prove_eq59),
    statement("eq-60", laws::eq60, laws::prove_eq60),
    statement("eq-62", body::eq62, body::prove_eq62),
    statement("eq-63", body::eq63, body::prove_eq63),
    statement("eq-64", body::eq64, body::prove_eq64),
    statement("eq-65", body::eq65, body::prove_eq65),
    statement("eq-66", body::eq66, body::prove_eq66),
    statement("eq-68", body::eq68, body::prove_eq68),
    statement("eq-69", body::eq69, body::prove_eq69),
    statement("eq-70", body::eq70, body::prove_eq70),
    statement("eq-71", body::eq71, body::prove_eq71),
    statement("eq-72", body::eq72, body::prove_eq72),
    statement("eq-73", body::eq73, body::prove_eq73),
    statement("eq-74", body::eq74, body::prove_eq74),
    statement("eq-75", body::eq75, body::prove_eq75),
    statement("corrected-75", body::corrected75, body::prove_eq75),
    statement("eq-77", body::eq77, body::prove_eq77),
    statement("eq-78", body::eq78, body::prove_eq78),
    statement("eq-79", body::eq79, body::prove_eq79),
    statement("eq-81", angle::eq81, angle::prove_eq81),
    statement("eq-82", angle::eq82, angle::prove_eq82),
    statement("corrected-82", angle::corrected82, angle::prove_eq82),
    statement("eq-83", angle::eq83, angle::prove_eq83),
    statement("corrected-83", angle::corrected83, angle::prove_eq83),
    statement("s3-reduction", body::reduction, body::prove_reduction),
    statement(
        "s3-spin-constant",
        body::spin_rate,
        body::prove_spin_constant,
    ),
];

/// The proof of the formula with this id.
pub fn proof(id: &str) -> Option<Proof> {
    STATEMENTS.iter().find(|s| s.id == id).map(Statement::proof)
}

/// Evidence of the proof of the formula with this id.
pub fn evidence(id: &str, subject: Subject) -> Evidence {
    let compared = match id {
        "eq-59" => "the formula with Newton's law in the laboratory, where friction alone acts",
        "eq-60" => "the formula with Newton's law for six point masses that move as one body",
        "eq-62" => "(64), with κ by the definition, with Euler's law for the sphere",
        "eq-68" => "(73), with ρ by the definition, with Newton's law for the sphere",
        "eq-69" | "eq-71" | "eq-72" => {
            "(74), with the quantity by the definition, with the laws of Newton and Euler for the sphere"
        }
        "eq-70" => "ζ dτ, with τ by (69), with ω dt",
        "eq-81" | "eq-82" | "eq-83" | "corrected-82" | "corrected-83" => {
            "the formula with (11), (13), (14), proved from (1), with γ for A, b for μg and τ for t, as (74) has them"
        }
        _ => "the formula with the laws of Newton and Euler for the sphere, component by component",
    };
    let proof = proof(id).unwrap_or_else(|| {
        let name = id.to_owned();
        Proof::impossible(id, ExactError::UnknownSymbol { name })
    });
    proved(&proof, subject, compared)
}

fn symbols<const N: usize>(names: [&'static str; N]) -> [Expr; N] {
    names.map(Expr::symbol)
}

/// Names of a vector's components, for the steps of a proof.
const AXES: [&str; 3] = ["along x", "along y", "along z"];
