//! Which signs of the velocity the proofs try.

use super::*;

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
