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

/// What texts say, held against what is so.
#[derive(Default)]
pub struct Held {
    pub wrong: Vec<String>,
}

impl Held {
    /// Of the choices of a pattern a text has the right ones, and one at least.
    pub fn hold(
        &mut self,
        name: &str,
        text: &[Word],
        pattern: &str,
        right: impl Fn(usize) -> bool,
    ) {
        let mut said = readings(pattern);
        said.retain(|(_, reading)| says(text, reading));
        if said.is_empty() {
            self.wrong.push(gone(name, pattern));
        }
        said.retain(|(choice, _)| !right(*choice));
        let wrong = said
            .iter()
            .map(|(_, slip)| format!("{name}: it says {slip:?}"));
        self.wrong.extend(wrong);
    }

    /// Fails if something is wrong, or no longer there.
    pub fn end(&self) {
        assert!(self.wrong.is_empty(), "{}", self.wrong.join("\n"));
    }
}

/// What to do where the words of a row are gone.
pub fn gone(name: &str, pattern: &str) -> String {
    format!(
        "{name}: it no longer says {pattern:?}, which `tests/suite/prose` asks of it: put the words into that row as they are now; \
         take the row out if nothing of the kind is said any more"
    )
}

#[test]
fn the_wrong_choice_is_told_from_the_right_one() {
    let pattern = "the {less|more} friction, the {faster|slower}";
    for (text, is_first, wrong) in [
        ("So the *less* friction, the faster.", true, false),
        ("So the less friction, the slower.", true, true),
        ("So the less friction, the faster.", false, true),
        ("So with less friction it is faster.", true, true),
    ] {
        let right = |choice: usize| (choice == 0) == is_first;
        let mut held = Held::default();
        held.hold("", &words(text), pattern, right);
        assert_eq!(held.wrong.is_empty(), !wrong, "{text}");
    }
}
