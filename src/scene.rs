//! Scenes ([`motion::scene`](crate::motion::scene)), and the paper's formulas as a second opinion on them.

pub use crate::motion::scene::*;

use crate::solve::{
    constant::{At, ConstantProblem},
    sphere::SphereProblem,
};

/// What a formula of the paper, corrected where the printed one fails, says of the end of a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Opinion {
    /// Whose formulas these are: the section of the paper.
    pub section: &'static str,
    /// Numbers of the answer, by their names, as the formulas have them.
    pub numbers: Vec<(&'static str, f64)>,
}

/// The paper's word on the end of a scene, if that lies in its reach: a block that is launched where the pull is one and the
/// same (section 2.1), a ball without spin there (section 3), each to its stop or to a time.
pub fn second(scene: &Scene, until: Until) -> Option<Opinion> {
    let [pull, velocity] = [scene.steady_pull()?, scene.start.velocity.map(|v| v.0)];
    let [a, v0] = [pull, velocity].map(|[x, y]| libm::hypot(x, y));
    let plain = scene.turning.is_none() && scene.back.is_none() && a > 0.0 && v0 > 0.0;
    if !plain {
        return None;
    }
    let along = pull.map(|x| x / a);
    let turned = |[x, y]: [f64; 2]| [along[0] * x - along[1] * y, along[1] * x + along[0] * y];
    let theta0 = libm::atan2(
        // Straight against the pull it is π, not −π.
        along[0] * velocity[1] - along[1] * velocity[0] + 0.0,
        along[0] * velocity[0] + along[1] * velocity[1],
    );
    let friction = scene.friction();
    let at = match until {
        Until::Stop => At::Stop,
        // Static friction has no say before the stop.
        Until::Time(t) => At::Time(t.0),
        _ => return None,
    };
    match scene.body {
        Body::Block => {
            let problem = ConstantProblem {
                lambda: friction / a,
                v0,
                theta0,
                accel: a,
                at,
            };
            let found = problem.solve().ok()?.by_formula?;
            let past = found.stop_time.is_some_and(|stop| found.t > stop);
            let (held, place) = (scene.holding * friction / scene.mu < a, scene.start.place);
            if past && held {
                return None;
            }
            let ([x, y], [vx, vy]) = (turned([found.x, found.y]), turned([found.vx, found.vy]));
            let numbers = vec![
                ("t", found.t),
                ("x", place[0].0 + x),
                ("y", place[1].0 + y),
                ("v_x", vx),
                ("v_y", vy),
            ];
            Some(Opinion {
                section: "2.1",
                numbers,
            })
        }
        Body::Ball {
            radius: Metre(radius),
            kappa,
        } => {
            let none = scene.start.spin.iter().all(|w| w.0 == 0.0);
            let (speed, time) = (libm::sqrt(friction * radius), libm::sqrt(radius / friction));
            let at = match at {
                At::Time(t) => At::Time(t / time),
                other => other,
            };
            let problem = SphereProblem {
                gamma: a / friction,
                u0: v0 / speed,
                theta0,
                kappa,
                at,
            };
            let found = none.then(|| problem.solve().ok()?.by_formula)??;
            let [x, y] = turned(found.zeta).map(|w| w / time);
            Some(Opinion {
                section: "3",
                numbers: vec![("t", found.tau * time), ("ω_x", x), ("ω_y", y)],
            })
        }
    }
}
