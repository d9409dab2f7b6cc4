//! The state at a time, in numbers of any width and as close to rest as they can say.

use super::{
    intrinsic::{Exact, Tracked},
    slow::{Slow, Width},
};
use crate::error::MotionError;
use crate::numerics::{
    series::{arrival, change, value},
    taylor::{Control, Integrator, Step, System},
};

/// A state on the way, by components along and across the velocity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moment<T> {
    /// Speed; 0 at rest.
    pub p: T,
    /// ξ = ρ·v̂.
    pub xi: T,
    /// η = ρ·n̂.
    pub eta: T,
    /// By how much the velocity has turned since the start.
    pub turned: T,
    /// So close to rest at ρ = 1 that the slow equations were used.
    pub slow: bool,
}

impl<T> Moment<T> {
    pub fn map<U>(self, f: impl Fn(T) -> U) -> Moment<U> {
        let [p, xi, eta, turned] = [self.p, self.xi, self.eta, self.turned].map(f);
        Moment {
            p,
            xi,
            eta,
            turned,
            slow: self.slow,
        }
    }
}

const STEPS: usize = 200_000;

/// From rest at ρ > 1 a particle is followed from where its speed is this part of what drives it.
const ONSET: f64 = 1e-20;

/// The state at the time `until`, by series of `N` terms. A particle that starts from rest at ρ > 1 starts straight
/// away from the axis.
///
/// # Errors
/// [`MotionError::Steps`] after 200,000 steps, [`MotionError::Numerics`] when numbers overflow.
pub fn moment<T: Width, const N: usize>(
    start: &Exact<T>,
    until: T,
) -> Result<Moment<T>, MotionError> {
    let [zero, one] = [0.0, 1.0].map(T::from_f64);
    let mut state = [zero, start.p, start.deficit, start.zeta, zero, zero];
    let slow = Slow::<T>::new();
    if start.p == zero {
        if start.deficit >= zero {
            return Ok(still(start.deficit));
        }
        // The way out of rest: ζ = −p/(1 − 2w), and dw² = (ζ/p)² dp².
        let p = -start.deficit * T::from_f64(ONSET);
        let zeta = -(p / (one - start.deficit - start.deficit));
        state[0] = p / -start.deficit;
        (state[1], state[3]) = (p, zeta);
        if until <= state[0] {
            return Ok(Moment {
                p: -start.deficit * until,
                ..still(start.deficit)
            });
        }
    }
    let (mut taken, mut slowly) = (0, false);
    loop {
        let [tau, p, w, zeta, turned, s] = state;
        let leg = if slow.serves(p, w, zeta) {
            slowly = true;
            let begin = [tau, p, w, turned, s];
            let leave = |x: &[T; 5]| !slow.serves(x[1], x[2], slow.zeta(x[1], x[2]));
            match go::<T, _, 5, N>(&slow, begin, until, &mut taken, leave)? {
                Leg::Left([tau, p, w, turned, s]) => {
                    Leg::Left([tau, p, w, slow.zeta(p, w), turned, s])
                }
                Leg::There([tau, p, w, turned, s]) => {
                    Leg::There([tau, p, w, slow.zeta(p, w), turned, s])
                }
                Leg::Rests([tau, p, w, turned, s]) => {
                    Leg::Rests([tau, p, w, slow.zeta(p, w), turned, s])
                }
            }
        } else {
            let enter = |x: &[T; 6]| slow.serves(x[1], x[2], x[3]);
            go::<T, _, 6, N>(&Tracked, state, until, &mut taken, enter)?
        };
        match leg {
            Leg::Left(next) => state = next,
            Leg::There([_, p, w, zeta, turned, _]) => {
                return Ok(Moment {
                    p,
                    xi: one - w,
                    eta: p - zeta,
                    turned,
                    slow: slowly,
                });
            }
            // The direction of a velocity that is gone may go on turning.
            Leg::Rests([_, _, w, zeta, turned, _]) => {
                return Ok(Moment {
                    p: zero,
                    xi: one - w,
                    eta: -zeta,
                    turned,
                    slow: slowly,
                });
            }
        }
    }
}

/// Friction outweighs the pull by `w` in the direction of its velocity.
fn still<T: Width>(w: T) -> Moment<T> {
    let [zero, one] = [0.0, 1.0].map(T::from_f64);
    Moment {
        p: zero,
        xi: one - w,
        eta: zero,
        turned: zero,
        slow: false,
    }
}

