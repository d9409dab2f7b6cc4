//! The two numbers of each case by hand, and the numbers by which claims can be found. The words are in the claims' entries.

use super::prelude::*;
use super::simulated;
use crate::validated::numbers;

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

pub(super) static VALUES: [Number; 13] = [
    Number::new("y-q-printed", || Ok(printed::eq58_y::<f64>()[0])),
    Number::new("y-lambda-printed", || Ok(printed::eq58_y::<f64>()[1])),
    Number::new("y-q", touching).within(numbers::Q_Y),
    Number::new("y-lambda", || Ok(1.0 / touching()?)).within(numbers::LAMBDA_Y),
    Number::new("contact", || Ok(corrected::contact(touching()?))).within(numbers::CONTACT),
    Number::new("y-root", || touching().map(|q| libm::sqrt(q * q - 1.0))).within(numbers::X_Y),
    Number::enclosed("curve-a-2", numbers::A_2),
    Number::enclosed("curve-a-6", numbers::A_6),
    Number::enclosed("curve-a-12", numbers::A_12),
    Number::enclosed("curve-b-2", numbers::B_2),
    Number::enclosed("curve-b-3", numbers::B_3),
    Number::enclosed("curve-e-6", numbers::E_6),
    Number::enclosed("curve-e-12", numbers::E_12),
];

fn printed_region(q: f64, lambda0: f64) -> Result<usize, Failure> {
    let region = printed::region(lambda0, &Curves::at(q)?.printed);
    Ok(region.ok_or("the point lies on a curve")?)
}

fn backward(signs: &[f64]) -> f64 {
    signs.iter().filter(|sign| **sign < 0.0).count() as f64
}
