//! The turntable: rest or escape, the state at a time, the boundary between the two.
//!
//! No formula gives a motion here. Where the others compare a formula with the motion, two integrations stand:
//! in components along and across the velocity and in the table's axes, or in the table's axes and in the
//! laboratory's.

use super::{Answer, Curve, Field, Fields, SolveError, check};
use crate::corrections::rest as corrected;
use crate::motion::MotionError;
use crate::motion::turntable::boundary::between;
use crate::motion::turntable::intrinsic::Run;
use crate::motion::turntable::{Fate, Path, Start, State, Table, fate, inertial, rotating};
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
        let points: Result<Vec<_>, _> = (0..=600)
            .map(|i| path.on_table(until * f64::from(i) / 600.0).map(|s| s.x))
            .collect();
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

/// A point of the boundary between rest and escape.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BoundaryProblem {
    /// α, in [0, 20].
    pub alpha: f64,
    /// ψ, radians.
    pub psi: f64,
}

/// A on the boundary.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Boundary {
    /// A.
    pub a: f64,
}

impl Fields for Boundary {
    fn fields(&self) -> Vec<Field> {
        vec![Field::new("A", self.a)]
    }
}

/// Below this α the second-order formula is the better one: it leaves out at most 5.2 α³.
const NEAR: f64 = 1e-5;
/// Beyond this α it means nothing.
const FAR: f64 = 1.0;

impl BoundaryProblem {
    /// A on the boundary, by bisection on the motion and by the expansion to second order in α.
    ///
    /// # Errors
    /// [`SolveError::Parameter`] for α or ψ out of range.
    pub fn solve(&self) -> Result<Answer<Boundary>, SolveError> {
        let BoundaryProblem { alpha, psi } = *self;
        check(
            "alpha",
            alpha,
            (0.0..=20.0).contains(&alpha),
            "between 0 and 20",
        )?;
        check("psi", psi, psi.abs() <= 1e3, "between -1e3 and 1e3")?;
        let formula = Boundary {
            a: corrected::boundary_a(alpha, psi),
        };
        if alpha < NEAR {
            let note = "by the expansion that replaces (147); what it leaves out is of order α³";
            return Ok(Answer {
                best: formula,
                by_formula: Some(formula),
                by_motion: None,
                disagreement: None,
                digits: Some(14),
                note: note.to_owned(),
            });
        }
        let least = (1.0 - 1e-9) * libm::exp(-alpha);
        let start = |a| Start::hyperbolic(a, alpha, psi);
        let motion = Boundary {
            a: between(start, least, 1.0 + 1e-9, 1e-15 * least)?,
        };
        let compared = if alpha <= FAR {
            let note = "by bisection on the motion; the formula is the expansion to second order in α that replaces (147)";
            Answer::by_both(formula, motion, note)?
        } else {
            let note = "by bisection on the motion; the formula that replaces (147) is for small α";
            Answer {
                disagreement: None,
                ..Answer::by_motions(motion, &motion, note)?
            }
        };
        Ok(Answer {
            best: motion,
            digits: Some(self.digits(motion.a)?),
            ..compared
        })
    }

    /// To how many digits the motion tells one side from the other: closer by, it hovers at the brink of rest for
    /// longer than it can be followed.
    fn digits(&self, a: f64) -> Result<u32, SolveError> {
        let rests = |a: f64| -> Result<Option<bool>, SolveError> {
            Ok(match fate(&Start::hyperbolic(a, self.alpha, self.psi)?)? {
                Fate::Rest { .. } => Some(true),
                Fate::Escape { .. } => Some(false),
                Fate::Undecided { .. } => None,
            })
        };
        for digits in (1..=MOST_DIGITS).rev() {
            let width = libm::exp10(-f64::from(digits));
            if rests(a * (1.0 - width))? == Some(true) && rests(a * (1.0 + width))? == Some(false) {
                return Ok(digits);
            }
        }
        Ok(0)
    }

    /// A against α at the same ψ, by the motion.
    ///
    /// # Errors
    /// As for [`solve`](Self::solve).
    pub fn curve(&self) -> Result<Curve, SolveError> {
        let most = self.alpha.max(1.0);
        let point = |i: u32| -> Result<[f64; 2], SolveError> {
            let alpha = most * f64::from(i) / 40.0;
            let start = |a| Start::hyperbolic(a, alpha, self.psi);
            let least = (1.0 - 1e-9) * libm::exp(-alpha);
            let a = match i {
                0 => 1.0,
                _ => between(start, least, 1.0 + 1e-9, 1e-4 * least)?,
            };
            Ok([alpha, a])
        };
        let points: Result<Vec<_>, _> = (0..=40).map(point).collect();
        Ok(Curve {
            title: "The boundary between rest and escape",
            x: "α",
            y: "A",
            equal: false,
            points: points?,
        })
    }
}

/// To so many digits a separate integration, in extended precision, has the same boundary.
const MOST_DIGITS: u32 = 12;
