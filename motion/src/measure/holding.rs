//! The largest ratio that rest can bear, from the moments at which it broke loose.

use super::{
    Interval, Unfound,
    kinetic::{mean, student},
    pieces::{BLOCK, Piece, Squares},
    sensor::Sensor,
};

/// The most rows of rest by which a curve is laid.
const MOST: usize = 256;
/// From less than this part of the slip's ratio it has to rise, or to as much more.
const RISE: f64 = 0.9;

/// Between which coefficients it held or did not; and what the body bears at most, as far as is known.
pub(super) fn holding(
    sensor: &Sensor,
    pieces: &[Piece],
    slips: &[Piece],
    kinetic: Option<&Interval>,
) -> (Result<Interval, Unfound>, f64) {
    let Some(kinetic) = kinetic else {
        return (Err(Unfound::NoSlip), f64::INFINITY);
    };
    let broke = slips.iter().filter_map(|slip| loose(sensor, pieces, slip));
    let broke: Vec<_> = broke.collect();
    if broke.is_empty() {
        // What rises above the slips is a push.
        let levels = pieces.iter().map(|piece| piece.line.y);
        let held = levels.filter(|y| *y <= kinetic.to).fold(0.0, f64::max);
        return (Err(Unfound::NeverLoose { held }), kinetic.to);
    }
    let [middle, error, _] = mean(&broke);
    let half = student((broke.len() + 3) as f64) * error;
    // Rest bears what a slip does, and a kink is not told from a small drop.
    let from = match middle - half {
        from if from < 1.03 * kinetic.to => kinetic.from,
        from => from,
    };
    let to = (middle + half).max(kinetic.to);
    (Ok(Interval { from, to }), to)
}

/// The ratio at which a slip began, and its variance, if it began from rest: by a rise in the direction that friction keeps.
fn loose(sensor: &Sensor, pieces: &[Piece], slip: &Piece) -> Option<(f64, f64)> {
    let at = pieces.partition_point(|piece| piece.from < slip.from);
    // The rows across which it broke loose may be a piece of their own.
    let mut before = pieces[..at].iter().rev();
    let rest = before.find(|piece| piece.to - piece.from > BLOCK)?;
    let (level, after) = (slip.line.y, (slip.from + BLOCK).min(slip.to));
    let first = rest.from.max(rest.to.saturating_sub(MOST));
    let [begin, end] = [rest.from, rest.to - 1].map(|k| rest.line.at(sensor.t[k]));
    if rest.to + 2 * BLOCK < slip.from
        || begin > RISE * level && end < level / RISE
        || rest.line.slope() <= 0.0
    {
        return None;
    }
    let floor = sensor.floor(first);
    let [noise, slipping] = [rest, slip].map(|piece| piece.line.variance().max(floor));
    let noise = noise.min(slipping);
    let factors = |k: usize| {
        let s = (sensor.t[k] - sensor.t[slip.from]) / (sensor.t[slip.from] - sensor.t[first]);
        [1.0, s, s * s]
    };
    // Whatever bends is as large as the level at most.
    let mut rise = Squares::new([level, 0.0, 0.0], [level * level; 3]);
    let mut best: Option<(f64, f64, f64, usize)> = None;
    for k in first..after {
        if k >= (rest.to - BLOCK).max(first + BLOCK) {
            // Each row may be the first that slips.
            let rows = sensor.ratio[k..after].iter();
            let left = rise.left + rows.map(|y| (y - level).powi(2) / noise).sum::<f64>();
            let ((here, doubt), (next, _)) =
                (rise.expected(&factors(k - 1)), rise.expected(&factors(k)));
            if best.is_none_or(|best| left < best.0) {
                let variance = 2.0 * sensor.alike * doubt + (next - here).powi(2) / 12.0;
                best = Some((left, 0.5 * (here + next), variance, k));
            }
        }
        rise.add(&factors(k), sensor.ratio[k], noise);
    }
    let (left, value, variance, k) = best?;
    let error = libm::sqrt(variance);
    let fits = left < 2.0 * (after - first) as f64;
    let same = sensor.angle([k - BLOCK, k], [slip.from, slip.to]) > 0.8;
    (fits && same && value + 3.0 * error > level && error < 0.2 * value)
        .then_some((value, variance))
}
