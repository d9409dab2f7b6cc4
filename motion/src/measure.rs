//! Friction from a recording: how much an accelerometer on a sliding body says of μ_k and μ_s.
//!
//! An accelerometer that lies on the sliding body, or is it, as a phone does, feels the force of contact per mass, however the
//! floor is shaken or tilted: along the floor friction f/m, across it N/m. Where Coulomb's law holds, a slip is a plateau, |f| =
//! μ_k N, that ends with a jump or a kink, and |f| ≤ μ_s N is all that is known of the rest.
//!
//! A sensor on the *floor* says nothing of friction; nor can a recording tell a plateau of slip from a floor that for a while
//! accelerates evenly: it is taken for granted that the body slid. A rest on a tilted floor is told from a slip by x² + z² = g².
//! More than friction acts while a hand pushes the body, or a stop catches it.

mod holding;
mod kinetic;
mod pieces;
mod sensor;

#[cfg(test)]
mod tests;

use crate::fitted::{G, Recording};
use pieces::Piece;
use sensor::Sensor;
use std::fmt;

/// What is known of body and sensor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// Acceleration of gravity, in m/s², from 0.001 to 1000.
    pub g: f64,
    /// Times, in s, between which the body lay at rest on level floor: they show the zeros of the sensor. Where none are given,
    /// quiet stretches with less than g/20 along the floor count as such.
    pub rest: Option<[f64; 2]>,
    /// Standard deviation of the zeros if there is no rest, in m/s², from 0.001 to 1000.
    pub offset: f64,
}

impl Default for Settings {
    fn default() -> Self {
        Self {
            g: G,
            rest: None,
            offset: 0.1,
        }
    }
}

/// Between which numbers one lies, with a probability of 95 %.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    /// The lower end,
    pub from: f64,
    /// and the upper.
    pub to: f64,
}

/// What the body does between two times.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stretch {
    /// Its first time, in s,
    pub from: f64,
    /// and its last.
    pub to: f64,
    /// What the body does.
    pub kind: Kind,
}

/// What a body can do.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// It sticks, as far as one can see.
    Stick,
    /// It slides, by friction alone.
    Slip,
    /// More acts on it than friction can: a hand, or a stop.
    Pushed,
}

/// Whether Coulomb's law fits the slips.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Verdict {
    /// Nothing speaks against it.
    Fits,
    /// Slips have different coefficients: either there are two floors or loads, or friction depends on speed or time, or some of them are none.
    Levels(Interval),
    /// The coefficient changes during a slip, by this part from its beginning to its end.
    Drifts(f64),
    /// There is no slip that could tell, or slips to and fro differ as by a tilt that is not known.
    Untold,
}

/// In a word or two: it *sticks*, *slips*, *is pushed*.
impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(match self {
            Self::Stick => "sticks",
            Self::Slip => "slips",
            Self::Pushed => "is pushed",
        })
    }
}

/// To two digits of its width.
impl fmt::Display for Interval {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let width = (self.to - self.from).max(1e-9);
        let decimals = (1.0 - libm::floor(libm::log10(width))).clamp(0.0, 12.0) as usize;
        write!(f, "{:.decimals$} to {:.decimals$}", self.from, self.to)
    }
}

/// In words.
impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Fits => f.write_str("fits: nothing speaks against it"),
            Self::Untold => f.write_str("cannot be told from this"),
            Self::Levels(levels) => {
                write!(f, "does not fit: slips have coefficients from {levels}")
            }
            Self::Drifts(part) => {
                let (way, percent) = (
                    if *part < 0.0 { "falls" } else { "rises" },
                    100.0 * part.abs(),
                );
                write!(
                    f,
                    "does not fit: the coefficient {way} by {percent:.0} % during a slip"
                )
            }
        }
    }
}

