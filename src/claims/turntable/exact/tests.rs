//! Every proof holds, and fails for every formula that differs in one place and is not the same in value.

use super::*;
use crate::exact::{Rational, mutations};
use crate::scalar::Scalar;

#[test]
fn every_statement_is_proved() {
    for statement in ALL {
        let proof = statement.proof();
        assert!(proof.holds(), "{proof}");
    }
}

#[test]
fn what_lacks_the_friction_coefficient_is_not_proved() {
    for proof in [PRINTED_106.proof(), PRINTED_WORK.proof()] {
        let text = proof.to_string();
        assert!(!proof.holds() && text.contains("Not proved"), "{text}");
        assert!(matches!(proof.obstacle(), Some(Obstacle::NotZero { .. })));
    }
}

/// Whether a mutant says the same as the printed formula: decided by comparison in the ring. An unreadable one
/// does not.
fn says_the_same(statement: &Law, ours: Expr, theirs: Expr) -> bool {
    let compare = || -> Result<bool, ExactError> {
        let setting = (statement.setting.setting)()?;
        let ring = &setting.ring;
        let [(ours_by_q, of), (theirs_by_q, other)] = [ours, theirs].map(fixed::name_arcsine);
        if of.is_some() {
            // Angles: they are the same if sine and cosine are.
            let apart = (ours_by_q - theirs_by_q) / Expr::int(2);
            return Ok(of == other && ring.is_zero(&ring.read(apart.sin())?)?);
        }
        let (ours, theirs) = (ring.read(ours)?, ring.read(theirs)?);
        if !statement.setting.invariant {
            return ring.is_zero(&(ours - theirs));
        }
        // A multiple of what keeps its value keeps it too; here only small whole ones can come up.
        for k in [-2, -1, 1, 2].map(Rational::int) {
            if ring.is_zero(&(&ours * &k - &theirs))? {
                return Ok(true);
            }
        }
        Ok(false)
    };
    compare() == Ok(true)
}

#[test]
fn every_mutant_fails_that_differs_in_value() {
    let (mut refuted, mut unreadable, mut same) = (0, 0, 0);
    for statement in ALL {
        let printed = (statement.formulas)();
        for place in 0..printed.len() {
            for mutation in mutations(printed[place]) {
                let mut formulas = printed.clone();
                formulas[place] = mutation.formula;
                let proof = (statement.prove)(formulas);
                let expected = says_the_same(statement, printed[place], mutation.formula);
                let who = format!("{}: {}", mutation.change, mutation.formula);
                assert_eq!(proof.holds(), expected, "{who}\n{proof}");
                match proof.obstacle() {
                    None => same += 1,
                    Some(Obstacle::NotZero { .. }) => refuted += 1,
                    Some(_) => unreadable += 1,
                }
            }
        }
    }
    println!("{refuted} mutants refuted, {unreadable} outside the ring, {same} the same in value");
    assert!(refuted > 300, "too few mutants are refuted: {refuted}");
}

#[test]
fn an_arcsine_is_named_wherever_it_stands() {
    let [q, s, t] = ["q", "s", "t"].map(Expr::symbol);
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
