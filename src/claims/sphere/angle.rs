//! Trials of (80) to (83): slip under constant acceleration, in the paper's own units, of the rigid sphere.

use super::prelude::*;
use super::spheres::Units;
use crate::claims::constant::launches::Turn as Launched;
use crate::corrections::constant::{speed, time};

#[derive(Debug, Clone)]
pub(crate) struct Turn {
    sphere: Sphere,
    a: f64,
    /// The slip u, γ and τ in the place of a particle's v, A and t.
    slip: Launched,
}

/// The share of tan(θ/2) that is left at least: the motion takes a component below 1e-90 of the other for none.
const LEAST: f64 = 1e-80;
/// The share that is left at most where less than that was left at first.
const MOST: f64 = 1e-40;

impl Turn {
    /// With this friction λ, from slip `u0` at the angle `theta0`; `elapsed` is in units of what it takes to stop if
    /// it stops, of u₀/γ if not.
    fn new(
        i: usize,
        points: &mut Points,
        lambda: f64,
        theta0: f64,
        elapsed: f64,
    ) -> Result<Self, Failure> {
        let sphere = sphere(i, points);
        let units = Units::of(&sphere);
        let a = braking(&sphere) / lambda;
        let u0 = points.log_uniform(0.1, 10.0);
        let w = u0 * units.speed;
        let toward = if theta0.abs() == PI {
            [-w, 0.0]
        } else {
            [w * libm::cos(theta0), w * libm::sin(theta0)]
        };
        let (share, spin) = (points.uniform(-1.0, 2.0), points.uniform(-3.0, 3.0));
        let rest = toward.map(|c| (1.0 - share) * c / sphere.radius);
        let start = Ball {
            t: 0.0,
            x: [0.0; 2],
            v: toward.map(|c| share * c),
            omega: [rest[1], -rest[0], spin],
        };
        let plane = Plane::constant([-a, 0.0]);
        let long = if lambda > 1.0 {
            let motion = sphere.run(&plane, &start, 4.0 * w / (a * (lambda - 1.0)))?;
            motion.transitions().first().ok_or("it does not stop")?.t
        } else {
            w / a
        };
        let slip = |t: f64| sphere.run(&plane, &start, t)?.slip(t);
        let tangent = |[x, y]: [f64; 2]| libm::tan(libm::atan2(y, x).abs() / 2.0);
        let left = |end| tangent(end) / libm::tan(theta0.abs() / 2.0);
        let mut t = elapsed * long;
        let mut end = slip(t)?;
        // Where next to no angle is left, the little that is left is lost in rounding: look earlier, but while the angle is still tiny.
        let (mut early, mut late) = (0.0, t);
        // Straight against the force there is no angle to lose: the slip turns round at once.
        let most = if theta0.abs() == PI {
            f64::INFINITY
        } else {
            MOST
        };
        while left(end) < LEAST || (t < elapsed * long && left(end) > most) {
            if left(end) < LEAST {
                late = t;
            } else {
                early = t;
            }
            t = 0.5 * (early + late);
            if !(early < t && t < late) {
                return Err("the angle vanishes all at once".into());
            }
            end = slip(t)?;
        }
        let [x, y] = end;
        Ok(Turn {
            sphere,
            a,
            slip: Launched {
                v: libm::hypot(x, y) / units.speed,
                theta: libm::atan2(y, x),
                t: t / units.time,
                ..Launched::launch(lambda, a / units.push, u0, theta0)
            },
        })
    }

    fn at(&self) -> String {
        let Launched {
            lambda,
            a: gamma,
            v0: u0,
            theta0,
            theta,
            ..
        } = self.slip;
        format!("λ = {lambda:.6}, γ = {gamma:.6}, u₀ = {u0:.6}, θ₀ = {theta0:.6}, θ = {theta:.6}")
    }

    fn numbers(&self) -> [Double; 6] {
        let s = &self.slip;
        [s.lambda, s.v0, s.theta0, s.theta, s.t, s.a].map(Double::from)
    }
}

/// Slips from here on are late: τ is up to some hundreds.
const LATE: usize = 220;

const EDGES: [f64; 4] = [5e-4, 1.0 - 5e-4, 1.0 + 5e-4, 12.0];

/// Slips that turn: random ones, then λ = 1, then cos θ₀ = −λ, then λ at its edges, then late ones.
static TURNS: Runs<Vec<Turn>> = Runs::new(|| {
    let mut points = Points::here();
    let turn = |i: usize| {
        let lambda = match i {
            160..180 => 1.0,
            _ if i.is_multiple_of(2) => points.uniform(0.05, 1.0),
            _ => points.uniform(1.0, 12.0),
        };
        let theta0 = points.sign() * points.uniform(0.2, 3.1);
        let (lambda, theta0) = match i {
            180..200 => (
                -libm::cos(1.6 + 0.07 * (i - 180) as f64),
                1.6 + 0.07 * (i - 180) as f64,
            ),
            200..LATE => (EDGES[i % EDGES.len()], theta0),
            LATE.. => (points.uniform(0.1, 0.9), theta0),
            _ => (lambda, theta0),
        };
        // Late slips at large friction have next to no angle left.
        let elapsed = points.uniform(0.05, 0.8) * if i < LATE { 1.0 } else { 400.0 };
        Turn::new(i, &mut points, lambda, theta0, elapsed)
    };
    every((0..LATE + 20).map(turn))
});

