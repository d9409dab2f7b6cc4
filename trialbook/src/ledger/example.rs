//! A paper made up for the tests: what each claim comes to can be told by counting.

use super::Ledger;
use crate::claims::attempt::Attempt;
use crate::claims::compare::{Pair, Trial};
use crate::claims::tolerances::MOTION;
use crate::claims::{Claim, Condition, Paper, Sort, Topic};
use crate::evidence::{Change, Compared, Evidence, Route, Subject};

/// Twenty points, at so many of which what is stated is off by 1; the last agree but for a rounding.
pub(crate) fn tried(route: Route, subject: Subject, failed: u8) -> Evidence {
    let trial = Trial::by(route, subject, Compared::one("$a$", "$b$"), MOTION);
    trial.over(0..20, |n| {
        Ok(Pair {
            at: format!("n = {n}"),
            stated: if n < failed { 1.0 } else { 1e-16 },
            found: 0.0,
            scale: 1.0,
        })
    })
}

/// Trials by these routes, on these subjects, with so many disagreements each.
macro_rules! trials {
    ($($route:ident $subject:ident $failed:literal),*) => {
        &[$(Attempt::measured(
            || tried(Route::$route, Subject::$subject, $failed),
            || concat!("example::", stringify!($route), stringify!($subject)),
        )),*]
    };
}
pub(crate) use trials;

const NEEDED: &[Condition] = &[Condition {
    text: "$x>0$",
    sort: Sort::Substance,
}];

static CLAIMS: [Claim; 8] = [
    Claim::equation("eq-1", "1", "an error", "a=1")
        .corrected(Change::Statement, "a=2")
        .tried(trials![Root Printed 3, Root Corrected 0, Limit Corrected 0]),
    // It rests on (1), and its own step fails.
    Claim {
        depends_on: &["eq-1"],
        ..Claim::equation("eq-2", "1", "another error", "b=1")
            .corrected(Change::Statement, "b=2")
            .tried(trials![Root Printed 5, Census Step 20, Root Corrected 0, Limit Corrected 0])
    },
    Claim {
        depends_on: &["eq-1", "eq-2"],
        ..Claim::equation("eq-3", "1", "an heir of both", "c=1")
            .tried(trials![Root Printed 20, Census Step 0])
    },
    Claim::equation("eq-4", "2", "a misprint", "d=1")
        .corrected(Change::Sign, "d=-1")
        .tried(trials![Root Printed 20, Root Corrected 0, Limit Corrected 0]),
    Claim {
        conditions: NEEDED,
        ..Claim::equation("eq-5", "2", "too much is said", "e=1")
            .tried(trials![Root Within 0, Limit Within 0, Root Outside 7, Limit Outside 4])
    },
    Claim {
        depends_on: &["eq-4"],
        ..Claim::equation("eq-6", "2", "right beside the misprint", "f=1")
            .tried(trials![Exact Printed 0])
    },
    Claim {
        depends_on: &["eq-5"],
        ..Claim::equation("eq-7", "2", "right under the condition", "g=1")
            .tried(trials![Certified Printed 0])
    },
    Claim::equation("eq-8", "2", "right", "h=1").tried(trials![Exact Printed 0]),
];

pub(crate) static PAPER: Paper = Paper {
    title: "Examples",
    authors: "N. N.",
    topics: &[Topic::new("examples", "Examples", &CLAIMS)],
    ..Paper::BLANK
};

/// The claims, tried and judged.
pub(crate) fn ledger() -> Ledger {
    Ledger::try_all(&PAPER, |_| {})
}
