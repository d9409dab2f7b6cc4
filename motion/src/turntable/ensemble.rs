//! Many particles on the table at once: each is followed until it rests, is far out, or its time is up. Eight share a vector
//! register. One for which these steps are too rough, close to the border of rest and escape, is followed once more, alone.

use super::{
    fate::{self, Speeds, judge},
    intrinsic::{Exact, Law, Start, check},
    slow::{Slow, Width},
};
use crate::error::MotionError;
use crate::numerics::{
    batch::Batch,
    double::Double,
    lanes::{Lanes, Wide, widest},
    number::Real,
    series::{arrival, value},
    taylor::{Control, Integrator, Step},
};
#[cfg(feature = "parallel")]
use rayon::prelude::*;
use std::sync::LazyLock;

/// How long a particle of an ensemble is followed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Horizon {
    /// Distance from the axis, in units of μg/Ω².
    pub rho: f64,
    /// Time, in units of 1/Ω.
    pub tau: f64,
}

static NARROW: LazyLock<Slow<f64>> = LazyLock::new(Slow::new);
static WIDE: LazyLock<Slow<Double>> = LazyLock::new(Slow::new);

/// How a particle's way ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum End {
    /// It comes to rest.
    Rest {
        /// Distance σ from the axis,
        sigma: f64,
        /// and how closely it is known: to 10⁻⁸ or better, unless 1 − σ is below 10⁻⁴.
        sigma_error: f64,
        /// When,
        tau: f64,
        /// and how closely that is known.
        tau_error: f64,
    },
    /// It crosses the horizon's distance, or starts moving beyond it.
    Far {
        /// When,
        tau: f64,
        /// and how closely that is known: to 10⁻⁷ of itself or better, unless it passed the border of rest closely.
        tau_error: f64,
    },
    /// It does neither within the horizon's time.
    Late(Start),
    /// So close to the border of rest and escape that the rounding of the start decides.
    Unfinished(Start),
}

/// Steps after which a particle is followed alone: a hundred times those that all but a few need.
pub const STEPS: u32 = 5000;

/// Terms of the series, and binary logarithm of the size that the last two may have.
const TERMS: usize = 20;
const TOLERANCE: f64 = -40.0;

/// Of the series of a particle that is followed alone, in both kinds of numbers.
const CLOSELY: usize = 24;
const EXACTLY: usize = 44;

/// A rest is looked for below this p²/w.
const SLOW: f64 = 1e-6;

/// Wanted half-width of the bounds of σ.
const RADIUS: f64 = 2e-10;

/// Less than 2^TOLERANCE, as measured.
const LOST: f64 = 7e-13;

/// In spacings of its numbers, at most.
const LOST_ALONE: f64 = 64.0;

/// Steps of many know a speed to what they cost beside 1. What begins slower is followed alone.
const FAST: f64 = 1e-3;

/// By no more than this the friction's lead may weaken in the last moments.
const WEAKENING: f64 = 1e-4;

/// What comes closer to p = w = 0 is followed alone.
const BRINK: f64 = 0.001;

const PIECE: usize = 1024;

impl Horizon {
    /// The ends of these particles' ways, in their order. Only a start that no constructor of [`Start`] gives, or one at rest
    /// beyond ρ = 1 (it starts by itself, at a time of its own), has none. With the feature `parallel` all cores share the work;
    /// the result does not depend on how.
    ///
    /// Cost: for each some fifty steps as a rule, and at most [`STEPS`] before it is followed alone.
    ///
    /// # Errors
    /// [`MotionError::Argument`] for a horizon that is not positive or above 10⁶.
    pub fn follow(&self, starts: &[Start]) -> Result<Vec<Result<End, MotionError>>, MotionError> {
        self.check()?;
        let ends = |piece| self.each(piece);
        #[cfg(feature = "parallel")]
        let pieces = starts.par_chunks(PIECE).flat_map_iter(ends);
        #[cfg(not(feature = "parallel"))]
        let pieces = starts.chunks(PIECE).flat_map(ends);
        Ok(pieces.collect())
    }

    /// As [`follow`](Self::follow), on one core.
    ///
    /// # Errors
    /// As for [`follow`](Self::follow).
    pub fn follow_alone(
        &self,
        starts: &[Start],
    ) -> Result<Vec<Result<End, MotionError>>, MotionError> {
        self.check()?;
        Ok(starts
            .chunks(PIECE)
            .flat_map(|piece| self.each(piece))
            .collect())
    }

