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
