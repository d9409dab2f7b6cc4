//! A verdict in the book's prose stands in a placeholder; and the letters hold what fails. Numbers in prose: `tests/print/prose`.

use slipbook::claims::{PAPER, by_hand::CASES};
use slipbook::ledger::{Format, Ledger, plain_words};
use std::fs;
use std::path::Path;

/// Pages that explain what verdicts are, and so name them.
const ON_VERDICTS: [&str; 6] = ["methods", "adding", "own", "snapshots", "errata", "map"];

/// The pages: stem, and prose with formulas.
fn pages() -> Vec<(String, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("book/src");
    let mut pages = Vec::new();
    for file in fs::read_dir(folder).unwrap() {
        let path = file.unwrap().path();
        let text = fs::read_to_string(&path).unwrap();
        let (mut prose, mut fenced) = (String::new(), false);
        for line in text.lines() {
            if line.starts_with("```") {
                fenced = !fenced;
            } else if !fenced {
                prose.push_str(line);
                prose.push('\n');
            }
        }
        let stem = path.file_stem().unwrap().to_str().unwrap().to_owned();
        pages.push((stem, without(&without(&prose, "{{", "}}"), "`", "`")));
    }
    pages.sort();
    pages
}

/// A text without what stands between two marks.
fn without(text: &str, open: &str, close: &str) -> String {
    let mut out = String::new();
    let mut rest = text;
    while let Some((before, after)) = rest.split_once(open) {
        out.push_str(before);
        out.push(' ');
        rest = after.split_once(close).map_or("", |(_, after)| after);
    }
    out + rest
}

#[test]
fn the_letters_can_be_sent() {
    let ledger = Ledger::try_all(&PAPER, |_| {});
    let [text, latex, json] =
        [Format::Text, Format::Latex, Format::Json].map(|format| ledger.letter(format).unwrap());
    for case in &CASES {
        let name = plain_words(&ledger.name(case.claim));
        assert!(text.contains(&name), "{name}");
        assert!(json.contains(&format!("\"id\": \"{}\"", case.claim)));
    }
    assert!(text.lines().all(|line| line.chars().count() <= 78));
    let foreign: Vec<_> = latex.chars().filter(|c| !c.is_ascii()).collect();
    assert!(foreign.is_empty(), "no LaTeX for {foreign:?}");
    assert!(!latex.contains("$$") && latex.matches('$').count() % 2 == 0);
}

#[test]
fn no_page_passes_a_verdict_of_its_own() {
    for (stem, prose) in pages() {
        if ON_VERDICTS.contains(&stem.as_str()) {
            continue;
        }
        for word in ["refuted", "misprint", "confirmed", "undecided"] {
            assert!(
                !prose.to_lowercase().contains(word),
                "{stem}.md says \"{word}\" in its own words"
            );
        }
    }
}
