//! The turntable: rest or escape, and the state at a time.
//!
#![doc = include_str!("axes/table.md")]
//!
//! No formula gives a motion here. Where the others compare a formula with the motion, two integrations stand: in
//! components along and across the velocity, in numbers of twice the width, and in the table's axes or in the
//! laboratory's in `f64`.

/// Why a start cannot be followed.
pub use crate::motion::MotionError;
/// Where a particle of an ensemble starts.
pub use crate::motion::turntable::Start;
/// An ensemble of particles, by the motion alone.
pub use crate::motion::turntable::ensemble::{End, Horizon};

use super::{Answer, Curve, Field, Fields, Quantity, RADIANS, SolveError, check, steps};
use crate::motion::{
    turntable::fate::{Certain, Ending, Rest, follow},
    turntable::intrinsic::Exact,
    turntable::moment::{Moment as Parts, moment},
    turntable::{Path, State, Table, inertial, rotating},
};
use crate::numerics::{double::Double, number::Real, taylor::TERMS};
use crate::paper::turntable as printed;
use crate::scalar::Scalar;
use std::f64::consts::TAU;

/// A start on the table, in the paper's units and in axes that turn with the table.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum TurntableProblem<T = f64> {
    /// At the distance ρ on the +x axis with the speed p at the angle −ψ.
    Polar {
        /// ρ, in [0, 10⁶] units of μg/Ω².
        rho: T,
        /// p, in [0, 10⁶] units of μg/Ω.
        p: T,
        /// ψ, from the velocity to the position, counterclockwise (radians).
        psi: T,
    },
    /// As `Polar`, with p = A sinh α and ρ = A cosh α.
    Hyperbolic {
        /// A, with ρ and p at most 10⁶.
        a: T,
        /// α, in [0, 20].
        alpha: T,
        /// ψ (radians).
        psi: T,
    },
    /// By position and velocity.
    Cartesian {
        /// Position, in units of μg/Ω²; at most 10⁶ from the axis.
        position: [T; 2],
        /// Velocity relative to the table, in units of μg/Ω; at most 10⁶.
        velocity: [T; 2],
    },
}

/// The units of lengths, speeds and times.
pub const LENGTH: &str = "μg/Ω²";
/// See [`LENGTH`].
pub const SPEED: &str = "μg/Ω";
/// See [`LENGTH`].
pub const TIME: &str = "1/Ω";

/// What becomes of a start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TurntableOutcome {
    /// `rest` or `escape`.
    pub outcome: &'static str,
    /// The distance σ from the axis at which it rests, in units of μg/Ω².
    pub sigma: Option<f64>,
    /// The time τ at which it comes to rest, in units of 1/Ω.
    pub tau_rest: Option<f64>,
}

/// A state on the way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moment {
    /// Position in the table's axes, in units of μg/Ω².
    pub position: [f64; 2],
    /// Velocity relative to the table, in units of μg/Ω.
    pub velocity: [f64; 2],
    /// The distance ρ from the axis.
    pub rho: f64,
    /// The speed p.
    pub p: f64,
    /// ψ, radians in (−π, π]; 0 where the particle is at rest or on the axis.
    pub psi: f64,
}

impl Moment {
    pub(super) fn of([x, y]: [f64; 2], [u, v]: [f64; 2]) -> Self {
        let (rho, p) = (libm::hypot(x, y), libm::hypot(u, v));
        let psi = if rho == 0.0 || p == 0.0 {
            0.0
        } else {
            libm::atan2(u * y - v * x, u * x + v * y)
        };
        Self {
            position: [x, y],
            velocity: [u, v],
            rho,
            p,
            psi,
        }
    }
}

/// x, y, v_x, v_y, ρ, p, ψ, each rounded.
impl From<[Double; 7]> for Moment {
    fn from(parts: [Double; 7]) -> Self {
        let [x, y, u, v, rho, p, psi] = parts.map(Double::to_f64);
        Self {
            position: [x, y],
            velocity: [u, v],
            rho,
            p,
            psi,
        }
    }
}

impl Fields for TurntableOutcome {
    fn fields(&self) -> Vec<Field> {
        vec![
            Field::new("outcome", self.outcome),
            Field::new("sigma", self.sigma).of(LENGTH),
            Field::new("tau_rest", self.tau_rest).of(TIME),
        ]
    }
}

impl Fields for Moment {
    fn fields(&self) -> Vec<Field> {
        let Moment { rho, p, psi, .. } = *self;
        vec![
            Field::within(rho, "x", self.position[0]).of(LENGTH),
            Field::within(rho, "y", self.position[1]).of(LENGTH),
            Field::within(p, "vx", self.velocity[0]).of(SPEED),
            Field::within(p, "vy", self.velocity[1]).of(SPEED),
            Field::new("rho", rho).of(LENGTH),
            Field::new("p", p).of(SPEED),
            Field::within(1.0, "psi", psi).of(RADIANS),
        ]
    }
}

/// Of a distance or speed this large the highest power in a series is a number.
const LARGEST: f64 = 1e6;
/// So long may a motion be followed: about a turn of the velocity in a unit of time.
const LONGEST: f64 = 1e5;

