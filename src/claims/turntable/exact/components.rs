//! The motion by p, ℓ, ξ and by p, ρ, ψ: (96) to (102), (107) to (109).

use super::{Setting, prove, vectors};
use crate::corrections::turntable as corrected;
use crate::exact::{Expr, Proof};
use crate::paper::turntable as paper;

/// The printed rate of something against its rate by (89).
fn rate(title: &str, of: &'static str, printed: &[Expr]) -> Proof {
    prove(title, Setting::polar(), |p, setting| {
        let own = p.ring().named(of)?;
        let found = p.derivative("Its rate by (89)", &own, &setting.motion)?;
        let printed = p.read("The printed rate", printed[0])?;
        p.equal("Rate by (89) against printed rate", &found, &printed)
    })
}

/// Two sides of an equation.
fn sides(title: &str, printed: &[Expr]) -> Proof {
    prove(title, Setting::polar(), |p, _| {
        let left = p.read("The left-hand side", printed[0])?;
        let right = p.read("The right-hand side", printed[1])?;
        p.equal("They are the same", &left, &right)
    })
}

pub(super) fn eq96() -> Vec<Expr> {
    let [p, ell] = Expr::symbols(["p", "ℓ"]);
    let [position, rate] = vectors();
    paper::eq96_angular_momentum(p, ell, position, rate).into()
}

pub(super) fn prove_eq96(printed: Vec<Expr>) -> Proof {
    sides("(96), with (95)", &printed)
}

pub(super) fn eq97() -> Vec<Expr> {
    let [p, xi] = Expr::symbols(["p", "ξ"]);
    let [position, rate] = vectors();
    paper::eq97_radial(p, xi, position, rate).into()
}

pub(super) fn prove_eq97(printed: Vec<Expr>) -> Proof {
    sides("(97), with (94)", &printed)
}

pub(super) fn eq98() -> Vec<Expr> {
    let [ell, xi] = Expr::symbols(["ℓ", "ξ"]);
    paper::eq98_distance(vectors()[0], ell, xi).into()
}

pub(super) fn prove_eq98(printed: Vec<Expr>) -> Proof {
    sides("(98), with (94) and (95)", &printed)
}

pub(super) fn eq99() -> Vec<Expr> {
    vec![paper::eq99_p_rate(Expr::symbol("ξ"))]
}

pub(super) fn prove_eq99(printed: Vec<Expr>) -> Proof {
    rate("(99): dp/dτ", "p", &printed)
}

pub(super) fn eq100() -> Vec<Expr> {
    let [p, ell, xi] = Expr::symbols(["p", "ℓ", "ξ"]);
    vec![paper::eq100_ell_rate(p, ell, xi)]
}

pub(super) fn prove_eq100(printed: Vec<Expr>) -> Proof {
    rate("(100): dℓ/dτ", "ℓ", &printed)
}

pub(super) fn eq101() -> Vec<Expr> {
    let [p, ell] = Expr::symbols(["p", "ℓ"]);
    vec![paper::eq101_xi_rate(p, ell)]
}

pub(super) fn prove_eq101(printed: Vec<Expr>) -> Proof {
    rate("(101): dξ/dτ", "ξ", &printed)
}

pub(super) fn tangential() -> Vec<Expr> {
    let [position, rate] = vectors();
    vec![paper::s4_tangential_rate(position, rate)]
}

pub(super) fn prove_tangential(printed: Vec<Expr>) -> Proof {
    rate("dp/dτ, by (89) on the velocity", "p", &printed)
}

pub(super) fn azimuthal() -> Vec<Expr> {
    let [p, ell, xi] = Expr::symbols(["p", "ℓ", "ξ"]);
    vec![corrected::azimuthal_rate(p, ell, xi)]
}

pub(super) fn prove_azimuthal(corrected: Vec<Expr>) -> Proof {
    rate("dℓ/dτ, by the angular momentum and dp/dτ", "ℓ", &corrected)
}

pub(super) fn radial() -> Vec<Expr> {
    let [p, ell, xi] = Expr::symbols(["p", "ℓ", "ξ"]);
    vec![corrected::radial_rate(p, ell, xi)]
}

pub(super) fn prove_radial(corrected: Vec<Expr>) -> Proof {
    rate("dξ/dτ, by the radius and dp/dτ", "ξ", &corrected)
}

pub(super) fn eq102() -> Vec<Expr> {
    let [ell, xi, p] = [["ℓ", "dℓ/dτ"], ["ξ", "dξ/dτ"], ["p", "dp/dτ"]].map(Expr::symbols);
    paper::eq102_rate(ell, xi, p).into()
}

pub(super) fn prove_eq102(printed: Vec<Expr>) -> Proof {
    prove("(102): ρ dρ/dτ", Setting::polar(), |p, setting| {
        let rho = p.ring().named("ρ")?;
        let rate = p.derivative("dρ/dτ by (89)", &rho, &setting.motion)?;
        for formula in printed {
            let printed = p.read("A printed expression", formula)?;
            p.equal("Against ρ dρ/dτ", &printed, &(&rho * &rate))?;
        }
        Ok(())
    })
}

pub(super) fn eq107() -> Vec<Expr> {
    let [rho, psi] = Expr::symbols(["ρ", "ψ"]);
    vec![paper::eq107_p_rate(rho, psi)]
}

pub(super) fn prove_eq107(printed: Vec<Expr>) -> Proof {
    rate("(107): dp/dτ", "p", &printed)
}

pub(super) fn eq108() -> Vec<Expr> {
    let [p, psi] = Expr::symbols(["p", "ψ"]);
    vec![paper::eq108_rho_rate(p, psi)]
}

pub(super) fn prove_eq108(printed: Vec<Expr>) -> Proof {
    rate("(108): dρ/dτ", "ρ", &printed)
}

pub(super) fn eq109() -> Vec<Expr> {
    let [p, rho, psi] = Expr::symbols(["p", "ρ", "ψ"]);
    vec![paper::eq109_psi_rate(p, rho, psi)]
}

pub(super) fn prove_eq109(printed: Vec<Expr>) -> Proof {
    rate("(109): dψ/dτ", "ψ", &printed)
}
