//! A coin on a turntable: from where does it stay on, and with which launches from the axis?
//!
//! `cargo run --no-default-features --example turntable`

use slipbook::motion::MotionError;
use slipbook::motion::turntable::{Fate, Start, critical_radius, critical_speed, fate};

fn main() -> Result<(), MotionError> {
    // Lengths in units of μg/Ω², speeds in units of μg/Ω.
    for speed in [0.2, 0.5, 0.8, 1.1, 1.4] {
        match fate(&Start::launched(speed)?)? {
            Fate::Rest { sigma, tau, .. } => {
                println!("launched with {speed}: rests at ρ = {sigma:.10} after τ = {tau:.8}");
            }
            Fate::Escape { because, .. } => {
                println!("launched with {speed}: goes away ({because:?})")
            }
            Fate::Undecided { .. } => println!("launched with {speed}: too close to tell"),
        }
    }
    println!(
        "the fastest launch that comes to rest: {:.11}",
        critical_speed()?
    );
    println!(
        "the farthest place to put it down:     {:.11}",
        critical_radius()?
    );
    Ok(())
}
