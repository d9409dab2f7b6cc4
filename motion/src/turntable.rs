//! A particle on a rough turntable that turns at a steady rate about a vertical axis (section 4 of the paper).
//!
//! Newton's law with Coulomb friction, three times over: in axes that turn with the table ([`rotating`]), in axes at rest in the
//! laboratory ([`inertial`]), and in components along and across the velocity ([`intrinsic`]), which tell whether the particle
//! comes to rest ([`mod@fate`]) and where the boundary lies ([`mod@boundary`]).
//!
//! A particle at rest on the table at the distance r from the axis stays there if Ω²r ≤ μg. If Ω²r > μg it starts at once,
//! straight away from the axis.

pub mod boundary;
pub mod ensemble;
pub mod fate;
pub mod inertial;
pub mod intrinsic;
pub mod moment;
mod path;
pub mod rotating;
mod slow;

use super::error::{MotionError, check as argument};

pub use boundary::{boundary, critical_radius, critical_speed};
pub use fate::{Escaping, Fate, fate};
pub use intrinsic::{Intrinsic, Start};
pub use path::Path;

/// In one of the two frames, whose origins are on the axis, and which coincide at t = 0.
pub use super::State;

#[cfg(all(test, feature = "trials"))]
mod tests;

/// The table and the particle. Both the friction and the turning may be absent, and Ω may have either sign.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Table {
    /// Angular velocity Ω of the table, counterclockwise, in 1/time.
    pub omega: f64,
    /// Coefficient of friction μ ≥ 0, dimensionless.
    pub mu: f64,
    /// Gravity g > 0, in length/time².
    pub g: f64,
    /// Mass m > 0 of the particle.
    pub mass: f64,
}

/// Ω = μ = g = m = 1: lengths in units of μg/Ω², times in units of 1/Ω.
impl Default for Table {
    fn default() -> Self {
        Self {
            omega: 1.0,
            mu: 1.0,
            g: 1.0,
            mass: 1.0,
        }
    }
}

fn turned(vector: [f64; 2], angle: f64) -> [f64; 2] {
    let (s, c) = libm::sincos(angle);
    [c * vector[0] - s * vector[1], s * vector[0] + c * vector[1]]
}

impl Table {
    /// Checks the parameters.
    ///
    /// # Errors
    /// [`MotionError::Argument`] for Ω not finite, μ negative, g or m not positive, and for any above 10⁵⁰.
    pub fn check(&self) -> Result<(), MotionError> {
        size("omega", self.omega)?;
        let allowed = (0.0..=LARGEST).contains(&self.mu);
        argument("mu", self.mu, allowed, "finite, between 0 and 1e50")?;
        for (name, value) in [("g", self.g), ("mass", self.mass)] {
            let allowed = value > 0.0 && value <= LARGEST;
            argument(name, value, allowed, "finite and positive, at most 1e50")?;
        }
        Ok(())
    }

    /// Largest deceleration by friction, μg, in length/time².
    pub fn friction(&self) -> f64 {
        self.mu * self.g
    }

    /// μg/Ω², infinite for Ω = 0.
    pub fn length(&self) -> f64 {
        self.friction() / (self.omega * self.omega)
    }

    /// Whether static friction holds a particle that is at rest on the table at distance `radius` from the axis.
    pub fn holds(&self, radius: f64) -> bool {
        self.omega * self.omega * radius <= self.friction()
    }

    /// ½m(v² − Ω²r²), kinetic and of the centrifugal force, for a state in the table's frame.
    pub fn energy(&self, state: &State) -> f64 {
        let (p, r) = (state.speed(), self.omega * state.radius());
        0.5 * self.mass * (p - r) * (p + r)
    }

    /// A state relative to the table as seen from the laboratory.
    pub fn to_laboratory(&self, state: &State) -> State {
        let [x, y] = state.x;
        let [u, v] = state.v;
        let angle = self.omega * state.t;
        State {
            t: state.t,
            x: turned([x, y], angle),
            v: turned([u - self.omega * y, v + self.omega * x], angle),
        }
    }

    /// A state in the laboratory as seen from the table.
    pub fn to_table(&self, state: &State) -> State {
        let [x, y] = state.x;
        let [u, v] = state.v;
        let angle = -self.omega * state.t;
        State {
            t: state.t,
            x: turned([x, y], angle),
            v: turned([u + self.omega * y, v - self.omega * x], angle),
        }
    }
}

/// Products of several are still numbers.
const LARGEST: f64 = 1e50;

fn size(name: &'static str, value: f64) -> Result<(), MotionError> {
    let range = "finite, at most 1e50 in absolute value";
    argument(name, value, value.abs() <= LARGEST, range)
}

fn check_start(start: &State, until: f64) -> Result<(), MotionError> {
    let parts = [
        ("t", start.t),
        ("x", start.x[0]),
        ("y", start.x[1]),
        ("vx", start.v[0]),
        ("vy", start.v[1]),
    ];
    for (name, value) in parts {
        size(name, value)?;
    }
    size("until", until)?;
    argument("until", until, until >= start.t, "not before the start")
}
