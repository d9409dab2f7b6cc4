//! Trials of (62) and (68) to (72): two spheres that differ in all but the dimensionless quantities move alike, and one
//! of them has 1 for each unit.

use super::prelude::*;
use super::spheres::{Case, Dimensionless, SLIDING, Units, length};

/// A sphere, and the one with m = R = μ = g = 1 and the same κ, drive and start in its own units, until the same
/// time in these.
#[derive(Debug)]
struct Twins {
    at: String,
    /// γτ, the size that velocities may reach, and τ.
    speed: f64,
    tau: f64,
    ours: Followed,
    unit: Followed,
}

impl Twins {
    fn at(&self) -> String {
        self.at.clone()
    }
}

/// In the paper's units.
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

    fn follow(&self, sphere: Sphere) -> Result<Followed, Failure> {
        let Units {
            length,
            push,
            time,
            speed,
        } = Units::of(&sphere);
        let sine = Signal::Sine {
            frequency: self.frequency / time,
            phase: self.phase,
        };
        let direction = [libm::cos(self.angle), libm::sin(self.angle)];
        let case = Case {
            sphere,
            plane: Plane::along(direction, sine.times(self.gamma * push)),
            size: self.gamma * push,
            start: Ball {
                t: 0.0,
                x: self.rho.map(|c| c * length),
                v: self.rho_rate.map(|c| c * speed),
                omega: self.zeta.map(|c| c / time),
            },
            name: String::new(),
        };
        Ok(case.run(self.tau * time)?)
    }
}

static TWINS: Runs<Vec<Twins>> = Runs::new(|| {
    let mut points = Points::here();
    let pair = |i: usize| -> Result<_, Failure> {
        let plan = Plan::new(&mut points);
        let mut ours = sphere(i, &mut points);
        if i >= 18 {
            // Large, and so slow that its times are long.
            ours.radius *= 1e4;
        }
        ours.inertia = plan.kappa * ours.mass * ours.radius * ours.radius;
        Ok(Twins {
            at: format!(
                "κ = {:.6}, γ = {:.6}, ζ₃ = {:.6}, τ = {:.6}",
                plan.kappa, plan.gamma, plan.zeta[2], plan.tau
            ),
            speed: plan.gamma * plan.tau,
            tau: plan.tau,
            ours: plan.follow(ours)?,
            unit: plan.follow(Sphere::with_kappa(plan.kappa))?,
        })
    };
    every((0..24).map(pair))
});

const PLANE: &str = ", at the same time in these, each vector by the one number $x+2y$";
const SPACE: &str = ", at the same time in these, each vector by the one number $x+2y+3z$";

