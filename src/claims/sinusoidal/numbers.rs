//! The two numbers of each case by hand, and the numbers by which claims can be found. The words are in the claims' entries.

use super::prelude::*;
use crate::validated::numbers;
use std::f64::consts::{FRAC_1_PI, FRAC_1_SQRT_2};

/// In the paper's order: what the printed formula says, and what the motion does.
pub(super) static CASES: [Numbers; 2] = [
    Numbers::new("s22-vy-two-stages", || Ok(1.0), growth_of_logarithm),
    Numbers::new(
        "s22-rest-of-period",
        || Ok(printed::s22_rest_of_period_end(FRAC_PI_2)),
        || Ok(root(|phi| libm::sin(phi) - 0.5, 1.5 * PI, 2.5 * PI)?),
    ),
];

pub(super) static VALUES: [Number; 14] = [
    Number::new("lambda-c", || Ok(printed::eq37_lambda_c())).within(numbers::LAMBDA_C),
    Number::new("fig-3-start", || Ok(printed::eq39_phi_t1(FRAC_1_PI))),
    Number::new("fig-3-largest", || largest(FRAC_1_PI)),
    Number::new("fig-4-largest", || largest(FRAC_1_SQRT_2)),
    Number::new("phi-1", || Ok(printed::eq27_phi1(FRAC_1_SQRT_2))),
    Number::new("phi-2", || Ok(printed::eq28_phi2(FRAC_1_SQRT_2))),
    Number::new("phi-3", || Ok(printed::eq29_phi3(FRAC_1_SQRT_2))),
    Number::new("phi-4", || Ok(printed::eq30_phi4(FRAC_1_SQRT_2))),
    Number::new("fig-3-friction", || Ok(FRAC_1_PI)),
    Number::new("fig-4-friction", || Ok(FRAC_1_SQRT_2)),
    Number::enclosed("critical-phase", numbers::CRITICAL_PHASE),
    Number::enclosed("fig-4-slip-end", numbers::SLIP_END_FIG_4),
    Number::enclosed("slip-end-0.6", numbers::SLIP_END_3_5),
    Number::enclosed("slip-end-0.9", numbers::SLIP_END_9_10),
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

fn largest(lambda: f64) -> Result<f64, Failure> {
    Ok(settled(lambda, ORIGIN)?.largest().w.abs())
}
