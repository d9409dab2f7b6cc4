//! The judge, tried on evidence made by hand.

use slipbook::evidence::{Change, Evidence, Kind, Route, Subject, Tolerance};
use slipbook::ledger::{Judgement, Verdict, in_view_of, judge};
use std::panic::Location;

fn evidence(route: Route, subject: Subject, worst: f64) -> Evidence {
    const EXAMPLE: Tolerance = Tolerance {
        name: "EXAMPLE",
        value: 1e-12,
        reason: "test",
    };
    Evidence {
        points: 1000,
        worst,
        at: "x = 1".into(),
        ..Evidence::new(route, subject, "a with b", EXAMPLE)
    }
}

fn verdict(kind: Kind, change: Option<Change>, evidence: &[Evidence]) -> Verdict {
    judge(kind, change, &[], evidence).verdict
}

const GOOD: f64 = 1e-13;
const BAD: f64 = 1e-3;

#[test]
fn two_routes_that_agree_confirm() {
    let e = [
        evidence(Route::Integration, Subject::Printed, GOOD),
        evidence(Route::Quadrature, Subject::Printed, GOOD),
    ];
    assert_eq!(verdict(Kind::Equation, None, &e), Verdict::Confirmed);
}

#[test]
fn the_same_route_twice_is_one_route() {
    let e = [
        evidence(Route::Integration, Subject::Printed, GOOD),
        evidence(Route::Integration, Subject::Printed, GOOD),
    ];
    assert_eq!(verdict(Kind::Equation, None, &e), Verdict::Undecided);
}

#[test]
fn two_routes_that_have_read_the_same_runs_are_one_route() {
    let [here, there] = [Location::caller(), place()];
    let by = |route, runs: &[_]| Evidence {
        runs: runs.iter().copied().collect(),
        ..evidence(route, Subject::Printed, GOOD)
    };
    let census = by(Route::Census, &[here, there]);
    let shared = [census.clone(), by(Route::Integration, &[here])];
    assert_eq!(verdict(Kind::Equation, None, &shared), Verdict::Undecided);
    let apart = [by(Route::Census, &[there]), by(Route::Integration, &[here])];
    assert_eq!(verdict(Kind::Equation, None, &apart), Verdict::Confirmed);
    let third = [&shared[..], &[by(Route::Root, &[])]].concat();
    assert_eq!(verdict(Kind::Equation, None, &third), Verdict::Confirmed);
}

fn place() -> &'static Location<'static> {
    Location::caller()
}

#[test]
fn one_route_that_proves_is_enough() {
    for route in [Route::Exact, Route::Certified] {
        let mut e = evidence(route, Subject::Printed, 0.0);
        e.points = 1;
        assert_eq!(verdict(Kind::Equation, None, &[e]), Verdict::Confirmed);
    }
}

#[test]
fn a_proof_does_not_outweigh_a_disagreement() {
    let e = [
        evidence(Route::Exact, Subject::Printed, 0.0),
        evidence(Route::Integration, Subject::Printed, BAD),
    ];
    assert_eq!(verdict(Kind::Equation, None, &e), Verdict::Undecided);
}

#[test]
fn a_disagreement_without_a_correction_is_undecided() {
    let e = [
        evidence(Route::Integration, Subject::Printed, BAD),
        evidence(Route::Quadrature, Subject::Printed, BAD),
    ];
    assert_eq!(verdict(Kind::Equation, None, &e), Verdict::Undecided);
}

#[test]
fn a_confirmed_correction_makes_a_misprint_or_a_refutation_by_its_size() {
    let e = [
        evidence(Route::Integration, Subject::Printed, BAD),
        evidence(Route::Integration, Subject::Corrected, GOOD),
        evidence(Route::Quadrature, Subject::Corrected, GOOD),
    ];
    for change in [Change::Sign, Change::Factor, Change::Symbol] {
        assert_eq!(verdict(Kind::Equation, Some(change), &e), Verdict::Misprint);
    }
    let refuted = verdict(Kind::Equation, Some(Change::Statement), &e);
    assert_eq!(refuted, Verdict::Refuted);
    assert_eq!(verdict(Kind::Equation, None, &e), Verdict::Undecided);
}

#[test]
fn a_correction_by_one_route_or_with_a_disagreement_settles_nothing() {
    let one = [
        evidence(Route::Integration, Subject::Printed, BAD),
        evidence(Route::Integration, Subject::Corrected, GOOD),
    ];
    let contested = [
        evidence(Route::Integration, Subject::Printed, BAD),
        evidence(Route::Integration, Subject::Corrected, GOOD),
        evidence(Route::Root, Subject::Corrected, GOOD),
        evidence(Route::Limit, Subject::Corrected, BAD),
    ];
    for e in [&one[..], &contested[..]] {
        assert_eq!(
            verdict(Kind::Equation, Some(Change::Sign), e),
            Verdict::Undecided
        );
    }
}

