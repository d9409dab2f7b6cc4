//! What the proofs about the boundary show.

use super::*;

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
    let steps = || {
        proof
            .premises()
            .into_iter()
            .flat_map(|premise| premise.steps())
    };
    let step = |says: &str| {
        let found = steps().find(|step| step.says == says);
        found.unwrap().gives.as_str()
    };
    // f₂ = 7/6 c⁴ + 2 c³ s − c² s² + 2/3 c s³ − 1/4 s⁴, c and s being the cosine and the sine of ψ/2.
    let second = step("At the order α^1");
    assert_eq!(second, "x₁ = 2, x₂ = −1, x₃ = 2/3, x₄ = −1/4");
    assert!(step("At the order α^2").ends_with("a′ = 7/6"));
    assert_eq!(step("F₁"), "−1/(tan(ψ/2)^2 + 1)");
}
