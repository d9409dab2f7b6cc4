//! Tries the ledger with the mistake of the given number made, 0 for none. On a line each: a claim's id, its verdict, and
//! its trials with what they say.

use slipbook_wrong::claims::PAPER;
use slipbook_wrong::ledger::Ledger;

fn main() {
    let number = std::env::args().nth(1).and_then(|n| n.parse().ok());
    slipbook_wrong::go_wrong(number.expect("the number of a mistake"));
    let ledger = Ledger::try_all(&PAPER, |_| {});
    for entry in &ledger.entries {
        let trials = entry.evidence.iter();
        let trials: String = trials
            .map(|e| format!("\t{} {:?} {:e}", e.trial, e.outcome(), e.worst))
            .collect();
        let verdict = entry.judgement.verdict.slug();
        println!("{}\t{verdict}{trials}", entry.claim.id);
    }
}
