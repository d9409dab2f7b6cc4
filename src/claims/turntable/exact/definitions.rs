//! The definitions (93) to (95), (110) to (112), (116) to (118), by what they have to be consistent with.

use super::{Setting, prove, vectors};
use crate::paper::turntable as paper;
use trialbook::prelude::*;

/// A formula against what it has to be.
fn is(
    title: &str,
    setting: Result<Setting, ExactError>,
    printed: Expr,
    (says, expected): (&str, Expr),
) -> Proof {
    prove(title, setting, |p, _| {
        p.identity(("The printed formula", printed), (says, expected))
    })
}

fn speed() -> Expr {
    Expr::symbol("p")
}

pub(super) fn eq93() -> Vec<Expr> {
    vec![paper::eq93_speed(vectors()[1])]
}
pub(super) fn prove_eq93(printed: Vec<Expr>) -> Proof {
    let expected = ("the size of the velocity p (cos χ, sin χ)", speed());
    is("(93): p", Setting::polar(), printed[0], expected)
}

pub(super) fn eq94() -> Vec<Expr> {
    let [rho, psi] = Expr::symbols(["ρ", "ψ"]);
    vec![paper::eq94_xi(rho, psi)]
}
pub(super) fn prove_eq94(printed: Vec<Expr>) -> Proof {
    let [[x, y], [u, v]] = vectors();
    let along = (x * u + y * v) / speed();
    let expected = ("the position along the velocity", along);
    is("(94): ξ", Setting::polar(), printed[0], expected)
}

pub(super) fn eq95() -> Vec<Expr> {
    let [rho, psi] = Expr::symbols(["ρ", "ψ"]);
    vec![paper::eq95_ell(rho, psi)]
}
pub(super) fn prove_eq95(printed: Vec<Expr>) -> Proof {
    let [[x, y], [u, v]] = vectors();
    let across = (x * v - y * u) / speed();
    let expected = ("the moment of the velocity about the axis, over p", across);
    is("(95): ℓ", Setting::polar(), printed[0], expected)
}

/// The sum and the difference of two of the formulas are `size` × exp(±`argument`).
fn sums(
    p: &mut Prover<'_>,
    [larger, smaller]: [Expr; 2],
    [size, argument]: [Expr; 2],
) -> Result<(), Obstacle> {
    for (says, sum, sign) in [
        ("The sum of the two", larger + smaller, 1),
        ("The difference of the two", larger - smaller, -1),
    ] {
        let expected = size * (Expr::int(sign) * argument).exp();
        p.identity((says, sum), ("as it should be", expected))?;
    }
    Ok(())
}

pub(super) fn eq110() -> Vec<Expr> {
    let [p, rho] = Expr::symbols(["p", "ρ"]);
    vec![paper::eq110_case(p, rho)]
}
pub(super) fn prove_eq110(printed: Vec<Expr>) -> Proof {
    let expected = ("negative", -Expr::symbol("A").squared());
    is(
        "(110): with (111) and (112)",
        Setting::slower(),
        printed[0],
        expected,
    )
}

pub(super) fn eq111() -> Vec<Expr> {
    let [a, alpha] = Expr::symbols(["A", "α"]);
    vec![paper::eq111_p(a, alpha)]
}
pub(super) fn prove_eq111(printed: Vec<Expr>) -> Proof {
    prove("(111): ρ ± p = A exp(±α)", Setting::slower(), |p, _| {
        sums(p, [eq112()[0], printed[0]], Expr::symbols(["A", "α"]))
    })
}

pub(super) fn eq112() -> Vec<Expr> {
    let [a, alpha] = Expr::symbols(["A", "α"]);
    vec![paper::eq112_rho(a, alpha)]
}
pub(super) fn prove_eq112(printed: Vec<Expr>) -> Proof {
    prove("(112): ρ ± p = A exp(±α)", Setting::slower(), |p, _| {
        sums(p, [printed[0], eq111()[0]], Expr::symbols(["A", "α"]))
    })
}

pub(super) fn eq116() -> Vec<Expr> {
    let [p, rho] = Expr::symbols(["p", "ρ"]);
    vec![paper::eq116_case(p, rho)]
}
pub(super) fn prove_eq116(printed: Vec<Expr>) -> Proof {
    let expected = ("positive", Expr::symbol("B").squared());
    is(
        "(116): with (117) and (118)",
        Setting::faster(),
        printed[0],
        expected,
    )
}

pub(super) fn eq117() -> Vec<Expr> {
    let [b, beta] = Expr::symbols(["B", "β"]);
    vec![paper::eq117_p(b, beta)]
}
pub(super) fn prove_eq117(printed: Vec<Expr>) -> Proof {
    prove("(117): p ± ρ = B exp(±β)", Setting::faster(), |p, _| {
        sums(p, [printed[0], eq118()[0]], Expr::symbols(["B", "β"]))
    })
}

pub(super) fn eq118() -> Vec<Expr> {
    let [b, beta] = Expr::symbols(["B", "β"]);
    vec![paper::eq118_rho(b, beta)]
}
pub(super) fn prove_eq118(printed: Vec<Expr>) -> Proof {
    prove("(118): p ± ρ = B exp(±β)", Setting::faster(), |p, _| {
        sums(p, [eq117()[0], printed[0]], Expr::symbols(["B", "β"]))
    })
}
