//! The plateaus of a slip, the coefficient they have in common, and whether they do.

use super::{
    Interval, Verdict,
    pieces::{BLOCK, Line, Piece, curve},
    sensor::Sensor,
};

/// The fewest rows of a plateau.
const ROWS: usize = 8;
/// How much of its level a plateau may change from its beginning to its end, and how far levels that are one may lie apart.
const FLAT: f64 = 0.2;
const SAME: f64 = 0.06;
/// Plateaus of another level with so many rows of those of the first speak against it.
const OTHERS: f64 = 0.25;
/// The most that a plateau is rough, as a part of its level, beside the noise of the sensor.
const ROUGH: f64 = 0.15;
/// The part of the slips that may be followed by a change without a jump.
const FOLLOWED: f64 = 0.3;
/// The part of all rows without rest that slips have at least: in what is shaken and sticks some plateaus are chance.
const SHARE: f64 = 0.04;
/// The least ratio of a slip: below it a sensor's zeros decide.
const LEAST: f64 = 0.02;
/// So many parts at least a coefficient is averaged from.
const PARTS: usize = 12;
/// How many rows before a plateau a blow may be.
const BLOW: usize = 16;
/// By how much intervals are wider than the scatter says: some rows of rest are always among those of a slip. Of 385 trays that were
/// shaken on paper 97 in 100 have the truth inside with it, 95 without.
pub const WIDER: f64 = 1.2;
/// What is less than this part of the coefficient does not speak against Coulomb's law, however sure it is,
const SLIGHT: f64 = 0.02;
/// and neither does what is less sure than so many standard errors.
const SURE: f64 = 4.0;

/// Pieces that are flat, and neither rise nor fall smoothly into their neighbours.
fn plateaus(sensor: &Sensor, pieces: &[Piece]) -> Vec<Piece> {
    let mut list: Vec<Piece> = Vec::new();
    for piece in pieces.iter().filter(|piece| is_flat(sensor, piece)) {
        match list.last_mut() {
            // One slip in two pieces.
            Some(last)
                if last.to == piece.from
                    && near(last.line.y, piece.line.y)
                    && is_level(sensor, last)
                    && is_level(sensor, piece) =>
            {
                last.to = piece.to;
                last.line = last.line.with(&piece.line);
            }
            _ => list.push(*piece),
        }
    }
    list.retain(|piece| is_sharp(sensor, piece) && !is_caught(sensor, piece));
    list
}

fn is_flat(sensor: &Sensor, piece: &Piece) -> bool {
    let (line, variance) = (&piece.line, piece.line.variance());
    let floor = sensor.noise / (sensor.n[piece.from] * sensor.n[piece.from]);
    let noise = libm::sqrt(variance.max(floor) / line.rows);
    // The size of noise alone is 1.25 of its deviation.
    let alone = 3.0 * libm::sqrt(floor);
    piece.to - piece.from >= ROWS
        && line.y > LEAST.max(6.0 * noise).max(alone)
        && variance < 4.0 * floor + (ROUGH * line.y).powi(2)
        && change(sensor, piece).0.abs() < FLAT * line.y
}

/// By how much the ratio changes along a piece, and the error of that.
fn change(sensor: &Sensor, piece: &Piece) -> (f64, f64) {
    let last = sensor.t[piece.to - 1] - sensor.t[piece.from];
    let error = libm::sqrt(piece.line.variance() / piece.line.tt);
    (last * piece.line.slope(), last * error)
}

/// Whether it changes so little that it can be a slip by Coulomb's law.
fn is_level(sensor: &Sensor, piece: &Piece) -> bool {
    let (change, error) = change(sensor, piece);
    change.abs() < (SLIGHT * piece.line.y).max(SURE * error)
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() < SAME * 0.5 * (a + b)
}

/// Whether a plateau and what lies around it, half as long before and after it, are less like one cubic than like three lines: a
/// factor of 10⁵ at least. Nothing counts of how far away it is around, nor of the rows next to the plateau.
fn is_sharp(sensor: &Sensor, piece: &Piece) -> bool {
    let margin = (piece.to - piece.from).div_ceil(2).max(BLOCK);
    let before = piece.from.saturating_sub(BLOCK);
    let after = (piece.to + BLOCK).min(sensor.t.len());
    let parts = [
        (before.saturating_sub(margin), before),
        (piece.from, piece.to),
        (after, (after + margin).min(sensor.t.len())),
    ];
    let floor = sensor.noise / (sensor.n[piece.from] * sensor.n[piece.from]);
    let most = (0.5 * piece.line.y).max(8.0 * libm::sqrt(floor));
    let near = |k: usize| sensor.ratio[k].clamp(piece.line.y - most, piece.line.y + most);
    let rows = |(from, to): (usize, usize)| (from..to).map(|k| (sensor.t[k], near(k)));
    let lines: f64 = parts
        .map(|part| Line::through(rows(part)).left())
        .iter()
        .sum();
    let (t, y): (Vec<_>, Vec<_>) = parts.into_iter().flat_map(rows).unzip();
    let cubic = curve(&t, &y, 3, 0.0).left;
    let floor = t.len() as f64 * floor;
    t.len() as f64 * libm::log((cubic + floor) / (lines + floor)) > 23.0
}

