//! Every proof holds, and fails for every formula that differs in one place and is not the same in value.

use super::*;
use crate::exact::mutations;

#[test]
fn every_statement_is_proved() {
    for statement in STATEMENTS {
        let proof = statement.proof();
        assert!(proof.holds(), "{}\n{proof}", statement.id);
    }
}

/// Whether a mutant says the same as the printed formula: decided by comparison, not by a list.
fn says_the_same(statement: &Statement, mutant: Expr) -> Result<bool, ExactError> {
    let mut newton = Newton::new(statement.friction)?;
    if statement.id == "eq-12" {
        // Any value will do for the derivative D, as long as both formulas get the same.
        newton.ring.symbol("D");
    }
    let ring = &newton.ring;
    let (ours, theirs) = (ring.read((statement.printed)())?, ring.read(mutant)?);
    if !statement.invariant {
        return ring.is_zero(&(ours - theirs));
    }
    // Two expressions that both keep their values, one being the other times a number.
    let ratio = ring.divide(&theirs, &ours)?;
    let state = ["v", "θ"].map(|name| ring.by(name).and_then(|by| ring.derivative(&ratio, &by)));
    let fixed = state
        .into_iter()
        .map(|slope| ring.is_zero(&slope?))
        .collect::<Result<Vec<_>, _>>()?;
    Ok(fixed == [true, true] && !ring.is_zero(&ratio)?)
}

#[test]
fn every_mutant_fails_that_differs_in_value() {
    let (mut refuted, mut impossible, mut same) = (0, 0, 0);
    for statement in STATEMENTS {
        for mutation in mutations((statement.printed)()) {
            let proof = (statement.prove)(mutation.formula);
            let expected = says_the_same(statement, mutation.formula) == Ok(true);
            assert_eq!(
                proof.holds(),
                expected,
                "{}, {}: {}\n{proof}",
                statement.id,
                mutation.change,
                mutation.formula
            );
            match proof.obstacle() {
                None => same += 1,
                Some(Obstacle::NotZero { .. }) => refuted += 1,
                Some(_) => impossible += 1,
            }
        }
    }
    println!("{refuted} mutants refuted, {impossible} cannot be read, {same} are the same");
    // Most mutants must fail because a difference is not zero, not because they make no sense here.
    assert!(
        refuted > 3 * impossible,
        "{refuted} refuted, {impossible} impossible"
    );
}

#[test]
fn a_proof_reads_as_steps() {
    let text = proof("eq-9").expect("eq-9 is there").to_string();
    assert!(
        text.contains("The printed rate: (λ − cos(θ))/sin(θ) = "),
        "{text}"
    );
    assert!(text.ends_with("Proved.\n"), "{text}");
    let wrong = prove_eq9(-eq9()).to_string();
    assert!(
        wrong.contains("Not proved: Rate by (1) against printed rate: the difference is "),
        "{wrong}"
    );
}
