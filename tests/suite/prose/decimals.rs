//! Decimals in running text.

use super::formulas::{Given, found, is_arithmetic};
use slipbook::book::{Piece, pieces};
use slipbook::edition::EDITION;
use trialbook::notation::literals;

pub fn decimals(text: &str) -> Vec<&str> {
    let mut found = Vec::new();
    let mut rest = text;
    while let Some(start) = rest.find(|c: char| c.is_ascii_digit()) {
        let before = rest[..start]
            .split_whitespace()
            .next_back()
            .unwrap_or_default();
        let before = before.trim_start_matches(['[', '*']).to_lowercase();
        let part = |c: char| c.is_ascii_digit() || ".,".contains(c);
        let end = rest[start..]
            .find(|c| !part(c))
            .map_or(rest.len(), |length| start + length);
        let number = rest[start..end].trim_end_matches(['.', ',']);
        if number.contains('.') && !["section", "before", "problem"].contains(&&before[..]) {
            found.push(number);
        }
        rest = &rest[end..];
    }
    found
}

/// Neither in the code of their section nor in arithmetic that is tried as it stands.
fn from_nowhere(page: &str) -> Vec<String> {
    let mut sections = vec![Vec::new()];
    for (_, piece) in pieces(page) {
        match piece {
            Piece::Section => sections.push(Vec::new()),
            piece => sections.last_mut().unwrap().push(piece),
        }
    }
    let mut nowhere = Vec::new();
    for section in sections {
        let code = |piece: &Piece| match piece {
            Piece::Code(code) => literals(code),
            _ => Vec::new(),
        };
        let (known, mut given): (Vec<f64>, _) =
            (section.iter().flat_map(code).collect(), Given::new());
        let mut wanted = Vec::new();
        for piece in &section {
            match piece {
                Piece::Prose(words) => wanted.extend(decimals(words)),
                Piece::Formula(latex) => {
                    if !is_arithmetic(latex, &given) {
                        wanted.extend(decimals(latex));
                    }
                    found(latex, &mut given);
                }
                Piece::Code(code) => {
                    let comments = code
                        .lines()
                        .filter_map(|line| Some(line.split_once("//")?.1));
                    wanted.extend(comments.flat_map(decimals));
                }
                _ => {}
            }
        }
        wanted.retain(|number| !number.parse().is_ok_and(|number| known.contains(&number)));
        nowhere.extend(wanted.into_iter().map(str::to_owned));
    }
    nowhere
}

#[test]
fn every_decimal_beside_code_stands_in_the_code() {
    for page in EDITION.pages {
        assert_eq!(from_nowhere(&page.text), [""; 0], "{}.md", page.stem);
    }
}

#[test]
fn decimals_are_vouched_for_by_the_code_beside_them() {
    for (text, vouched) in [
        (
            "first 0.25, then $2e$ and $x=0.125$, so 0.25 in section 2.1",
            true,
        ),
        ("it is 0.7", false),
        ("it is 1000.5 and $0.5^2=0.25$, 0.125", true),
        ("$a=0.5$", false),
    ] {
        let code = "use a::b2; // 0.25\nlet x = [0.25, 1_000.5, 2e-3]; assert_eq!(y, \"0.125\"); f(1..=3, 2.0_f64)";
        let page = |text: &str, code: &str| format!("## A\n\n{text}\n\n```rust\n{code}\n```\n");
        assert_eq!(
            from_nowhere(&page(text, code)).is_empty(),
            vouched,
            "{text}"
        );
        assert_eq!(
            from_nowhere(&page("", "let x = 0.5; // not 0.375\n// but 0.5")),
            ["0.375"]
        );
    }
}
