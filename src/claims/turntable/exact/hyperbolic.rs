//! The motion by A, α and by B, β: (113) to (115), (119) to (121), and how the two go over into each other,
//! (122) and (123).

use super::{Setting, prove};
use crate::paper::turntable as paper;
use trialbook::prelude::*;

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
        p.equal("Rate by (89) against printed rate", &found, &printed)
    })
}

pub(super) fn eq113() -> Vec<Expr> {
    vec![paper::eq113_a_rate(Expr::symbol("α"))]
}

pub(super) fn prove_eq113(printed: Vec<Expr>) -> Proof {
    rate("(113): dA/dτ", Setting::slower(), "A", &printed)
}

pub(super) fn eq114() -> Vec<Expr> {
    let [a, alpha, psi] = Expr::symbols(["A", "α", "ψ"]);
    vec![paper::eq114_alpha_rate(a, alpha, psi)]
}

pub(super) fn prove_eq114(printed: Vec<Expr>) -> Proof {
    rate("(114): dα/dτ", Setting::slower(), "α", &printed)
}

pub(super) fn eq115() -> Vec<Expr> {
    let [alpha, psi] = Expr::symbols(["α", "ψ"]);
    vec![paper::eq115_psi_rate(alpha, psi)]
}

pub(super) fn prove_eq115(printed: Vec<Expr>) -> Proof {
    rate("(115): dψ/dτ", Setting::slower(), "ψ", &printed)
}

pub(super) fn eq119() -> Vec<Expr> {
    vec![paper::eq119_b_rate(Expr::symbol("β"))]
}

pub(super) fn prove_eq119(printed: Vec<Expr>) -> Proof {
    rate("(119): dB/dτ", Setting::faster(), "B", &printed)
}

pub(super) fn eq120() -> Vec<Expr> {
    let [b, beta, psi] = Expr::symbols(["B", "β", "ψ"]);
    vec![paper::eq120_beta_rate(b, beta, psi)]
}

pub(super) fn prove_eq120(printed: Vec<Expr>) -> Proof {
    rate("(120): dβ/dτ", Setting::faster(), "β", &printed)
}

pub(super) fn eq121() -> Vec<Expr> {
    let [beta, psi] = Expr::symbols(["β", "ψ"]);
    vec![paper::eq121_psi_rate(beta, psi)]
}

pub(super) fn prove_eq121(printed: Vec<Expr>) -> Proof {
    rate("(121): dψ/dτ", Setting::faster(), "ψ", &printed)
}

pub(super) fn eq122() -> Vec<Expr> {
    let [i, b] = Expr::symbols(["i", "B"]);
    vec![paper::eq122_a(i, b)]
}

pub(super) fn prove_eq122(printed: Vec<Expr>) -> Proof {
    continuation("(122), with (123)", printed[0], eq123()[0])
}

pub(super) fn eq123() -> Vec<Expr> {
    let [i, beta] = Expr::symbols(["i", "β"]);
    vec![paper::eq123_alpha(i, beta)]
}

pub(super) fn prove_eq123(printed: Vec<Expr>) -> Proof {
    continuation("(123), with (122)", eq122()[0], printed[0])
}

/// How far the multiples of iπ/2 and of β in (123) are looked for.
const MOST: i64 = 4;

/// exp(α/2) for α = n β + k iπ/2, by Euler's formula ζᵏ exp(β/2)ⁿ.
fn half_exponential(p: &mut Prover<'_>, alpha: &Rational) -> Result<Rational, Obstacle> {
    let ring = p.ring();
    let [i, beta] = Expr::symbols(["i", "β"]);
    let quarter = ring.read(i * Expr::pi() / Expr::int(2))?;
    let beta_element = ring.read(beta)?;
    for k in -MOST..=MOST {
        for n in -MOST..=MOST {
            let known = &quarter * &Rational::int(k) + &beta_element * &Rational::int(n);
            if ring.is_zero(&(alpha - &known))? {
                let zeta = Expr::symbol("ζ").pow(Expr::int(k));
                let half = (beta / Expr::int(2)).exp().pow(Expr::int(n));
                p.note("α, in terms of iπ/2 and β", format!("{k} iπ/2 + {n} β"));
                return p.read(
                    "exp(α/2), by Euler's formula with ζ = exp(iπ/4)",
                    zeta * half,
                );
            }
        }
    }
    Err(Obstacle::NotZero {
        says: "α must be a whole multiple of iπ/2 plus one of β".into(),
        normal_form: ring.text(alpha),
    })
}

/// (111) to (115) turn into (117) to (121).
fn continuation(title: &str, a: Expr, alpha: Expr) -> Proof {
    prove(title, Setting::continued(), |p, _| {
        let ring = p.ring();
        let [a_tree, alpha_tree, b, beta, psi, i] = Expr::symbols(["A", "α", "B", "β", "ψ", "i"]);
        let a = p.read("A", a)?;
        let alpha_element = p.read("α", alpha)?;
        let half = half_exponential(p, &alpha_element)?;
        let own = ring.read((alpha_tree / Expr::int(2)).exp())?;
        let own_a = ring.named("A")?;
        let ours = [(&own_a, &a), (&own, &half)];
        let mut same = |says: &str, inner: Expr, outer: Expr| -> Result<(), Obstacle> {
            let inner = ring.put(&ring.read(inner)?, &ours)?;
            let outer = ring.read(outer)?;
            p.equal(says, &inner, &outer)
        };
        same(
            "(111) becomes (117)",
            paper::eq111_p(a_tree, alpha_tree),
            paper::eq117_p(b, beta),
        )?;
        same(
            "(112) becomes (118)",
            paper::eq112_rho(a_tree, alpha_tree),
            paper::eq118_rho(b, beta),
        )?;
        // A is a fixed multiple of B, and α differs from β by a constant: so do their rates.
        let ratio = paper::eq122_a(i, Expr::int(1));
        same(
            "(113) becomes (119)",
            paper::eq113_a_rate(alpha_tree),
            ratio * paper::eq119_b_rate(beta),
        )?;
        same(
            "(114) becomes (120)",
            paper::eq114_alpha_rate(a_tree, alpha_tree, psi),
            paper::eq120_beta_rate(b, beta, psi),
        )?;
        same(
            "(115) becomes (121)",
            paper::eq115_psi_rate(alpha_tree, psi),
            paper::eq121_psi_rate(beta, psi),
        )
    })
}