/// Whether a blow comes before it in its own direction: a stop has caught the body, and may hold it. One that has been pushed slips
/// with friction against the push.
fn is_caught(sensor: &Sensor, piece: &Piece) -> bool {
    let size = |k: &usize| sensor.ratio[*k];
    let before = piece.from.saturating_sub(BLOW)..(piece.from + 2).min(piece.to);
    let Some(blow) = before.max_by(|a, b| size(a).total_cmp(&size(b))) else {
        return false;
    };
    let (a, b) = (sensor.f[blow], sensor.mean(piece.from, piece.to));
    sensor.ratio[blow] > 2.0 * piece.line.y && a[0] * b[0] + a[1] * b[1] > 0.0
}

/// The plateaus that have a level in common on which the body is longest.
pub fn slips(sensor: &Sensor, pieces: &[Piece]) -> Vec<Piece> {
    let mut all = plateaus(sensor, pieces);
    // What rises or falls slowly may be a rest on a board that is raised.
    if all.iter().any(|piece| is_level(sensor, piece)) {
        all.retain(|piece| is_level(sensor, piece));
    }
    let level = commonest(&all).map_or(f64::NAN, |(level, _)| level);
    all.retain(|piece| near(piece.line.y, level));
    let quiet = 3.0 * libm::sqrt(sensor.noise) / sensor.n[0];
    let moved = pieces
        .iter()
        .filter(|piece| piece.line.y > LEAST.max(quiet));
    let rows = |sum: f64, piece: &Piece| sum + piece.line.rows;
    if all.iter().fold(0.0, rows) < SHARE * moved.fold(0.0, rows) {
        all.clear();
    }
    all
}

/// The level about which most rows lie, and how many.
fn commonest(plateaus: &[Piece]) -> Option<(f64, f64)> {
    let mut sorted: Vec<_> = plateaus.iter().map(|p| (p.line.y, p.line.rows)).collect();
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (mut first, mut sum, mut moment) = (0, 0.0, 0.0);
    let mut best: Option<(f64, f64)> = None;
    for (level, rows) in &sorted {
        sum += rows;
        moment += rows * level;
        while !near(sorted[first].0, *level) {
            sum -= sorted[first].1;
            moment -= sorted[first].0 * sorted[first].1;
            first += 1;
        }
        if best.is_none_or(|best| sum > best.1) {
            best = Some((moment / sum, sum));
        }
    }
    best
}

/// The rows of a plateau but for its ends, which a sensor's filter, or a stop, may have touched.
fn core(piece: &Piece) -> (usize, usize) {
    let rows = piece.to - piece.from;
    let end = 4.min(rows / 4) + rows / 20;
    (piece.from + end, piece.to - end)
}

/// The coefficient in these rows, and the mean of N/m. Rows that are far off their middle do not count, as those between two slips
/// to and fro; a size is greater by noise across.
fn coefficient(sensor: &Sensor, from: usize, to: usize) -> (f64, f64) {
    let middle = |list: &mut Vec<f64>| {
        let half = list.len() / 2;
        *list.select_nth_unstable_by(half, f64::total_cmp).1
    };
    let mut sorted = sensor.ratio[from..to].to_vec();
    let median = middle(&mut sorted);
    sorted.iter_mut().for_each(|y| *y = (*y - median).abs());
    // The deviation of a normal distribution is 1.48 of the median of its sizes.
    let floor = libm::sqrt(sensor.noise) / sensor.n[from];
    let far = 4.0 * (1.48 * middle(&mut sorted)).max(floor);
    let near = |k: &usize| (sensor.ratio[*k] - median).abs() <= far;
    let (mut rows, mut f, mut n, mut ff) = (0.0, 0.0, 0.0, 0.0);
    for k in (from..to).filter(near) {
        let size = sensor.ratio[k] * sensor.n[k];
        rows += 1.0;
        f += size;
        n += sensor.n[k];
        ff += size * size;
    }
    let spread = (ff - f * f / rows).max(0.0) / rows;
    let across = (sensor.axes - 1.0) * 0.5 * spread * rows / f;
    ((f - across * rows) / n, n / rows)
}

