//! A rigid sphere on a rough horizontal plane that accelerates, in three dimensions (section 3 of the paper).
//!
//! In the frame of the plane, with r the centre, ω the angular velocity, R = −Rẑ the way from the centre to the point
//! of contact and F the force of friction there, Newton's and Euler's laws are
//!
//! ```text
//! m dv/dt = −m A(t) + F,    I dω/dt = R×F,    c = v + ω×R
//! ```
//!
//! c being the velocity of the point of contact. While it is not zero the sphere slides and F = −μmg c/|c|. While it
//! is zero the sphere rolls, with the F that keeps it zero: dc/dt = −A + F/m + (R×F)×R/I = 0, F = A/(1/m + R²/I). It
//! rolls as long as this force is at most μmg.
//!
//! Sliding is integrated in the time s with dt = |c| ds, in which the end of sliding is regular, with c as a part of
//! the state (of its own, as the difference of v and −ω×R loses its digits there); its first moments come from the
//! power series of [`onset`](super::onset).

mod line;
mod run;
mod slide;
mod turning;

#[cfg(all(test, feature = "trials"))]
mod tests;

pub use line::{Directed, LineMotion, LineState, Stretch};
pub use turning::Turning;

use super::{
    acceleration::Acceleration,
    error::{MotionError, check},
    track::{Part, Track},
};
use crate::numerics::{
    series::{arrival, value},
    taylor::{Coefficients, Step, TERMS},
};

/// A homogeneous or hollow sphere and the plane under it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sphere {
    /// Mass m > 0.
    pub mass: f64,
    /// Radius R > 0, in length.
    pub radius: f64,
    /// Moment of inertia I about an axis through the centre, in mass·length²; I/(mR²) in (0, 1].
    pub inertia: f64,
    /// Coefficient of friction μ > 0, dimensionless: kinetic, and static unless a motion is [told](Self::run_held) more.
    pub mu: f64,
    /// Gravity g > 0, in length/time².
    pub g: f64,
}

/// Position, velocity and angular velocity at a time, in the frame of the plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ball {
    /// Time.
    pub t: f64,
    /// Horizontal position of the centre, in length.
    pub x: [f64; 2],
    /// Velocity of the centre, in length/time.
    pub v: [f64; 2],
    /// Angular velocity ω, in 1/time; the third axis points up.
    pub omega: [f64; 3],
}

/// What the point of contact does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Contact {
    /// It slides over the plane.
    Sliding,
    /// It is at rest on the plane.
    Rolling,
}

/// The velocity of the point of contact is zero and the kind of motion may change.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Transition {
    /// When.
    pub t: f64,
    /// Sliding may follow on sliding: then the velocity only passes through zero.
    pub to: Contact,
}

#[inline(always)]
fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

impl Sphere {
    /// The sphere with I = κmR² that has m = R = μ = g = 1.
    pub fn with_kappa(kappa: f64) -> Self {
        Self {
            mass: 1.0,
            radius: 1.0,
            inertia: kappa,
            mu: 1.0,
            g: 1.0,
        }
    }

    /// κ = I/(mR²), dimensionless: 2/5 for a solid sphere, 2/3 for a hollow one.
    pub fn kappa(&self) -> f64 {
        self.inertia / (self.mass * self.radius * self.radius)
    }

    /// Velocity c of the point of contact.
    pub fn contact(&self, ball: &Ball) -> [f64; 2] {
        let turning = cross(ball.omega, self.arm());
        [ball.v[0] + turning[0], ball.v[1] + turning[1]]
    }

    /// The angular velocity with the given spin about the vertical with which a sphere of velocity `v` rolls.
    pub fn rolling(&self, v: [f64; 2], spin: f64) -> [f64; 3] {
        [-v[1] / self.radius, v[0] / self.radius, spin]
    }

