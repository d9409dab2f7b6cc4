//! Tries the ledger with the mistake of the given number made, 0 for none. On a line each: a claim's id, its verdict, and
//! its trials: name, what they say, route, points, worst disagreement, and all that was found in one number.

use slipbook_wrong::claims::PAPER;
use slipbook_wrong::evidence::Evidence;
use slipbook_wrong::ledger::Ledger;

fn main() {
    let number = std::env::args().nth(1).and_then(|n| n.parse().ok());
    slipbook_wrong::go_wrong(number.expect("the number of a mistake"));
    let ledger = Ledger::try_all(&PAPER, |_| {});
    for entry in &ledger.entries {
        let trials = entry.evidence.iter();
        let trials: String = trials
            .map(|e| {
                let (says, route, found) = (e.outcome(), e.route.name(), e.sides.found);
                let Evidence { trial, points, worst, .. } = e;
                format!("\t{trial} {says:?} {route} {points} {worst:e} {found:016x}")
            })
            .collect();
        let verdict = entry.judgement.verdict.slug();
        println!("{}\t{verdict}{trials}", entry.claim.id);
    }
}
