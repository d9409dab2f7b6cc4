//! Slipbook from Python: the module `slipbook`.

mod answer;
mod claims;
mod columns;
mod measure;
mod scene;
mod turntable;

use pyo3::{
    exceptions::PyValueError,
    prelude::*,
    types::{IntoPyDict, PyDict},
};
use slipbook::scene::{Number, WORDS};
use std::{fmt::Display, str::FromStr};

/// A block or a ball on a rough floor that moves, and what becomes of it.
///
///     slipbook.block(mu=0.5, throw="6m/s").run().path
///
/// `block`, `ball` and `scene` make scenes of words, which `WORDS` explains. A value has its unit, as in "15cm", "33.3rpm", "36km/h", "10deg" and
/// "1g", or is a number in SI. What is wrong with them is told as a ValueError. `measure` finds friction in a recording, `turntable_ends`
/// follows many particles, and `claims` are those of the paper, with their verdicts.
#[pymodule]
#[pyo3(name = "slipbook")]
fn slipbook_module(module: &Bound<'_, PyModule>) -> PyResult<()> {
    let words = WORDS
        .iter()
        .map(|word| (word.name.replace('-', "_"), word.help));
    module.add("WORDS", words.into_py_dict(module.py())?)?;
    module.add("__version__", env!("CARGO_PKG_VERSION"))?;
    module.add_class::<answer::Answer>()?;
    module.add_class::<scene::Scene>()?;
    module.add_function(wrap_pyfunction!(scene::ball, module)?)?;
    module.add_function(wrap_pyfunction!(scene::block, module)?)?;
    module.add_function(wrap_pyfunction!(claims::claims, module)?)?;
    module.add_function(wrap_pyfunction!(claims::sheet, module)?)?;
    module.add_function(wrap_pyfunction!(measure::measure, module)?)?;
    module.add_function(wrap_pyfunction!(scene::find, module)?)?;
    module.add_function(wrap_pyfunction!(scene::of_body, module)?)?;
    module.add_function(wrap_pyfunction!(turntable::turntable_ends, module)?)
}

/// In the library's words.
fn wrong(error: impl Display) -> PyErr {
    PyValueError::new_err(error.to_string())
}

/// A number is in SI.
fn one(value: &Bound<'_, PyAny>) -> PyResult<String> {
    match value.extract() {
        Ok(text) => Ok(text),
        Err(_) => Ok(value.extract::<f64>()?.to_string()),
    }
}

/// Its parts behind one another.
fn text(value: &Bound<'_, PyAny>) -> PyResult<String> {
    one(value).or_else(|error| match value.extract::<Vec<_>>() {
        Ok(parts) => Ok(parts
            .iter()
            .map(one)
            .collect::<PyResult<Vec<_>>>()?
            .join(",")),
        Err(_) => Err(error),
    })
}

fn parsed<T: FromStr<Err: Display>>(value: &Bound<'_, PyAny>) -> PyResult<T> {
    text(value)?.parse().map_err(wrong)
}

/// In letters that are on every keyboard.
fn name(number: &str) -> String {
    number.replace('ω', "omega")
}

fn by_name<'py, T: IntoPyObject<'py>>(
    py: Python<'py>,
    numbers: &[Number],
    of: impl Fn(&Number) -> T,
) -> PyResult<Bound<'py, PyDict>> {
    numbers
        .iter()
        .map(|number| (name(number.name), of(number)))
        .into_py_dict(py)
}
