//! The judge, tried on evidence made by hand.

use slipbook::claims::compare::{Pair, Trial};
use slipbook::claims::{Condition, Sort};
use slipbook::evidence::{Change, Compared, Evidence, Kind, Outcome, Route, Subject, Tolerance};
use slipbook::ledger::{Judgement, Verdict, in_view_of, judge};
use slipbook::numerics::roots::root;
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
        ..Evidence::new(route, subject, Compared::one("$a$", "$b$"), EXAMPLE)
    }
}

fn verdict(kind: Kind, change: Option<Change>, evidence: &[Evidence]) -> Verdict {
    let outside = evidence.iter().any(|e| e.subject == Subject::Outside);
    let conditions = if outside { NEEDED } else { &[] };
    judge(kind, change, conditions, evidence).verdict
}

/// The verdict under one condition of this sort.
fn under(sort: Sort, evidence: &[Evidence]) -> Verdict {
    let condition = Condition {
        text: "x > 0",
        sort,
    };
    judge(Kind::Equation, None, &[condition], evidence).verdict
}

/// A condition of substance, where there is evidence without it.
const NEEDED: &[Condition] = &[Condition {
    text: "x > 0",
    sort: Sort::Substance,
}];

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
fn a_confirmed_correction_makes_a_misprint_or_more_by_its_size() {
    let e = [
        evidence(Route::Integration, Subject::Printed, BAD),
        evidence(Route::Integration, Subject::Corrected, GOOD),
        evidence(Route::Quadrature, Subject::Corrected, GOOD),
    ];
    for change in [Change::Sign, Change::Factor, Change::Symbol] {
        assert_eq!(verdict(Kind::Equation, Some(change), &e), Verdict::Misprint);
    }
    let more = |kind| verdict(kind, Some(Change::Statement), &e);
    assert_eq!(more(Kind::Equation), Verdict::Misderived);
    assert_eq!(more(Kind::Property), Verdict::Refuted);
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

/// Whatever a trial speaks of, and whatever the others settle: without a number, or with too few points, it is none, and nothing is
/// judged by it.
#[test]
fn a_trial_that_brings_nothing_leaves_its_claim_undecided() {
    let twice = |subject, worst| {
        let routes = [Route::Integration, Route::Quadrature];
        routes.map(|route| evidence(route, subject, worst)).to_vec()
    };
    let fails = evidence(Route::Integration, Subject::Printed, BAD);
    let outside = evidence(Route::Integration, Subject::Outside, BAD);
    let remark = evidence(Route::Census, Subject::Remark, GOOD);
    let excepted = evidence(Route::Census, Subject::Excepted, 0.0);
    let step = evidence(Route::Root, Subject::Step, GOOD);
    let within = [twice(Subject::Within, GOOD), vec![outside]].concat();
    let everywhere = evidence(Route::Root, Subject::Corrected, GOOD);
    for (change, sort, settled, expected) in [
        (
            None,
            None,
            twice(Subject::Printed, GOOD),
            Verdict::Confirmed,
        ),
        (
            None,
            Some(Sort::Substance),
            [&within[..], &[everywhere, remark]].concat(),
            Verdict::Conditional,
        ),
        (
            None,
            Some(Sort::Degenerate),
            [&within[..], &[excepted]].concat(),
            Verdict::Degenerate,
        ),
        (
            Some(Change::Sign),
            None,
            [vec![fails.clone()], twice(Subject::Corrected, GOOD)].concat(),
            Verdict::Misprint,
        ),
        (None, None, vec![fails, step], Verdict::Inherited),
    ] {
        let conditions = sort.map(|sort| Condition {
            text: "x > 0",
            sort,
        });
        let judged =
            |e: &[Evidence]| judge(Kind::Equation, change, conditions.as_slice(), e).verdict;
        assert_eq!(judged(&settled), expected);
        let subjects = [
            Subject::Printed,
            Subject::Within,
            Subject::Outside,
            Subject::Corrected,
            Subject::Step,
            Subject::Excepted,
            Subject::Remark,
        ];
        let more = subjects
            .map(|subject| [&settled[..], &[evidence(Route::Limit, subject, GOOD)]].concat());
        let last = settled.len();
        let places = (0..last).map(|at| (at, settled.clone()));
        for (at, all) in places.chain(more.map(|all| (last, all))) {
            for (worst, points) in [(f64::NAN, 1000), (GOOD, 19), (BAD, 19), (f64::NAN, 0)] {
                let mut all = all.clone();
                (all[at].worst, all[at].points) = (worst, points);
                assert_eq!(
                    judged(&all),
                    Verdict::Undecided,
                    "{expected:?} {:?}",
                    all[at]
                );
            }
        }
    }
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

fn own(verdict: Verdict) -> Judgement {
    Judgement {
        verdict,
        ground: "fails".into(),
        inherits: Vec::new(),
    }
}

#[test]
fn a_misprint_from_which_an_error_is_inherited_is_more_than_that() {
    let seen = |verdict, above: &[(&str, Verdict)]| in_view_of(own(verdict), &[], above);
    let heir = [("a", Verdict::Confirmed), ("b", Verdict::Inherited)];
    assert_eq!(seen(Verdict::Misprint, &heir).verdict, Verdict::Misderived);
    assert!(
        seen(Verdict::Misprint, &heir)
            .ground
            .ends_with("its error passes to b")
    );
    assert_eq!(seen(Verdict::Confirmed, &heir).verdict, Verdict::Confirmed);
    // What is wrong by itself inherits nothing.
    for other in [Verdict::Misprint, Verdict::Misderived, Verdict::Refuted] {
        assert_eq!(
            seen(Verdict::Misprint, &[("b", other)]).verdict,
            Verdict::Misprint
        );
    }
}

#[test]
fn an_error_is_inherited_from_something_that_is_wrong() {
    let printed = evidence(Route::Integration, Subject::Printed, BAD);
    let step = |worst| evidence(Route::Root, Subject::Step, worst);
    let judged = |e: &[Evidence]| judge(Kind::Equation, None, &[], e);
    let heir = judged(&[printed.clone(), step(GOOD)]);
    assert_eq!(heir.verdict, Verdict::Inherited);
    // A step that fails explains nothing; nor does one to something that is right.
    assert_eq!(
        judged(&[printed.clone(), step(BAD)]).verdict,
        Verdict::Undecided
    );
    assert_eq!(judged(&[step(GOOD)]).verdict, Verdict::Undecided);
    // What is said to be right instead must not fail.
    let corrected = evidence(Route::Root, Subject::Corrected, BAD);
    assert_eq!(
        judged(&[printed, step(GOOD), corrected]).verdict,
        Verdict::Undecided
    );

    let seen = |below: &[(&str, Verdict)]| in_view_of(heir.clone(), below, &[]).verdict;
    assert_eq!(seen(&[("a", Verdict::Misderived)]), Verdict::Inherited);
    assert_eq!(
        seen(&[("a", Verdict::Confirmed), ("b", Verdict::Inherited)]),
        Verdict::Inherited
    );
    for verdict in Verdict::ALL {
        let wrong = [
            Verdict::Misprint,
            Verdict::Misderived,
            Verdict::Inherited,
            Verdict::Refuted,
        ];
        let expected = match wrong.contains(&verdict) {
            true => Verdict::Inherited,
            false => Verdict::Undecided,
        };
        assert_eq!(seen(&[("a", verdict)]), expected, "{verdict:?}");
    }
}

#[test]
fn only_what_is_tried_and_found_to_be_degenerate_is_no_reproach() {
    let with = |sorts: &[Sort], excepted: &[f64]| {
        let conditions: Vec<_> = sorts
            .iter()
            .map(|sort| Condition {
                text: "x > 0",
                sort: *sort,
            })
            .collect();
        let mut e = vec![
            evidence(Route::Integration, Subject::Within, GOOD),
            evidence(Route::Quadrature, Subject::Within, GOOD),
            evidence(Route::Integration, Subject::Outside, f64::INFINITY),
        ];
        e.extend(
            excepted
                .iter()
                .map(|worst| evidence(Route::Census, Subject::Excepted, *worst)),
        );
        judge(Kind::Equation, None, &conditions, &e).verdict
    };
    let (stated, thin, thick) = (Sort::Stated, Sort::Degenerate, Sort::Substance);
    assert_eq!(with(&[stated, thin], &[0.0]), Verdict::Degenerate);
    assert_eq!(with(&[thin, thin], &[0.0, 0.0]), Verdict::Degenerate);
    assert_eq!(with(&[thin, thick], &[0.0]), Verdict::Conditional);
    assert_eq!(with(&[thick], &[]), Verdict::Conditional);
    // Not tried, tried once for two, tried and not so, tried and not claimed.
    assert_eq!(with(&[thin], &[]), Verdict::Undecided);
    assert_eq!(with(&[thin, thin], &[0.0]), Verdict::Undecided);
    assert_eq!(with(&[thin], &[1.0]), Verdict::Undecided);
    assert_eq!(with(&[thick], &[0.0]), Verdict::Undecided);
}

#[test]
fn what_is_in_dispute_settles_nothing() {
    let step = |route, worst| evidence(route, Subject::Step, worst);
    let fails = evidence(Route::Integration, Subject::Printed, BAD);
    let heir = [fails, step(Route::Root, GOOD)];
    assert_eq!(verdict(Kind::Equation, None, &heir), Verdict::Inherited);
    let contested = [&heir[..], &[step(Route::Quadrature, BAD)]].concat();
    assert_eq!(
        verdict(Kind::Equation, None, &contested),
        Verdict::Undecided
    );
    // Nor is a step a second route of the statement.
    let one = [
        evidence(Route::Integration, Subject::Printed, GOOD),
        step(Route::Root, GOOD),
    ];
    assert_eq!(verdict(Kind::Equation, None, &one), Verdict::Undecided);

    let needed = [
        evidence(Route::Integration, Subject::Within, GOOD),
        evidence(Route::Quadrature, Subject::Within, GOOD),
        evidence(Route::Root, Subject::Outside, BAD),
    ];
    assert_eq!(under(Sort::Substance, &needed), Verdict::Conditional);
    let holds = evidence(Route::Limit, Subject::Outside, GOOD);
    let contested = [&needed[..], &[holds]].concat();
    assert_eq!(under(Sort::Substance, &contested), Verdict::Undecided);
    let excepted = |worst| evidence(Route::Census, Subject::Excepted, worst);
    let degenerate = [&needed[..], &[excepted(0.0)]].concat();
    assert_eq!(under(Sort::Degenerate, &degenerate), Verdict::Degenerate);
    let contested = [&degenerate[..], &[excepted(BAD)]].concat();
    assert_eq!(under(Sort::Degenerate, &contested), Verdict::Undecided);
    // A convention is tried in the same way.
    assert_eq!(under(Sort::Convention, &degenerate), Verdict::Confirmed);
    for e in [&needed[..], &contested] {
        assert_eq!(under(Sort::Convention, e), Verdict::Undecided);
    }
}

#[test]
fn a_condition_that_is_added_has_to_be_tried_without() {
    let e = [
        evidence(Route::Integration, Subject::Printed, GOOD),
        evidence(Route::Quadrature, Subject::Printed, GOOD),
    ];
    assert_eq!(under(Sort::Stated, &e), Verdict::Confirmed);
    assert_eq!(under(Sort::Degenerate, &e), Verdict::Undecided);
    assert_eq!(under(Sort::Substance, &e), Verdict::Undecided);
}

#[test]
fn a_reading_has_no_effect_and_a_remark_has_to_be_tried() {
    let holds = [
        evidence(Route::Integration, Subject::Printed, GOOD),
        evidence(Route::Quadrature, Subject::Printed, GOOD),
    ];
    let fails = [evidence(Route::Integration, Subject::Printed, BAD)];
    let remark = |worst| evidence(Route::Limit, Subject::Remark, worst);
    let beside = |e: &[Evidence], worst| [e, &[remark(worst)]].concat();
    assert_eq!(under(Sort::Reading, &holds), Verdict::Confirmed);
    assert_eq!(under(Sort::Reading, &fails), Verdict::Undecided);
    assert_eq!(under(Sort::Remark, &holds), Verdict::Undecided);
    assert_eq!(
        under(Sort::Remark, &beside(&holds, GOOD)),
        Verdict::Confirmed
    );
    assert_eq!(
        under(Sort::Remark, &beside(&holds, BAD)),
        Verdict::Undecided
    );
    // It speaks for nothing but itself.
    assert_eq!(
        under(Sort::Remark, &beside(&holds[..1], GOOD)),
        Verdict::Undecided
    );
}

#[test]
fn what_is_tried_in_part_is_undecided() {
    let parts = [Route::Integration, Route::Quadrature]
        .map(|route| evidence(route, Subject::Printed, GOOD).of_a_part());
    let judged = judge(Kind::Property, None, &[], &parts);
    assert_eq!(judged.verdict, Verdict::Undecided);
    assert!(judged.ground.contains("a part"), "{}", judged.ground);
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
        "holds by root, census; a part of it holds by proof (certified)"
    );
    let against = evidence(Route::Certified, Subject::Printed, f64::INFINITY).of_a_part();
    assert_eq!(against.proof_words(), Some("disproved"));
    assert_eq!(
        verdict(Kind::Equation, None, &[against]),
        Verdict::Undecided
    );
}

#[test]
fn a_tolerance_ends_where_it_says() {
    let of = |worst| evidence(Route::Census, Subject::Printed, worst).outcome();
    assert_eq!(of(1e-12), Outcome::Agrees);
    assert_eq!(of(1e-12_f64.next_up()), Outcome::Disagrees);
    // And what is just beyond it is counted.
    let tolerance = evidence(Route::Census, Subject::Printed, 0.0).tolerance;
    let trial = Trial::by(
        Route::Census,
        Subject::Printed,
        Compared::one("$a$", "$b$"),
        tolerance,
    );
    let pairs = trial.over(0..30, |i| {
        Ok(Pair {
            at: format!("i = {i}"),
            stated: if i < 7 { 1.1e-12 } else { 0.9e-12 },
            found: 0.0,
            scale: 1.0,
        })
    });
    assert_eq!((pairs.failed, pairs.outcome()), (7, Outcome::Disagrees));
}

#[test]
fn no_value_is_no_agreement() {
    let of = |stated: f64, found: f64, scale: f64| {
        let at = String::new();
        Pair {
            at,
            stated,
            found,
            scale,
        }
        .disagreement()
    };
    for none in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(of(none, 1.0, 1.0), f64::INFINITY);
        assert!(of(1.0, none, 1.0).is_nan() && of(1.0, 1.0, none).is_nan());
    }
    assert!(of(1.0, 1.0, 0.0).is_nan() && of(1.0, 1.0, -1.0).is_nan());
    assert_eq!([of(1.0, 3.0, 4.0), of(3.0, 1.0, 4.0)], [0.5, 0.5]);
}

