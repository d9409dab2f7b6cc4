//! How far does a crate slide on a truck that brakes? A particle on a plane of constant acceleration, by Newton's law
//! and by the paper's stopping time.
//!
//! `cargo run --no-default-features --example constant`

use slipbook::motion::{Launch, MotionError};
use slipbook::paper::constant::eq20_stop_time;

fn main() -> Result<(), MotionError> {
    let (mu, g) = (0.5, 9.81);
    let (braking, speed) = (3.0, 2.0);
    let lambda = mu * g / braking;
    println!(
        "λ = {lambda:.3}; launched with {speed} m/s at θ₀ to the direction of the inertial force"
    );
    println!("θ₀ (°)   stops after (s)   by (20) (s)   slides along, across (m)");
    for degrees in [0.0, 45.0, 90.0, 135.0, 180.0_f64] {
        let theta0 = degrees.to_radians();
        let end = Launch::new(lambda, braking, speed, theta0)?
            .motion_to_rest()?
            .end();
        let by_formula = eq20_stop_time(lambda, braking, speed, theta0);
        let [along, across] = end.x;
        println!(
            "{degrees:6}   {:15.6}   {by_formula:11.6}   {along:9.4} {across:9.4}",
            end.t
        );
    }
    Ok(())
}
