//! What a trial compares with what, and where, in words.

use serde::{Serialize, Serializer};
use std::fmt::{self, Display};

/// The two sides of a comparison, in words; formulas as LaTeX in `$…$`.
///
/// ```
/// use trialbook::evidence::Compared;
///
/// let time = Compared::one("$T$", "the time at which the motion stops").over(r"$\lambda$ near 1");
/// assert_eq!(time.words(), "$T$ was compared with the time at which the motion stops");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Compared {
    /// A comma at its end parts what was added to it from the verb. Without a found side, all that is to be
    /// proved.
    stated: Words,
    found: Option<Words>,
    form: Form,
    over: Option<Words>,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
struct Words([&'static str; 3]);

impl Words {
    const fn of(words: &'static str) -> Self {
        Words([words, "", ""])
    }

    fn without_comma(&self) -> String {
        self.to_string().trim_end_matches(',').to_owned()
    }
}

impl Display for Words {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|part| f.write_str(part))
    }
}

impl Serialize for Words {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
enum Form {
    One,
    Many,
    /// A number that says little by itself: the sentence begins with what is found.
    Constant,
}

impl From<[&'static str; 2]> for Compared {
    fn from([stated, found]: [&'static str; 2]) -> Self {
        Compared::one(stated, found)
    }
}

impl Compared {
    /// One thing that is stated, and what is found.
    pub const fn one(stated: &'static str, found: &'static str) -> Self {
        Self::composed([stated, "", ""], [found, "", ""])
    }

    /// The same from parts, one a row's own, the others its table's.
    ///
    /// ```
    /// use trialbook::evidence::Compared;
    ///
    /// let change = |rate, of| Compared::composed(["the integral of ", rate, ""], ["the change of ", of, ""]);
    /// assert_eq!(change("(3)", "$p$").words(), "the integral of (3) was compared with the change of $p$");
    /// ```
    pub const fn composed(stated: [&'static str; 3], found: [&'static str; 3]) -> Self {
        Compared {
            stated: Words(stated),
            found: Some(Words(found)),
            form: Form::One,
            over: None,
        }
    }

    /// Several things that are stated, and what is found.
    pub const fn many(stated: &'static str, found: &'static str) -> Self {
        let one = Self::one(stated, found);
        let form = Form::Many;
        Compared { form, ..one }
    }

    /// A number that is stated or expected, with what it means, and what is found; a comma at its end parts
    /// it from the verb.
    ///
    /// ```
    /// use trialbook::evidence::Compared;
    ///
    /// let kept = Compared::constant("the expected 1", "whether the coin stays (1 if so)");
    /// assert_eq!(kept.words(), "whether the coin stays (1 if so) was compared with the expected 1");
    /// ```
    pub const fn constant(stated: &'static str, found: &'static str) -> Self {
        let (one, form) = (Self::one(stated, found), Form::Constant);
        Compared { form, ..one }
    }

    /// What a proof without two sides shows, as a clause.
    pub const fn shown(clause: &'static str) -> Self {
        let one = Self::one(clause, "");
        Compared { found: None, ..one }
    }

    /// The same, at these points; the words stand behind their number.
    pub const fn over(self, points: &'static str) -> Self {
        let over = Some(Words::of(points));
        Compared { over, ..self }
    }

    /// The same, at these points, in words from parts.
    pub const fn over_composed(self, points: [&'static str; 3]) -> Self {
        let over = Some(Words(points));
        Compared { over, ..self }
    }

    /// What is stated; formulas in `$…$`.
    pub fn stated(&self) -> String {
        self.stated.without_comma()
    }

    /// What is found; nothing for a proof without two sides.
    pub fn found(&self) -> Option<String> {
        self.found.map(|found| found.without_comma())
    }

    /// Where, if the trial says so; formulas in `$…$`.
    pub fn points(&self) -> Option<String> {
        self.over.map(|words| words.to_string())
    }

    /// What was compared, as a clause; formulas in `$…$`.
    pub fn words(&self) -> String {
        let Some(found) = self.found else {
            return self.stated.to_string();
        };
        match self.form {
            Form::One => format!("{} was compared with {found}", self.stated),
            Form::Many => format!("{} were compared with {found}", self.stated),
            Form::Constant => format!("{found} was compared with {}", self.stated),
        }
    }
}