    fn each(&self, starts: &[Start]) -> Vec<Result<End, MotionError>> {
        let fit = |start: &&Start| moves(start).is_ok();
        let followed: Vec<_> = starts.iter().filter(fit).copied().collect();
        let mut ends = self.piece(&followed).into_iter();
        let end = |start: &Start| {
            moves(start)?;
            Ok(ends.next().unwrap_or(End::Unfinished(*start)))
        };
        starts.iter().map(end).collect()
    }

    /// The end of one particle's way from the distance `rho`, the speed `p` and the angle `psi` (radians), taken as exact, in
    /// numbers of twice the width: also where rounding to `f64` would decide. Some hundred times the work of
    /// [`follow`](Self::follow).
    ///
    /// # Errors
    /// As for [`follow`](Self::follow) and [`Start::polar`].
    pub fn follow_exactly(&self, rho: Double, p: Double, psi: Double) -> Result<End, MotionError> {
        let near = Start::polar(rho.to_f64(), p.to_f64(), psi.to_f64())?;
        self.check()?;
        moves(&near)?;
        let exact = Exact::polar(rho, p, psi);
        let end = self.closely::<_, EXACTLY>(exact, &WIDE);
        Ok(end.unwrap_or(End::Unfinished(near)))
    }

    fn check(&self) -> Result<(), MotionError> {
        for (name, value) in [("rho", self.rho), ("tau", self.tau)] {
            let allowed = value > 0.0 && value <= 1e6;
            super::argument(name, value, allowed, "positive, at most 1e6")?;
        }
        Ok(())
    }
}

fn moves(start: &Start) -> Result<(), MotionError> {
    check(start)?;
    let moves = start.p > 0.0 || start.rho() <= 1.0;
    super::argument("p", start.p, moves, "positive where rho > 1")
}

#[derive(Clone, Copy)]
struct Extremes {
    /// How close it came to p = w = 0.
    brink: f64,
    most: f64,
}

trait Watch {
    type End: Clone;

    fn over<const L: usize>(&self, states: &[Lanes<L>; 4]) -> [bool; L];

    fn end(
        &self,
        series: impl FnOnce() -> [[f64; TERMS]; 4],
        h: f64,
        state: &[f64; 4],
        extremes: Extremes,
    ) -> Option<Self::End>;

    /// An end that the steps of many do not find, or not well.
    fn alone(&self, start: &Start) -> Self::End;

    fn is_for_many(&self, start: &Start) -> bool;

    fn is_rough(end: &Self::End, extremes: Extremes) -> bool;

    fn piece(&self, starts: &[Start]) -> Vec<Self::End>
    where
        Self: Sized,
    {
        struct Piece<'a, W>(&'a W, &'a [Start]);
        impl<W: Watch> Wide for Piece<'_, W> {
            type Output = Vec<W::End>;
            #[inline(always)]
            fn call<const WIDTH: usize>(self) -> Vec<W::End> {
                // As many as are fastest: with four in a register, thirty-two take a sixth less time than sixteen.
                match WIDTH {
                    4 => self.0.run::<32>(self.1),
                    _ => self.0.run::<16>(self.1),
                }
            }
        }
        widest(Piece(self, starts))
    }

    #[inline(always)]
    fn run<const L: usize>(&self, starts: &[Start]) -> Vec<Self::End> {
        let mut ends = vec![None; starts.len()];
        let ours = |(_, start): &(usize, &Start)| self.is_for_many(start);
        let mut waiting = starts.iter().enumerate().filter(ours);
        let mut batch = Batch::<4, TERMS, L>::new();
        let mut riders: [Option<(usize, u32)>; L] = [None; L];
        let mut brink = Lanes::<L>::all(f64::INFINITY);
        let mut most = Lanes::<L>::all(0.0);
        let mut board = |lane: usize, batch: &mut Batch<4, TERMS, L>| {
            let next = waiting.next();
            let rest = [0.0, 0.0, 1.0, 0.0];
            let state = next.map_or(rest, |(_, start)| {
                [0.0, start.p, 1.0 - start.xi, start.zeta]
            });
            batch.set(lane, &state);
            (next.map(|(index, _)| (index, 0)), state[1])
        };
        for (lane, rider) in riders.iter_mut().enumerate() {
            (*rider, most.0[lane]) = board(lane, &mut batch);
        }
        while riders.iter().any(Option::is_some) {
            batch.expand(&Law);
            let h = batch.reach(TOLERANCE);
            let states = batch.after(&h);
            let [_, p, w, _] = states;
            brink = brink.min(p.max(w.abs()));
            most = most.max(p);
            let over = self.over(&states);
            if over.iter().any(|over| *over) {
                for lane in 0..L {
                    let Some((index, _)) = riders[lane].filter(|_| over[lane]) else {
                        continue;
                    };
                    let state = states.map(|x| x.0[lane]);
                    let extremes = Extremes {
                        brink: brink.0[lane],
                        most: most.0[lane],
                    };
                    let series = || batch.lane(lane);
                    if let Some(end) = self.end(series, h.0[lane], &state, extremes) {
                        let rough = Self::is_rough(&end, extremes);
                        ends[index] = (!rough).then_some(end);
                        riders[lane] = None;
                    }
                }
            }
            batch.go(&states);
            for (lane, rider) in riders.iter_mut().enumerate() {
                if let Some((_, steps)) = rider {
                    *steps += 1;
                    if *steps < STEPS {
                        continue;
                    }
                }
                (*rider, most.0[lane]) = board(lane, &mut batch);
                brink.0[lane] = f64::INFINITY;
            }
        }
        let pairs = ends.into_iter().zip(starts);
        pairs
            .map(|(end, start)| end.unwrap_or_else(|| self.alone(start)))
            .collect()
    }
}

