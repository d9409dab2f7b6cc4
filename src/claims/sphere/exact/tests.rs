//! Every proof holds, except the three misprints', and fails for every formula that differs in one place and in value.

use super::*;
use crate::exact::{Obstacle, Ring, mutations};

/// Printed forms that do not hold.
fn is_misprint(law: &Law) -> bool {
    [EQ75, EQ82, EQ83]
        .iter()
        .any(|misprint| misprint.place == law.place)
}

#[test]
fn every_statement_but_the_misprints_is_proved() {
    for law in ALL {
        let proof = law.proof();
        assert_eq!(proof.holds(), !is_misprint(law), "{proof}");
        if is_misprint(law) {
            let refuted = matches!(proof.obstacle(), Some(Obstacle::NotZero { .. }));
            assert!(refuted, "{proof}");
        }
    }
}

#[test]
fn every_mutant_fails_that_differs_in_value() {
    let (mut refuted, mut same) = (0, 0);
    for law in ALL.iter().filter(|law| !is_misprint(law)) {
        let ring = (law.setting)().expect("the ring can be set up");
        let printed = (law.formulas)();
        // One component of each vector: the others have the same form.
        for (i, component) in printed.iter().enumerate().take(1) {
            for mutation in mutations(*component) {
                let mut mutant = printed.clone();
                mutant[i] = mutation.formula;
                let proof = (law.prove)(mutant);
                let who = format!("{}: {}", mutation.change, mutation.formula);
                let says_the_same = if law.place == EQ79.place {
                    // It leaves a constant free: another one says the same.
                    differ_by_a_constant(&ring, *component, mutation.formula)
                } else {
                    let theirs = ring.read(mutation.formula);
                    let difference = theirs.and_then(|x| Ok(x - ring.read(*component)?));
                    difference.and_then(|d| ring.is_zero(&d)) == Ok(true)
                };
                assert_eq!(proof.holds(), says_the_same, "{who}\n{proof}");
                if says_the_same {
                    same += 1
                } else {
                    refuted += 1
                }
            }
        }
    }
    println!("{refuted} mutants refuted, {same} the same in value");
    assert!(refuted > 200, "too few mutants are refuted: {refuted}");
}

/// Whether two formulas have the same slopes along all that moves.
fn differ_by_a_constant(ring: &Ring, ours: Expr, theirs: Expr) -> bool {
    let moving = ["v_x", "v_y", "ω_x", "ω_y", "ν_x", "ν_y"];
    moving.iter().all(|name| {
        let slope = |x: Expr| ring.derivative(&ring.read(x)?, &ring.by(name)?);
        match (slope(ours), slope(theirs)) {
            (Ok(a), Ok(b)) => ring.is_zero(&(a - b)) == Ok(true),
            _ => false,
        }
    })
}

#[test]
fn vectors_are_added_component_by_component() {
    let [a, b, c] = ["a", "b", "c"].map(Expr::symbol);
    let sum = body::sum([a, b, c], [c, a, b]);
    assert_eq!(sum, [a + c, b + a, c + b]);
}
