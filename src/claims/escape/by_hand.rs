//! The two numbers of each case by hand. The words are in the claims' entries.

use super::growth::{self, DISTANCE, LAG, Named, SIZE, SPEED, WAY};
use super::prelude::*;
use std::f64::consts::SQRT_2;

/// In the paper's order: what the printed formula says, and what the motion does.
pub(super) static CASES: [Numbers; 10] = [
    Numbers::new("eq-128", || of(growth::EQ128), || of(growth::ALPHA_RATE)),
    Numbers::new("eq-129", || Ok(1.0), || of(growth::PRODUCT)),
    Numbers::new(
        "eq-130",
        || Ok(printed::eq130_alpha(1.0)),
        || of(growth::ALPHA_BY_A),
    ),
    Numbers::new(
        "eq-131",
        || Ok(printed::eq131_a_rate(1.0)),
        || of(growth::A_RATE),
    ),
    Numbers::new("eq-132", || Ok(printed::eq132_a(1.0)), || of(SIZE.over)),
    Numbers::new(
        "eq-133",
        || Ok(printed::eq133_alpha(1.0)),
        || of(growth::EXCESS),
    ),
    Numbers::new(
        "eq-134",
        || Ok(printed::eq134_lag(1200.0)),
        || Ok(of(LAG.over)? / 1200.0),
    ),
    Numbers::new(
        "eq-135",
        || Ok(3.0 * SQRT_2 * printed::eq135_p(1.0)),
        || Ok(3.0 * SQRT_2 * of(SPEED.over)?),
    ),
    Numbers::new(
        "eq-136",
        || Ok(printed::eq136_rho(1.0)),
        || of(DISTANCE.over),
    ),
    Numbers::new("eq-137", || Ok(printed::eq137_s(1.0)), || of(WAY.over)),
];

/// The limit of a quantity of an escape, which does not depend on the start.
fn of((_, quantity): Named) -> Result<f64, Failure> {
    let escape = ESCAPES.each().next().ok_or("no escape")??;
    Ok(growth::limit(escape, quantity)?.value)
}
