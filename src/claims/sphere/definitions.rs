//! Trials of (59) to (62), (67) and (76): the laws from the laboratory, the definitions by the use made of them.

use super::prelude::*;
use super::spheres::{MIXED, length};

/// At this velocity of the lowest point relative to the plane.
fn friction(run: &Followed, slip: [f64; 3]) -> [f64; 3] {
    let sphere = run.case.sphere;
    let size = length(slip);
    slip.map(|c| -sphere.mu * sphere.mass * sphere.g * c / size)
}

/// v and ω at the end of a motion by (59) and (60), with a foreign integrator; NaN if it finds none.
fn by_the_laws(run: &Followed) -> [f64; 5] {
    let sphere = run.case.sphere;
    let plane = |_: f64, y: &[f64; 6]| {
        let (v, omega) = ([y[0], y[1], 0.0], [y[2], y[3], y[4]]);
        let contact = run.case.contact();
        let force = friction(run, printed::slip(v, omega, contact));
        let a = run.case.acceleration(y[5]);
        let push = printed::eq59_momentum_rate(sphere.mass, a, force);
        let twist = printed::eq60_spin_rate(contact, force);
        let (m, i) = (sphere.mass, sphere.inertia);
        [
            push[0] / m,
            push[1] / m,
            twist[0] / i,
            twist[1] / i,
            twist[2] / i,
            1.0,
        ]
    };
    let Ball { v, omega, .. } = run.case.start;
    let start = [v[0], v[1], omega[0], omega[1], omega[2], 0.0];
    let end = dop853::end(plane, 0.0, start, run.until, 1e-13, 1e-14);
    end.map_or([f64::NAN; 5], |[a, b, c, d, e, _]| [a, b, c, d, e])
}

/// The laboratory knows no inertial force.
fn eq59() -> Evidence {
    let trial = Trial::by(
        Integration,
        Printed,
        [
            r"$\bm v$ by (59) and (60)",
            r"$\bm V-\bm U$ of the laboratory, where friction alone acts, each vector by the one number $x+2y$",
        ],
        FOREIGN,
    );
    trial.each(super::spheres::SLIDING.each(), Followed::at_end, |run| {
        let sphere = run.case.sphere;
        // V, U, the rates of turning about x and y, the time.
        let laboratory = |_: f64, y: &[f64; 7]| {
            let slip = [
                y[0] - y[2] - sphere.radius * y[5],
                y[1] - y[3] + sphere.radius * y[4],
                0.0,
            ];
            let [fx, fy, _] = friction(run, slip);
            let [ax, ay, _] = run.case.acceleration(y[6]);
            let lever = sphere.radius / sphere.inertia;
            let m = sphere.mass;
            [fx / m, fy / m, ax, ay, lever * fy, -lever * fx, 1.0]
        };
        let Ball { v, omega, .. } = run.case.start;
        let start = [v[0], v[1], 0.0, 0.0, omega[0], omega[1], 0.0];
        let seen = dop853::end(laboratory, 0.0, start, run.until, 1e-13, 1e-14)?;
        let stated = by_the_laws(run);
        Ok([
            stated[0] + 2.0 * stated[1],
            seen[0] - seen[2] + 2.0 * (seen[1] - seen[3]),
            libm::hypot(v[0], v[1]) + libm::hypot(seen[0], seen[1]),
        ])
    })
}

fn eq61() -> Evidence {
    let trial = Trial::consistency(
        Printed,
        [
            r"$-\bm\omega\times$ (61)",
            "the velocity of the centre of a rolling sphere, each vector by the one number $x+2y$",
        ],
    );
    let states = with_each(
        MIXED.each(),
        [1, 2, 3, 4, 5, 6, 7, 8].map(|k| f64::from(k) / 8.0),
    );
    let rolling = only(states, |(run, share)| {
        run.motion.contact(share * run.until) == Ok(Contact::Rolling)
    });
    trial.over(rolling, |state| {
        let (run, share) = state?;
        let t = share * run.until;
        let ball = run.motion.at(t)?;
        let turning = printed::slip([0.0; 3], ball.omega, run.case.contact());
        Ok(Pair {
            at: run.at(t),
            stated: -weighed(turning),
            found: weighed([ball.v[0], ball.v[1], 0.0]),
            scale: libm::hypot(ball.v[0], ball.v[1])
                + length(run.case.start.omega) * run.case.sphere.radius,
        })
    })
}

fn eq67() -> Evidence {
    Trial::consistency(
        Printed,
        [
            r"$w/(b\mu g)$, with $b$ by (67),",
            "the time at which a sphere on a plane at rest begins to roll",
        ],
    )
    .drawn(0..60, |i, points| {
        let sphere = sphere(i, points);
        let (w, angle) = (points.log_uniform(0.1, 10.0), points.uniform(-3.1, 3.1));
        let start = Ball {
            t: 0.0,
            x: [0.0; 2],
            v: [w * libm::cos(angle), w * libm::sin(angle)],
            omega: [0.0; 3],
        };
        let kappa = printed::eq62_kappa(sphere.inertia, sphere.mass, sphere.radius);
        let late = 3.0 * w / braking(&sphere);
        let motion = sphere.run(&Plane::constant([0.0; 2]), &start, late)?;
        let first = motion.transitions().first().ok_or("it does not roll")?;
        Ok(Pair {
            at: format!(
                "κ = {:.6}, μ = {:.6}, g = {:.6}, w = {w:.6}",
                sphere.kappa(),
                sphere.mu,
                sphere.g
            ),
            stated: w / (printed::eq67_factor(kappa) * sphere.mu * sphere.g),
            found: first.t,
            scale: first.t,
        })
    })
}

attempts![
    eq59,
    eq60 = Trial::by(
        Integration,
        Printed,
        [
            r"$\bm\omega$ by (59) and (60), by another library's integrator,",
            r"$\bm\omega$ of the motion, each vector by the one number $x+2y+3z$",
        ],
        FOREIGN,
    )
    .each(super::spheres::SLIDING.each(), Followed::at_end, |run| {
        let [_, _, x, y, z] = by_the_laws(run);
        let found = run.motion.end().omega;
        Ok([
            weighed([x, y, z]),
            weighed(found),
            length(found) + length(run.case.start.omega),
        ])
    }),
    eq61,
    eq67,
    eq76 = {
        let trial = Trial::consistency(
            Printed,
            [
                r"the integral of (76) over $\tau$",
                r"$-\bm v/\sqrt{\mu gR}$ of a particle from rest without friction, each vector by the one number $x+2y$",
            ],
        );
        trial.each(MIXED.each(), Followed::at_end, |run| {
            let (_, mu, g) = run.case.parameters();
            let rate = |t: f64| {
                let gamma = printed::eq72_acceleration(mu, g, run.case.acceleration(t));
                run.tau_rate() * weighed(printed::eq76_nu_rate(gamma))
            };
            let size = run.until / run.units().time * run.case.size / run.units().push;
            Ok([
                sum(rate, 0.0, run.until, 1e-13 * size),
                weighed(super::rates::nu(run, run.until)?),
                size,
            ])
        })
    }
];
