//! An adaptive integrator by Taylor series of high order, whose last two coefficients tell how far to trust
//! them (Jorba and Zou, "A software package for the numerical integration of ODEs by means of high-order
//! Taylor methods", Exp. Math. 14, 2005, section 3.2). Times and states are summed with a carry.

use super::{
    error::NumericsError,
    lanes::{Wide, widest},
    number::Number,
    series::{Series, changes, value},
};

/// Order 26 serves f64 well.
pub const TERMS: usize = 27;

/// Taylor coefficients by the time, to the order of the integrator.
pub type Coefficients = [f64; TERMS];

/// A system of `D` ordinary differential equations x′ = f(t, x), by its series of `N` terms.
pub trait System<T: Number, const D: usize, const N: usize> {
    /// Series that the system keeps for itself during a step.
    type Work: Default;

    /// Prepares for a step that begins at time `t` in `state`.
    fn begin(&self, t: &T, state: &[T; D], work: &mut Self::Work);

    /// Coefficient `k` of x′, from the coefficients of `x` up to `k`; called for k = 0, 1, 2, … in turn.
    fn derivative(&self, k: usize, x: &[Series<T, N>; D], work: &mut Self::Work) -> [T; D];
}

/// In units of what the last terms of a step have to be small.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Control {
    /// Of each component by itself (of its own change, where it passes through zero).
    Each,
    /// Of the largest component.
    Largest,
}

struct Expansion<'e, S, T, const D: usize, const N: usize>
where
    T: Number,
    S: System<T, D, N>,
{
    system: &'e S,
    state: &'e [T; D],
    work: &'e mut S::Work,
    series: &'e mut [Series<T, N>; D],
}

impl<S, T, const D: usize, const N: usize> Wide for Expansion<'_, S, T, D, N>
where
    T: Number,
    S: System<T, D, N>,
{
    type Output = ();

    #[inline(always)]
    fn call<const WIDTH: usize>(self) {
        let series = self.series;
        for (x, start) in series.iter_mut().zip(self.state) {
            x[0] = start.clone();
        }
        for k in 0..N - 1 {
            let slope = self.system.derivative(k, series, self.work);
            for (x, d) in series.iter_mut().zip(slope) {
                x[k + 1] = d.over(k + 1);
            }
        }
    }
}

/// One step: the series of the state about its beginning.
#[derive(Debug, Clone, PartialEq)]
pub struct Step<T, const D: usize, const N: usize> {
    /// Time at the beginning.
    pub t: T,
    /// Length over which the series is used; infinite where the series ends before its last two terms.
    pub h: f64,
    /// Coefficients of each component.
    pub series: [Series<T, N>; D],
}

impl<T: Number, const D: usize, const N: usize> Step<T, D, N> {
    /// A step to be [expanded](Integrator::expand).
    pub fn empty() -> Self {
        let zero = || T::from_f64(0.0);
        Self {
            t: zero(),
            h: 0.0,
            series: std::array::from_fn(|_| std::array::from_fn(|_| zero())),
        }
    }

    /// State at a distance from the beginning of the step, as good as the nodes for distances from 0 to `h`.
    pub fn at(&self, distance: &T) -> [T; D] {
        std::array::from_fn(|i| value(&self.series[i], distance))
    }
}

/// The state of an integration under way.
pub struct Integrator<'a, S, T, const D: usize, const N: usize>
where
    T: Number,
    S: System<T, D, N>,
{
    system: &'a S,
    control: Control,
    work: S::Work,
    t: T,
    t_carry: T,
    state: [T; D],
    carry: [T; D],
}

