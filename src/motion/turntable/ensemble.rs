//! Many particles on the table at once, to 10⁻⁹ in the place of rest: each is followed until it rests, until it is far out, or until
//! its time is up.
//!
//! The law of motion is that of [`intrinsic`](super::intrinsic), the certainty of a rest that of
//! [`fate`](super::fate). What is new is only how the work is laid out: eight particles share a vector register, and
//! a particle that has come to its end makes room for the next at once.

use super::fate::{Fate, judge};
use super::intrinsic::{Law, Start, check};
use crate::motion::error::MotionError;
use crate::numerics::batch::Batch;
use crate::numerics::lanes::{Lanes, Wide, widest};
use crate::numerics::series::value;
use rayon::prelude::*;

/// How long a particle of an ensemble is followed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Horizon {
    /// Distance from the axis, in units of μg/Ω².
    pub rho: f64,
    /// Time, in units of 1/Ω.
    pub tau: f64,
}

/// How a particle's way ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum End {
    /// It comes to rest.
    Rest {
        /// Distance σ from the axis, to 10⁻⁹.
        sigma: f64,
    },
    /// It crosses the horizon's distance.
    Far {
        /// When: to 10⁻⁹ of itself.
        tau: f64,
    },
    /// It does neither within the horizon's time.
    Late(Start),
    /// It does neither within [`STEPS`] steps.
    Unfinished(Start),
}

/// Steps after which a particle is given up: a hundred times those that all but a few need.
pub const STEPS: u32 = 5000;

/// Terms of the series, and binary logarithm of the size that the last two may have.
const TERMS: usize = 20;
const TOLERANCE: f64 = -40.0;

/// Particles that share a register.
const LANES: usize = 16;

/// A rest is looked for below this p²/w.
const SLOW: f64 = 1e-6;

/// Wanted half-width of the bounds of σ.
const RADIUS: f64 = 2e-10;

/// Particles in one piece of work for one thread.
const PIECE: usize = 1024;

impl Horizon {
    /// The ends of these particles' ways, in their order. All cores share the work; the result does not depend on how.
    ///
    /// # Errors
    /// [`MotionError::Argument`] for a horizon that is not positive and finite, a start that no constructor of
    /// [`Start`] gives, or one at rest beyond ρ = 1 (it starts by itself, and this time is not that of the ensemble).
    pub fn follow(&self, starts: &[Start]) -> Result<Vec<End>, MotionError> {
        self.check(starts)?;
        let ends = |piece| self.piece(piece);
        Ok(starts.par_chunks(PIECE).flat_map_iter(ends).collect())
    }

    /// As [`follow`](Self::follow), on one core.
    ///
    /// # Errors
    /// As for [`follow`](Self::follow).
    pub fn follow_alone(&self, starts: &[Start]) -> Result<Vec<End>, MotionError> {
        self.check(starts)?;
        Ok(self.piece(starts))
    }

    fn check(&self, starts: &[Start]) -> Result<(), MotionError> {
        for (name, value) in [("rho", self.rho), ("tau", self.tau)] {
            let allowed = value > 0.0 && value <= 1e6;
            super::argument(name, value, allowed, "positive, at most 1e6")?;
        }
        for start in starts {
            check(start)?;
            let moves = start.p > 0.0 || start.rho() <= 1.0;
            super::argument("p", start.p, moves, "positive where rho > 1")?;
        }
        Ok(())
    }
}

/// What ends a particle's way.
trait Watch {
    /// How it ends.
    type End: Clone;

    /// Whether a motion may have come to its end, for the states after a step.
    fn over<const L: usize>(&self, states: &[Lanes<L>; 4]) -> [bool; L];

    /// The end of a motion's way, if it lies in the step `h` long with this series and this state at its end.
    fn end(&self, series: &[[f64; TERMS]; 4], h: f64, state: &[f64; 4]) -> Option<Self::End>;

    /// The end of a motion that is given up in this state.
    fn unfinished(&self, state: &[f64; 4]) -> Self::End;

