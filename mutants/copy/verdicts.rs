//! Tries claims, or all, with the mistake of the given number made, 0 for none. On a line each: a claim's id, its verdict, and
//! its measurements: route, subject, what they say, points, worst disagreement, all that was found in a number, and how many
//! comparisons disagree.
//!
//! With `passed` for a number: the numbers of the mistakes whose place is passed as the claims are tried, with none made.

use slipbook_wrong::claims::PAPER;
use slipbook_wrong::evidence::Evidence;
use slipbook_wrong::ledger::Ledger;

fn main() {
    let mut arguments = std::env::args().skip(1);
    let number = arguments.next().expect("the number of a mistake");
    let ids: Vec<String> = arguments.collect();
    let ids: Vec<&str> = ids.iter().map(String::as_str).collect();
    let tried = || match ids.is_empty() {
        true => Ledger::try_all(&PAPER, |_| {}),
        false => Ledger::try_some(&PAPER, &ids, |_| {}),
    };
    if number == "passed" {
        slipbook_wrong::go_wrong(slipbook_wrong::NOTED);
        tried();
        let passed: Vec<_> = slipbook_wrong::passed().map(|n| n.to_string()).collect();
        println!("{}", passed.join(" "));
        return;
    }
    slipbook_wrong::go_wrong(number.parse().expect("the number of a mistake"));
    for entry in &tried().entries {
        let measured = entry.evidence.iter().filter(|e| !e.route.is_proof());
        let trials: String = measured
            .map(|e| {
                let (says, found) = (e.outcome(), e.sides.found);
                let Evidence { route, subject, points, worst, failed, .. } = e;
                format!("\t{route:?} {subject:?} {says:?} {points} {worst:e} {found:016x} {failed}").to_lowercase()
            })
            .collect();
        let verdict = entry.judgement.verdict.slug();
        println!("{}\t{verdict}{trials}", entry.claim.id);
    }
}
