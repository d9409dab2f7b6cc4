//! The quasi-fixed points (124) and (125), and their stability.

use super::{Setting, Vectorial, prove};
use crate::claims::turntable::prelude::*;
use crate::exact::Node;
use crate::paper::turntable as paper;

/// A formula with the angle q wherever it has an arcsine, and what that is the arcsine of.
pub(super) fn name_arcsine(formula: Expr) -> (Expr, Option<Expr>) {
    use crate::exact::Function;
    match formula.node() {
        Node::Call(Function::Asin, of) => (symbol("q"), Some(of)),
        Node::Call(f, x) => {
            let (x, of) = name_arcsine(x);
            (Expr::new(Node::Call(f, x)), of)
        }
        Node::Neg(x) => {
            let (x, of) = name_arcsine(x);
            (-x, of)
        }
        Node::Binary(op, x, y) => {
            let (x, in_x) = name_arcsine(x);
            let (y, in_y) = name_arcsine(y);
            (Expr::new(Node::Binary(op, x, y)), in_x.or(in_y))
        }
        Node::Int(_) | Node::Pi | Node::Symbol(_) => (formula, None),
    }
}

/// Puts in the half tangent of q, the arcsine of a formula in α.
fn with_arcsine(p: &mut Prover<'_>, x: &Rational, sine: Expr) -> Result<Rational, Obstacle> {
    let ring = p.ring();
    let sine = p.read("The sine of q", sine)?;
    let one = Rational::int(1);
    let squared = ring.normal(&(&one - &sine * &sine));
    // q lies between −π/2 and π/2, where the cosine is the positive root.
    let double = 2 * symbol("α");
    let cosine = p.read("The cosine of q", 1 / double.cosh())?;
    p.equal("Its square is 1 − sin² q", &(&cosine * &cosine), &squared)?;
    let tangent = p.quotient("tan(q/2) = sin q/(1 + cos q)", &sine, &(&one + &cosine))?;
    let value = ring.put(&ring.normal(x), &[(&ring.half_tangent("q")?, &tangent)])?;
    p.note("With that", ring.text(&value));
    Ok(value)
}

/// A function of α and ψ at the angle ψ that a formula with an arcsine gives.
fn at_angle(p: &mut Prover<'_>, f: Expr, angle: Expr) -> Result<Rational, Obstacle> {
    let (angle, sine) = name_arcsine(angle);
    let value = p.read("At the angle, with q for the arcsine", f.with("ψ", angle))?;
    sine.map_or(Ok(value.clone()), |sine| with_arcsine(p, &value, sine))
}

const ZERO: Compared = Compared::one(
    "(115)",
    "a product of which one factor is zero at this angle, and the other one at the other",
);
pub(crate) const EQ124: Vectorial =
    Vectorial::new(Printed, ZERO, paper::eq124_psi1::parts, |printed| {
        let [first, _] = factors();
        prove_zero(printed[0], first)
    });

/// Each is zero once in a turn.
fn factors() -> [Expr; 2] {
    let [psi, q] = symbols(["ψ", "q"]);
    [((psi - q) / 2).sin(), ((psi + q) / 2).cos()]
}

fn prove_zero(printed: Expr, factor: Expr) -> Proof {
    let title = "(115) is zero at a quasi-fixed point";
    prove(title, Setting::fixed(), |p, _| {
        let (angle, sine) = name_arcsine(printed);
        p.remark("Let q be the arcsine in the formula");
        p.vanishes("A factor at the angle", factor.with("ψ", angle))?;
        let [first, second] = factors();
        let double = 2 * symbol("α");
        let product = -(4 * double.coth() * first * second);
        let product = p.read("With the other factor, each zero once in a turn", product)?;
        let sine = sine.ok_or(Obstacle::Empty)?;
        let product = with_arcsine(p, &product, sine)?;
        p.reads_as(&product, "which is (115)", paper::eq115_psi_rate::tree())
    })
}

fn prove_slope(printed: Vec<Expr>) -> Proof {
    let title = "the slope of (115) at its zeros, α held fixed";
    prove(title, Setting::fixed(), |p, _| {
        let [alpha, psi] = symbols(["α", "ψ"]);
        let expected = 2 / (2 * alpha).sinh();
        let read = p.read("(115)", printed[0])?;
        let found = p.slope("Its derivative with respect to ψ", &read, "ψ")?;
        // The same derivative as a tree, to be taken at an angle.
        let tree = -(2 * psi.cos() * (2 * alpha).coth());
        let as_tree = p.read("The same, written out", tree)?;
        p.equal("They are the same", &found, &as_tree)?;
        let angles = [paper::eq124_psi1::tree(), paper::eq125_psi2::tree()];
        for (name, angle, sign) in [("ψ₁", angles[0], -1), ("ψ₂", angles[1], 1)] {
            p.note("At", name);
            let rate = at_angle(p, printed[0], angle)?;
            p.zero("There dψ/dτ is 0", &rate)?;
            let value = at_angle(p, tree, angle)?;
            let rate = p.read("The rate expected", int(sign) * expected)?;
            p.equal("The slope is that", &value, &rate)?;
        }
        Ok(())
    })
}

attempts![
    &EQ124,
    &EQ125 = Vectorial::new(Printed, ZERO, paper::eq125_psi2::parts, |printed| {
        let [_, second] = factors();
        prove_zero(printed[0], second)
    }),
    &S4_QUASI_FIXED_STABILITY = Vectorial::new(
        Within,
        Compared::many(
            r"the slopes of (115) at $\psi_1$ and $\psi_2$",
            r"$-2/\sinh2\alpha$ and $2/\sinh2\alpha$",
        ),
        paper::eq115_psi_rate::parts,
        prove_slope,
    ),
];
