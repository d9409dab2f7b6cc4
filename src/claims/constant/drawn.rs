//! The curves of fig-1 and of the chapter's other figures: what is tried here is what the book draws.

use super::prelude::*;

/// In units of v₀ and A.
#[derive(Debug, Clone)]
pub(crate) struct Curve {
    pub lambda: f64,
    pub theta0: f64,
    /// To rest for λ > 1, else for a while.
    pub motion: Motion,
}

/// Friction in panel (a) of fig-1.
pub(crate) const WEAK: [f64; 3] = [0.0, 0.5, 1.0];
/// Friction in panel (b) of fig-1.
pub(crate) const STRONG: [f64; 3] = [1.2, 2.0, 5.0];

/// How long a motion that does not stop is followed, in units of v₀/A.
const WHILE: f64 = 8.0;
/// The velocity in units of v₀ that the inertial force less friction gives in the time shown in fig-1, λ < 1.
const GAIN: f64 = 2.0;

pub(crate) fn curve(lambda: f64, theta0: f64) -> Result<Curve, MotionError> {
    curve_until(lambda, theta0, WHILE)
}

fn curve_until(lambda: f64, theta0: f64, until: f64) -> Result<Curve, MotionError> {
    let launch = Turn::launch(lambda, 1.0, 1.0, theta0);
    let motion = if lambda > 1.0 {
        launch.motion_to_rest()?
    } else {
        launch.motion(until)?
    };
    Ok(Curve {
        lambda,
        theta0,
        motion,
    })
}

/// Eight launch angles for each λ.
pub(crate) fn panel(lambdas: &[f64]) -> Result<Vec<Curve>, MotionError> {
    let angles = (0..8).map(|i| (f64::from(i) - 3.5) * PI / 4.0);
    let pairs = angles.flat_map(|theta0| lambdas.iter().map(move |&lambda| (lambda, theta0)));
    let mut curves: Vec<_> = pairs
        .map(|(lambda, theta0)| {
            let until = if lambda < 1.0 {
                GAIN / (1.0 - lambda)
            } else {
                WHILE
            };
            curve_until(lambda, theta0, until)
        })
        .collect::<Result<_, _>>()?;
    curves.sort_by(|a, b| a.lambda.total_cmp(&b.lambda));
    Ok(curves)
}

fn both_panels() -> impl Iterator<Item = Result<Curve, Failure>> {
    [WEAK, STRONG]
        .into_iter()
        .flat_map(|lambdas| parts(panel(&lambdas)))
}

pub(crate) fn points() -> Evidence {
    Trial::motion(
        Printed,
        ["(11) at the angle of each drawn point", "the speed there"],
    )
    .pairs(both_panels(), |curve| {
        let Curve {
            lambda,
            theta0,
            motion,
        } = curve?;
        let drawn = motion.nodes().filter(|state| state.speed() > 1e-6);
        let pair = |state: State| {
            let number = Double::from;
            let (v, theta) = (state.speed(), state.direction());
            let speed =
                printed::eq11_speed(number(lambda), number(1.0), number(theta0), number(theta));
            let at = format!("λ = {lambda}, θ₀ = {theta0:.6}, θ = {theta:.6}");
            let launch = Turn::launch(lambda, 1.0, 1.0, theta0);
            let condition = Turn { theta, ..launch }.condition();
            Pair::wide(at, speed, v).within(v * condition)
        };
        Ok(drawn.map(pair).collect())
    })
}

pub(crate) fn ends() -> Evidence {
    let trial = Trial::census(
        Printed,
        [
            "whether a curve ends in motion, as in panel (a), or at rest, as in panel (b) (1 for motion),",
            "what the motion does",
        ],
    );
    let at = |curve: &Curve| format!("λ = {}, θ₀ = {:.6}", curve.lambda, curve.theta0);
    trial.each(both_panels(), at, |curve| {
        let [left, right] = printed::s21_keeps_moving_sides(curve.lambda);
        let moves = curve.motion.end().speed() > 0.0;
        Ok([is(left <= right), is(moves), 1.0])
    })
}

attempts![points, ends];
