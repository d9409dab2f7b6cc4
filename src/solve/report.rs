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

struct Object<'a>(&'a [Field]);

impl Serialize for Object<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_map(self.0.iter().map(|field| (field.name, field.value)))
    }
}

struct Units<'a>(&'a [Field]);

impl Serialize for Units<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let numbers = self.0.iter().filter(|field| !field.unit.is_empty());
        serializer.collect_map(numbers.map(|field| (field.name, field.unit)))
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
        map.serialize_entry("units", &Units(&self.fields))?;
        map.serialize_entry("by_formula", &self.by_formula.as_deref().map(Object))?;
        map.serialize_entry("by_motion", &self.by_motion.as_deref().map(Object))?;
        map.serialize_entry("disagreement", &self.disagreement)?;
        map.serialize_entry("digits", &self.digits)?;
        map.serialize_entry("note", &self.note)?;
        map.end()
    }
}

impl<T: Fields> Answer<T> {
    /// The answer without its type, for output: no number has more digits than are known.
    pub fn report(&self, problem: &'static str) -> Report {
        let rounded = |fields: Vec<Field>| -> Vec<Field> {
            let Some(digits) = self.digits else {
                return fields;
            };
            let fields = fields.into_iter();
            fields.map(|field| field.rounded(digits)).collect()
        };
        let best = self.best.fields();
        // Of a formula that is not the best way, what both have in common.
        let alike = |(formula, best): (Field, &Field)| {
            let most = self.digits.unwrap_or(0);
            let to = |n: &u32| formula.rounded(*n).value == best.rounded(*n).value;
            let n = (0..=most).rev().find(to);
            n.map_or(formula, |n| formula.rounded(n))
        };
        Report {
            problem,
            by_formula: self.by_formula.as_ref().map(|way| {
                let pairs = way.fields().into_iter().zip(&best);
                pairs.map(alike).collect()
            }),
            by_motion: self.by_motion.as_ref().map(|way| rounded(way.fields())),
            fields: rounded(best),
            disagreement: self.disagreement,
            digits: self.digits,
            note: self.note.clone(),
        }
    }
}
