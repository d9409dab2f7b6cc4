//! A scene: its words as they were given, and what the library reads in them.

use crate::{
    answer::Answer,
    columns::{Record, record},
    parsed, text, wrong,
};
use pyo3::{prelude::*, types::PyDict};
use slipbook::{
    motion::Fitted,
    scene::{self, Part, Radian, SceneError, Until, WORDS, apart, second, target},
};
use std::sync::OnceLock;

/// A block or a ball on a rough floor, what moves that, and how it starts. It never changes.
#[pyclass(frozen, module = "slipbook")]
pub struct Scene {
    given: Py<PyDict>,
    words: Words,
    read: (scene::Scene, Until),
}

#[derive(Clone)]
struct Words {
    body: String,
    words: Vec<(String, String)>,
    shaken: Option<Part>,
}

impl Words {
    fn read(&self) -> Result<(scene::Scene, Until), SceneError> {
        let words = self.words.iter().map(|(name, text)| (&**name, &**text));
        let (mut scene, until) = scene::Scene::read(&self.body, words, |_| Ok(String::new()))?;
        scene.frame.extend(self.shaken.clone());
        Ok((scene, until))
    }
}

/// A scene of a block: block(mu=0.3, mu_s=0.4, pull="4.2m/s^2:4.79s,0"). WORDS says what there is.
#[pyfunction]
#[pyo3(signature = (**words))]
pub fn block(py: Python<'_>, words: Option<&Bound<'_, PyDict>>) -> PyResult<Scene> {
    of_body(py, "block", words)
}

/// A scene of a ball: ball(mu=0.08, radius="11cm", throw="5m/s"). WORDS says what there is.
#[pyfunction]
#[pyo3(signature = (**words))]
pub fn ball(py: Python<'_>, words: Option<&Bound<'_, PyDict>>) -> PyResult<Scene> {
    of_body(py, "ball", words)
}

/// A scene of a "block" or a "ball"; scene(**answer["scene"]) is the one of `slipbook scene --json`.
#[pyfunction]
#[pyo3(name = "scene", signature = (body, **words))]
pub fn of_body(py: Python<'_>, body: &str, words: Option<&Bound<'_, PyDict>>) -> PyResult<Scene> {
    Scene::new(body, PyDict::new(py), words)
}

/// The values of a word from low to high, at which a number of the answer is what it is to be, as in
/// find(scene, "mu", 0.01, 2, path="20m"); they have the unit of low and high.
///
/// Of two values that are closer together than a 400th of the range, or one that is only touched, nothing may be seen; where the
/// number jumps over what it is to be, there is none.
#[pyfunction]
#[pyo3(signature = (scene, word, low, high, **number))]
pub fn find(
    py: Python<'_>,
    scene: &Scene,
    word: &str,
    low: &Bound<'_, PyAny>,
    high: &Bound<'_, PyAny>,
    number: Option<&Bound<'_, PyDict>>,
) -> PyResult<Vec<f64>> {
    let word = word.replace('_', "-");
    if !WORDS.iter().any(|known| known.name == word) {
        return Err(wrong(SceneError::Word(word)));
    }
    let asked: Vec<_> = number.into_iter().flatten().collect();
    let [(name, wanted)] = &asked[..] else {
        return Err(wrong("one number is to be found, as in path=\"20m\""));
    };
    let (name, wanted) = target(&format!("{name}={}", text(wanted)?)).map_err(wrong)?;
    let ends = [text(low)?, text(high)?];
    let [(low, unit), (high, other)] = [apart(&ends[0]), apart(&ends[1])];
    if unit.trim() != other.trim() {
        return Err(wrong(format!("`{unit}` and `{other}` are two units")));
    }
    let [low, high] = [low, high].map(|end| end.trim().parse().unwrap_or(f64::NAN));
    let stopped = OnceLock::new();
    let value = |x: f64| {
        if stopped.get().is_some()
            || Python::attach(|py| py.check_signals())
                .map_err(|stop| stopped.set(stop))
                .is_err()
        {
            return Err(SceneError::Together("stopped"));
        }
        let mut other = scene.words.clone();
        let old = other.words.iter().position(|(name, _)| *name == word);
        let old = old.map(|at| other.words.remove(at).1).unwrap_or_default();
        // Its direction stays.
        let direction = old.find('@').map_or("", |at| &old[at..]);
        let text = format!("{x}{unit}{direction}");
        other.words.push((word.clone(), text));
        other.read()
    };
    let found = py.detach(|| scene::find(value, [low, high], (name, wanted)));
    if let Some(stop) = stopped.into_inner() {
        return Err(stop);
    }
    Ok(found.map_err(wrong)?.solutions)
}

