//! A second, foreign integrator: Dormand and Prince's Runge–Kutta method of order 8(5,3), from `ode_solvers`.
//!
//! It shares no line with [`taylor`](super::taylor) and serves to cross-check it. Its step sizes go through the
//! standard library's powers, so that its last bits may differ between platforms.

use super::error::{NumericsError, finite};
use ode_solvers::dop_shared::IntegrationError;
use ode_solvers::{Dop853, OutputType, SVector, System};

/// A right-hand side in the form that the library wants.
struct RightHandSide<F>(F);

impl<const D: usize, F: Fn(f64, &[f64; D]) -> [f64; D]> System<f64, SVector<f64, D>>
    for RightHandSide<F>
{
    fn system(&self, t: f64, x: &SVector<f64, D>, slope: &mut SVector<f64, D>) {
        *slope = SVector::from((self.0)(t, &(*x).into()));
    }
}

/// State at time `to` of x′ = `f(t, x)` that begins at time `from` in `state`. `relative` and `absolute` are the
/// tolerances of a single step; 10⁻¹⁴ is about the least that makes sense.
///
/// # Errors
/// [`NumericsError::Argument`] for a time, state or tolerance out of range, [`NumericsError::Library`] when the
/// method gives up (100,000 steps, too small steps, stiffness), [`NumericsError::NotFinite`] when the result is.
pub fn end<const D: usize>(
    f: impl Fn(f64, &[f64; D]) -> [f64; D],
    from: f64,
    state: [f64; D],
    to: f64,
    relative: f64,
    absolute: f64,
) -> Result<[f64; D], NumericsError> {
    finite("from", from)?;
    finite("to", to)?;
    for x in state {
        finite("state", x)?;
    }
    for (name, value) in [("relative", relative), ("absolute", absolute)] {
        if !(value.is_finite() && value > 0.0) {
            return Err(NumericsError::Argument {
                name,
                value,
                range: "finite and positive",
            });
        }
    }
    if from == to {
        return Ok(state);
    }
    let start = SVector::from(state);
    let mut solver = Dop853::new(
        RightHandSide(f),
        from,
        to,
        to - from,
        start,
        relative,
        absolute,
    );
    solver.set_output(OutputType::Sparse);
    solver
        .integrate()
        .map_err(|error: IntegrationError| NumericsError::Library {
            method: "Dop853",
            message: error.to_string(),
        })?;
    let end: [f64; D] = solver.y_out().last().map_or(state, |x| (*x).into());
    if end.iter().all(|x| x.is_finite()) {
        Ok(end)
    } else {
        Err(NumericsError::NotFinite {
            what: "the state integrated by Dop853",
            at: to,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_oscillation_ends_where_it_should() {
        let swing = |_: f64, x: &[f64; 2]| [x[1], -x[0]];
        for to in [10.0, -10.0] {
            let [x, v] = end(swing, 0.0, [1.0, 0.0], to, 1e-13, 1e-13).unwrap();
            assert!(
                (x - libm::cos(10.0)).abs() < 1e-11 && (v + libm::sin(to)).abs() < 1e-11,
                "{x} {v}"
            );
        }
    }

    #[test]
    fn bad_input_and_blow_up_are_errors() {
        let f = |_: f64, x: &[f64; 1]| [x[0] * x[0]];
        assert!(matches!(
            end(f, f64::NAN, [1.0], 1.0, 1e-12, 1e-12),
            Err(NumericsError::Argument { name: "from", .. })
        ));
        assert!(matches!(
            end(f, 0.0, [1.0], 1.0, 0.0, 1e-12),
            Err(NumericsError::Argument {
                name: "relative",
                ..
            })
        ));
        // x′ = x² from 1 is infinite at t = 1.
        assert!(end(f, 0.0, [1.0], 2.0, 1e-12, 1e-12).is_err());
    }
}
