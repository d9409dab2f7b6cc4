//! The numbers behind a figure, as comma-separated values (RFC 4180, lines ended by `\n`).

use super::FigureError;

/// What a row of a table is made of: a number (12 significant digits, empty if not finite), a whole number,
/// words; or several of these.
pub trait Cells {
    /// Adds them to a row, each as it is written.
    fn add_to(&self, row: &mut Vec<String>);
}

impl Cells for f64 {
    fn add_to(&self, row: &mut Vec<String>) {
        row.push(number(*self));
    }
}

impl Cells for u64 {
    fn add_to(&self, row: &mut Vec<String>) {
        row.push(self.to_string());
    }
}

impl Cells for str {
    fn add_to(&self, row: &mut Vec<String>) {
        row.push(self.to_owned());
    }
}

impl Cells for String {
    fn add_to(&self, row: &mut Vec<String>) {
        self.as_str().add_to(row);
    }
}

impl<T: Cells + ?Sized> Cells for &T {
    fn add_to(&self, row: &mut Vec<String>) {
        (**self).add_to(row);
    }
}

impl<T: Cells> Cells for [T] {
    fn add_to(&self, row: &mut Vec<String>) {
        self.iter().for_each(|cells| cells.add_to(row));
    }
}

impl<T: Cells> Cells for Vec<T> {
    fn add_to(&self, row: &mut Vec<String>) {
        self.as_slice().add_to(row);
    }
}

impl<T: Cells, const N: usize> Cells for [T; N] {
    fn add_to(&self, row: &mut Vec<String>) {
        self.as_slice().add_to(row);
    }
}

macro_rules! tuples {
    ($(($($part:ident)*))*) => {$(
        impl<$($part: Cells),*> Cells for ($($part,)*) {
            #[allow(non_snake_case, unused_variables)]
            fn add_to(&self, row: &mut Vec<String>) {
                let ($($part,)*) = self;
                $($part.add_to(row);)*
            }
        }
    )*};
}

tuples! { () (A B) (A B C) (A B C D) }

/// A table in the making: one column per quantity, one row per point.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    columns: usize,
    cells: Vec<Vec<String>>,
}

impl Table {
    /// An empty table; each header names a quantity and its unit, if it has one: `"t (s)"`, `"v_x (v_0)"`.
    pub fn new(headers: &[&str]) -> Self {
        Table {
            columns: headers.len(),
            cells: vec![headers.iter().map(|header| (*header).to_owned()).collect()],
        }
    }

    /// Adds a row. [`FigureError::Row`] if it has not one cell per column.
    pub fn row(&mut self, row: impl Cells) -> Result<(), FigureError> {
        let mut cells = Vec::with_capacity(self.columns);
        row.add_to(&mut cells);
        if cells.len() != self.columns {
            return Err(FigureError::Row {
                expected: self.columns,
                found: cells.len(),
            });
        }
        self.cells.push(cells);
        Ok(())
    }

    /// Adds rows that all begin with `head`, each as [`row`](Self::row) does.
    pub fn rows(
        &mut self,
        head: impl Cells,
        rows: impl IntoIterator<Item: Cells>,
    ) -> Result<(), FigureError> {
        rows.into_iter().try_for_each(|row| self.row((&head, row)))
    }

    /// The cells of the rows, as they are written.
    pub fn cells(&self) -> &[Vec<String>] {
        &self.cells[1..]
    }

    /// The rows as numbers, NaN for words.
    pub fn numbers(&self) -> Vec<Vec<f64>> {
        let number = |cell: &String| cell.parse().unwrap_or(f64::NAN);
        let rows = self.cells().iter();
        rows.map(|row| row.iter().map(number).collect()).collect()
    }

    /// The same, by what stands in the first column, in order.
    pub fn groups(&self) -> Vec<Vec<Vec<f64>>> {
        let mut groups: Vec<(&str, Vec<Vec<f64>>)> = Vec::new();
        for (cells, row) in self.cells().iter().zip(self.numbers()) {
            let name = cells.first().map_or("", String::as_str);
            match groups.iter_mut().find(|(known, _)| *known == name) {
                Some((_, rows)) => rows.push(row),
                None => groups.push((name, vec![row])),
            }
        }
        groups.sort_by(|one, other| one.1[0][0].total_cmp(&other.1[0][0]));
        groups.into_iter().map(|(_, rows)| rows).collect()
    }

    /// The whole table as text.
    pub fn into_text(self) -> String {
        let line = |row: &Vec<String>| {
            let cells: Vec<_> = row.iter().map(|cell| quoted(cell)).collect();
            cells.join(",") + "\n"
        };
        self.cells.iter().map(line).collect()
    }
}

fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.into()
    }
}

/// To 12 significant digits, without superfluous zeros; nothing if it is not finite.
fn number(value: f64) -> String {
    let mut out = String::new();
    if !value.is_finite() {
        return out;
    }
    if value == 0.0 {
        return "0".into();
    }
    if value < 0.0 {
        out.push('-');
    }
    let scientific = format!("{:.11e}", value.abs());
    let (mantissa, exponent) = scientific.split_once('e').unwrap_or((&scientific, "0"));
    let mantissa = mantissa.trim_end_matches('0').trim_end_matches('.');
    let exponent: i32 = exponent.parse().unwrap_or(0);
    let (first, rest) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let zeros = |count: usize| std::iter::repeat_n('0', count);
    match exponent {
        0 => out.push_str(mantissa),
        -5..0 => {
            out += "0.";
            out.extend(zeros(exponent.unsigned_abs() as usize - 1));
            out.extend([first, rest]);
        }
        1..12 => {
            let whole = exponent as usize;
            out += first;
            match rest.split_at_checked(whole) {
                Some((whole, "")) => out.push_str(whole),
                Some((whole, part)) => out.extend([whole, ".", part]),
                None => {
                    out += rest;
                    out.extend(zeros(whole - rest.len()));
                }
            }
        }
        _ => out.push_str(&format!("{mantissa}e{exponent}")),
    }
    out
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
            assert_eq!(number(value), text, "{value:e}");
        }
    }

    proptest! {
        #[test]
        fn a_number_survives_to_twelve_digits(value in proptest::num::f64::NORMAL) {
            let back: f64 = number(value).parse().unwrap();
            prop_assume!(back.is_finite());
            prop_assert!((back - value).abs() <= 5.1e-12 * value.abs());
        }
    }

    #[test]
    fn words_with_commas_and_quotes_are_quoted() {
        let mut table = Table::new(&["state", "t (s)"]);
        table.row(("slides, \"then\" rests", 0.5)).unwrap();
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
        assert_eq!(table.row(1.0), Err(error));
    }
}
