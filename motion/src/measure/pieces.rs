//! A recording as a chain of straight pieces: neighbours become one until no straight line serves both.

use std::{
    cmp::Reverse,
    collections::{BTreeMap, BinaryHeap},
};

pub(super) const BLOCK: usize = 4;
/// So many rows of the noise of all count beside a piece's own rows.
const BEFORE: f64 = 4.0;

/// By the moments of its rows about their means.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Line {
    pub rows: f64,
    pub t: f64,
    pub y: f64,
    pub tt: f64,
    pub ty: f64,
    pub yy: f64,
}

impl Line {
    pub(super) fn through(rows: impl IntoIterator<Item = (f64, f64)>) -> Self {
        let one = |(t, y)| Self {
            rows: 1.0,
            t,
            y,
            ..Self::default()
        };
        rows.into_iter()
            .fold(Self::default(), |line, row| line.with(&one(row)))
    }

    pub(super) fn with(&self, other: &Self) -> Self {
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

    pub(super) fn slope(&self) -> f64 {
        self.ty / self.tt.max(f64::MIN_POSITIVE)
    }

    pub(super) fn at(&self, t: f64) -> f64 {
        self.y + self.slope() * (t - self.t)
    }

    /// The squares that the line leaves.
    pub(super) fn left(&self) -> f64 {
        (self.yy - self.slope() * self.ty).max(0.0)
    }

    pub(super) fn variance(&self) -> f64 {
        self.left() / (self.rows - 2.0).max(1.0)
    }
}

#[derive(Clone, Copy)]
pub(super) struct Squares<const N: usize> {
    pub found: [f64; N],
    pub spread: [[f64; N]; N],
    /// What is left of the rows, in squares of their errors.
    pub left: f64,
}

impl<const N: usize> Squares<N> {
    /// From what is known before, with variances.
    pub(super) fn new(found: [f64; N], variances: [f64; N]) -> Self {
        let mut spread = [[0.0; N]; N];
        for i in 0..N {
            spread[i][i] = variances[i];
        }
        Self {
            found,
            spread,
            left: 0.0,
        }
    }

    pub(super) fn expected(&self, x: &[f64; N]) -> (f64, f64) {
        (
            dot(x, &self.found),
            dot(x, &self.spread.map(|row| dot(x, &row))),
        )
    }

    pub(super) fn add(&mut self, x: &[f64; N], y: f64, variance: f64) {
        let (value, doubt) = self.expected(x);
        let (off, all) = (y - value, doubt + variance);
        let part = self.spread.map(|row| dot(x, &row));
        for i in 0..N {
            self.found[i] += part[i] * off / all;
            for j in 0..N {
                self.spread[i][j] -= part[i] * part[j] / all;
            }
        }
        self.left += off * off / all;
    }
}

fn dot<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Piece {
    /// Its rows, from the first to before the last.
    pub from: usize,
    pub to: usize,
    pub line: Line,
}

impl Piece {
    fn with(&self, next: &Self) -> Self {
        Self {
            from: self.from,
            to: next.to,
            line: self.line.with(&next.line),
        }
    }

    fn cost(&self, noise: f64) -> f64 {
        let free = self.line.rows - 2.0 + BEFORE;
        free * libm::log((self.line.left() / noise + BEFORE) / free)
    }
}

/// Neighbours stay apart that are less likely one by a factor exp(`penalty`/2). O(n log n).
pub(super) fn cut(t: &[f64], y: &[f64], noise: f64, penalty: f64) -> Vec<Piece> {
    let n = t.len();
    let block = |k: usize| {
        let from = k * BLOCK;
        let to = if n - from < 2 * BLOCK {
            n
        } else {
            from + BLOCK
        };
        let line = Line::through((from..to).map(|k| (t[k], y[k])));
        (from, Piece { from, to, line })
    };
    let mut pieces: BTreeMap<_, _> = (0..n / BLOCK).map(block).collect();
    let mut heap = BinaryHeap::new();
    let offer = |heap: &mut BinaryHeap<_>, pieces: &BTreeMap<usize, Piece>, from: usize| {
        let mut two = pieces.range(from..).map(|(_, piece)| piece);
        if let (Some(a), Some(b)) = (two.next(), two.next()) {
            let loss = a.with(b).cost(noise) - a.cost(noise) - b.cost(noise);
            if loss < penalty {
                // The bits of positive numbers are ordered as these; no loss is as negative.
                let order = (loss + 1e9).max(0.0).to_bits();
                heap.push(Reverse((order, a.from, b.from, b.to)));
            }
        }
    };
    for k in 0..n / BLOCK {
        offer(&mut heap, &pieces, k * BLOCK);
    }
    while let Some(Reverse((_, a, b, to))) = heap.pop() {
        let (Some(left), Some(right)) = (pieces.get(&a), pieces.get(&b)) else {
            continue;
        };
        if left.to != b || right.to != to {
            continue;
        }
        let both = left.with(right);
        pieces.insert(a, both);
        pieces.remove(&b);
        if let Some((&before, _)) = pieces.range(..a).next_back() {
            offer(&mut heap, &pieces, before);
        }
        offer(&mut heap, &pieces, a);
    }
    pieces.into_values().collect()
}