impl<'a, S, T, const D: usize, const N: usize> Integrator<'a, S, T, D, N>
where
    T: Number,
    S: System<T, D, N>,
{
    /// An integration of `system` that begins at time `t` in `state`.
    pub fn new(system: &'a S, t: T, state: [T; D], control: Control) -> Self {
        let zero = || T::from_f64(0.0);
        Self {
            system,
            control,
            work: S::Work::default(),
            t,
            t_carry: zero(),
            state,
            carry: std::array::from_fn(|_| zero()),
        }
    }

    /// Goes on with what an earlier integration [finished](Self::finish), for a system that does not depend
    /// on the time.
    pub fn resume(
        system: &'a S,
        state: [T; D],
        (carry, work): ([T; D], S::Work),
        control: Control,
    ) -> Self {
        Self {
            carry,
            work,
            ..Self::new(system, T::from_f64(0.0), state, control)
        }
    }

    /// The state, what rounding has taken from each component, and the work space.
    pub fn finish(self) -> ([T; D], ([T; D], S::Work)) {
        (self.state, (self.carry, self.work))
    }

    /// Time reached.
    pub fn t(&self) -> &T {
        &self.t
    }

    /// State reached.
    pub fn state(&self) -> &[T; D] {
        &self.state
    }

    /// Replaces one component of the state, exactly.
    pub fn set(&mut self, component: usize, value: T) {
        self.state[component] = value;
        self.carry[component] = T::from_f64(0.0);
    }

    /// Fills a step with the series about the present state and the length (positive) over which it holds.
    ///
    /// # Errors
    /// [`NumericsError::NotFinite`] when the state or a coefficient is infinite or NaN.
    pub fn expand(&mut self, step: &mut Step<T, D, N>) -> Result<(), NumericsError> {
        self.system.begin(&self.t, &self.state, &mut self.work);
        step.t = self.t.clone();
        let series = &mut step.series;
        widest(Expansion {
            system: self.system,
            state: &self.state,
            work: &mut self.work,
            series,
        });
        // Every one, without a look in between.
        let finite = |fine, c: &T| fine & c.magnitude().is_finite();
        if !series.iter().flatten().fold(true, finite) {
            return Err(NumericsError::NotFinite {
                what: "a Taylor coefficient of the state",
                at: self.t.magnitude(),
            });
        }
        step.h = libm::exp2(match self.control {
            Control::Each => series
                .iter()
                .map(|x| log2_reach(x, T::TOLERANCE_LOG2))
                .fold(f64::INFINITY, f64::min),
            Control::Largest => {
                let largest: [f64; N] = std::array::from_fn(|k| {
                    series.iter().map(|x| x[k].magnitude()).fold(0.0, f64::max)
                });
                log2_reach(&largest, T::TOLERANCE_LOG2)
            }
        });
        Ok(())
    }

    /// Goes `step.h` (finite, either sign) along a step that [`expand`](Self::expand) has just given.
    pub fn advance(&mut self, step: &Step<T, D, N>) {
        let h = T::from_f64(step.h);
        let deltas = changes(&step.series, &h);
        for (i, delta) in deltas.into_iter().enumerate() {
            (self.state[i], self.carry[i]) = T::accumulate(&self.state[i], &self.carry[i], &delta);
        }
        (self.t, self.t_carry) = T::accumulate(&self.t, &self.t_carry, &h);
    }
}

/// How far a series may be trusted: the largest h at which its last two terms (the last eight, where those
/// are zero) are below the tolerance times one of its first four, from where these begin; may be infinite.
pub fn reach<T: Number>(x: &[T]) -> f64 {
    libm::exp2(log2_reach(x, T::TOLERANCE_LOG2))
}

#[inline(always)]
fn log2_reach<T: Number>(x: &[T], tolerance: f64) -> f64 {
    // The exponent field of zero stands for −∞; no quotient with it is the largest.
    let first = |from: usize| -> [f64; 4] {
        std::array::from_fn(|k| x.get(from + k).map_or(f64::NEG_INFINITY, log2))
    };
    let is_zero = |size: &f64| *size == f64::NEG_INFINITY;
    let (mut from, mut sizes) = (0, first(0));
    if sizes.iter().all(is_zero) {
        from = x.iter().take_while(|c| is_zero(&log2(*c))).count();
        sizes = first(from);
    }
    let gap = x.iter().rev().take(2).all(|c| is_zero(&log2(c)));
    let counted = x.len().saturating_sub(if gap { 8 } else { 2 });
    let mut least = f64::INFINITY;
    for (n, c) in x.iter().enumerate().skip(counted.max(from + 4)) {
        let last = log2(c);
        let mut best = f64::NEG_INFINITY;
        for (k, size) in sizes.iter().enumerate() {
            let room = (tolerance + size - last).over(n - from - k);
            best = if room > best { room } else { best };
        }
        if last > f64::NEG_INFINITY && best > f64::NEG_INFINITY && best < least {
            least = best;
        }
    }
    least
}

