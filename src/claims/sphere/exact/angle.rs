//! Constant acceleration, (81) to (83): (74) is (1) with γ for A, b for μg and τ for t, so that (11), (13) and (14)
//! say what has to be proved.

use super::{AS_A_PARTICLE, Components, EQ74, S3_REDUCTION, Vectorial};
use crate::claims::constant::exact as constant;
use crate::corrections::sphere as corrected;
use crate::paper::constant as particle;
use crate::paper::sphere as paper;
use trialbook::prelude::*;

/// The ring of λ, γ, u₀, θ, θ₀ and τ, with the powers of the half tangents.
pub(super) fn ring() -> Result<Ring, ExactError> {
    let mut ring = Ring::of(["γ", "u₀", "τ"]);
    for name in ["θ", "θ₀"] {
        ring.angle(name);
    }
    let lambda = ring.symbol("λ");
    for name in ["θ", "θ₀"] {
        let u = ring.half_tangent(name)?;
        ring.power(&u, &lambda)?;
    }
    Ok(ring)
}

fn prove(
    title: &str,
    rests_on: &Statement,
    steps: impl FnOnce(&mut Prover<'_>) -> Result<(), Obstacle>,
) -> Proof {
    match ring() {
        Err(error) => Proof::impossible(title, error),
        Ok(ring) => Proof::of(title, &ring, |p| {
            given(p, &[&EQ74, &S3_REDUCTION, rests_on])?;
            p.note(
                "(74) is (1) with",
                "u for v, γ for A, b for μg, τ for t; λ = b/γ",
            );
            steps(p)
        }),
    }
}

/// Whether the formula says the same as the particle's, in the sphere's variables.
fn same(p: &mut Prover<'_>, formula: Components, particle: Expr) -> Result<(), Obstacle> {
    let particle = p.read("The particle's formula", particle)?;
    for formula in formula {
        p.reads_as(&particle, "the formula", formula)?;
    }
    Ok(())
}

pub const EQ81: Vectorial =
    Vectorial::new(Within, AS_A_PARTICLE, paper::eq81_slip::parts, |formula| {
        let [lambda, u0, theta0, theta] = Expr::symbols(["λ", "u₀", "θ₀", "θ"]);
        prove("(81): u at the angle θ", &constant::EQ11, |p| {
            same(p, formula, particle::eq11_speed(lambda, u0, theta0, theta))
        })
    });

pub const EQ82: Vectorial =
    Vectorial::new(Printed, AS_A_PARTICLE, paper::eq82_time::parts, prove_eq82);

pub const CORRECTED_82: Vectorial =
    Vectorial::new(Corrected, AS_A_PARTICLE, corrected::time::parts, prove_eq82);

fn prove_eq82(formula: Components) -> Proof {
    let [lambda, gamma, u0, theta0, theta] = Expr::symbols(["λ", "γ", "u₀", "θ₀", "θ"]);
    prove("(82): τ at the angle θ", &constant::EQ13, |p| {
        same(
            p,
            formula,
            particle::eq13_time(lambda, gamma, u0, theta0, theta),
        )
    })
}

pub const EQ83: Vectorial = Vectorial::new(
    Printed,
    AS_A_PARTICLE,
    paper::eq83_slip_at_time::parts,
    prove_eq83,
);

pub const CORRECTED_83: Vectorial = Vectorial::new(
    Corrected,
    AS_A_PARTICLE,
    corrected::slip_at_time::parts,
    prove_eq83,
);

fn prove_eq83(formula: Components) -> Proof {
    let [lambda, gamma, u0, theta0, theta, tau] = Expr::symbols(["λ", "γ", "u₀", "θ₀", "θ", "τ"]);
    prove(
        "(83): u at the angle θ and the time τ",
        &constant::EQ14,
        |p| {
            same(
                p,
                formula,
                particle::eq14_speed_at_time(lambda, gamma, u0, theta0, theta, tau),
            )
        },
    )
}