impl Watch for Horizon {
    type End = End;

    #[inline(always)]
    fn over<const L: usize>(&self, states: &[Lanes<L>; 4]) -> [bool; L] {
        let [tau, p, w, zeta] = states;
        let (xi, eta) = (Lanes::all(1.0) - *w, *p - *zeta);
        let square = xi * xi + eta * eta;
        let slow = *p * *p - Lanes::all(SLOW) * *w;
        let far = self.rho * self.rho;
        let mut over = [false; L];
        for (i, over) in over.iter_mut().enumerate() {
            *over = slow.0[i] < 0.0 || square.0[i] > far || tau.0[i] > self.tau;
        }
        over
    }

    fn end(
        &self,
        series: impl FnOnce() -> [[f64; TERMS]; 4],
        h: f64,
        state: &[f64; 4],
        Extremes { brink, most }: Extremes,
    ) -> Option<End> {
        let amplified = 1.0 / (brink * brink);
        self.ended(series, h, state, [LOST, amplified])
            .or_else(|| settled(state, most))
    }

    fn alone(&self, start: &Start) -> End {
        let end = self.closely::<f64, CLOSELY>(Exact::from(start), &NARROW);
        end.unwrap_or(End::Unfinished(*start))
    }

    fn is_for_many(&self, start: &Start) -> bool {
        start.p == 0.0 || start.p >= FAST && !self.is_beyond(start)
    }

    fn is_rough(end: &End, extremes: Extremes) -> bool {
        extremes.brink < BRINK && !matches!(end, End::Late(_))
    }
}

impl Horizon {
    /// If it lies in this step. What was `lost` on the way is by so much more, `amplified`, close to the border of rest.
    fn ended<const N: usize>(
        &self,
        series: impl FnOnce() -> [[f64; N]; 4],
        h: f64,
        state: &[f64; 4],
        [lost, amplified]: [f64; 2],
    ) -> Option<End> {
        let excess = |[p, w, zeta]: [f64; 3]| {
            let (xi, eta) = (1.0 - w, p - zeta);
            (xi * xi + eta * eta - self.rho * self.rho, 2.0 * p * p * xi)
        };
        let [after, p, w, zeta] = *state;
        let far = excess([p, w, zeta]).0 > 0.0;
        if !far && after <= self.tau {
            return None;
        }
        let series = series();
        let at = |i: usize, h: f64| value(&series[i], &h);
        if far {
            const { assert!(N.is_multiple_of(2)) };
            // Six sums side by side, of even powers and of odd: none waits for itself.
            let parts = |h: f64| {
                let (mut even, mut odd) = ([0.0; 3], [0.0; 3]);
                for k in (0..N).step_by(2).rev() {
                    for (i, series) in series[1..].iter().enumerate() {
                        even[i] = even[i] * (h * h) + series[k];
                        odd[i] = odd[i] * (h * h) + series[k + 1];
                    }
                }
                [0, 1, 2].map(|i| odd[i] * h + even[i])
            };
            let h = crossing(h, |h| excess(parts(h)));
            let tau = at(0, h);
            if tau <= self.tau {
                // A place is rounded, and crosses at the rate dρ/dτ = pξ/ρ.
                let [p, w, _] = parts(h);
                let rounded = 2.0 * f64::EPSILON * self.rho * self.rho / (p * (1.0 - w));
                return Some(End::Far {
                    tau,
                    tau_error: lost * (tau + amplified) + rounded.abs(),
                });
            }
        }
        (after > self.tau).then(|| {
            let h = crossing(h, |h| (at(0, h) - self.tau, at(1, h)));
            End::Late(start_of(&[0, 1, 2, 3].map(|i| at(i, h))))
        })
    }