pub struct Fit {
    pub interval: Interval,
    /// How far the zeros are off.
    pub offset: [f64; 2],
}

/// Least squares for the coefficient and the zeros, of which something is known.
pub fn fit(sensor: &Sensor, slips: &[Piece]) -> Fit {
    let each = PARTS.div_ceil(slips.len());
    let mut parts = Vec::new();
    for piece in slips {
        let (from, to) = core(piece);
        let each = each.min((to - from) / 4).max(1);
        let edge = |k: usize| from + k * (to - from) / each;
        parts.extend((0..each).map(|k| (edge(k), edge(k + 1))));
    }
    let rows: Vec<([f64; 3], f64, f64)> = parts
        .iter()
        .map(|&(from, to)| {
            let ((mu, n), [x, y]) = (coefficient(sensor, from, to), sensor.mean(from, to));
            let size = mu * n * n;
            ([1.0, x / size, y / size], mu, (to - from) as f64)
        })
        .collect();
    // How far the parts scatter about the coefficient says what a row weighs.
    let (mut scatter, mut found, mut variance) = (1.0, [0.0; 3], 0.0);
    for _ in 0..3 {
        let mut matrix = [[0.0; 4]; 3];
        for (x, mu, weight) in &rows {
            for i in 0..3 {
                for j in 0..3 {
                    matrix[i][j] += weight / scatter * x[i] * x[j];
                }
                matrix[i][3] += weight / scatter * x[i] * mu;
            }
        }
        for i in 0..2 {
            matrix[i + 1][i + 1] += 1.0 / sensor.doubt;
            matrix[i + 1][3] -= sensor.shifted[i] / sensor.doubt;
        }
        (found, variance) = solve(matrix);
        let off = |(x, mu, weight): &([f64; 3], f64, f64)| {
            weight * (mu - found[0] - x[1] * found[1] - x[2] * found[2]).powi(2)
        };
        let free = (rows.len() as f64 - 1.0).max(1.0);
        scatter = (rows.iter().map(off).sum::<f64>() / free).max(1e-18);
    }
    let n = slips[0].from;
    let across = sensor.digits + found[0] * found[0] * sensor.doubt_across;
    let variance = variance + across / (sensor.n[n] * sensor.n[n]);
    let half = WIDER * student(rows.len() as f64 - 1.0) * libm::sqrt(variance);
    Fit {
        interval: Interval {
            from: (found[0] - half).max(0.0),
            to: found[0] + half,
        },
        offset: [found[1], found[2]],
    }
}

/// The solution of three equations whose matrix is positive, and the first number of the inverse.
fn solve(mut m: [[f64; 4]; 3]) -> ([f64; 3], f64) {
    // From the last to the first: what is left of the first alone is the inverse of its variance.
    for k in (1..3).rev() {
        for i in 0..k {
            let part = m[i][k] / m[k][k];
            let row = m[k];
            m[i].iter_mut().zip(row).for_each(|(x, y)| *x -= part * y);
        }
    }
    let a = m[0][3] / m[0][0];
    let b = (m[1][3] - m[1][0] * a) / m[1][1];
    let c = (m[2][3] - m[2][0] * a - m[2][1] * b) / m[2][2];
    ([a, b, c], 1.0 / m[0][0])
}

/// What 95 % of Student's t with so many degrees of freedom are below, in size: right to 2 % from three on.
pub fn student(free: f64) -> f64 {
    let z = 1.96;
    let free = free.max(1.0);
    z + 2.372 / free + 2.823 / (free * free) + 2.5 / free.powi(3)
}

