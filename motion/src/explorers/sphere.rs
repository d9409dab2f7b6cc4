//! Section 3.2: a sphere on a plane that swings. Velocities in units of A₀/ϖ, lengths in A₀/ϖ², φ = ϖt.

use super::{Answer, ExplorerError, PICTURES, spread};
use crate::sphere::{Ball, BallMotion, Contact, Sphere};
use crate::{MotionError, Plane, Signal};
use std::f64::consts::TAU;

const PERIODS: f64 = 4.0;

/// The motion of a sphere with I = κmR² on a plane with A = −A₀ sin(ϖt) x̂, where friction is λ₀ = bμg/A₀ with
/// b = 1 + 1/κ; at φ = 0 the centre has the velocity `slip` and the sphere does not turn, so that `slip` is also
/// the velocity of the lowest point.
///
/// Values: b, the phase at which it first rolls (−1 if it does not), the share of the last of four periods in which it
/// rolls, the size of the slip at the end, the number of stretches of rolling, and the first and the last phase of
/// each. Curves: slip along x against φ, velocity of the centre along x against φ, the slip in the plane, the path of
/// the centre on the plane.
///
/// # Errors
/// λ₀ or κ not positive, κ above 1, a slip that is not finite.
pub fn motion(lambda0: f64, kappa: f64, slip: [f64; 2]) -> Result<Answer, ExplorerError> {
    let motion = followed(lambda0, kappa, slip)?;
    let (b, until) = (1.0 + 1.0 / kappa, PERIODS * TAU);
    let mut rolls: Vec<[f64; 2]> = Vec::new();
    let mut from = (motion.contact(0.0)? == Contact::Rolling).then_some(0.0);
    for transition in motion.transitions() {
        match (transition.to, from) {
            (Contact::Rolling, None) => from = Some(transition.t),
            (Contact::Sliding, Some(begin)) => {
                rolls.push([begin, transition.t]);
                from = None;
            }
            _ => {}
        }
    }
    rolls.extend(from.map(|begin| [begin, until]));

    let last = until - TAU;
    let rolling: f64 = rolls.iter().map(|[a, b]| (b - a.max(last)).max(0.0)).sum();
    let [end_x, end_y] = motion.slip(until)?;
    let mut values = vec![
        b,
        rolls.first().map_or(-1.0, |[begin, _]| *begin),
        rolling / TAU,
        libm::hypot(end_x, end_y),
        rolls.len() as f64,
    ];
    values.extend(rolls.iter().flatten());

    let mut phases: Vec<f64> = spread(0.0, until, 400).collect();
    phases.extend(motion.transitions().iter().map(|transition| transition.t));
    phases.sort_by(f64::total_cmp);
    let mut curves = vec![Vec::new(); 4];
    for phi in phases {
        let (slip, ball) = (motion.slip(phi)?, motion.at(phi)?);
        let points = [[phi, slip[0]], [phi, ball.v[0]], slip, ball.x];
        curves.iter_mut().zip(points).for_each(|(c, p)| c.push(p));
    }
    Ok(Answer { values, curves })
}

/// The same motion at equal times, for a moving picture from the side.
///
/// Values: the phase between the pictures. Curves: the displacements, in A₀/ϖ², of the floor in the laboratory and of the centre
/// on the floor; the angle by which the ball has turned, forwards along the swing, times its radius, in A₀/ϖ², and the slip along
/// the swing.
///
/// # Errors
/// As for [`motion`].
pub fn film(lambda0: f64, kappa: f64, slip: [f64; 2]) -> Result<Answer, ExplorerError> {
    let motion = followed(lambda0, kappa, slip)?;
    let step = PERIODS * TAU / f64::from(PICTURES);
    let (mut turned, mut before) = (0.0, 0.0);
    let mut curves = [Vec::new(), Vec::new()];
    for phi in spread(0.0, PERIODS * TAU, PICTURES) {
        let (ball, slip) = (motion.at(phi)?, motion.slip(phi)?);
        // Where it rolls, it turns as fast as its centre advances.
        let spin = ball.v[0] - slip[0];
        turned += 0.5 * step * (spin + before);
        before = spin;
        curves[0].push([libm::sin(phi), ball.x[0]]);
        curves[1].push([turned, slip[0]]);
    }
    Ok(Answer {
        values: vec![step],
        curves: curves.into(),
    })
}

fn followed(lambda0: f64, kappa: f64, slip: [f64; 2]) -> Result<BallMotion, ExplorerError> {
    let fit = (1e-6..=1e6).contains(&lambda0);
    if !fit {
        return Err(ExplorerError::Motion(MotionError::Argument {
            name: "lambda_0",
            value: lambda0,
            range: "between 1e-6 and 1e6",
        }));
    }
    let sine = Signal::Sine {
        frequency: 1.0,
        phase: 0.0,
    };
    // A₀ = ϖ = m = R = g = 1; μ follows from λ₀.
    let sphere = Sphere {
        mu: lambda0 / (1.0 + 1.0 / kappa),
        ..Sphere::with_kappa(kappa)
    };
    let start = Ball {
        t: 0.0,
        x: [0.0; 2],
        v: slip,
        omega: [0.0; 3],
    };
    let plane = Plane::along([1.0, 0.0], sine.times(-1.0));
    Ok(sphere.run(&plane, &start, PERIODS * TAU)?)
}
