//! An answer of any topic, as it is written.

use super::{Answer, Field, Fields, Value};
use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

/// The version of the form in which answers are written.
pub const VERSION: u32 = 1;

/// An answer of any topic, as it is written as JSON: the fields at the top level, then the two ways.
#[derive(Debug, Clone, PartialEq)]
pub struct Report {
    /// The problem's name.
    pub problem: &'static str,
    /// The quantities, each to as many digits as are known.
    pub fields: Vec<Field>,
    /// See [`Answer::by_formula`].
    pub by_formula: Option<Vec<Field>>,
    /// See [`Answer::by_motion`].
    pub by_motion: Option<Vec<Field>>,
    /// See [`Answer::disagreement`].
    pub disagreement: Option<f64>,
    /// See [`Answer::digits`].
    pub digits: Option<u32>,
    /// See [`Answer::note`].
    pub note: String,
}

impl Serialize for Value {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        match self {
            Value::Number(x) => serializer.serialize_f64(*x),
            Value::Word(word) => serializer.serialize_str(word),
            Value::Missing => serializer.serialize_none(),
        }
    }
}

/// Fields as an object.
struct Object<'a>(&'a [Field]);

impl Serialize for Object<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|field| (field.name, field.value)))
    }
}

impl Serialize for Report {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(None)?;
        map.serialize_entry("version", &VERSION)?;
        map.serialize_entry("problem", self.problem)?;
        for field in &self.fields {
            map.serialize_entry(field.name, &field.value)?;
        }
        map.serialize_entry("by_formula", &self.by_formula.as_deref().map(Object))?;
        map.serialize_entry("by_motion", &self.by_motion.as_deref().map(Object))?;
        map.serialize_entry("disagreement", &self.disagreement)?;
        map.serialize_entry("digits", &self.digits)?;
        map.serialize_entry("note", &self.note)?;
        map.end()
    }
}

/// What a way has found, to so many digits.
fn rounded<T: Fields>(way: &T, digits: Option<u32>) -> Vec<Field> {
    let fields = way.fields().into_iter();
    let rounded = fields.map(|field| match digits {
        Some(digits) => field.rounded(digits),
        None => field,
    });
    rounded.collect()
}

impl<T: Fields> Answer<T> {
    /// To how many digits the formula is written: to as many as are known, but where the motion denies it to those that
    /// the two have in common, and to one at least.
    fn of_formula(&self) -> Option<u32> {
        let digits = self.digits?;
        let denied = self.disagreement > Some(10.0 * libm::exp10(-f64::from(digits)));
        let ways = self.by_formula.as_ref().zip(self.by_motion.as_ref());
        let Some((formula, motion)) = ways.filter(|_| denied) else {
            return Some(digits);
        };
        let values = |way: &T, n: u32| -> Vec<_> {
            let fields = rounded(way, Some(n)).into_iter();
            fields.map(|field| field.value).collect()
        };
        let alike = |n: &u32| values(formula, *n) == values(motion, *n);
        Some((1..=digits).rev().find(alike).unwrap_or(digits.min(1)))
    }

    /// The answer without its type, for output: no number has more digits than are known.
    pub fn report(&self, problem: &'static str) -> Report {
        Report {
            problem,
            fields: rounded(&self.best, self.digits),
            by_formula: self
                .by_formula
                .as_ref()
                .map(|way| rounded(way, self.of_formula())),
            by_motion: self.by_motion.as_ref().map(|way| rounded(way, self.digits)),
            disagreement: self.disagreement,
            digits: self.digits,
            note: self.note.clone(),
        }
    }
}
