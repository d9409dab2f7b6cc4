//! The periodic motion that a start leads to.
//!
//! Two motions of one drive never move apart and never pass each other, so the return map F of w over a period is monotone with
//! slope between 0 and 1, and F(w) − w never increases. Newton's method inside the bracket of those signs goes to the motion that
//! plain following would reach; the last period is always a plain one.

use super::{
    Drive, DriveError, DriveState, Friction,
    arcs::{Mark, Walker},
    intervals::{Interval, between, canonical, drops_one},
    sign::Sign,
};
use std::f64::consts::TAU;

/// The state after one more period must agree with itself to this, in units of the largest |h|.
const AGREEMENT: f64 = 1e-12;
/// Aim of the acceleration for the distance to the periodic state, in the same units.
const AIM: f64 = 1e-13;
/// Rounding of a period, in the same units.
const ROUNDING: f64 = 2e-15;

/// What becomes of a start.
#[derive(Debug, Clone)]
pub enum Outcome<'d> {
    /// The motion becomes periodic.
    Settles(Attractor<'d>),
    /// w grows (or falls) for ever by this much per period: the mean of h exceeds the friction.
    Drifts {
        /// Change of w per period, with its sign.
        per_period: f64,
    },
}

impl<'d> Outcome<'d> {
    /// The periodic motion, if there is one.
    pub fn settled(self) -> Option<Attractor<'d>> {
        match self {
            Outcome::Settles(attractor) => Some(attractor),
            Outcome::Drifts { .. } => None,
        }
    }
}

/// How long it took.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Periods {
    /// Periods integrated, the plain one at the end included.
    pub followed: u32,
    /// Periods that plain following takes until w changes by less than 1e-12 over one: counted where nothing
    /// was accelerated, else from the final contraction rate. None for a neutral motion reached by acceleration.
    pub plain: Option<u64>,
}

/// A periodic motion.
#[derive(Debug, Clone)]
pub struct Attractor<'d> {
    pub(super) drive: &'d Drive,
    pub(super) friction: Friction,
    pub(super) intervals: Vec<Interval>,
    /// w at the beginning of the list: 0 unless w never vanishes.
    pub(super) w_start: f64,
    residual: f64,
    contraction: f64,
    grazes: bool,
    periods: Periods,
}

/// Whether several starts lead to the same motion.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Agreement {
    /// Of w, between the first start's motion and any other's, over 64 phases.
    pub largest_difference: f64,
    /// Within what the motions' own uncertainties allow (at least 1e-12).
    pub agree: bool,
    /// Of the starts, by plain following, where known.
    pub most_periods: Option<u64>,
}

