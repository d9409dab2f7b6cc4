//! Trials of (3) to (5): the definitions are consistent with the use made of them.

use super::prelude::*;

/// The component along x, less whatever there is across.
fn along_alone(v: [f64; 2]) -> f64 {
    v[0] - v[1].abs()
}

attempts![
    eq3 = {
        let trial = Trial::consistency(
            Printed,
            [
                "(3) times $-t$",
                "the velocity of a particle from rest without friction, on a plane that is pulled towards $-x$",
            ],
        );
        trial.drawn(0..1000, |_, points| {
            let (a, t) = (points.log_uniform(0.1, 10.0), points.uniform(0.1, 5.0));
            let rest = State::moving([0.0; 2]);
            let v = run(&Plane::constant([-a, 0.0]), 0.0, rest, t)?.end().v;
            Ok(Pair {
                at: format!("A = {a:.6}, t = {t:.6}"),
                stated: along_alone(printed::eq3_acceleration(a).map(|rate| -rate * t)),
                found: along_alone(v),
                scale: a * t,
            })
        })
    },
    eq4 = Trial::consistency(
        Printed,
        [
            "the size of (4) times the exponential of its angle",
            r"$v\,\mathrm e^\theta$ along motions",
        ],
    )
    .each(TURNS.each(), Turn::at, |turn| {
        let [vx, vy] = printed::eq4_velocity(turn.v, turn.theta);
        let found = turn.v * libm::exp(turn.theta);
        Ok([
            libm::hypot(vx, vy) * libm::exp(libm::atan2(vy, vx)),
            found,
            found,
        ])
    }),
    eq5 = {
        let trial = Trial::consistency(
            Printed,
            [
                "$v_x/v_0$ of a motion",
                r"that of another with the same $\lambda$ of (5) and different $\mu$, $g$, $A$, $v_0$, at the same $At/v_0$",
            ],
        );
        trial.drawn(0..1000, |_, points| {
            let (theta0, mu, g) = (
                points.uniform(0.1, 3.0),
                points.uniform(0.1, 2.0),
                points.uniform(1.0, 20.0),
            );
            let (a, t) = (points.log_uniform(0.1, 10.0), points.uniform(0.1, 0.9));
            let lambda = printed::eq5_lambda(mu, g, a);
            let vx = |friction: f64, a: f64, v0: f64| -> Result<_, Failure> {
                let start = State::moving([v0 * libm::cos(theta0), v0 * libm::sin(theta0)]);
                let end = run(&Plane::constant([-a, 0.0]), friction, start, t * v0 / a)?.end();
                Ok(end.v[0] / v0)
            };
            Ok(Pair::plain(
                format!("μ = {mu:.6}, g = {g:.6}, A = {a:.6}, θ₀ = {theta0:.6}, A t/v₀ = {t:.6}"),
                vx(lambda, 1.0, 1.0).unwrap_or(f64::NAN),
                vx(mu * g, a, 3.0)?,
            ))
        })
    }
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_across_spoils_what_is_along() {
        assert_eq!(
            [[3.0, 0.0], [3.0, 1.0], [3.0, -1.0]].map(along_alone),
            [3.0, 2.0, 2.0]
        );
    }
}
