//! What counts in running text, and what it is counted by.

use super::numbers::{WORDS, counts, literals};
use super::pages::{Block, Section};
use slipbook::claims::PAPER;
use slipbook::claims::anisotropic::census;
use slipbook::claims::values::VALUES;
use std::f64::consts::TAU;

/// How many digits the calculators claimed, and had.
const DIGITS: &str = include_str!("../../../snapshots/digits.csv");
/// The mistakes that are made in the physics of a drive.
const PHYSICS: &str = include_str!("../../../mutants/physics/2-drive.txt");
/// The example that a page speaks of.
const DRAG: &str = include_str!("../../../trialbook/examples/drag/main.rs");

/// A count that is computed: page, words with `{}` for it, and what it has to be there.
type Computed = (&'static str, &'static str, fn() -> String);

pub const COMPUTED: &[Computed] = &[
    ("anisotropic", "nearly {} points", || {
        let points = census::COLUMNS * census::ROWS;
        in_thousands(points.next_multiple_of(10_000))
    }),
    (
        "anisotropic",
        "These are the paper's {} kinds of motion",
        || word(named("s24-region-")),
    ),
    ("general", "The paper draws {} conclusions", || {
        word(in_words_only("general"))
    }),
    (
        "general",
        "## {} statements about every acceleration",
        || capital(&word(in_words_only("general"))),
    ),
    (
        "sinusoidal",
        "That makes {} phases of a period special",
        || word(VALUES.iter().filter(|v| v.id.starts_with("phi-")).count() as f64),
    ),
    ("speed", "{} particles go side by side", || {
        let source = include_str!("../../../src/motion/turntable/ensemble.rs");
        let lanes = source.split("const LANES: usize = ").nth(1).unwrap();
        capital(&word(lanes.split(';').next().unwrap().parse().unwrap()))
    }),
    ("accuracy", "asked {} times", || {
        let rows = DIGITS.lines().skip(1);
        let mut asked = std::collections::BTreeMap::<&str, usize>::new();
        for row in rows {
            let cells: Vec<&str> = row.split(',').collect();
            *asked.entry(cells[0]).or_default() += cells[3].parse::<usize>().unwrap();
        }
        let of_each: std::collections::BTreeSet<usize> = asked.into_values().collect();
        format!("{of_each:?}").replace("{10000}", "ten thousand")
    }),
    ("accuracy", "has all its {} digits", || word(most_digits())),
    (
        "json",
        "a number of up to {} digits",
        || word(most_digits()),
    ),
    ("proved", "friction that is a part in {} too strong", || {
        slips("1e-7", "ten million")
    }),
    ("proved", "that gives way a part in {} too early", || {
        slips("1e-9", "10⁹")
    }),
    ("escape", "differ by {} per cent or less", || {
        let value = |id| {
            VALUES
                .iter()
                .find(|v| v.id == id)
                .unwrap()
                .number()
                .unwrap()
        };
        let pairs = [("a-printed", "a"), ("p-printed", "p"), ("s-printed", "s")];
        let apart = pairs.map(|(printed, right)| (value(printed) / value(right) - 1.0).abs());
        word((100.0 * apart.into_iter().fold(0.0, f64::max)).ceil())
    }),
    ("escape", "which turns {} times meanwhile", || {
        format!("{} million", word(((1e8 - 1e4) / TAU / 1e6).round()))
    }),
    ("rest", "the code does, to {} digits", || {
        let value = |id| VALUES.iter().find(|v| v.id == id).unwrap().decimals;
        word(value("critical-radius").min(value("critical-speed")) as f64)
    }),
    ("turntable", "subject of the next {} chapters", || {
        let stems = PAPER.topics.iter().map(|topic| topic.stem);
        word(
            stems
                .skip_while(|stem| *stem != "turntable")
                .skip(1)
                .count() as f64,
        )
    }),
    ("own", "a whole paper in some {} lines", || {
        (10 * DRAG.lines().count().div_ceil(10)).to_string()
    }),
    ("own", "{} equations,", || {
        let numbers = (1..100).filter(|n| DRAG.contains(&format!("pub fn eq{n}_")));
        word(numbers.count() as f64)
    }),
    ("own", "equations, {} of them proved", || {
        word(DRAG.matches("> = proved(").count() as f64)
    }),
];

fn most_digits() -> f64 {
    let rows = DIGITS.lines().skip(1);
    let claimed = rows.map(|row| row.split(',').nth(1).unwrap().parse::<usize>().unwrap());
    claimed.max().unwrap() as f64
}

/// The words, if the list of mistakes in the physics has one of this size.
fn slips(size: &str, words: &str) -> String {
    let there = PHYSICS.contains(size);
    if there {
        words.to_owned()
    } else {
        format!("no mistake of {size}")
    }
}

/// How many claims begin their ids so.
fn named(prefix: &str) -> f64 {
    PAPER
        .claims()
        .filter(|(_, claim)| claim.id.starts_with(prefix))
        .count() as f64
}

/// How many claims of a topic have no number.
fn in_words_only(stem: &str) -> f64 {
    let claims = PAPER
        .claims()
        .filter(|(topic, claim)| topic.stem == stem && claim.equation.is_none());
    claims.count() as f64
}

fn capital(word: &str) -> String {
    word[..1].to_uppercase() + &word[1..]
}

/// A number as a word.
fn word(n: f64) -> String {
    let found = WORDS.iter().find(|(_, value)| *value == n);
    found.map_or_else(|| n.to_string(), |(word, _)| (*word).to_owned())
}

fn in_thousands(n: usize) -> String {
    format!("{} thousand", word(n as f64 / 1e3))
}

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

/// The words of a table on a page: how it is counted, and the words.
pub fn listed<'a>(table: &'a str, page: &str) -> Vec<(&'a str, &'a str)> {
    let lines = table
        .lines()
        .skip_while(|line| line.strip_prefix("# ") != Some(page))
        .skip(1);
    let lines = lines.take_while(|line| !line.starts_with('#'));
    lines.filter_map(|line| line.split_once(": ")).collect()
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
    let code: Vec<f64> = code.flatten().collect();
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
            let in_code = |words: &str| values(words).iter().all(|value| code.contains(value));
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

/// What words count: numbers beside each other are one.
fn values(words: &str) -> Vec<f64> {
    let mut values: Vec<(usize, f64)> = Vec::new();
    for (at, count) in counts(words) {
        let known = WORDS.iter().find(|(word, _)| *word == count.to_lowercase());
        let value = known.map_or_else(
            || count.replace(',', "").parse().unwrap(),
            |(_, value)| *value,
        );
        match values.last_mut() {
            Some((end, before)) if *end + 1 == at => *before *= value,
            _ => values.push((0, value)),
        }
        values.last_mut().unwrap().0 = at + count.len();
    }
    values.into_iter().map(|(_, value)| value).collect()
}
