//! The claims as data: that their files can be read, and that what they say is whole.
//!
//! Every test gathers all offences before it fails.

use slipbook::claims::PAPER;
use slipbook::edition::EDITION;
use slipbook::evidence::Kind;
use trialbook::notation::{plain_formula, plain_words};
use trialbook::trials::Claim;

fn all() -> impl Iterator<Item = &'static Claim> {
    PAPER.claims().map(|(_, claim)| claim)
}

fn none(offences: Vec<String>) {
    let count = offences.len();
    assert!(count == 0, "{count} offences:\n{}", offences.join("\n"));
}

#[test]
fn the_equations_stand_in_their_order() {
    let numbers: Vec<_> = all().filter_map(|claim| claim.equation).collect();
    assert!(
        numbers.is_sorted(),
        "the entries are not in the paper's order"
    );
}

/// Each equation has a number for the signs that it prints, without braces, blanks and sizes of brackets. Nothing writes these
/// lines.
#[test]
fn what_is_printed_is_what_the_paper_prints() {
    let line = |claim: &Claim| {
        let signs = claim.latex.replace(r"\left", "").replace(r"\right", "");
        let signs = signs.bytes().filter(|c| !b"{} ".contains(c));
        let sum = signs.fold(0_u32, |sum, c| {
            sum.rotate_left(5).wrapping_mul(31) ^ u32::from(c)
        });
        let sum = claim
            .equation
            .map_or(String::new(), |_| format!(" {sum:08x}"));
        format!("{} {}{sum}", claim.id, claim.section)
    };
    let paper: Vec<_> = include_str!("../data/printed.txt").lines().collect();
    let printed: Vec<_> = all().filter(|claim| !claim.ours).map(line).collect();
    let gone = paper
        .iter()
        .filter(|line| printed.iter().all(|other| other != *line));
    let gone = gone.map(|line| {
        let (id, _) = line.split_once(' ').unwrap_or((*line, ""));
        let now = printed.iter().find(|line| line.starts_with(&format!("{id} ")));
        match now {
            None => format!("tests/data/printed.txt has `{line}`, and there is no such claim: leave the line out if it is given up"),
            Some(now) => format!(
                "{id}: tests/data/printed.txt has `{line}`, the entry gives `{now}`. Hold the entry against the paper; only if the line \
                 was wrong, change it"
            ),
        }
    });
    let known = |line: &&String| {
        paper
            .iter()
            .any(|other| other.split(' ').next() == line.split(' ').next())
    };
    let new = printed.iter().filter(|line| !known(line));
    let new = new.map(|line| {
        format!(
            "tests/data/printed.txt lacks `{line}`: add it, once you have held it against the paper"
        )
    });
    none(gone.chain(new).collect());
}

#[test]
fn no_text_names_a_claim_that_is_gone() {
    let mut offences = Vec::new();
    for (path, text) in [
        (
            "tests/browser/questions.tsv",
            include_str!("../browser/questions.tsv"),
        ),
        ("python/README.md", include_str!("../../python/README.md")),
        ("README.md", include_str!("../../README.md")),
        (".ci/deep", include_str!("../../.ci/deep")),
        (
            "python/tests/test_data.py",
            include_str!("../../python/tests/test_data.py"),
        ),
        (
            "tests/suite/command/held.txt",
            include_str!("command/held.txt"),
        ),
    ] {
        for (number, line) in (1..).zip(text.lines()) {
            let words = line.split(|c: char| !c.is_ascii_alphanumeric() && c != '-');
            // As the command is typed: `slipbook show 75`, not "show 75 points", nor the section of `show 2.1`.
            let typed = ["slipbook show ", "slipbook -q show ", "`show "];
            let typed = typed.iter().flat_map(|typed| line.split(typed).skip(1));
            let shown = typed.filter_map(|behind| {
                let number = behind.split([' ', '`', ')', '"']).next()?;
                number
                    .parse()
                    .ok()
                    .map(|number: u16| format!("eq-{number}"))
            });
            let shown: Vec<_> = shown.collect();
            let shown = shown.iter().map(String::as_str);
            for id in words.filter(|word| word.starts_with("eq-")).chain(shown) {
                // So no claim will ever be called.
                let known = id == "eq-999" || all().any(|claim| claim.id == id);
                if !known && id[3..].parse::<u16>().is_ok() {
                    offences.push(format!("{path}, line {number}: there is no claim `{id}`"));
                }
            }
        }
    }
    none(offences);
}

#[test]
fn all_that_the_files_name_is_there_and_named() {
    let told = EDITION.check().err().map(|told| told.to_string());
    none(told.into_iter().collect());
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

/// Between `$…$`; `None` if a `$` has no partner.
fn inline(text: &str) -> Option<Vec<&str>> {
    let parts: Vec<_> = text.split('$').collect();
    (parts.len() % 2 == 1).then(|| parts.into_iter().skip(1).step_by(2).collect())
}

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
        if claim.equation.is_some() && claim.latex.ends_with(['.', ',']) {
            blame("a stop behind a formula");
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
fn dependencies_have_no_cycle() {
    // Drop whatever depends on nothing left, or on which nothing left depends.
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
