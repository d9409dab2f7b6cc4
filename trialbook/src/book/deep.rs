//! What a deep run has brought.

use super::{
    context::Context,
    error::Html,
    table::tried,
    text::{count, counted, escape, size},
};
use crate::evidence::{Evidence, Route};
use crate::ledger::Entry;
use std::collections::BTreeMap;

pub(super) fn line(context: &Context<'_>, entry: &Entry) -> String {
    let deep = context.deep.as_ref();
    let Some(entry) = deep.and_then(|(_, ledger)| ledger.entry(entry.claim.id)) else {
        return String::new();
    };
    let Some(closest) = entry.closest() else {
        return String::new();
    };
    let points = entry.measured().map(|e| e.points).sum();
    let worst = match closest.tolerance.value {
        0.0 => "all agree, and no disagreement is allowed".to_owned(),
        allowed => format!(
            "worst disagreement {} where {} is allowed",
            size(closest.worst),
            size(allowed)
        ),
    };
    format!(
        "<p>{}: {}, {worst}.</p>",
        context.explained("Deep run", "deep"),
        counted(points, "point"),
    )
}

pub(super) fn table_of(context: &Context<'_>) -> Html {
    let Some((deep, ledger)) = &context.deep else {
        return Ok("<p>No deep run is recorded.</p>".to_owned());
    };
    let mut routes: BTreeMap<Route, Vec<(&Entry, &Evidence)>> = BTreeMap::new();
    for entry in &ledger.entries {
        for e in entry.measured().filter(|e| e.points > 0) {
            routes.entry(e.route).or_default().push((entry, e));
        }
    }
    let row = |(route, trials): (Route, Vec<(&Entry, &Evidence)>)| {
        let points = trials.iter().map(|(_, e)| e.points).sum();
        let fewest = trials.iter().map(|(_, e)| e.points).min();
        let part = |entry: &Entry| {
            let e = entry.closest().filter(|e| e.route == route)?;
            (e.worst > 0.0).then(|| e.worst / e.tolerance.value)
        };
        let parts = trials
            .iter()
            .filter_map(|(entry, _)| Some((*entry, part(entry)?)));
        let closest = match parts.max_by(|a, b| a.1.total_cmp(&b.1)) {
            None => String::new(),
            Some((entry, part)) => {
                let link = context.link(entry)?;
                format!("{:.0} % of it, {link}", 100.0 * part)
            }
        };
        Ok([
            route.name().to_owned(),
            count(trials.len()),
            count(points),
            count(fewest.unwrap_or(0)),
            closest,
        ])
    };
    let head = [
        "By",
        "Trials",
        "Points",
        "Fewest of a trial",
        "Closest to its tolerance",
    ];
    Ok(format!(
        "<p>As of {}, in {} and {}:</p>\n{}",
        escape(deep.made),
        counted(deep.rounds as usize, "round"),
        counted(deep.comparisons, "comparison"),
        tried("deep", head, routes.into_iter().map(row))?
    ))
}

#[cfg(test)]
mod tests {
    use super::*;
    use super::{super::code::Code, super::maths::Maths};
    use crate::ledger::{
        deep::Deep,
        example::{PAPER, ledger},
    };
    use crate::publishing::Edition;

    static EDITION: Edition = Edition::of("examples", &PAPER);

    #[test]
    fn a_row_has_all_points_of_a_route_and_the_fewest_of_a_trial() {
        let mut ledger = ledger();
        ledger.entries[0].evidence[0].points += 30;
        let record = ledger.record("commit 0, 2026-01-02", 3);
        let deep = Deep::read(&record).unwrap();
        // A trial that has come since has nothing to show.
        let mut since = deep.in_place_of(&ledger);
        let another = Evidence {
            points: 0,
            ..since.entries[0].evidence[0].clone()
        };
        since.entries[0].evidence.push(another);
        let context = Context {
            edition: &EDITION,
            ledger: &ledger,
            figures: &[],
            errata: &[],
            code: &Code::new(&EDITION),
            maths: &Maths::new(),
            deep: Some((deep, since)),
        };
        let html = table_of(&context).unwrap();
        // Nine trials by root-finding, five by a limit and two counts have twenty points each, and one has thirty more.
        for row in [
            "<td>root</td><td>9</td><td>210</td><td>20</td>",
            "<td>limit</td><td>5</td><td>100</td><td>20</td>",
            "<td>census</td><td>2</td><td>40</td><td>20</td>",
        ] {
            assert!(html.contains(row), "{row}\n{html}");
        }
        assert_eq!(html.matches("<tr>").count(), 4);
        assert!(
            html.starts_with("<p>As of commit 0, 2026-01-02, in 3 rounds and 350 comparisons:</p>"),
            "{html}"
        );
        let without = Context {
            deep: None,
            ..context
        };
        assert_eq!(
            table_of(&without).unwrap(),
            "<p>No deep run is recorded.</p>"
        );
    }
}
