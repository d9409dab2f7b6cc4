//! A second, foreign integrator to check [`taylor`](super::taylor): Dormand and Prince's Runge–Kutta method
//! of order 8(5,3), from `ode_solvers`. Its last bits may differ between platforms.

use super::error::{NumericsError, finite};
use ode_solvers::dop_shared::{IntegrationError, OutputType};
use ode_solvers::{DVector, Dop853, System};

/// With the time as one more component: the library's own is wrong in the last stage (its node c₁₂ is 0 where
/// it has to be 1), so nothing may depend on it.
struct RightHandSide<'f>(&'f Slopes<'f>);

type Slopes<'f> = dyn Fn(f64, &[f64], &mut [f64]) + 'f;

impl System<f64, DVector<f64>> for RightHandSide<'_> {
    fn system(&self, _: f64, x: &DVector<f64>, slope: &mut DVector<f64>) {
        let last = x.len() - 1;
        let (state, time) = x.as_slice().split_at(last);
        let (slopes, unit) = slope.as_mut_slice().split_at_mut(last);
        (self.0)(time[0], state, slopes);
        unit[0] = 1.0;
    }
}

/// State at time `to` of x′ = `f(t, x)` from `state` at time `from`. `relative` and `absolute` are the
/// tolerances of a single step, from about 10⁻¹⁴.
///
/// # Errors
/// [`NumericsError::Argument`] for a time, state or tolerance out of range, [`NumericsError::Library`] when the
/// method gives up (10,000 steps, too small steps), [`NumericsError::NotFinite`] when the result is.
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
    // The library's own settings but for one: its test for stiffness takes rounding for stiffness when steps are
    // short, so it is put off beyond the last step.
    let (safety, beta, shrink, grow, initial_step) = (0.9, 0.0, 0.333, 6.0, 0.0);
    let start = DVector::from_iterator(D + 1, state.into_iter().chain([from]));
    let slopes = |t: f64, x: &[f64], slopes: &mut [f64]| {
        slopes.copy_from_slice(&f(t, &std::array::from_fn(|i| x[i])));
    };
    let mut solver = Dop853::from_param(
        RightHandSide(&slopes),
        from,
        to,
        to - from,
        start,
        relative,
        absolute,
        safety,
        beta,
        shrink,
        grow,
        to - from,
        initial_step,
        MAX_STEPS,
        2 * MAX_STEPS,
        OutputType::Sparse,
    );
    solver
        .integrate()
        .map_err(|error: IntegrationError| NumericsError::Library {
            method: "Dop853",
            message: error.to_string(),
        })?;
    let end = solver
        .y_out()
        .last()
        .map_or(state, |x| std::array::from_fn(|i| x[i]));
    if end.iter().all(|x| x.is_finite()) {
        Ok(end)
    } else {
        Err(NumericsError::NotFinite {
            what: "the state integrated by Dop853",
            at: to,
        })
    }
}

const MAX_STEPS: u32 = 10_000;

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
    fn the_time_counts() {
        // x′ = t⁷ + cos t, where the order of a method with a wrong node falls.
        let f = |t: f64, _: &[f64; 1]| [libm::pow(t, 7.0) + libm::cos(t)];
        let [x] = end(f, 0.5, [0.0], 2.0, 1e-14, 1e-14).unwrap();
        let expected = (256.0 - libm::pow(0.5, 8.0)) / 8.0 + libm::sin(2.0) - libm::sin(0.5);
        assert!((x - expected).abs() < 1e-12, "{x} {expected}");
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
