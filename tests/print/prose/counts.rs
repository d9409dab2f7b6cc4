//! What counts in running text and is not computed: it stands in the code beside it, counts a list, or is listed.

use super::computed::COMPUTED;
use super::numbers::{WORDS, counts, literals};
use super::pages::{Block, Section};

/// Text on one line, a formula as §.
pub fn flat(text: &str) -> String {
    let parts = text.split('$').enumerate();
    let text: String = parts
        .map(|(i, part)| if i % 2 == 1 { "§" } else { part })
        .collect();
    // The line stays where a list counts.
    let lines = text
        .lines()
        .map(|line| line.split_whitespace().collect::<Vec<_>>().join(" "));
    lines.collect::<Vec<_>>().join("\n")
}

/// The words of a table on a page: how it is counted, and the words, without the reason.
pub fn listed<'a>(table: &'a str, page: &str) -> Vec<(&'a str, &'a str)> {
    let lines = table
        .lines()
        .skip_while(|line| line.strip_prefix("# ") != Some(page))
        .skip(1);
    let lines = lines.take_while(|line| !line.starts_with('#'));
    lines.filter_map(row).collect()
}

/// A row of such a table.
pub fn row(line: &str) -> Option<(&str, &str)> {
    let (how, words) = line.split_once(": ")?;
    Some((how, words.split(" -- ").next()?))
}

/// What counts in a section and has no witness; and of the words in `listed`, those that were used are noted.
pub fn uncounted(section: &Section, listed: &[(&str, &str)], used: &mut Vec<usize>) -> Vec<String> {
    let computed = COMPUTED.iter().filter(|(page, ..)| *page == section.page);
    let computed: Vec<String> = computed
        .map(|(_, words, count)| words.replace("{}", &count()))
        .collect();
    let code = section.blocks.iter().filter_map(|block| match block {
        Block::Code(code) => Some(literals(code)),
        Block::Prose(_) => None,
    });
    let mut code: Vec<f64> = code.flatten().collect();
    for block in &section.blocks {
        if let Block::Code(text) = block {
            code.extend(quotients(text));
        }
    }
    let mut out = Vec::new();
    for block in &section.blocks {
        let Block::Prose(text) = block else { continue };
        let lines = flat(text);
        let text = format!("\n{lines}");
        let one_line = text.replace('\n', " ");
        for (at, count) in counts(&text) {
            let covers = |words: &str| {
                let mut places = one_line.match_indices(words);
                places.any(|(start, _)| start <= at && at + count.len() <= start + words.len())
            };
            let close = |value: f64| {
                code.iter()
                    .any(|known| (known - value).abs() <= 1e-12 * value)
            };
            let in_code = |words: &str| values(words).into_iter().all(close);
            let of_table = listed
                .iter()
                .position(|(by, words)| covers(words) && (*by != "code" || in_code(words)));
            used.extend(of_table);
            if of_table.is_none() && !computed.iter().any(|words| covers(words)) {
                let context = one_line[..at].split(' ').rev().take(3).collect::<Vec<_>>();
                let context: Vec<&str> = context.into_iter().rev().collect();
                let after: String = one_line[at..]
                    .split(' ')
                    .take(4)
                    .collect::<Vec<_>>()
                    .join(" ");
                out.push(format!("{}: {} {after}", section.page, context.join(" ")));
            }
        }
    }
    out
}

/// What may be said of what the words around name, and nothing else vouches for.
const PLAIN: [&str; 6] = ["0", "1", "half", "two", "twice", "third"];

/// Whether a line of the list stands under the right name: what is only text is plain, what is told has a reason.
pub fn is_well_listed(line: &str) -> bool {
    let plain = |words| {
        let all: Vec<_> = counts(words)
            .into_iter()
            .map(|(_, c)| c.to_lowercase())
            .collect();
        !all.is_empty() && all.iter().all(|count| PLAIN.contains(&count.as_str()))
    };
    match line.split_once(": ") {
        Some(("text", words)) => plain(words),
        Some(("told", words)) => words
            .split_once(" -- ")
            .is_some_and(|(words, why)| !plain(words) && !why.is_empty()),
        _ => true,
    }
}

/// The fractions in code: `1.0 / 3.0`.
fn quotients(code: &str) -> Vec<f64> {
    let divisions = code.match_indices(" / ");
    let fraction = |(at, sign): (usize, &str)| {
        let number = |c: char| c.is_ascii_digit() || c == '.';
        let above = code[..at].rsplit(|c: char| !number(c)).next()?;
        let below = code[at + sign.len()..].split(|c: char| !number(c)).next()?;
        Some(above.parse::<f64>().ok()? / below.parse::<f64>().ok()?)
    };
    divisions.filter_map(fraction).collect()
}

/// What words count: numbers beside each other are one.
pub fn values(words: &str) -> Vec<f64> {
    let mut values: Vec<(usize, f64)> = Vec::new();
    // The last number of all that are taken together.
    let mut last = 1.0;
    for (at, count) in counts(words) {
        let known = WORDS.iter().find(|(word, _)| *word == count.to_lowercase());
        let mut value = known.map_or_else(
            || count.replace(',', "").parse().unwrap(),
            |(_, value)| *value,
        );
        if words[..at].ends_with("one and a ") {
            value += 1.0;
        }
        match values.last_mut() {
            // Three ten-billionths are three tenths of a billionth, three quarters are three times a quarter.
            Some((end, before))
                if *end + 1 == at && value < 1.0 && words[*end..].starts_with('-') =>
            {
                *before *= value / (last * last);
            }
            Some((end, before)) if *end + 1 == at => *before *= value,
            _ => values.push((0, value)),
        }
        if words[at + count.len()..].starts_with(" %") {
            values.last_mut().unwrap().1 /= 100.0;
        }
        last = value;
        values.last_mut().unwrap().0 = at + count.len();
    }
    values.into_iter().map(|(_, value)| value).collect()
}

#[test]
fn words_that_count_have_a_value() {
    for (words, expected) in [
        ("a ten-billionth of it", 1e-10),
        ("three quarters of it", 0.75),
        ("one and a half times as strong", 1.5),
        ("ten thousand times", 1e4),
        ("three ten-millionths of it", 3e-7),
        ("within 2 % of it", 0.02),
    ] {
        let [value] = values(words)[..] else {
            panic!("{words}")
        };
        assert!((value / expected - 1.0).abs() < 1e-15, "{words}");
    }
    assert_eq!(
        quotients("assert!((x - 1.0 / 3.0).abs() < a / 2.0)"),
        [1.0 / 3.0]
    );
}