/// To within 0.09, from the bits of the number; −∞ for zero.
#[inline(always)]
fn log2<T: Number>(x: &T) -> f64 {
    let bits = x.magnitude().to_bits();
    // So few bits that the sum is exact: a power of two as a factor then changes nothing else.
    let log2 = f64::from((bits >> 32) as i32) / f64::from(1 << 20) - 1023.0;
    if bits == 0 { f64::NEG_INFINITY } else { log2 }
}

/// A finished integration: its steps in order.
#[derive(Debug, Clone, PartialEq)]
pub struct Path<const D: usize, const N: usize> {
    /// The last one ends at the end of the integration.
    pub steps: Vec<Step<f64, D, N>>,
    /// State at the end.
    pub end: [f64; D],
    /// Time at the end.
    pub t: f64,
}

impl<const D: usize, const N: usize> Path<D, N> {
    /// State at time `t`.
    ///
    /// # Errors
    /// [`NumericsError::Outside`] for a time that was not integrated over.
    pub fn at(&self, t: f64) -> Result<[f64; D], NumericsError> {
        let from = self.steps.first().map_or(self.t, |step| step.t);
        let outside = NumericsError::Outside {
            at: t,
            from,
            to: self.t,
        };
        let way = self.t - from;
        if t == self.t {
            return Ok(self.end);
        }
        if !((t - from) * way >= 0.0 && (self.t - t) * way > 0.0) {
            return Err(outside);
        }
        let index = self.steps.partition_point(|step| (t - step.t) * way >= 0.0);
        let step = &self.steps[index.saturating_sub(1)];
        Ok(step.at(&(t - step.t)))
    }
}

/// Integrates `system` from `from` to `to`, forwards or backwards, and keeps all steps.
///
/// # Errors
/// [`NumericsError::Argument`] for a time that is not finite, [`NumericsError::NotFinite`] when the state
/// leaves the finite numbers, [`NumericsError::Limit`] after `max_steps` steps.
pub fn integrate<S: System<f64, D, N>, const D: usize, const N: usize>(
    system: &S,
    from: f64,
    state: [f64; D],
    to: f64,
    control: Control,
    max_steps: usize,
) -> Result<Path<D, N>, NumericsError> {
    super::error::finite("from", from)?;
    super::error::finite("to", to)?;
    let mut integrator = Integrator::new(system, from, state, control);
    let mut steps = Vec::new();
    loop {
        let left = (to - integrator.t) - integrator.t_carry;
        if left == 0.0 || integrator.t == to {
            if integrator.state.iter().any(|x| !x.is_finite()) {
                return Err(NumericsError::NotFinite {
                    what: "the state",
                    at: to,
                });
            }
            return Ok(Path {
                steps,
                end: integrator.state,
                t: to,
            });
        }
        if steps.len() >= max_steps {
            let at = integrator.t;
            return Err(NumericsError::Limit {
                what: "steps of the Taylor integrator",
                limit: max_steps,
                at,
            });
        }
        let mut step = Step::empty();
        integrator.expand(&mut step)?;
        let last = step.h >= left.abs();
        step.h = if last { left } else { step.h.copysign(left) };
        integrator.advance(&step);
        if last {
            (integrator.t, integrator.t_carry) = (to, 0.0);
        }
        steps.push(step);
    }
}

#[cfg(all(test, feature = "trials"))]
mod tests;
