//! Captions, and what they say to those who do not see the figure.

use crate::data::Data;
use crate::directed;
use crate::tried::TRIED;
use slipbook::figures::all;

/// Words with a direction in captions, and those that say how something is drawn.
const SHOWN: &[&str] = &[
    "above",
    "across",
    "against",
    "along",
    "backwards",
    "below",
    "dashed",
    "dotted",
    "down",
    "dwindles",
    "earlier",
    "fall",
    "falling",
    "falls",
    "faster",
    "first",
    "growing",
    "grows",
    "higher",
    "horizontal",
    "inertial",
    "inner",
    "inside",
    "larger",
    "last",
    "left",
    "less",
    "longest",
    "lower",
    "more",
    "never",
    "outer",
    "outside",
    "outwards",
    "right",
    "rise",
    "rises",
    "rising",
    "second",
    "shrink",
    "slower",
    "small",
    "smaller",
    "solid",
    "steeper",
    "steeply",
    "thick",
    "thin",
    "up",
    "upwards",
    "vertical",
];

/// Words with a direction in captions that nothing tries, by figure.
const UNTRIED: &[(&str, &str)] = &[
    ("fig-1", "along inertial right upwards Above up Below above"),
    ("constant-speed-angle", "inertial against Above Below"),
    ("fig-2", "along against across first lower smaller"),
    ("sinusoidal-decay", "dotted dwindles below"),
    ("sinusoidal-rest", "up"),
    ("sinusoidal-family", "against small down"),
    (
        "periodic-census",
        "against first small right last horizontal never",
    ),
    ("periodic-pulses", "up down small rises falls"),
    ("periodic-rest-shares", "right upwards Above grows left"),
    ("periodic-come-and-go", "growing first second never"),
    (
        "fig-5",
        "last first right upwards fall left horizontal thin below second along lower above",
    ),
    ("fig-6", "against backwards right upwards never"),
    ("anisotropic-census", "right upwards below above"),
    ("anisotropic-far", "horizontal falls below"),
    ("sphere-swinging", "solid dashed against first second"),
    ("turntable-paths", "outwards slower first right second"),
    (
        "turntable-following",
        "First thick thin dotted against first rise second",
    ),
    ("escape-compensated", "grows falls right horizontal"),
    (
        "escape-paths",
        "down inside outside backwards outwards first second",
    ),
    ("escape-fan", "down along inner dotted outer backwards"),
    ("escape-residual", "horizontal dashed grows"),
    ("rest-radius", "down dashed vertical"),
    ("rest-hodograph", "down last vertical horizontal along"),
    (
        "rest-basin",
        "outwards first along second horizontal vertical",
    ),
    (
        "rest-census",
        "dotted second small right upwards below falls steeply solid dashed",
    ),
    ("rest-fates", "below lower above last right upwards rises"),
    ("rest-boundary", "against second dashed"),
    (
        "rest-space",
        "along outside dotted down falls right larger left",
    ),
    (
        "digits",
        "against higher more last right below dashed above upwards",
    ),
    ("constant-stopping-time", "against"),
    ("fig-3", "against"),
    ("fig-4", "against"),
    (
        "anisotropic-drift",
        "first second along horizontal vertical",
    ),
    ("sphere-times", "against horizontal"),
    ("turntable-energy", "against horizontal"),
    ("exam", "against"),
];

#[test]
fn every_direction_in_a_caption_is_tried_on_its_numbers_or_listed() {
    let figures = all().unwrap();
    let mut failures = Vec::new();
    for (id, words, holds) in TRIED {
        let figure = figures.iter().find(|figure| figure.id == *id).unwrap();
        if !figure.caption.contains(words) && !figure.alt.contains(words) {
            failures.push(format!("{id}: it does not say {words:?}"));
        }
        if !holds(&Data::of(figure)) {
            failures.push(format!("{id}: the numbers are not so that {words:?}"));
        }
    }
    for figure in &figures {
        let tried = TRIED
            .iter()
            .filter(|row| row.0 == figure.id)
            .map(|row| row.1);
        let left = tried.fold(
            format!("{} {}", figure.caption, figure.alt),
            |text, words| text.replace(words, ""),
        );
        let left = directed(&left, SHOWN).join(" ");
        let listed = UNTRIED
            .iter()
            .find(|row| row.0 == figure.id)
            .map_or("", |row| row.1);
        if left != listed {
            failures.push(format!("(\"{}\", \"{left}\"),", figure.id));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn a_figure_of_the_paper_names_it_in_its_caption() {
    let mut named = 0;
    for figure in all().unwrap() {
        let says = figure.caption.contains("of the paper, by its caption");
        let number = figure.id.strip_prefix("fig-");
        assert_eq!(number.is_some(), says, "{}", figure.id);
        if let Some(number) = number {
            let words = format!("After figure {number} of the paper");
            assert!(figure.caption.contains(&words), "{}", figure.id);
            named += 1;
        }
    }
    assert_eq!(named, 6);
}

/// The decimals of a text.
fn decimals(text: &str) -> Vec<&str> {
    let parts = text.split(|c: char| !(c.is_ascii_digit() || c == '.'));
    let parts = parts.map(|part| part.trim_end_matches('.'));
    parts
        .filter(|part| part.contains('.') && !part.starts_with('.'))
        .collect()
}

/// Decimals of captions that are no cell of the figure's numbers, by figure, and what they are.
const OTHER_DECIMALS: &[(&str, &str, &str)] = &[
    (
        "anisotropic-census",
        "1.4",
        "the end of the census along λ₀",
    ),
    ("anisotropic-census", "0.28", "the end of an axis"),
    ("anisotropic-far", "2.0000000", "computed"),
    ("anisotropic-far", "3.1415927", "computed"),
    ("anisotropic-far", "12.5663706", "computed"),
    ("anisotropic-far", "4.6", "where C is left, to be seen"),
    ("rest-boundary", "1.4", "√2; tried as a direction"),
];

#[test]
fn every_decimal_in_a_caption_is_one_of_its_numbers_or_listed() {
    let mut failures = Vec::new();
    for figure in all().unwrap() {
        let cells: Vec<f64> = Data::of(&figure).rows().concat();
        for number in decimals(&format!("{} {}", figure.caption, figure.alt)) {
            let places = number.len() - number.find('.').unwrap() - 1;
            let known = cells
                .iter()
                .any(|cell| format!("{:.places$}", cell.abs()) == *number);
            let listed = OTHER_DECIMALS
                .iter()
                .any(|row| (row.0, row.1) == (figure.id, number));
            if known == listed {
                failures.push(format!("(\"{}\", \"{number}\", \"\"),", figure.id));
            }
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}
