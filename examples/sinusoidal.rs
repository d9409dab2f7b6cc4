//! A particle on a shaken plane: when it slides and when it sticks, once it has forgotten its start. Any drive will do.
//!
//! `cargo run --no-default-features --example sinusoidal`

use slipbook::motion::drive::{Drive, DriveError, Friction, Sign, State};

fn main() -> Result<(), DriveError> {
    // Not a sine, but a sine with a third harmonic.
    let drive = Drive::new(|phi| (phi.sin() + 0.4 * (3.0 * phi).sin()) / 1.05, &[])?;
    let start = State { phi: 0.0, w: 1.0 };
    for lambda in [0.2, 0.5, 0.8] {
        let outcome = drive.attractor(Friction::new(lambda, lambda)?, start, 100)?;
        let Some(motion) = outcome.settled() else {
            println!("λ₀ = {lambda}: it drifts away");
            continue;
        };
        println!(
            "λ₀ = {lambda}: largest velocity {:.6}",
            motion.largest().w.abs()
        );
        for interval in motion.intervals() {
            let what = match interval.sign {
                Sign::Positive => "forward",
                Sign::Negative => "backward",
                Sign::Rest => "at rest",
            };
            println!(
                "    {what:<9} from {:9.6} to {:9.6}",
                interval.start, interval.end
            );
        }
    }
    Ok(())
}