static STRAIGHT: Runs<Vec<Turn>> = Runs::new(|| {
    let mut points = Points::here();
    let turn = |i: usize| {
        let lambda = points.uniform(0.1, 4.0);
        let theta0 = [0.0, PI][i % 2];
        // At λ just above 1 the stop is far away, and tan(θ/2) falls as (u/u₀)^(1/(λ − 1)).
        let elapsed = if lambda > 1.0 {
            0.2 * libm::fmin(50.0 * (lambda - 1.0), 1.0)
        } else {
            0.2
        };
        Turn::new(i, &mut points, lambda, theta0, elapsed)
    };
    every((0..40).map(turn))
});

pub(crate) fn eq81() -> Evidence {
    Trial::motion(
        Within,
        ["(81)", r"the slip of the motion at the angle $\theta$"],
    )
    .over(TURNS.each(), |turn| {
        let turn = turn?;
        let stated = turn.slip.formula(printed::eq81_slip);
        Ok(Pair::wide(turn.at(), stated, turn.slip.v).within(turn.slip.v * turn.slip.condition()))
    })
}

pub(crate) fn regular_straight() -> Evidence {
    let trial = Trial::motion(
        Corrected,
        [
            r"the regular form of $u$ along the line of the acceleration, with $r$ from the regular form of $\tau$,",
            "the slip of the motion",
        ],
    );
    trial.each(STRAIGHT.each(), Turn::at, |turn| {
        let Launched {
            lambda,
            a: gamma,
            v0: u0,
            theta0,
            t: tau,
            ..
        } = turn.slip;
        let late = |ln_r: f64| time(lambda, gamma, u0, theta0, ln_r) - tau;
        let r = libm::exp(root(late, -20.0, 0.0).unwrap_or(f64::NAN));
        Ok([speed(lambda, u0, theta0, r), turn.slip.v, u0])
    })
}

type Time = fn([Double; 6]) -> Double;

