//! A paper made up for the tests: what each claim comes to can be told by counting.

use super::Ledger;
use crate::evidence::{Evidence, Route, Subject};
use crate::trials::{
    Paper, Topic,
    attempt::Attempt,
    compare::{Pair, Trial},
    read::claims,
    tolerances::MOTION,
};

/// Twenty points, at so many of which what is stated is off by 1; the last agree but for a rounding.
pub(crate) fn tried(route: Route, subject: Subject, failed: u8) -> Evidence {
    let trial = Trial::by(route, subject, ["$a$", "$b$"], MOTION);
    trial.over(0..20, |n| {
        Ok(Pair {
            at: format!("n = {n}"),
            stated: if n < failed { 1.0 } else { 1e-16 },
            found: 0.0,
            scale: 1.0,
        })
    })
}

/// Trials by these routes, on these subjects, with so many disagreements each: `example::RootPrinted3`.
macro_rules! trials {
    ($($route:ident $subject:ident $failed:literal),*) => {
        &[$(Attempt::measured(
            || tried(Route::$route, Subject::$subject, $failed),
            concat!("example::", stringify!($route), stringify!($subject), $failed),
        )),*]
    };
}

static TOPIC: Topic = Topic::new(
    "examples",
    "Examples",
    claims!("src/ledger/example.toml"),
    &[trials![
        Root Printed 3, Root Printed 5, Root Printed 20, Root Corrected 0, Limit Corrected 0, Census Step 0, Census Step 20,
        Root Within 0, Limit Within 0, Root Outside 7, Limit Outside 4, Exact Printed 0, Certified Printed 0
    ]],
);

pub(crate) static PAPER: Paper = Paper {
    title: "Examples",
    authors: "N. N.",
    topics: &[&TOPIC],
    ..Paper::BLANK
};

pub(crate) static CHAIN: Topic = Topic::new(
    "heirs",
    "Heirs",
    claims!("src/ledger/chain.toml"),
    &[trials![Root Printed 20, Root Corrected 0, Limit Corrected 0, Census Step 0]],
);

pub(crate) fn ledger() -> Ledger {
    Ledger::try_all(&PAPER, |_| {})
}
