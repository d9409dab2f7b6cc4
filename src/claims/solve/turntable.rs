//! The turntable: rest or escape, and the state at a time.
//!
//! No formula gives a motion here. Where the others compare a formula with the motion, two integrations stand:
//! in components along and across the velocity and in the table's axes, or in the table's axes and in the
//! laboratory's.

/// Where a particle of an ensemble starts.
pub use crate::motion::turntable::Start;
/// An ensemble of particles, by the motion alone.
#[cfg(feature = "book")]
pub use crate::motion::turntable::ensemble::{End, Horizon};

use super::{Answer, Curve, Field, Fields, SolveError, check, steps};
use crate::motion::MotionError;
use crate::motion::turntable::intrinsic::Run;
use crate::motion::turntable::{Fate, Path, State, Table, fate, inertial, rotating};
use crate::paper::turntable as printed;

/// A start on the table, in the paper's units and in axes that turn with the table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Problem {
    /// At the distance ρ on the +x axis with the speed p at the angle −ψ.
    Polar {
        /// ρ, in [0, 10⁹].
        rho: f64,
        /// p, in [0, 10⁹].
        p: f64,
        /// ψ, from the velocity to the position, counterclockwise (radians).
        psi: f64,
    },
    /// As `Polar`, with p = A sinh α and ρ = A cosh α.
    Hyperbolic {
        /// A, in [0, 10⁹].
        a: f64,
        /// α, in [0, 20].
        alpha: f64,
        /// ψ (radians).
        psi: f64,
    },
    /// By position and velocity.
    Cartesian {
        /// Position.
        position: [f64; 2],
        /// Velocity relative to the table.
        velocity: [f64; 2],
    },
}

/// What becomes of a start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Outcome {
    /// `rest` or `escape`.
    pub outcome: &'static str,
    /// The distance σ from the axis at which it rests.
    pub sigma: Option<f64>,
    /// The time τ at which it comes to rest.
    pub tau_rest: Option<f64>,
}

/// A state on the way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moment {
    /// Position in the table's axes.
    pub position: [f64; 2],
    /// Velocity relative to the table.
    pub velocity: [f64; 2],
}

impl Moment {
    /// ρ.
    pub fn rho(&self) -> f64 {
        libm::hypot(self.position[0], self.position[1])
    }

    /// p.
    pub fn p(&self) -> f64 {
        printed::eq93_speed(self.velocity)
    }

    /// ψ, in (−π, π]; 0 where the particle is at rest or on the axis.
    pub fn psi(&self) -> f64 {
        let ([x, y], [u, v]) = (self.position, self.velocity);
        libm::atan2(u * y - v * x, u * x + v * y)
    }
}

impl Fields for Outcome {
    fn fields(&self) -> Vec<Field> {
        vec![
            Field::new("outcome", self.outcome),
            Field::new("sigma", self.sigma),
            Field::new("tau_rest", self.tau_rest),
        ]
    }
}

impl Fields for Moment {
    fn fields(&self) -> Vec<Field> {
        let (rho, p) = (self.rho(), self.p());
        vec![
            Field::within(rho, "x", self.position[0]),
            Field::within(rho, "y", self.position[1]),
            Field::within(p, "vx", self.velocity[0]),
            Field::within(p, "vy", self.velocity[1]),
            Field::new("rho", rho),
            Field::new("p", p),
            Field::within(1.0, "psi", self.psi()),
        ]
    }
}

/// So long may a motion be followed: about a turn of the velocity in a unit of time.
const LONGEST: f64 = 1e5;

