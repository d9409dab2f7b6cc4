//! The README's table of verdicts is the ledger's.

use slipbook::claims::PAPER;
use slipbook::ledger::{Ledger, Verdict};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

#[test]
fn the_table_of_verdicts_is_the_ledgers() {
    let ledger = Ledger::try_all(&PAPER, |_| {});
    let mut rows: Vec<(&str, BTreeMap<Verdict, usize>)> = Vec::new();
    for entry in &ledger.entries {
        let title = entry.topic.title;
        if rows.last().is_none_or(|(last, _)| *last != title) {
            rows.push((title, BTreeMap::new()));
        }
        let counts = &mut rows.last_mut().unwrap().1;
        *counts.entry(entry.judgement.verdict).or_default() += 1;
    }
    rows.push(("**all**", ledger.counts()));
    let cells = |cells: Vec<String>| format!("| {} |\n", cells.join(" | "));
    let words = Verdict::ALL.iter().map(|v| v.words().to_owned());
    let mut table = cells([String::from("topic")].into_iter().chain(words).collect());
    table += &cells(vec!["---".into(); Verdict::ALL.len() + 1]);
    for (title, counts) in rows {
        let count = |v: &Verdict| counts.get(v).map_or(String::new(), usize::to_string);
        let numbers = Verdict::ALL.iter().map(count);
        table += &cells([title.to_owned()].into_iter().chain(numbers).collect());
    }
    let readme = Path::new(env!("CARGO_MANIFEST_DIR")).join("README.md");
    let text = fs::read_to_string(&readme).unwrap();
    let (begin, end) = ("<!-- verdicts -->\n", "<!-- /verdicts -->\n");
    let (before, rest) = text.split_once(begin).expect("a table of verdicts");
    let (old, after) = rest.split_once(end).expect("the end of the table");
    if old != table {
        fs::write(&readme, [before, begin, &table, end, after].concat()).unwrap();
        panic!("README.md had another table of verdicts; look at the new one");
    }
}

#[test]
fn the_picture_is_fig_1() {
    let figures = slipbook::figures::all().unwrap();
    let portrait = figures.iter().find(|figure| figure.id == "fig-1").unwrap();
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(concat!(env!("CARGO_MANIFEST_DIR"), "/snapshots/constant"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    let picture = portrait.svg.clone().into_bytes();
    settings.bind(|| insta::assert_binary_snapshot!("portrait.svg", picture));
}
