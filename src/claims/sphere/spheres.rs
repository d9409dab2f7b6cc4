//! The motions of the rigid sphere that section 3 is held against, with m, R, I, μ and g that are not 1.

use super::prelude::*;
use crate::motion::Acceleration;

#[derive(Debug, Clone)]
pub(super) struct Case {
    pub sphere: Sphere,
    pub plane: Plane,
    /// Of A.
    pub size: f64,
    /// At t = 0.
    pub start: Ball,
    /// Its parameters.
    pub name: String,
}

#[derive(Debug)]
pub(super) struct Followed {
    pub case: Case,
    pub motion: BallMotion,
    pub until: f64,
}

impl Case {
    pub(super) fn acceleration(&self, t: f64) -> [f64; 3] {
        let [x, y] = self.plane.coefficients(t).map(|series| series[0]);
        [x, y, 0.0]
    }

    /// **R** by (61).
    pub(super) fn contact(&self) -> [f64; 3] {
        printed::eq61_contact(self.sphere.radius)
    }

    /// κ by (62).
    pub(super) fn kappa(&self) -> f64 {
        printed::eq62_kappa(self.sphere.inertia, self.sphere.mass, self.sphere.radius)
    }

    /// b by (67).
    pub(super) fn b(&self) -> f64 {
        printed::eq67_factor(self.kappa())
    }

    /// By how much friction slows the slip: Newton's law for the centre and Euler's for the turning, added.
    pub(super) fn braking(&self) -> f64 {
        braking(&self.sphere)
    }

    /// (R, μ, g), of which the units of (68) to (72) are made.
    pub(super) fn parameters(&self) -> (f64, f64, f64) {
        (self.sphere.radius, self.sphere.mu, self.sphere.g)
    }

    pub(super) fn run(self, until: f64) -> Result<Followed, MotionError> {
        let motion = self.sphere.run(&self.plane, &self.start, until)?;
        Ok(Followed {
            case: self,
            motion,
            until,
        })
    }
}

pub(super) fn braking(sphere: &Sphere) -> f64 {
    (1.0 + 1.0 / sphere.kappa()) * sphere.mu * sphere.g
}

/// The dimensionless state at a time: by the printed definitions, or in the sphere's own units.
#[derive(Debug, Clone, Copy)]
pub(super) struct Dimensionless {
    /// ρ, by (68).
    pub rho: [f64; 3],
    /// dρ/dτ, by (68) and (69).
    pub rho_rate: [f64; 3],
    /// ζ, by (70).
    pub zeta: [f64; 3],
    /// u, by (71).
    pub u: [f64; 3],
    /// γ, by (72).
    pub gamma: [f64; 3],
}

#[derive(Debug, Clone, Copy)]
pub(super) struct Units {
    /// R.
    pub length: f64,
    /// μg.
    pub push: f64,
    /// √(R/(μg)).
    pub time: f64,
    /// √(μgR).
    pub speed: f64,
}

impl Units {
    pub(super) fn of(sphere: &Sphere) -> Self {
        let (length, push) = (sphere.radius, sphere.mu * sphere.g);
        Units {
            length,
            push,
            time: libm::sqrt(length / push),
            speed: libm::sqrt(length * push),
        }
    }
}

impl Followed {
    /// In the sphere's own units, without the paper's formulas.
    pub(super) fn own(&self, t: f64) -> Result<Dimensionless, MotionError> {
        let Units {
            length,
            push,
            time,
            speed,
        } = self.units();
        let ball = self.motion.at(t)?;
        let [sx, sy] = self.motion.slip(t)?;
        let over = |[x, y, z]: [f64; 3], unit: f64| [x / unit, y / unit, z / unit];
        let flat = |[x, y]: [f64; 2]| [x, y, 0.0];
        Ok(Dimensionless {
            rho: over(flat(ball.x), length),
            rho_rate: over(flat(ball.v), speed),
            zeta: over(ball.omega, 1.0 / time),
            u: over([sx, sy, 0.0], speed),
            gamma: over(self.case.acceleration(t), push),
        })
    }

    pub(super) fn at_end(&self) -> String {
        self.at(self.until)
    }

    pub(super) fn units(&self) -> Units {
        Units::of(&self.case.sphere)
    }

    /// By the printed definitions.
    pub(super) fn dimensionless(&self, t: f64) -> Result<Dimensionless, MotionError> {
        let (radius, mu, g) = self.case.parameters();
        let ball = self.motion.at(t)?;
        let [sx, sy] = self.motion.slip(t)?;
        let flat = |[x, y]: [f64; 2]| [x, y, 0.0];
        let rate = printed::eq68_position(radius, flat(ball.v));
        Ok(Dimensionless {
            rho: printed::eq68_position(radius, flat(ball.x)),
            rho_rate: rate.map(|c| c / self.tau_rate()),
            zeta: printed::eq70_spin(radius, mu, g, ball.omega),
            u: printed::eq71_slip(radius, mu, g, [sx, sy, 0.0]),
            gamma: printed::eq72_acceleration(mu, g, self.case.acceleration(t)),
        })
    }