impl Problem {
    /// Rest or escape.
    ///
    /// # Errors
    /// [`SolveError::Motion`] for a parameter out of range, [`SolveError::Undecided`] on the boundary.
    pub fn fate(&self) -> Result<Answer<Outcome>, SolveError> {
        let start = self.start()?;
        let (sigma, tau, error) = match fate(&start)? {
            Fate::Undecided { tau, p } => return Err(SolveError::Undecided { tau, p }),
            Fate::Escape { .. } => {
                let escape = Outcome {
                    outcome: "escape",
                    sigma: None,
                    tau_rest: None,
                };
                let note = "by the motion; the paper has no formula for a single start";
                return Ok(Answer {
                    disagreement: None,
                    ..Answer::by_motions(escape, &escape, note)?
                });
            }
            Fate::Rest { sigma, tau, error } => (sigma, tau, error),
        };
        let rest = |sigma, tau| Outcome {
            outcome: "rest",
            sigma: Some(sigma),
            tau_rest: Some(tau),
        };
        let note = "by the motion, integrated along the velocity and in the table's axes";
        match (self.at_its_stop(&start), self.path(2.0 * tau + 1.0)) {
            (Ok(Some((sigma, tau))), Ok(path)) => {
                let place = path
                    .resting_place()
                    .map_or(f64::NAN, |[x, y]| libm::hypot(x, y));
                let stop = path.stops().last().copied().unwrap_or(0.0);
                Answer::by_motions(rest(sigma, tau), &rest(place, stop), note)
            }
            // An approach so slow that only bounds are known.
            _ => Answer::by_motions(rest(sigma, tau), &rest(sigma + error, tau + SLOW), note),
        }
    }

    /// The state at the time `tau`.
    ///
    /// # Errors
    /// [`SolveError::Parameter`] or [`SolveError::Motion`] for a parameter out of range.
    pub fn at(&self, tau: f64) -> Result<Answer<Moment>, SolveError> {
        let fit = (0.0..=LONGEST).contains(&tau);
        check("time", tau, fit, "between 0 and 1e5")?;
        self.start()?;
        let moment = |path: &Path| -> Result<Moment, MotionError> {
            let State { x, v, .. } = path.on_table(tau)?;
            Ok(Moment {
                position: x,
                velocity: v,
            })
        };
        let on_table = moment(&self.path(tau)?)?;
        let from_outside = moment(&inertial::run(
            &Table::default(),
            &Table::default().to_laboratory(&self.state()),
            tau,
        )?)?;
        let note = "by the motion, integrated in the table's axes and in the laboratory's";
        Answer::by_motions(on_table, &from_outside, note)
    }

    /// The path on the table, until it rests or up to `until`.
    ///
    /// # Errors
    /// As for [`fate`](Self::fate).
    pub fn curve(&self, until: Option<f64>) -> Result<Curve, SolveError> {
        let until = match (until, self.fate()?.best.tau_rest) {
            (Some(until), _) => until,
            (None, Some(rest)) => rest,
            (None, None) => ESCAPE_SHOWN,
        };
        let path = self.path(until)?;
        let place = |tau| path.on_table(tau).map(|state| state.x);
        let points: Result<Vec<_>, _> = steps(until, 600).map(place).collect();
        Ok(Curve {
            title: "The path on the table",
            x: "x",
            y: "y",
            equal: true,
            points: points?,
        })
    }

    fn start(&self) -> Result<Start, SolveError> {
        Ok(match *self {
            Problem::Polar { rho, p, psi } => Start::polar(rho, p, psi)?,
            Problem::Hyperbolic { a, alpha, psi } => {
                check(
                    "alpha",
                    alpha,
                    (0.0..=20.0).contains(&alpha),
                    "between 0 and 20",
                )?;
                Start::hyperbolic(a, alpha, psi)?
            }
            Problem::Cartesian { position, velocity } => Start::cartesian(position, velocity)?,
        })
    }

    fn state(&self) -> State {
        let polar = |rho: f64, p: f64, psi: f64| State {
            t: 0.0,
            x: [rho, 0.0],
            v: [p * libm::cos(psi), -p * libm::sin(psi)],
        };
        match *self {
            Problem::Polar { rho, p, psi } => polar(rho, p, psi),
            Problem::Hyperbolic { a, alpha, psi } => polar(
                printed::eq112_rho(a, alpha),
                printed::eq111_p(a, alpha),
                psi,
            ),
            Problem::Cartesian { position, velocity } => State {
                t: 0.0,
                x: position,
                v: velocity,
            },
        }
    }

    fn path(&self, until: f64) -> Result<Path, MotionError> {
        rotating::run(&Table::default(), &self.state(), until)
    }

    /// σ and τ, followed until nothing is left of the speed.
    fn at_its_stop(&self, start: &Start) -> Result<Option<(f64, f64)>, MotionError> {
        let end = Run::new(start, f64::MAX)?.end();
        Ok((end.p() < 1e-20).then(|| (end.rho(), end.tau)))
    }
}

/// To this the time of a very slow stop is known.
const SLOW: f64 = 1e-9;
/// So long a time of an escape is drawn.
const ESCAPE_SHOWN: f64 = 12.0;