    /// The ends of some particles' ways, on one core.
    fn piece(&self, starts: &[Start]) -> Vec<Self::End>
    where
        Self: Sized,
    {
        struct Piece<'a, W>(&'a W, &'a [Start]);
        impl<W: Watch> Wide for Piece<'_, W> {
            type Output = Vec<W::End>;
            #[inline(always)]
            fn call(self) -> Vec<W::End> {
                self.0.run::<LANES>(self.1)
            }
        }
        widest(Piece(self, starts))
    }

    #[inline(always)]
    fn run<const L: usize>(&self, starts: &[Start]) -> Vec<Self::End> {
        let mut ends = vec![self.unfinished(&[0.0; 4]); starts.len()];
        let mut waiting = starts.iter().enumerate();
        let mut batch = Batch::<4, TERMS, L>::new();
        let mut riders: [Option<(usize, u32)>; L] = [None; L];
        let mut board = |lane: usize, batch: &mut Batch<4, TERMS, L>| {
            let next = waiting.next();
            let rest = [0.0, 0.0, 1.0, 0.0];
            let state = next.map_or(rest, |(_, start)| {
                [0.0, start.p, 1.0 - start.xi, start.zeta]
            });
            batch.set(lane, &state);
            next.map(|(index, _)| (index, 0))
        };
        for (lane, rider) in riders.iter_mut().enumerate() {
            *rider = board(lane, &mut batch);
        }
        while riders.iter().any(Option::is_some) {
            batch.expand(&Law);
            let h = batch.reach(TOLERANCE);
            let states = batch.after(&h);
            let over = self.over(&states);
            if over.iter().any(|over| *over) {
                for lane in 0..L {
                    let Some((index, _)) = riders[lane].filter(|_| over[lane]) else {
                        continue;
                    };
                    let state = states.map(|x| x.0[lane]);
                    if let Some(end) = self.end(&batch.lane(lane), h.0[lane], &state) {
                        ends[index] = end;
                        riders[lane] = None;
                    }
                }
            }
            batch.go(&states);
            for (lane, rider) in riders.iter_mut().enumerate() {
                if let Some((index, steps)) = rider {
                    *steps += 1;
                    if *steps < STEPS {
                        continue;
                    }
                    ends[*index] = self.unfinished(&batch.state(lane));
                }
                *rider = board(lane, &mut batch);
            }
        }
        ends
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

    fn end(&self, series: &[[f64; TERMS]; 4], h: f64, state: &[f64; 4]) -> Option<End> {
        let excess = |[_, p, w, zeta]: &[f64; 4]| {
            let (xi, eta) = (1.0 - w, p - zeta);
            (xi * xi + eta * eta - self.rho * self.rho, 2.0 * p * p * xi)
        };
        let at = |h: f64| std::array::from_fn(|i| value(&series[i], &h));
        let late = |x: &[f64; 4]| (x[0] - self.tau, x[1]);
        if excess(state).0 > 0.0 {
            let [tau, ..] = at(crossing(h, |h| excess(&at(h))));
            if tau <= self.tau {
                return Some(End::Far { tau });
            }
        }
        if state[0] > self.tau {
            return Some(End::Late(start_of(&at(crossing(h, |h| late(&at(h)))))));
        }
        match judge(state)?.fate {
            Fate::Rest { sigma, error, .. } if error <= RADIUS => Some(End::Rest { sigma }),
            _ => None,
        }
    }

    fn unfinished(&self, state: &[f64; 4]) -> End {
        End::Unfinished(start_of(state))
    }
}

/// Follows a particle until its [fate](mod@super::fate) is certain.
struct Certain;

impl Watch for Certain {
    /// Whether it comes to rest; nothing where [`STEPS`] steps do not tell.
    type End = Option<bool>;

    #[inline(always)]
    fn over<const L: usize>(&self, states: &[Lanes<L>; 4]) -> [bool; L] {
        std::array::from_fn(|lane| judge(&states.map(|x| x.0[lane])).is_some())
    }

