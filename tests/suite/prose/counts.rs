//! Counts from the code and the files beside a page, or from what the page itself shows; others are computed where the book is made,
//! `src/edition/words`. A row is found by a few words around the number: they have to be there, and each number there right.

use super::{
    choices::gone,
    numbers::{literals, number, quotients, slots},
    printed_part::Library,
    text::{Page, Section, pages, sections_of},
};
use slipbook::claims::{PAPER, corners::CORNERS};
use slipbook::motion::{
    sphere::Ball,
    turntable::{Start, intrinsic},
};
use slipbook::seeded::Corner;
use slipbook::solve::VERSION;
use std::collections::BTreeSet;

/// What a number has to be.
enum Count {
    Is(fn() -> f64),
    /// One of these.
    Among(fn(&Page) -> Vec<f64>),
    /// In the code of the same section.
    Code,
}

use Count::{Among, Code, Is};

/// A page, words with `{}` for the number, and what it has to be.
type Row = (&'static str, &'static str, Count);

macro_rules! counts {
    ($($page:literal, $words:literal => $count:expr;)*) => {
        const COUNTS: &[Row] = &[$(($page, $words, $count)),*];
    };
}

counts! {
    "methods", "asked {} times" => Among(|_| digits().asked);
    "methods", "has all its {} digits" => Among(|_| digits().most);
    "json", "number of up to {} digits" => Among(|_| digits().most);
    "json", "relative to that {} if" => Among(|_| digits().most);
    "methods", "part in {} too strong" => Among(slips);
    "methods", "part in {} too early" => Among(slips);
    "methods", "a {} of 0 or of 1" => Is(|| edges("λ₀").map(|c| c.high - c.low).fold(0.0, f64::max));
    "methods", "coefficient of friction above {}" => Is(|| edges("μ").next().unwrap().low);
    "methods", "or § above {}" => Is(|| edges("α").find(|c| c.high.is_infinite()).unwrap().low);
    "methods", "or § above {} or" => Is(|| edges("β").find(|c| c.high.is_infinite()).unwrap().low);
    "methods", "or below a {}" => Is(|| edges("α").find(|c| c.low == 0.0).unwrap().high);
    "methods", "below a {} and" => Is(|| edges("β").find(|c| c.low == 0.0).unwrap().high);
    "general", "draws {} conclusions" => Is(|| without_number("general"));
    "general", "{} statements about every" => Is(|| without_number("general"));
    "exam", "second prints {} of them" => Among(|page| {
        let command = behind(&page.text, "slipbook exam --json > exam.json\nslipbook exam ").lines().next();
        command.iter().map(|line| line.split(' ').count() as f64).collect()
    });
    "escape", "is within {} of" => Code;
    "rest", "turns {} times a minute" => Code;
    "rest", "less than a {} of each" => Code;
    "json", "takes some {} steps" => Is(|| 10.0 * (steps() / 10.0).round());
    "json", "same for a {} starts" => Among(|_| timed().into_iter().take(1).collect());
    "json", "as for a {}" => Among(|_| timed().into_iter().skip(1).collect());
    "turntable", "so {} numbers suffice" => Is(|| arguments(&["eq107_p_rate", "eq108_rho_rate", "eq109_psi_rate"]));
    "turntable", "grows at the rate {}" => Code;
    "turntable", "at {} turns a minute" => Code;
    "own", "{} equations are printed" => Among(|_| {
        let example = file("trialbook/examples/fall.rs");
        equations(behind(&example, "mod paper {").split("\n}").next().unwrap_or_default())
    });
    "own", "whole paper {} equations" => Among(|_| equations(&file("trialbook/examples/drag/main.rs")));
    "own", "it takes {} commands" => Among(|page| {
        let (steps, _) = page.text.split_once("## Break it").unwrap_or_default();
        let blocks = steps.split("```text").skip(1).filter_map(|block| block.split("```").next());
        let is_command = |line: &&str| line.starts_with("cargo ") || line.starts_with("cd ");
        some(blocks.flat_map(str::lines).filter(is_command).count())
    });
    "methods", "mpmath to a {} decimals" => Among(|_| {
        let text = file("tests/data/digits/certified.csv");
        let long = text.lines().skip(1).filter_map(|row| row.split(',').nth(2)?.split_once('.'));
        let least = long.map(|(_, decimals)| decimals.len()).min();
        least.iter().map(|least| (least / 1000 * 1000) as f64).collect()
    });
    "json", "for {} numbers from the first" => Among(|page| {
        let range = behind(&page.text, "in the place of a number, `").split(':').nth(2);
        range.into_iter().map(leading).collect()
    });
    "json", "of {} parts" => Among(|page| {
        let shard = behind(&page.text, "`--shard ").split_once('/');
        shard.into_iter().map(|(_, of)| leading(of)).collect()
    });
    "json", "describes version {}" => Is(|| f64::from(VERSION));
    "json", "the {} of them add up" => Among(|page| {
        let section = behind(&page.text, "{#solve-anisotropic}").split("\n## ").next();
        some(section.unwrap_or_default().matches("| number | length of ").count())
    });
    "constant", "with a {} of the time left" => Code;
    "constant", "about a {} of its initial value" => Code;
    "constant", "ends up with {} of its speed" => Code;
    "sinusoidal", "vanishes at {} instants" => Code;
    "sphere", "with {} components" => Is(|| {
        let ball = Ball { t: 0.0, x: [0.0; 2], v: [0.0; 2], omega: [0.0; 3] };
        ball.omega.len() as f64
    });
    "periodic", "rests for a {} of each" => Code;
    "periodic", "fill {} of the time" => Code;
    "anisotropic", "each of {} ×" => Code;
    "anisotropic", "× {} cells" => Code;
    "anisotropic", "the one {} between them" => Code;
    "anisotropic", "here are {}" => Code;
    // Beside the phase.
    "anisotropic", "{} numbers decide" => Is(|| arguments(&["eq51_rate", "eq52_rate"]) - 1.0);
    "anisotropic", "map of these {} numbers" => Is(|| arguments(&["eq51_rate", "eq52_rate"]) - 1.0);
    "anisotropic", "{} questions four borders" => Among(curves);
    "anisotropic", "questions {} borders" => Among(curves);
    "anisotropic", "{} questions decide what comes next" => Among(curves);
}

