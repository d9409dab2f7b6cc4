//! Work and energy: (103), (104), (106) as printed and corrected, the powers of the forces.

use super::{Setting, prove, vectors};
use crate::corrections::turntable as corrections;
use crate::paper::turntable as paper;
use trialbook::prelude::*;

pub(super) fn eq103() -> Vec<Expr> {
    let [p, rho] = Expr::symbols(["p", "ρ"]);
    vec![paper::eq103_energy(p, rho), paper::eq103_energy_rate(p)]
}

pub(super) fn prove_eq103(printed: Vec<Expr>) -> Proof {
    prove(
        "(103): d[(p² − ρ²)/2]/dτ",
        Setting::polar(),
        |p, setting| {
            let energy = p.read("The printed energy", printed[0])?;
            let rate = p.derivative("Its rate by (89)", &energy, &setting.motion)?;
            let printed = p.read("The printed rate", printed[1])?;
            p.equal("Rate by (89) against printed rate", &rate, &printed)
        },
    )
}

pub(super) fn eq104() -> Vec<Expr> {
    let [p, rho, s] = Expr::symbols(["p", "ρ", "s"]);
    vec![paper::eq104_constant(p, rho, s)]
}

/// The formula keeps its value and depends on the state.
fn keeps_its_value(
    title: &str,
    setting: Result<Setting, crate::exact::ExactError>,
    formula: Expr,
) -> Proof {
    prove(title, setting, |p, setting| {
        let value = p.read("The expression", formula)?;
        let slope = p.slope("Its change with s alone", &value, "s")?;
        if slope.is_literally_zero() {
            // Without the work it could be any number; that would say nothing about the motion.
            return p.equal(
                "It must depend on s",
                &slope,
                &crate::exact::Rational::int(1),
            );
        }
        let rate = p.derivative("Its rate along the motion", &value, &setting.motion)?;
        p.zero("The rate", &rate)
    })
}

pub(super) fn prove_eq104(printed: Vec<Expr>) -> Proof {
    keeps_its_value(
        "(104): an expression keeps its value",
        Setting::polar(),
        printed[0],
    )
}

pub(super) fn printed_106() -> Vec<Expr> {
    let [m, g, omega, s] = Expr::symbols(["m", "g", "Ω", "s"]);
    let [r, v] = vectors();
    vec![paper::eq106_constant(m, g, omega, r, v, s)]
}

pub(super) fn corrected_106() -> Vec<Expr> {
    let [m, mu, g, omega, s] = Expr::symbols(["m", "μ", "g", "Ω", "s"]);
    let [r, v] = vectors();
    vec![corrections::constant(m, mu, g, omega, r, v, s)]
}

pub(super) fn prove_106(formula: Vec<Expr>) -> Proof {
    let title = "(106): an energy keeps its value";
    keeps_its_value(title, Setting::dimensional(), formula[0])
}

pub(super) fn printed_works() -> Vec<Expr> {
    let [m, g, s] = Expr::symbols(["m", "g", "s"]);
    vec![paper::friction_work(m, g, s)]
}

pub(super) fn works() -> Vec<Expr> {
    let [m, mu, g, s] = Expr::symbols(["m", "μ", "g", "s"]);
    vec![corrections::friction_work(m, mu, g, s)]
}

/// Of the forces in (86), the Coriolis force has no power, and friction that by which the given work grows.
pub(super) fn prove_works(work: Vec<Expr>) -> Proof {
    let title = "the works of the Coriolis force and of friction";
    prove(title, Setting::dimensional(), |p, setting| {
        let [omega, mu, g, m] = Expr::symbols(["Ω", "μ", "g", "m"]);
        let [r, v] = vectors();
        let zero = Expr::int(0);
        let power = |[ax, ay]: [Expr; 2]| m * (ax * v[0] + ay * v[1]);
        // On the axis and without friction the Coriolis force is alone.
        let coriolis = power(paper::eq86_acceleration(omega, zero, g, [zero; 2], v));
        let coriolis = p.read("The power of the Coriolis force", coriolis)?;
        p.reads_as(&coriolis, "", Expr::int(0))?;
        let smooth = power(paper::eq86_acceleration(omega, zero, g, r, v));
        let rough = power(paper::eq86_acceleration(omega, mu, g, r, v));
        let friction = p.read("The power of friction", rough - smooth)?;
        let work = p.read("The work along the way s", work[0])?;
        let rate = p.derivative("Its rate", &work, &setting.motion)?;
        p.equal("Against the power of friction", &rate, &friction)
    })
}
