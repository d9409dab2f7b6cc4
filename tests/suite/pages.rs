//! A verdict in the book's prose stands in a placeholder; and the letters hold what fails.

use crate::{BOOK, LEDGER};
use slipbook::book;
use slipbook::claims::PAPER;
use slipbook::edition::EDITION;
use slipbook::evidence::Evidence;
use slipbook::ledger::Format;
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use trialbook::notation::{Piece, pieces, plain_formula, plain_words};

/// They explain what verdicts are.
const ON_VERDICTS: [&str; 5] = ["methods", "adding", "own", "errata", "map"];

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
    let ledger = &*LEDGER;
    let [text, latex] = [Format::Text, Format::Latex].map(|format| ledger.letter(format).unwrap());
    let [text, latex] = [(Format::Text, text), (Format::Latex, latex)].map(|(format, sent)| {
        assert!(sent.contains("[name") && sent.contains("[address"));
        format.signed(
            sent,
            Some("A. Nobody/Here & There"),
            Some("https://b.example/a_b"),
        )
    });
    assert!(text.contains("From A. Nobody, Here & There\n") && text.contains("/a_b"));
    assert!(latex.contains(r"From A. Nobody, Here \& There") && latex.contains(r"a\_b"));
    let tags: BTreeSet<_> = latex.split(r"\tag{").skip(1).map(|tag| &tag[..4]).collect();
    assert!(tags.len() == latex.matches(r"\tag{").count() && tags.len() > 10);
    assert!(text.lines().all(|line| line.chars().count() <= 78));
    let foreign: Vec<_> = latex.chars().filter(|c| !c.is_ascii()).collect();
    assert!(foreign.is_empty(), "no LaTeX for {foreign:?}");
    assert!(!latex.contains("$$") && latex.matches('$').count() % 2 == 0);
}

#[test]
fn the_letter_names_every_error() {
    let links = PAPER.letter.replace("{{right ", "](#");
    let links = links.split("](#").skip(1);
    let named: BTreeSet<_> = links
        .filter_map(|link| link.split([')', '}']).next())
        .collect();
    let errata = LEDGER.errata().unwrap();
    let wrong: BTreeSet<_> = errata.iter().map(|erratum| erratum.id).collect();
    assert_eq!(named, wrong);
}

#[test]
fn the_errata_take_nothing_for_its_opposite() {
    for erratum in LEDGER.errata().unwrap() {
        let (_, claim) = PAPER.find(erratum.id).unwrap();
        assert!(erratum.old.contains(claim.latex), "{}", erratum.id);
        if let Some(correction) = claim.correction {
            assert!(erratum.new.contains(correction.latex), "{}", erratum.id);
        }
    }
    // The decay across the drive, region II, escape, the boundary of rest; the factors of (82) and (106).
    assert_eq!(LEDGER.weights(), [4, 2]);
}

#[test]
fn no_page_passes_a_verdict_of_its_own() {
    let pages = EDITION.pages.iter();
    for page in pages.filter(|page| !ON_VERDICTS.contains(&page.stem)) {
        for (_, piece) in book::pieces(&page.text) {
            let verdicts = ["refuted", "misprint", "confirmed", "undecided"];
            let own = matches!(&piece, book::Piece::Prose(words) if verdicts.iter().any(|verdict| words.to_lowercase().contains(verdict)));
            assert!(!own, "{}.md says {piece:?} in its own words", page.stem);
        }
    }
}

/// Greek, a small digit above or below the line, and the like.
fn mathematical(c: char) -> bool {
    "²³¹½∂Σ√∞∫ᵏ".contains(c)
        || matches!(u32::from(c), 0x300..=0x3ff | 0x1d62..=0x1d6a | 0x2070..=0x209f | 0x1d400..=0x1d7ff)
}

#[test]
fn no_formula_of_a_trial_stands_bare() {
    let mut bare_ones = std::collections::BTreeSet::new();
    for entry in &LEDGER.entries {
        let trials = entry.evidence.iter().flat_map(|e| {
            let points = e.samples.iter().map(|sample| sample.at.clone());
            let said = [
                e.title.clone(),
                e.comparison(),
                e.measured(),
                e.tolerance.reason.to_owned(),
            ];
            e.steps
                .iter()
                .cloned()
                .chain(points)
                .chain(said)
                .collect::<Vec<_>>()
        });
        for text in trials {
            for words in text.split('$').step_by(2) {
                let bare = |piece: &Piece<'_>| match piece {
                    Piece::Text(text) => text.contains(mathematical),
                    Piece::Formula(_) | Piece::Minus | Piece::Scientific(_) => false,
                };
                let found: Vec<_> = pieces(words).into_iter().filter(bare).collect();
                if !found.is_empty() {
                    bare_ones.insert(format!("{}: {found:?} in \"{text}\"", entry.claim.id));
                }
            }
        }
    }
    assert!(bare_ones.is_empty(), "{bare_ones:#?}");
}