    fn end(&self, _: &[[f64; TERMS]; 4], _: f64, state: &[f64; 4]) -> Option<Option<bool>> {
        let fate = judge(state)?.fate;
        Some(Some(matches!(fate, Fate::Rest { .. })))
    }

    fn unfinished(&self, _: &[f64; 4]) -> Option<bool> {
        None
    }
}

/// Whether each of these particles comes to rest, as [`fate::rests`](super::fate::rests) finds for one, at a tenth of
/// the time: good for pictures, since a start within about 10⁻⁹ of the boundary may be told wrongly. On one core.
///
/// # Errors
/// [`MotionError::Argument`] for a start that no constructor of [`Start`] gives.
pub fn rests(starts: &[Start]) -> Result<Vec<Option<bool>>, MotionError> {
    starts.iter().try_for_each(check)?;
    Ok(Certain.piece(starts))
}

/// Where a function that is positive at `h` was zero before, by Newton's rule from its value and slope.
fn crossing(mut h: f64, function: impl Fn(f64) -> (f64, f64)) -> f64 {
    for _ in 0..20 {
        let (value, slope) = function(h);
        let change = value / slope;
        h -= change;
        if change.abs() <= 1e-13 * h.abs() {
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
    use crate::motion::turntable::{fate, intrinsic::Run};

    const HORIZON: Horizon = Horizon {
        rho: 100.0,
        tau: 50.0,
    };

    /// Starts at ρ = 0.5 in all directions with speeds up to 2: some rest, some do not.
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
            match (*end, fate(start).unwrap()) {
                (End::Rest { sigma }, Fate::Rest { sigma: exact, .. }) => {
                    // Close to σ = 1 what a step loses grows; elsewhere it is far less.
                    let allowed = if exact > 0.99 { 1e-9 } else { 2e-11 + RADIUS };
                    assert!((sigma - exact).abs() <= allowed, "{start:?} {sigma}");
                    rests += 1;
                }
                (End::Far { tau }, Fate::Escape { .. }) => {
                    let rho = Run::new(start, tau).unwrap().end().rho();
                    assert!((rho / 100.0 - 1.0).abs() < 1e-9, "{rho}");
                    far += 1;
                }
                other => panic!("{start:?}: {other:?}"),
            }
        }
        assert!(rests > 50 && far > 50);
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
            let End::Late(there) = end else { continue };
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
        let [end] = HORIZON.follow(&[still]).unwrap()[..] else {
            panic!()
        };
        assert_eq!(end, End::Rest { sigma: 0.7 });
        assert_eq!(HORIZON.follow(&[]).unwrap(), []);
        let loose = Start::polar(1.1, 0.0, 0.0).unwrap();
        let broken = Start {
            p: f64::NAN,
            ..still
        };
        for starts in [[loose], [broken]] {
            assert!(matches!(
                HORIZON.follow(&starts),
                Err(MotionError::Argument { .. })
            ));
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
        // Near: p + ρ < 1. Outward: ξ > 1. Neither.
        let states = [
            Lanes([0.0; 3]),
            Lanes([0.1, 0.1, 0.6]),
            Lanes([0.9, -0.1, 0.5]),
            Lanes([0.0, 0.0, 0.6]),
        ];
        assert_eq!(Certain.over(&states), [true, true, false]);
        // Of a particle that is given up nothing is said.
        assert_eq!(Certain.unfinished(&[1.0, 0.6, 0.5, 0.6]), None);
    }

    #[test]
    fn what_moves_beyond_the_largest_rest_is_followed() {
        let fast = Start::polar(1.1, 0.5, 0.3).unwrap();
        let [End::Far { tau }] = HORIZON.follow(&[fast]).unwrap()[..] else {
            panic!()
        };
        let rho = Run::new(&fast, tau).unwrap().end().rho();
        assert!((rho / 100.0 - 1.0).abs() < 1e-9, "{rho}");
    }
}
