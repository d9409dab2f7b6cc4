//! Numbers with units, as people type them: `15cm`, `33.3rpm`, `36km/h`, `120deg`, `1g`, `2.15m/s^2`.

use super::SceneError;
use crate::numerics::{
    error::plain,
    expression::{ExpressionError, expression},
};
use std::{fmt, str::FromStr};

/// Of metre, second and kilogram.
type Dimension = [i8; 3];

/// With size in SI. Angles and turns have no dimension.
const UNITS: [(&str, f64, Dimension); 31] = [
    ("m", 1.0, [1, 0, 0]),
    ("km", 1e3, [1, 0, 0]),
    ("dm", 0.1, [1, 0, 0]),
    ("cm", 0.01, [1, 0, 0]),
    ("mm", 1e-3, [1, 0, 0]),
    ("um", 1e-6, [1, 0, 0]),
    ("µm", 1e-6, [1, 0, 0]),
    ("in", 0.0254, [1, 0, 0]),
    ("ft", 0.3048, [1, 0, 0]),
    ("mi", 1609.344, [1, 0, 0]),
    ("s", 1.0, [0, 1, 0]),
    ("ms", 1e-3, [0, 1, 0]),
    ("us", 1e-6, [0, 1, 0]),
    ("µs", 1e-6, [0, 1, 0]),
    ("min", 60.0, [0, 1, 0]),
    ("h", 3600.0, [0, 1, 0]),
    ("mph", 0.447_04, [1, -1, 0]),
    ("knots", 1852.0 / 3600.0, [1, -1, 0]),
    ("g", 9.80665, [1, -2, 0]),
    ("mg", 9.80665e-3, [1, -2, 0]),
    ("gal", 0.01, [1, -2, 0]),
    ("J", 1.0, [2, -2, 1]),
    ("kg", 1.0, [0, 0, 1]),
    ("rad", 1.0, [0, 0, 0]),
    ("deg", std::f64::consts::PI / 180.0, [0, 0, 0]),
    ("°", std::f64::consts::PI / 180.0, [0, 0, 0]),
    ("turn", std::f64::consts::TAU, [0, 0, 0]),
    ("rev", std::f64::consts::TAU, [0, 0, 0]),
    ("rpm", std::f64::consts::TAU / 60.0, [0, -1, 0]),
    ("Hz", std::f64::consts::TAU, [0, -1, 0]),
    ("1", 1.0, [0, 0, 0]),
];

/// Such as `km/h`, `m/s^2`, `m/s2`, `1/s`; its size and dimension.
fn unit(text: &str) -> Option<(f64, Dimension)> {
    let (mut size, mut dimension) = (1.0, [0; 3]);
    let mut side = 1;
    let text = text.replace("²", "2").replace(['·', ' '], "*");
    for part in text.split_inclusive(['/', '*']) {
        let name = part.trim_end_matches(['/', '*']);
        let bare = name.trim_end_matches(['2', '^']);
        let power = side * if bare.len() < name.len() { 2 } else { 1 };
        if !name.is_empty() {
            let (_, one, own) = UNITS.iter().find(|(known, ..)| *known == bare)?;
            size *= one.powi(power);
            for (sum, own) in dimension.iter_mut().zip(own) {
                *sum += own * i8::try_from(power).ok()?;
            }
        }
        side = if part.ends_with('/') { -1 } else { 1 };
    }
    Some((size, dimension))
}

/// `si` has the dimension; a plain number is in SI. Its value and the unit's size; `value` reads a number, and `what` says what
/// it is to be.
pub(super) fn read<T>(
    what: &'static str,
    si: &'static str,
    text: &str,
    value: impl Fn(&str) -> Result<T, ExpressionError>,
) -> Result<(T, f64), SceneError> {
    let text = text.trim();
    let (_, wanted) = unit(si).unwrap_or_default();
    let wrong = |why: String| SceneError::Quantity {
        what,
        text: text.to_owned(),
        why: format!("{why}; a plain number is in {si}"),
    };
    let plainly = match value(text) {
        Ok(value) => return Ok((value, 1.0)),
        Err(error) => error.to_string(),
    };
    // The longest number, so that `1/2 m` is half a metre.
    let ends: Vec<_> = text.char_indices().map(|(at, _)| at).skip(1).collect();
    let mut found = ends.into_iter().rev().filter_map(|end| {
        let (number, name) = text.split_at(end);
        Some((value(number.trim()).ok()?, unit(name.trim())?))
    });
    match found.next() {
        Some((value, (size, own))) if own == wanted => Ok((value, size)),
        Some(_) => Err(wrong("its unit measures something else".to_owned())),
        None => match apart(text).1.trim() {
            "N" | "kg" => Err(wrong(
                "the mass drops out: a force is asked for by each kilogram".to_owned(),
            )),
            name if name.contains('(') => Err(wrong(format!(
                "{plainly}; a unit stands behind the whole, as in 4*sin(t) m/s^2"
            ))),
            name if name.starts_with(char::is_alphabetic) => {
                Err(wrong(format!("`{name}` is no unit that is known")))
            }
            _ => Err(wrong(plainly)),
        },
    }
}

/// A text as a number and the unit behind it, without a look at either where there is no number.
pub fn apart(text: &str) -> (&str, &str) {
    let number = |text: &str| expression::<f64>(text.trim(), |digits| digits.parse().ok()).is_ok();
    let ends = text.char_indices().map(|(at, _)| at);
    let ends: Vec<_> = ends.chain([text.len()]).collect();
    let end = ends.into_iter().rev().find(|end| number(&text[..*end]));
    text.split_at(end.unwrap_or(0))
}

macro_rules! quantities {
    ($($(#[$doc:meta])* $name:ident, $what:literal, $si:literal;)*) => {$(
        $(#[$doc])*
        #[derive(Debug, Clone, Copy, Default, PartialEq, PartialOrd)]
        pub struct $name(pub f64);

        impl $name {
            /// The name of its unit.
            pub const UNIT: &'static str = $si;
        }

        impl FromStr for $name {
            type Err = SceneError;

            fn from_str(text: &str) -> Result<Self, SceneError> {
                let number = |text: &str| expression(text, |digits| digits.parse().ok());
                let (number, size) = read::<f64>($what, $si, text, number)?;
                Ok(Self(number * size))
            }
        }

        impl fmt::Display for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, "{} {}", plain(self.0), $si)
            }
        }
    )*};
}

quantities! {
    /// A length in m.
    Metre, "a length", "m";
    /// A time in s.
    Second, "a time", "s";
    /// A velocity in m/s.
    MetrePerSecond, "a speed", "m/s";
    /// An acceleration in m/s².
    MetrePerSecond2, "an acceleration", "m/s^2";
    /// An angular velocity in rad/s.
    RadianPerSecond, "an angular velocity", "rad/s";
    /// An angle in rad, counterclockwise.
    Radian, "an angle", "rad";
    /// An energy on each kilogram, in J/kg.
    JoulePerKilogram, "a heat on each kilogram", "J/kg";
}
