//! Numbers and verdicts in the book's prose are the ledger's: a number stands in a claim, in the index of values, in a
//! case by hand, or in the code of the same page, which runs as a test; a verdict stands in a placeholder.

use slipbook::claims::{PAPER, by_hand::CASES, values::VALUES};
use slipbook::ledger::{Format, Ledger, plain_words};
use std::fs;
use std::path::Path;

/// Pages that explain what verdicts are, and so name them.
const ON_VERDICTS: [&str; 6] = ["methods", "adding", "own", "snapshots", "errata", "map"];

/// The pages: stem, prose with formulas, and code.
fn pages() -> Vec<(String, String, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("book/src");
    let mut pages = Vec::new();
    for file in fs::read_dir(folder).unwrap() {
        let path = file.unwrap().path();
        let text = fs::read_to_string(&path).unwrap();
        let (mut prose, mut code, mut fenced) = (String::new(), String::new(), false);
        for line in text.lines() {
            if line.starts_with("```") {
                fenced = !fenced;
            } else {
                let to = if fenced { &mut code } else { &mut prose };
                to.push_str(line);
                to.push('\n');
            }
        }
        let stem = path.file_stem().unwrap().to_str().unwrap().to_owned();
        pages.push((stem, without(&without(&prose, "{{", "}}"), "`", "`"), code));
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

/// The decimals in a text, with what stands before each.
fn decimals(text: &str) -> Vec<(&str, &str)> {
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(start) = text[at..]
        .find(|c: char| c.is_ascii_digit())
        .map(|i| at + i)
    {
        let end = text[start..].find(|c: char| !(c.is_ascii_digit() || c == '.'));
        let end = end.map_or(text.len(), |i| start + i);
        let number = text[start..end].trim_end_matches('.');
        if number.contains('.') {
            found.push((number, text[..start].trim_end()));
        }
        at = end;
    }
    found
}

/// All numbers that the claims vouch for.
fn vouched() -> Vec<f64> {
    let mut numbers: Vec<f64> = VALUES.iter().map(|value| value.number().unwrap()).collect();
    for case in &CASES {
        numbers.extend([(case.stated)().unwrap(), (case.found)().unwrap()]);
        let words = case.words().unwrap();
        numbers.extend(
            decimals(&words)
                .iter()
                .filter_map(|(number, _)| number.parse::<f64>().ok()),
        );
    }
    for (_, claim) in PAPER.claims() {
        numbers.extend(
            decimals(claim.plain)
                .iter()
                .filter_map(|(number, _)| number.parse::<f64>().ok()),
        );
    }
    numbers
}

fn is_vouched(number: &str, numbers: &[f64]) -> bool {
    let decimals = number.len() - number.find('.').unwrap() - 1;
    let value: f64 = number.parse().unwrap();
    let half = 0.5 * 0.1_f64.powi(decimals as i32) * (1.0 + 1e-9);
    numbers
        .iter()
        .any(|known| (known.abs() - value).abs() <= half)
}

/// A number in code as a number of its own, or at its full length within a longer one.
fn in_code(number: &str, code: &str) -> bool {
    code.match_indices(number)
        .any(|(at, _)| !code[..at].ends_with(|c: char| c.is_ascii_digit() || c == '.'))
}

#[test]
fn every_number_in_the_prose_has_a_source() {
    let numbers = vouched();
    let mut without_source = Vec::new();
    for (stem, prose, code) in pages() {
        for (number, before) in decimals(&prose) {
            let word = before
                .rsplit([' ', '\n', '(', '*'])
                .next()
                .unwrap_or_default()
                .to_lowercase();
            let section = ["section", "of", "before", "to", "[section"].contains(&word.as_str())
                && number.len() == 3
                && number.starts_with(['2', '3']);
            if !section && !in_code(number, &code) && !is_vouched(number, &numbers) {
                let context: String = before
                    .chars()
                    .rev()
                    .take(40)
                    .collect::<Vec<_>>()
                    .into_iter()
                    .rev()
                    .collect();
                without_source.push(format!("{stem}.md: {}{number}", context.replace('\n', " ")));
            }
        }
    }
    assert!(
        without_source.is_empty(),
        "numbers from nowhere:\n{}",
        without_source.join("\n")
    );
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
    for (stem, prose, _) in pages() {
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

#[test]
fn a_number_from_nowhere_is_seen() {
    let text = "by 0.4321 in section 2.1, at 3.";
    assert_eq!(
        decimals(text)
            .iter()
            .map(|(number, _)| *number)
            .collect::<Vec<_>>(),
        ["0.4321", "2.1"]
    );
    assert!(!is_vouched("0.4321", &vouched()) && is_vouched("0.5370", &vouched()));
    assert!(in_code("0.5", "let x = 0.5;") && !in_code("0.5", "let x = 10.5;"));
    assert_eq!(without("a {{b}} c", "{{", "}}"), "a   c");
}
