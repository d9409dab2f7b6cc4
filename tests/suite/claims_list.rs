//! The claims as data, held against the paper's list (`tests/data/equations.md`, `tests/data/claims.md`).
//!
//! Every test gathers all offences before it fails, each with the id of its claim.

use slipbook::claims::{Claim, PAPER};
use slipbook::evidence::{Change, Kind};
use slipbook::ledger::{plain_formula, plain_words};
use std::collections::BTreeMap;

/// The claims without their topics.
fn all() -> impl Iterator<Item = &'static Claim> {
    PAPER.claims().map(|(_, claim)| claim)
}

const EQUATIONS: &str = include_str!("../data/equations.md");
const OTHERS: &str = include_str!("../data/claims.md");

/// A row of the paper's list.
struct Listed {
    section: &'static str,
    equation: Option<u16>,
    latex: Option<&'static str>,
}

/// The paper's list by id: numbered rows `| 13 | 2.1 | 184 | `…` |` of the equations, and rows
/// `| id | words |` of the other claims, whose section stands in the heading above them.
fn list() -> BTreeMap<String, Listed> {
    let mut rows = BTreeMap::new();
    let mut add = |id: String, row| {
        let before = rows.insert(id.clone(), row);
        assert!(before.is_none(), "{id} stands twice in the paper's list");
    };
    for line in EQUATIONS.lines() {
        let mut cells = line.split(" | ");
        let number = cells
            .next()
            .and_then(|c| c.strip_prefix("| ")?.parse().ok());
        if let (Some(number), Some(section)) = (number, cells.next()) {
            let row = Listed {
                section,
                equation: Some(number),
                latex: line.split('`').nth(1),
            };
            add(format!("eq-{number}"), row);
        }
    }
    let mut section = "";
    for line in OTHERS.lines() {
        if let Some(heading) = line.strip_prefix("## Section ") {
            section = heading.split(':').next().unwrap_or("");
        }
        let id = line.strip_prefix("| ").and_then(|l| l.split(" | ").next());
        if let Some(id) = id.filter(|id| *id != "id") {
            let row = Listed {
                section,
                equation: None,
                latex: None,
            };
            add(id.to_owned(), row);
        }
    }
    rows
}

/// A formula without what we may change in it: white space that separates nothing, the stop at its
/// end, `&` before the conditions of cases, `\quad`, and how text is tagged (`\mbox`, `\text`; the
/// letters of the curves A to D bear no tag in the list).
fn normal(latex: &str) -> String {
    let mut text = latex
        .replace("\\mbox", "\\text")
        .replace("\\quad", " ")
        .replace('&', " ");
    for curve in ["A:", "B:", "C:", "D:"] {
        text = text.replace(&format!("\\text{{{curve}}}"), curve);
    }
    let text = text.trim_end().trim_end_matches(['.', ',']);
    let mut out = String::new();
    for word in text.split_whitespace() {
        let letters = out.trim_end_matches(|c: char| c.is_ascii_alphabetic());
        let in_command = letters.len() < out.len() && letters.ends_with('\\');
        if in_command && word.starts_with(|c: char| c.is_ascii_alphabetic()) {
            out.push(' ');
        }
        out.push_str(word);
    }
    out
}

/// Fails with all offences, one a line.
fn none(offences: Vec<String>) {
    let count = offences.len();
    assert!(count == 0, "{count} offences:\n{}", offences.join("\n"));
}

#[test]
fn the_equations_stand_in_their_order() {
    let numbers = all().filter_map(|claim| claim.equation);
    assert!(numbers.eq(1..=147), "order of the equations");
}

#[test]
fn ids_numbers_and_sections_are_those_of_the_list() {
    let list = list();
    let mut seen: BTreeMap<&str, usize> = BTreeMap::new();
    for claim in all() {
        *seen.entry(claim.id).or_default() += 1;
    }
    let twice = seen.iter().filter(|(_, n)| **n > 1);
    let mut offences: Vec<_> = twice.map(|(id, n)| format!("{id}: {n} rows")).collect();
    let missing = list.keys().filter(|id| PAPER.find(id).is_none());
    offences.extend(missing.map(|id| format!("{id}: listed, but no row")));
    for claim in all() {
        let id = claim.id;
        let Some(row) = list.get(id) else {
            offences.push(format!("{id}: a row, but not listed"));
            continue;
        };
        if claim.section != row.section {
            offences.push(format!(
                "{id}: section {}, listed {}",
                claim.section, row.section
            ));
        }
        if claim.equation != row.equation {
            offences.push(format!(
                "{id}: number {:?}, listed {:?}",
                claim.equation, row.equation
            ));
        }
    }
    none(offences);
}

