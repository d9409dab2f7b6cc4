//! A billiard ball, struck without spin on a table at rest, slips and then rolls: with 5/7 of its speed.
//!
//! `cargo run --no-default-features --example sphere`

use slipbook::motion::sphere::{Ball, Sphere};
use slipbook::motion::{MotionError, Plane};

fn main() -> Result<(), MotionError> {
    let (mass, radius) = (0.17, 0.02625);
    let ball = Sphere {
        mass,
        radius,
        inertia: 0.4 * mass * radius * radius,
        mu: 0.2,
        g: 9.81,
    };
    let start = Ball {
        t: 0.0,
        x: [0.0; 2],
        v: [2.0, 0.0],
        omega: [0.0; 3],
    };
    let motion = ball.run(&Plane::constant([0.0, 0.0]), &start, 1.0)?;
    for t in [0.0, 0.1, 0.2, 0.3, 0.4] {
        let at = motion.at(t)?;
        let (v, spin) = (at.v[0], at.omega[1] * radius);
        println!(
            "t = {t:.1} s: v = {v:.6} m/s, ωR = {spin:.6} m/s, {:?}",
            motion.contact(t)?
        );
    }
    for transition in motion.transitions() {
        println!("{:?} from t = {:.6} s on", transition.to, transition.t);
    }
    println!(
        "v/v₀ at the end: {:.12}, 5/7 = {:.12}",
        motion.end().v[0] / 2.0,
        5.0 / 7.0
    );
    Ok(())
}
