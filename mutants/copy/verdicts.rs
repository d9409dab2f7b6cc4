//! Tries the ledger with the mistake of the given number made, 0 for none. On a line each: a claim's id, its verdict, and
//! its trials: name, what they say, route, points, worst disagreement, in a number each all that was found, stated and taken
//! for a scale, and how many comparisons disagree.

use slipbook_wrong::claims::PAPER;
use slipbook_wrong::evidence::{Evidence, Sides};
use slipbook_wrong::ledger::Ledger;

fn main() {
    let number = std::env::args().nth(1).and_then(|n| n.parse().ok());
    slipbook_wrong::go_wrong(number.expect("the number of a mistake"));
    let ledger = Ledger::try_all(&PAPER, |_| {});
    for entry in &ledger.entries {
        let trials = entry.evidence.iter();
        let trials: String = trials
            .map(|e| {
                let (says, route) = (e.outcome(), e.route.name());
                let Evidence { trial, points, worst, failed, .. } = e;
                let Sides { stated, found, scale } = e.sides;
                format!(
                    "\t{trial} {says:?} {route} {points} {worst:e} {found:016x} {stated:016x} {scale:016x} {failed}"
                )
            })
            .collect();
        let verdict = entry.judgement.verdict.slug();
        println!("{}\t{verdict}{trials}", entry.claim.id);
    }
}
