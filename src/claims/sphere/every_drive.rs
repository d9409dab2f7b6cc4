//! Trials of the statements in words about every A(t): the reduction, and the vertical spin.

use super::prelude::*;
use super::spheres::{Case, MIXED, case, length, moments};

/// The particle with bμ that begins with the sphere's slip velocity; none if bμ is below zero.
fn particle(run_of: &super::spheres::Followed) -> Result<crate::motion::Motion, Failure> {
    let case = &run_of.case;
    let start = State::moving(case.sphere.contact(&case.start));
    let friction = case.b() * case.sphere.mu * case.sphere.g;
    Ok(run(&case.plane, friction, start, run_of.until)?)
}

/// Rolling when the plane begins to pull, more than friction can follow, along a direction that turns.
fn released() -> impl Iterator<Item = Result<Followed, Failure>> {
    let mut points = Points::here();
    (0..24).map(move |i| {
        let case = case(i, &mut points);
        let [x, y] = [points.uniform(-1.0, 1.0), points.uniform(-1.0, 1.0)];
        let (frequency, phase) = (points.uniform(0.5, 3.0), points.uniform(0.0, TAU));
        let friction = braking(&case.sphere);
        let size = friction * points.uniform(1.05, 4.0);
        let case = Case {
            plane: Plane::rotating(Signal::constant(size), frequency, phase),
            size,
            start: Ball {
                v: [x, y],
                omega: case.sphere.rolling([x, y], 0.5),
                ..case.start
            },
            name: format!(
                "κ = {:.6}, A = {:.6} bμg, turning at {frequency:.6}, from rolling",
                case.kappa(),
                size / friction
            ),
            ..case
        };
        Ok(case.run(points.uniform(0.2, 1.0) / frequency)?)
    })
}

fn reduction_small_slip() -> Evidence {
    Trial::motion(
        Printed,
        [
            r"the time in which a particle with $b\mu$ that is as slow as the slip stops",
            "that in which the sphere, a billion times as fast, comes to roll",
        ],
    )
    .drawn(0..20, |i, points| {
        let sphere = sphere(i, points);
        let [x, y] = [points.uniform(0.5, 2.0), points.uniform(0.5, 2.0)];
        let slip = points.log_uniform(1e-11, 1e-9);
        let start = Ball {
            t: 0.0,
            x: [0.0; 2],
            v: [x, y],
            omega: sphere.rolling([x - slip, y], 0.3),
        };
        let still = Plane::constant([0.0; 2]);
        let v = sphere.contact(&start);
        let kappa = printed::eq62_kappa(sphere.inertia, sphere.mass, sphere.radius);
        let friction = printed::eq67_factor(kappa) * sphere.mu * sphere.g;
        let rest = State::moving(v);
        let until = 2.0 * libm::hypot(v[0], v[1]) / braking(&sphere);
        let particle = run(&still, friction, rest, until);
        let stop = particle.map_or(None, |particle| particle.first_stop());
        let motion = sphere.run(&still, &start, until)?;
        // One that rolls from the start has no slip to lose.
        let rolls = motion.transitions().first().map_or(0.0, |first| first.t);
        Ok(Pair {
            at: format!("κ = {kappa:.6}, slip {slip:.6e}"),
            stated: stop.unwrap_or(f64::NAN),
            found: rolls,
            scale: until,
        })
    })
}

pub(super) fn rolling_time(
    motion: &crate::motion::sphere::BallMotion,
    from: f64,
    to: f64,
) -> Result<f64, Failure> {
    let within = motion
        .transitions()
        .iter()
        .filter(|c| c.t > from && c.t < to);
    let mut total = 0.0;
    let (mut now, mut since) = (motion.contact(from)?, from);
    for change in within {
        if now == Contact::Rolling {
            total += change.t - since;
        }
        (now, since) = (change.to, change.t);
    }
    if now == Contact::Rolling {
        total += to - since;
    }
    Ok(total)
}

fn reduction_rest() -> Evidence {
    Trial::motion(Printed, Compared::many(
        r"the velocity $\mathrm d\bm\rho/\mathrm d\tau$ by (79) and the spin $\bm\zeta$ by the corrected (75), with $\bm u$ of the particle,",
        "those of the motion, all components in one weighted sum",
    )).each(MIXED.each(), Followed::at_end, |run| {
        let (b, t, zero) = (run.case.b(), run.until, [0.0; 3]);
        let (start, own_start, own) = (run.dimensionless(0.0)?, run.own(0.0)?, run.own(t)?);
        let (radius, mu, g) = run.case.parameters();
        let [x, y] = particle(run).map_or([f64::NAN; 2], |particle| particle.end().v);
        let u = printed::eq71_slip(radius, mu, g, [x, y, 0.0]);
        let without = printed::eq79_velocity(b, zero, start.u, zero);
        let c = [0, 1, 2].map(|i| start.rho_rate[i] - without[i]);
        let nu = super::rates::nu(run, t)?;
        let velocity = printed::eq79_velocity(b, nu, u, c);
        let zeta = corrected::spin(start.zeta[2], u, velocity);
        let velocities = length(own.u) + length(own.rho_rate) + length(own_start.rho_rate);
        Ok([
            weighed(velocity) + 7.0 * weighed(zeta),
            weighed(own.rho_rate) + 7.0 * weighed(own.zeta),
            length(nu) + velocities + length(own.zeta),
        ])
    })
}