#[test]
fn formulas_are_those_of_the_list() {
    let list = list();
    let mut compared = 0;
    let mut offences = Vec::new();
    for claim in all() {
        let Some(listed) = list.get(claim.id).and_then(|row| row.latex) else {
            continue;
        };
        compared += 1;
        let (ours, theirs) = (normal(claim.latex), normal(listed));
        if ours != theirs {
            offences.push(format!("{}:\n  row  {ours}\n  list {theirs}", claim.id));
        }
        if claim.latex.ends_with(['.', ',']) {
            offences.push(format!("{}: the formula ends in a stop", claim.id));
        }
    }
    none(offences);
    assert_eq!(compared, 147, "formulas compared");
}

#[test]
fn kinds_fit_the_rows() {
    let wrong = all().filter(|c| match c.kind {
        Kind::Figure => !c.id.starts_with("fig-"),
        Kind::Property => c.equation.is_some() || c.id.starts_with("fig-"),
        _ => c.equation.is_none(),
    });
    none(
        wrong
            .map(|c| format!("{}: {}", c.id, c.kind.name()))
            .collect(),
    );
}

/// The formulas between `$…$`; `None` if a `$` has no partner.
fn inline(text: &str) -> Option<Vec<&str>> {
    let parts: Vec<_> = text.split('$').collect();
    (parts.len() % 2 == 1).then(|| parts.into_iter().skip(1).step_by(2).collect())
}

/// All formulas of a row, those of its conditions included; `None` if a `$` has no partner.
fn formulas(claim: &Claim) -> Option<Vec<&'static str>> {
    let mut formulas = match claim.equation {
        Some(_) => vec![claim.latex],
        None => inline(claim.latex)?,
    };
    for condition in claim.conditions {
        formulas.extend(inline(condition.text)?);
    }
    Some(formulas)
}

#[test]
fn texts_are_filled_and_plain() {
    let mut offences = Vec::new();
    for claim in all() {
        let mut blame = |what: &str| offences.push(format!("{}: {what}", claim.id));
        for (name, text) in [
            ("title", claim.title),
            ("latex", claim.latex),
            ("plain", claim.plain),
        ] {
            if text.trim().is_empty() {
                blame(&format!("empty {name}"));
            }
        }
        if claim.plain.contains(['\\', '$']) {
            blame("LaTeX in the plain text");
        }
        if claim.title.contains(['\\', '$', '|']) || claim.title.ends_with('.') {
            blame("a title is a few plain words");
        }
        if claim.equation.is_some() && claim.latex.contains('$') {
            blame("`$` in a formula");
        }
        if claim.conditions.iter().any(|c| c.text.trim().is_empty()) {
            blame("empty condition");
        }
    }
    none(offences);
}

#[test]
fn formulas_render() {
    let context = katex::KatexContext::default();
    let settings = katex::Settings::default();
    let mut offences = Vec::new();
    for claim in all() {
        let Some(formulas) = formulas(claim) else {
            offences.push(format!("{}: a `$` has no partner", claim.id));
            continue;
        };
        for formula in formulas {
            if let Err(error) = katex::render_to_string(&context, formula, &settings) {
                offences.push(format!("{}: `{formula}`: {error}", claim.id));
            }
        }
    }
    none(offences);
}

#[test]
fn dependencies_exist_once_each() {
    let mut offences = Vec::new();
    for claim in all() {
        for (i, on) in claim.depends_on.iter().enumerate() {
            if *on == claim.id {
                offences.push(format!("{}: depends on itself", claim.id));
            } else if PAPER.find(on).is_none() {
                offences.push(format!(
                    "{}: depends on `{on}`, which is no claim",
                    claim.id
                ));
            }
            if claim.depends_on[..i].contains(on) {
                offences.push(format!("{}: names `{on}` twice", claim.id));
            }
        }
    }
    none(offences);
}

