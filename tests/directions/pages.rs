//! The pages' own prose: a direction in it is computed, or stands in a list by which a change of it shows.

use crate::directed;
use crate::said::SAID;
use slipbook::claims::PAPER;
use slipbook::claims::by_hand::CASES;
use slipbook::claims::measured::MEASURED;
use slipbook::claims::values::VALUES;
use std::collections::BTreeSet;
use std::fs;

/// The words with a direction that nothing here computes.
const LISTED: &str = include_str!("../data/directions.txt");

/// The pages, and what the repository's own says.
pub fn pages() -> Vec<String> {
    let files = fs::read_dir("book/src").unwrap();
    let names = files.map(|file| file.unwrap().file_name().into_string().unwrap());
    let mut pages: Vec<_> = names
        .filter_map(|name| Some(name.strip_suffix(".md")?.to_owned()))
        .collect();
    pages.push("README".to_owned());
    pages.sort();
    pages
}

fn text_of(page: &str) -> String {
    let file = match page {
        "README" => "README.md".to_owned(),
        _ => format!("book/src/{page}.md"),
    };
    fs::read_to_string(file).unwrap()
}

const WORDS: &[&str] = &[
    "above",
    "across",
    "against",
    "ahead",
    "along",
    "always",
    "attracts",
    "backward",
    "backwards",
    "behind",
    "below",
    "both",
    "clockwise",
    "converges",
    "counterclockwise",
    "decreases",
    "difference",
    "diverges",
    "downwards",
    "earlier",
    "exceeds",
    "excluded",
    "exponentially",
    "fall",
    "falls",
    "farther",
    "fast",
    "faster",
    "fastest",
    "finite",
    "first",
    "forward",
    "forwards",
    "free",
    "gains",
    "grow",
    "growing",
    "grows",
    "higher",
    "horizontal",
    "included",
    "increases",
    "infinite",
    "inner",
    "inside",
    "inverse",
    "inwards",
    "larger",
    "largest",
    "last",
    "later",
    "least",
    "left",
    "less",
    "linearly",
    "longer",
    "loses",
    "lower",
    "more",
    "most",
    "nearer",
    "negative",
    "never",
    "not",
    "opposite",
    "outer",
    "outside",
    "outwards",
    "positive",
    "right",
    "rise",
    "rises",
    "same",
    "second",
    "shorter",
    "shrink",
    "shrinks",
    "slow",
    "slower",
    "slowest",
    "slowly",
    "smaller",
    "sooner",
    "stable",
    "steeper",
    "strong",
    "stronger",
    "sum",
    "unbounded",
    "unstable",
    "upwards",
    "vanishes",
    "vertical",
    "weak",
    "weaker",
    "wrong",
];

/// A page on one line: without code and placeholders, a formula as §.
pub fn flat(page: &str) -> String {
    let text = text_of(page);
    let odd_out = |text: &str, mark: &str, instead: &str| -> String {
        let parts = text.split(mark).enumerate();
        parts
            .map(|(i, part)| if i % 2 == 1 { instead } else { part })
            .collect()
    };
    let text = odd_out(&text, "```", " ").replace("$$", "$");
    let text = odd_out(&odd_out(&text, "`", " "), "$", "§");
    let text = text.replace("{{", "\u{1}").replace("}}", "\u{1}");
    let text = odd_out(&text, "\u{1}", "");
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// What the code says in words and no page: of what is wrong, by hand; and the values' meanings.
const SPOKEN: [&str; 5] = ["by hand", "conditions", "measured", "titles", "values"];

/// Words that turn round what those say, beside the others.
const TURNING: &[&str] = &["one"];

pub fn spoken(page: &str) -> String {
    let claims = PAPER.claims().map(|(_, claim)| claim);
    let parts: Vec<&str> = match page {
        "by hand" => CASES
            .iter()
            .flat_map(|case| [case.wrong, case.reason, case.case])
            .collect(),
        "conditions" => claims
            .flat_map(|claim| claim.conditions)
            .map(|condition| condition.text)
            .collect(),
        "measured" => MEASURED.iter().map(|row| row.reason).collect(),
        "titles" => claims.map(|claim| claim.title).collect(),
        _ => VALUES.iter().map(|value| value.meaning).collect(),
    };
    parts
        .join(" | ")
        .split('$')
        .enumerate()
        .map(|(i, part)| if i % 2 == 1 { "§" } else { part })
        .collect()
}

/// Each word with a direction, with the two before it and the two behind it.
fn around(text: &str, extra: &[&str]) -> Vec<String> {
    let words: Vec<_> = text.split(' ').collect();
    let one = |i: usize| words[i.saturating_sub(2)..words.len().min(i + 3)].join(" ");
    let has = |i: &usize| {
        [WORDS, extra]
            .iter()
            .any(|all| !directed(words[*i], all).is_empty())
    };
    (0..words.len()).filter(has).map(one).collect()
}

/// The lines of the list: page, what tries it, words.
fn listed() -> Vec<(&'static str, &'static str, &'static str)> {
    let mut page = "";
    let mut all = Vec::new();
    for line in LISTED.lines() {
        if let Some(next) = line.strip_prefix("# ") {
            page = next;
        } else if let Some((how, words)) = line.split_once(": ")
            && !page.is_empty()
        {
            all.push((page, how, words));
        }
    }
    all
}

#[test]
fn every_direction_on_a_page_is_computed_or_listed() {
    let listed = listed();
    let mut used = BTreeSet::new();
    let mut failures = Vec::new();
    let pages = pages();
    let pages = pages.iter().map(String::as_str);
    for page in pages.chain(SPOKEN) {
        let (mut text, extra) = match SPOKEN.contains(&page) {
            true => (spoken(page), TURNING),
            false => (flat(page), &[][..]),
        };
        for (_, words, holds) in SAID.iter().filter(|said| said.0 == page) {
            if !text.contains(words) {
                failures.push(format!("{page}: it does not say {words:?}"));
            }
            if !holds() {
                failures.push(format!("{page}: it is not so that {words:?}"));
            }
            text = text.replace(words, "§");
        }
        for words in around(&text, extra) {
            match listed
                .iter()
                .position(|row| (row.0, row.2) == (page, words.as_str()))
            {
                Some(row) => drop(used.insert(row)),
                None => failures.push(format!("{page}: text: {words}")),
            }
        }
    }
    for (i, (page, how, words)) in listed.iter().enumerate() {
        if !used.contains(&i) {
            failures.push(format!("{page}: listed, but not there: {words}"));
        }
        if *how != "text" && PAPER.find(how).is_none() {
            failures.push(format!("{page}: there is no claim {how}"));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn no_bound_in_the_code_of_a_page_lets_everything_pass() {
    for page in pages() {
        let text = text_of(&page);
        let code = text.split("```").skip(1).step_by(2);
        for bound in code.flat_map(|code| code.split(".abs() < ").skip(1)) {
            let number: String = bound
                .chars()
                .take_while(|c| c.is_ascii_alphanumeric() || "._-".contains(*c))
                .collect();
            let value: Option<f64> = number.trim_end_matches("_f64").parse().ok();
            assert!(value.is_none_or(|value| value <= 0.1), "{page}: {number}");
        }
    }
}

#[test]
fn a_word_stands_with_its_neighbours() {
    assert_eq!(
        around("as it *grows*, § falls.", &[]),
        ["as it *grows*, § falls.", "*grows*, § falls."]
    );
}
