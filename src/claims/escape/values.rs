//! The numbers by which claims can be found.

use super::prelude::*;
use std::f64::consts::SQRT_2;
use trialbook::certified::ball::Ball;
use trialbook::certified::enclosure::Enclosure;
use trialbook::trials::enclosed::on_balls;

pub(super) static VALUES: [Number; 11] = [
    Number::new("a-printed", || Ok(printed::eq132_a(1.0)))
        .within(Enclosure(|bits| closed(printed::eq132_a(one()), bits))),
    Number::new("a", || Ok(corrected::a(1.0)))
        .within(Enclosure(|bits| closed(corrected::a(one()), bits))),
    Number::new("alpha-printed", || Ok(printed::eq133_alpha(1.0))),
    Number::new("alpha", || Ok(corrected::alpha(1.0))),
    Number::new("p-printed", || Ok(printed::eq135_p(1.0)))
        .within(Enclosure(|bits| closed(printed::eq135_p(one()), bits))),
    Number::new("p", || Ok(corrected::rho(1.0)))
        .within(Enclosure(|bits| closed(corrected::rho(one()), bits))),
    Number::new("s-printed", || Ok(printed::eq137_s(1.0)))
        .within(Enclosure(|bits| closed(printed::eq137_s(one()), bits))),
    Number::new("s", || Ok(corrected::s(1.0)))
        .within(Enclosure(|bits| closed(corrected::s(one()), bits))),
    Number::new("turn", || Ok(libm::exp(TAU / SQRT_2))),
    Number::new("delay", || Ok(corrected::delay()))
        .within(Enclosure(|bits| closed(corrected::delay(), bits))),
    Number::new("winding", || Ok(corrected::winding()))
        .within(Enclosure(|bits| closed(corrected::winding(), bits))),
];

fn one() -> Expr {
    int(1)
}

fn closed(formula: Expr, bits: usize) -> Result<Ball, CertifiedError> {
    let ball = on_balls(formula, bits + 8, &|_| None).map(|ball| ball.with_bits(bits));
    ball.ok_or_else(|| CertifiedError::unproved("the formula has no ball", &[]))
}
