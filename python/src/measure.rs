//! Friction from a recording.

use crate::{
    columns::{Record, record},
    parsed, wrong,
};
use pyo3::prelude::*;
use slipbook::{
    motion::{
        Recording,
        measure::{Interval, Settings, Unfound, Verdict},
    },
    scene::{MetrePerSecond2, Second},
};
use std::collections::BTreeMap;

type Found = Result<Interval, Unfound>;

#[derive(IntoPyObject)]
pub struct Measured {
    mu_k: Option<(f64, f64)>,
    mu_s: Option<(f64, f64)>,
    why: (Option<String>, Option<String>),
    coulomb: bool,
    verdict: String,
    noise: f64,
    zeroed: bool,
    normal: bool,
    assumed: Option<String>,
    stretches: Vec<(f64, f64, String)>,
    units: BTreeMap<&'static str, &'static str>,
}

/// The coefficients of friction by an accelerometer on the body that slides: what `slipbook measure` says, in a dict.
///
/// mu_k and mu_s are each the ends of an interval that holds the coefficient with a probability of 95 %, or None, and why says
/// why; coulomb is whether Coulomb's law fits, verdict says what speaks against it; noise is the sensor's, in m/s^2; zeroed whether a rest has
/// shown its zeros; normal whether N/m is measured, or taken for g; assumed what is taken for granted; stretches are (from, to, "sticks", "slips" or "is pushed"), in s.
///
/// A recording is a file, with columns="x=accel_x,z=accel_z,unit=g" where its heads do not say that, or sequences (t, a_x) to
/// (t, a_x, a_y, a_z) in s and m/s^2, z across the floor, whose numbers are copied, from an array of float64 in one piece. rest=(0, "2s")
/// are times between which it lay at rest on level floor. Without g that is 9.80665 m/s^2.
#[pyfunction]
#[pyo3(signature = (recording, /, *, columns = None, rest = None, g = None))]
pub fn measure(
    py: Python<'_>,
    recording: &Bound<'_, PyAny>,
    columns: Option<&str>,
    rest: Option<[Bound<'_, PyAny>; 2]>,
    g: Option<&Bound<'_, PyAny>>,
) -> PyResult<Measured> {
    let recording = match record(recording, columns)? {
        Record::Rows(rows) => rows,
        Record::Text(text, columns) => Recording::from_csv(&text, &columns).map_err(wrong)?,
    };
    let mut settings = Settings::default();
    if let Some(g) = g {
        settings.g = parsed::<MetrePerSecond2>(g)?.0;
    }
    if let Some([from, to]) = rest {
        settings.rest = Some([parsed::<Second>(&from)?.0, parsed::<Second>(&to)?.0]);
    }
    let found = py.detach(|| slipbook::motion::measure::measure(&recording, &settings));
    let found = found.map_err(wrong)?;
    let ends = |found: &Found| found.as_ref().ok().map(|ends| (ends.from, ends.to));
    let why = |found: &Found| found.as_ref().err().map(Unfound::to_string);
    let stretches = found.stretches.iter();
    Ok(Measured {
        mu_k: ends(&found.kinetic),
        mu_s: ends(&found.holding),
        why: (why(&found.kinetic), why(&found.holding)),
        coulomb: found.verdict == Verdict::Fits,
        verdict: found.verdict.to_string(),
        noise: found.noise,
        zeroed: found.zeroed,
        normal: found.normal,
        assumed: found.assumed(),
        stretches: stretches
            .map(|piece| (piece.from, piece.to, piece.kind.to_string()))
            .collect(),
        units: BTreeMap::from([("noise", "m/s^2"), ("stretches", "s")]),
    })
}