    /// The motion from `start` until the time `until` on a plane with the given acceleration, [against](super) which the sphere is
    /// pulled. A contact velocity
    /// below 10⁻¹⁴ of the velocities of which it is the sum counts as zero at the start.
    ///
    /// Times, v, ω and x are right to about 10⁻¹² relative where the problem is well conditioned, but for the acceleration's own
    /// error: see [`BallMotion::drive_error`].
    ///
    /// # Errors
    /// [`MotionError::Argument`] for a parameter out of range, [`MotionError::Outside`] for times at which the acceleration is not
    /// known, [`MotionError::Steps`] after 50,000 steps and a hundred for each piece of the acceleration,
    /// [`MotionError::Numerics`] when the motion or the acceleration leaves the finite numbers.
    pub fn run(
        &self,
        plane: &dyn Acceleration,
        start: &Ball,
        until: f64,
    ) -> Result<BallMotion, MotionError> {
        self.run_held(self.mu, plane, start, until)
    }

    /// As [`run`](Self::run), but rolling lasts as long as its force is at most `holding` mg, a coefficient of static friction
    /// that is not below μ.
    pub(crate) fn run_held(
        &self,
        holding: f64,
        plane: &dyn Acceleration,
        start: &Ball,
        until: f64,
    ) -> Result<BallMotion, MotionError> {
        self.check()?;
        let fit = holding >= self.mu && holding <= 1e50;
        check("holding", holding, fit, "not below mu, at most 1e50")?;
        run::run(self, holding, plane, start, until)
    }

    fn arm(&self) -> [f64; 3] {
        [0.0, 0.0, -self.radius]
    }

    /// Largest force of friction, μmg.
    fn friction(&self) -> f64 {
        self.mu * self.mass * self.g
    }

    /// By a horizontal force at the point of contact.
    #[inline(always)]
    fn response(&self, force: [f64; 2]) -> ([f64; 2], [f64; 3]) {
        let [x, y, z] = cross(self.arm(), [force[0], force[1], 0.0]);
        (
            [force[0] / self.mass, force[1] / self.mass],
            [x / self.inertia, y / self.inertia, z / self.inertia],
        )
    }

    /// dc/dt by a horizontal force at the point of contact.
    fn yielding(&self, force: f64) -> f64 {
        let ([a, _], spin) = self.response([force, 0.0]);
        a + cross(spin, self.arm())[0]
    }

    fn check(&self) -> Result<(), MotionError> {
        for (name, value) in [
            ("mass", self.mass),
            ("radius", self.radius),
            ("inertia", self.inertia),
            ("mu", self.mu),
            ("g", self.g),
        ] {
            let fit = (1e-50..=1e50).contains(&value);
            check(name, value, fit, "positive, between 1e-50 and 1e50")?;
        }
        let kappa = self.kappa();
        check(
            "kappa",
            kappa,
            kappa > 0.0 && kappa <= 1.0 + 4.0 * f64::EPSILON,
            "in (0, 1]",
        )
    }
}

/// x, y, v_x, v_y, ω_x, ω_y, ω_z, c_x, c_y; the time in front where it is one of them.
const PARTS: usize = 9;

#[derive(Debug, Clone, PartialEq)]
enum Piece {
    /// Sliding, in the time s.
    Slide {
        step: Box<Step<f64, 10, TERMS>>,
        to: f64,
    },
    /// Power series in t − from.
    Series {
        from: f64,
        to: f64,
        series: Box<[Coefficients; PARTS]>,
    },
}

impl Piece {
    fn from(&self) -> f64 {
        match self {
            Self::Slide { step, .. } => step.series[0][0],
            Self::Series { from, .. } => *from,
        }
    }

    fn to(&self) -> f64 {
        match self {
            Self::Slide { to, .. } | Self::Series { to, .. } => *to,
        }
    }

    fn parts(&self, t: f64) -> Result<[f64; PARTS], MotionError> {
        Ok(match self {
            Self::Slide { step, .. } => {
                let s = arrival(&step.series[0], t - step.series[0][0], step.h);
                std::array::from_fn(|i| value(&step.series[i + 1], &s))
            }
            Self::Series { from, series, .. } => {
                std::array::from_fn(|i| value(&series[i], &(t - from)))
            }
        })
    }
}

