//! The numbers by which claims can be found.

use super::by_hand::boundary_example;
use super::prelude::*;
use crate::motion::turntable;

pub(super) static VALUES: [Number; 8] = [
    Number::new("critical-radius", || Ok(turntable::critical_radius()?)),
    Number::new("critical-speed", || Ok(turntable::critical_speed()?)),
    Number::new("envelope", || Ok(printed::eq147_a(0.1))),
    Number::new("boundary-least", || Ok(corrected::boundary_least(0.1))),
    Number::new("boundary", boundary_example),
    Number::new("boundary-series", || Ok(corrected::boundary_a(0.1, 0.2))),
    Number::new("boundary-slope", || Ok(corrected::boundary_slope(PI / 2.0))),
    Number::new("boundary-curvature", || {
        Ok(corrected::boundary_curvature(0.0))
    }),
];
