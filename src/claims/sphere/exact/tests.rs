//! Every proof holds, except the three misprints', and fails for every formula that differs in one place and in value.

use super::*;
use crate::exact::{Obstacle, Ring, mutations};

const MISPRINTS: [&str; 3] = ["eq-75", "eq-82", "eq-83"];

#[test]
fn every_statement_but_the_misprints_is_proved() {
    for statement in STATEMENTS {
        let proof = statement.proof();
        let misprint = MISPRINTS.contains(&statement.id);
        assert_eq!(proof.holds(), !misprint, "{}\n{proof}", statement.id);
        if misprint {
            let refuted = matches!(proof.obstacle(), Some(Obstacle::NotZero { .. }));
            assert!(refuted, "{}\n{proof}", statement.id);
        }
    }
}

fn rings(id: &str) -> Option<Ring> {
    match id {
        "eq-59" | "eq-60" => {
            let mut ring = Ring::new();
            for name in ["m", "A_x", "A_y", "F_x", "F_y", "R"] {
                ring.symbol(name);
            }
            Some(ring)
        }
        "eq-81" | "corrected-82" | "corrected-83" => angle::ring().ok(),
        _ => body::Body::sliding().ok().map(|body| body.ring),
    }
}

#[test]
fn every_mutant_fails_that_differs_in_value() {
    let (mut refuted, mut same) = (0, 0);
    for statement in STATEMENTS.iter().filter(|s| !MISPRINTS.contains(&s.id)) {
        let ring = rings(statement.id).expect("the ring can be set up");
        let printed = (statement.printed)();
        // One component of each vector: the others have the same form.
        for (i, component) in printed.iter().enumerate().take(1) {
            for mutation in mutations(*component) {
                let mut mutant = printed.clone();
                mutant[i] = mutation.formula;
                let proof = (statement.prove)(mutant);
                let who = format!(
                    "{}, {}: {}",
                    statement.id, mutation.change, mutation.formula
                );
                let says_the_same = match statement.id {
                    // (79) leaves a constant free: another one says the same.
                    "eq-79" => differ_by_a_constant(&ring, *component, mutation.formula),
                    _ => {
                        let theirs = ring.read(mutation.formula);
                        let difference = theirs.and_then(|x| Ok(x - ring.read(*component)?));
                        difference.and_then(|d| ring.is_zero(&d)) == Ok(true)
                    }
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
