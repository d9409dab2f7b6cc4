//! How proofs read.

use super::*;

#[test]
fn a_proof_reads_as_steps() {
    let text = EQ9.proof().to_string();
    assert!(
        text.contains("The printed rate: (λ − cos(θ))/sin(θ); in normal form: "),
        "{text}"
    );
    assert!(text.ends_with("Shown.\n"), "{text}");
    let wrong = (EQ9.prove)(-(EQ9.formulas)()).to_string();
    assert!(
        wrong.contains("Not proved: The rate by (1) is the printed one: the difference is "),
        "{wrong}"
    );
}

#[test]
fn the_component_along_x_is_the_speed_times_the_cosine() {
    let proof = EQ18.proof();
    let step = proof.steps().iter().find(|step| step.says == "v_x");
    let gives = &step.unwrap().gives;
    assert!(gives.contains("^λ cos(θ) = "), "{gives}");
}
