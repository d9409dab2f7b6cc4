//! The letters of each page: each is in the table of symbols, and none has a meaning of its own where a box uses it.

use super::text::formulas_of;
use slipbook::book::{Piece, pieces};
use slipbook::claims::PAPER;
use slipbook::edition::EDITION;
use slipbook::symbols::SYMBOLS;
use std::collections::{BTreeMap, BTreeSet};
use trialbook::data::{Text, text};
use trialbook::trials::Topic;

const TABLE: Text = text!("book/src/lookup.md");

/// Numbers with names, axes, orders of magnitude, and what a text calls by a capital.
const PLAIN: [&str; 8] = ["pi", "O", "bm x", "bm y", "bm z", "x", "y", "z"];

/// Their argument is no letter of the formula.
const WORDS: [&str; 8] = [
    "mathrm",
    "text",
    "operatorname",
    "begin",
    "end",
    "mbox",
    "mathsf",
    "spdot",
];

/// Other accents mean a rate or a direction of the same letter.
const OTHER: [&str; 4] = ["bm", "mathfrak", "mathbb", "tilde"];

const GREEK: &str = "alpha beta gamma delta epsilon varepsilon zeta eta theta vartheta iota kappa lambda mu nu xi ell pi varpi rho sigma
    tau phi chi psi omega Delta Omega Gamma Phi Psi";

/// Each with what makes it another and with its index: `bm R`, `tilde phi_1`.
pub fn letters(latex: &str) -> BTreeSet<String> {
    let mut out = BTreeSet::new();
    let mut prefix = String::new();
    let mut rest = latex;
    while let Some(c) = rest.chars().next() {
        let mut letter = None;
        rest = &rest[c.len_utf8()..];
        if c == '\\' {
            let end = rest
                .find(|c: char| !c.is_ascii_alphabetic())
                .unwrap_or(rest.len());
            let (name, after) = rest.split_at(end);
            rest = after;
            if WORDS.contains(&name) {
                rest = skipped(rest);
            } else if OTHER.contains(&name) {
                prefix += &format!("{name} ");
                rest = rest.trim_start_matches([' ', '{']);
                continue;
            } else if GREEK.split_whitespace().any(|letter| letter == name) {
                letter = Some(name.to_owned());
            } else if name.is_empty() {
                rest = rest.get(1..).unwrap_or_default();
            }
        } else if c.is_ascii_alphabetic() {
            letter = Some(c.to_string());
        } else if c == '_' {
            rest = skipped(rest);
        }
        if let Some(letter) = letter {
            let after = rest.trim_start_matches('}');
            let index = match after.strip_prefix('_') {
                Some(index) => &index[..index.len() - skipped(index).len()],
                None => "",
            };
            let index: String = index
                .chars()
                .filter(|c| c.is_ascii_alphanumeric() || "+-".contains(*c))
                .collect();
            let index = index.replace("mathrm", "").replace("text", "");
            let index = if index.is_empty() {
                index
            } else {
                format!("_{index}")
            };
            out.insert(format!("{prefix}{letter}{index}"));
        }
        prefix.clear();
    }
    out
}

fn skipped(text: &str) -> &str {
    let text = text.trim_start();
    let mut depth = 0;
    for (i, c) in text.char_indices() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            '\\' if depth == 0 => {
                let end = text[1..].find(|c: char| !c.is_ascii_alphabetic());
                let end = end.map_or(text.len(), |end| end + 1);
                return match WORDS.contains(&&text[1..end]) {
                    true => skipped(&text[end..]),
                    false => &text[end..],
                };
            }
            _ => {}
        }
        if depth <= 0 {
            return &text[i + c.len_utf8()..];
        }
    }
    ""
}

fn base(letter: &str) -> &str {
    letter.split('_').next().unwrap_or(letter)
}

