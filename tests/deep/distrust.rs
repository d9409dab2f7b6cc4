//! Mistakes are seeded in what the trials read: each trial notices one at least, and one of twice its tolerance, and what it finds
//! stays where it is.

use slipbook::claims::{PAPER, variants::Variant};
use slipbook::ledger::{
    Key, Ledger,
    distrust::{Extent, Tried},
};
use std::collections::BTreeSet;
use trialbook::trials::{Claim, Excuse, Topic, attempt::Attempt};

#[test]
fn every_trial_notices_mistakes() {
    let variants = PAPER.formulas.variants();
    let topics = PAPER.topics.iter().copied();
    let wrong = topics.filter_map(|topic| Some((topic.stem, distrust(topic, &variants).err()?)));
    let wrong: Vec<_> = wrong.collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}

fn distrust(topic: &Topic, variants: &[Variant]) -> Result<(), String> {
    let ids: Vec<_> = topic.claims().iter().map(|claim| claim.id).collect();
    let ledger = Ledger::try_some(&PAPER, &ids, |_| {});
    let tried = ledger.distrust(variants, Extent::Few, || {});
    let key = |t: &Tried| ledger.entries[t.entry].key(t.trial);
    let leaning = tried.iter().filter(|t| t.leans_on().is_some());
    let leaning: Vec<_> = leaning.map(|t| key(t).to_string()).collect();
    let idle = tried.iter().filter(|t| t.agrees && t.rejected() == 0);
    let idle: BTreeSet<_> = idle.map(key).collect();
    let excused = attempts(&ledger).filter(|(_, attempt)| attempt.idle.is_some());
    let excused: BTreeSet<_> = excused.map(|(key, _)| key).collect();
    let wrong = idle.symmetric_difference(&excused);
    let wrong: Vec<_> = wrong.map(Key::to_string).collect();
    let of_topic = |id: &str| topic.claims().iter().any(|claim| claim.id == id);

    let slight = ledger.slight();
    let coarse = slight.iter().filter(|s| !s.noticed);
    let coarse = coarse.map(|s| (ledger.entries[s.entry].key(s.trial), s.formula));
    let coarse: BTreeSet<_> = coarse.collect();
    let excused = attempts(&ledger).flat_map(|(key, attempt)| {
        let formulas = attempt.coarse.iter();
        formulas.map(move |excuse| (key, excuse.of))
    });
    let excused: BTreeSet<_> = excused.collect();
    let coarse: Vec<_> = coarse.symmetric_difference(&excused).collect();

    let mut corners = PAPER.corners();
    corners.retain(|variant| of_topic(&variant.claim));
    let noticed = ledger.noticed(&corners);
    let those = |noticed_by: Option<bool>| {
        let pairs = corners.iter().zip(&noticed);
        let those = pairs.filter(move |(_, noticed)| **noticed == noticed_by);
        those.map(|(variant, _)| variant)
    };
    let cornered = those(Some(false)).map(|v| (v.claim.as_str(), v.text.as_str()));
    let cornered: BTreeSet<_> = cornered.collect();
    let of = |list: fn(&Claim) -> &'static [Excuse]| -> BTreeSet<_> {
        let claims = topic.claims().iter();
        let pairs = claims.flat_map(|claim| list(claim).iter().map(|excuse| (claim.id, excuse.of)));
        pairs.collect()
    };
    let excused = of(|claim| claim.cornered);
    let cornered: Vec<_> = cornered.symmetric_difference(&excused).collect();

    let unread = those(None).map(|v| (v.claim.as_str(), v.formula));
    let unread: BTreeSet<_> = unread.collect();
    let excused = of(|claim| claim.unread);
    let unread: Vec<_> = unread.symmetric_difference(&excused).collect();

    let silent = [
        wrong.len(),
        leaning.len(),
        coarse.len(),
        cornered.len(),
        unread.len(),
    ];
    if silent == [0; 5] {
        return Ok(());
    }
    Err(format!(
        "notice nothing without a reason, or have one for nothing: {wrong:#?}; find something else, or in other units: \
         {leaning:#?}; do not notice twice the tolerance, or do: {coarse:#?}; nobody notices a corner, or somebody does: \
         {cornered:#?}; no measurement reads, or one does: {unread:#?}"
    ))
}

fn attempts(ledger: &Ledger) -> impl Iterator<Item = (Key, &'static Attempt)> {
    ledger.entries.iter().flat_map(|entry| {
        let trials = entry.claim.trials.iter().enumerate();
        trials.map(|(i, attempt)| (entry.key(i), attempt))
    })
}