    fn is_beyond(&self, start: &Start) -> bool {
        start.p > 0.0 && start.rho() >= self.rho
    }

    /// By shorter steps and by the slow equations; nothing where rounding decides.
    fn closely<T: Width, const N: usize>(&self, start: Exact<T>, slow: &Slow<T>) -> Option<End> {
        let zero = T::from_f64(0.0);
        let mut state = [zero, start.p, start.deficit, start.zeta];
        if self.is_beyond(&start_of(&state.map(T::to_f64))) {
            return Some(End::Far {
                tau: 0.0,
                tau_error: 0.0,
            });
        }
        let lost = LOST_ALONE * T::ROUNDING;
        let (mut brink, mut speeds) = (f64::INFINITY, Speeds::default());
        // Into the slow equations and out again at most.
        for _ in 0..3 {
            let mut fast = Integrator::<_, _, 4, N>::new(&Law, zero, state, Control::Each);
            let mut step = Step::empty();
            let [tau, p, w] = loop {
                let &[tau, p, w, zeta] = fast.state();
                brink = brink.min(p.magnitude().max(w.magnitude()));
                speeds.most = speeds.most.max(p.to_f64());
                if let Some(end) = ends_closely(fast.state(), speeds) {
                    return Some(end);
                }
                if slow.serves(p, w, zeta) {
                    break [tau, p, w];
                }
                fast.expand(&mut step).ok()?;
                fast.advance(&step);
                let amplified = speeds.entry.unwrap_or(brink) / (brink * brink);
                let series = || step.series.each_ref().map(|row| row.map(T::to_f64));
                let there = fast.state().map(T::to_f64);
                if let Some(end) = self.ended(series, step.h, &there, [lost, amplified]) {
                    // It went away from the brink at which it was slowest; a start that is rounded may have come to rest.
                    return (amplified * T::ROUNDING < 1.0).then_some(end);
                }
            };
            speeds.entry = Some(p.to_f64());
            let begin = [tau, p, w, zero, zero];
            let mut slowly = Integrator::<_, _, 5, N>::new(slow, zero, begin, Control::Each);
            let mut step = Step::empty();
            state = loop {
                let &[tau, p, w, ..] = slowly.state();
                brink = brink.min(p.magnitude().max(w.magnitude()));
                let state = [tau, p, w, slow.zeta(p, w)];
                if let Some(end) = ends_closely(&state, speeds) {
                    return Some(end);
                }
                if p.magnitude() < T::ROUNDING {
                    return None;
                }
                if !slow.serves(p, w, state[3]) {
                    break state;
                }
                slowly.expand(&mut step).ok()?;
                slowly.advance(&step);
                let &[after, ..] = slowly.state();
                if after.to_f64() > self.tau {
                    let clock = step.series[0].map(T::to_f64);
                    let h = arrival(&clock, self.tau - tau.to_f64(), step.h);
                    let [_, p, w, ..] = step.at(&T::from_f64(h));
                    let there = [tau, p, w, slow.zeta(p, w)].map(T::to_f64);
                    return Some(End::Late(start_of(&there)));
                }
            };
        }
        None
    }
}

/// If it is certain to rest and its place is known well enough; `most` is its greatest speed.
fn settled(state: &[f64; 4], most: f64) -> Option<End> {
    let Last {
        time,
        way,
        weakening,
    } = last_moments(state);
    if weakening.is_nan() || weakening > WEAKENING {
        return None;
    }
    let (fate::Certain::Rest(rest), _) = judge(state)? else {
        return None;
    };
    if rest.error > RADIUS {
        return None;
    }
    // σ² = ρ² − p² + 2S.
    let sigma = libm::sqrt((start_of(state).energy() + 2.0 * way).max(0.0)).min(1.0);
    let beyond = 16.0 * weakening * weakening;
    let estimated = fate::Rest {
        error: (beyond * way / sigma.max(way)).min(rest.error),
        late: beyond * time,
        ..rest
    };
    let speeds = Speeds {
        most: 1.0,
        entry: Some(most),
    };
    let [sigma_error, tau_error] = estimated.errors(LOST, speeds);
    Some(End::Rest {
        sigma,
        sigma_error,
        tau: state[0] + time,
        tau_error,
    })
}

