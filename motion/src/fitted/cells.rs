//! What a cell of a recording says: a number or a unit; and which columns are meant.

use super::{FitError, LARGEST};

/// Columns for [`Fitted::from_csv_with`](super::Fitted::from_csv_with), where the head does not say them.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Columns<'a> {
    /// Of the times: its head, with or without the unit, or its number from 1.
    pub time: Option<&'a str>,
    /// That of A_x. If this or that of A_y is given, the other is zero where it is not.
    pub x: Option<&'a str>,
    /// That of A_y.
    pub y: Option<&'a str>,
    /// That of A_z, which only a [`Recording`] has.
    pub z: Option<&'a str>,
    /// In place of the head's: s, ms, us, ns, min or h.
    pub time_unit: Option<&'a str>,
    /// In place of the head's: m/s^2, mm/s^2, cm/s^2, km/s^2, ft/s^2, in/s^2, g or mg.
    pub unit: Option<&'a str>,
    /// Steps of more than eight times the usual one are bridged.
    pub gaps: bool,
}

pub(super) fn refuse(line: usize, text: &str, why: &'static str) -> FitError {
    FitError::Line {
        line,
        text: text.chars().take(100).collect(),
        why,
    }
}

pub(super) const EMPTY: &str = "a cell is empty or no finite number";

pub(super) fn parsed(cell: &str) -> Option<f64> {
    cell.replace(',', ".").replace('−', "-").parse().ok()
}

pub(super) fn read(
    cell: &str,
    separator: char,
    sign: &mut Option<char>,
) -> Result<f64, &'static str> {
    for c in cell.chars().filter(|c| matches!(c, '.' | ',')) {
        if c == separator || *sign.get_or_insert(c) != c {
            return Err("its decimal sign is not the only one");
        }
    }
    let number = parsed(cell).filter(|x| x.abs() <= LARGEST);
    number.ok_or(EMPTY)
}

/// Without what can be written in several ways.
pub(super) fn plain(unit: &str) -> String {
    let mut unit = unit.to_lowercase();
    unit.retain(|c| !c.is_whitespace() && !"^*.()[]{}·⋅".contains(c));
    for (long, short) in [
        ("metres", "m"),
        ("meters", "m"),
        ("metre", "m"),
        ("meter", "m"),
        ("per", "/"),
        ("squared", "2"),
        ("seconds", "s"),
        ("second", "s"),
        ("secs", "s"),
        ("sec", "s"),
        ("²", "2"),
        ("⁻", "-"),
        ("−", "-"),
        ("µ", "u"),
        ("μ", "u"),
    ] {
        unit = unit.replace(long, short);
    }
    unit
}

pub(super) fn seconds(unit: &str) -> Option<f64> {
    Some(match unit {
        "s" => 1.0,
        "ms" | "millis" => 1e-3,
        "us" | "micros" => 1e-6,
        "ns" | "nanos" => 1e-9,
        "min" | "minutes" => 60.0,
        "h" | "hours" => 3600.0,
        _ => return None,
    })
}

pub(super) fn of_acceleration(unit: &str) -> Option<f64> {
    if matches!(unit, "g" | "gn" | "g0" | "mg") {
        return Some(if unit == "mg" { 1e-3 * G } else { G });
    }
    let lengths = [
        ("m", 1.0),
        ("mm", 1e-3),
        ("cm", 1e-2),
        ("km", 1e3),
        ("ft", 0.3048),
        ("in", 0.0254),
    ];
    lengths.iter().find_map(|(length, size)| {
        let rest = unit.strip_prefix(length)?;
        matches!(rest, "/s2" | "/s/s" | "/ss" | "s-2" | "s2" | "ps2").then_some(*size)
    })
}

/// In m/s².
pub(crate) const G: f64 = 9.806_65;