fn spin_constant() -> Evidence {
    Trial::motion(Printed, Compared::many(
        r"a kept $\omega_z$, and the $x$, $\bm v$, $\omega_x$ and $\omega_y$ in which a motion with three times that $\omega_z$ ends,",
        "those of the motion, all in one weighted sum",
    )).each(MIXED.each(), Followed::at_end, |run| {
        let case = &run.case;
        let start = with_three_times_the_spin(case.start);
        let other = case.sphere.run(&case.plane, &start, run.until)?.end();
        let end = run.motion.end();
        let rest = |ball: &crate::motion::sphere::Ball| {
            let radius = case.sphere.radius;
            ball.x[0] / radius
                + 2.0 * ball.x[1] / radius
                + 3.0 * ball.v[0]
                + 4.0 * ball.v[1]
                + radius * (5.0 * ball.omega[0] + 6.0 * ball.omega[1])
        };
        let spin = |value: f64| 7.0 * case.sphere.radius * value;
        let units = run.units();
        let gained = printed::s3_zeta3_rate::<f64>() * run.until / (units.time * units.time);
        let size = length([end.v[0], end.v[1], 0.0]) + case.sphere.radius * length(end.omega);
        Ok([
            rest(&other) + spin(case.start.omega[2] + gained),
            rest(&end) + spin(end.omega[2]),
            size + libm::hypot(end.x[0], end.x[1]) / case.sphere.radius,
        ])
    })
}

fn with_three_times_the_spin(ball: Ball) -> Ball {
    let [x, y, z] = ball.omega;
    Ball {
        omega: [x, y, 3.0 * z],
        ..ball
    }
}

attempts![
    reduction_motion = {
        let trial = Trial::motion(
            Printed,
            [
                r"$\bm v$ of a particle with $b\mu$ under the same $\bm A$",
                "the slip velocity of the motion, sliding and rolling, each vector by the one number $x+2y$",
            ],
        );
        trial.over(moments(), |state| {
            let (run, t) = state?;
            let v = || -> Result<[f64; 2], Failure> { Ok(particle(run)?.at(t)?.v) };
            let [x, y] = v().unwrap_or([f64::NAN; 2]);
            let [sx, sy] = run.motion.slip(t)?;
            let [ux, uy] = run.case.sphere.contact(&run.case.start);
            let push = length(run.case.acceleration(t)).max(run.case.sphere.mu * run.case.sphere.g);
            Ok(Pair {
                at: run.at(t),
                stated: x + 2.0 * y,
                found: sx + 2.0 * sy,
                scale: libm::hypot(ux, uy) + push * t,
            })
        })
    },
    reduction_from_rest = {
        let trial = Trial::motion(
            Printed,
            [
                r"$\bm v$ of a particle with $b\mu$, from rest, under the same turning $\bm A$",
                "the slip velocity of a sphere that rolls at the start, each vector by the one number $x+2y$",
            ],
        );
        trial.over(released(), |run| {
            let run = run?;
            let Followed {
                case,
                motion,
                until,
            } = &run;
            let friction = case.b() * case.sphere.mu * case.sphere.g;
            let rest = State::moving([0.0; 2]);
            let particle = crate::motion::run(&case.plane, friction, rest, *until);
            let [x, y] = particle.map_or([f64::NAN; 2], |particle| particle.end().v);
            let [sx, sy] = motion.slip(*until)?;
            Ok(Pair {
                at: run.at(*until),
                stated: x + 2.0 * y,
                found: sx + 2.0 * sy,
                scale: case.size * until,
            })
        })
    },
    reduction_small_slip,
    reduction_rolling = Trial::motion(
        Printed,
        [
            r"the time that a particle with $b\mu$ rests",
            "the time that the sphere rolls",
        ],
    )
    .each(MIXED.each(), Followed::at_end, |run| {
        let rests = |particle: crate::motion::Motion| {
            let phases = particle.phases().iter();
            let rests = phases.filter(|phase| phase.kind == PhaseKind::Stick);
            rests.map(|phase| phase.to - phase.from).sum()
        };
        Ok([
            particle(run).map_or(f64::NAN, rests),
            rolling_time(&run.motion, 0.0, run.until)?,
            run.until,
        ])
    }),
    reduction_rest,
    spin_constant
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn another_spin_is_another_start() {
        for run in MIXED.each() {
            let start = run.unwrap().case.start;
            let [x, y, z] = start.omega;
            assert!(z.abs() > 1e-3, "{z}");
            let other = with_three_times_the_spin(start);
            assert_eq!(other.omega, [x, y, z + z + z]);
        }
    }
}