/// What a formula gives at a turn: its name, where it is tried, and what the motion has, with the unit.
type Found = (&'static str, fn(&Turn) -> bool, fn(&Launched) -> [f64; 2]);

const TIME: Found = (
    r"the time $\tau$ of the motion at the angle $\theta$",
    |turn| turn.slip.has_a_time(),
    |slip| [slip.t, slip.time_scale()],
);
const SLIP: Found = (
    "its slip",
    |_| true,
    |slip| [slip.v, slip.speed_at_time_scale()],
);

fn at_turns(
    subject: Subject,
    (name, wanted, found): Found,
    stated: &'static str,
    formula: Time,
) -> Evidence {
    let turns = only(TURNS.each(), |turn| wanted(turn));
    Trial::motion(subject, [stated, name]).over(turns, |turn| {
        let turn = turn?;
        let [found, scale] = found(&turn.slip);
        Ok(Pair::wide(turn.at(), formula(turn.numbers()), found).within(scale))
    })
}

/// (82) with its factor.
fn corrected_time([lambda, u0, theta0, theta, _, gamma]: [Double; 6]) -> Double {
    corrected::time(lambda, gamma, u0, theta0, theta)
}

pub(crate) fn regular_time() -> Evidence {
    Trial::motion(
        Corrected,
        [
            r"the regular form of $\tau$",
            r"that of the motion, $\lambda=1$ and $\cos\theta_0=-\lambda$ included",
        ],
    )
    .each(TURNS.each(), Turn::at, |turn| {
        Ok([
            time(
                turn.slip.lambda,
                turn.slip.a,
                turn.slip.v0,
                turn.slip.theta0,
                libm::log(turn.slip.r()),
            ),
            turn.slip.t,
            turn.slip.t * turn.slip.condition(),
        ])
    })
}

pub(crate) fn times_over_printed() -> Result<Vec<[f64; 2]>, Failure> {
    let known = only(TURNS.each(), |turn| turn.slip.has_a_time());
    known
        .map(|turn| {
            let turn = turn?;
            let stated = printed::eq82_time(
                turn.slip.lambda,
                turn.slip.v0,
                turn.slip.theta0,
                turn.slip.theta,
            );
            Ok([turn.slip.a, turn.slip.t / stated])
        })
        .collect()
}

attempts![
    eq80 = Trial::consistency(
        Printed,
        [
            r"$v/v_0$ of a particle with $\mu g=\lambda A$, with $\lambda$ by (80),",
            "$u/u_0$ of a sphere at the same $At/v_0$",
        ],
    )
    .each(TURNS.each(), Turn::at, |turn| {
        let start = State::moving([libm::cos(turn.slip.theta0), libm::sin(turn.slip.theta0)]);
        let t = turn.slip.a * turn.slip.t / turn.slip.v0;
        let sphere = turn.sphere;
        let kappa = printed::eq62_kappa(sphere.inertia, sphere.mass, sphere.radius);
        let b = printed::eq67_factor(kappa);
        let lambda = printed::eq80_lambda(b, sphere.mu, sphere.g, turn.a);
        // The speed may grow far beyond its start.
        let unit = (turn.slip.v / turn.slip.v0).max(1.0);
        let particle = run(&Plane::constant([-1.0, 0.0]), lambda, start, t);
        // No particle has a friction below zero.
        Ok([
            particle.map_or(f64::NAN, |particle| particle.end().speed()),
            turn.slip.v / turn.slip.v0,
            unit,
        ])
    }),
    eq81,
    // (81) along the line of the acceleration, where it is 0/0.
    eq81_outside = Trial::motion(
        Outside,
        [
            "(81) along the line of the acceleration",
            "the slip of the motion",
        ],
    )
    .each(STRAIGHT.each(), Turn::at, |turn| {
        Ok([
            printed::eq81_slip(
                turn.slip.lambda,
                turn.slip.v0,
                turn.slip.theta0,
                turn.slip.theta,
            ),
            turn.slip.v,
            turn.slip.v0,
        ])
    }),
    regular_slip = Trial::motion(
        Corrected,
        ["the regular form of $u$", "the slip of the motion"],
    )
    .each(TURNS.each(), Turn::at, |turn| {
        Ok([
            speed(
                turn.slip.lambda,
                turn.slip.v0,
                turn.slip.theta0,
                turn.slip.r(),
            ),
            turn.slip.v,
            turn.slip.v.max(turn.slip.v0) * turn.slip.condition(),
        ])
    }),
    regular_straight,
    eq82 | corrected82 = at_turns(TIME)(
        ("(82)", |[lambda, u0, theta0, theta, ..]| {
            printed::eq82_time(lambda, u0, theta0, theta)
        }) | (r"(82) over $\gamma$", corrected_time)
    ),
    // (82) with its factor, from Newton's law across and along the slip: u dθ = −γ sin θ dτ and du = (γ cos θ − λγ) dτ.
    corrected82_quadrature = {
        let compared = Compared::one(
            r"(82) over $\gamma$",
            r"$-\int u\,\mathrm d\theta/(\gamma\sin\theta)$, with $u=u_0\exp\int(\lambda-\cos\theta)\,\mathrm d\theta/\sin\theta$, both integrals by another library's integrator",
        );
        let turns = only(TURNS.each(), |t| {
            t.slip.has_a_time() && t.slip.condition() < 100.0 && t.slip.theta.abs() > 1e-3
        });
        Trial::quadrature(Corrected, compared).over(turns, |turn| {
            let turn = turn?;
            let Launched {
                lambda,
                a: gamma,
                v0: u0,
                theta0,
                theta,
                ..
            } = turn.slip;
            // ln(u/u₀) and γτ/u₀ over y = ln tan(θ/2), in which dy = dθ/sin θ and cos θ = −tanh y.
            let rates = |y: f64, [ln_u, _]: &[f64; 2]| [lambda + libm::tanh(y), -libm::exp(*ln_u)];
            let y = |theta: f64| libm::log(libm::tan(theta.abs() / 2.0));
            let [_, late] = dop853::end(rates, y(theta0), [0.0; 2], y(theta), 1e-14, 1e-15)?;
            let found = late * u0 / gamma;
            let stated = corrected_time(turn.numbers());
            Ok(Pair::wide(turn.at(), stated, found).within(turn.slip.time_scale()))
        })
    },
    regular_time,
    eq83 | corrected83 = at_turns(SLIP)(
        (
            "(83) at the angle and time of the motion",
            |[lambda, u0, theta0, theta, tau, _]| {
                printed::eq83_slip_at_time(lambda, u0, theta0, theta, tau)
            }
        ) | (
            r"(83) with $\gamma\tau$ for $\tau$, at the angle and time of the motion,",
            |[lambda, u0, theta0, theta, tau, gamma]| {
                corrected::slip_at_time(lambda, gamma, u0, theta0, theta, tau)
            }
        )
    ),
    eq83_step = {
        let points = Points::here().within(40, [[0.2, 0.8], [0.5, 2.0], [1.0, 1.5], [0.3, 0.9]]);
        Trial::by(
            Consistency,
            Step,
            ["$u$ by (83) at the time of (82)", "$u$ by (81)"],
            ROOT,
        )
        .at(
            ["λ", "u₀", "θ₀", "θ"],
            points,
            1.0,
            |[lambda, u0, theta0, theta]| {
                let tau = printed::eq82_time(lambda, u0, theta0, theta);
                let slip = printed::eq83_slip_at_time(lambda, u0, theta0, theta, tau);
                Ok([slip / printed::eq81_slip(lambda, u0, theta0, theta), 1.0])
            },
        )
    }
];