/// Why a coefficient is not found.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum Unfound {
    /// Nothing in the recording is a slip.
    #[error(
        "no plateau of friction that begins and ends sharply: the body did not slip, or only for some rows, or not by Coulomb's law, or the sensor lies on the floor"
    )]
    NoSlip,
    /// There are plateaus, but with no other size of what is felt than at rest.
    #[error(
        "a plateau is there, but x^2 + z^2 on it is g^2, as of a body at rest on a tilted floor, and no other is a slip"
    )]
    Tilted,
    /// No slip is seen to begin from rest without a push.
    #[error(
        "it is not seen to break loose by itself, without a push; it held up to {held:.3} at least"
    )]
    NeverLoose {
        /// The largest coefficient at which it stuck.
        held: f64,
    },
}

/// What a recording says.
#[derive(Debug, Clone, PartialEq)]
pub struct Measured {
    /// μ_k.
    pub kinetic: Result<Interval, Unfound>,
    /// μ_s.
    pub holding: Result<Interval, Unfound>,
    /// What the body does, one after the other.
    pub stretches: Vec<Stretch>,
    /// Whether Coulomb's law fits.
    pub verdict: Verdict,
    /// Standard deviation along one axis, at rest, or else from row to row, in m/s².
    pub noise: f64,
    /// Whether a rest has shown the sensor's zeros.
    pub zeroed: bool,
    /// N/m is measured; else it is taken to be g.
    pub normal: bool,
    /// What differs to and fro is taken for a tilt of the floor.
    pub tilted: bool,
}

impl Measured {
    /// What the coefficients take for granted, beyond what is recorded.
    pub fn assumed(&self) -> Option<String> {
        let found = self.kinetic.is_ok();
        let all = [
            (
                found,
                "that the body slid: on a floor that for a while accelerates evenly a sensor reads the same",
            ),
            (
                found && self.zeroed,
                "that the floor was level at the rest that shows the sensor's zeros",
            ),
            (
                self.tilted,
                "that the floor is tilted, for slips to and fro differ: or else there are two frictions",
            ),
            (
                !self.normal,
                "that the floor is level: no column along z has gravity in it, so N/m is taken for g",
            ),
        ];
        let all: Vec<_> = all
            .into_iter()
            .filter(|one| one.0)
            .map(|one| one.1)
            .collect();
        (!all.is_empty()).then(|| all.join("; "))
    }
}

/// Why nothing can be measured.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum MeasureError {
    /// Too few rows.
    #[error("a recording needs at least {least} rows, this one has {rows}")]
    Rows {
        /// How many are needed.
        least: usize,
        /// How many there are.
        rows: usize,
    },
    /// A time that does not rise, or a value that is no number.
    #[error(
        "times have to rise, up to 1e10 s, and values to be at most 1e6 in size: row {row} is wrong"
    )]
    Row {
        /// Its number, from 1.
        row: usize,
    },
    /// A setting is out of its range.
    #[error("{name} = {value} must be {range}")]
    Setting {
        /// Name of the setting.
        name: &'static str,
        /// What was given.
        value: f64,
        /// What is allowed.
        range: &'static str,
    },
    /// What is along z is no gravity.
    #[error(
        "z reads {across:.3} m/s², and gravity is said to be {g}: the unit, the column or g is another"
    )]
    Gravity {
        /// The usual size along z, in m/s².
        across: f64,
        /// Acceleration of gravity.
        g: f64,
    },
    /// Hardly any rows between the times of rest, or no rest on level floor.
    #[error(
        "there are hardly any rows between {from} and {to}, where it is said to be at rest, or it moves there, or is tilted"
    )]
    Rest {
        /// The first time,
        from: f64,
        /// and the last.
        to: f64,
    },
}

/// The fewest rows: a rest and a slip.
const LEAST_ROWS: usize = 64;
const LARGEST: f64 = 1e6;

