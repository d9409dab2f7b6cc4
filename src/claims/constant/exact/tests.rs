//! Every proof holds, and fails for every formula that differs in one place and is not the same in value.

use super::*;
use crate::exact::mutations;

#[test]
fn every_statement_is_proved() {
    for statement in ALL {
        let proof = statement.proof();
        assert!(proof.holds(), "{proof}");
    }
}

/// Whether a mutant says the same as the printed formula: decided by comparison, not by a list.
fn says_the_same(statement: &Law, mutant: Expr) -> Result<bool, ExactError> {
    let mut newton = Newton::new(statement.setting.friction)?;
    if statement.place == EQ12.place {
        // Any value will do for the derivative D, as long as both formulas get the same.
        newton.ring.symbol("D");
    }
    let ring = &newton.ring;
    let (ours, theirs) = (ring.read((statement.formulas)())?, ring.read(mutant)?);
    if !statement.setting.invariant {
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

/// A number for each symbol, so that nothing is special about the state.
fn number(name: &str) -> Option<f64> {
    Some(match name {
        "λ" => 1.7,
        "A" => 2.3,
        "v" => 0.9,
        "v₀" => 1.3,
        "v₀x" => 0.7,
        "v₀y" => 1.1,
        "θ" => 0.83,
        "θ₀" => 2.1,
        "t" => 0.37,
        "D" => 0.59,
        "μ" => 0.31,
        "g" => 9.3,
        _ => return None,
    })
}

/// Whether a formula that the ring cannot read is another function than the printed one, or, for an
/// invariant, does not keep its value from one angle to the next.
fn differs_in_numbers(statement: &Law, mutant: Expr) -> bool {
    let (ours, theirs) = if statement.setting.invariant {
        let later = mutant.with("v", eq11()).with("θ", Expr::int(1));
        (mutant.with("v", eq11()), later)
    } else {
        ((statement.formulas)(), mutant)
    };
    let [ours, theirs] = [ours, theirs].map(|formula| formula.evaluate(&number));
    let (Some(ours), Some(theirs)) = (ours, theirs) else {
        return false;
    };
    // A formula without a value says nothing either.
    !theirs.is_finite() || (ours - theirs).abs() > 1e-6 * ours.abs()
}

#[test]
fn every_mutant_fails_that_differs_in_value() {
    let (mut refuted, mut unreadable, mut same) = (0, 0, 0);
    for statement in ALL {
        for mutation in mutations((statement.formulas)()) {
            let proof = (statement.prove)(mutation.formula);
            let who = format!("{}: {}", mutation.change, mutation.formula);
            let expected = says_the_same(statement, mutation.formula) == Ok(true);
            assert_eq!(proof.holds(), expected, "{who}\n{proof}");
            match proof.obstacle() {
                None => same += 1,
                Some(Obstacle::NotZero { .. }) => refuted += 1,
                Some(_) => {
                    unreadable += 1;
                    assert!(
                        differs_in_numbers(statement, mutation.formula),
                        "{who}\n{proof}"
                    );
                }
            }
        }
    }
    println!("{refuted} mutants refuted, {unreadable} outside the ring, {same} the same in value");
    assert!(
        refuted > 300,
        "too few mutants are refuted by a difference: {refuted}"
    );
}

#[test]
fn a_proof_reads_as_steps() {
    let text = EQ9.proof().to_string();
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

#[test]
fn every_changed_definition_fails() {
    let defined = definitions();
    assert!(
        prove_definitions(defined).holds(),
        "{}",
        prove_definitions(defined)
    );
    for place in 0..defined.len() {
        for mutation in mutations(defined[place]) {
            let mut changed = defined;
            changed[place] = mutation.formula;
            let values = [defined[place], mutation.formula].map(|x| x.evaluate(&number));
            let same = matches!(values, [Some(x), Some(y)] if (x - y).abs() < 1e-12);
            let proof = prove_definitions(changed);
            assert_eq!(proof.holds(), same, "{}\n{proof}", mutation.change);
        }
    }
}

#[test]
fn the_component_along_x_is_the_speed_times_the_cosine() {
    let proof = prove_eq18(eq18());
    let step = proof.steps().iter().find(|step| step.says == "v_x");
    let gives = &step.unwrap().gives;
    assert!(gives.contains("^λ cos(θ) = "), "{gives}");
}