/// Whether the slips agree among each other and within.
pub fn verdict(sensor: &Sensor, pieces: &[Piece], slips: &[Piece]) -> Verdict {
    let rows: f64 = slips.iter().map(|slip| slip.line.rows).sum();
    let level = slips
        .iter()
        .map(|slip| slip.line.rows * slip.line.y)
        .sum::<f64>()
        / rows;
    let mut others = plateaus(sensor, pieces);
    others.retain(|piece| !near(piece.line.y, level) && is_level(sensor, piece));
    if let Some((other, more)) = commonest(&others)
        && more > OTHERS * rows
    {
        return Verdict::Levels(Interval {
            from: other.min(level),
            to: other.max(level),
        });
    }
    if let Some(part) = followed(sensor, pieces, slips) {
        return Verdict::Drifts(part);
    }
    let lines: Vec<_> = slips
        .iter()
        .map(|slip| (core(slip), sensor.line(core(slip).0, core(slip).1)))
        .collect();
    let doubled = correlated(sensor, &lines);
    let (mut drift, mut bulge, mut levels) = (Vec::new(), Vec::new(), Vec::new());
    for ((from, to), line) in &lines {
        let variance = doubled * line.variance().max(1e-18);
        let last = sensor.t[to - 1] - sensor.t[*from];
        levels.push((
            coefficient(sensor, *from, *to).0 / level,
            variance / line.rows / (level * level),
        ));
        drift.push((
            line.slope() * last / level,
            variance * last * last / line.tt / (level * level),
        ));
        let quarter = (to - from) / 4;
        let (a, b) = (from + quarter, to - quarter);
        let [inner, before, after] = [(a, b), (*from, a), (b, *to)].map(|(a, b)| sensor.line(a, b));
        let outer = before.with(&after);
        bulge.push((
            (inner.y - outer.y) / level,
            variance * (1.0 / inner.rows + 1.0 / outer.rows) / (level * level),
        ));
    }
    let sure = |list: &[(f64, f64)]| {
        let (mean, error) = mean(list);
        (mean.abs() > SLIGHT.max(SURE * error)).then_some(mean)
    };
    let (average, _) = mean(&levels);
    let free = levels.len() as f64 - 1.0;
    let chi = levels
        .iter()
        .map(|(x, v)| (x - average).powi(2) / v)
        .sum::<f64>();
    let spread = libm::sqrt(
        levels
            .iter()
            .map(|(x, _)| (x - average).powi(2))
            .sum::<f64>()
            / free.max(1.0),
    );
    let (least, most) = levels
        .iter()
        .fold((f64::INFINITY, 0.0_f64), |(a, b), (x, _)| {
            (a.min(*x), b.max(*x))
        });
    if free > 0.0 && chi > free + SURE * libm::sqrt(2.0 * free) + SURE && spread > 0.75 * SLIGHT {
        Verdict::Levels(Interval {
            from: level * least,
            to: level * most,
        })
    } else if let Some(part) = sure(&drift) {
        Verdict::Drifts(part)
    } else if let Some(part) = sure(&bulge) {
        Verdict::Bulges(part)
    } else {
        Verdict::Fits
    }
}

/// By how much the coefficient changes in what follows a slip without a jump, in the same direction, if many are followed so. By
/// Coulomb's law a slip ends with a jump; that it is none is chance.
fn followed(sensor: &Sensor, pieces: &[Piece], slips: &[Piece]) -> Option<f64> {
    let (mut rows, mut those, mut sum) = (0.0, 0.0, 0.0);
    for slip in slips {
        rows += slip.line.rows;
        let after = pieces.partition_point(|piece| piece.from < slip.to);
        let next = pieces[after..]
            .iter()
            .find(|piece| piece.to - piece.from > BLOCK);
        let Some(next) = next.filter(|next| next.from <= slip.to + BLOCK) else {
            continue;
        };
        let (a, b) = (
            sensor.mean(slip.from, slip.to),
            sensor.mean(next.from, next.to),
        );
        let same =
            a[0] * b[0] + a[1] * b[1] > 0.8 * libm::hypot(a[0], a[1]) * libm::hypot(b[0], b[1]);
        let end = next.line.at(sensor.t[next.to - 1]);
        let begins = near(next.line.at(sensor.t[next.from]), slip.line.y);
        if same && begins && !is_level(sensor, next) && end > 0.5 * slip.line.y {
            those += slip.line.rows;
            sum += slip.line.rows * (end / slip.line.y - 1.0);
        }
    }
    (those > FOLLOWED * rows && sum.abs() > 2.0 * SLIGHT * those).then(|| sum / those)
}

/// The mean of numbers with variances, and its error, by these or by how they scatter.
pub fn mean(list: &[(f64, f64)]) -> (f64, f64) {
    let weight: f64 = list.iter().map(|(_, v)| 1.0 / v).sum();
    let mean = list.iter().map(|(x, v)| x / v).sum::<f64>() / weight;
    let chi = list
        .iter()
        .map(|(x, v)| (x - mean).powi(2) / v)
        .sum::<f64>();
    let free = (list.len() as f64 - 1.0).max(1.0);
    (mean, libm::sqrt((chi / free).max(1.0) / weight))
}

/// By what the correlation of neighbours, as of one filter, multiplies the variance of a mean.
fn correlated(sensor: &Sensor, lines: &[((usize, usize), Line)]) -> f64 {
    let (mut both, mut one) = (0.0, f64::MIN_POSITIVE);
    for ((from, to), line) in lines {
        let off = |k: usize| sensor.ratio[k] - line.at(sensor.t[k]);
        both += (*from..to - 1).map(|k| off(k) * off(k + 1)).sum::<f64>();
        one += (*from..*to).map(|k| off(k) * off(k)).sum::<f64>();
    }
    let part = (both / one).clamp(0.0, 0.9);
    (1.0 + part) / (1.0 - part)
}
