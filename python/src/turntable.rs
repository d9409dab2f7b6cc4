//! Many particles on a table that turns.

use crate::wrong;
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

/// What becomes of particles on a rough table that turns, from their distances rho from its axis, their speeds p on it and their
/// angles psi (radians) from velocity to position, in units of mu g/Omega^2, mu g/Omega and 1/Omega.
///
/// A list for each name: the outcome is "rest", "far" (beyond the distance far), "late" (neither until the time late),
/// "unfinished" (rounding decides) or "refused" (out of range); sigma is where it rests, tau when it does, or is gone, each
/// with how far it may be off; nan where there is none.
#[pyfunction]
#[pyo3(signature = (rho, p, psi, *, far = 100.0, late = 50.0))]
pub fn turntable_ends(
    py: Python<'_>,
    rho: Vec<f64>,
    p: Vec<f64>,
    psi: Vec<f64>,
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
    let ends = py.detach(|| {
        let given = rho.iter().zip(&p).zip(&psi);
        let starts: Vec<_> = given
            .map(|((rho, p), psi)| Start::polar(*rho, *p, *psi))
            .collect();
        let good: Vec<_> = starts.iter().flatten().copied().collect();
        let mut ends = horizon.follow(&good)?.into_iter();
        let end = |start: Result<_, _>| start.ok().and_then(|_: Start| ends.next()?.ok());
        Ok::<_, MotionError>(starts.into_iter().map(end).collect::<Vec<_>>())
    });
    let mut outcomes = Vec::new();
    let mut columns = [const { Vec::new() }; 4];
    for end in ends.map_err(wrong)? {
        let none = f64::NAN;
        let (outcome, row) = match end {
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
        };
        outcomes.push(outcome);
        for (column, x) in columns.iter_mut().zip(row) {
            column.push(x);
        }
    }
    let names = ["sigma", "sigma_error", "tau", "tau_error"];
    let ends = names.into_iter().zip(columns).into_py_dict(py)?;
    ends.set_item("outcome", outcomes)?;
    Ok(ends)
}
