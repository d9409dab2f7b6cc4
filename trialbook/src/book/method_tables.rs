//! How claims are tried: the routes, the tolerances, and how closely what was measured agrees.

use super::{
    context::Context,
    error::Html,
    table::{table, tried},
    text::{count, size},
};
use crate::evidence::{Evidence, Route, Tolerance};
use crate::ledger::Ledger;
use std::collections::BTreeMap;

pub(super) fn routes(ledger: &Ledger) -> String {
    const ALL: [(Route, &str); 8] = [
        (Route::Exact, "zero-testing in exact arithmetic"),
        (
            Route::Certified,
            "an enclosure by intervals, rounded outwards",
        ),
        (Route::Integration, "integration of the equation of motion"),
        (
            Route::Quadrature,
            "numerical integration of a given integrand",
        ),
        (Route::Root, "root-finding"),
        (Route::Limit, "the approach to a limit, its rate included"),
        (Route::Census, "a count over many cases"),
        (
            Route::Consistency,
            "dimensions, and the use made of a definition",
        ),
    ];
    let rows = ALL.map(|(route, what)| {
        let trials = ledger.evidence().filter(|e| e.route == route).count();
        let proves = match route.is_proof() {
            true => "proves",
            false => "measures",
        };
        [
            route.name().to_owned(),
            what.to_owned(),
            proves.to_owned(),
            count(route.min_points()),
            count(trials),
        ]
    });
    table(
        "routes",
        ["Route", "What it is", "It", "Fewest points", "Trials"],
        rows,
    )
}

pub(super) fn tolerances(context: &Context<'_>) -> Html {
    let mut uses: BTreeMap<&str, (Tolerance, usize)> = BTreeMap::new();
    for evidence in context.ledger.evidence() {
        let tolerance = evidence.tolerance;
        uses.entry(tolerance.name).or_insert((tolerance, 0)).1 += 1;
    }
    let mut uses: Vec<_> = uses.into_values().collect();
    uses.sort_by(|(a, _), (b, _)| a.value.total_cmp(&b.value));
    let rows = uses.into_iter().map(|(tolerance, trials)| {
        let reason = context.maths.words(tolerance.reason)?;
        Ok([size(tolerance.value), reason, count(trials)])
    });
    tried("tolerances", ["Tolerance", "Reason", "Trials"], rows)
}

pub(super) fn accuracy(context: &Context<'_>) -> Html {
    let entries = context.ledger.entries.iter();
    let measured = entries.filter_map(|entry| Some((entry, entry.closest()?)));
    let rows = measured.map(|(entry, closest)| {
        let [points, worst, tolerance] = sizes(closest);
        Ok([
            context.link(entry)?,
            closest.route.name().to_owned(),
            closest
                .subject
                .words(entry.is_conditional(), entry.claim.ours)
                .to_owned(),
            points,
            worst,
            tolerance,
        ])
    });
    let head = [
        "Claim",
        "By",
        "What",
        "Points",
        "Worst disagreement",
        "Tolerance",
    ];
    tried("accuracy", head, rows)
}

fn sizes(measured: &Evidence) -> [String; 3] {
    [
        count(measured.points),
        size(measured.worst),
        size(measured.tolerance.value),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evidence::Subject;

    #[test]
    fn a_measurement_is_told_by_what_was_found_and_then_by_what_is_allowed() {
        let measured = crate::ledger::example::tried(Route::Root, Subject::Printed, 3);
        let allowed = size(measured.tolerance.value);
        assert_eq!(sizes(&measured), ["20".to_owned(), size(1.0), allowed]);
    }
}
