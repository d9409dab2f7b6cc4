//! Trials of the sense in which a particle slides in the end: along the plane's acceleration, or against it.

use super::prelude::*;

/// Launches of any direction on a plane with λ < 1, by λ, the directions of the acceleration and of the velocity, until
/// friction has little left to turn: as printed and as corrected, by the sign of 𝐯·𝐀.
fn senses(
    subject: Subject,
    route: Route,
    found: &'static str,
    velocity: impl Fn(f64, [f64; 2], [f64; 2]) -> Result<[f64; 2], Failure>,
    says: &'static str,
    stated: f64,
) -> Evidence {
    let compared = Compared::constant(says, found);
    let launches = Points::here().within(30, [[0.0, 0.8], [-3.0, 3.0], [-3.0, 3.0]]);
    Trial::by(route, subject, compared, NONE).at(
        ["λ", "angle of A", "angle of v₀"],
        launches,
        1.0,
        |[lambda, pull, start]| {
            let unit = |angle: f64| [libm::cos(angle), libm::sin(angle)];
            let [ax, ay] = unit(pull);
            let [vx, vy] = velocity(lambda, [ax, ay], unit(start))?;
            Ok([stated, (vx * ax + vy * ay).signum()])
        },
    )
}

/// When the sense is looked at, in units of v₀/A: a particle with λ ≤ 0.8 has long turned by then.
const LATE: f64 = 50.0;

fn by_motion(lambda: f64, pull: [f64; 2], v: [f64; 2]) -> Result<[f64; 2], Failure> {
    let plane = Plane::along(pull, Signal::constant(1.0));
    let start = State::moving(v);
    Ok(run(&plane, lambda, start, LATE)?.end().v)
}

/// V, and U = 𝐀t; friction alone acts there.
fn in_the_laboratory(lambda: f64, pull: [f64; 2], v: [f64; 2]) -> Result<[f64; 2], Failure> {
    let relative = |t: f64, y: &[f64; 2]| [y[0] - pull[0] * t, y[1] - pull[1] * t];
    let rate = |t: f64, y: &[f64; 2]| {
        let [x, y] = relative(t, y);
        let slip = libm::hypot(x, y);
        [-lambda * x / slip, -lambda * y / slip]
    };
    let end = dop853::end(rate, 0.0, v, LATE, 1e-10, 1e-12)?;
    Ok(relative(LATE, &end))
}

/// The cosine of the angle between 𝐯 and 𝐀 = −A x̂ of a particle with λ = ½ that begins along x̂.
pub(crate) fn sense_of_sliding() -> Result<f64, Failure> {
    let [x, y] = by_motion(0.5, [-1.0, 0.0], [1.0, 0.0])?;
    Ok(-x / libm::hypot(x, y))
}

const ON_THE_PLANE: &str = r"the sign of $\bm v\cdot\bm A$ in the motion at $t=50\,v_0/A$";
const AGAINST: &str = r"the expected $-1$, for against $\bm A$";

attempts![
    along | against = senses(Census, ON_THE_PLANE, by_motion)(
        (
            r"the expected 1, for along $\bm A$",
            printed::s21_late_sense()
        ) | (AGAINST, corrected::late_sense())
    ),
    against_in_the_laboratory = senses(
        Corrected,
        Integration,
        r"the sign of $(\bm V-\bm U)\cdot\bm A$ in the laboratory, where friction alone acts,",
        in_the_laboratory,
        AGAINST,
        corrected::late_sense()
    )
];
