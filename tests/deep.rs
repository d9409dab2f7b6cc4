//! Depth: what another round brings is added to the evidence and judged with it.

use slipbook::claims::PAPER;
use slipbook::ledger::deep::DeepError;
use slipbook::ledger::{Ledger, Verdict};

fn stop_time() -> Ledger {
    Ledger::try_some(&PAPER, &["eq-20"], |_| {})
}

#[test]
fn a_round_adds_its_points_and_keeps_the_worse_of_two() {
    let mut ledger = stop_time();
    let (before, round) = (ledger.points(), ledger.round());
    ledger.add(&round).unwrap();
    let evidence = &ledger.entries[0].evidence;
    let proofs = evidence.iter().filter(|e| e.route.is_proof()).count();
    assert_eq!(ledger.points() + proofs, 2 * before);
    let ledger = ledger.judged();
    assert_eq!(ledger.entries[0].judgement.verdict, Verdict::Confirmed);
}

#[test]
fn a_round_that_disagrees_or_has_no_number_changes_the_verdict() {
    for worst in ["0.5", "inf", "NaN"] {
        let mut ledger = stop_time();
        let round = format!("eq-20\t1\t7\t{worst}\tλ = 3");
        ledger.add(&round).unwrap();
        let evidence = &ledger.entries[0].evidence[1];
        assert_eq!((evidence.points, evidence.at.as_str()), (707, "λ = 3"));
        let verdict = ledger.judged().entries[0].judgement.verdict;
        assert_eq!(verdict, Verdict::Undecided, "{worst}");
    }
}

#[test]
fn a_line_that_is_none_of_a_round_adds_nothing() {
    let mut ledger = stop_time();
    let before = ledger.entries[0].evidence.clone();
    let good = "eq-20\t1\t7\t0.0\tλ = 3\n";
    let error = ledger
        .add(&format!("{good}eq-20\tone\t7\t0.0\t"))
        .unwrap_err();
    assert!(matches!(error, DeepError::Line { line: 2, .. }), "{error}");
    for strange in ["eq-20\t9\t7\t0.0\t", "eq-21\t0\t7\t0.0\t"] {
        let error = ledger.add(&format!("{good}{strange}")).unwrap_err();
        assert!(matches!(error, DeepError::Trial { line: 2, .. }), "{error}");
    }
    assert_eq!(ledger.entries[0].evidence, before);
}
