//! Every proof holds, and fails for every formula that differs in one place and is not the same in value.

use super::*;
use crate::exact::mutations;

fn number(name: &str) -> Option<f64> {
    Some(match name {
        "σ" => 0.37,
        "α" => 0.11,
        "ψ" => 0.53,
        "c" => 0.71,
        "τ" => 1.3,
        "slope" => 0.9,
        _ => return None,
    })
}

/// How many changed formulas are refuted, all of those that have another value.
fn refuted(formula: Expr, prove: &dyn Fn(Expr) -> Proof) -> usize {
    let proof = prove(formula);
    assert!(proof.holds(), "{proof}");
    let ours = formula.evaluate(&number).expect("all symbols have values");
    let differs = |mutant: Expr| {
        let theirs = mutant.evaluate(&number).expect("the same symbols");
        let same = (ours - theirs).abs() < 1e-12;
        assert_eq!(prove(mutant).holds(), same, "{mutant} for {formula}");
        !same
    };
    let mutants = mutations(formula).into_iter();
    mutants.filter(|mutant| differs(mutant.formula)).count()
}

#[test]
fn all_are_proved_and_no_changed_formula_is() {
    let [sigma, alpha, psi, tau, slope] = symbols(["σ", "α", "ψ", "τ", "slope"]);
    let left142 = printed::eq142_left(sigma, slope);
    let right142 = printed::eq142_right(alpha, psi);
    let left144 = printed::eq144_left(sigma, slope);
    let right144 = printed::eq144_right(alpha);
    type Statement = (Expr, Box<dyn Fn(Expr) -> Proof>);
    let statements: Vec<Statement> = vec![
        (printed::eq139_largest_sigma(), Box::new(eq139)),
        (printed::eq140_alpha_rate(sigma), Box::new(near::eq140)),
        (printed::eq141_alpha(sigma, tau), Box::new(near::eq141)),
        (left142, Box::new(move |x| near::eq142([x, right142]))),
        (right142, Box::new(move |x| near::eq142([left142, x]))),
        (left144, Box::new(move |x| near::eq144([x, right144]))),
        (right144, Box::new(move |x| near::eq144([left144, x]))),
        (printed::eq145_a(sigma, alpha), Box::new(near::eq145)),
        (printed::eq146_right(sigma, alpha), Box::new(eq146)),
        (printed::eq147_a(alpha), Box::new(eq147)),
        (boundary::stated(), Box::new(|x| boundary::prove(x, 2))),
    ];
    let counts = statements
        .iter()
        .map(|(formula, prove)| refuted(*formula, prove));
    let refuted: usize = counts.sum();
    assert!(refuted > 200, "{refuted}");
}

#[test]
fn the_free_constant_is_free_and_nothing_else_is() {
    let [sigma, alpha, c] = symbols(["σ", "α", "c"]);
    let formula = printed::eq143_psi(sigma, c, alpha);
    assert!(near::eq143(formula).holds(), "{}", near::eq143(formula));
    for mutation in mutations(formula) {
        let proof = near::eq143(mutation.formula);
        let number = |name: &str| number(name);
        let same = formula
            .evaluate(&number)
            .zip(mutation.formula.evaluate(&number));
        let same = same.is_some_and(|(x, y)| (x - y).abs() < 1e-12);
        assert_eq!(proof.holds(), same, "{}\n{proof}", mutation.change);
    }
}

#[test]
fn the_printed_envelope_is_not_the_boundary() {
    let proof = boundary::prove(printed::eq147_a(Expr::symbol("α")), 1);
    assert!(
        matches!(proof.obstacle(), Some(Obstacle::NotZero { .. })),
        "{proof}"
    );
}

#[test]
fn the_boundary_is_told_by_the_coefficients_that_are_stated() {
    let proof = boundary::prove(boundary::stated(), 2);
    let step = |says: &str| {
        let found = proof.steps().iter().find(|step| step.says == says);
        found.unwrap().gives.as_str()
    };
    // f₂ = 7/6 c⁴ + 2 c³ s − c² s² + 2/3 c s³ − 1/4 s⁴, c and s being the cosine and the sine of ψ/2.
    let second = step("At the order α^1");
    assert_eq!(second, "x₁ = 2, x₂ = −1, x₃ = 2/3, x₄ = −1/4");
    assert!(step("At the order α^2").ends_with("before = 7/6"));
    assert_eq!(step("F₁"), "−1/(tan(ψ/2)^2 + 1)");
}
