//! Maps of fates at one A, in the plane of α and ψ: simulation says where the boundary runs, validated integration
//! proves the fates on both sides of it.

use super::prelude::*;
use crate::validated::turntable::{Margins, Strip};
use rayon::prelude::*;
use std::fmt;
use trialbook::certified::interval::Interval;
use trialbook::data::{Text, text};

/// Largest α of a map. Simulation decides whether the boundary lies below it.
pub const REACH: f64 = 1.5;

/// The range of ψ: a little more than once round.
pub const ROUND: f64 = 31_416.0 / 10_000.0;

/// Strips of a map, and how often one is halved where a straight line does not follow the boundary.
pub(crate) const STRIPS: u32 = 32;
const HALVINGS: u32 = 4;

/// How near to the line proofs are to come, as a share of the way to the map's edge.
const NEAREST: f64 = 2e-4;

/// The maps that were made once, since it takes long.
pub const RECORD: Text = text!("snapshots/fates.csv");

/// The boundary is found to this width in α.
const WIDTH: f64 = 1e-9;

/// The columns of the record.
pub const HEAD: &str = "A,psi_from,psi_to,line_from,line_to,rest,escape";

/// A strip of a map, and what is proved of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// A, dimensionless.
    pub a: f64,
    /// The ends of the range of ψ, in radians.
    pub psi: [f64; 2],
    /// α at the ends of the line.
    pub line: [f64; 2],
    /// Up to where fates are proved, in shares of the way from the line to the map's edges.
    pub rest: f64,
    /// As `rest`, above the line.
    pub escape: f64,
}

impl Row {
    /// The strip.
    pub fn strip(&self) -> Strip {
        Strip {
            a: Interval::decimal(self.a),
            psi: self.psi,
            line: self.line,
            reach: REACH,
        }
    }

    /// What is proved of it.
    pub fn margins(&self) -> Margins {
        Margins {
            rest: self.rest,
            escape: self.escape,
        }
    }

    /// α up to which all come to rest, at the ends of the range.
    pub fn rests(&self) -> [f64; 2] {
        self.line.map(|line| (1.0 - self.rest) * line)
    }

    /// α from which all escape.
    pub fn escapes(&self) -> [f64; 2] {
        self.line.map(|line| line + self.escape * (REACH - line))
    }
}

impl fmt::Display for Row {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Row {
            a,
            psi: [from, to],
            line: [first, last],
            rest,
            escape,
        } = self;
        write!(f, "{a},{from},{to},{first},{last},{rest},{escape}")
    }
}

/// α at which particles with this A and ψ pass from rest to escape, as simulation has it: the first α from which one
/// escapes may lie lower where the boundary folds.
///
/// # Errors
/// Those of the motion.
pub fn line(a: f64, psi: f64) -> Result<f64, MotionError> {
    // p + ρ = A exp(α) < 1: it comes to rest.
    let rest = (1.0 - 1e-9) * libm::log(1.0 / a);
    between(|alpha| Start::hyperbolic(a, alpha, psi), rest, REACH, WIDTH)
}

/// The n-th of the [`STRIPS`] of a map, in parts as narrow as the line needs.
///
/// # Errors
/// Those of the motion.
pub fn strip(a: f64, n: u32) -> Result<Vec<Row>, MotionError> {
    let psi = [n, n + 1].map(|k| ROUND * (2.0 * f64::from(k) / f64::from(STRIPS) - 1.0));
    let row = Row {
        a,
        psi,
        line: [line(a, psi[0])?, line(a, psi[1])?],
        rest: 1.0,
        escape: 1.0,
    };
    parts(row, HALVINGS)
}

fn parts(mut row: Row, halvings: u32) -> Result<Vec<Row>, MotionError> {
    let strip = row.strip();
    let (aim, straight) = aim(&row)?;
    let margins = strip.margins(row.margins(), aim);
    (row.rest, row.escape) = (margins.rest, margins.escape);
    if halvings == 0 || (straight && margins == aim) {
        return Ok(vec![row]);
    }
    let middle = 0.5 * (row.psi[0] + row.psi[1]);
    let on_line = line(row.a, middle)?;
    let halves = [0, 1].map(|half| {
        let (mut psi, mut line) = (row.psi, row.line);
        (psi[1 - half], line[1 - half]) = (middle, on_line);
        let part = Row { psi, line, ..row };
        let Margins { rest, escape } = strip.inherited(margins, &part.strip());
        Row {
            rest,
            escape,
            ..part
        }
    });
    let [first, second] = halves.map(|half| parts(half, halvings - 1));
    Ok([first?, second?].concat())
}

/// How near to the line proofs can come, for all that simulation says; and whether that is as near as they have to.
fn aim(row: &Row) -> Result<(Margins, bool), MotionError> {
    let mut aim = Margins {
        rest: NEAREST,
        escape: NEAREST,
    };
    for quarter in 1..4 {
        let share = 0.25 * f64::from(quarter);
        let [psi, straight] = [row.psi, row.line].map(|[from, to]| from + share * (to - from));
        let off = line(row.a, psi)? - straight;
        // The sampled deviation is not the greatest.
        aim.rest = aim.rest.max(-1.5 * off / straight);
        aim.escape = aim.escape.max(1.5 * off / (REACH - straight));
    }
    let straight = aim.rest.max(aim.escape) == NEAREST;
    Ok((aim, straight))
}

/// The part of a map's area in which nothing is proved.
pub fn open(rows: &[Row]) -> f64 {
    let open = rows.iter().map(|row| row.strip().undecided(&row.margins()));
    open.sum::<f64>() / (2.0 * ROUND * REACH)
}

/// Of which commit the recorded maps are.
pub fn as_of() -> &'static str {
    trialbook::trials::as_of(&RECORD)
}

/// The maps that the book shows, as `examples/fates.rs` made them; nothing where a line is not one of theirs.
pub fn recorded() -> Option<Vec<Vec<Row>>> {
    let mut maps: Vec<Vec<Row>> = Vec::new();
    for line in RECORD.lines().skip(1) {
        let cells: Result<Vec<f64>, _> = line.split(',').map(str::parse).collect();
        let Ok(cells) = cells else {
            return None;
        };
        let &[a, from, to, first, last, rest, escape] = cells.as_slice() else {
            return None;
        };
        let row = Row {
            a,
            psi: [from, to],
            line: [first, last],
            rest,
            escape,
        };
        match maps.last_mut() {
            Some(map) if map.last().is_some_and(|known| known.a == a) => map.push(row),
            _ => maps.push(vec![row]),
        }
    }
    Some(maps)
}

/// A map, strip by strip from ψ = −[`ROUND`] to [`ROUND`]; `done` is told of each strip.
///
/// Cost: a quarter of an hour on two cores.
///
/// # Errors
/// Those of the motion: for an A at which a particle does not rest or escape within [`REACH`].
pub fn map(a: f64, done: impl Fn() + Sync) -> Result<Vec<Row>, MotionError> {
    let strips = (0..STRIPS).into_par_iter().map(|n| {
        let rows = strip(a, n);
        done();
        rows
    });
    let strips: Result<Vec<_>, _> = strips.collect();
    Ok(strips?.concat())
}
