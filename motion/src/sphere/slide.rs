//! Sliding: Newton's and Euler's laws in the time s, dt = |c| ds.

use super::{Sphere, cross};
use crate::numerics::{
    series::{convolution, product, sqrt, square},
    taylor::{Coefficients, System, TERMS},
};

pub(super) struct Sliding<'a> {
    sphere: &'a Sphere,
    /// A about the beginning of the step, as series in t.
    a: [Coefficients; 2],
    /// Number of coefficients up to the last that is not zero.
    terms: usize,
}

impl<'a> Sliding<'a> {
    pub(super) fn new(sphere: &'a Sphere, a: [Coefficients; 2]) -> Self {
        let last = |c: &Coefficients| c.iter().rposition(|c| *c != 0.0).map_or(0, |k| k + 1);
        Self {
            sphere,
            a,
            terms: last(&a[0]).max(last(&a[1])),
        }
    }

    /// Coefficient `k` in s of A(t(s)), by the powers of t − t₀.
    #[inline(always)]
    fn acceleration(&self, k: usize, t: &Coefficients, work: &mut Work) {
        let mut sum = [0, 1].map(|i| if k == 0 { self.a[i][0] } else { 0.0 });
        for j in 1..=k.min(self.terms.saturating_sub(1)) {
            work.powers[j][k] = if j == 1 {
                t[k]
            } else {
                convolution(&t[1..=k + 1 - j], &work.powers[j - 1][j - 1..k])
            };
            for (sum, a) in sum.iter_mut().zip(&self.a) {
                *sum += a[j] * work.powers[j][k];
            }
        }
        (work.a[0][k], work.a[1][k]) = (sum[0], sum[1]);
    }
}

/// What a step needs besides the state.
#[derive(Default)]
pub(super) struct Work {
    squared: Coefficients,
    /// |c|.
    rate: Coefficients,
    a: [Coefficients; 2],
    /// Powers of t − t₀; `powers[j]` begins with order j.
    powers: Vec<Coefficients>,
}

impl System<f64, 10, TERMS> for Sliding<'_> {
    type Work = Work;

    fn begin(&self, _: &f64, _: &[f64; 10], work: &mut Work) {
        // What is read of them has been written in the same step.
        if work.powers.len() < self.terms {
            work.powers.resize(self.terms, [0.0; TERMS]);
        }
    }

    #[inline(always)]
    fn derivative(&self, k: usize, state: &[Coefficients; 10], work: &mut Work) -> [f64; 10] {
        let [t, _, _, vx, vy, _, _, _, cx, cy] = state;
        work.squared[k] = square(cx, k) + square(cy, k);
        work.rate[k] = sqrt(&work.squared, &work.rate, k);
        self.acceleration(k, t, work);
        let friction = self.sphere.friction();
        // The force times |c|.
        let (by_force, spin) = self.sphere.response([-friction * cx[k], -friction * cy[k]]);
        let pull = if self.terms > 1 {
            [
                product(&work.a[0], &work.rate, k),
                product(&work.a[1], &work.rate, k),
            ]
        } else {
            [self.a[0][0] * work.rate[k], self.a[1][0] * work.rate[k]]
        };
        let dv = [by_force[0] - pull[0], by_force[1] - pull[1]];
        let turning = cross(spin, self.sphere.arm());
        [
            work.rate[k],
            product(&work.rate, vx, k),
            product(&work.rate, vy, k),
            dv[0],
            dv[1],
            spin[0],
            spin[1],
            spin[2],
            dv[0] + turning[0],
            dv[1] + turning[1],
        ]
    }
}
