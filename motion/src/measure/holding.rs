//! The largest ratio that rest can bear, from the moments at which it broke loose.

use super::{
    Interval, Unfound,
    kinetic::{WIDER, mean, student},
    pieces::{BLOCK, Piece, curve},
    sensor::Sensor,
};

/// The most rows of rest by which a curve is laid.
const MOST: usize = 256;
/// From less than this part of the slip's ratio it has to rise.
const RISE: f64 = 0.9;

/// Between which coefficients it held or did not; and what the body bears at most, as far as is known.
pub fn holding(
    sensor: &Sensor,
    pieces: &[Piece],
    slips: &[Piece],
    kinetic: Option<&Interval>,
) -> (Result<Interval, Unfound>, f64) {
    let Some(kinetic) = kinetic else {
        return (Err(Unfound::NoSlip), f64::INFINITY);
    };
    let loose: Vec<_> = slips
        .iter()
        .filter_map(|slip| loose(sensor, pieces, slip))
        .collect();
    if loose.is_empty() {
        // What rises above the slips is a push.
        let held = pieces
            .iter()
            .map(|piece| piece.line.y)
            .filter(|y| *y <= kinetic.to)
            .fold(0.0, f64::max);
        return (Err(Unfound::NeverLoose { held }), kinetic.to);
    }
    let (middle, error) = mean(&loose);
    let half = WIDER * student((loose.len() + 3) as f64) * error;
    // Rest bears what a slip does.
    let from = match middle - half {
        // A kink is not told from a small drop.
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
    let rest = pieces[..at]
        .iter()
        .rev()
        .find(|piece| piece.to - piece.from > BLOCK)?;
    let (level, after) = (slip.line.y, (slip.from + BLOCK).min(slip.to));
    let first = rest.from.max(rest.to.saturating_sub(MOST));
    if rest.to + 2 * BLOCK < slip.from
        || rest.line.at(sensor.t[rest.from]) > RISE * level
        || rest.line.slope() <= 0.0
    {
        return None;
    }
    let floor = sensor.noise / (sensor.n[first] * sensor.n[first]);
    let noise = rest
        .line
        .variance()
        .max(floor)
        .min(slip.line.variance().max(floor));
    // Each row after which it may have been is as likely as the curve before it and the slip after it fit.
    let (mut tried, mut least) = (Vec::new(), f64::INFINITY);
    for k in (rest.to - BLOCK).max(first + BLOCK)..after {
        let degree = if k - first < 12 { 1 } else { 2 };
        let of = |at| curve(&sensor.t[first..k], &sensor.ratio[first..k], degree, at);
        let (here, next) = (of(sensor.t[k - 1]), of(sensor.t[k]));
        let slipping = sensor.ratio[k..after].iter().map(|y| (y - level).powi(2));
        let left = here.left + slipping.sum::<f64>();
        let step = next.value - here.value;
        // Neighbours may be correlated.
        let variance = 2.0 * noise * here.variance + step * step / 12.0;
        least = least.min(left);
        tried.push((left, here.value + 0.5 * step, variance, k));
    }
    let weight = |left: f64| libm::exp(-0.5 * (left - least) / noise);
    let total: f64 = tried.iter().map(|of| weight(of.0)).sum();
    let value = tried.iter().map(|of| weight(of.0) * of.1).sum::<f64>() / total;
    let spread = |of: &(f64, f64, f64, usize)| weight(of.0) * (of.2 + (of.1 - value).powi(2));
    let variance = tried.iter().map(spread).sum::<f64>() / total;
    let best = tried.iter().min_by(|a, b| a.0.total_cmp(&b.0))?;
    let fits = least < 2.0 * noise * (after - first) as f64;
    let a = sensor.mean(best.3 - BLOCK, best.3);
    let b = sensor.mean(slip.from, slip.to);
    let same = a[0] * b[0] + a[1] * b[1] > 0.8 * libm::hypot(a[0], a[1]) * libm::hypot(b[0], b[1]);
    let error = libm::sqrt(variance);
    (fits && same && value + 3.0 * error > level && error < 0.2 * value)
        .then_some((value, variance))
}
