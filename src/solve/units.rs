//! Units: each number of an answer carries the name of its own, in the quantities of the paper or in SI.

use super::{Curve, Double, Field, Value};

/// The unit of a ratio or a share.
pub const DIMENSIONLESS: &str = "dimensionless";

/// The unit of angles and phases.
pub const RADIANS: &str = "rad";

/// A unit of the paper, and what it comes to in SI.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Unit {
    /// Its name, as the [fields](Field::unit) have it.
    paper: &'static str,
    /// How many it is of
    size: Double,
    /// this unit of SI.
    si: &'static str,
}

impl Unit {
    /// What a unit of the paper comes to in SI.
    pub fn new(paper: &'static str, size: Double, si: &'static str) -> Self {
        Self { paper, size, si }
    }

    /// So many of its SI unit as this is in the paper's. One rounding more.
    fn converted(&self, x: f64) -> f64 {
        (Double::from(x) * self.size).into()
    }

    /// That of the name, if it is among these.
    fn named<'a>(name: &str, units: &'a [Self]) -> Option<&'a Self> {
        units.iter().find(|unit| unit.paper == name)
    }

    /// The name in SI of a unit that is among these; else the name itself.
    pub fn name(paper: &'static str, units: &[Self]) -> &'static str {
        Self::named(paper, units).map_or(paper, |unit| unit.si)
    }
}

impl Field {
    /// The same in SI, if its unit is among these.
    pub(super) fn in_si(self, units: &[Unit]) -> Self {
        let Some(unit) = Unit::named(self.unit, units) else {
            return self;
        };
        let of = |x| unit.converted(x);
        Field {
            value: match self.value {
                Value::Number(x) => Value::from(of(x)),
                other => other,
            },
            unit: unit.si,
            scale: of(self.scale),
            lost: of(self.lost),
            unseen: of(self.unseen),
            ..self
        }
    }

    /// Its name with its unit, if it is no word, as the head of a column.
    pub fn head(&self) -> String {
        match self.unit {
            "" => self.name.to_owned(),
            unit => head(self.name, unit),
        }
    }
}

impl Curve {
    /// The same in SI, each axis if its unit is among these.
    pub fn in_si(mut self, units: &[Unit]) -> Self {
        for axis in [0, 1] {
            let Some(unit) = Unit::named(self.units[axis], units) else {
                continue;
            };
            self.units[axis] = unit.si;
            for point in &mut self.points {
                point[axis] = unit.converted(point[axis]);
            }
        }
        self
    }

    /// Names and units of the two axes.
    pub fn labels(&self) -> [String; 2] {
        let [x, y] = self.units;
        [head(self.x, x), head(self.y, y)]
    }
}

/// A name with its unit.
pub fn head(name: &str, unit: &str) -> String {
    format!("{name} ({unit})")
}
