//! What became of the body of a scene.

use crate::{by_name, columns::array, name, parsed, wrong};
use pyo3::{
    exceptions::PyAttributeError,
    prelude::*,
    types::{IntoPyDict, PyDict, PyList},
};
use slipbook::scene::{self, Moment, Opinion};

/// The end of a scene, in SI and in the axes of the floor, and how it came to that: the time t, the place x and y, the velocity
/// v_x and v_y, of a ball the spin omega_x, omega_y and omega_z, the length of the path, and the heat of friction on each kilogram.
#[pyclass(frozen, module = "slipbook")]
pub struct Answer {
    pub answer: scene::Answer,
    pub second: Option<Opinion>,
}

#[pymethods]
impl Answer {
    /// The numbers of the end by their names.
    #[getter]
    fn numbers<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        by_name(py, &self.answer.numbers, |number| number.value)
    }

    /// How far each of them may be off: inf or nan if that is not known.
    #[getter]
    fn errors<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        by_name(py, &self.answer.numbers, |number| number.error)
    }

    /// The unit of each of them.
    #[getter]
    fn units<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        by_name(py, &self.answer.numbers, |number| number.unit)
    }

    /// What the body does and since when: "slides", "rests" or "rolls".
    #[getter]
    fn events(&self) -> Vec<(f64, String)> {
        let events = self.answer.events.iter();
        events
            .map(|event| (event.t.0, format!("{:?}", event.doing).to_lowercase()))
            .collect()
    }

    /// What the paper's formulas say, where the scene lies in their reach: the section, and numbers by their names.
    #[getter]
    fn second<'py>(&self, py: Python<'py>) -> PyResult<Option<(&str, Bound<'py, PyDict>)>> {
        let said = self.second.as_ref().map(|second| {
            let numbers = second.numbers.iter().map(|(known, x)| (name(known), *x));
            Ok((second.section, numbers.into_py_dict(py)?))
        });
        said.transpose()
    }

    /// The numbers at a time, without their errors.
    fn at<'py>(&self, py: Python<'py>, t: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyDict>> {
        let moment = self.answer.moved.at(parsed(t)?).map_err(wrong)?;
        by_name(py, &moment.numbers(), |number| number.value)
    }

    /// The numbers from the start on, dt apart, and at the end: an array of float64 for each name, which NumPy takes without a copy,
    /// and pandas.DataFrame all together.
    fn table<'py>(&self, py: Python<'py>, dt: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyDict>> {
        let dt = parsed(dt)?;
        let rows = py.detach(|| {
            let moments = self.answer.moved.every(dt)?;
            Ok(moments.iter().map(Moment::numbers).collect::<Vec<_>>())
        });
        let rows = rows.map_err(|error: scene::SceneError| wrong(error))?;
        let columns = PyDict::new(py);
        for (k, head) in self.answer.numbers.iter().enumerate() {
            let column = rows
                .iter()
                .map(|row| row.get(k).map_or(f64::NAN, |number| number.value));
            columns.set_item(name(head.name), array(py, column)?)?;
        }
        Ok(columns)
    }

    fn __getattr__(&self, known: &str) -> PyResult<f64> {
        let mut numbers = self.answer.numbers.iter();
        let number = numbers.find(|number| name(number.name) == known);
        let none = || PyAttributeError::new_err(format!("an answer has no `{known}`"));
        number.map(|number| number.value).ok_or_else(none)
    }

    fn __dir__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyList>> {
        let all = py.get_type::<Self>().dir()?;
        for number in &self.answer.numbers {
            all.append(name(number.name))?;
        }
        Ok(all)
    }

    fn __repr__(&self) -> String {
        let numbers = self.answer.numbers.iter().map(|number| {
            let shown = number
                .rounded()
                .map_or("unknown".to_owned(), |x| x.to_string());
            format!("{}={shown}", name(number.name))
        });
        format!("Answer({})", numbers.collect::<Vec<_>>().join(", "))
    }
}
