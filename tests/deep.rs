//! Depth: what another round brings is added to the evidence and judged with it.

use slipbook::claims::PAPER;
use slipbook::ledger::deep::{Deep, DeepError, Rounds};
use slipbook::ledger::{Ledger, Verdict};

fn stop_time() -> Ledger {
    Ledger::try_some(&PAPER, &["eq-20"], |_| {})
}

#[test]
fn a_round_adds_its_points_and_keeps_the_worse_of_two() {
    let ledger = stop_time();
    let (before, round) = (ledger.points(), ledger.round());
    let ledger = ledger.with(&round).unwrap();
    let evidence = &ledger.entries[0].evidence;
    let proofs = evidence.iter().filter(|e| e.route.is_proof()).count();
    assert_eq!(ledger.points() + proofs, 2 * before);
    assert_eq!(ledger.entries[0].judgement.verdict, Verdict::Confirmed);
}

#[test]
fn a_round_that_disagrees_or_has_no_number_changes_the_verdict() {
    for worst in ["0.5", "inf", "NaN"] {
        let ledger = stop_time();
        let trial = ledger.entries[0].evidence[1].trial;
        let round = format!("eq-20\t{trial}\t7\t2\t{worst}\tλ = 3");
        let ledger = ledger.with(&round).unwrap();
        let evidence = &ledger.entries[0].evidence[1];
        let brought = (evidence.points, evidence.failed, evidence.at.as_str());
        assert_eq!(brought, (707, 2, "λ = 3"));
        let verdict = ledger.entries[0].judgement.verdict;
        assert_eq!(verdict, Verdict::Undecided, "{worst}");
    }
}

#[test]
fn a_line_that_is_none_of_a_round_is_refused() {
    let ledger = stop_time();
    let trial = ledger.entries[0].evidence[1].trial;
    let good = format!("eq-20\t{trial}\t7\t0\t0.0\tλ = 3\n");
    let with = |strange: &str| {
        ledger
            .clone()
            .with(&format!("{good}{strange}"))
            .unwrap_err()
    };
    let error = with(&format!("eq-20\t{trial}\tseven\t0\t0.0\t"));
    assert!(matches!(error, DeepError::Line { line: 2, .. }), "{error}");
    for strange in ["eq-20\tnone\t7\t0\t0.0\t", "eq-21\tnone\t7\t0\t0.0\t"] {
        let error = with(strange);
        assert!(matches!(error, DeepError::Trial { line: 2, .. }), "{error}");
    }
}

#[test]
fn a_record_is_read_as_it_was_written() {
    let ledger = stop_time();
    let text = ledger.record("2026-01-02", 3);
    let deep = Deep::read(&text).unwrap();
    assert_eq!((deep.date, deep.rounds), ("2026-01-02", 3));
    let read = deep.in_place_of(&ledger).unwrap();
    assert_eq!(read.entries[0].evidence, ledger.entries[0].evidence);
    // A line that is lost, and one that is there twice.
    let (all, last) = text.trim_end().rsplit_once('\n').unwrap();
    for wrong in [all.to_owned(), format!("{text}{last}\n")] {
        let error = Deep::read(&wrong).unwrap().in_place_of(&ledger);
        assert!(matches!(error, Err(DeepError::Comparisons { .. })));
    }
    for wrong in ["", "2026-01-02\t3\n", "2026-01-02\tthree\t7\n"] {
        assert!(matches!(Deep::read(wrong), Err(DeepError::Header(_))));
    }
}

#[test]
fn rounds_from_any_parts_are_one_run() {
    let ledger = stop_time();
    let round = |shift: f64| {
        let lines = ledger.round();
        let lines = lines.lines().map(|line| {
            let columns: Vec<_> = line.split('\t').collect();
            let worst = columns[4].parse::<f64>().unwrap() + shift;
            format!("{}\t{worst:?}\tshift {shift}\n", columns[..4].join("\t"))
        });
        lines.collect::<String>()
    };
    let brought = [0.0, 0.0, 1e-17, f64::NAN, 1e-18].map(round);
    let mut whole = ledger.clone();
    let mut as_run = Rounds::default();
    as_run.read(&Rounds::headed(0, &brought[0])).unwrap();
    whole = as_run.in_place_of(&whole, 1).unwrap();
    for brought in &brought[1..] {
        whole = whole.with(brought).unwrap();
    }
    let parts = |numbers: &[u32]| -> String {
        let of = |&n: &u32| Rounds::headed(n, &brought[n as usize]);
        numbers.iter().map(of).collect()
    };
    let joined = |texts: &[&str], rounds| {
        let mut joined = Rounds::default();
        for text in texts {
            joined.read(text)?;
        }
        joined.in_place_of(&ledger, rounds)
    };
    for texts in [
        [parts(&[3, 4]), parts(&[0]), parts(&[1, 2])],
        [parts(&[4, 2, 0]), String::new(), parts(&[3, 1])],
    ] {
        let joined = joined(&texts.each_ref().map(String::as_str), 5).unwrap();
        assert_eq!(joined.record("", 5), whole.record("", 5));
    }
    let all = parts(&[0, 1, 2, 3, 4]);
    let cut = all.trim_end();
    let unfinished = &all[..all[..cut.rfind('\n').unwrap()].len() + 1];
    for (texts, rounds, error) in [
        (vec![&all[..], "round\t2\n"], 5, DeepError::Twice(2)),
        (vec![&all], 6, DeepError::Missing(5)),
        (
            vec![&all],
            4,
            DeepError::Beyond {
                round: 4,
                rounds: 4,
            },
        ),
        (vec![unfinished], 5, DeepError::Unfinished(4)),
        (vec![cut], 5, DeepError::Rounds("the last line is cut off")),
        (
            vec!["round\tx\n"],
            5,
            DeepError::Rounds("a round has no number"),
        ),
        (
            vec!["eq-20\n"],
            5,
            DeepError::Rounds("they begin with no `round`"),
        ),
    ] {
        assert_eq!(joined(&texts, rounds).unwrap_err(), error);
    }
}

/// The run is as deep as was asked for, of the trials as they are now, and comes to the same verdicts.
#[test]
fn the_record_of_the_deep_run_is_that_of_this_ledger() {
    let ledger = Ledger::try_all(&PAPER, |_| {});
    let kept = Deep::read(PAPER.deep).unwrap();
    let deep = kept.in_place_of(&ledger).unwrap();
    assert!(kept.comparisons >= 10_000_000, "{}", kept.comparisons);
    for (now, then) in ledger.entries.iter().zip(&deep.entries) {
        let id = now.claim.id;
        assert_eq!(then.judgement.verdict, now.judgement.verdict, "{id}");
        for (now, then) in now.evidence.iter().zip(&then.evidence) {
            assert!(then.points >= now.points, "{id}: {}", now.trial);
            assert_eq!(then.outcome(), now.outcome(), "{id}: {}", now.trial);
        }
    }
}
