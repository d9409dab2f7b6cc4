//! The largest ratio that rest can bear, from the moments at which it broke loose.

use super::{
    Interval, Unfound,
    kinetic::{mean, student},
    pieces::{BLOCK, Piece, Squares},
    sensor::Sensor,
};

/// Rows of rest by which a curve is laid.
const MOST: usize = 256;
/// Of the slip's ratio; or to as much more.
const RISE: f64 = 0.9;
const FITS: f64 = 2.0;

/// The interval of μ_s, and what the body bears at most, as far as is known.
pub(super) fn holding(
    sensor: &Sensor,
    pieces: &[Piece],
    slips: &[Piece],
    kinetic: &Result<Interval, Unfound>,
) -> (Result<Interval, Unfound>, f64) {
    let kinetic = match kinetic {
        Ok(kinetic) => kinetic,
        Err(why) => return (Err(*why), f64::INFINITY),
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

/// With its variance; from rest, by a rise in the direction that friction keeps.
fn loose(sensor: &Sensor, pieces: &[Piece], slip: &Piece) -> Option<(f64, f64)> {
    let at = pieces.partition_point(|piece| piece.from < slip.from);
    // The rows across which it broke loose may be a piece of their own.
    let mut before = pieces[..at].iter().rev();
    let long = before.find(|piece| piece.to - piece.from > BLOCK);
    let long = long.filter(|rest| rest.to + 2 * BLOCK >= slip.from);
    // A steep rise has hardly any rows; and what bends is cut into the shortest pieces without noise.
    let short = slip.from.checked_sub(3 * BLOCK).map(|from| {
        let to = slip.from - BLOCK;
        let line = sensor.line([from, to]);
        Piece { from, to, line }
    });
    let level = slip.line.y;
    let rest = long.copied().into_iter().chain(short).find(|rest| {
        let [begin, end] = [rest.from, rest.to - 1].map(|k| rest.line.at(sensor.t[k]));
        !(begin > RISE * level && end < level / RISE) && rest.line.slope() > 0.0
    })?;
    let tried = [MOST, MOST / 4, MOST / 16, 2 * BLOCK].map(|most| broke(sensor, &rest, slip, most));
    let fits = |one: &&(f64, f64, f64, usize)| one.2 < FITS;
    let all = || tried.iter().flatten();
    let &(value, variance, left, k) = all().find(fits).or(all().last())?;
    let error = libm::sqrt(variance);
    let same = sensor.angle([k - BLOCK, k], [slip.from, slip.to]) > 0.8;
    // By a few rows a push looks like a rise.
    let part = if rest.line.rows > 2.0 * BLOCK as f64 && left < FITS {
        0.2
    } else {
        0.1
    };
    (same && value + 3.0 * error > level && error < part * value).then_some((value, variance))
}

/// By the last rows of a rest; with its variance, by how much more than noise the rows are off, and the first row that slips.
fn broke(
    sensor: &Sensor,
    rest: &Piece,
    slip: &Piece,
    most: usize,
) -> Option<(f64, f64, f64, usize)> {
    let (level, after) = (slip.line.y, (slip.from + BLOCK).min(slip.to));
    let first = rest.from.max(rest.to.saturating_sub(most));
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
            let rows = sensor.ratio[k..after].iter();
            let left = rise.left + rows.map(|y| (y - level).powi(2) / noise).sum::<f64>();
            let ((here, doubt), (next, _)) =
                (rise.expected(&factors(k - 1)), rise.expected(&factors(k)));
            if best.is_none_or(|best| left < best.0) {
                let more = left / (after - first) as f64;
                let more = if more < FITS { 1.0 } else { more };
                let variance = 2.0 * sensor.alike * doubt * more + (next - here).powi(2) / 12.0;
                best = Some((left, 0.5 * (here + next), variance, k));
            }
        }
        rise.add(&factors(k), sensor.ratio[k], noise);
    }
    let (left, value, variance, k) = best?;
    Some((value, variance, left / (after - first) as f64, k))
}
