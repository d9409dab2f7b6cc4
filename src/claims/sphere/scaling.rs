//! Trials of (62) and (68) to (72): two spheres that differ in all but the dimensionless quantities move alike.

use super::spheres::{Case, Dimensionless, length, sliding, sphere, weighed};
use crate::claims::compare::{Failure, Pair, Trial};
use crate::claims::points::Points;
use crate::claims::runs::{Runs, every};
use crate::claims::tolerances::MOTION;
use crate::evidence::{Evidence, Route, Subject};
use crate::motion::sphere::{Ball, Directed};
use crate::motion::{Plane, Signal};
use crate::numerics::quadrature::integral_within;
use crate::paper::sphere as printed;

/// Two spheres with the same κ, γ(τ), ρ, dρ/dτ and ζ at the start, at the same τ.
#[derive(Debug)]
struct Twins {
    at: String,
    /// γτ, the size that velocities may reach, and τ.
    speed: f64,
    tau: f64,
    kappa: [f64; 2],
    states: [Dimensionless; 2],
    /// τ of the first change between sliding and rolling.
    change: [f64; 2],
}

/// A state, drive and time in the paper's units.
struct Plan {
    kappa: f64,
    gamma: f64,
    angle: f64,
    frequency: f64,
    phase: f64,
    rho: [f64; 2],
    rho_rate: [f64; 2],
    zeta: [f64; 3],
    tau: f64,
}

impl Plan {
    fn new(points: &mut Points) -> Self {
        let mut pair = || [points.uniform(-2.0, 2.0), points.uniform(-2.0, 2.0)];
        let (rho, rho_rate, [x, y]) = (pair(), pair(), pair());
        Plan {
            kappa: points.uniform(0.2, 1.0),
            gamma: points.uniform(0.5, 5.0),
            angle: points.uniform(-3.0, 3.0),
            frequency: points.uniform(0.5, 2.0),
            phase: points.uniform(0.0, 6.0),
            rho,
            rho_rate,
            zeta: [x, y, points.uniform(-2.0, 2.0)],
            tau: points.uniform(1.0, 6.0),
        }
    }

    /// The plan for one sphere, its mass, radius, μ and g being given: κ, γ, state and τ at the end.
    fn follow(&self, i: usize, points: &mut Points) -> Result<(f64, Dimensionless, f64), Failure> {
        let mut sphere = sphere(i, points);
        let (radius, mu, g) = (sphere.radius, sphere.mu, sphere.g);
        sphere.inertia = self.kappa / printed::eq62_kappa(1.0, sphere.mass, radius);
        // The printed definitions are linear: divided by their value at 1, they give the quantities themselves.
        let one = [1.0; 3];
        let length = 1.0 / printed::eq68_position(radius, one)[0];
        let clock = printed::eq69_time(radius, mu, g, 1.0);
        let turning = 1.0 / printed::eq70_spin(radius, mu, g, one)[0];
        let pull = 1.0 / printed::eq72_acceleration(mu, g, one)[0];
        let sine = Signal::Sine {
            frequency: self.frequency * clock,
            phase: self.phase,
        };
        let direction = [libm::cos(self.angle), libm::sin(self.angle)];
        let case = Case {
            sphere,
            plane: Plane::along(direction, sine.times(self.gamma * pull)),
            size: self.gamma * pull,
            start: Ball {
                t: 0.0,
                x: self.rho.map(|c| c * length),
                v: self.rho_rate.map(|c| c * length * clock),
                omega: self.zeta.map(|c| c * turning),
            },
            name: String::new(),
        };
        let kappa = case.kappa();
        let run = case.run(self.tau / clock)?;
        let first = run
            .motion
            .transitions()
            .first()
            .map_or(0.0, |t| t.t * clock);
        Ok((kappa, run.dimensionless(run.until)?, first))
    }
}

fn twins() -> impl Iterator<Item = Result<&'static Twins, Failure>> {
    static TWINS: Runs<Vec<Twins>> = Runs::new(|| {
        let mut points = Points::stream(403);
        let pair = |i: usize| -> Result<_, Failure> {
            let plan = Plan::new(&mut points);
            let (ours, theirs) = (
                plan.follow(i, &mut points)?,
                plan.follow(i + 1, &mut points)?,
            );
            Ok(Twins {
                at: format!(
                    "κ = {:.6}, γ = {:.6}, ζ₃ = {:.6}, τ = {:.6}",
                    plan.kappa, plan.gamma, plan.zeta[2], plan.tau
                ),
                speed: plan.gamma * plan.tau,
                tau: plan.tau,
                kappa: [ours.0, theirs.0],
                states: [ours.1, theirs.1],
                change: [ours.2, theirs.2],
            })
        };
        every((0..24).map(pair))
    });
    TWINS.each()
}

