//! The plateaus of a slip, the coefficient they have in common, and whether they do.

use super::{
    Interval, Verdict,
    pieces::{BLOCK, Line, Piece, Squares},
    sensor::{SAME, Sensor},
};
use crate::numerics::median;

const ROWS: usize = 8;
/// As a part of its level, from beginning to end.
const FLAT: f64 = 0.2;
/// As a part of its level, beside the noise of the sensor.
const ROUGH: f64 = 0.2;
/// As a part of the rows of the first level.
const OTHERS: f64 = 0.25;
/// Of all rows without rest, where a piece counts as the longest slip at most: in what is shaken and sticks some plateaus are
/// chance, but a board is raised slowly.
const SHARE: f64 = 0.08;
/// Below this ratio a sensor's zeros decide.
const LEAST: f64 = 0.02;
const PARTS: usize = 12;
/// The variance of what nothing is known of, in those of a row.
const FREE: f64 = 1e8;
const BLOW: usize = 16;
const TRIED: usize = 64;
/// What is less, as a part of the coefficient, does not speak against Coulomb's law, however sure it is,
const SLIGHT: f64 = 0.02;
/// and neither does what is less sure than so many standard errors.
const SURE: f64 = 4.0;

/// Flat pieces that do not rise or fall smoothly into their neighbours.
fn plateaus(sensor: &Sensor, pieces: &[Piece]) -> Vec<Piece> {
    let fit = |piece: &&Piece| {
        is_flat(sensor, piece) && is_sharp(sensor, piece) && !is_caught(sensor, piece)
    };
    pieces.iter().filter(fit).copied().collect()
}

fn is_flat(sensor: &Sensor, piece: &Piece) -> bool {
    let (line, variance) = (&piece.line, piece.line.variance());
    let floor = sensor.floor(piece.from);
    let noise = libm::sqrt(sensor.alike * variance.max(floor) / line.rows);
    // The size of noise alone is 1.25 of its deviation.
    let alone = 3.0 * libm::sqrt(floor);
    piece.to - piece.from >= ROWS
        && line.y > LEAST.max(6.0 * noise).max(alone)
        && variance < 2.0 * floor + (ROUGH * line.y).powi(2)
        && change(sensor, piece).0.abs() < FLAT * line.y
}

/// Along a piece, with its error.
fn change(sensor: &Sensor, piece: &Piece) -> (f64, f64) {
    let last = sensor.t[piece.to - 1] - sensor.t[piece.from];
    let error = libm::sqrt(sensor.alike * piece.line.variance() / piece.line.tt);
    (last * piece.line.slope(), last * error)
}

fn is_level(sensor: &Sensor, piece: &Piece) -> bool {
    let (change, error) = change(sensor, piece);
    change.abs() < (SLIGHT * piece.line.y).max(SURE * error)
}

/// Whether a plateau and its surroundings, half as long on either side, are less like one quartic than like three lines, by a
/// factor of 10⁴. The rows next to the plateau do not count.
fn is_sharp(sensor: &Sensor, piece: &Piece) -> bool {
    let margin = (piece.to - piece.from).div_ceil(2).max(BLOCK);
    let before = piece.from.saturating_sub(BLOCK);
    let after = (piece.to + BLOCK).min(sensor.t.len());
    let parts = [
        [before.saturating_sub(margin), before],
        [piece.from, piece.to],
        [after, (after + margin).min(sensor.t.len())],
    ];
    let floor = sensor.floor(piece.from);
    let most = (0.5 * piece.line.y).max(8.0 * libm::sqrt(floor));
    let span = sensor.t[piece.to - 1] - sensor.t[piece.from];
    let (mut rows, mut lines) = (0.0, 0.0);
    let mut quartic = Squares::new([0.0; 5], [FREE; 5]);
    for [from, to] in parts {
        let mut line = Squares::new([0.0; 2], [FREE; 2]);
        for k in from..to {
            let y = (sensor.ratio[k] - piece.line.y).clamp(-most, most);
            let s = (sensor.t[k] - piece.line.t) / span;
            line.add(&[1.0, s], y, 1.0);
            quartic.add(&[0, 1, 2, 3, 4].map(|power| s.powi(power)), y, 1.0);
            rows += 1.0;
        }
        lines += line.left;
    }
    let floor = rows * floor;
    rows * libm::log((quartic.left + floor) / (lines + floor)) > 10.0 * sensor.alike
}

/// A blow comes before it in its own direction: a stop may hold the body. A pushed body slips with friction against the push.
fn is_caught(sensor: &Sensor, piece: &Piece) -> bool {
    let size = |k: &usize| sensor.ratio[*k];
    let before = piece.from.saturating_sub(BLOW)..(piece.from + 2).min(piece.to);
    let blow = before.max_by(|a, b| size(a).total_cmp(&size(b)));
    blow.is_some_and(|blow| {
        sensor.ratio[blow] > 2.0 * piece.line.y
            && sensor.angle([blow, blow + 1], [piece.from, piece.to]) > 0.0
    })
}

