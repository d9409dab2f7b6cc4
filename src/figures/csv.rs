//! The numbers behind a figure, as comma-separated values (RFC 4180, lines ended by `\n`).

use super::FigureError;

/// One entry of a table.
#[derive(Debug, Clone, PartialEq)]
pub enum Cell {
    /// A number, written with 12 significant digits; one that is not finite is left empty.
    Number(f64),
    /// A whole number, written in full.
    Whole(u64),
    /// Words.
    Text(String),
}

impl From<f64> for Cell {
    fn from(value: f64) -> Self {
        Cell::Number(value)
    }
}

impl From<&f64> for Cell {
    fn from(value: &f64) -> Self {
        Cell::Number(*value)
    }
}

impl From<u64> for Cell {
    fn from(value: u64) -> Self {
        Cell::Whole(value)
    }
}

impl From<&str> for Cell {
    fn from(value: &str) -> Self {
        Cell::Text(value.into())
    }
}

/// A table in the making: one column per quantity, one row per point.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    columns: usize,
    text: String,
}

impl Table {
    /// An empty table; each header names a quantity and its unit: `"t (s)"`, `"v_x (v_0)"`. A
    /// quantity without a unit in brackets is dimensionless.
    pub fn new(headers: &[&str]) -> Self {
        let mut table = Table {
            columns: headers.len(),
            text: String::new(),
        };
        table.line(headers.iter().map(|header| quoted(header)));
        table
    }

    /// Adds a row. [`FigureError::Row`] if it has not one cell per column.
    pub fn row(&mut self, cells: impl IntoIterator<Item = Cell>) -> Result<(), FigureError> {
        let cells: Vec<Cell> = cells.into_iter().collect();
        if cells.len() != self.columns {
            return Err(FigureError::Row {
                expected: self.columns,
                found: cells.len(),
            });
        }
        self.line(cells.iter().map(|cell| match cell {
            Cell::Number(value) => twelve_digits(*value),
            Cell::Whole(value) => value.to_string(),
            Cell::Text(words) => quoted(words),
        }));
        Ok(())
    }

    /// The whole table as text.
    pub fn into_text(self) -> String {
        self.text
    }

    fn line(&mut self, cells: impl Iterator<Item = String>) {
        self.text.push_str(&cells.collect::<Vec<_>>().join(","));
        self.text.push('\n');
    }
}

fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.into()
    }
}

/// `value` rounded to 12 significant digits, without superfluous zeros; empty if not finite.
fn twelve_digits(value: f64) -> String {
    if !value.is_finite() {
        return String::new();
    }
    if value == 0.0 {
        return "0".into();
    }
    let scientific = format!("{value:.11e}");
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let mantissa = mantissa.trim_end_matches('0').trim_end_matches('.');
    let exponent: i32 = exponent.parse().unwrap_or(0);
    if !(-5..12).contains(&exponent) {
        return format!("{mantissa}e{exponent}");
    }
    let (sign, digits) = match mantissa.strip_prefix('-') {
        Some(rest) => ("-", rest.replace('.', "")),
        None => ("", mantissa.replace('.', "")),
    };
    if exponent < 0 {
        let zeros = "0".repeat((-exponent - 1) as usize);
        return format!("{sign}0.{zeros}{digits}");
    }
    let whole = exponent as usize + 1;
    if digits.len() <= whole {
        format!("{sign}{digits}{}", "0".repeat(whole - digits.len()))
    } else {
        format!("{sign}{}.{}", &digits[..whole], &digits[whole..])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn numbers_are_written_plainly() {
        for (value, text) in [
            (0.0, "0"),
            (-0.0, "0"),
            (1.0, "1"),
            (-1.5, "-1.5"),
            (0.1 + 0.2, "0.3"),
            (std::f64::consts::PI, "3.14159265359"),
            (-0.000_123, "-0.000123"),
            (1.0e-300, "1e-300"),
            (-2.5e20, "-2.5e20"),
            (123_456_789_012.0, "123456789012"),
            (1_200.0, "1200"),
            (999_999_999_999.9, "1e12"),
            (f64::NAN, ""),
            (f64::INFINITY, ""),
        ] {
            assert_eq!(twelve_digits(value), text, "{value:e}");
        }
    }

    proptest! {
        #[test]
        fn a_number_survives_to_twelve_digits(value in proptest::num::f64::NORMAL) {
            let back: f64 = twelve_digits(value).parse().unwrap();
            prop_assume!(back.is_finite());
            prop_assert!((back - value).abs() <= 5.1e-12 * value.abs());
        }
    }

    #[test]
    fn words_with_commas_and_quotes_are_quoted() {
        let mut table = Table::new(&["state", "t (s)"]);
        table
            .row(["slides, \"then\" rests".into(), 0.5.into()])
            .unwrap();
        assert_eq!(
            table.into_text(),
            "state,t (s)\n\"slides, \"\"then\"\" rests\",0.5\n"
        );
    }

    #[test]
    fn a_row_must_fill_the_columns() {
        let mut table = Table::new(&["x", "y"]);
        let error = FigureError::Row {
            expected: 2,
            found: 1,
        };
        assert_eq!(table.row([1.0.into()]), Err(error));
    }
}
