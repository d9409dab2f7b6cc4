//! What moves the floor: a sum of pulls, as what lies on it feels them.

use super::{SceneError, directed, quantity, unit_vector};
use crate::numerics::taylor::Coefficients;
use std::{cell::RefCell, rc::Rc};

use crate::{
    FitError, Fitted,
    acceleration::Acceleration,
    numerics::{expression::Formula, taylor::TERMS},
};

/// A part of what moves the floor.
#[derive(Debug, Clone)]
pub struct Part(Kind);

#[derive(Debug, Clone)]
enum Kind {
    Pull {
        along: [f64; 2],
        pieces: Vec<Piece>,
    },
    /// The record's x axis points along this.
    Record {
        along: [f64; 2],
        fitted: Fitted,
    },
}

/// Until a time, as a formula in t whose number is `size` times too small.
#[derive(Debug, Clone)]
struct Piece {
    formula: Formula<f64>,
    size: f64,
    until: f64,
}

impl Part {
    /// A pull on each kilogram of what lies on the floor: `SIZE[:DURATION],…[@DIRECTION]`, a size being an acceleration or an
    /// expression of one in t (in seconds), as in `4.2m/s^2:4.79s,0` or `4*sin(10*pi*t)@90deg`. After the last duration it is
    /// over.
    ///
    /// # Errors
    /// [`SceneError`] for a text that is none.
    pub fn pull(text: &str) -> Result<Self, SceneError> {
        Self::read(text, 1.0)
    }

    /// The floor's own acceleration, as for [`pull`](Self::pull), which is the opposite.
    ///
    /// # Errors
    /// As for [`pull`](Self::pull).
    pub fn accelerate(text: &str) -> Result<Self, SceneError> {
        Self::read(text, -1.0)
    }

    /// As recorded; the record's x axis points along the angle `towards`.
    pub fn record(fitted: Fitted, towards: quantity::Radian) -> Self {
        let along = unit_vector(towards.0);
        Self(Kind::Record { along, fitted })
    }

    fn read(text: &str, sign: f64) -> Result<Self, SceneError> {
        let (text, angle) = directed(text)?;
        let mut until = 0.0;
        let mut pieces = Vec::new();
        for piece in text.split(',') {
            let (size, duration) = match piece.split_once(':') {
                Some((size, duration)) => (size, duration.parse::<quantity::Second>()?.0),
                None => (piece, f64::INFINITY),
            };
            let formula = |text: &str| Formula::read(text, |digits| digits.parse().ok());
            let (formula, size) = quantity::read("an acceleration", "m/s^2", size, formula)?;
            let before = until;
            until += duration;
            if until.is_nan() || until <= before {
                return Err(SceneError::given(
                    "a duration",
                    duration,
                    "positive, and none after the last",
                ));
            }
            pieces.push(Piece {
                formula,
                size: sign * size,
                until,
            });
        }
        let along = unit_vector(angle);
        Ok(Self(Kind::Pull { along, pieces }))
    }

    /// Whether it has an expression of the time.
    pub(super) fn varies(&self) -> bool {
        match &self.0 {
            Kind::Pull { pieces, .. } => pieces.iter().any(|piece| piece.formula.fixed().is_none()),
            Kind::Record { .. } => false,
        }
    }

    /// Whether it pulls along x alone.
    pub(super) fn is_along_x(&self) -> bool {
        match &self.0 {
            Kind::Pull { along, .. } => along[1] == 0.0,
            Kind::Record { along, fitted } => along[1] == 0.0 && fitted.is_along_x(),
        }
    }

    pub(super) fn steady_pull(&self) -> Option<[f64; 2]> {
        match &self.0 {
            Kind::Pull { along, pieces } => match &pieces[..] {
                [
                    Piece {
                        formula,
                        size,
                        until: f64::INFINITY,
                    },
                ] => {
                    let one = formula.fixed()?;
                    Some(along.map(|c| c * one * size))
                }
                _ => None,
            },
            Kind::Record { .. } => None,
        }
    }

    /// A function has no pulse shorter than `width`.
    fn spans(
        &self,
        [from, to]: [f64; 2],
        width: f64,
        spans: &mut Vec<Span>,
    ) -> Result<(), SceneError> {
        let (along, pieces) = match &self.0 {
            Kind::Record { along, fitted } => {
                let [from, until] = fitted.times();
                let what = What::Fitted(fitted.clone());
                spans.push(Span {
                    from,
                    until,
                    along: *along,
                    what,
                });
                return Ok(());
            }
            Kind::Pull { along, pieces } => (*along, pieces),
        };
        let mut begin = from;
        for Piece {
            formula,
            size,
            until,
        } in pieces
        {
            let end = until.min(to);
            if end > begin {
                let what = match formula.fixed() {
                    Some(one) => What::Steady(-one * size),
                    None => {
                        let pull = |t| [-size * formula.at(t), 0.0];
                        let width = width.min(end - begin);
                        let fitted = Fitted::from_fn(pull, [begin, end], width, &[]);
                        What::Fitted(fitted.map_err(|error| match error {
                            FitError::Unresolved { t } => SceneError::Jump {
                                t: quantity::Second(t),
                            },
                            other => other.into(),
                        })?)
                    }
                };
                spans.push(Span {
                    from: begin,
                    until: *until,
                    along,
                    what,
                });
                begin = end;
            }
        }
        Ok(())
    }
}

