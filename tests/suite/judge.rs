//! The judge, tried on evidence made by hand: case by case in `judge/rules.txt`, and what no case says.

use slipbook::evidence::{Change, Compared, Evidence, Kind, Outcome, Route, Subject, Tolerance};
use slipbook::ledger::{Judgement, Verdict, in_view_of, judge};
use slipbook::numerics::roots::root;
use std::fmt::Debug;
use std::panic::Location;
use trialbook::data::text;
use trialbook::trials::{
    Condition, Sort,
    compare::{Pair, Trial},
};

const GOOD: f64 = 1e-13;
const BAD: f64 = 1e-3;

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

const ROUTES: [Route; 8] = [
    Route::Exact,
    Route::Certified,
    Route::Integration,
    Route::Quadrature,
    Route::Root,
    Route::Limit,
    Route::Census,
    Route::Consistency,
];
const SUBJECTS: [Subject; 7] = [
    Subject::Printed,
    Subject::Within,
    Subject::Outside,
    Subject::Corrected,
    Subject::Step,
    Subject::Excepted,
    Subject::Remark,
];
const SORTS: [Sort; 6] = [
    Sort::Stated,
    Sort::Degenerate,
    Sort::Convention,
    Sort::Substance,
    Sort::Reading,
    Sort::Remark,
];
const CHANGES: [Change; 4] = [
    Change::Sign,
    Change::Factor,
    Change::Symbol,
    Change::Statement,
];
const SOME_RUNS: &Location<'static> = place();
const OTHER_RUNS: &Location<'static> = place();
const KINDS: [Kind; 2] = [Kind::Property, Kind::Definition];

#[track_caller]
const fn place() -> &'static Location<'static> {
    Location::caller()
}

fn named<T: Copy + Debug>(all: &[T], word: &str) -> Option<T> {
    let mut all = all.iter().copied();
    all.find(|one| format!("{one:?}").to_lowercase() == word)
}

struct Case {
    kind: Kind,
    change: Option<Change>,
    conditions: Vec<Condition>,
    evidence: Vec<Evidence>,
}

impl Case {
    fn read(text: &str) -> Self {
        let (claim, trials) = text.split_once(':').expect("a colon");
        let words = || claim.split_whitespace();
        let sorts = words().filter_map(|word| named(&SORTS, word));
        let conditions: Vec<_> = sorts
            .map(|sort| Condition {
                text: "x > 0",
                sort,
            })
            .collect();
        let kind = words().find_map(|word| named(&KINDS, word));
        let change = words().find_map(|word| named(&CHANGES, word));
        let known = conditions.len() + usize::from(kind.is_some()) + usize::from(change.is_some());
        assert_eq!(known, words().count(), "{text}");
        let mut subject = Subject::Printed;
        let mut of_word = |word: &str| {
            let Some(route) = word.strip_prefix(['+', '-']) else {
                subject = named(&SUBJECTS, word).unwrap_or_else(|| panic!("`{word}` in {text}"));
                return None;
            };
            let (route, runs) = route.split_once('@').unwrap_or((route, ""));
            let route = named(&ROUTES, route).unwrap_or_else(|| panic!("`{word}` in {text}"));
            let worst = if word.starts_with('+') { GOOD } else { BAD };
            let runs = runs.chars().map(|run| match run {
                'a' => SOME_RUNS,
                _ => OTHER_RUNS,
            });
            Some(Evidence {
                runs: runs.collect(),
                ..evidence(route, subject, worst)
            })
        };
        Case {
            kind: kind.unwrap_or(Kind::Equation),
            change,
            conditions,
            evidence: trials.split_whitespace().filter_map(&mut of_word).collect(),
        }
    }

    fn judged(&self, evidence: &[Evidence]) -> Verdict {
        judge(self.kind, self.change, &self.conditions, evidence).verdict
    }

    fn verdict(&self) -> Verdict {
        self.judged(&self.evidence)
    }
}