fn own() -> BTreeMap<String, Vec<String>> {
    let mut own = BTreeMap::<String, Vec<String>>::new();
    let mut page = String::new();
    let rows = TABLE
        .lines()
        .skip_while(|line| !line.starts_with("## Letters of our own"));
    for row in rows.filter(|row| row.starts_with("| ")) {
        let cells: Vec<&str> = row.split(" | ").collect();
        if let Some((_, address)) = cells[0].split_once("](") {
            page = address
                .split(['.', '#'])
                .next()
                .unwrap_or_default()
                .to_owned();
        }
        let found = formulas_of(cells[1])
            .into_iter()
            .flat_map(|formula| letters(&formula));
        own.entry(page.clone()).or_default().extend(found);
    }
    own
}

fn boxed(topic: &Topic) -> BTreeSet<String> {
    let mut out = BTreeSet::new();
    for claim in topic.claims() {
        let whole = |text: &str| match (text.contains('$'), text.ends_with('.')) {
            (true, _) => formulas_of(text),
            (false, true) => Vec::new(),
            (false, false) => vec![text.to_owned()],
        };
        let mut formulas = whole(claim.latex);
        formulas.extend(claim.correction.iter().flat_map(|c| whole(c.latex)));
        formulas.extend(claim.conditions.iter().flat_map(|c| formulas_of(c.text)));
        out.extend(formulas.iter().flat_map(|formula| letters(formula)));
    }
    out
}

#[test]
fn letters_are_told_apart() {
    let of = |latex: &str| letters(latex).into_iter().collect::<Vec<_>>();
    assert_eq!(
        of(r"\frac{\mathrm d\bm v}{\mathrm d t}=-\bm{A}"),
        ["bm A", "bm v", "t"]
    );
    assert_eq!(
        of(r"\tilde\phi_2<\lambda_\mathrm c\,q_{\text{Y}}"),
        ["lambda_c", "q_Y", "tilde phi_2"]
    );
    assert_eq!(of(r"\ddot{\bm\rho}\cdot\hat{\bm w}"), ["bm rho", "bm w"]);
}

#[test]
fn no_letter_has_two_meanings_on_a_page() {
    let mut wrong = Vec::new();
    for (page, letters) in own() {
        let mut seen = BTreeSet::new();
        for letter in &letters {
            if !seen.insert(letter.clone()) {
                wrong.push(format!("{page}: {letter} is declared twice"));
            }
        }
        let topic = PAPER
            .topics
            .iter()
            .copied()
            .find(|topic| topic.stem == page);
        let boxed = topic.map(boxed).unwrap_or_default();
        for letter in seen.intersection(&boxed) {
            wrong.push(format!(
                "{page}: {letter} is of our own, and a box has it too"
            ));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn every_letter_of_a_page_is_in_the_table_of_symbols() {
    let own = own();
    let known: BTreeSet<String> = SYMBOLS.iter().flat_map(|s| letters(s.latex)).collect();
    let mut wrong = BTreeSet::new();
    for page in EDITION.pages.iter().filter(|page| page.stem != "lookup") {
        let here = own.get(page.stem).cloned().unwrap_or_default();
        let of = |(_, piece)| match piece {
            Piece::Formula(latex) => letters(&latex),
            _ => BTreeSet::new(),
        };
        for letter in pieces(&page.text).into_iter().flat_map(of) {
            let bold = format!("bm {}", base(&letter));
            let names = [letter.as_str(), base(&letter), &bold];
            let is = |name: &&str| {
                known.contains(*name) || here.iter().any(|own| own == name) || PLAIN.contains(name)
            };
            // A vector is known by a component.
            let component = |known: &String| Some(base(known)) == letter.strip_prefix("bm ");
            if !names.iter().any(is) && !known.iter().any(component) {
                wrong.insert(format!("{}: {letter}", page.stem));
            }
        }
    }
    assert!(
        wrong.is_empty(),
        "{}",
        wrong.into_iter().collect::<Vec<_>>().join("\n")
    );
}
