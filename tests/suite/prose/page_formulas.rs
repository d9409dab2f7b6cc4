//! The formulas in the text of the pages: each is asked, or said to be a definition; nothing else may stand there.

use super::{
    formulas::{Found, Given, found, is_name},
    given,
    mistakes::{mistakes, pieces},
    printed_part::Library,
    text::formulas_of,
};
use slipbook::book::{self, Piece};
use slipbook::claims::PAPER;
use slipbook::edition::EDITION;
use std::collections::BTreeSet;

const TABLE: &str = "tests/data/formulas.txt";

fn entries() -> Vec<(String, String, String)> {
    let (mut page, mut entries) = (String::new(), Vec::new());
    for line in std::fs::read_to_string(TABLE).unwrap().lines() {
        let mut add = |givens: &str, formula: &str| {
            entries.push((page.clone(), givens.to_owned(), formula.to_owned()));
        };
        if let Some(next) = line.strip_prefix("# ") {
            next.clone_into(&mut page);
        } else if let Some(defined) = line.strip_prefix("let ") {
            defined.split(" ; ").for_each(|formula| add("", formula));
        } else if let Some((givens, formula)) = line.split_once(" => ") {
            add(givens, formula);
        }
    }
    entries
}

/// Without room, the size of a fraction and the stop behind it.
fn key(latex: &str) -> String {
    let latex = latex.trim_end_matches(['.', ',', ':', ' ']);
    let pieces = pieces(latex).into_iter().map(|(_, piece)| piece);
    let counts = |piece: &&str| ![" ", r"\,", r"\;", r"\!", r"\quad", r"\qquad"].contains(piece);
    let same = |piece| match piece {
        r"\tfrac" => r"\frac",
        r"\leq" => r"\le",
        r"\geq" => r"\ge",
        piece => piece,
    };
    pieces
        .filter(counts)
        .map(same)
        .collect::<Vec<_>>()
        .join(" ")
}

/// Page, line, formula, and what is to be said of it there.
type Here = (&'static str, usize, String, Option<Found>);

fn formulas() -> Vec<Here> {
    let mut all = Vec::new();
    for page in EDITION.pages {
        let (text, mut given) = (page.text.as_str(), Given::new());
        for (at, piece) in book::pieces(text) {
            match piece {
                Piece::Formula(formula) => {
                    let what = found(&formula, &mut given);
                    all.push((
                        page.stem,
                        text[..at].matches('\n').count() + 1,
                        formula,
                        what,
                    ));
                }
                Piece::Prose(_) => {}
                _ => given = Given::new(),
            }
        }
    }
    all
}

/// What its entries give, and what the paper or the corrections print, which `print` holds.
struct Asked(BTreeSet<(String, String)>);

impl Asked {
    fn new(entries: &[(String, String, String)]) -> Self {
        let mut asked = BTreeSet::new();
        for (page, givens, formula) in entries {
            let all = givens.split("; ").chain([&formula[..]]);
            asked.extend(all.map(|formula| (page.clone(), key(formula))));
        }
        for (_, claim) in PAPER.claims() {
            for latex in [claim.latex]
                .into_iter()
                .chain(claim.correction.map(|c| c.latex))
            {
                let formulas = match latex.contains('$') {
                    true => formulas_of(latex),
                    false => vec![latex.to_owned()],
                };
                // A short one may be any.
                let keys = formulas.iter().map(|formula| key(formula));
                let long = keys.filter(|key| key.split(' ').count() > 8);
                asked.extend(long.map(|key| (String::new(), key)));
            }
        }
        Self(asked)
    }

    fn fault(&self, (page, line, formula, what): &Here) -> Option<String> {
        let of = |page: &str| self.0.contains(&(page.to_owned(), key(formula)));
        if let Some(Found::Wrong(why)) = what
            && !of(page)
        {
            return Some(format!("{page}.md, line {line}: `{formula}`: {why}"));
        }
        let key = key(formula);
        let sides: Vec<_> = key.split(" = ").collect();
        let says_nothing = sides.windows(2).any(|two| two[0] == two[1]);
        let fine =
            *what == Some(Found::Holds) && !says_nothing || of(page) || of("") || is_name(formula);
        (!fine).then(|| {
            format!(
                "{page}.md, line {line}: nothing asks whether `{formula}` is right: correct it, or say below `# {page}` in {TABLE} by \
                 what it is, or, where it defines or supposes something, `let {formula}`"
            )
        })
    }
}

#[test]
fn every_formula_on_a_page_is_asked() {
    let (library, entries, formulas) = (Library::new(), entries(), formulas());
    let asked = Asked::new(&entries);
    let mut failures: Vec<_> = formulas
        .iter()
        .filter_map(|here| asked.fault(here))
        .collect();
    let there: BTreeSet<_> = formulas
        .iter()
        .map(|(page, _, formula, _)| (*page, key(formula)))
        .collect();
    for (page, givens, formula) in &entries {
        if !there.contains(&(&page[..], key(formula))) {
            failures.push(format!("{page}.md no longer says `{formula}`: take it out of {TABLE}, or change it there, too"));
        }
        if !givens.is_empty()
            && let Err(why) = given::hold(&library, givens, formula)
        {
            failures.push(format!("{page}: {formula} where {givens}: {why}"));
        }
    }
    assert!(
        failures.is_empty(),
        "{} failures:\n{}",
        failures.len(),
        failures.join("\n")
    );
}

#[test]
fn a_slip_in_a_formula_is_seen() {
    let (library, entries, formulas) = (Library::new(), entries(), formulas());
    for (page, givens, formula) in entries.iter().filter(|(_, givens, _)| !givens.is_empty()) {
        let formula = formula.trim_end_matches(['.', ',', ' ', ':']);
        let slip = format!("{formula}+1");
        assert!(
            given::hold(&library, givens, &slip).is_err(),
            "{page}: {slip}"
        );
    }
    let asked = Asked::new(&entries);
    let mut unseen = Vec::new();
    for (page, line, formula, _) in formulas
        .iter()
        .filter(|(_, _, formula, _)| !is_name(formula))
    {
        for slip in mistakes(formula) {
            let here = (*page, *line, slip, None);
            // What is said elsewhere on the page, or is true as well, is no slip.
            let said = asked.0.contains(&((*page).to_owned(), key(&here.2)));
            let holds = || found(&here.2, &mut Given::new()) == Some(Found::Holds);
            if !said && asked.fault(&here).is_none() && !holds() {
                unseen.push(format!("{page}.md, line {line}: {formula}: {}", here.2));
            }
        }
    }
    assert!(unseen.is_empty(), "not seen:\n{}", unseen.join("\n"));
}
