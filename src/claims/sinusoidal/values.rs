//! The numbers by which claims can be found.

use super::prelude::*;
use crate::validated::numbers;
use std::f64::consts::{FRAC_1_PI, FRAC_1_SQRT_2};

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

fn largest(lambda: f64) -> Result<f64, Failure> {
    Ok(settled(lambda, ORIGIN)?.largest().w.abs())
}
