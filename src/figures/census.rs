//! Who comes to rest, by simulation: a census over a plane of starts on the turntable.

use super::{AllFiguresError, Drawn};
use crate::motion::MotionError;
use crate::motion::turntable::Start;
use crate::motion::turntable::ensemble::rests;
use trialbook::plotting::{Axis, FigureError, Panel, Raster};

/// Cells of equal size, `side` along each side.
pub(super) struct Census {
    pub side: usize,
    /// Ends of the axis to the right, and of the one upwards.
    pub ends: [(f64, f64); 2],
    /// Rest or not, row by row from the lowest.
    pub rests: Vec<bool>,
}

impl Census {
    pub(super) fn new(
        side: usize,
        ends: [(f64, f64); 2],
        start: impl Fn([f64; 2]) -> Result<Start, MotionError>,
    ) -> Drawn<Self> {
        let starts = (0..side * side).map(|k| start(middle(ends, side, k)));
        let starts: Result<Vec<_>, _> = starts.collect();
        let certain: Option<Vec<bool>> = rests(&starts?)?.into_iter().collect();
        let undecided = || AllFiguresError::Data("the fate of a cell is not certain".into());
        Ok(Census {
            side,
            ends,
            rests: certain.ok_or_else(undecided)?,
        })
    }

    /// The middles of the cells, each with 1 for rest or 0 for escape.
    pub(super) fn rows(&self) -> impl Iterator<Item = ([f64; 2], f64)> {
        let rests = self.rests.iter().enumerate();
        rests.map(|(k, rests)| {
            let rests = f64::from(u8::from(*rests));
            (middle(self.ends, self.side, k), rests)
        })
    }

    pub(super) fn panel(&self, [x, y]: [Axis; 2]) -> Result<Panel, FigureError> {
        let [along, up] = self.ends;
        let cells = self.rests.iter().map(|rests| u8::from(!rests)).collect();
        let raster = Raster::new(self.side, self.side, along, up, cells)?
            .class("rest", 0, 0.35)
            .class("escape", 1, 0.08);
        Ok(Panel::new(x.range(along.0, along.1), y.range(up.0, up.1)).raster(raster))
    }
}

fn middle(ends: [(f64, f64); 2], side: usize, k: usize) -> [f64; 2] {
    let at = |(from, to): (f64, f64), i: usize| from + (to - from) * (i as f64 + 0.5) / side as f64;
    [at(ends[0], k % side), at(ends[1], k / side)]
}
