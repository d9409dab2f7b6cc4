//! The numbers by which claims can be found.

use super::prelude::*;
use crate::validated::numbers;

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