/// If it is certain to rest and all is known that can be.
fn ends_closely<T: Width>(state: &[T; 4], speeds: Speeds) -> Option<End> {
    let (fate::Certain::Rest(rest), true) = judge(state)? else {
        return None;
    };
    let [sigma_error, tau_error] = rest.errors(LOST_ALONE * T::ROUNDING, speeds);
    Some(End::Rest {
        sigma: rest.sigma.to_f64(),
        sigma_error,
        tau: rest.tau.to_f64(),
        tau_error,
    })
}

/// Time, way, and the part by which w weakens meanwhile.
struct Last {
    time: f64,
    way: f64,
    weakening: f64,
}

/// With w as it is, p falls like e^−ws and ζ with it, dζ/ds = −p − (1 − w)ζ, so that the time is ∫p ds = p/w and the way ∫p² ds =
/// p²/(2w). That w itself falls, dw/ds = −ζ², adds to them, for k = 1 and 2, the part ∫e^−kws ζ² ds / w, from the derivatives of
/// e^−kws times p², pζ and ζ². What is left out is smaller by as much again.
fn last_moments(&[_, p, w, zeta]: &[f64; 4]) -> Last {
    let part = |k: f64| {
        let of_squares = p * p / ((k + 2.0) * w);
        let of_products = (p * zeta - of_squares) / (1.0 + k * w);
        (zeta * zeta - 2.0 * of_products) / (2.0 + (k - 2.0) * w) / w
    };
    if p == 0.0 {
        return Last {
            time: 0.0,
            way: 0.0,
            weakening: 0.0,
        };
    }
    let [late, far] = [1.0, 2.0].map(part);
    Last {
        time: p / w * (1.0 + late),
        way: 0.5 * p * p / w * (1.0 + far),
        weakening: late.abs().max(far.abs()),
    }
}

struct Certain;

impl Watch for Certain {
    type End = Option<bool>;

    #[inline(always)]
    fn over<const L: usize>(&self, states: &[Lanes<L>; 4]) -> [bool; L] {
        std::array::from_fn(|lane| judge(&states.map(|x| x.0[lane])).is_some())
    }

    fn end(
        &self,
        _: impl FnOnce() -> [[f64; TERMS]; 4],
        _: f64,
        state: &[f64; 4],
        _: Extremes,
    ) -> Option<Option<bool>> {
        let (certain, _) = judge(state)?;
        Some(Some(matches!(certain, fate::Certain::Rest(_))))
    }

    fn alone(&self, start: &Start) -> Option<bool> {
        fate::rests(start).ok().flatten()
    }

    fn is_for_many(&self, _: &Start) -> bool {
        true
    }

    fn is_rough(_: &Option<bool>, _: Extremes) -> bool {
        false
    }
}

/// Whether each of these particles comes to rest, as [`fate::rests`] finds for one, at a tenth of
/// the time: good for pictures, since a start within about 10⁻⁹ of the boundary may be told wrongly. On one core.
///
/// # Errors
/// [`MotionError::Argument`] for a start that no constructor of [`Start`] gives.
pub fn rests(starts: &[Start]) -> Result<Vec<Option<bool>>, MotionError> {
    starts.iter().try_for_each(check)?;
    Ok(Certain.piece(starts))
}

/// By Newton's rule; the function is positive at `h`.
fn crossing(mut h: f64, function: impl Fn(f64) -> (f64, f64)) -> f64 {
    for _ in 0..20 {
        let (value, slope) = function(h);
        let change = value / slope;
        h -= change;
        // The next change would be of the order of the square.
        if change.abs() <= 1e-7 * h.abs() {
            break;
        }
    }
    h
}