impl<T: Quantity> TurntableProblem<T> {
    /// Rest or escape.
    ///
    /// # Errors
    /// [`SolveError::Parameter`] or [`SolveError::Motion`] for a parameter out of range, [`SolveError::Undecided`] on the
    /// boundary.
    pub fn fate(&self) -> Result<Answer<TurntableOutcome>, SolveError> {
        let near = self.near();
        near.start()?;
        let exact = self.exact();
        let end = |start| follow::<Double, ORDER>(&start, true).map(|(ending, _)| ending);
        let rounded = near.exact();
        let (here, beside) = match [end(exact)?, end(exact.beside(NUDGE.into()))?] {
            [
                Ending::Certain(Certain::Rest(here)),
                Ending::Certain(Certain::Rest(beside)),
            ] => (here, beside),
            [
                Ending::Certain(Certain::Escape { .. }),
                Ending::Certain(Certain::Escape { .. }),
            ] => {
                let escape = TurntableOutcome {
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
            [here, _] => {
                let (tau, p) = here.reached();
                return Err(SolveError::Undecided { tau, p });
            }
        };
        let rest = |sigma: f64, tau: f64| TurntableOutcome {
            outcome: "rest",
            sigma: Some(sigma),
            tau_rest: Some(tau),
        };
        let best = rest(here.sigma.into(), here.tau.into());
        let second = if here.gap.to_f64() > SLOW && exact.p.to_f64() > AT_ITS_STOP {
            let path = near.path(2.0 * here.tau.to_f64() + 1.0)?;
            let place = path.resting_place().map(|[x, y]| libm::hypot(x, y));
            let stop = path.stops().last().copied();
            rest(place.unwrap_or(f64::NAN), stop.unwrap_or(0.0))
        } else {
            match follow::<f64, NARROW>(&exact.map(Double::to_f64), true)?.0 {
                Ending::Certain(Certain::Rest(narrow)) => rest(narrow.sigma, narrow.tau),
                // So close to the border that the narrower numbers miss it.
                _ => best,
            }
        };
        let moved = |to: Rest<Double>| {
            let moved = [here.sigma - to.sigma, here.tau - to.tau];
            moved.map(Double::to_f64).to_vec()
        };
        let by_rounding = if rounded == exact {
            moved(here)
        } else if let Ending::Certain(Certain::Rest(rounded)) = end(rounded)? {
            moved(rounded)
        } else {
            vec![f64::INFINITY; 2]
        };
        Answer::by_wide_motion(best, &second, [moved(beside), by_rounding], NOTE)
    }

    /// The state at the time `tau`.
    ///
    /// # Errors
    /// [`SolveError::Parameter`] or [`SolveError::Motion`] for a parameter out of range.
    pub fn at(&self, tau: T) -> Result<Answer<Moment>, SolveError> {
        let (exactly, tau): (Double, f64) = (tau.into(), tau.into());
        let fit = (0.0..=LONGEST).contains(&tau);
        check("time", tau, fit, "between 0 and 1e5")?;
        let near = self.near();
        near.start()?;
        let exact = self.exact();
        let parts = |start| Ok::<_, SolveError>(moment::<Double, ORDER>(&start, exactly)?);
        let (here, beside) = (parts(exact)?, parts(exact.beside(NUDGE.into()))?);
        let [best, beside] = [&here, &beside].map(|parts| self.seen(parts));
        let rounded = if near.exact() == exact {
            best
        } else {
            near.seen(&parts(near.exact())?)
        };
        let second = if here.slow || here.p.to_f64() < AT_ITS_STOP {
            let narrow = moment::<f64, NARROW>(&exact.map(Double::to_f64), tau)?;
            Moment::from(near.seen(&narrow.map(Double::from)))
        } else {
            let outside = Table::default().to_laboratory(&near.state());
            let path = inertial::run(&Table::default(), &outside, tau)?;
            let State { x, v, .. } = path.on_table(tau)?;
            Moment::of(x, v)
        };
        let moved = |to: [Double; 7]| -> Vec<f64> {
            let pairs = best.into_iter().zip(to);
            pairs.map(|(x, y)| (x - y).to_f64()).collect()
        };
        let moved = [moved(beside), moved(rounded)];
        let best = Moment::from(best);
        let turns = libm::round((best.psi - second.psi) / TAU);
        let second = Moment {
            psi: second.psi + TAU * turns,
            ..second
        };
        Answer::by_wide_motion(best, &second, moved, NOTE)
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
        let path = self.near().path(until)?;
        let place = |tau| path.on_table(tau).map(|state| state.x);
        let points: Result<Vec<_>, _> = steps(until, 600).map(place).collect();
        Ok(Curve {
            title: "The path on the table",
            x: "x",
            y: "y",
            units: [LENGTH; 2],
            equal: true,
            points: points?,
        })
    }

    fn near(&self) -> TurntableProblem {
        let near = |x: T| -> f64 { x.into() };
        match *self {
            Self::Polar { rho, p, psi } => TurntableProblem::Polar {
                rho: near(rho),
                p: near(p),
                psi: near(psi),
            },
            Self::Hyperbolic { a, alpha, psi } => TurntableProblem::Hyperbolic {
                a: near(a),
                alpha: near(alpha),
                psi: near(psi),
            },
            Self::Cartesian { position, velocity } => TurntableProblem::Cartesian {
                position: position.map(near),
                velocity: velocity.map(near),
            },
        }
    }

    fn exact(&self) -> Exact<Double> {
        let wide = |x: T| -> Double { x.into() };
        match *self {
            Self::Polar { rho, p, psi } => Exact::polar(wide(rho), wide(p), wide(psi)),
            Self::Hyperbolic { a, alpha, psi } => {
                let (a, alpha) = (wide(a), wide(alpha));
                Exact::polar(
                    printed::eq112_rho(a, alpha),
                    printed::eq111_p(a, alpha),
                    wide(psi),
                )
            }
            Self::Cartesian { position, velocity } => {
                Exact::cartesian(position.map(wide), velocity.map(wide))
            }
        }
    }

    /// At the start; away from the axis for a start from rest.
    fn direction(&self) -> [Double; 2] {
        let away = [1.0, 0.0].map(Double::from);
        let unit = |vector: [T; 2]| {
            let [x, y] = vector.map(Into::into);
            let size = Double::hypot(x, y);
            (size.to_f64() > 0.0).then(|| [x / size, y / size])
        };
        match *self {
            Self::Cartesian { position, velocity } => {
                unit(velocity).or_else(|| unit(position)).unwrap_or(away)
            }
            Self::Polar { psi, .. } | Self::Hyperbolic { psi, .. } => {
                if self.exact().p.to_f64() == 0.0 {
                    return away;
                }
                let psi = psi.into();
                [Scalar::cos(psi), -Scalar::sin(psi)]
            }
        }
    }

    /// x, y, v_x, v_y, ρ, p, ψ in the table's axes.
    fn seen(&self, parts: &Parts<Double>) -> [Double; 7] {
        let [along, across] = self.direction();
        let (c, s) = (Scalar::cos(parts.turned), Scalar::sin(parts.turned));
        let [u, v] = [c * along - s * across, s * along + c * across];
        let Parts { p, xi, eta, .. } = *parts;
        let rho = xi.hypot(eta);
        let zero = Double::from(0.0);
        let psi = if p == zero || rho == zero {
            zero
        } else {
            eta.atan2(xi)
        };
        [
            xi * u - eta * v,
            xi * v + eta * u,
            p * u,
            p * v,
            rho,
            p,
            psi,
        ]
    }
}

impl TurntableProblem {
    fn start(&self) -> Result<Start, SolveError> {
        let start = match *self {
            TurntableProblem::Polar { rho, p, psi } => Start::polar(rho, p, psi)?,
            TurntableProblem::Hyperbolic { a, alpha, psi } => {
                check(
                    "alpha",
                    alpha,
                    (0.0..=20.0).contains(&alpha),
                    "between 0 and 20",
                )?;
                Start::hyperbolic(a, alpha, psi)?
            }
            TurntableProblem::Cartesian { position, velocity } => {
                Start::cartesian(position, velocity)?
            }
        };
        for (name, size) in [("rho", start.rho()), ("p", start.p)] {
            check(name, size, size <= LARGEST, "at most 1e6")?;
        }
        Ok(start)
    }

    fn state(&self) -> State {
        let polar = |rho: f64, p: f64, psi: f64| State {
            t: 0.0,
            x: [rho, 0.0],
            v: [p * libm::cos(psi), -p * libm::sin(psi)],
        };
        match *self {
            TurntableProblem::Polar { rho, p, psi } => polar(rho, p, psi),
            TurntableProblem::Hyperbolic { a, alpha, psi } => polar(
                printed::eq112_rho(a, alpha),
                printed::eq111_p(a, alpha),
                psi,
            ),
            TurntableProblem::Cartesian { position, velocity } => State {
                t: 0.0,
                x: position,
                v: velocity,
            },
        }
    }

    fn path(&self, until: f64) -> Result<Path, MotionError> {
        rotating::run(&Table::default(), &self.state(), until)
    }
}

/// Terms of the series of numbers of twice the width.
const ORDER: usize = 44;
/// A change of this part of a start shows how many digits of the answer hang on the digits of the integration, which
/// loses less than that.
const NUDGE: f64 = 1e-28;
const NARROW: usize = TERMS;
/// Below this speed the motion in the laboratory, a difference, has too few digits, and that in the table's axes.
const AT_ITS_STOP: f64 = 1e-5;
/// Above this 1 − σ the integration in the table's axes gets to rest.
const SLOW: f64 = 0.01;
/// So long a time of an escape is drawn.
const ESCAPE_SHOWN: f64 = 12.0;
const NOTE: &str = "by the motion, integrated along the velocity in numbers of 31 digits; the digits are those that a change of the start by 10⁻²⁸ does not touch, and a second integration agrees";
