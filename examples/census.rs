//! A census on the turntable: how many of ten thousand particles come to rest, and how far out at most.

use slipbook::motion::{
    turntable::Start,
    turntable::ensemble::{End, Horizon},
};
use std::f64::consts::PI;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // Distances in units of μg/Ω², times in units of 1/Ω.
    let horizon = Horizon {
        rho: 100.0,
        tau: 50.0,
    };
    let mut starts = Vec::new();
    for i in 0..100 {
        for j in 0..100 {
            let (p, psi) = (0.015 * f64::from(i), PI * (0.02 * f64::from(j) - 1.0));
            starts.push(Start::polar(0.5, p, psi)?);
        }
    }
    let ends = horizon.follow(&starts)?;
    let rests: Vec<f64> = ends
        .iter()
        .filter_map(|end| match end {
            Ok(End::Rest { sigma, .. }) => Some(*sigma),
            _ => None,
        })
        .collect();
    let farthest = rests.iter().copied().fold(0.0, f64::max);
    println!(
        "{} of {} come to rest, the farthest at {farthest:.6}",
        rests.len(),
        ends.len()
    );
    Ok(())
}