/// Whether a page has the number right that a row is about, wherever it says so; none if nowhere.
fn holds((_, pattern, count): &Row, page: &Page) -> Option<bool> {
    let found = slots(&page.words, pattern);
    let right = |(start, at, length): &(usize, usize, usize)| {
        let slot = &page.words[*at..at + length];
        let start = page.words[*start].at;
        let among = |all: Vec<f64>| {
            let close = |n: f64| all.iter().any(|right| (right - n).abs() <= 1e-9 * n.abs());
            number(slot).is_some_and(close)
        };
        match count {
            Is(right) => among(vec![right()]),
            Among(all) => among(all(page)),
            Code => {
                let sections = sections_of(&page.name, &page.text);
                let here = sections.iter().rfind(|section| section.from <= start);
                let code = here.into_iter().flat_map(Section::code);
                among(
                    code.flat_map(|code| [literals(code), quotients(code)].concat())
                        .collect(),
                )
            }
        }
    };
    (!found.is_empty()).then(|| found.iter().all(right))
}

#[test]
fn every_count_is_there_and_right_and_no_other_would_be() {
    let (mut pages, mut failures) = (pages(), Vec::new());
    for row in COUNTS {
        let (name, pattern, _) = row;
        let page = pages
            .iter_mut()
            .find(|page| page.name == *name)
            .expect("a page");
        match holds(row, page) {
            None => failures.push(gone(name, pattern)),
            Some(false) => failures.push(format!("{name}: wrong in {pattern:?}")),
            Some(true) => {}
        }
        // Each place counts.
        let words = page.words.clone();
        for (_, at, _) in slots(&words, pattern) {
            page.words[at].text = "77,777".to_owned();
            if holds(row, page) == Some(true) {
                failures.push(format!("{name}: anything would do in {pattern:?}"));
            }
            page.words.clone_from(&words);
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

/// A file of the crate, empty if there is none.
fn file(path: &str) -> String {
    std::fs::read_to_string(path).unwrap_or_default()
}

/// What stands behind these words, nothing if they are not there.
fn behind<'a>(text: &'a str, words: &str) -> &'a str {
    text.split_once(words).unwrap_or_default().1
}

/// The number at the beginning of a text.
fn leading(text: &str) -> f64 {
    let end = text
        .find(|c: char| !c.is_ascii_digit() && c != '.')
        .unwrap_or(text.len());
    text[..end]
        .trim_end_matches('.')
        .parse()
        .unwrap_or(f64::NAN)
}

/// A number of things, none if none were found.
fn some(n: usize) -> Vec<f64> {
    (n > 0).then_some(n as f64).into_iter().collect()
}

/// What the record says of the calculators: how many cases each was asked, how many digits they claimed at most.
#[derive(Default)]
struct Digits {
    asked: Vec<f64>,
    most: Vec<f64>,
}

fn digits() -> Digits {
    let text = file("snapshots/digits.csv");
    let mut asked = std::collections::BTreeMap::<&str, f64>::new();
    let mut most = None;
    for row in text.lines().skip(1) {
        let cells: Vec<&str> = row.split(',').collect();
        let [calculator, claimed, _, cases] = cells[..] else {
            return Digits::default();
        };
        *asked.entry(calculator).or_default() += leading(cases);
        most = most.max(claimed.parse::<usize>().ok());
    }
    let mut asked: Vec<f64> = asked.into_values().collect();
    asked.dedup();
    // Each as often, or nothing can be said of all.
    asked.truncate(usize::from(asked.len() == 1));
    Digits {
        asked,
        most: most.map_or_else(Vec::new, some),
    }
}

/// How many parts each of the mistakes in a drive is one of.
fn slips(_: &Page) -> Vec<f64> {
    literals(&file("mutants/physics/2-drive.txt"))
        .into_iter()
        .map(|size| (1.0 / size).round())
        .collect()
}

/// The least and the largest number of starts that were timed, as powers of ten.
fn timed() -> Vec<f64> {
    let results: serde_json::Value =
        serde_json::from_str(&file("benches/results.json")).unwrap_or_default();
    let rows = results["growth"].as_array().cloned().unwrap_or_default();
    let starts = [rows.first(), rows.last()].into_iter().flatten();
    starts
        .filter_map(|row| Some(10_f64.powf(row["starts"].as_f64()?.log10().round())))
        .collect()
}

/// How many equations an example prints.
fn equations(example: &str) -> Vec<f64> {
    some(
        (1..100)
            .filter(|n| example.contains(&format!("pub fn eq{n}_")))
            .count(),
    )
}

/// How many curves a page has headings for.
fn curves(page: &Page) -> Vec<f64> {
    some(page.text.matches("{#curve-").count())
}

/// How many steps a motion on the turntable takes to rest, or to a time of 100, at a middle.
fn steps() -> f64 {
    let starts = [0.3, 0.6, 0.9, 1.2, 1.5].map(|a| Start::hyperbolic(a, 0.3, 1.0).unwrap());
    let runs = starts.map(|start| intrinsic::Run::new(&start, 100.0).unwrap());
    let mut steps = runs.map(|run| run.nodes().count());
    steps.sort_unstable();
    steps[2] as f64
}

/// The corners of a symbol.
fn edges(letter: &'static str) -> impl Iterator<Item = &'static Corner> {
    CORNERS.iter().filter(move |corner| corner.letter == letter)
}

/// How many claims of a topic have no number.
fn without_number(topic: &str) -> f64 {
    let of_topic = PAPER
        .claims()
        .filter(|(of, claim)| of.stem == topic && claim.equation.is_none());
    of_topic.count() as f64
}

/// How many arguments these formulas have.
fn arguments(formulas: &[&str]) -> f64 {
    let library = Library::new();
    let all = formulas
        .iter()
        .flat_map(|name| library.formula(name).arguments);
    all.collect::<BTreeSet<_>>().len() as f64
}