/// Those of [`sliding`] that are slips, and whether some may be a rest on a tilted floor.
pub(crate) fn slips(sensor: &Sensor, pieces: &[Piece]) -> (Vec<Piece>, bool) {
    let mut all = plateaus(sensor, pieces);
    // What rises or falls slowly may be a rest on a board that is raised.
    if all.iter().any(|piece| is_level(sensor, piece)) {
        all.retain(|piece| is_level(sensor, piece));
    }
    let (mut all, rests) = sliding(sensor, pieces, all);
    let quiet = 3.0 * libm::sqrt(sensor.noise) / sensor.n[0];
    let moved = pieces
        .iter()
        .filter(|piece| piece.line.y > LEAST.max(quiet));
    let rows = |sum: f64, piece: &Piece| sum + piece.line.rows;
    let longest = all
        .iter()
        .fold(0.0, |most: f64, piece| most.max(piece.line.rows));
    let cut = |sum: f64, piece: &Piece| sum + piece.line.rows.min(longest);
    if all.iter().fold(0.0, rows) < SHARE * moved.fold(0.0, cut) {
        all.clear();
    }
    (all, rests)
}

/// With a common level on which the body is longest, but for those that may be a rest on a tilted floor; and whether there are
/// such.
fn sliding(sensor: &Sensor, pieces: &[Piece], mut all: Vec<Piece>) -> (Vec<Piece>, bool) {
    let mut rests = false;
    let weight = sensor.weight(&all);
    loop {
        let level = commonest(sensor, &all).y;
        let near = |piece: &Piece| sensor.near(piece.line.y, level);
        let same: Vec<_> = all.iter().filter(|piece| near(piece)).copied().collect();
        if same.is_empty() || !sensor.may_rest(&same, top(sensor, pieces, &same), weight) {
            return (same, rests);
        }
        rests = true;
        all.retain(|piece| !near(piece));
    }
}

/// The ratio from which the longest of these plateaus began with a drop, or else its own.
fn top(sensor: &Sensor, pieces: &[Piece], plateaus: &[Piece]) -> f64 {
    let longest = plateaus
        .iter()
        .max_by(|a, b| a.line.rows.total_cmp(&b.line.rows));
    longest.map_or(0.0, |plateau| {
        let before = pieces.iter().rev();
        let mut before = before.filter(|piece| piece.to <= plateau.from);
        let rise = before.find(|piece| piece.to - piece.from > BLOCK);
        let end = rise.map_or(0.0, |rise| rise.line.at(sensor.t[rise.to - 1]));
        if end > (1.0 + SAME) * plateau.line.y {
            end
        } else {
            plateau.line.y
        }
    })
}

fn commonest(sensor: &Sensor, plateaus: &[Piece]) -> Line {
    let mut longest: Vec<_> = plateaus.iter().collect();
    longest.sort_by(|a, b| b.line.rows.total_cmp(&a.line.rows));
    let about = |one: &Piece| {
        let same = plateaus
            .iter()
            .filter(|other| sensor.near(other.line.y, one.line.y));
        same.fold(Line::default(), |all, other| all.with(&other.line))
    };
    let levels = longest.into_iter().take(TRIED).map(about);
    levels
        .max_by(|a, b| a.rows.total_cmp(&b.rows))
        .unwrap_or_default()
}

/// The rows but for the ends, which a filter, or a stop, may have touched.
fn core(piece: &Piece) -> [usize; 2] {
    let rows = piece.to - piece.from;
    let end = 4.min(rows / 4) + rows / 20;
    [piece.from + end, piece.to - end]
}

/// The coefficient, and the mean of N/m. Rows far off their middle do not count, as those between two slips; a size is
/// greater by noise across.
fn coefficient(sensor: &Sensor, [from, to]: [usize; 2]) -> (f64, f64) {
    let middle = median(sensor.ratio[from..to].iter().copied());
    let off = |k: usize| (sensor.ratio[k] - middle).abs();
    let far = (1.48 * median((from..to).map(off))).max(libm::sqrt(sensor.floor(from)));
    let near = (from..to).filter(|k| off(*k) <= 4.0 * far);
    let sizes = Line::through(near.map(|k| (sensor.n[k], sensor.ratio[k] * sensor.n[k])));
    let across = 0.5 * (sensor.axes - 1.0) * sizes.yy / (sizes.rows * sizes.y);
    ((sizes.y - across) / sizes.t, sizes.t)
}