    /// dτ/dt by (69).
    pub(super) fn tau_rate(&self) -> f64 {
        let (radius, mu, g) = self.case.parameters();
        printed::eq69_time(radius, mu, g, 1.0)
    }

    pub(super) fn at(&self, t: f64) -> String {
        format!("{}, t = {t:.6}", self.case.name)
    }
}

/// Between a point mass and a hoop, the solid and the hollow one in their turn.
pub(super) fn sphere(i: usize, points: &mut Points) -> Sphere {
    let kappa = match i % 4 {
        0 => 0.4,
        1 => 2.0 / 3.0,
        2 => points.uniform(0.05, 1.0),
        _ => points.uniform(0.2, 0.8),
    };
    let (mass, radius) = (points.log_uniform(0.2, 5.0), points.log_uniform(0.2, 5.0));
    Sphere {
        mass,
        radius,
        inertia: kappa * mass * radius * radius,
        mu: points.uniform(0.1, 1.4),
        g: points.uniform(2.0, 12.0),
    }
}

/// Constant, swinging and turning accelerations of a size to let the sphere slide and roll.
pub(super) fn case(i: usize, points: &mut Points) -> Case {
    let sphere = sphere(i, points);
    let push = sphere.mu * sphere.g;
    let size = push * points.log_uniform(0.4, 6.0);
    let angle = points.uniform(-PI, PI);
    let direction = [libm::cos(angle), libm::sin(angle)];
    let (frequency, phase) = (points.uniform(0.5, 3.0), points.uniform(0.0, TAU));
    let sine = Signal::Sine { frequency, phase };
    let plane = match i % 3 {
        0 => Plane::constant(direction.map(|c| c * size)),
        1 => Plane::along(direction, sine.times(size)),
        _ => Plane::rotating(Signal::constant(size), frequency, phase),
    };
    let speed = push * points.log_uniform(0.3, 3.0);
    let (toward, around) = (points.uniform(-PI, PI), points.uniform(-PI, PI));
    let turn = points.log_uniform(0.3, 3.0) * speed / sphere.radius;
    let start = Ball {
        t: 0.0,
        x: [points.uniform(-1.0, 1.0), points.uniform(-1.0, 1.0)],
        v: [speed * libm::cos(toward), speed * libm::sin(toward)],
        omega: [
            turn * libm::cos(around),
            turn * libm::sin(around),
            points.uniform(-2.0, 2.0) * turn,
        ],
    };
    let kind = ["constant", "swinging", "turning"][i % 3];
    let name = format!(
        "κ = {:.6}, m = {:.6}, R = {:.6}, μ = {:.6}, g = {:.6}, {kind} A of size {size:.6}",
        sphere.kappa(),
        sphere.mass,
        sphere.radius,
        sphere.mu,
        sphere.g
    );
    Case {
        sphere,
        plane,
        size,
        start,
        name,
    }
}

/// They end before sliding does.
pub(super) static SLIDING: Runs<Vec<Followed>> = Runs::new(|| {
    let mut points = Points::here();
    let run = |i| {
        let case = case(i, &mut points);
        let [x, y] = case.sphere.contact(&case.start);
        let slip = libm::hypot(x, y);
        let friction = case.braking();
        // The lowest point loses its velocity no faster than friction and A together take it.
        let a = (0..40).map(|k| {
            let [x, y, _] = case.acceleration(f64::from(k) * slip / friction / 40.0);
            libm::hypot(x, y)
        });
        let until = 0.7 * slip / (friction + a.fold(0.0, f64::max));
        case.run(until)
    };
    every((0..32).map(run))
});

pub(super) static MIXED: Runs<Vec<Followed>> = Runs::new(|| {
    let mut points = Points::here();
    let run = |i| {
        let case = case(i, &mut points);
        let until = points.uniform(3.0, 9.0);
        case.run(until)
    };
    every((0..32).map(run))
});

/// Three between start and end.
pub(super) fn moments() -> impl Iterator<Item = Result<(&'static Followed, f64), Failure>> {
    let moments = with_each(MIXED.each(), [0.31, 0.62, 1.0]);
    moments.map(|moment| moment.map(|(run, share)| (run, share * run.until)))
}

/// All components of a vector in one number, each with a weight of its own.
pub(super) fn weighed([x, y, z]: [f64; 3]) -> f64 {
    x + 2.0 * y + 3.0 * z
}

pub(super) fn length([x, y, z]: [f64; 3]) -> f64 {
    libm::hypot(libm::hypot(x, y), z)
}
