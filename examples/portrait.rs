//! A portrait as CSV: particles launched in all directions on a plane of constant acceleration, until they stop.

use slipbook::motion::{Plane, State, run};
use std::f64::consts::TAU;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let plane = Plane::constant([1.0, 0.0]);
    println!("launch,t,vx,vy");
    for launch in 0..12 {
        let (sine, cosine) = (TAU * f64::from(launch) / 12.0).sin_cos();
        let start = State {
            t: 0.0,
            v: [cosine, sine],
            x: [0.0, 0.0],
        };
        // μg is one and a half times A: all of them stop.
        let motion = run(&plane, 1.5, start, 5.0)?;
        let stop = motion.first_stop().ok_or("it does not stop")?;
        for k in 0..=40 {
            let state = motion.at(stop * f64::from(k) / 40.0)?;
            println!("{launch},{},{},{}", state.t, state.v[0], state.v[1]);
        }
    }
    Ok(())
}
