//! What a trial need not notice, and which wrong variant may stand, each with its reason.

use super::{context::Context, error::Html, table::tried, text::in_code};
use crate::ledger::Entry;
use crate::trials::{Claim, Excuse, attempt::Attempt};

/// `survivors`, wrong variants that are not rejected; `cornered`, mistakes in a corner that no measurement
/// notices, and the formulas that none reads.
pub(super) fn excused(context: &Context<'_>, name: &'static str) -> Html {
    type Lists = &'static [fn(&Claim) -> &[Excuse]];
    let head = ["Claim", "Wrong variant", "Why it stands"];
    let lists: Lists = match name {
        "survivors" => &[|claim| claim.survivors],
        _ => &[|claim| claim.cornered, |claim| claim.unread],
    };
    let entries = || context.ledger.entries.iter();
    let all = lists.iter().flat_map(|list| {
        entries().flat_map(move |entry| list(entry.claim).iter().map(move |excuse| (entry, excuse)))
    });
    let rows = all.map(|(entry, excuse)| {
        let why = context.maths.words(excuse.why)?;
        Ok([context.link(entry)?, in_code(excuse.of), why])
    });
    tried(name, head, rows)
}

fn trials<'a>(context: &Context<'a>) -> impl Iterator<Item = (&'a Entry, &'static Attempt)> {
    let entries = context.ledger.entries.iter();
    entries.flat_map(|entry| entry.claim.trials.iter().map(move |trial| (entry, trial)))
}

/// `coarse`, where measurements do not notice a mistake of twice their tolerance; `spared`, where proofs do
/// not reject every wrong variant.
pub(super) fn excused_trials(context: &Context<'_>, name: &'static str) -> Html {
    type List = fn(&Attempt) -> &'static [Excuse];
    let (head, list): (_, List) = match name {
        "spared" => (
            [
                "Claim",
                "Proof",
                "Formula",
                "Why the proof does not reject all",
            ],
            |trial| trial.spared,
        ),
        _ => (
            ["Claim", "Trial", "Formula", "Why it does not show"],
            |trial| trial.coarse,
        ),
    };
    let all = trials(context)
        .flat_map(|(entry, trial)| list(trial).iter().map(move |excuse| (entry, trial, excuse)));
    let rows = all.map(|(entry, trial, excuse)| {
        Ok([
            context.link(entry)?,
            in_code(trial.name()),
            in_code(excuse.of),
            context.maths.words(excuse.why)?,
        ])
    });
    tried(name, head, rows)
}

pub(super) fn idle(context: &Context<'_>) -> Html {
    let idle = trials(context).filter_map(|(entry, trial)| Some((entry, trial, trial.idle?)));
    let rows = idle.map(|(entry, trial, why)| {
        let why = context.maths.words(why)?;
        Ok([context.link(entry)?, in_code(trial.name()), why])
    });
    let head = ["Claim", "Trial", "What no formula says"];
    tried("idle", head, rows)
}
