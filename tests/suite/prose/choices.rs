//! Words of which one out of several is right: `the angle {falls|rises} towards zero`.

use super::text::{Word, stands, words};

/// How a pattern reads with each of its choices: the number of the choice, if there is only one; with several, 0 for the first of each.
fn readings(pattern: &str) -> Vec<(usize, String)> {
    let Some((before, rest)) = pattern.split_once('{') else {
        return vec![(0, pattern.to_owned())];
    };
    let (choices, after) = rest.split_once('}').expect("a closed brace");
    let choices = choices.split('|').enumerate();
    let read = |(i, choice): (usize, &str)| {
        let after = readings(after).into_iter();
        after
            .map(move |(other, after)| (i + other, format!("{before}{choice}{after}")))
            .collect::<Vec<_>>()
    };
    choices.flat_map(read).collect()
}

fn says(text: &[Word], reading: &str) -> bool {
    let reading = words(reading);
    (0..text.len()).any(|at| stands(&text[at..], &reading))
}

/// Whether a text has a pattern with any of its choices.
pub fn has(text: &[Word], pattern: &str) -> bool {
    readings(pattern)
        .iter()
        .any(|(_, reading)| says(text, reading))
}

/// What a text says that is not right.
pub fn failures(text: &[Word], pattern: &str, right: impl Fn(usize) -> bool) -> Vec<String> {
    let wrong = readings(pattern)
        .into_iter()
        .filter(|(choice, reading)| !right(*choice) && says(text, reading));
    wrong.map(|(_, reading)| reading).collect()
}

#[test]
fn the_wrong_choice_is_told_from_the_right_one() {
    let pattern = "the {less|more} friction, the {faster|slower}";
    for (text, is_first, wrong) in [
        ("So the *less* friction, the faster.", true, false),
        ("So the less friction, the slower.", true, true),
        ("So the less friction, the faster.", false, true),
        ("So with less friction it is faster.", true, false),
    ] {
        let right = |choice: usize| (choice == 0) == is_first;
        assert_eq!(
            !failures(&words(text), pattern, right).is_empty(),
            wrong,
            "{text}"
        );
    }
}