const OF_RECORD: [&str; 3] = ["record", "columns", "towards"];

fn shaken(given: &Bound<'_, PyDict>) -> PyResult<Option<Part>> {
    let [recording, columns, towards] = OF_RECORD.map(|name| given.get_item(name));
    let Some(recording) = recording? else {
        return Ok(None);
    };
    let columns = columns?.map(|columns| text(&columns)).transpose()?;
    let fitted = match record(&recording, columns.as_deref())? {
        Record::Text(text, columns) => Fitted::from_csv_with(&text, &columns),
        Record::Rows(recording) => Fitted::from_table(&recording.rows),
    };
    let towards = towards?.map_or(Ok(Radian(0.0)), |towards| parsed(&towards))?;
    Ok(Some(Part::record(fitted.map_err(wrong)?, towards)))
}

impl Scene {
    /// None, or False, takes a word away.
    fn new(
        body: &str,
        given: Bound<'_, PyDict>,
        more: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        for (name, value) in more.into_iter().flatten() {
            let name = name.extract::<String>()?.replace('_', "-");
            let parts = value.extract::<Vec<Bound<'_, PyAny>>>().is_ok();
            if parts && !["pull", "accelerate", "record"].contains(&&*name) {
                given.set_item(name, text(&value)?)?;
            } else if !value.is_none() && value.extract::<bool>().unwrap_or(true) {
                given.set_item(name, value)?;
            } else if given.contains(&name)? {
                given.del_item(name)?;
            }
        }
        let mut all = Words {
            body: body.to_owned(),
            words: Vec::new(),
            shaken: shaken(&given)?,
        };
        for (name, value) in &given {
            let name: String = name.extract()?;
            if all.shaken.is_some() && OF_RECORD.contains(&&*name) {
                continue;
            }
            let texts = if value.extract::<bool>().is_ok() {
                vec![String::new()]
            } else if let Ok(many) = value.extract::<Vec<_>>() {
                many.iter().map(text).collect::<PyResult<_>>()?
            } else {
                vec![text(&value)?]
            };
            let texts = texts.into_iter().map(|text| (name.clone(), text));
            all.words.extend(texts);
        }
        Ok(Self {
            given: given.unbind(),
            read: all.read().map_err(wrong)?,
            words: all,
        })
    }
}

#[pymethods]
impl Scene {
    /// The same with other words; None takes one away.
    #[pyo3(signature = (**words))]
    fn with_(&self, py: Python<'_>, words: Option<&Bound<'_, PyDict>>) -> PyResult<Self> {
        Self::new(&self.words.body, self.given.bind(py).copy()?, words)
    }

    /// The same on a floor that accelerates as was recorded: in a file, or in the sequences (t, a_x) or (t, a_x, a_y), in s and m/s^2.
    ///
    /// Their numbers are copied, from an array of float64 in one piece; `with_` reads them again.
    #[pyo3(signature = (record, /, **words))]
    fn on(
        &self,
        py: Python<'_>,
        record: Bound<'_, PyAny>,
        words: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        let given = self.given.bind(py).copy()?;
        given.set_item("record", record)?;
        Self::new(&self.words.body, given, words)
    }

    /// What becomes of the body until "stop", "rolling", "rest", a time "2s", a path's length "1.8m", or "beyond=30cm".
    #[pyo3(signature = (until = None))]
    fn run(&self, py: Python<'_>, until: Option<&Bound<'_, PyAny>>) -> PyResult<Answer> {
        let (scene, own) = &self.read;
        let until = match until {
            Some(until) => parsed(until)?,
            None => *own,
        };
        let answer = py.detach(|| scene.answer(until)).map_err(wrong)?;
        let second = second(scene, until);
        Ok(Answer { answer, second })
    }

    /// Its words as they were given, with its body: `slipbook scene` reads them from a file of JSON.
    #[getter]
    fn words<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let words = PyDict::new(py);
        words.set_item("body", &self.words.body)?;
        words.update(self.given.bind(py).as_mapping())?;
        Ok(words)
    }

    fn __repr__(&self, py: Python<'_>) -> PyResult<String> {
        let words = self.given.bind(py).iter().map(|(name, value)| {
            let name = name.extract::<String>()?.replace('-', "_");
            let value = value.repr()?.to_string();
            let long = value.chars().count() > 60;
            Ok(format!("{name}={}", if long { "..." } else { &value }))
        });
        let words = words.collect::<PyResult<Vec<_>>>()?.join(", ");
        Ok(format!("slipbook.{}({words})", self.words.body))
    }
}
