//! Sliding, in a time s that runs as fast as the particle slows down: dt = |v| ds / g.
//!
//! With a unit of acceleration g, dv/ds = −(A/g)|v| − (μg/g) v, dt/ds = |v|/g, dx/ds = v|v|/g. The right-hand side is analytic
//! for all v ≠ 0 and of the first degree in v: towards a stop v falls exponentially in s, each component with all its digits. A
//! stop is reached only in the limit; once the time left is below the rounding of the time slid, it is added.

use super::{
    super::creep::creep,
    super::trajectory::{Arc, Piece, SlideStep, State},
    MotionError, Run,
};
use crate::numerics::{
    number::Number,
    series::{convolution, product, sqrt, square},
    taylor::{Coefficients, Control, Integrator, Step, System, TERMS},
};

struct Sliding {
    /// A/g about the beginning of the step, as series in t of `terms` coefficients.
    a: [Coefficients; 2],
    /// Number of coefficients of `a` up to the last that is not zero.
    terms: usize,
    /// μg/g.
    friction: f64,
    /// 1/g.
    slowness: f64,
}

/// What a step needs besides the state.
#[derive(Default)]
struct Work {
    speed_squared: Coefficients,
    speed: Coefficients,
    /// |v| minus the absolute value of its larger component.
    excess: Coefficients,
    a: [Coefficients; 2],
    /// Powers of t − t₀; `powers[j]` begins with order j.
    powers: Vec<Coefficients>,
}

impl System<f64, 5, TERMS> for Sliding {
    type Work = Work;

    fn begin(&self, _: &f64, _: &[f64; 5], work: &mut Work) {
        // What is read of them has been written in the same step.
        if work.powers.len() < self.terms {
            work.powers.resize(self.terms, [0.0; TERMS]);
        }
    }

    #[inline(always)]
    fn derivative(&self, k: usize, state: &[Coefficients; 5], work: &mut Work) -> [f64; 5] {
        let [vx, vy, t, ..] = state;
        let [ax, ay] = if self.terms > 1 {
            work.speed_squared[k] = square(vx, k) + square(vy, k);
            work.speed[k] = sqrt(&work.speed_squared, &work.speed, k);
            self.compose(k, t, work);
            [
                product(&work.a[0], &work.speed, k) + self.friction * vx[k],
                product(&work.a[1], &work.speed, k) + self.friction * vy[k],
            ]
        } else {
            self.constant_pull(k, [vx, vy], work)
        };
        let speed = &work.speed;
        [
            -ax,
            -ay,
            speed[k] * self.slowness,
            product(vx, speed, k) * self.slowness,
            product(vy, speed, k) * self.slowness,
        ]
    }
}

impl Sliding {
    /// Coefficient `k` of A|v| + μg v for a constant A, and of |v|: with d|v|/ds = −A·v − μg|v|, nothing needs to be multiplied.
    /// When v points along −A, the sum may cancel down to (μg − |A|) v; so, with ± the sign of the larger component w of v, the
    /// smaller u, and a, b of A, it is a e + (μg ± a) w, where e = |v| − |w| = u²/(|v| + |w|) obeys de/ds = (±a − μg) e − b u.
    #[inline(always)]
    fn constant_pull(&self, k: usize, v: [&Coefficients; 2], work: &mut Work) -> [f64; 2] {
        let larger = usize::from(v[1][0].abs() > v[0][0].abs());
        let (w, u) = (v[larger], v[1 - larger]);
        let (a, b) = (self.a[larger][0], self.a[1 - larger][0]);
        let way = 1f64.copysign(w[0]);
        let excess = &mut work.excess;
        excess[k] = if k == 0 {
            u[0] * u[0] / (libm::hypot(u[0], w[0]) + w[0].abs())
        } else {
            ((way * a - self.friction) * excess[k - 1] - b * u[k - 1]).over(k)
        };
        work.speed[k] = way * w[k] + excess[k];
        let mut pull = [b * work.speed[k] + self.friction * u[k]; 2];
        pull[larger] = a * excess[k] + (self.friction + way * a) * w[k];
        pull
    }

    /// Coefficient `k` in s of A(t(s)), by the powers of t − t₀ up to `k`.
    #[inline(always)]
    fn compose(&self, k: usize, t: &Coefficients, work: &mut Work) {
        if k == 0 {
            (work.a[0][0], work.a[1][0]) = (self.a[0][0], self.a[1][0]);
            return;
        }
        work.powers[1][k] = t[k];
        let mut sum = [self.a[0][1] * t[k], self.a[1][1] * t[k]];
        for j in 2..=k.min(self.terms - 1) {
            let power = convolution(&t[1..=k + 1 - j], &work.powers[j - 1][j - 1..k]);
            work.powers[j][k] = power;
            sum[0] += self.a[0][j] * power;
            sum[1] += self.a[1][j] * power;
        }
        (work.a[0][k], work.a[1][k]) = (sum[0], sum[1]);
    }
}

/// As a fraction of the other component: what is one-dimensional in the limit becomes so before it underflows.
const NEGLIGIBLE: f64 = 1e-90;
/// As a fraction of the time that stopping takes from full speed.
const LAST: f64 = 1e-18;
/// As a fraction of the full speed, where rest holds what braking does not: on the way straight to a stop rounding turns the
/// direction by then.
const STILL: f64 = 1e-12;

/// The angle to the acceleration that is left at that speed of one that was below rounding at full speed.
const STRAIGHT: f64 = 1e-6;

/// For very short motions only.
const FASTEST: f64 = 1e100;

