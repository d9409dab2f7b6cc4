//! Trials of whether friction keeps a particle at rest that begins so.

use super::prelude::*;

/// The velocity at a time of a particle that begins at rest, against the direction of 𝐀, which has this size.
fn speed(lambda: f64, a: f64, t: f64) -> Result<f64, Failure> {
    let start = State::moving([0.0; 2]);
    Ok(run(&Plane::constant([-a, 0.0]), lambda * a, start, t)?
        .end()
        .v[0])
}

fn moves(subject: Subject, frictions: Vec<[f64; 2]>) -> Evidence {
    let compared = Compared::one(
        r"whether $\lambda\le1$ (1 if so)",
        "whether a particle that begins at rest moves",
    );
    Trial::census(subject, compared).over(frictions, |[lambda, a]| {
        let [left, right] = printed::s21_cannot_hold_sides(lambda);
        Ok(Pair::plain(
            format!("λ = {lambda:.9}, A = {a:.3}"),
            is(left <= right),
            is(speed(lambda, a, 1.0)? > 0.0),
        ))
    })
}

/// On both sides of λ = 1.
fn around_one() -> Vec<[f64; 2]> {
    let mut points = Points::here();
    let mut frictions: Vec<_> = (0..60).map(|_| points.uniform(0.0, 3.0)).collect();
    for near in [1e-9, 1e-6, 1e-3] {
        frictions.extend([1.0 - near, 1.0 + near]);
    }
    frictions.into_iter().map(|lambda| [lambda, 1.0]).collect()
}

pub(super) fn velocity() -> Evidence {
    let launches = Points::here().within(40, [[0.0, 2.0], [0.1, 5.0]]);
    Trial::motion(
        Within,
        [
            r"$t$ times the rate (6) at $\theta=0$, or 0 where $\lambda\le1$ does not hold,",
            "the velocity at the time $t$ of a particle that begins at rest",
        ],
    )
    .at(["λ", "t"], launches, 5.0, |[lambda, t]| {
        let [left, right] = printed::s21_cannot_hold_sides(lambda);
        let stated = match left <= right {
            true => t * printed::eq6_vx_rate(lambda, 1.0, 0.0),
            false => 0.0,
        };
        Ok([stated, speed(lambda, 1.0, t)?])
    })
}

attempts![
    census = moves(Within, around_one()),
    velocity,
    outside = moves(Outside, Points::here().within(20, [[1.0; 2], [0.1, 10.0]])),
    critical = no_inside(
        "a friction",
        r"$\lambda=1$",
        [("λ", [0.0, 2.0])],
        &[[1.0]],
        |[lambda]| lambda != 1.0,
    )
];
