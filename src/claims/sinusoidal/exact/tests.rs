//! Which signs of the velocity the proofs try.

use super::*;

#[test]
fn both_signs_of_the_velocity_are_tried() {
    let signs = |proof: Proof, sign: &str| {
        proof
            .to_string()
            .contains(&format!("The velocity's sign: {sign}\n"))
    };
    assert!(signs(EQ26.proof(), "-1") && signs(DEFINITIONS.proof(), "1"));
    assert!(!signs(DEFINITIONS.proof(), "-1"));
}

/// What vanishes for one sign of 𝔴 only is wrong for the other.
#[test]
fn eq26_is_proved_for_both_signs() {
    let w = Expr::symbol("𝔴");
    let size = w.squared().sqrt();
    for wrong in [size + w, size - w] {
        let (units, rate) = (EQ26.formulas)();
        assert!((EQ26.prove)((units, rate)).holds());
        assert!(!(EQ26.prove)((units, rate + wrong)).holds());
    }
}
