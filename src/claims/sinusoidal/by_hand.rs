//! The two numbers of each case by hand. The words are in the claims' entries.

use super::prelude::*;
use std::f64::consts::FRAC_1_PI;

/// In the paper's order: what the printed formula says, and what the motion does.
pub(super) static CASES: [Numbers; 2] = [
    Numbers::new("s22-vy-two-stages", || Ok(1.0), growth_of_logarithm),
    Numbers::new(
        "s22-rest-of-period",
        || Ok(printed::s22_rest_of_period_end(FRAC_PI_2)),
        || Ok(root(|phi| libm::sin(phi) - 0.5, 1.5 * PI, 2.5 * PI)?),
    ),
];

/// The factor by which ln v_y grows in a period at friction 1/π.
fn growth_of_logarithm() -> Result<f64, Failure> {
    let motion = settled(FRAC_1_PI, ORIGIN)?;
    let mut slips = motion.intervals().iter();
    let slip = slips.rfind(|i| i.sign == Sign::Positive);
    let slip = slip.ok_or("no slip")?;
    let phi = 0.5 * (slip.start + slip.end);
    let start = PlanarState {
        phi,
        w_x: motion.w(phi),
        ln_w_y: -1e9,
    };
    let states = drive()?.planar(FRAC_1_PI, start, &[phi + TAU])?;
    let end = states.first().ok_or("no state")?;
    Ok(end.ln_w_y / start.ln_w_y)
}
