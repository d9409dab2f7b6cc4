//! Units: each number of an answer carries the name of its own, in the quantities of the paper.

use super::{Curve, Field};

/// The unit of a ratio or a share.
pub const DIMENSIONLESS: &str = "dimensionless";

/// The unit of angles and phases.
pub const RADIANS: &str = "rad";

impl Field {
    /// Its name with its unit, if it is no word, as the head of a column.
    pub fn head(&self) -> String {
        match self.unit {
            "" => self.name.to_owned(),
            unit => head(self.name, unit),
        }
    }
}

impl Curve {
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
