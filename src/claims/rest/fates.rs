//! A map of fates: at one A, up to where in the plane of α and ψ a particle is proved to come to rest, and from where
//! on to escape. Where the line between them is to run, bisection on the motion proposes; what is proved on its two
//! sides does not depend on that.

use crate::certified::turntable::{Margins, Strip};
use crate::certified::written::decimal;
use crate::motion::MotionError;
use crate::motion::turntable::Start;
use crate::motion::turntable::boundary::between;
use crate::motion::turntable::fate::rests;
use crate::numerics::error::plain;
use rayon::prelude::*;
use std::f64::consts::PI;

/// What is proved in one strip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// A, dimensionless, to six decimals.
    pub a: f64,
    /// The ends of the strip's range of ψ, in radians.
    pub psi: [f64; 2],
    /// α of the line at the ends.
    pub line: [f64; 2],
    /// Up to where.
    pub margins: Margins,
}

/// The largest α of a map.
pub const REACH: f64 = 2.0;

/// Between these ends of A the line lies well within the map.
pub const RANGE: [f64; 2] = [0.4, 0.95];

/// Strips at first.
pub const STRIPS: usize = 128;

/// A strip of which a larger share stays open is tried again in halves, so many times at most.
const OPEN: f64 = 9e-4;
const HALVINGS: u32 = 6;

/// Width to which the line is found.
const WIDTH: f64 = 1e-9;

/// Steps in α, in which a place beyond the line is looked for.
const STEP: f64 = 0.01;

/// The map at `a`, in order of ψ, from −π to π; `done` is called for each of the [`STRIPS`].
///
/// Cost: some 50,000 enclosed motions, minutes on two cores.
///
/// # Errors
/// [`MotionError::Argument`] for an A out of [`RANGE`]; and the errors of the motion.
pub fn map(a: f64, done: impl Fn() + Sync) -> Result<Vec<Row>, MotionError> {
    let [least, most] = RANGE;
    let millionths = (a * 1e6).round();
    if !(least..=most).contains(&a) || millionths / 1e6 != a {
        return Err(MotionError::Argument {
            name: "A",
            value: a,
            range: "between 0.4 and 0.95, with six decimals at most",
        });
    }
    // The number next to π from above: together the strips are the whole circle.
    let end = PI.next_up();
    let at = |k: usize| end * (2.0 * k as f64 / STRIPS as f64 - 1.0);
    let strips = (0..STRIPS).into_par_iter().map(|k| {
        let rows = refined(a, [at(k), at(k + 1)], HALVINGS);
        done();
        rows
    });
    let rows: Result<Vec<_>, _> = strips.collect();
    Ok(rows?.concat())
}

/// What is proved between two angles, in as many parts as it takes.
fn refined(a: f64, psi: [f64; 2], halvings: u32) -> Result<Vec<Row>, MotionError> {
    let [from, to] = psi;
    let mut row = Row {
        a,
        psi,
        line: [line(a, from)?, line(a, to)?],
        margins: Margins {
            rest: 1.0,
            escape: 1.0,
        },
    };
    row.margins = row.strip().margins();
    if halvings == 0 || row.open() <= OPEN {
        return Ok(vec![row]);
    }
    let middle = 0.5 * (from + to);
    let parts = [[from, middle], [middle, to]].map(|psi| refined(a, psi, halvings - 1));
    let [first, second] = parts;
    Ok([first?, second?].concat())
}

/// α where the motion passes from rest to escape.
fn line(a: f64, psi: f64) -> Result<f64, MotionError> {
    let start = |alpha: f64| Start::hyperbolic(a, alpha, psi);
    // With p + ρ = A exp(α) below 1 it comes to rest.
    let rest = -libm::log(a) * (1.0 - 1e-9);
    let mut beyond = rest + STEP;
    while beyond < REACH && rests(&start(beyond)?)? != Some(false) {
        beyond += STEP;
    }
    between(start, rest, beyond, WIDTH)
}

impl Row {
    /// The strip, as it is put to the proof.
    pub fn strip(&self) -> Strip {
        Strip {
            a: decimal(self.a),
            psi: self.psi,
            line: self.line,
            reach: REACH,
        }
    }

    /// The share of the strip of which nothing is proved.
    pub fn open(&self) -> f64 {
        let [from, to] = self.psi;
        self.strip().undecided(&self.margins) / ((to - from) * REACH)
    }

    /// α at an angle of the strip: up to the first all come to rest, from the second on all escape.
    pub fn proved(&self, psi: f64) -> [f64; 2] {
        let [from, to] = self.psi;
        let line = self.line[0] + (psi - from) * (self.line[1] - self.line[0]) / (to - from);
        let Margins { rest, escape } = self.margins;
        [line * (1.0 - rest), line + escape * (REACH - line)]
    }

    /// As cells of a table.
    pub fn cells(&self) -> [String; 7] {
        let Margins { rest, escape } = self.margins;
        let [from, to] = self.psi;
        [self.a, from, to, self.line[0], self.line[1], rest, escape].map(plain)
    }
}

/// Heads of the columns of such a table.
pub const HEAD: [&str; 7] = [
    "A",
    "psi_from",
    "psi_to",
    "line_from",
    "line_to",
    "rest",
    "escape",
];

/// The share of a map of which nothing is proved.
pub fn open(rows: &[Row]) -> f64 {
    let area = |row: &Row| (row.psi[1] - row.psi[0]) * row.open();
    rows.iter().map(area).sum::<f64>() / (2.0 * PI)
}

/// The maps that the command `fates` has made for the book, in order of A.
///
/// # Errors
/// The number of a line that is none of a table of [`HEAD`].
pub fn recorded() -> Result<Vec<Vec<Row>>, usize> {
    let mut maps: Vec<Vec<Row>> = Vec::new();
    for (n, line) in include_str!("../../../snapshots/fates.csv")
        .lines()
        .enumerate()
        .skip(1)
    {
        let row = read(line).ok_or(n + 1)?;
        match maps.last_mut() {
            Some(map) if map[0].a == row.a => map.push(row),
            _ => maps.push(vec![row]),
        }
    }
    Ok(maps)
}

fn read(line: &str) -> Option<Row> {
    let numbers: Option<Vec<f64>> = line.split(',').map(|cell| cell.parse().ok()).collect();
    let [a, from, to, first, last, rest, escape] = numbers?.try_into().ok()?;
    Some(Row {
        a,
        psi: [from, to],
        line: [first, last],
        margins: Margins { rest, escape },
    })
}
