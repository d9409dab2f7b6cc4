//! The theorems in `rocq`: of the formulas as they are, on record, and of something that there is.

use slipbook::claims::PAPER;
use std::collections::BTreeSet;
use trialbook::theorems::record::AXIOMS;
use trialbook::theorems::term::Term;
use trialbook::theorems::{FORMULAS, Known, formulas};

const AGAIN: &str = "run `make -C rocq`, and review the record";

fn known() -> &'static Known {
    PAPER.known_theorems()
}

#[test]
fn the_definitions_are_the_formulas() {
    let trees = (PAPER.formulas.trees)();
    let own = formulas::definitions(&trees, PAPER.formulas.corrections);
    let files = PAPER.theorems.files.texts(".v");
    let (_, written) = files.iter().find(|(path, _)| path == FORMULAS).unwrap();
    let written: BTreeSet<_> = written.lines().collect();
    let other = own.lines().find(|line| !written.contains(line));
    assert!(
        own.lines().collect::<BTreeSet<_>>() == written,
        "rocq/{FORMULAS} is not of these formulas: it lacks `{}`, or has others: {AGAIN}",
        other.unwrap_or_default()
    );
}

#[test]
fn the_record_is_of_these_files() {
    let known = known();
    assert_eq!(known.fault, None);
    let wanted: BTreeSet<_> = known
        .wanted(PAPER.claim_ids())
        .iter()
        .map(|item| item.name.as_str())
        .collect();
    let recorded: BTreeSet<_> = known
        .record
        .iter()
        .map(|accepted| accepted.name.as_str())
        .collect();
    assert_eq!(wanted, recorded, "{AGAIN}");
    let moved: Vec<_> = known
        .record
        .iter()
        .filter(|accepted| {
            known
                .sources
                .proved(&accepted.name)
                .is_none_or(|item| known.sources.mark(item) != accepted.mark)
        })
        .map(|accepted| &accepted.name)
        .collect();
    assert!(
        moved.is_empty(),
        "not as they were accepted: {moved:?}: {AGAIN}"
    );
}

#[test]
fn theorems_rest_on_what_is_said() {
    for accepted in &known().record {
        let other: Vec<_> = accepted
            .axioms
            .iter()
            .filter(|axiom| !AXIOMS.contains(&axiom.as_str()))
            .collect();
        assert!(other.is_empty(), "{} rests on {other:?}", accepted.name);
    }
}

#[test]
fn a_theorem_speaks_of_its_own_formula() {
    let known = known();
    for (_, claim) in PAPER.claims() {
        let own: BTreeSet<_> = known
            .formulas
            .iter()
            .filter(|(_, (of, _))| of == claim.id)
            .map(|(name, _)| name)
            .collect();
        let theorems = known.of_claim(claim.id);
        if claim.equation.is_none() || own.is_empty() || theorems.is_empty() {
            continue;
        }
        let speaks = theorems.iter().any(|(_, item)| {
            let used = known.sources.behind(item);
            used.iter()
                .any(|i| own.contains(&known.sources.items[*i].name))
        });
        assert!(speaks, "no theorem of {} speaks of {own:?}", claim.id);
    }
}

#[test]
fn what_is_supposed_occurs() {
    let known = known();
    let moves = |name: &&str| {
        let used = known.sources.used([*name].into_iter(), "");
        used.iter()
            .any(|i| known.sources.items[*i].word == "Record")
    };
    let supposes = |statement: &Term| {
        let free = statement.free();
        let supposed = statement.supposed().into_iter().flat_map(Term::free);
        supposed
            .filter(|name| free.contains(name))
            .any(|name| moves(&name))
    };
    let open = known.record.iter().filter(|accepted| {
        Term::read(&accepted.statement).is_some_and(|statement| supposes(&statement))
            && !accepted.occurs
    });
    let open: Vec<_> = open.map(|accepted| &accepted.name).collect();
    assert!(
        open.is_empty(),
        "nothing shows that the hypotheses can be met of {open:?}"
    );
}

#[test]
fn every_statement_is_told_as_mathematics() {
    for accepted in &known().record {
        assert!(
            Term::read(&accepted.statement).is_some(),
            "{}: {}",
            accepted.name,
            accepted.statement
        );
    }
}