struct Span {
    from: f64,
    until: f64,
    /// Of its first component in the plane.
    along: [f64; 2],
    what: What,
}

enum What {
    Steady(f64),
    Fitted(Fitted),
}

/// By the time up to which they go.
#[derive(Default)]
pub(super) struct Floors(RefCell<Vec<(f64, Rc<Floor>)>>);

impl Floors {
    pub(super) fn get(
        &self,
        to: f64,
        make: impl FnOnce() -> Result<Floor, SceneError>,
    ) -> Result<Rc<Floor>, SceneError> {
        let known = |all: &Vec<(f64, Rc<Floor>)>| {
            let found = all.iter().find(|(until, _)| *until == to);
            found.map(|(_, floor)| Rc::clone(floor))
        };
        if let Some(floor) = known(&self.0.borrow()) {
            return Ok(floor);
        }
        let floor = Rc::new(make()?);
        self.0.borrow_mut().push((to, Rc::clone(&floor)));
        Ok(floor)
    }
}

pub(super) struct Floor {
    spans: Vec<Span>,
    times: [f64; 2],
}

impl Floor {
    /// For these times; and a steady pull beside.
    pub(super) fn new(
        parts: &[Part],
        pull: [f64; 2],
        times: [f64; 2],
        width: f64,
    ) -> Result<Self, SceneError> {
        let mut spans = vec![Span {
            from: f64::NEG_INFINITY,
            until: f64::INFINITY,
            along: pull,
            what: What::Steady(-1.0),
        }];
        for part in parts {
            part.spans(times, width, &mut spans)?;
        }
        Ok(Self {
            spans,
            times: Self::known(parts),
        })
    }

    pub(super) fn known(parts: &[Part]) -> [f64; 2] {
        let mut known = [f64::NEG_INFINITY, f64::INFINITY];
        for part in parts {
            if let Kind::Record { fitted, .. } = &part.0 {
                let [from, to] = fitted.times();
                known = [known[0].max(from), known[1].min(to)];
            }
        }
        known
    }

    pub(super) fn steady(&self, t: f64) -> Option<[f64; 2]> {
        let [mut x, mut y] = [0.0; 2];
        for span in self.spans.iter().filter(|span| span.until > t) {
            match span.what {
                What::Steady(a) if span.until.is_infinite() && span.from <= t => {
                    (x, y) = (x - span.along[0] * a, y - span.along[1] * a);
                }
                _ => return None,
            }
        }
        Some([x, y])
    }

    fn fits(&self) -> impl Iterator<Item = &Fitted> {
        self.spans.iter().filter_map(|span| match &span.what {
            What::Fitted(fitted) => Some(fitted),
            What::Steady(_) => None,
        })
    }
}

impl Acceleration for Floor {
    fn coefficients(&self, t: f64) -> [Coefficients; 2] {
        let mut sum = [[0.0; TERMS]; 2];
        for span in self
            .spans
            .iter()
            .filter(|span| span.from <= t && t < span.until)
        {
            let [c, s] = span.along;
            match &span.what {
                What::Steady(a) => {
                    sum[0][0] += c * a;
                    sum[1][0] += s * a;
                }
                What::Fitted(fitted) => {
                    let [x, y] = fitted.coefficients(t);
                    for k in 0..TERMS {
                        sum[0][k] += c * x[k] - s * y[k];
                        sum[1][k] += s * x[k] + c * y[k];
                    }
                }
            }
        }
        sum
    }

    fn next_break(&self, t: f64) -> Option<f64> {
        let ends = self.spans.iter().flat_map(|span| [span.from, span.until]);
        let own = self.fits().filter_map(|fitted| fitted.next_break(t));
        ends.filter(|end| *end > t && end.is_finite())
            .chain(own)
            .reduce(f64::min)
    }

    fn times(&self) -> [f64; 2] {
        self.times
    }

    fn pieces(&self) -> usize {
        self.fits().map(Acceleration::pieces).sum()
    }

    fn error(&self) -> f64 {
        self.fits().map(Acceleration::error).sum()
    }
}