fn start_of(&[_, p, w, zeta]: &[f64; 4]) -> Start {
    Start {
        p,
        xi: 1.0 - w,
        zeta,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::turntable::{Fate, fate, intrinsic::Run};

    const HORIZON: Horizon = Horizon {
        rho: 100.0,
        tau: 50.0,
    };

    fn starts() -> Vec<Start> {
        let one = |k: usize| {
            let (speed, angle) = (0.02 * (k % 100) as f64 + 0.01, 2.399963 * k as f64);
            let (sine, cosine) = libm::sincos(angle);
            Start::cartesian([0.5, 0.0], [speed * cosine, speed * sine])
        };
        (0..300).map(one).collect::<Result<_, _>>().unwrap()
    }

    #[test]
    fn each_end_is_that_of_the_particle_alone() {
        let starts = starts();
        let ends = HORIZON.follow(&starts).unwrap();
        let (mut rests, mut far) = (0, 0);
        for (start, end) in starts.iter().zip(&ends) {
            match (end.clone().unwrap(), fate(start).unwrap()) {
                (
                    End::Rest {
                        sigma,
                        sigma_error,
                        tau,
                        tau_error,
                    },
                    Fate::Rest {
                        sigma: place,
                        tau: time,
                        ..
                    },
                ) => {
                    assert!((sigma - place).abs() <= sigma_error, "{start:?} {sigma}");
                    assert!((tau - time).abs() <= tau_error, "{start:?} {tau}");
                    assert!(sigma_error < 1e-8 && tau_error < 1e-6, "{start:?}");
                    rests += 1;
                }
                (End::Far { tau, tau_error }, Fate::Escape { .. }) => {
                    let end = Run::new(start, tau).unwrap().end();
                    // dρ/dτ is nearly p, far out.
                    let off = (end.rho() - 100.0) / end.p();
                    assert!(
                        off.abs() <= 2.0 * tau_error && tau_error < 1e-6 * tau,
                        "{off}"
                    );
                    far += 1;
                }
                other => panic!("{start:?}: {other:?}"),
            }
        }
        assert!(rests > 50 && far > 50);
    }

    #[test]
    fn a_start_that_is_rounded_across_the_border_is_told_so() {
        // ρ + p = 1 as decimals, not in `f64`. The times are those of tests/data/digits/turntable.py.
        for (rho, p, time, error) in [
            ("0.999999999", "1e-9", 10.910_939_064_057_26, 1e-13),
            ("0.9999999999", "1e-10", 12.062_231_609_429_283, 1e-11),
            ("0.999999999999", "1e-12", 14.364_816_702_299_58, 1e-6),
        ] {
            let [rho, p] = [rho, p].map(|text| text.parse::<Double>().unwrap());
            let near = Start::polar(rho.to_f64(), p.to_f64(), 0.0).unwrap();
            assert!(!matches!(
                HORIZON.follow(&[near]).unwrap()[..],
                [Ok(End::Rest { .. })]
            ));
            let end = HORIZON.follow_exactly(rho, p, Double::from(0.0)).unwrap();
            let End::Rest { tau, tau_error, .. } = end else {
                panic!("{end:?}")
            };
            assert!(
                (tau - time).abs() < tau_error + 1e-14 && tau_error < error,
                "{tau} {tau_error}"
            );
        }
    }

    #[test]
    fn fates_of_many_are_those_of_each() {
        let starts = starts();
        let alone = starts.iter().map(|start| fate::rests(start).unwrap());
        assert_eq!(rests(&starts).unwrap(), alone.collect::<Vec<_>>());
        let broken = Start {
            p: f64::NAN,
            ..starts[0]
        };
        assert!(matches!(
            rests(&[broken]),
            Err(MotionError::Argument { .. })
        ));
    }

    #[test]
    fn time_that_is_up_ends_the_way_where_the_particle_is() {
        let starts = starts();
        let horizon = Horizon {
            tau: 3.0,
            ..HORIZON
        };
        let mut late = 0;
        for (start, end) in starts.iter().zip(horizon.follow(&starts).unwrap()) {
            let Ok(End::Late(there)) = end else { continue };
            let exact = Run::new(start, 3.0).unwrap().end().parts;
            for (a, b) in [
                (there.p, exact.p),
                (there.xi, exact.xi),
                (there.zeta, exact.zeta),
            ] {
                assert!((a - b).abs() < 1e-9 * (1.0 + b.abs()), "{a} {b}");
            }
            late += 1;
        }
        assert!(late > 50);
    }

    #[test]
    fn neighbours_and_threads_change_no_bit() {
        let starts = starts();
        let together = HORIZON.follow(&starts).unwrap();
        assert_eq!(together, HORIZON.follow_alone(&starts).unwrap());
        for (start, end) in starts.iter().zip(together) {
            assert_eq!(HORIZON.follow_alone(&[*start]).unwrap(), [end]);
        }
    }

    #[test]
    fn rest_stays_and_what_cannot_be_followed_is_refused() {
        let still = Start::polar(0.7, 0.0, 0.0).unwrap();
        let ends = HORIZON.follow(&[still]).unwrap();
        let rest = End::Rest {
            sigma: 0.7,
            sigma_error: 0.0,
            tau: 0.0,
            tau_error: 0.0,
        };
        assert_eq!(ends, [Ok(rest)]);
        assert_eq!(HORIZON.follow(&[]).unwrap(), []);
        let loose = Start::polar(1.1, 0.0, 0.0).unwrap();
        let broken = Start {
            p: f64::NAN,
            ..still
        };
        for bad in [loose, broken] {
            let refused = |end: &_| matches!(end, Err(MotionError::Argument { name: "p", .. }));
            for follow in [Horizon::follow, Horizon::follow_alone] {
                let ends = follow(&HORIZON, &[bad, still, bad]).unwrap();
                assert!(refused(&ends[0]) && ends[1] == Ok(rest) && refused(&ends[2]));
            }
        }
        for (rho, tau) in [
            (0.0, 1.0),
            (f64::NAN, 1.0),
            (1.0, f64::INFINITY),
            (1.0, -1.0),
        ] {
            assert!(Horizon { rho, tau }.follow(&[still]).is_err());
        }
    }

    #[test]
    fn a_watch_looks_up_where_a_way_may_have_ended() {
        let horizon = Horizon {
            rho: 3.0,
            tau: 50.0,
        };
        // By ξ, η, p and τ: whether a way may have ended, ρ² being compared with 9 and p² with 10⁻⁶ w.
        let cases = [
            (2.5, 1.7, 1.0, 1.0, true),
            (2.9, 0.5, 1.0, 1.0, false),
            (0.5, 3.0, 1.0, 1.0, true),
            (0.5, 2.9, 1.0, 1.0, false),
            (0.5, 1.0, 7.0e-4, 1.0, true),
            (0.5, 1.0, 7.2e-4, 1.0, false),
            (0.5, 1.0, 1.0, 50.1, true),
            (0.5, 1.0, 1.0, 49.9, false),
        ];
        let states = [
            Lanes(cases.map(|(.., tau, _)| tau)),
            Lanes(cases.map(|(_, _, p, ..)| p)),
            Lanes(cases.map(|(xi, ..)| 1.0 - xi)),
            Lanes(cases.map(|(_, eta, p, ..)| p - eta)),
        ];
        assert_eq!(horizon.over(&states), cases.map(|(.., over)| over));
        let states = [
            Lanes([0.0; 3]),
            Lanes([0.1, 0.1, 0.6]),
            Lanes([0.9, -0.1, 0.5]),
            Lanes([0.0, 0.0, 0.6]),
        ];
        assert_eq!(Certain.over(&states), [true, true, false]);
    }

    #[test]
    fn what_starts_moving_beyond_the_horizon_is_far_at_once() {
        let at_once = End::Far {
            tau: 0.0,
            tau_error: 0.0,
        };
        for (rho, p, psi) in [(200.0, 1e-3, 0.0), (101.0, 1.0, 2.0), (100.0, 99.0, 0.0)] {
            let start = Start::polar(rho, p, psi).unwrap();
            assert_eq!(
                HORIZON.follow(&[start]).unwrap(),
                [Ok(at_once)],
                "{rho} {p}"
            );
        }
        let start = Start::polar(100.0, 99.0, 1.57).unwrap();
        let [Ok(End::Far { tau, tau_error })] = HORIZON.follow(&[start]).unwrap()[..] else {
            panic!()
        };
        assert!((0.0..=tau_error).contains(&tau) && tau_error < 1e-11);
        let near = Horizon {
            rho: 0.4,
            tau: 50.0,
        };
        let [still, moving] = [0.0, 0.3].map(|p| Start::polar(0.5, p, 0.0).unwrap());
        let ends = near.follow(&[still, moving]).unwrap();
        assert!(matches!(ends[0], Ok(End::Rest { sigma: 0.5, .. })) && ends[1] == Ok(at_once));
    }

    #[test]
    fn what_moves_beyond_the_largest_rest_is_followed() {
        let fast = Start::polar(1.1, 0.5, 0.3).unwrap();
        let [Ok(End::Far { tau, .. })] = HORIZON.follow(&[fast]).unwrap()[..] else {
            panic!()
        };
        let rho = Run::new(&fast, tau).unwrap().end().rho();
        assert!((rho / 100.0 - 1.0).abs() < 1e-9, "{rho}");
    }

    #[test]
    fn close_to_the_border_a_particle_is_followed_alone_and_no_digit_is_made_up() {
        let place = |rho, p, psi| Start::polar(rho, p, psi).unwrap();
        // By an implicit integration in ln p, 1 − ρ and ψ at forty digits.
        for (start, sigma, tau) in [
            (
                place(0.9999, 1e-4, 0.0),
                0.9999988455574359,
                5.154601306786737,
            ),
            (
                place(0.999999, 1e-6, 0.0),
                0.9999999988452771,
                7.457041106957004,
            ),
        ] {
            let ends = HORIZON.follow(&[start]).unwrap();
            let [
                Ok(End::Rest {
                    sigma: place,
                    sigma_error,
                    tau: time,
                    tau_error,
                }),
            ] = ends[..]
            else {
                panic!("{ends:?}")
            };
            assert!((place - sigma).abs() <= sigma_error && sigma_error < 1e-10);
            assert!((time - tau).abs() <= tau_error && (time - tau).abs() < 1e-8);
        }
        let [Ok(End::Far { tau, tau_error })] =
            HORIZON.follow(&[place(0.9999, 1.1e-4, 0.0)]).unwrap()[..]
        else {
            panic!()
        };
        let rho = Run::new(&place(0.9999, 1.1e-4, 0.0), tau)
            .unwrap()
            .end()
            .rho();
        assert!((rho / 100.0 - 1.0).abs() < 1e-9 && tau_error < 1e-6 && tau > 10.0);
        let brief = Horizon {
            tau: 3.0,
            ..HORIZON
        };
        let [Ok(End::Late(there))] = brief.follow(&[place(0.9999, 1.1e-4, 0.0)]).unwrap()[..]
        else {
            panic!()
        };
        let exact = Run::new(&place(0.9999, 1.1e-4, 0.0), 3.0)
            .unwrap()
            .end()
            .parts;
        assert!((there.p - exact.p).abs() < 1e-10 && (there.zeta - exact.zeta).abs() < 1e-10);
    }

    /// Just inside the horizon and nearly along it: the rounding of the place makes most of the time.
    #[test]
    fn the_time_of_a_crossing_is_known_as_closely_as_the_place_is() {
        let horizon = Horizon {
            rho: 3.0,
            tau: 50.0,
        };
        let mut worst = 0.0_f64;
        for k in 4..=40 {
            let rho = 3.0 - 2.0 * f64::from(k) * f64::EPSILON;
            let (p, psi) = (1.0, 0.5 * std::f64::consts::PI - 3e-5);
            let wide = [rho, p, psi].map(Double::from);
            let End::Far { tau: exact, .. } =
                horizon.follow_exactly(wide[0], wide[1], wide[2]).unwrap()
            else {
                panic!("{k}")
            };
            let start = Start::polar(rho, p, psi).unwrap();
            let [Ok(End::Far { tau, tau_error })] = horizon.follow(&[start]).unwrap()[..] else {
                panic!("{k}")
            };
            assert!(
                (tau - exact).abs() <= tau_error,
                "{tau} {exact} {tau_error}"
            );
            worst = worst.max((tau - exact).abs() / tau_error);
        }
        assert!(worst > 0.1, "{worst}");
    }

    /// w weakens by at most a thousandth, by ζ for the most part and by p beside it.
    #[test]
    fn the_last_moments_leave_out_no_more_than_the_square_of_what_they_add() {
        for w in [0.2, 0.6, 1.0, 1.4] {
            for (p, zeta) in [(1e-5, 0.02), (1e-5, -0.02), (1e-3, 0.01), (1e-3, -0.01)] {
                let start = Start {
                    p,
                    xi: 1.0 - w,
                    zeta,
                };
                let last = last_moments(&[0.0, p, w, zeta]);
                let exact = Exact::from(&start);
                let (ending, _) = fate::follow::<Double, EXACTLY>(&exact, true).unwrap();
                let fate::Ending::Certain(fate::Certain::Rest(rest)) = ending else {
                    panic!("{w} {p}")
                };
                let square = last.weakening * last.weakening;
                assert!((rest.tau.to_f64() / last.time - 1.0).abs() < 2.0 * square);
            }
        }
    }
}