/// A motion from a start to an end.
#[derive(Debug, Clone, PartialEq)]
pub struct BallMotion {
    pieces: Vec<Piece>,
    transitions: Vec<Transition>,
    begin: Contact,
    start: Ball,
    slip: [f64; 2],
    end: Ball,
    drive_error: f64,
}

impl BallMotion {
    /// Every moment at which the contact velocity is zero after it was not, or stops to be zero, in order.
    pub fn transitions(&self) -> &[Transition] {
        &self.transitions
    }

    /// The [`error`](Acceleration::error) of a component of the acceleration, in length/time²; v and x are off by at most as much
    /// as those of a [particle](super::Motion::drive_error).
    pub fn drive_error(&self) -> f64 {
        self.drive_error
    }

    /// State at the end.
    pub fn end(&self) -> Ball {
        self.end
    }

    /// Whether the sphere slides or rolls at time `t`; at a transition, what comes after it.
    ///
    /// # Errors
    /// As for [`at`](Self::at).
    pub fn contact(&self, t: f64) -> Result<Contact, MotionError> {
        self.within(t)?;
        let past = self
            .transitions
            .iter()
            .rev()
            .find(|transition| transition.t <= t);
        Ok(past.map_or(self.begin, |transition| transition.to))
    }

    /// Velocity of the point of contact at time `t`, without cancellation where it is small; zero in rolling.
    ///
    /// # Errors
    /// As for [`at`](Self::at).
    pub fn slip(&self, t: f64) -> Result<[f64; 2], MotionError> {
        self.within(t)?;
        match self.piece(t) {
            Some(piece) => piece
                .parts(t.min(piece.to()))
                .map(|parts| [parts[7], parts[8]]),
            None => Ok(self.slip),
        }
    }

    /// State at time `t`.
    ///
    /// # Errors
    /// [`MotionError::Argument`] for a time before the start or after the end.
    pub fn at(&self, t: f64) -> Result<Ball, MotionError> {
        self.within(t)?;
        if t == self.end.t {
            return Ok(self.end);
        }
        let Some(piece) = self.piece(t) else {
            return Ok(self.start);
        };
        let [x, y, u, v, a, b, c, _, _] = piece.parts(t)?;
        Ok(Ball {
            t,
            x: [x, y],
            v: [u, v],
            omega: [a, b, c],
        })
    }

    /// The way of its centre on the plane.
    pub(crate) fn track(&self) -> Result<Track<'_>, MotionError> {
        self.tracked(2)
    }

    /// The way that its lowest point slides, each unit of which turns μg into heat, per unit of mass; the places are the centre's.
    ///
    /// # Errors
    /// As for [`track`](Self::track).
    pub fn slipped(&self) -> Result<Track<'_>, MotionError> {
        self.tracked(7)
    }

    fn tracked(&self, first: usize) -> Result<Track<'_>, MotionError> {
        let parts = self.pieces.iter().map(|piece| {
            let (own, series) = match piece {
                Piece::Slide { step, .. } => (Some(step), &step.series[1..]),
                Piece::Series { series, .. } => (None, &series[..]),
            };
            let pair = |first: usize| [&series[first], &series[first + 1]];
            let part = match own {
                Some(step) => Part::clocked(&step.series[0], step.h, pair(first), pair(0)),
                None => {
                    let lasts = piece.to() - piece.from();
                    Part::timed(piece.from(), lasts, pair(first), pair(0))
                }
            };
            // The lowest point comes to rest, and never passes through it.
            if first == 2 {
                part.cornered()
            } else {
                Ok(part)
            }
        });
        Track::new([self.start.t, self.end.t], self.start.x, parts)
    }

    fn within(&self, t: f64) -> Result<(), MotionError> {
        let fit = t >= self.start.t && t <= self.end.t;
        check("t", t, fit, "between the start and the end of the motion")
    }

    fn piece(&self, t: f64) -> Option<&Piece> {
        let index = self.pieces.partition_point(|piece| piece.from() <= t);
        self.pieces.get(index.saturating_sub(1))
    }
}