#[test]
fn a_condition_must_be_needed_and_must_suffice() {
    let within = [
        evidence(Route::Integration, Subject::Within, GOOD),
        evidence(Route::Quadrature, Subject::Within, GOOD),
    ];
    let outside = |worst| evidence(Route::Integration, Subject::Outside, worst);
    let with = |worst| [&within[..], &[outside(worst)]].concat();
    assert_eq!(
        verdict(Kind::Equation, None, &with(f64::INFINITY)),
        Verdict::Conditional
    );
    assert_eq!(
        verdict(Kind::Equation, None, &with(GOOD)),
        Verdict::Undecided
    );
    let few = [within[0].clone(), outside(BAD)];
    assert_eq!(verdict(Kind::Equation, None, &few), Verdict::Undecided);
    let fails_within = [
        evidence(Route::Integration, Subject::Within, BAD),
        outside(BAD),
    ];
    assert_eq!(
        verdict(Kind::Equation, None, &fails_within),
        Verdict::Undecided
    );
}

#[test]
fn a_form_for_everywhere_must_hold_everywhere() {
    let with = |worst| {
        [
            evidence(Route::Integration, Subject::Within, GOOD),
            evidence(Route::Quadrature, Subject::Within, GOOD),
            evidence(Route::Integration, Subject::Outside, f64::INFINITY),
            evidence(Route::Integration, Subject::Corrected, worst),
        ]
    };
    assert_eq!(
        verdict(Kind::Equation, None, &with(GOOD)),
        Verdict::Conditional
    );
    assert_eq!(
        verdict(Kind::Equation, None, &with(BAD)),
        Verdict::Undecided
    );
}

#[test]
fn a_definition_is_one_only_while_it_is_consistent() {
    let e = |worst| [evidence(Route::Consistency, Subject::Printed, worst)];
    assert_eq!(
        verdict(Kind::Definition, None, &e(GOOD)),
        Verdict::Definition
    );
    assert_eq!(verdict(Kind::Definition, None, &e(BAD)), Verdict::Undecided);
    assert_eq!(verdict(Kind::Equation, None, &e(GOOD)), Verdict::Undecided);
}

#[test]
fn nan_infinity_too_few_points_and_nothing_never_confirm() {
    let good = evidence(Route::Quadrature, Subject::Printed, GOOD);
    let mut nan = evidence(Route::Integration, Subject::Printed, f64::NAN);
    let mut few = evidence(Route::Integration, Subject::Printed, GOOD);
    few.points = 19;
    let mut loose = evidence(Route::Integration, Subject::Printed, GOOD);
    loose.tolerance.value = f64::INFINITY;
    let infinite = evidence(Route::Integration, Subject::Printed, f64::INFINITY);
    for bad in [&nan, &few, &loose, &infinite] {
        let e = [good.clone(), (*bad).clone()];
        assert_eq!(verdict(Kind::Equation, None, &e), Verdict::Undecided);
    }
    assert_eq!(verdict(Kind::Equation, None, &[]), Verdict::Undecided);
    let judged = judge(Kind::Equation, None, &[], &[]);
    assert_eq!(judged.ground, "no trial yet");
    nan.at = "the integrator failed".into();
    let judged = judge(Kind::Equation, None, &[], &[nan]);
    assert!(judged.ground.contains("the integrator failed"));
}

#[test]
fn a_misprint_from_which_a_refuted_claim_follows_is_refuted() {
    let own = |verdict| Judgement {
        verdict,
        ground: "fails".into(),
    };
    let seen = |own_verdict, dependents: &[(&str, Verdict)]| {
        in_view_of(own(own_verdict), dependents).verdict
    };
    let fallen = [("a", Verdict::Confirmed), ("b", Verdict::Refuted)];
    assert_eq!(seen(Verdict::Misprint, &fallen), Verdict::Refuted);
    assert_eq!(seen(Verdict::Confirmed, &fallen), Verdict::Confirmed);
    let unharmed = [("a", Verdict::Confirmed), ("b", Verdict::Misprint)];
    assert_eq!(seen(Verdict::Misprint, &unharmed), Verdict::Misprint);
    let ground = in_view_of(own(Verdict::Misprint), &fallen).ground;
    assert!(ground.ends_with("falls too: b"), "{ground}");
}

#[test]
fn a_proof_of_a_part_proves_no_claim() {
    let part = evidence(Route::Certified, Subject::Printed, 0.0).of_a_part();
    let census = evidence(Route::Census, Subject::Printed, 0.0);
    let root = evidence(Route::Root, Subject::Printed, GOOD);
    let alone = [part.clone(), census.clone()];
    assert_eq!(verdict(Kind::Equation, None, &alone), Verdict::Undecided);
    let judged = judge(Kind::Equation, None, &[], &[part, census, root]);
    assert_eq!(judged.verdict, Verdict::Confirmed);
    assert_eq!(
        judged.ground,
        "holds by root, census; a part of it is proved (certified)"
    );
    let against = evidence(Route::Certified, Subject::Printed, f64::INFINITY).of_a_part();
    assert_eq!(against.proof_words(), Some("disproved"));
    assert_eq!(
        verdict(Kind::Equation, None, &[against]),
        Verdict::Undecided
    );
}
