//! Sticking: v = 0 while |A| ≤ μ_s g.

use super::{
    super::trajectory::{Piece, State},
    MotionError, Run,
};
use crate::numerics::{
    events::{Way, roots},
    series::square,
    taylor::{Coefficients, TERMS, reach},
};

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Release {
    /// |A| grows through μ_s g.
    Smooth,
    /// |A| > μ_s g from the first moment.
    Sudden,
}

impl Run<'_> {
    /// Nothing if it does not get loose before the end.
    pub(super) fn stick(&mut self) -> Result<Option<Release>, MotionError> {
        let mut crossed = false;
        while self.state.t < self.until {
            let local = self.local()?;
            let State { t, x, .. } = self.state;
            let (mut excess, rounding) = excess(&local.a, self.holding);
            if crossed || excess[0].abs() <= rounding[0] {
                excess[0] = 0.0;
            }
            let first = (0..TERMS).find(|&k| {
                if k == 0 {
                    excess[0] != 0.0
                } else {
                    excess[k].abs() > rounding[k]
                }
            });
            if first.is_some_and(|k| excess[k] > 0.0) {
                return Ok(Some(if first == Some(0) {
                    Release::Sudden
                } else {
                    Release::Smooth
                }));
            }
            // The square of a series is good for less far than the series.
            let trusted = reach(&excess);
            let (left, landing) = if trusted < local.left {
                (trusted, None)
            } else {
                (local.left, local.landing)
            };
            let found = if first.is_some() {
                roots(&excess, left)?
            } else {
                Vec::new()
            };
            let crossing = found.iter().find(|root| root.way == Way::Rising);
            crossed = crossing.is_some();
            let to = match (crossing, landing) {
                (Some(root), _) => t + root.at,
                (None, Some(landing)) => landing,
                (None, None) => t + left,
            };
            let to = to.min(self.until);
            self.push(
                Piece::Rest { from: t, x },
                State {
                    t: to,
                    v: [0.0; 2],
                    x,
                },
            );
        }
        Ok(None)
    }
}

/// |A|² − (μ_s g)², and bounds for what rounding makes of its coefficients: a small component may have an error that is small
/// only beside the other one.
fn excess(a: &[Coefficients; 2], holding: f64) -> (Coefficients, Coefficients) {
    let sizes: Coefficients = std::array::from_fn(|k| a[0][k].abs() + a[1][k].abs());
    let mut f = [0.0; TERMS];
    let mut rounding = [0.0; TERMS];
    for k in 0..TERMS {
        f[k] = square(&a[0], k) + square(&a[1], k);
        rounding[k] = 8.0 * f64::EPSILON * square(&sizes, k);
    }
    // (|A_x| − μ_s g)(|A_x| + μ_s g) is exact where A is along an axis.
    f[0] = if a[1][0] == 0.0 {
        (a[0][0].abs() - holding) * (a[0][0].abs() + holding)
    } else if a[0][0] == 0.0 {
        (a[1][0].abs() - holding) * (a[1][0].abs() + holding)
    } else {
        f[0] - holding * holding
    };
    (f, rounding)
}
