//! The drives on which section 2.3 is tried, each with max |h| = 1, and the kinds of motion under them.

use super::prelude::*;

/// From here a motion starts whose kind is asked for.
const REST: DriveState = DriveState { phi: 0.0, w: 0.0 };
/// From here a motion starts that is compared in full: far from any periodic one.
const OFF: DriveState = DriveState { phi: 2.5, w: 3.0 };
const PERIODS: u32 = 400;

/// What becomes of the motion, as a count.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Phase {
    /// w grows for ever.
    Drifts,
    /// It moves, with this many intervals of rest per period.
    Rests(usize),
    /// It is at rest for ever.
    Still,
}

impl Phase {
    /// Whether it moves for ever, and rests in between.
    pub fn rests(self) -> bool {
        matches!(self, Phase::Rests(1..))
    }
}

fn settled(
    drive: &Drive,
    lambda: f64,
    from: DriveState,
) -> Result<Option<Attractor<'_>>, DriveError> {
    let friction = Friction::new(lambda, lambda)?;
    Ok(drive.attractor(friction, from, PERIODS)?.settled())
}

/// From a start far from it; `None` if it drifts.
pub(crate) fn motion(drive: &Drive, lambda: f64) -> Result<Option<Attractor<'_>>, DriveError> {
    settled(drive, lambda, OFF)
}

/// From rest under isotropic friction, by the simulation alone.
pub(crate) fn phase(drive: &Drive, lambda: f64) -> Result<Phase, DriveError> {
    Ok(settled(drive, lambda, REST)?.map_or(Phase::Drifts, |motion| phase_of(&motion)))
}

pub(crate) fn phase_of(motion: &Attractor<'_>) -> Phase {
    let list = motion.intervals();
    match list.iter().filter(|i| i.sign == Sign::Rest).count() {
        1 if list.len() == 1 => Phase::Still,
        rests => Phase::Rests(rests),
    }
}

pub(crate) fn rest_share(motion: &Attractor<'_>) -> f64 {
    let rests = motion.intervals().iter().filter(|i| i.sign == Sign::Rest);
    rests.map(|i| i.length()).sum::<f64>() / TAU
}

/// By halving to the last bits.
pub(crate) fn boundary<E>(
    mut low: f64,
    mut high: f64,
    holds: impl Fn(f64) -> Result<bool, E>,
) -> Result<f64, E> {
    let at_low = holds(low)?;
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if middle <= low || middle >= high {
            break;
        }
        if holds(middle)? == at_low {
            low = middle;
        } else {
            high = middle;
        }
    }
    Ok(0.5 * (low + high))
}

/// Pulses of size 1 that fill the share η of each half period, there and back.
pub(crate) fn pulses(eta: f64) -> Result<Drive, DriveError> {
    let end = eta * PI;
    let h = move |phi: f64| match phi {
        phi if phi < end => 1.0,
        phi if PI <= phi && phi < PI + end => -1.0,
        _ => 0.0,
    };
    Drive::new(h, &[end, PI, PI + end])
}

/// A sum of harmonics, a constant included: m + Σ aₖ sin(kφ + pₖ), then divided by its largest size.
#[derive(Debug, Clone)]
pub(crate) struct Harmonics {
    mean: f64,
    terms: Vec<(f64, f64, f64)>,
    size: f64,
}

impl Harmonics {
    /// From m and the terms (k, aₖ, pₖ).
    pub(crate) fn new(mean: f64, terms: &[(u32, f64, f64)]) -> Result<Self, DriveError> {
        let terms = terms.iter().map(|&(k, a, p)| (f64::from(k), a, p));
        let mut sum = Harmonics {
            mean,
            terms: terms.collect(),
            size: 1.0,
        };
        sum.size = Drive::new(|phi| sum.h(phi), &[])?.shape().size();
        Ok(sum)
    }

    /// Three harmonics without a mean, at random.
    pub(crate) fn random(points: &mut Points) -> Result<Self, DriveError> {
        let terms = [1, 2, 3].map(|k| {
            let amplitude = points.uniform(-1.0, 1.0);
            (k, amplitude, points.uniform(0.0, TAU))
        });
        Self::new(0.0, &terms)
    }

    pub(crate) fn h(&self, phi: f64) -> f64 {
        let wave = |&(k, a, p): &(f64, f64, f64)| a * libm::sin(k * phi + p);
        (self.mean + self.terms.iter().map(wave).sum::<f64>()) / self.size
    }

