//! Columns of numbers: recordings, and arrays that go out.

use crate::wrong;
use pyo3::{buffer::PyBuffer, prelude::*};
use slipbook::{
    motion::{Columns, Recording},
    scene,
};
use std::{fs, io, path::PathBuf};

/// Numbers; those of an array of float64 are copied in one piece. (PyO3 takes the other order of bytes for its own.)
pub fn numbers(given: &Bound<'_, PyAny>) -> PyResult<Vec<f64>> {
    match PyBuffer::get(given) {
        Ok(array) if array.dimensions() == 1 && array.format() == c"d" => array.to_vec(given.py()),
        _ => given.extract(),
    }
}

pub fn array(py: Python<'_>, numbers: impl Iterator<Item = f64>) -> PyResult<Bound<'_, PyAny>> {
    let numbers: Vec<_> = numbers.collect();
    let array = py.import("array")?.call_method1("array", ("d", [0.0]))?;
    let array = array.mul(numbers.len())?;
    // An empty one lies nowhere.
    if !numbers.is_empty() {
        PyBuffer::get(&array)?.copy_from_slice(py, &numbers)?;
    }
    Ok(array)
}

/// A file's text, with the columns that count, or numbers.
pub enum Record<'a> {
    Text(String, Columns<'a>),
    Rows(Recording),
}

pub fn record<'a>(given: &Bound<'_, PyAny>, columns: Option<&'a str>) -> PyResult<Record<'a>> {
    let asked = columns.map_or(Ok(Columns::default()), scene::columns);
    let asked = asked.map_err(wrong)?;
    if let Ok(file) = given.extract::<PathBuf>() {
        let text = fs::read(&file).map_err(|error| {
            let why = format!("cannot read `{}`: {error}", file.display());
            io::Error::new(error.kind(), why)
        })?;
        return Ok(Record::Text(Recording::decoded(text), asked));
    }
    let all = given.extract::<Vec<_>>()?;
    let all: Vec<_> = all.iter().map(numbers).collect::<PyResult<_>>()?;
    let rows = all.first().map_or(0, Vec::len);
    if !(2..5).contains(&all.len()) || all.iter().any(|column| column.len() != rows) {
        let wanted = "a recording is a file, or (t, a_x), (t, a_x, a_y) or (t, a_x, a_y, a_z), each as long as the others";
        return Err(wrong(wanted));
    }
    let bridged = columns == Some("gaps=bridge");
    if columns.is_some() && !bridged {
        let wanted = "columns of numbers are in s and m/s^2, and can be \"gaps=bridge\" alone";
        return Err(wrong(wanted));
    }
    let at = |column: usize, row: usize| Some(*all.get(column)?.get(row)?);
    let row = |(k, t): (usize, &f64)| (*t, [1, 2].map(|axis| at(axis, k).unwrap_or(0.0)));
    let recording = Recording {
        rows: all.iter().take(1).flatten().enumerate().map(row).collect(),
        normal: all.get(3).cloned(),
    };
    match recording.gap().filter(|_| !bridged) {
        Some(k) => Err(wrong(format!(
            "before row {} is a gap of more than eight usual steps: columns=\"gaps=bridge\" goes on over it",
            k + 1
        ))),
        None => Ok(Record::Rows(recording)),
    }
}
