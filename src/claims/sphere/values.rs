//! The numbers by which claims can be found.

use super::prelude::*;

pub(super) static VALUES: [Number; 4] = [
    Number::new("kappa-solid", || Ok(2.0 / 5.0)),
    Number::new("b-solid", || Ok(printed::eq67_factor(0.4))),
    Number::new("b-hollow", || Ok(printed::eq67_factor(2.0 / 3.0))),
    Number::new("slip-end", || Ok(14.0 / 33.0)),
];