/// Finds slips and rests in what a sensor on the sliding body has recorded, and the coefficients of friction.
///
/// - *μ_k* is the mean of |f|/N over the plateaus, which have to agree. Its interval is from the scatter of plateaus, or of their
///   parts where they are few, but no less than from the noise at rest; it contains what is unknown of the zeros of the sensor.
/// - *μ_s* is where |f|/N was, by a straight line through the last rows of rest, when the body broke loose; its interval has noise
///   and the time between two rows. It broke loose where a plateau begins from a rise, with f in the same direction.
/// - The [`Verdict`] compares plateaus with each other, and within.
///
/// N/m is the acceleration along z, if that contains gravity; else it is g, as on a level floor that is shaken along itself, and
/// [`Measured::assumed`] says so. A plateau needs some twelve rows. O(n log n): a second for 300,000 rows.
///
/// # Errors
/// [`MeasureError`]: fewer than 64 rows, rows that are no numbers or whose times do not rise, settings out of their range.
pub fn measure(recording: &Recording, settings: &Settings) -> Result<Measured, MeasureError> {
    let (found, _) = by(Sensor::new(recording, settings, true)?);
    // What differs to and fro may be a tilt at rest, taken for zeros of the sensor.
    if found.zeroed && settings.rest.is_none() && matches!(found.verdict, Verdict::Levels(_)) {
        let (other, [x, y]) = by(Sensor::new(recording, settings, false)?);
        if other.verdict == Verdict::Fits && libm::hypot(x, y) < 2.0 * settings.offset {
            return Ok(Measured {
                verdict: Verdict::Untold,
                tilted: true,
                ..other
            });
        }
    }
    Ok(found)
}

fn by(mut sensor: Sensor) -> (Measured, [f64; 2]) {
    let mut pieces = sensor.pieces();
    let (mut slips, rests) = kinetic::slips(&sensor, &pieces);
    if !sensor.zeroed && !slips.is_empty() {
        sensor.shift(kinetic::fit(&sensor, &slips).1);
        let again = sensor.pieces();
        let (found, _) = kinetic::slips(&sensor, &again);
        if !found.is_empty() {
            (pieces, slips) = (again, found);
        }
    }
    let (kinetic, verdict) = if slips.is_empty() {
        let why = if rests {
            Unfound::Tilted
        } else {
            Unfound::NoSlip
        };
        (Err(why), Verdict::Untold)
    } else {
        let (interval, _) = kinetic::fit(&sensor, &slips);
        (Ok(interval), kinetic::verdict(&sensor, &pieces, &slips))
    };
    let (holding, held) = holding::holding(&sensor, &pieces, &slips, &kinetic);
    let found = Measured {
        stretches: stretches(&sensor, &pieces, &slips, held),
        kinetic,
        holding,
        verdict,
        noise: libm::sqrt(sensor.noise),
        zeroed: sensor.zeroed,
        normal: sensor.measured,
        tilted: false,
    };
    (found, sensor.shifted)
}

fn stretches(sensor: &Sensor, pieces: &[Piece], slips: &[Piece], held: f64) -> Vec<Stretch> {
    let mut slipping = slips.iter().peekable();
    let mut list: Vec<Stretch> = Vec::new();
    for piece in pieces {
        while slipping.next_if(|slip| slip.to <= piece.from).is_some() {}
        let noise = libm::sqrt(piece.line.variance() / piece.line.rows);
        let kind = match slipping.peek() {
            Some(slip) if slip.from <= piece.from && piece.to <= slip.to => Kind::Slip,
            _ if piece.line.y > 1.1 * held + 4.0 * noise => Kind::Pushed,
            _ => Kind::Stick,
        };
        let [from, to] = [
            sensor.t[piece.from],
            sensor.t[piece.to.min(sensor.t.len() - 1)],
        ];
        match list.last_mut() {
            Some(last) if last.kind == kind => last.to = to,
            _ => list.push(Stretch { from, to, kind }),
        }
    }
    list
}