#[test]
fn a_root_at_an_end_is_that_end() {
    let at = |low, high| root(|x| x - 2.0, low, high).unwrap();
    assert_eq!([at(2.0, 3.0), at(1.0, 2.0)], [2.0; 2]);
}

#[test]
fn nineteen_points_are_too_few_by_any_measured_route() {
    for route in [
        Route::Integration,
        Route::Quadrature,
        Route::Root,
        Route::Limit,
        Route::Census,
        Route::Consistency,
    ] {
        let outcome = |points| {
            let evidence = evidence(route, Subject::Printed, GOOD);
            Evidence { points, ..evidence }.outcome()
        };
        assert_eq!(
            [19, 20].map(outcome),
            [Outcome::TooFewPoints, Outcome::Agrees]
        );
    }
}

/// The verdicts that the page gives in its rules are those that the judge gives in these cases, in the same order.
#[test]
fn the_page_gives_the_rules_of_the_judge() {
    use Subject::{Corrected, Outside, Printed, Step, Within};
    let page = include_str!("../../book/src/methods.md");
    let rules = page.split("## The judge {#judge}").nth(1).unwrap();
    let rules = rules.split("```").next().unwrap();
    let rules = rules.split_whitespace().collect::<Vec<_>>().join(" ");
    let by = |subject, worst: &[f64]| -> Vec<Evidence> {
        let routes = [Route::Integration, Route::Quadrature];
        let pairs = routes.into_iter().zip(worst);
        pairs
            .map(|(route, worst)| evidence(route, subject, *worst))
            .collect()
    };
    let two = [GOOD, GOOD];
    let judged = |parts: &[Vec<Evidence>], change| verdict(Kind::Equation, change, &parts.concat());
    let wrong = |kind| {
        let e = [by(Printed, &[BAD]), by(Corrected, &two)].concat();
        verdict(kind, Some(Change::Statement), &e)
    };
    let but_for = |sort| {
        let excepted = by(Subject::Excepted, &[0.0]);
        let e = [by(Within, &two), by(Outside, &[BAD]), excepted];
        under(sort, &e.concat())
    };
    let consistent = [evidence(Route::Consistency, Printed, GOOD)];
    let misprint = || {
        judged(
            &[by(Printed, &[BAD]), by(Corrected, &two)],
            Some(Change::Sign),
        )
    };
    let remark = || {
        let e = [by(Printed, &two), by(Subject::Remark, &[BAD])];
        under(Sort::Remark, &e.concat())
    };
    let heir = || in_view_of(own(misprint()), &[], &[("b", Verdict::Inherited)]).verdict;
    let cases = [
        // Without a trial.
        judged(&[], None),
        // The step is right, what it starts from is not.
        judged(&[by(Printed, &[BAD]), by(Step, &[GOOD])], None),
        // It fails, and what replaces it is tried in one way alone.
        judged(
            &[by(Printed, &[BAD]), by(Corrected, &[GOOD])],
            Some(Change::Sign),
        ),
        // A sign, a larger change, words.
        misprint(),
        wrong(Kind::Equation),
        wrong(Kind::Property),
        // Under a condition: not without it, then on both sides.
        judged(&[by(Within, &two), by(Outside, &[BAD])], None),
        judged(&[by(Within, &two), by(Outside, &[GOOD])], None),
        but_for(Sort::Degenerate),
        but_for(Sort::Convention),
        verdict(Kind::Definition, None, &consistent),
        judged(&[by(Printed, &two)], None),
        judged(&[by(Printed, &[GOOD])], None),
        remark(),
        // What looks like a misprint, and has an heir.
        heir(),
    ];
    let said: Vec<_> = rules.split("**").skip(1).step_by(2).collect();
    assert_eq!(said, cases.map(|verdict| verdict.words()));

    let pair = |stated, found| {
        let at = String::new();
        Pair {
            at,
            stated,
            found,
            scale: 1.0,
        }
        .disagreement()
    };
    assert_eq!(pair(f64::NAN, 1.0), f64::INFINITY);
    assert!(pair(1.0, f64::NAN).is_nan());
}
