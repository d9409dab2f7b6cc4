//! What is not proved, and how an arcsine is read.

use super::*;
use crate::scalar::Scalar;

#[test]
fn what_lacks_the_friction_coefficient_is_not_proved() {
    for proof in [PRINTED_106.proof(), PRINTED_WORK.proof()] {
        let text = proof.to_string();
        assert!(!proof.holds() && text.contains("Not proved"), "{text}");
        assert!(matches!(proof.obstacle(), Some(Obstacle::NotZero { .. })));
    }
}

#[test]
fn an_arcsine_is_named_wherever_it_stands() {
    let [q, s, t] = Expr::symbols(["q", "s", "t"]);
    for (formula, named) in [
        (s.asin(), q),
        (-s.asin(), -q),
        (Expr::pi() - s.asin(), Expr::pi() - q),
        ((-s.asin()).cos() * t, (-q).cos() * t),
    ] {
        assert_eq!(fixed::name_arcsine(formula), (named, Some(s)), "{formula}");
    }
    assert_eq!(fixed::name_arcsine(-t), (-t, None));
}