fn alike(compared: &'static str, of: impl Fn(&Twins, usize) -> [f64; 3]) -> Evidence {
    let trial = Trial::by(Route::Consistency, Subject::Printed, compared, MOTION);
    trial.over(twins(), |twins| {
        let twins = twins?;
        let (ours, theirs) = (of(twins, 0), of(twins, 1));
        let state = &twins.states[0];
        Ok(Pair {
            at: twins.at.clone(),
            stated: weighed(ours),
            found: weighed(theirs),
            scale: 1.0
                + length(state.rho)
                + length(state.rho_rate)
                + length(state.zeta)
                + twins.speed * twins.tau,
        })
    })
}

/// (62).
pub fn eq62() -> Evidence {
    let compared =
        "κ + dρ/dτ of two spheres of the same κ by (62) with different m, R, I, μ, g; x + 2y";
    alike(compared, |twins, i| {
        let [x, y, _] = twins.states[i].rho_rate;
        [twins.kappa[i] + x, y, 0.0]
    })
}

/// (68).
pub fn eq68() -> Evidence {
    let compared = "ρ by (68), at the same τ, of two spheres with different m, R, I, μ, g; x + 2y";
    alike(compared, |twins, i| twins.states[i].rho)
}

/// (68) as what the velocity adds up to.
pub fn eq68_way() -> Evidence {
    let compared = "the change of (68) with ∫ (d𝐫/dt)/R dt of a sphere that slides; x + 2y";
    let trial = Trial::by(Route::Consistency, Subject::Printed, compared, MOTION);
    trial.over(sliding(), |run| {
        let run = run?;
        let (radius, ..) = run.case.units();
        let place = |[x, y]: [f64; 2]| weighed(printed::eq68_position(radius, [x, y, 0.0]));
        let rate = |t: f64| {
            let ball = run.motion.at(t);
            ball.map_or(f64::NAN, |b| (b.v[0] + 2.0 * b.v[1]) / radius)
        };
        let (start, end) = (&run.case.start, run.motion.end());
        let size = libm::hypot(start.v[0], start.v[1]) + run.case.size * run.until;
        let scale = size * run.until / radius;
        Ok(Pair {
            at: run.at(run.until),
            stated: place(end.x) - place(start.x),
            found: integral_within(rate, 0.0, run.until, 1e-13 * scale)?.value,
            scale: scale + place(start.x).abs(),
        })
    })
}

/// (71) where the sphere slides with one friction forwards and with another backwards.
pub fn eq71_both_ways() -> Evidence {
    let compared = "u by (71) from d𝐫/dt and ω with that from the slip velocity, of a sphere on a line with μ₋ ≠ μ₊, followed by itself";
    let trial = Trial::by(Route::Consistency, Subject::Printed, compared, MOTION);
    let mut points = Points::stream(421);
    trial.over(0..24, |i| {
        let sphere = sphere(i, &mut points);
        let (radius, mu, g) = (sphere.radius, sphere.mu, sphere.g);
        let frequency = points.uniform(0.5, 3.0);
        let sine = Signal::Sine {
            frequency,
            phase: points.uniform(0.0, 6.0),
        };
        let size = mu * g * points.log_uniform(2.0, 8.0);
        let plane = Plane::along([1.0, 0.0], sine.times(size));
        let v = points.uniform(-2.0, 2.0);
        let omega = points.uniform(-2.0, 2.0) / radius;
        let directed = Directed {
            sphere,
            mu_minus: mu * points.uniform(1.0, 4.0),
        };
        let until = points.uniform(2.0, 8.0) / frequency;
        let end = directed.run(&plane, [v, omega], 0.0, until)?.end;
        let arm = printed::eq61_contact(radius);
        let slip = printed::slip([end.v, 0.0, 0.0], [0.0, end.omega, 0.0], arm);
        let u = |slip: [f64; 3]| printed::eq71_slip(radius, mu, g, slip)[0];
        Ok(Pair {
            at: format!(
                "μ₋/μ₊ = {:.6}, ϖt = {:.6}",
                directed.mu_minus / mu,
                frequency * until
            ),
            stated: u(slip),
            found: u([end.slip, 0.0, 0.0]),
            scale: u([2.0 + size * until, 0.0, 0.0]),
        })
    })
}

/// (69).
pub fn eq69() -> Evidence {
    let compared =
        "τ by (69) at which two spheres with different m, R, I, μ, g begin to roll or slide";
    alike(compared, |twins, i| [twins.change[i], 0.0, 0.0])
}

/// (70).
pub fn eq70() -> Evidence {
    let compared =
        "ζ by (70), at the same τ, of two spheres with different m, R, I, μ, g; x + 2y + 3z";
    alike(compared, |twins, i| twins.states[i].zeta)
}

/// (71).
pub fn eq71() -> Evidence {
    let compared = "u by (71), at the same τ, of two spheres with different m, R, I, μ, g; x + 2y";
    alike(compared, |twins, i| twins.states[i].u)
}

/// (72).
pub fn eq72() -> Evidence {
    let compared =
        "γ by (72) at the end, and dρ/dτ, of two spheres with different m, R, I, μ, g; x + 2y";
    alike(compared, |twins, i| {
        let state = &twins.states[i];
        [0, 1, 2].map(|k| state.gamma[k] + state.rho_rate[k])
    })
}