fn rules() -> impl Iterator<Item = (&'static str, Verdict)> {
    let lines = include_str!("judge/rules.txt").lines();
    let cases = lines.filter(|line| !line.is_empty() && !line.starts_with('#'));
    cases.map(|line| {
        let (case, verdict) = line.split_once(" = ").expect("a verdict");
        (case, named(&Verdict::ALL, verdict).expect("a verdict"))
    })
}

#[test]
fn each_case_has_its_verdict() {
    let wrong = rules().filter_map(|(case, expected)| {
        let found = Case::read(case).verdict();
        (found != expected).then(|| format!("{case}: {found:?}, not {expected:?}"))
    });
    let wrong: Vec<_> = wrong.collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// Without a number, or with too few points.
#[test]
fn a_trial_that_brings_nothing_leaves_its_claim_undecided() {
    let settled = rules().filter(|(_, verdict)| *verdict != Verdict::Undecided);
    for (text, _) in settled {
        let case = Case::read(text);
        let last = case.evidence.len();
        let places = (0..last).map(|at| (at, case.evidence.clone()));
        let more = SUBJECTS.map(|subject| {
            let one = [evidence(Route::Limit, subject, GOOD)];
            (last, [&case.evidence[..], &one].concat())
        });
        for (at, all) in places.chain(more) {
            for (worst, points) in [(f64::NAN, 1000), (GOOD, 19), (BAD, 19), (f64::NAN, 0)] {
                let mut all = all.clone();
                if all[at].route.is_proof() && points == 19 {
                    continue;
                }
                (all[at].worst, all[at].points) = (worst, points);
                assert_eq!(
                    case.judged(&all),
                    Verdict::Undecided,
                    "{text} {:?}",
                    all[at]
                );
            }
        }
    }
}

#[test]
fn infinity_and_nothing_confirm_nothing_and_what_fails_is_said() {
    let case = Case::read(": printed +integration +quadrature");
    let mut loose = case.evidence.clone();
    loose[0].tolerance.value = f64::INFINITY;
    assert_eq!(case.judged(&loose), Verdict::Undecided);
    let mut infinite = case.evidence.clone();
    infinite[0].worst = f64::INFINITY;
    assert_eq!(case.judged(&infinite), Verdict::Undecided);
    let ground = |evidence: &[Evidence]| judge(Kind::Equation, None, &[], evidence).ground;
    assert_eq!(ground(&[]), "no trial yet");
    let mut none = evidence(Route::Integration, Subject::Printed, f64::NAN);
    none.at = "the integrator failed".into();
    assert!(ground(&[none]).contains("the integrator failed"));
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
    let misprint = seen(Verdict::Misprint, &heir);
    assert_eq!(misprint.verdict, Verdict::Misderived);
    assert!(misprint.ground.ends_with("its error passes to b"));
    assert_eq!(seen(Verdict::Confirmed, &heir).verdict, Verdict::Confirmed);
    for other in [Verdict::Misprint, Verdict::Misderived, Verdict::Refuted] {
        let alone = seen(Verdict::Misprint, &[("b", other)]);
        assert_eq!(alone.verdict, Verdict::Misprint);
    }
}

#[test]
fn an_error_is_inherited_from_something_that_is_wrong() {
    use Verdict::{Confirmed, Inherited, Misderived, Misprint, Refuted, Undecided};
    let seen = |below: &[(&str, Verdict)]| in_view_of(own(Inherited), below, &[]).verdict;
    assert_eq!(seen(&[("a", Confirmed), ("b", Inherited)]), Inherited);
    for verdict in Verdict::ALL {
        let wrong = [Misprint, Misderived, Inherited, Refuted].contains(&verdict);
        let expected = if wrong { Inherited } else { Undecided };
        assert_eq!(seen(&[("a", verdict)]), expected, "{verdict:?}");
    }
}

#[test]
fn what_is_tried_or_proved_in_part_proves_no_claim() {
    let part = |route, worst| evidence(route, Subject::Printed, worst).of_a_part();
    let judged = |all: &[Evidence]| judge(Kind::Property, None, &[], all);
    let measured = judged(&[
        part(Route::Integration, GOOD),
        part(Route::Quadrature, GOOD),
    ]);
    assert_eq!(measured.verdict, Verdict::Undecided);
    assert!(measured.ground.contains("a part"), "{}", measured.ground);
    let proved = part(Route::Certified, 0.0);
    let census = evidence(Route::Census, Subject::Printed, 0.0);
    let alone = judged(&[proved.clone(), census.clone()]);
    assert_eq!(alone.verdict, Verdict::Undecided);
    let root = evidence(Route::Root, Subject::Printed, GOOD);
    let all = judged(&[proved, census, root]);
    assert_eq!(all.verdict, Verdict::Confirmed);
    let ground = "holds by root, census; a part of it holds by enclosure";
    assert_eq!(all.ground, ground);
    let against = part(Route::Certified, f64::INFINITY);
    assert_eq!(against.proof_words(), Some("disproved"));
    assert_eq!(judged(&[against]).verdict, Verdict::Undecided);
}

#[test]
fn a_tolerance_ends_where_it_says() {
    let of = |worst| evidence(Route::Census, Subject::Printed, worst).outcome();
    assert_eq!(of(1e-12), Outcome::Agrees);
    assert_eq!(of(1e-12_f64.next_up()), Outcome::Disagrees);
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

fn disagreement(stated: f64, found: f64, scale: f64) -> f64 {
    let at = String::new();
    Pair {
        at,
        stated,
        found,
        scale,
    }
    .disagreement()
}

#[test]
fn no_value_is_no_agreement() {
    for none in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        assert_eq!(disagreement(none, 1.0, 1.0), f64::INFINITY);
        assert!(disagreement(1.0, none, 1.0).is_nan());
        assert!(disagreement(1.0, 1.0, none).is_nan());
    }
    for scale in [0.0, -1.0] {
        assert!(disagreement(1.0, 1.0, scale).is_nan());
    }
    for (stated, found) in [(1.0, 3.0), (3.0, 1.0)] {
        assert_eq!(disagreement(stated, found, 4.0), 0.5);
    }
}

#[test]
fn a_root_at_an_end_is_that_end() {
    let at = |low, high| root(|x| x - 2.0, low, high).unwrap();
    assert_eq!([at(2.0, 3.0), at(1.0, 2.0)], [2.0; 2]);
}

#[test]
fn the_page_gives_the_rules_of_the_judge() {
    let page = text!("book/src/methods.md").as_str();
    let rules = page.split("## The judge {#judge}").nth(1).unwrap();
    let rules = rules.split("```").next().unwrap();
    let rules = rules.split_whitespace().collect::<Vec<_>>().join(" ");
    let misprint = "sign : printed -integration corrected +integration +quadrature";
    let cases = [
        ":",
        // The step is right, what it starts from is not.
        ": printed -integration step +integration",
        "sign : printed -integration corrected +integration",
        misprint,
        "statement : printed -integration corrected +integration +quadrature",
        "property statement : printed -integration corrected +integration +quadrature",
        // Not without the condition, then on both sides.
        "substance : within +integration +quadrature outside -integration",
        "substance : within +integration +quadrature outside +integration",
        "degenerate : within +integration +quadrature outside -integration excepted +integration",
        "convention : within +integration +quadrature outside -integration excepted +integration",
        "definition : printed +consistency",
        ": printed +integration +quadrature",
        ": printed +integration",
        "remark : printed +integration +quadrature remark -integration",
    ];
    let cases = cases.map(|case| Case::read(case).verdict());
    // What looks like a misprint, and has an heir.
    let heir = [("b", Verdict::Inherited)];
    let heir = in_view_of(own(Case::read(misprint).verdict()), &[], &heir);
    let verdicts = cases.into_iter().chain([heir.verdict]);
    let said: Vec<_> = rules.split("**").skip(1).step_by(2).collect();
    assert_eq!(said, verdicts.map(Verdict::words).collect::<Vec<_>>());
}
