//! Constant acceleration, (81) to (83): (74) is (1) with γ for A, b for μg and τ for t, so that (11), (13) and (14)
//! say what has to be proved.

use super::{AS_A_PARTICLE, Components, EQ74, S3_REDUCTION, Vectorial};
use crate::claims::constant::exact as constant;
use crate::claims::sphere::prelude::*;
use crate::paper::constant as particle;
use crate::paper::general::eq1_velocity_rate;
use crate::paper::sphere as paper;

/// The ring of both sets of letters, with the powers of the half tangents of angles of a sign.
fn ring(sign: i64) -> Result<Ring, ExactError> {
    let mut ring = Ring::of(["γ", "u₀", "τ", "A", "v₀", "t"]);
    let u = ring.symbol("u");
    ring.root_is(&(&u * &u), 2, &u)?;
    let lambda = ring.symbol("λ");
    for name in ["θ", "θ₀"] {
        ring.angle(name);
        let u = ring.half_tangent(name)? * Rational::int(sign);
        ring.power(&u, &lambda)?;
    }
    Ok(ring)
}

/// Whether the formula says the same as the particle's, with the sphere's letters put in.
fn prove(title: &str, formula: &[Expr], rests_on: &Statement, particle: Expr) -> Proof {
    Proof::for_both_signs(|sign| {
        Proof::in_ring(title, ring(sign), |p| {
            rest_on(p, &[&EQ74, &S3_REDUCTION, rests_on])?;
            p.note("The sign of both angles", sign.to_string());
            let ring = p.ring();
            let names = [("A", "γ"), ("v₀", "u₀"), ("t", "τ")];
            let mut letters = Vec::new();
            for (own, ours) in names {
                letters.push((ring.named(own)?, ring.named(ours)?));
            }
            let values: Vec<_> = letters.iter().map(|(own, ours)| (own, ours)).collect();
            let [lambda, a, gamma, u, theta] = symbols(["λ", "A", "γ", "u", "θ"]);
            let (zero, one) = (int(0), int(1));
            let [x, y] = [u * theta.cos(), u * theta.sin()];
            let law = eq1_velocity_rate([-a, zero], lambda * a, one, [x, y]);
            let slip = paper::eq74_slip_rate(lambda * gamma, [-gamma, zero, zero], [x, y, zero]);
            for (law, slip) in law.into_iter().zip(slip) {
                let law = p.read("(1) with u for v and λA for μg", law)?;
                let law = ring.put(&law, &values)?;
                p.note("With γ for A, u₀ for v₀ and τ for t", ring.text(&law));
                p.reads_as(&law, "(74) with b = λγ", slip)?;
            }
            let own = p.read("The particle's formula", particle)?;
            let ours = ring.put(&own, &values)?;
            p.note("The same in the sphere's letters", ring.text(&ours));
            formula
                .iter()
                .try_for_each(|formula| p.reads_as(&ours, "the formula", *formula))
        })
    })
}

fn prove_eq82(formula: Components) -> Proof {
    let particle = particle::eq13_time::tree();
    prove(
        "(82): τ at the angle θ",
        &formula,
        &constant::EQ13,
        particle,
    )
}

fn prove_eq83(formula: Components) -> Proof {
    let particle = particle::eq14_speed_at_time::tree();
    let title = "(83): u at the angle θ and the time τ";
    prove(title, &formula, &constant::EQ14, particle)
}

attempts![
    &EQ81 = Vectorial::new(Within, AS_A_PARTICLE, paper::eq81_slip::parts, |formula| {
        let particle = particle::eq11_speed::tree();
        prove(
            "(81): u at the angle θ",
            &formula,
            &constant::EQ11,
            particle,
        )
    }),
    &EQ82 | &CORRECTED_82 = Vectorial::new(AS_A_PARTICLE)(
        (paper::eq82_time::parts, prove_eq82) | (corrected::time::parts, prove_eq82)
    ),
    &EQ83 | &CORRECTED_83 = Vectorial::new(AS_A_PARTICLE)(
        (paper::eq83_slip_at_time::parts, prove_eq83)
            | (corrected::slip_at_time::parts, prove_eq83)
    ),
];
