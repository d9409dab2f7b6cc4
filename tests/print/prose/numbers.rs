//! Numbers in running text, and the code beside it that vouches for them.

use super::formulas::{Given, found, is_arithmetic};
use super::pages::{Block, Section};

/// Words that count.
pub const WORDS: &[(&str, f64)] = &[
    ("two", 2.0),
    ("three", 3.0),
    ("four", 4.0),
    ("five", 5.0),
    ("six", 6.0),
    ("seven", 7.0),
    ("eight", 8.0),
    ("nine", 9.0),
    ("ten", 10.0),
    ("eleven", 11.0),
    ("twelve", 12.0),
    ("fifteen", 15.0),
    ("sixteen", 16.0),
    ("twenty", 20.0),
    ("thirty", 30.0),
    ("forty", 40.0),
    ("fifty", 50.0),
    ("sixty", 60.0),
    ("seventy", 70.0),
    ("eighty", 80.0),
    ("ninety", 90.0),
    ("hundred", 1e2),
    ("thousand", 1e3),
    ("million", 1e6),
    ("billion", 1e9),
    ("billionth", 1e-9),
    ("billionths", 1e-9),
    ("millionth", 1e-6),
    ("millionths", 1e-6),
    ("thousandth", 1e-3),
    ("hundredth", 0.01),
    ("tenth", 0.1),
    ("half", 0.5),
    ("third", 1.0 / 3.0),
    ("thirds", 1.0 / 3.0),
    ("quarter", 0.25),
    ("quarters", 0.25),
    ("twice", 2.0),
];

/// Behind these stands a year.
const MONTHS: [&str; 12] = [
    "January",
    "February",
    "March",
    "April",
    "May",
    "June",
    "July",
    "August",
    "September",
    "October",
    "November",
    "December",
];

/// The decimals of a text as they stand there, without numbers of sections and of problems.
pub fn decimals(text: &str) -> Vec<&str> {
    let mut found = Vec::new();
    for (start, number) in digits(text) {
        let mut before = text[..start].split_whitespace().rev();
        let section = before.next().is_some_and(|word| {
            ["section", "before", "problem"]
                .contains(&word.trim_start_matches(['[', '*']).to_lowercase().as_str())
        });
        if number.contains('.') && !section {
            found.push(number);
        }
    }
    found
}

/// The runs of digits, with decimals, and where they begin.
fn digits(text: &str) -> Vec<(usize, &str)> {
    let mut found = Vec::new();
    let mut at = 0;
    while let Some(start) = text[at..]
        .find(|c: char| c.is_ascii_digit())
        .map(|i| at + i)
    {
        let end = text[start..].find(|c: char| !(c.is_ascii_digit() || c == '.' || c == ','));
        let end = end.map_or(text.len(), |i| start + i);
        found.push((start, text[start..end].trim_end_matches(['.', ','])));
        at = end;
    }
    found
}

/// True if what stands behind a number shows that it is the volume or the page of a reference, as in `32, 1049 (2011)`.
fn of_reference(after: &str) -> bool {
    let digit = |c: char| c.is_ascii_digit();
    let after = after
        .strip_prefix(", ")
        .map_or(after, |page| page.trim_start_matches(digit));
    let year = after
        .strip_prefix(" (")
        .and_then(|rest| rest.split_once(')'));
    year.is_some_and(|(year, _)| year.len() == 4 && year.chars().all(digit))
}

/// What counts in a text without formulas: where it begins, and as it stands there. Numbers of equations, sections, figures,
/// exercises, references and lists are left out by their form.
pub fn counts(text: &str) -> Vec<(usize, &str)> {
    let mut found: Vec<(usize, &str)> = Vec::new();
    for (start, number) in digits(text) {
        let (before, after) = (&text[..start], &text[start + number.len()..]);
        let word = before.split_whitespace().next_back().unwrap_or_default();
        let word = word.trim_start_matches(['[', '*']).to_lowercase();
        let named =
            before.ends_with(' ') && ["section", "figure", "before"].contains(&word.as_str());
        let equation = before.ends_with('(') && after.starts_with(')');
        let exercise = before.ends_with("**") && after.starts_with(".**");
        let address = before.ends_with("eq-");
        let listed = before.ends_with('\n') && after.starts_with(". ");
        // UTF-8, IEEE 754, f64, November 2026.
        let last = before.trim_end_matches([' ', '-']);
        let capitals = last
            .chars()
            .rev()
            .take(2)
            .filter(char::is_ascii_uppercase)
            .count();
        let name = capitals == 2 && last.len() < before.len()
            || before.ends_with(|c: char| c.is_ascii_alphabetic())
            || MONTHS.iter().any(|month| last.ends_with(month));
        let other = address || listed || name || of_reference(after) || number.contains('.');
        if !(named || equation || exercise || other) {
            found.push((start, number));
        }
    }
    let mut start = 0;
    for word in text.split(|c: char| !c.is_alphabetic()) {
        let at = start;
        start += word.len()
            + text[start + word.len()..]
                .chars()
                .next()
                .map_or(0, char::len_utf8);
        if WORDS.iter().any(|(known, _)| *known == word.to_lowercase()) {
            found.push((at, word));
        }
    }
    found.sort_unstable();
    found
}