#[test]
fn steps_of_proofs_are_sentences() {
    let of = |e: &Evidence| {
        let lemmas = e.lemmas.iter().flat_map(|lemma| lemma.steps.clone());
        e.steps.iter().cloned().chain(lemmas).collect::<Vec<_>>()
    };
    let mut wrong = BTreeSet::new();
    for step in LEDGER
        .entries
        .iter()
        .flat_map(|entry| entry.evidence.iter().flat_map(of))
    {
        let all = pieces(&step);
        let begins = |text: &str| text.starts_with(|c: char| c.is_lowercase());
        let ragged = matches!(all[0], Piece::Text(text) if begins(text));
        let torn = all.windows(3).any(|three| match three {
            [Piece::Formula(_), Piece::Text(" "), Piece::Text(sign)] => "+−=<>≤≥·×".contains(sign),
            [Piece::Formula(_), Piece::Text(sign), _] => "/^_(".contains(sign),
            _ => false,
        });
        if ragged || torn {
            wrong.insert(step);
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn what_answers_to_words_is_there() {
    for line in EDITION.aliases.lines() {
        let place = line
            .split_once('\t')
            .and_then(|(place, _)| place.split_once('#'));
        let (page, id) = place.unwrap_or_else(|| panic!("no place in \"{line}\""));
        let html = fs::read_to_string(BOOK.join(page)).unwrap();
        assert!(html.contains(&format!("id=\"{id}\"")), "{line}");
    }
}

fn more(new: &str, old: &str) -> BTreeMap<char, i64> {
    let mut more = BTreeMap::new();
    for (text, one) in [(new, 1), (old, -1)] {
        for c in text.chars().filter(|c| !c.is_whitespace()) {
            let small = "₀₁₂₃₄₅₆₇₈₉".chars().position(|digit| digit == c);
            let c = small
                .and_then(|n| char::from_digit(n as u32, 10))
                .unwrap_or(c);
            *more.entry(c).or_default() += one;
        }
    }
    more
}

/// By and large, by what characters each has more.
#[test]
fn a_box_shows_each_form_in_its_place() {
    let (mut boxes, mut failures) = (0, Vec::new());
    for (topic, claim) in PAPER.claims() {
        let page = fs::read_to_string(BOOK.join(topic.stem).with_extension("html")).unwrap();
        let after = |text: &str, mark: &str| Some(text.split_once(mark)?.1.to_owned());
        let forms = || {
            let whole = after(&page, &format!("aria-labelledby=\"{}\"", claim.id))?;
            let (whole, _) = whole.split_once("</article>")?;
            let (printed, corrected) = whole.split_once("<div class=\"corrected\">")?;
            let (corrected, _) = corrected.split_once("<details")?;
            let corrected = corrected.split("<div class=\"by-hand\">").next()?;
            let printed = after(printed, "<div class=\"printed\">")?;
            let form = |form: &str| Some(without(&after(form, "</p>")?, "<", ">"));
            Some([form(&printed)?, form(corrected)?])
        };
        let (Some(correction), Some([old, new])) = (claim.correction, forms()) else {
            continue;
        };
        boxes += 1;
        let plain = [correction.latex, claim.latex].map(|latex| match latex.contains('$') {
            true => plain_words(latex),
            false => plain_formula(latex),
        });
        let (shown, right) = (more(&new, &old), more(&plain[0], &plain[1]));
        let alike: i64 = shown
            .iter()
            .map(|(c, n)| n * right.get(c).unwrap_or(&0))
            .sum();
        if alike <= 0 {
            failures.push((claim.id, shown));
        }
    }
    assert!(failures.is_empty() && boxes > 20, "{boxes} {failures:#?}");
}

/// A citation leads to a box, or to the page of lemmas, whose own lead on.
#[test]
fn every_proof_that_is_cited_stands_somewhere() {
    for page in ["rest", "escape", "anisotropic", "lemmas"] {
        let html = fs::read_to_string(BOOK.join(page).with_extension("html")).unwrap();
        let all = html.matches("Shown before").count();
        assert!(
            all > 0 && html.matches("\">Shown before").count() == all,
            "{page}"
        );
    }
}