/// What a definition makes of the motion of the one with the same quantity of the other, at their ends.
fn alike(
    [by_definition, own, each]: [&'static str; 3],
    stated: impl Fn(&Followed, &Dimensionless) -> [f64; 3],
    found: impl Fn(&Followed, &Dimensionless) -> [f64; 3],
) -> Evidence {
    const TWIN: &str = r" of the one with $m=R=\mu=g=1$ that has the same $\kappa$, drive and start in its own units";
    Trial::consistency(
        Printed,
        Compared::composed([by_definition, " of a sphere", ""], [own, TWIN, each]),
    )
    .each(TWINS.each(), Twins::at, |twins| {
        let Twins { ours, unit, .. } = twins;
        let (by_definition, own) = (ours.dimensionless(ours.until)?, unit.own(unit.until)?);
        Ok([
            weighed(stated(ours, &by_definition)),
            weighed(found(unit, &own)),
            1.0 + length(own.rho)
                + length(own.rho_rate)
                + length(own.zeta)
                + twins.speed * twins.tau,
        ])
    })
}

/// When it first begins to roll or to slide; 0 if it does not.
fn first_change(run: &Followed) -> f64 {
    run.motion.transitions().first().map_or(0.0, |c| c.t)
}

fn eq71_both_ways() -> Evidence {
    let trial = Trial::consistency(
        Printed,
        [
            r"$\bm u$ by (71) from $\mathrm d\bm r/\mathrm dt$ and $\bm\omega$",
            r"that from the slip velocity, of a sphere on a line with $\mu_-\ne\mu_+$, which has equations of its own",
        ],
    );
    trial.drawn(0..24, |i, points| {
        let sphere = sphere(i, points);
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
        let unit = libm::sqrt(radius * mu * g);
        Ok(Pair {
            at: format!(
                "μ₋/μ₊ = {:.6}, ϖt = {:.6}",
                directed.mu_minus / mu,
                frequency * until
            ),
            stated: printed::eq71_slip(radius, mu, g, slip)[0],
            found: end.slip / unit,
            scale: (2.0 + size * until) / unit,
        })
    })
}

/// A vector with a number added to its first component.
fn both(kappa: f64, [x, y, _]: [f64; 3]) -> [f64; 3] {
    [kappa + x, y, 0.0]
}

fn driven(_: &Followed, state: &Dimensionless) -> [f64; 3] {
    [0, 1, 2].map(|k| state.gamma[k] + state.rho_rate[k])
}

attempts![
    eq62 = alike(
        [
            r"the sum of $\kappa$ by (62), along $x$, and $\mathrm d\bm\rho/\mathrm d\tau$",
            r"that of $I$ and $\bm v$",
            PLANE
        ],
        |run, state| both(run.case.kappa(), state.rho_rate),
        |run, state| both(run.case.sphere.inertia, state.rho_rate),
    ),
    eq68 = alike(
        [r"$\bm\rho$ by (68)", r"$\bm r$", PLANE],
        |_, state| state.rho,
        |_, state| state.rho
    ),
    eq68_way = {
        let trial = Trial::consistency(
            Printed,
            [
                "the change of (68)",
                r"the integral of $(\mathrm d\bm r/\mathrm dt)/R$ over $t$ of a sphere that slides, each vector by the one number $x+2y$",
            ],
        );
        trial.each(SLIDING.each(), Followed::at_end, |run| {
            let (radius, ..) = run.case.parameters();
            let place = |[x, y]: [f64; 2]| weighed(printed::eq68_position(radius, [x, y, 0.0]));
            let rate = |t: f64| {
                let ball = run.motion.at(t);
                ball.map_or(f64::NAN, |b| (b.v[0] + 2.0 * b.v[1]) / radius)
            };
            let (start, end) = (&run.case.start, run.motion.end());
            let size = libm::hypot(start.v[0], start.v[1]) + run.case.size * run.until;
            let scale = size * run.until / radius;
            Ok([
                place(end.x) - place(start.x),
                integral_within(rate, 0.0, run.until, 1e-13 * scale)?.value,
                scale + libm::hypot(start.x[0], start.x[1]) / radius,
            ])
        })
    },
    eq69 = alike(
        [
            r"the time $\tau$ by (69) of the first change between sliding and rolling",
            "that time",
            "",
        ],
        |run, _| {
            let (radius, mu, g) = run.case.parameters();
            let tau = printed::eq69_time(radius, mu, g, first_change(run));
            [tau, 0.0, 0.0]
        },
        |run, _| [first_change(run), 0.0, 0.0],
    ),
    eq70 = alike(
        [r"$\bm\zeta$ by (70)", r"$\bm\omega$", SPACE],
        |_, state| state.zeta,
        |_, state| state.zeta
    ),
    eq71 = alike(
        [r"$\bm u$ by (71)", "the slip", PLANE],
        |_, state| state.u,
        |_, state| state.u
    ),
    eq71_both_ways,
    eq72 = alike(
        [
            r"the sum of $\bm\gamma$ by (72) and $\mathrm d\bm\rho/\mathrm d\tau$",
            r"that of $\bm A$ and $\bm v$",
            PLANE
        ],
        driven,
        driven
    )
];