/// The numbers in code, in order; those in its comments do not count.
pub fn literals(code: &str) -> Vec<f64> {
    let mut numbers = Vec::new();
    let lines = code
        .lines()
        .map(|line| line.split("//").next().unwrap_or_default());
    for line in lines.filter(|line| !line.starts_with("use ")) {
        let mut rest = line;
        let mut before = ' ';
        while let Some(first) = rest.chars().next() {
            let starts = first.is_ascii_digit() && !(before.is_alphanumeric() || before == '_');
            let length = if starts {
                length(rest)
            } else {
                first.len_utf8()
            };
            if starts {
                let text = rest[..length].replace('_', "");
                numbers.extend(text.parse::<f64>());
            }
            before = rest[..length].chars().next_back().unwrap_or(' ');
            rest = &rest[length..];
        }
    }
    numbers
}

/// How long the number is that a text begins with.
fn length(text: &str) -> usize {
    let bytes = text.as_bytes();
    let mut end = 0;
    while end < bytes.len() {
        let next = bytes.get(end + 1).copied().unwrap_or(b' ');
        let part = match bytes[end] {
            b'0'..=b'9' => true,
            b'_' | b'.' => next.is_ascii_digit(),
            b'e' => next.is_ascii_digit() || next == b'-',
            b'-' => bytes[end - 1] == b'e',
            _ => false,
        };
        if !part {
            break;
        }
        end += 1;
    }
    end
}

/// The decimals of a section for which the code beside them does not vouch: in the order in which the text first names
/// them they stand in the code after it, or in the code before it.
pub fn unvouched(section: &Section) -> Vec<String> {
    let mut out = Vec::new();
    for (i, block) in section.blocks.iter().enumerate() {
        let text = match block {
            Block::Prose(text) => text,
            Block::Code(code) => {
                let known = literals(code);
                let comments = code
                    .lines()
                    .filter_map(|line| Some(line.split_once("//")?.1));
                let unknown = comments
                    .flat_map(decimals)
                    .filter(|n| !known.contains(&n.parse().unwrap()));
                out.extend(unknown.map(|n| format!("{}.md: {n} in a comment", section.page)));
                continue;
            }
        };
        let wanted = wanted(text);
        let code = |block: &Block| match block {
            Block::Code(code) => Some(literals(code)),
            Block::Prose(_) => None,
        };
        let after = section.blocks[i..].iter().find_map(code);
        let before = section.blocks[..i].iter().rev().find_map(code);
        let missing = |code: Option<Vec<f64>>| {
            let mut code = code.unwrap_or_default().into_iter();
            wanted
                .iter()
                .find(|number| code.all(|literal| literal != number.parse::<f64>().unwrap()))
        };
        if let (Some(number), Some(_)) = (missing(after), missing(before)) {
            let context = text.split(number.as_str()).next().unwrap_or_default();
            let context: Vec<&str> = context.split_whitespace().rev().take(5).collect();
            let context: Vec<&str> = context.into_iter().rev().collect();
            out.push(format!(
                "{}.md: {} {number}",
                section.page,
                context.join(" ")
            ));
        }
    }
    out
}

/// The decimals of a text that want a witness, each once: all but those of arithmetic that is tried as it stands.
fn wanted(text: &str) -> Vec<String> {
    let mut wanted: Vec<String> = Vec::new();
    let mut given = Given::new();
    for (i, part) in text.split('$').enumerate() {
        let formula = i % 2 == 1;
        if formula && is_arithmetic(part, &given) {
            found(part, &mut given);
            continue;
        }
        if formula {
            found(part, &mut given);
        }
        for number in decimals(part) {
            if !wanted.iter().any(|known| known == number) {
                wanted.push(number.to_owned());
            }
        }
    }
    wanted
}

#[test]
fn decimals_are_vouched_for_in_their_order_by_the_code_beside_them() {
    let section = |text: &str, code: &str| Section {
        page: "p".to_owned(),
        blocks: vec![Block::Prose(text.to_owned()), Block::Code(code.to_owned())],
    };
    let code = "use a::b2; // 0.25\nlet x = [0.25, 1_000.5, 2e-3]; assert_eq!(y, \"0.125\"); f(1..=3, 2.0_f64)";
    assert_eq!(literals(code), [0.25, 1000.5, 2e-3, 0.125, 1.0, 3.0, 2.0]);
    for (text, vouched) in [
        (
            "first 0.25, then $2e$ and $x=0.125$, so 0.25 in section 2.1",
            true,
        ),
        ("first 0.125, then 0.25", false),
        ("it is 0.7", false),
        ("it is 1000.5 and $0.5^2=0.25$, 0.125", true),
        ("$a=0.5$", false),
    ] {
        assert_eq!(
            unvouched(&section(text, code)).is_empty(),
            vouched,
            "{text}"
        );
    }
}

#[test]
fn what_counts_is_told_from_what_is_numbered() {
    let text = "Section 2 and figure 3 of (12):\n1. Two of 40 halves, **2.** a tenth at 0.5, Phys. 32, 1049 (2011), 5, 6 (70)";
    let counts: Vec<&str> = counts(text).into_iter().map(|(_, word)| word).collect();
    assert_eq!(counts, ["Two", "40", "tenth", "5", "6"]);
}

#[test]
fn a_comment_in_code_says_no_number_that_the_code_has_not() {
    let block = Block::Code("let x = 0.5; // not 0.25\n// but 0.5".to_owned());
    let section = Section {
        page: "p".to_owned(),
        blocks: vec![block],
    };
    assert_eq!(unvouched(&section), ["p.md: 0.25 in a comment"]);
}