impl Drive {
    /// Follows the motion from `start` until w after one more period agrees with itself to 1e-12 of the largest |h|.
    ///
    /// Cost: at most `max_periods` periods, in each of which every piece of the drive is visited.
    ///
    /// # Errors
    /// A bad start; a motion that is not periodic after `max_periods` periods. Long sliding is skipped and slow contraction
    /// accelerated, so a few dozen are enough.
    pub fn attractor(
        &self,
        friction: Friction,
        start: DriveState,
        max_periods: u32,
    ) -> Result<Outcome<'_>, DriveError> {
        let start = start.check()?;
        let size = self.shape().size();
        let phi = start.phi.rem_euclid(TAU);
        let mut walker = Walker::new(self, friction, phi, start.w);
        let section = walker.position();
        let mut marks: Vec<Mark> = Vec::with_capacity(12);
        let mut w = start.w;
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        let mut counted = 0.0;
        let mut accelerated_at: Option<f64> = None;
        let mut change = f64::INFINITY;
        let mut leap = 1.0;
        let mut last = f64::INFINITY;
        for followed in 1..=max_periods {
            walker.set(w);
            walker.period(section, &mut marks);
            let rate = walker.contraction();
            let settled;
            if marks.len() == 1 && marks[0].sign != Sign::Rest {
                // One sign all the way: the change is the same from every larger |w|.
                let sign = marks[0].sign;
                let friction = match sign {
                    Sign::Positive => -friction.plus,
                    _ => friction.minus,
                };
                change = self.shape().integral() + TAU * friction;
                // So many that w comes down to its lowest.
                let periods = (walker.lowest() / change.abs()).floor().max(1.0);
                if change.abs() <= ROUNDING * size || periods.is_infinite() {
                    let spare = sign.factor() * walker.lowest();
                    if accelerated_at.is_some() && spare.abs() > self.resolution() {
                        // Acceleration went past the first of the neutral motions: go back to it.
                        w -= spare;
                        continue;
                    }
                    settled = true;
                } else if sign.factor() * change > 0.0 {
                    return Ok(Outcome::Drifts { per_period: change });
                } else {
                    (low, high) = narrowed(low, high, w, change);
                    counted += periods;
                    w += periods * change;
                    continue;
                }
            } else {
                change = walker.w() - w;
                // The next period repeats this one to the last bits, unless the rest was no more than an error of the start.
                let aim = if rate == 0.0 { 0.0 } else { AIM * (1.0 - rate) };
                let goal = aim.max(ROUNDING) * size;
                (low, high) = narrowed(low, high, w, change);
                settled = change.abs() <= goal;
            }
            if settled {
                let plain = plain_periods(counted, accelerated_at.map(|at| at - w), rate, size);
                return Ok(Outcome::Settles(Attractor::from_period(
                    self,
                    friction,
                    (phi, w),
                    &walker,
                    &marks,
                    Periods { followed, plain },
                    change.abs(),
                )));
            }
            if rate == 0.0 {
                counted += 1.0;
                w = walker.w();
                continue;
            }
            let newton = w + change / (1.0 - rate);
            accelerated_at.get_or_insert(w);
            // Newton's method may go to and fro for ever between the two sides of a kink: where the change has not halved, halve
            // the bracket.
            let stalls = change.abs() > 0.5 * last;
            last = change.abs();
            w = if newton > low && newton < high && !stalls {
                newton
            } else if low.is_finite() && high.is_finite() {
                0.5 * (low + high)
            } else {
                // Nothing shrinks here: go on the same way, ever faster, to a bracket or to where it drifts.
                leap *= 2.0;
                w + leap * change
            };
        }
        Err(DriveError::NotSettled {
            periods: max_periods,
            change,
        })
    }

    /// Whether all `starts` lead to the same periodic motion. Motions that drift agree if all do.
    ///
    /// Cost: [`Drive::attractor`] for each start, and 64 values of each motion.
    ///
    /// # Errors
    /// As [`Drive::attractor`].
    pub fn attractors_agree(
        &self,
        friction: Friction,
        starts: &[DriveState],
        max_periods: u32,
    ) -> Result<Agreement, DriveError> {
        let mut settled = Vec::new();
        for start in starts {
            settled.extend(self.attractor(friction, *start, max_periods)?.settled());
        }
        // Whether a motion drifts depends on the mean of h alone, so it is all of them or none.
        let mut largest_difference = 0.0_f64;
        let mut uncertainty = AGREEMENT;
        if let Some((first, others)) = settled.split_first() {
            for other in others {
                largest_difference = largest_difference.max(first.apart(other));
                let sum = first.uncertainty() + other.uncertainty();
                if sum.is_finite() {
                    uncertainty = uncertainty.max(sum);
                }
            }
        }
        let counts: Option<Vec<u64>> = settled.iter().map(|a| a.periods().plain).collect();
        Ok(Agreement {
            largest_difference,
            agree: largest_difference <= uncertainty,
            most_periods: counts.and_then(|c| c.into_iter().max()),
        })
    }
}

fn narrowed(low: f64, high: f64, w: f64, change: f64) -> (f64, f64) {
    if change >= 0.0 {
        (low.max(w), high)
    } else {
        (low, high.min(w))
    }
}

/// Those counted, and those that a distance takes at a rate.
fn plain_periods(counted: f64, distance: Option<f64>, rate: f64, size: f64) -> Option<u64> {
    let more = match distance {
        None => 1.0,
        Some(_) if rate >= 1.0 => return None,
        Some(distance) => {
            let ratio = AGREEMENT * size / (distance.abs() * (1.0 - rate));
            if ratio >= 1.0 || rate == 0.0 {
                2.0
            } else {
                1.0 + (libm::log(ratio) / libm::log(rate)).ceil()
            }
        }
    };
    Some((counted + more) as u64)
}

impl<'d> Attractor<'d> {
    fn from_period(
        drive: &'d Drive,
        friction: Friction,
        (phi, w): (f64, f64),
        walker: &Walker,
        marks: &[Mark],
        periods: Periods,
        residual: f64,
    ) -> Self {
        let until = phi + TAU;
        let listed = between(marks, until);
        let whole = listed.len() == 1;
        let mut w_start = 0.0;
        let intervals = if whole && marks.len() == 1 && listed[0].sign != Sign::Rest {
            w_start = w;
            listed
        } else if whole {
            // At rest for ever: from 0. Of one sign but for zeros of length zero: from the last of them.
            let sign = listed[0].sign;
            let start = match sign {
                Sign::Rest => 0.0,
                _ => marks[marks.len() - 1].phi.rem_euclid(TAU),
            };
            vec![Interval {
                sign,
                start,
                end: start + TAU,
            }]
        } else {
            canonical(listed)
        };
        Attractor {
            drive,
            friction,
            intervals,
            w_start,
            residual,
            contraction: walker.contraction(),
            grazes: walker.touches() || drops_one(marks, until),
            periods,
        }
    }

    /// One period, in order. It begins, at the first such phase in [0, 2π), at the end of a rest before a positive interval;
    /// failing that, at the end of a rest; failing that, where w rises through zero. Ends are not reduced. At rest for ever: one
    /// interval from 0. Never zero: one interval from the phase of the start.
    pub fn intervals(&self) -> &[Interval] {
        &self.intervals
    }

    /// The friction.
    pub fn friction(&self) -> Friction {
        self.friction
    }