#[test]
fn dependencies_have_no_cycle() {
    // Drop whatever depends on nothing left, or has nothing left that depends on it, until nothing
    // more can be dropped: what stays lies on a cycle or between two.
    let mut left: Vec<&Claim> = all().collect();
    loop {
        let stays = |c: &&Claim| {
            let needs = left.iter().any(|o| c.depends_on.contains(&o.id));
            needs && left.iter().any(|o| o.depends_on.contains(&c.id))
        };
        let kept: Vec<_> = left.iter().copied().filter(stays).collect();
        if kept.len() == left.len() {
            break;
        }
        left = kept;
    }
    let edges = left
        .iter()
        .map(|c| format!("{}: in a cycle, {:?}", c.id, c.depends_on));
    none(edges.collect());
}

#[test]
fn every_claim_can_be_read_so() {
    let forms = PAPER.claims().flat_map(|(_, claim)| {
        let latex = [Some(claim.latex), claim.correction.map(|c| c.latex)];
        latex.into_iter().flatten().map(move |latex| (claim, latex))
    });
    for (claim, latex) in forms {
        let text = match claim.equation {
            Some(_) if !latex.contains('$') => plain_formula(latex),
            _ => plain_words(latex),
        };
        for left in ["\\", "{}", "mathrm", "frac", "bm", "$"] {
            assert!(!text.contains(left), "{}: {text}", claim.id);
        }
    }
}

/// The pieces of the formulas of a text, without brackets: a letter with what stands below it is one. What a formula defines
/// beside itself does not count.
fn pieces(text: &str) -> Vec<String> {
    let parts = match text.contains('$') {
        true => text.split('$').skip(1).step_by(2).collect(),
        false => vec![text.split(",\\quad").next().expect("a first part")],
    };
    let mut pieces: Vec<String> = Vec::new();
    for part in parts {
        let mut rest = part;
        while let Some(first) = rest.chars().next() {
            let length = match first {
                '\\' => {
                    let letter = |c: char| c.is_ascii_alphabetic();
                    let name = rest[1..].find(|c| !letter(c)).unwrap_or(rest.len() - 1);
                    1 + name.max(1)
                }
                _ => first.len_utf8(),
            };
            let piece = &rest[..length];
            match pieces.last_mut() {
                Some(last) if piece == "_" || last.ends_with('_') => last.push_str(piece),
                _ if [r"\left", r"\right"].contains(&piece) || "{}()[] ".contains(piece) => {}
                _ => pieces.push(piece.to_owned()),
            }
            rest = &rest[length..];
        }
    }
    pieces
}

/// What has changed: signs alone; letters or numbers that were added to a product; a word or letter; or more.
fn change(old: &str, new: &str) -> Change {
    let [a, b] = [old, new].map(pieces);
    let sign = |piece: &&String| ["+", "-"].contains(&piece.as_str());
    let unsigned = |of: &[String]| of.iter().filter(|p| !sign(p)).cloned().collect::<Vec<_>>();
    if a != b && unsigned(&a) == unsigned(&b) {
        return Change::Sign;
    }
    let mut left = a.iter().peekable();
    let added: Vec<_> = b
        .iter()
        .filter(|piece| left.next_if_eq(piece).is_none())
        .collect();
    let factor =
        |piece: &&String| piece.starts_with('\\') || piece.chars().all(char::is_alphanumeric);
    if left.next().is_none() && !added.is_empty() && added.iter().all(factor) {
        return Change::Factor;
    }
    let [a, b] = [(old, a), (new, b)].map(|(text, pieces)| match text.contains('$') {
        true => text.split(' ').map(str::to_owned).collect(),
        false => pieces,
    });
    let other = a.iter().zip(&b).filter(|(a, b)| a != b).count();
    match a.len() == b.len() && other == 1 {
        true => Change::Symbol,
        false => Change::Statement,
    }
}

#[test]
fn what_a_correction_changes_is_what_differs() {
    let kinds = all().filter_map(|claim| {
        let correction = claim.correction?;
        let found = change(claim.latex, correction.latex);
        (found != correction.change)
            .then(|| format!("{}: {found:?}, not {:?}", claim.id, correction.change))
    });
    none(kinds.collect());
}