/// Least squares for the coefficient and the zeros, from what is known of these; and how far they are off.
pub(crate) fn fit(sensor: &Sensor, slips: &[Piece]) -> (Interval, [f64; 2]) {
    let each = PARTS.div_ceil(slips.len());
    let mut parts = Vec::new();
    for piece in slips {
        let [from, to] = core(piece);
        let each = each
            .min((to - from) / (2.0 * sensor.alike).max(4.0) as usize)
            .max(1);
        let edge = |k: usize| from + k * (to - from) / each;
        parts.extend((0..each).map(|k| {
            let rows = [edge(k), edge(k + 1)];
            let ((mu, n), [x, y]) = (coefficient(sensor, rows), sensor.mean(rows));
            let size = mu * n * n;
            ([1.0, x / size, y / size], mu, (rows[1] - rows[0]) as f64)
        }));
    }
    let free = parts.len() as f64 - 1.0;
    let [x, y] = sensor.shifted.map(|x| -x);
    let before = Squares::new([parts[0].1, x, y], [1.0, sensor.doubt, sensor.doubt]);
    // The parts' scatter about the coefficient says what a row weighs.
    let (mut all, mut scatter) = (before, 1.0);
    for _ in 0..3 {
        all = before;
        for (x, mu, weight) in &parts {
            all.add(x, *mu, scatter / weight);
        }
        let off =
            |(x, mu, weight): &([f64; 3], f64, f64)| weight * (mu - all.expected(x).0).powi(2);
        scatter = (parts.iter().map(off).sum::<f64>() / free.max(1.0))
            .max(sensor.alike * sensor.floor(slips[0].from));
    }
    let [mu, x, y] = all.found;
    let across = (sensor.digits + mu * mu * sensor.doubt_across) / sensor.n[slips[0].from].powi(2);
    let variance = all.spread[0][0].max(0.0) + across;
    let half = student(free) * libm::sqrt(variance);
    let from = (mu - half).max(0.0);
    (
        Interval {
            from,
            to: mu + half,
        },
        [x, y],
    )
}

/// 95 % are below, in size: right to 2 % from three degrees of freedom on.
pub(crate) fn student(free: f64) -> f64 {
    let free = free.max(1.0);
    1.96 + 2.372 / free + 2.823 / (free * free) + 2.5 / free.powi(3)
}

pub(crate) fn verdict(sensor: &Sensor, pieces: &[Piece], slips: &[Piece]) -> Verdict {
    let all = slips
        .iter()
        .fold(Line::default(), |all, slip| all.with(&slip.line));
    let level = all.y;
    let mut others = plateaus(sensor, pieces);
    others.retain(|piece| !sensor.near(piece.line.y, level) && is_level(sensor, piece));
    let (others, _) = sliding(sensor, pieces, others);
    let other = commonest(sensor, &others);
    if other.rows > OTHERS * all.rows {
        let (from, to) = (other.y.min(level), other.y.max(level));
        return Verdict::Levels(Interval { from, to });
    }
    let (mut drift, mut levels) = (Vec::new(), Vec::new());
    for rows in slips.iter().map(core) {
        let line = sensor.line(rows);
        let variance = sensor.alike * line.variance().max(1e-18) / (level * level);
        let last = sensor.t[rows[1] - 1] - sensor.t[rows[0]];
        levels.push((coefficient(sensor, rows).0 / level, variance / line.rows));
        drift.push((
            line.slope() * last / level,
            variance * last * last / line.tt,
        ));
    }
    let sizes = || levels.iter().map(|level| level.0);
    let free = levels.len() as f64 - 1.0;
    let [middle, error, chi] = mean(&levels);
    let spread = error * libm::sqrt(free + 1.0);
    let chance = free + SURE * libm::sqrt(2.0 * free) + SURE;
    let [drift, error, _] = mean(&drift);
    if free > 0.0 && chi > chance && spread > 0.75 * SLIGHT {
        let [from, to] = [f64::min, f64::max].map(|of| level * sizes().fold(middle, of));
        Verdict::Levels(Interval { from, to })
    } else if drift.abs() > SLIGHT.max(SURE * error) {
        Verdict::Drifts(drift)
    } else {
        Verdict::Fits
    }
}

/// With its error, by the variances or by how they scatter, and χ².
pub(crate) fn mean(list: &[(f64, f64)]) -> [f64; 3] {
    let sum = |of: &dyn Fn(f64) -> f64| list.iter().map(|(x, v)| of(*x) / v).sum::<f64>();
    let weight = sum(&|_| 1.0);
    let mean = sum(&|x| x) / weight;
    let chi = sum(&|x| (x - mean).powi(2));
    let free = (list.len() as f64 - 1.0).max(1.0);
    [mean, libm::sqrt((chi / free).max(1.0) / weight), chi]
}