    /// Each as its number k, its size aₖ after the division and its phase pₖ; without the constant.
    pub(crate) fn terms(&self) -> impl Iterator<Item = [f64; 3]> + '_ {
        self.terms.iter().map(|&(k, a, p)| [k, a / self.size, p])
    }

    pub(crate) fn drive(&self) -> Result<Drive, DriveError> {
        Drive::new(|phi| self.h(phi), &[])
    }
}

#[derive(Debug, Clone)]
pub(crate) struct Named {
    pub name: &'static str,
    pub drive: Drive,
    /// Whether the claim's added conditions hold: no mean, not two-valued, not level at the median.
    pub generic: bool,
}

/// Linear from knot to knot (φ, h), the last joined to the first one period on.
fn polygon(knots: &[(f64, f64)]) -> Result<Drive, DriveError> {
    let h = |phi: f64| {
        let after = knots.partition_point(|(x, _)| *x <= phi);
        let (left, right) = match (after, knots.len()) {
            (0, n) => ((knots[n - 1].0 - TAU, knots[n - 1].1), knots[0]),
            (i, n) if i == n => (knots[n - 1], (knots[0].0 + TAU, knots[0].1)),
            (i, _) => (knots[i - 1], knots[i]),
        };
        left.1 + (right.1 - left.1) * ((phi - left.0) / (right.0 - left.0))
    };
    let breaks: Vec<f64> = knots.iter().map(|(phi, _)| *phi).collect();
    Drive::new(h, &breaks)
}

/// Steps: (until, h) from φ = 0 on.
pub(crate) fn steps(steps: &[(f64, f64)]) -> Result<Drive, DriveError> {
    let h = |phi: f64| {
        let after = steps.partition_point(|(end, _)| *end <= phi);
        steps[after.min(steps.len() - 1)].1
    };
    let breaks: Vec<f64> = steps.iter().map(|(end, _)| *end).collect();
    Drive::new(h, &breaks)
}

/// Steps between 1 and −1: up for x, down for y, up for π − x, down for the rest, half of the time each.
pub(crate) fn steps_between(x: f64, y: f64) -> Result<Drive, DriveError> {
    steps(&[(x, 1.0), (x + y, -1.0), (PI + y, 1.0), (TAU, -1.0)])
}

/// sin φ + a sin 3φ, the drive whose rests come, go and come again for a near 1.5.
pub(crate) fn third_harmonic(a: f64) -> Result<Drive, DriveError> {
    Harmonics::new(0.0, &[(1, 1.0, 0.0), (3, a, 0.0)])?.drive()
}

/// sin φ + sin(2φ + p): the antiderivative is level at its median, whatever p.
pub(crate) fn level_at_median(p: f64) -> Result<Drive, DriveError> {
    Harmonics::new(0.0, &[(1, 1.0, 0.0), (2, 1.0, p)])?.drive()
}

/// sin φ + b, of mean b/(1 + b) after scaling.
pub(crate) fn biased(b: f64) -> Result<Drive, DriveError> {
    Harmonics::new(b, &[(1, 1.0, 0.0)])?.drive()
}

/// In the order in which the census lists them.
pub(crate) fn named() -> Result<Vec<Named>, DriveError> {
    let one = |name, drive, generic| Named {
        name,
        drive,
        generic,
    };
    let (half, third) = (PI / 2.0, PI / 3.0);
    Ok(vec![
        one(
            "sine",
            Harmonics::new(0.0, &[(1, 1.0, 0.0)])?.drive()?,
            true,
        ),
        one(
            "two harmonics",
            Harmonics::new(0.0, &[(1, 1.0, 0.0), (2, 0.5, 1.0)])?.drive()?,
            true,
        ),
        one("third harmonic", third_harmonic(1.5)?, true),
        one(
            "triangle",
            polygon(&[(half, 1.0), (PI + half, -1.0)])?,
            true,
        ),
        one(
            "plateaus",
            polygon(&[
                (third, 1.0),
                (2.0 * third, 1.0),
                (4.0 * third, -1.0),
                (5.0 * third, -1.0),
            ])?,
            true,
        ),
        one("pulses, η = 0.6", pulses(0.6)?, true),
        one(
            "one-sided push",
            steps(&[(half, 1.0), (TAU, -1.0 / 3.0)])?,
            true,
        ),
        one("square wave", pulses(1.0)?, false),
        one("level median", level_at_median(half)?, false),
        one("sine and mean", biased(0.1)?, false),
    ])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_motion_with_rests_rests() {
        let phases = [
            Phase::Rests(0),
            Phase::Rests(2),
            Phase::Still,
            Phase::Drifts,
        ];
        assert_eq!(phases.map(Phase::rests), [false, true, false, false]);
    }
}
