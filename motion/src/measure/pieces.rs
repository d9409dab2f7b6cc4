//! A recording as a chain of straight pieces: neighbours become one until no straight line serves both.

use std::{cmp::Ordering, collections::BinaryHeap};

/// Rows of the shortest piece.
pub const BLOCK: usize = 4;
/// What counts for the noise of a piece beside its own rows: so many rows of the noise of all.
const BEFORE: f64 = 4.0;

/// The straight line through rows, by their moments about their means.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Line {
    pub rows: f64,
    pub t: f64,
    pub y: f64,
    pub tt: f64,
    pub ty: f64,
    pub yy: f64,
}

impl Line {
    pub fn through(rows: impl IntoIterator<Item = (f64, f64)>) -> Self {
        let one = |(t, y)| Self {
            rows: 1.0,
            t,
            y,
            ..Self::default()
        };
        rows.into_iter()
            .fold(Self::default(), |line, row| line.with(&one(row)))
    }

    pub fn with(&self, other: &Self) -> Self {
        let rows = self.rows + other.rows;
        let (t, y) = (other.t - self.t, other.y - self.y);
        let (part, weight) = (other.rows / rows, self.rows * other.rows / rows);
        Self {
            rows,
            t: self.t + part * t,
            y: self.y + part * y,
            tt: self.tt + other.tt + weight * t * t,
            ty: self.ty + other.ty + weight * t * y,
            yy: self.yy + other.yy + weight * y * y,
        }
    }

    pub fn slope(&self) -> f64 {
        if self.tt > 0.0 {
            self.ty / self.tt
        } else {
            0.0
        }
    }

    pub fn at(&self, t: f64) -> f64 {
        self.y + self.slope() * (t - self.t)
    }

    /// The squares that the line leaves.
    pub fn left(&self) -> f64 {
        (self.yy - self.slope() * self.ty).max(0.0)
    }

    /// The variance about the line.
    pub fn variance(&self) -> f64 {
        self.left() / (self.rows - 2.0).max(1.0)
    }
}

/// What a polynomial leaves of rows, its value at a time, and the variance of that for rows of variance one.
pub struct Curve {
    pub left: f64,
    pub value: f64,
    pub variance: f64,
}

/// The polynomial of least squares, by others that are orthogonal on the rows.
pub fn curve(t: &[f64], y: &[f64], degree: usize, at: f64) -> Curve {
    let (first, last) = (
        t.first().copied().unwrap_or(0.0),
        t.last().copied().unwrap_or(1.0),
    );
    let half = 0.5 * (last - first).max(f64::MIN_POSITIVE);
    // The place asked for is a row without weight.
    let s: Vec<_> = t
        .iter()
        .chain([&at])
        .map(|t| (t - first) / half - 1.0)
        .collect();
    let n = t.len();
    let mut left = y.to_vec();
    let (mut before, mut this) = (vec![0.0; n + 1], vec![1.0; n + 1]);
    let (mut norm_before, mut value, mut variance) = (1.0, 0.0, 0.0);
    for k in 0..=degree.min(n.saturating_sub(1)) {
        let norm: f64 = this[..n].iter().map(|p| p * p).sum();
        let part = this.iter().zip(&left).map(|(p, y)| p * y).sum::<f64>() / norm;
        left.iter_mut().zip(&this).for_each(|(y, p)| *y -= part * p);
        value += part * this[n];
        variance += this[n] * this[n] / norm;
        let a = this[..n]
            .iter()
            .zip(&s)
            .map(|(p, s)| p * p * s)
            .sum::<f64>()
            / norm;
        let b = if k == 0 { 0.0 } else { norm / norm_before };
        let next = (0..=n)
            .map(|i| (s[i] - a) * this[i] - b * before[i])
            .collect();
        norm_before = norm;
        before = std::mem::replace(&mut this, next);
    }
    let left = left.iter().map(|y| y * y).sum();
    Curve {
        left,
        value,
        variance,
    }
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Piece {
    /// Its rows, from the first to before the last.
    pub from: usize,
    pub to: usize,
    pub line: Line,
}

impl Piece {
    fn cost(line: &Line, noise: f64) -> f64 {
        let free = line.rows - 2.0 + BEFORE;
        free * libm::log((line.left() / noise + BEFORE) / free)
    }
}

/// Cuts rows into pieces, with the variance of the noise where there is least of it. Neighbours stay apart that are less likely one
/// by a factor exp(`penalty`/2). O(n log n).
pub fn cut(t: &[f64], y: &[f64], noise: f64, penalty: f64) -> Vec<Piece> {
    let n = t.len();
    let mut pieces: Vec<Option<Piece>> = (0..n / BLOCK)
        .map(|k| {
            let from = k * BLOCK;
            let to = if n - from < 2 * BLOCK {
                n
            } else {
                from + BLOCK
            };
            let rows = t[from..to].iter().copied().zip(y[from..to].iter().copied());
            let line = Line::through(rows);
            Some(Piece { from, to, line })
        })
        .collect();
    let last = pieces.len();
    let (mut before, mut after): (Vec<_>, Vec<_>) = (
        (0..last).map(|k| k.wrapping_sub(1)).collect(),
        (1..=last).collect(),
    );
    let loss = |a: &Piece, b: &Piece| {
        let both = a.line.with(&b.line);
        Piece::cost(&both, noise) - Piece::cost(&a.line, noise) - Piece::cost(&b.line, noise)
    };
    let mut heap: BinaryHeap<Pair> = BinaryHeap::new();
    let offer = |heap: &mut BinaryHeap<Pair>, pieces: &[Option<Piece>], a: usize, b: usize| {
        if let (Some(Some(left)), Some(Some(right))) = (pieces.get(a), pieces.get(b)) {
            let loss = loss(left, right);
            if loss < penalty {
                let ends = [left.from, right.to];
                heap.push(Pair { loss, a, b, ends });
            }
        }
    };
    for k in 1..last {
        offer(&mut heap, &pieces, k - 1, k);
    }
    while let Some(Pair { a, b, ends, .. }) = heap.pop() {
        let (Some(left), Some(right)) = (pieces[a], pieces[b]) else {
            continue;
        };
        if [left.from, right.to] != ends {
            continue;
        }
        pieces[a] = Some(Piece {
            from: left.from,
            to: right.to,
            line: left.line.with(&right.line),
        });
        pieces[b] = None;
        after[a] = after[b];
        if let Some(next) = before.get_mut(after[b]) {
            *next = a;
        }
        offer(&mut heap, &pieces, before[a], a);
        offer(&mut heap, &pieces, a, after[a]);
    }
    pieces.into_iter().flatten().collect()
}

/// Two neighbours, and what is lost by making them one.
#[derive(PartialEq)]
struct Pair {
    loss: f64,
    a: usize,
    b: usize,
    ends: [usize; 2],
}

impl Eq for Pair {}

impl Ord for Pair {
    fn cmp(&self, other: &Self) -> Ordering {
        other.loss.total_cmp(&self.loss).then(other.a.cmp(&self.a))
    }
}

impl PartialOrd for Pair {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}
