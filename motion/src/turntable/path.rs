//! A finished motion on the table, in the frame in which it was integrated.

use super::{State, Table};
use crate::Coefficients;
use crate::clock::Clocked;
use crate::error::MotionError;
use crate::track::{Part, Track};
use crate::trajectory::{Phase, PhaseKind};

#[derive(Debug, Clone, PartialEq)]
pub(super) enum Leg {
    /// Sliding; components t, x, y, v_x, v_y.
    Slide(Clocked<5>),
    /// Coefficients of x, y, v_x, v_y in powers of t − from.
    Onset {
        from: f64,
        series: Box<[Coefficients; 4]>,
    },
    /// At a steady deceleration relative to the table; a state in its frame.
    Stopping {
        state: State,
        to: f64,
    },
    Rest {
        from: f64,
        place: [f64; 2],
    },
}

impl Leg {
    fn from(&self) -> f64 {
        match self {
            Self::Slide(slide) => slide
                .nodes()
                .next()
                .map_or(f64::NEG_INFINITY, |node| node[0]),
            Self::Stopping { state, .. } => state.t,
            Self::Onset { from, .. } | Self::Rest { from, .. } => *from,
        }
    }
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Frame {
    Table,
    Laboratory,
}

/// A motion from a start to an end.
#[derive(Debug, Clone, PartialEq)]
pub struct Path {
    pub(super) table: Table,
    pub(super) frame: Frame,
    pub(super) legs: Vec<Leg>,
    pub(super) stops: Vec<f64>,
    pub(super) start: f64,
    pub(super) end: f64,
}

impl Path {
    /// The times at which the speed relative to the table becomes zero.
    pub fn stops(&self) -> &[f64] {
        &self.stops
    }

    /// Where on the table, in its own axes, the particle rests at the end, if it does.
    pub fn resting_place(&self) -> Option<[f64; 2]> {
        match self.legs.last() {
            Some(Leg::Rest { place, .. }) => Some(*place),
            _ => None,
        }
    }

    /// Its slides and rests, in order.
    pub fn phases(&self) -> Vec<Phase> {
        let ends = self.legs.iter().skip(1).map(Leg::from).chain([self.end]);
        let mut phases: Vec<Phase> = Vec::new();
        for (leg, to) in self.legs.iter().zip(ends) {
            let kind = match leg {
                Leg::Rest { .. } => PhaseKind::Stick,
                _ => PhaseKind::Slide,
            };
            match phases.last_mut() {
                Some(last) if last.kind == kind => last.to = to,
                _ => phases.push(Phase {
                    kind,
                    from: leg.from(),
                    to,
                }),
            }
        }
        phases
    }

    /// Time at the end.
    pub fn end(&self) -> f64 {
        self.end
    }

    /// State at time `t` in the frame of the integration.
    ///
    /// # Errors
    /// [`MotionError::Argument`] for a time before the start or after the end.
    pub fn at(&self, t: f64) -> Result<State, MotionError> {
        let range = "between the start and the end of the motion";
        super::argument("t", t, t >= self.start && t <= self.end, range)?;
        let index = self.legs.partition_point(|leg| leg.from() <= t);
        match &self.legs[index.saturating_sub(1)] {
            Leg::Slide(slide) => {
                let [_, x, y, u, v] = slide.at(t)?;
                Ok(State {
                    t,
                    x: [x, y],
                    v: [u, v],
                })
            }
            Leg::Onset { from, series } => {
                let [x, y, u, v] =
                    [0, 1, 2, 3].map(|i| crate::numerics::series::value(&series[i], &(t - from)));
                Ok(State {
                    t,
                    x: [x, y],
                    v: [u, v],
                })
            }
            Leg::Stopping { state, to } => {
                let part = ((t - state.t) / (to - state.t)).min(1.0);
                let way = (t - state.t) * (1.0 - 0.5 * part);
                Ok(self.seen(State {
                    t,
                    x: [0, 1].map(|i| state.x[i] + way * state.v[i]),
                    v: state.v.map(|v| (1.0 - part) * v),
                }))
            }
            Leg::Rest { place, .. } => Ok(self.seen(State {
                t,
                x: *place,
                v: [0.0; 2],
            })),
        }
    }

    /// Its way on the table; in the laboratory's frame, places of it are right for distances from the axis alone.
    pub(crate) fn track(&self) -> Result<Track<'_>, MotionError> {
        let omega = match self.frame {
            Frame::Table => 0.0,
            Frame::Laboratory => self.table.omega,
        };
        // The velocity relative to the table.
        let relative = |v: &Coefficients, x: &Coefficients, omega: f64| -> Vec<f64> {
            v.iter().zip(x).map(|(v, x)| v + omega * x).collect()
        };
        let mut parts = Vec::new();
        let ends = self.legs.iter().skip(1).map(Leg::from).chain([self.end]);
        for (leg, end) in self.legs.iter().zip(ends) {
            match leg {
                Leg::Slide(slide) => parts.extend(slide.steps().iter().map(|step| {
                    let [t, x, y, u, v] = &step.series;
                    let w = [relative(u, y, omega), relative(v, x, -omega)];
                    Part::clocked(t, step.h, w, [x, y])
                })),
                Leg::Onset { from, series } => {
                    let [x, y, u, v] = &**series;
                    let w = [relative(u, y, omega), relative(v, x, -omega)];
                    parts.push(Part::timed(*from, end - from, w, [x, y]));
                }
                Leg::Stopping { state, to } => {
                    let slowing = |i: usize| state.v[i] / (state.t - to);
                    let v = [0, 1].map(|i| vec![state.v[i], slowing(i)]);
                    let x = [0, 1].map(|i| vec![state.x[i], state.v[i], 0.5 * slowing(i)]);
                    parts.push(Part::timed(state.t, to.min(self.end) - state.t, v, x));
                }
                Leg::Rest { .. } => {}
            }
        }
        let start = self.at(self.start)?.x;
        // Without friction it may pass through rest.
        let free = self.table.friction() == 0.0;
        let parts = parts.into_iter();
        let parts = parts.map(|part| if free { part.cornered() } else { Ok(part) });
        Track::new([self.start, self.end], start, parts)
    }

    /// State at time `t` relative to the table.
    ///
    /// # Errors
    /// As for [`at`](Self::at).
    pub fn on_table(&self, t: f64) -> Result<State, MotionError> {
        let state = self.at(t)?;
        Ok(match self.frame {
            Frame::Table => state,
            Frame::Laboratory => self.table.to_table(&state),
        })
    }

    fn seen(&self, state: State) -> State {
        match self.frame {
            Frame::Table => state,
            Frame::Laboratory => self.table.to_laboratory(&state),
        }
    }
}
