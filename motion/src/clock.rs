//! Motions integrated in a time s with dt = (sliding speed) ds: in the time t, then the first component of the state, the law of
//! motion is singular where the sliding speed is zero.

use super::error::MotionError;
use crate::numerics::{
    NumericsError,
    series::{arrival, change},
    taylor::{Control, Integrator, Step, System, TERMS},
};

/// The first of `D` components is the time t.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Clocked<const D: usize> {
    steps: Vec<Step<f64, D, TERMS>>,
    end: [f64; D],
}

impl<const D: usize> Clocked<D> {
    /// Integrates `system` from `start` until its clock shows `until`, or until the first node at which
    /// `finished` holds. Cost: at most `limit` steps.
    pub(crate) fn run<S: System<f64, D, TERMS>>(
        system: &S,
        start: [f64; D],
        until: f64,
        limit: usize,
        mut finished: impl FnMut(&[f64; D]) -> bool,
    ) -> Result<Self, MotionError> {
        let mut integrator = Integrator::new(system, 0.0, start, Control::Each);
        let mut steps = Vec::new();
        loop {
            let state = *integrator.state();
            let left = until - state[0];
            if left <= 0.0 || finished(&state) {
                return Ok(Self { steps, end: state });
            }
            let reached = steps.len();
            if reached >= limit {
                return Err(MotionError::Steps { limit, t: state[0] });
            }
            steps.push(Step::empty());
            let step = &mut steps[reached];
            integrator.expand(step)?;
            if step.h == f64::INFINITY {
                // All series end: the clock is a polynomial whose first term alone brings it there.
                step.h = 2.0 * left / step.series[0][1];
            }
            if change(&step.series[0], &step.h) >= left {
                step.h = arrival(&step.series[0], left, step.h);
                let mut end = step.at(&step.h);
                end[0] = until;
                return Ok(Self { steps, end });
            }
            integrator.advance(step);
        }
    }

    pub(crate) fn end(&self) -> &[f64; D] {
        &self.end
    }

    /// In the last one the series serve to `h` as well.
    pub(crate) fn steps(&self) -> &[Step<f64, D, TERMS>] {
        &self.steps
    }

    pub(crate) fn nodes(&self) -> impl Iterator<Item = [f64; D]> + '_ {
        let begins = self.steps.iter().map(|step| step.at(&0.0));
        begins.chain(std::iter::once(self.end))
    }

    /// State when the clock shows `t`: that at the nearer end for a time outside.
    pub(crate) fn at(&self, t: f64) -> Result<[f64; D], MotionError> {
        if t.is_nan() {
            return Err(NumericsError::Argument {
                name: "t",
                value: t,
                range: "a number",
            }
            .into());
        }
        if t >= self.end[0] {
            return Ok(self.end);
        }
        let index = self.steps.partition_point(|step| step.series[0][0] <= t);
        let Some(step) = self.steps.get(index.saturating_sub(1)) else {
            return Ok(self.end);
        };
        let clock = &step.series[0];
        let mut state = step.at(&arrival(clock, t - clock[0], step.h));
        state[0] = state[0].max(t);
        Ok(state)
    }
}
