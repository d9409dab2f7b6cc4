//! Numbers in words, decimals in running text, and the numbers in code.

use super::formulas::{Given, found, is_arithmetic};
use super::text::{Block, Section, Word, sections, stands, words};
use trialbook::notation;

/// The number that words are which stand beside each other.
pub fn number(words: &[Word]) -> Option<f64> {
    let texts: Vec<&str> = words.iter().map(|word| &word.text[..]).collect();
    // With its article a number would be another slot.
    notation::number(&texts).filter(|_| !matches!(texts[..], ["a" | "the" | "no" | "none", ..]))
}

/// Where a text has the words of a pattern: the place of the first, and of the number that it has for `{}`, the
/// place and the length.
pub fn slots(text: &[Word], pattern: &str) -> Vec<(usize, usize, usize)> {
    let (before, after) = pattern.split_once("{}").expect("a place for a number");
    let (before, after) = (words(before), words(after));
    let long = |start: usize| {
        let first = start + before.len();
        let fits = |length: &usize| {
            let slot = &text[first..text.len().min(first + length)];
            let together = slot.iter().rev().skip(1).all(|word| !word.ends);
            slot.len() == *length && together && number(slot).is_some()
        };
        let length = (1..=4).rev().find(fits)?;
        // Of three hundred the hundred alone is no number.
        let inside = before.is_empty()
            && start > 0
            && !text[start - 1].ends
            && number(&text[start - 1..=start]).is_some();
        (!inside && stands(&text[first + length..], &after)).then_some((start, first, length))
    };
    let starts = (0..text.len()).filter(|start| stands(&text[*start..], &before));
    starts.filter_map(long).collect()
}

/// The fractions in code: `1.0 / 3.0`.
pub fn quotients(code: &str) -> Vec<f64> {
    let number = |c: char| c.is_ascii_digit() || c == '.';
    let fraction = |(at, sign): (usize, &str)| {
        let above = code[..at].rsplit(|c: char| !number(c)).next()?;
        let below = code[at + sign.len()..].split(|c: char| !number(c)).next()?;
        Some(above.parse::<f64>().ok()? / below.parse::<f64>().ok()?)
    };
    code.match_indices(" / ").filter_map(fraction).collect()
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

/// The decimals of a text as they stand there, without numbers of sections and of problems.
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

/// The decimals of a section that are neither in the code nor in arithmetic that is tried as it stands.
fn from_nowhere(section: &Section) -> Vec<String> {
    let known: Vec<f64> = section.code().flat_map(literals).collect();
    let mut given = Given::new();
    let mut wanted: Vec<&str> = Vec::new();
    for block in &section.blocks {
        match block {
            Block::Prose(text) => {
                for (i, part) in text.split('$').enumerate() {
                    let formula = i % 2 == 1;
                    if !(formula && is_arithmetic(part, &given)) {
                        wanted.extend(decimals(part));
                    }
                    if formula {
                        found(part, &mut given);
                    }
                }
            }
            Block::Code(code) => {
                let comments = code
                    .lines()
                    .filter_map(|line| Some(line.split_once("//")?.1));
                wanted.extend(comments.flat_map(decimals));
            }
        }
    }
    wanted.retain(|number| {
        !number
            .parse()
            .is_ok_and(|number: f64| known.contains(&number))
    });
    let line = |number: &&str| format!("{}: {number}", section.page);
    wanted.iter().map(line).collect()
}

#[test]
fn every_decimal_beside_code_stands_in_the_code() {
    let failures: Vec<String> = sections().iter().flat_map(from_nowhere).collect();
    assert!(
        failures.is_empty(),
        "numbers from nowhere:\n{}",
        failures.join("\n")
    );
}

#[test]
fn decimals_are_vouched_for_by_the_code_beside_them() {
    let code = "use a::b2; // 0.25\nlet x = [0.25, 1_000.5, 2e-3]; assert_eq!(y, \"0.125\"); f(1..=3, 2.0_f64)";
    assert_eq!(literals(code), [0.25, 1000.5, 2e-3, 0.125, 1.0, 3.0, 2.0]);
    for (text, vouched) in [
        (
            "first 0.25, then $2e$ and $x=0.125$, so 0.25 in section 2.1",
            true,
        ),
        ("it is 0.7", false),
        ("it is 1000.5 and $0.5^2=0.25$, 0.125", true),
        ("$a=0.5$", false),
    ] {
        let blocks = || vec![Block::Prose(text.to_owned()), Block::Code(code.to_owned())];
        let section = |blocks| Section {
            page: "p".to_owned(),
            from: 0,
            blocks,
        };
        assert_eq!(
            from_nowhere(&section(blocks())).is_empty(),
            vouched,
            "{text}"
        );
        let commented = Block::Code("let x = 0.5; // not 0.375\n// but 0.5".to_owned());
        assert_eq!(from_nowhere(&section(vec![commented])), ["p: 0.375"]);
    }
}

#[test]
fn words_that_count_have_a_value() {
    for (text, expected) in [
        ("just ten-billionth of it", 1e-10),
        ("just three quarters of it", 0.75),
        ("just one and a half of it", 1.5),
        ("just ten thousand of it", 1e4),
        ("just three ten-millionths of it", 3e-7),
        ("just 2 % of it", 0.02),
        ("just 10⁹ of it", 1e9),
        ("just 10,000 of it", 1e4),
        ("just two, three of it", f64::NAN),
        ("just few of it", f64::NAN),
    ] {
        let text = words(text);
        match slots(&text, "just {} of")[..] {
            [(0, at, length)] => {
                let value = number(&text[at..at + length]).unwrap();
                assert!((value / expected - 1.0).abs() < 1e-15, "{value} {expected}");
            }
            _ => assert!(expected.is_nan(), "{expected}"),
        }
    }
    assert_eq!(
        slots(&words("three hundred steps"), "{} steps"),
        [(0, 0, 2)]
    );
    assert_eq!(
        quotients("assert!((x - 1.0 / 3.0).abs() < a / 2.0)"),
        [1.0 / 3.0]
    );
}
