//! One test per claim: it is tried, judged, and its sheet held against `snapshots/<topic>/<id>.snap`.
//!
//! `cargo insta review` shows a change as claim, formula, values and verdict.

use insta::{Settings, assert_snapshot};
use libtest_mimic::{Arguments, Failed, Trial};
use slipbook::ledger::{Ledger, Record};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::Arc;

fn main() {
    // One after another, or the differences of several claims are printed into each other.
    let arguments = Arguments {
        test_threads: Some(1),
        ..Arguments::from_args()
    };
    let ledger = Arc::new(Ledger::try_all(|_| {}));
    let mut trials: Vec<_> = (0..ledger.entries.len())
        .map(|i| {
            let entry = &ledger.entries[i];
            let name = format!("{}::{}", entry.topic.stem, entry.claim.id);
            let ledger = Arc::clone(&ledger);
            Trial::test(name, move || {
                let entry = &ledger.entries[i];
                same_as_snapshot(entry.topic.stem, entry.claim.id, &entry.sheet())
            })
        })
        .collect();
    let record = Record::text_of(&ledger);
    trials.push(Trial::test("verdicts", move || {
        same_as_snapshot("", "verdicts", &record)
    }));
    let conclusion = libtest_mimic::run(&arguments, trials);
    let tried = ledger
        .entries
        .iter()
        .filter(|e| !e.evidence.is_empty())
        .count();
    println!(
        "{tried} of {} claims tried, in {} comparisons; {}\n",
        ledger.entries.len(),
        ledger.points(),
        ledger.summary()
    );
    conclusion.exit();
}

fn same_as_snapshot(folder: &str, name: &str, text: &str) -> Result<(), Failed> {
    let mut settings = Settings::clone_current();
    settings.set_snapshot_path(format!("{}/snapshots/{folder}", env!("CARGO_MANIFEST_DIR")));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    let same = || settings.bind(|| assert_snapshot!(name, text));
    catch_unwind(AssertUnwindSafe(same))
        .map_err(|_| format!("{name} differs from its snapshot: run `cargo insta review`").into())
}
