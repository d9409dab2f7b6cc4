//! The two numbers of each case by hand. The words are in the claims' entries.

use super::prelude::*;
use super::simulated;

/// In the paper's order: what the printed formula says, and what the motion does.
pub(super) static CASES: [Numbers; 3] = [
    Numbers::new(
        "s24-region-2",
        || Ok(backward(&printed::signs()[printed_region(9.0, 0.1)? - 1])),
        || {
            let motion = simulated::attractor(9.0, 0.1)?;
            let signs = motion.intervals().iter().map(|i| i.sign.factor());
            Ok(backward(&signs.collect::<Vec<_>>()))
        },
    ),
    Numbers::new(
        "eq-55",
        || Ok(printed::eq55_lambda0(9.0)),
        || simulated::last_backward(9.0),
    ),
    Numbers::new(
        "fig-5",
        || Ok(printed_region(6.5, 0.15)? as f64),
        || Ok(simulated::fits(simulated::simulated(6.5, 0.15)?) as f64),
    ),
];

fn printed_region(q: f64, lambda0: f64) -> Result<usize, Failure> {
    let region = printed::region(lambda0, &Curves::at(q)?.printed);
    Ok(region.ok_or("the point lies on a curve")?)
}

fn backward(signs: &[f64]) -> f64 {
    signs.iter().filter(|sign| **sign < 0.0).count() as f64
}
