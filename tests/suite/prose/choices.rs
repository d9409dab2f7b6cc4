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
    found: usize,
    all: usize,
}

impl Held {
    /// Of the choices of a pattern a text has the right ones, if it says any.
    pub fn hold(
        &mut self,
        name: &str,
        text: &[Word],
        pattern: &str,
        right: impl Fn(usize) -> bool,
    ) {
        let mut said = readings(pattern);
        said.retain(|(_, reading)| says(text, reading));
        self.all += 1;
        self.found += usize::from(!said.is_empty());
        if said.is_empty() {
            println!("{name}: it no longer says {pattern:?}");
        }
        said.retain(|(choice, _)| !right(*choice));
        let wrong = said
            .iter()
            .map(|(_, slip)| format!("{name}: it says {slip:?}"));
        self.wrong.extend(wrong);
    }

    /// Fails if something is wrong, or little is said.
    pub fn end(&self) {
        println!("{} of {} choices are still there", self.found, self.all);
        let enough = 2 * self.found > self.all;
        assert!(self.wrong.is_empty() && enough, "{}", self.wrong.join("\n"));
    }
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
        let mut held = Held::default();
        held.hold("", &words(text), pattern, right);
        assert_eq!(held.wrong.is_empty(), !wrong, "{text}");
    }
}
