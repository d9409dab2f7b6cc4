//! Many particles on a table that turns.

use crate::{
    columns::{array, numbers},
    wrong,
};
use pyo3::{
    prelude::*,
    types::{IntoPyDict, PyDict},
};
use slipbook::motion::{
    MotionError,
    turntable::{
        Start,
        ensemble::{End, Horizon},
    },
};

/// Between looks for Ctrl-C: some tenths of a second.
const PIECE: usize = 1 << 18;

/// What becomes of particles on a rough table that turns, from their distances rho from its axis, their speeds p on it and their
/// angles psi (radians) from velocity to position, in units of mu g/Omega^2, mu g/Omega and 1/Omega.
///
/// A column for each name: the outcome, in a list, is "rest", "far" (beyond the distance far), "late" (neither until the time
/// late), "unfinished" (rounding decides) or "refused" (out of range); sigma is where it rests, tau when it does, or is gone, each
/// with how far it may be off, in arrays, which NumPy takes without a copy; nan where there is none. What is given is copied, from an array of
/// float64 in one piece.
#[pyfunction]
#[pyo3(signature = (rho, p, psi, *, far = 100.0, late = 50.0))]
pub fn turntable_ends(
    py: Python<'_>,
    #[pyo3(from_py_with = numbers)] rho: Vec<f64>,
    #[pyo3(from_py_with = numbers)] p: Vec<f64>,
    #[pyo3(from_py_with = numbers)] psi: Vec<f64>,
    far: f64,
    late: f64,
) -> PyResult<Bound<'_, PyDict>> {
    if rho.len() != p.len() || rho.len() != psi.len() {
        return Err(wrong("rho, p and psi are equally many"));
    }
    let horizon = Horizon {
        rho: far,
        tau: late,
    };
    // It is refused without particles too.
    horizon.follow(&[]).map_err(wrong)?;
    let pieces = rho
        .chunks(PIECE)
        .zip(p.chunks(PIECE))
        .zip(psi.chunks(PIECE));
    let mut rows = Vec::new();
    for ((rho, p), psi) in pieces {
        py.check_signals()?;
        let ends = py.detach(|| {
            let given = rho.iter().zip(p).zip(psi);
            let starts: Vec<_> = given
                .map(|((rho, p), psi)| Start::polar(*rho, *p, *psi))
                .collect();
            let good: Vec<_> = starts.iter().flatten().copied().collect();
            let mut ends = horizon.follow(&good)?.into_iter();
            let end = |start: Result<_, _>| row(start.ok().and_then(|_: Start| ends.next()?.ok()));
            Ok::<_, MotionError>(starts.into_iter().map(end).collect::<Vec<_>>())
        });
        rows.extend(ends.map_err(wrong)?);
    }
    let outcomes = rows.iter().map(|row| row.0).collect::<Vec<_>>();
    let columns = [("outcome", outcomes)].into_py_dict(py)?;
    for (k, name) in ["sigma", "sigma_error", "tau", "tau_error"]
        .iter()
        .enumerate()
    {
        columns.set_item(name, array(py, rows.iter().map(|row| row.1[k]))?)?;
    }
    Ok(columns)
}

fn row(end: Option<End>) -> (&'static str, [f64; 4]) {
    let none = f64::NAN;
    match end {
        Some(End::Rest {
            sigma,
            sigma_error,
            tau,
            tau_error,
        }) => ("rest", [sigma, sigma_error, tau, tau_error]),
        Some(End::Far { tau, tau_error }) => ("far", [none, none, tau, tau_error]),
        Some(End::Late(_)) => ("late", [none; 4]),
        Some(End::Unfinished(_)) => ("unfinished", [none; 4]),
        None => ("refused", [none; 4]),
    }
}