    /// By how much w changed over the last, plainly followed, period.
    pub fn residual(&self) -> f64 {
        self.residual
    }

    /// By this factor a small distance to the motion shrinks per period: 0 with rest, 1 if neutral.
    pub fn contraction(&self) -> f64 {
        self.contraction
    }

    /// Of w, by the residual and rounding; infinite for a neutral motion.
    pub fn uncertainty(&self) -> f64 {
        if self.contraction >= 1.0 {
            return f64::INFINITY;
        }
        (self.residual + ROUNDING * self.drive.shape().size()) / (1.0 - self.contraction)
    }

    /// Whether w touches zero without resting or changing sign, or an interval of length zero was dropped.
    pub fn grazes(&self) -> bool {
        self.grazes
    }

    /// How long it took to get here.
    pub fn periods(&self) -> Periods {
        self.periods
    }

    fn apart(&self, other: &Self) -> f64 {
        let phases = (0..64).map(|k| TAU * f64::from(k) / 64.0);
        phases
            .map(|phi| (other.w(phi) - self.w(phi)).abs())
            .fold(0.0, f64::max)
    }

    /// The interval of the list that holds `phi`, and `phi` moved by whole periods into it.
    fn interval_at(&self, phi: f64) -> (&Interval, f64) {
        let first = self.intervals[0].start;
        let phi = first + (phi - first).rem_euclid(TAU);
        let found = self.intervals.iter().find(|i| phi < i.end);
        (found.unwrap_or(&self.intervals[0]), phi)
    }

    /// The velocity at any finite phase.
    pub fn w(&self, phi: f64) -> f64 {
        let (interval, phi) = self.interval_at(phi);
        self.w_in(interval, phi)
    }

    pub(super) fn w_in(&self, interval: &Interval, phi: f64) -> f64 {
        let shape = self.drive.shape();
        let moved = phi - interval.start;
        let gain = shape.antiderivative(phi) - shape.antiderivative(interval.start);
        match interval.sign {
            Sign::Rest => 0.0,
            Sign::Positive => (self.w_start + gain - self.friction.plus * moved).max(0.0),
            Sign::Negative => (self.w_start + gain + self.friction.minus * moved).min(0.0),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn motions_are_compared_at_all_phases() {
        let drive = Drive::new(libm::sin, &[]).unwrap();
        let settled = |friction: f64| {
            let start = DriveState { phi: 0.0, w: 0.0 };
            let outcome = drive.attractor(Friction::new(friction, friction).unwrap(), start, 100);
            outcome.unwrap().settled().unwrap()
        };
        let (slow, slower) = (settled(0.8), settled(1.5));
        assert_eq!(slow.w(0.0), slower.w(0.0));
        let most = (0..64).map(|k| TAU * f64::from(k) / 64.0);
        let most = most
            .map(|phi| slow.w(phi) - slower.w(phi))
            .fold(0.0, f64::max);
        assert!(most > 0.02 && (slow.apart(&slower) - most).abs() < 1e-12);
    }

    #[test]
    fn plain_following_is_counted_period_by_period() {
        for (distance, rate, size) in [
            (3.0, 0.5, 2.0),
            (-3.0, 0.5, 2.0),
            (1e3, 0.9, 0.7),
            (0.1, 0.97, 1.0),
            (7.0, 1e-3, 0.3),
        ] {
            let (mut left, mut counted) = (f64::abs(distance), 0);
            loop {
                counted += 1;
                let change = left * (1.0 - rate);
                left -= change;
                if change <= 1e-12 * size {
                    break;
                }
            }
            assert_eq!(
                plain_periods(0.0, Some(distance), rate, size),
                Some(counted)
            );
            assert_eq!(
                plain_periods(5.0, Some(distance), rate, size),
                Some(counted + 5)
            );
        }
        assert_eq!(plain_periods(4.0, None, 0.5, 1.0), Some(5));
        assert_eq!(plain_periods(4.0, Some(1e-13), 0.5, 1.0), Some(6));
        assert_eq!(plain_periods(4.0, Some(1.0), 0.0, 1.0), Some(6));
        assert_eq!(plain_periods(4.0, Some(1.0), 1.0, 1.0), None);
    }

    #[test]
    fn of_several_starts_the_most_periods_are_told() {
        let drive = Drive::new(libm::sin, &[]).unwrap();
        let friction = Friction::new(0.3, 0.3).unwrap();
        let starts = [0.0, 7.0, 40.0].map(|w| DriveState { phi: 1.0, w });
        let alone = starts.map(|start| {
            let outcome = drive.attractor(friction, start, 100).unwrap();
            outcome.settled().unwrap().periods().plain.unwrap()
        });
        assert!(alone[0] < alone[1] && alone[1] < alone[2], "{alone:?}");
        for n in 0..3 {
            let mut starts = starts;
            starts.rotate_left(n);
            let found = drive.attractors_agree(friction, &starts, 100).unwrap();
            assert!(found.agree);
            assert_eq!(found.most_periods, Some(alone[2]), "{n}");
        }
    }
}