impl Run<'_> {
    /// True at v = 0, false at the end of the motion.
    pub(super) fn slide(&mut self) -> Result<bool, MotionError> {
        let mut sliding = Sliding {
            a: [[0.0; TERMS]; 2],
            terms: 0,
            friction: 0.0,
            slowness: 1.0,
        };
        let State { t, v, x } = self.state;
        let mut fastest = self.state.speed();
        // t, x and v keep the integrator's carries through the whole slide.
        let (mut carry, mut work) = ([0.0; 5], Work::default());
        let mut start = [v[0], v[1], t, x[0], x[1]];
        drop_negligible(&mut start, &mut carry);
        // How long the direction may still remember what it was.
        let mut memory = 0.0;
        while self.state.t < self.until {
            let local = self.local()?;
            let speed = libm::hypot(start[0], start[1]);
            fastest = fastest.max(speed);
            if memory <= 0.0 {
                match creep(&local.a, self.friction, [start[0], start[1]], local.left) {
                    Ok(creep) => {
                        let landing = local.landing.filter(|_| creep.h == local.left);
                        self.arc(creep.velocity, creep.h, landing);
                        if creep.stops {
                            self.state.v = [0.0; 2];
                            return Ok(true);
                        }
                        let State { t, v, x } = self.state;
                        start = [v[0], v[1], t, x[0], x[1]];
                        carry = [0.0; 5];
                        continue;
                    }
                    Err(wait) => memory = wait,
                }
            }
            let size = libm::hypot(local.a[0][0], local.a[1][0]);
            let unit = unit(size.max(self.friction).max(speed / local.left).min(FASTEST));
            sliding.prepare(&local.a, self.friction, unit);
            let mut integrator = Integrator::resume(&sliding, start, (carry, work), Control::Each);
            let mut step = Box::new(Step::empty());
            integrator.expand(&mut step)?;
            // No further than a constant speed would take it four times.
            step.h = step.h.min(4.0 * local.left * unit / speed);
            let mut landing = None;
            if step.elapsed() >= local.left {
                step.h = step.s_at(local.left);
                landing = local.landing;
            }
            memory -= step.h * size / unit;
            integrator.advance(&step);
            if let Some(t) = landing {
                integrator.set(2, t);
            }
            (start, (carry, work)) = integrator.finish();
            drop_negligible(&mut start, &mut carry);
            let [vx, vy, t, x, y] = start;
            self.push(
                Piece::Slide(step),
                State {
                    t,
                    v: [vx, vy],
                    x: [x, y],
                },
            );
            if self.stops(fastest) {
                return Ok(true);
            }
        }
        Ok(false)
    }

    fn stops(&mut self, fastest: f64) -> bool {
        let State { t, v, x } = self.state;
        let speed = self.state.speed();
        let still = self.holding > self.friction && speed <= STILL * fastest;
        if speed > LAST * fastest && !still || t >= self.until {
            return false;
        }
        let a = self.plane.coefficients(t).map(|c| c[0]);
        let size = libm::hypot(a[0], a[1]);
        let against = (a[0] * v[0] + a[1] * v[1]) / speed;
        let rate = self.friction + against;
        // The worst that can come is a turn towards −A.
        let held = speed * (self.friction + size) <= LAST * fastest * (self.friction - size);
        // Nothing turns the velocity but rounding, by an angle that grows as the speed falls.
        let across = (a[0] * v[1] - a[1] * v[0]).abs();
        let straight = across <= STRAIGHT * size * speed && against >= 0.0;
        let still = still && size <= self.holding;
        if !(rate > 0.0 && (held || still || straight || speed <= NEGLIGIBLE * fastest)) {
            return false;
        }
        let left = speed / rate;
        let to = t + left;
        if to > self.until || self.plane.next_break(t).is_some_and(|b| to > b) {
            return false;
        }
        let mut arc = [[[0.0; TERMS]; 2]; 2];
        let [velocity, position] = &mut arc;
        let mut end = x;
        for i in 0..2 {
            velocity[i][..2].copy_from_slice(&[v[i], -v[i] / left]);
            position[i][..3].copy_from_slice(&[x[i], v[i], -0.5 * v[i] / left]);
            end[i] += 0.5 * v[i] * left;
        }
        let piece = Piece::Arc(Box::new(Arc {
            from: t,
            to,
            v: arc[0],
            x: arc[1],
        }));
        self.push(
            piece,
            State {
                t: to,
                v: [0.0; 2],
                x: end,
            },
        );
        true
    }
}

impl Sliding {
    fn prepare(&mut self, a: &[Coefficients; 2], friction: f64, unit: f64) {
        // A power of two: its inverse is exact.
        self.slowness = 1.0 / unit;
        let last =
            |series: &Coefficients| series.iter().rposition(|c| *c != 0.0).map_or(0, |k| k + 1);
        self.terms = last(&a[0]).max(last(&a[1]));
        for (scaled, a) in self.a.iter_mut().zip(a) {
            for (scaled, c) in scaled.iter_mut().zip(a).take(self.terms.max(1)) {
                *scaled = c * self.slowness;
            }
        }
        self.friction = friction * self.slowness;
    }
}

/// The power of two next below `size`.
fn unit(size: f64) -> f64 {
    libm::exp2(libm::floor(libm::log2(size)))
}

fn drop_negligible(state: &mut [f64; 5], carry: &mut [f64; 5]) {
    let (x, y) = (state[0].abs(), state[1].abs());
    if x < NEGLIGIBLE * y {
        (state[0], carry[0]) = (0.0, 0.0);
    }
    if y < NEGLIGIBLE * x {
        (state[1], carry[1]) = (0.0, 0.0);
    }
}
