//! A solid ball that slips until it rolls.

use super::posed::{self, Ask, Posed};
use super::{Answer, ExamError, Other, Task, fraction};
use crate::sphere::{Ball, BallMotion, Contact, Sphere};
use crate::{MotionError, Plane};
use trialbook::certified::enclosure::Enclosure;

const BOWLED: &str = "A solid ball is put down on a horizontal plane with the velocity v₀ along x and without spin. Units: μg = v₀ = 1.";

/// The point of contact slows down at the rate 7/2.
pub(super) const SLIP_TIME: Task = Task {
    id: "slip-time",
    setup: BOWLED,
    posed: Posed {
        grid: Some(posed::BOWLED),
        ..Posed::of("ball mu=1 g=1 radius=1 throw=1 until=rolling", Ask::T)
    },
    question: "When does it begin to roll?",
    unit: "v₀/(μg)",
    motion: || Ok(Answer::Number(rolls_from(&thrown(0.0, 1.0, [1.0, 0.0])?)?)),
    other: fraction!(2 / 7),
};

/// T − T²/2 with T = 2/7, then 1 − T at the speed 5/7.
pub(super) const PLACE: Task = Task {
    id: "ball-place",
    setup: BOWLED,
    posed: Posed::of("ball mu=1 g=1 radius=1 throw=1 until=time=1", Ask::X),
    question: "How far has its centre come at t = 1? (In the end it rolls with 5/7 of v₀.)",
    unit: "v₀²/(μg)",
    motion: || Ok(Answer::Number(thrown(0.0, 1.0, [1.0, 0.0])?.end().x[0])),
    other: fraction!(37 / 49),
};

/// For the point of contact friction counts 7/2 times, Λ = 7/4, and Λ|c| + c_x falls at the rate Λ² − 1.
pub(super) const DRIVEN_SLIP: Task = Task {
    id: "driven-slip",
    setup: "A solid ball is put down on a horizontal plane that accelerates; in its frame the ball feels a steady pull A along x. \
            Friction is μg/A = 1/2; the ball starts with the velocity v₀ along y and without spin. Units: A = v₀ = 1.",
    posed: Posed::of(
        "ball mu=0.5 g=1 radius=1 pull=1 throw=1@1.5707963267948966 until=rolling",
        Ask::T,
    ),
    question: "When does it begin to roll?",
    unit: "v₀/A",
    motion: || Ok(Answer::Number(rolls_from(&thrown(1.0, 0.5, [0.0, 1.0])?)?)),
    other: fraction!(28 / 33),
};

fn thrown(pull: f64, friction: f64, v: [f64; 2]) -> Result<BallMotion, MotionError> {
    let sphere = Sphere {
        mu: friction,
        ..Sphere::with_kappa(0.4)
    };
    let start = Ball {
        t: 0.0,
        x: [0.0; 2],
        v,
        omega: [0.0; 3],
    };
    sphere.run(&Plane::constant([-pull, 0.0]), &start, 1.0)
}

fn rolls_from(motion: &BallMotion) -> Result<f64, ExamError> {
    let rolling = motion
        .transitions()
        .iter()
        .find(|transition| transition.to == Contact::Rolling);
    Ok(rolling.ok_or(ExamError::Missing("rolling"))?.t)
}