/// Where its equations end, at the time wanted, or at rest.
enum Leg<T, const D: usize> {
    Left([T; D]),
    There([T; D]),
    Rests([T; D]),
}

fn go<T: Width, S: System<T, D, N>, const D: usize, const N: usize>(
    law: &S,
    begin: [T; D],
    until: T,
    taken: &mut usize,
    over: impl Fn(&[T; D]) -> bool,
) -> Result<Leg<T, D>, MotionError> {
    let mut integrator = Integrator::<_, _, D, N>::new(law, T::from_f64(0.0), begin, Control::Each);
    let mut step = Step::empty();
    loop {
        let state = *integrator.state();
        let (tau, p, w) = (state[0], state[1], state[2]);
        let left = until - tau;
        if left.to_f64() <= 0.0 {
            return Ok(Leg::There(state));
        }
        // What is left of the time, p/w, is below the spacing of the numbers.
        if p.magnitude() <= T::ROUNDING * T::ROUNDING * w.to_f64() {
            return Ok(Leg::Rests(state));
        }
        if over(&state) {
            return Ok(Leg::Left(state));
        }
        *taken += 1;
        if *taken > STEPS {
            let t = tau.to_f64();
            return Err(MotionError::Steps { limit: STEPS, t });
        }
        integrator.expand(&mut step)?;
        if change(&step.series[0], &T::from_f64(step.h)) >= left {
            return Ok(Leg::There(step.at(&when(&step.series[0], left, step.h))));
        }
        integrator.advance(&step);
    }
}

/// Within a step: its clock has gone on by `left` there.
fn when<T: Width, const N: usize>(clock: &[T; N], left: T, h: f64) -> T {
    let rough = clock.map(T::to_f64);
    let mut at = T::from_f64(arrival(&rough, left.to_f64(), h));
    let slope: [T; N] = std::array::from_fn(|k| match clock.get(k + 1) {
        Some(c) => *c * T::from_f64((k + 1) as f64),
        None => T::from_f64(0.0),
    });
    for _ in 0..3 {
        at = at - (change(clock, &at) - left) / value(&slope, &at);
    }
    at
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::{double::Double, number::Real};
    use crate::turntable::Start;

    /// dp/dτ = ρ − 1 at first; before and behind the moment from which it is followed step by step.
    #[test]
    fn out_of_rest_the_speed_grows_from_the_first_moment() {
        for rho in [1.5, 3.0] {
            let start = Exact::polar(rho, 0.0, 0.0);
            for until in [1e-40, 1e-21, 0.999e-20, 1.001e-20, 1e-18, 1e-12] {
                let there = moment::<f64, 24>(&start, until).unwrap();
                let share = there.p / ((rho - 1.0) * until);
                assert!((share - 1.0).abs() < 1e-11, "{rho} {until}: {share}");
                assert!((there.xi - rho).abs() < 1e-11 && there.eta.abs() < 1e-11);
                assert!(there.turned.abs() < 1e-11);
            }
        }
        let still = moment::<f64, 24>(&Exact::polar(1.0, 0.0, 0.0), 1e3).unwrap();
        assert_eq!((still.p, still.xi), (0.0, 1.0));
    }

    /// Near rest at ρ = 1, by the slow equations; numbers of twice the width leave them sooner.
    #[test]
    fn a_motion_that_has_hovered_goes_as_in_wider_numbers() {
        for (rho, p) in [(0.9999, 1.1e-4), (0.9995, 5.5e-4), (0.999, 1.2e-3)] {
            let start = Start::polar(rho, p, 0.0).unwrap();
            for until in [5.0, 8.0, 11.0, 14.0, 17.0] {
                let near = moment::<f64, 24>(&Exact::from(&start), until).unwrap();
                let wide = moment::<Double, 44>(&Exact::from(&start), until.into()).unwrap();
                let off = |a: f64, b: Double| (a - b.to_f64()).abs() / (1e-3 + b.to_f64().abs());
                let off = [
                    off(near.p, wide.p),
                    off(near.xi, wide.xi),
                    off(near.eta, wide.eta),
                ];
                assert!(off.iter().all(|off| *off < 1e-9), "{rho} {until} {off:?}");
            }
        }
    }
}
