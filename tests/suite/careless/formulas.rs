//! The formulas, printed and corrected, and the intervals.

use super::{any, config, each};
use proptest::prelude::*;
use slipbook::claims::{PAPER, formulas::formulas};
use slipbook::scalar::Scalar;
use trialbook::certified::{ball::Ball, interval::Interval};

fn is_bounded(x: Interval) -> bool {
    x.lo() <= x.hi()
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn a_formula_has_a_value_or_is_no_number(arguments in prop::collection::vec(any(), 40)) {
        for formula in formulas::<f64>() {
            (formula.value)(&arguments[..formula.symbols.len()]);
        }
    }

    #[test]
    fn an_interval_has_bounds_around_what_it_encloses([a, b, c, d] in each()) {
        let (x, y) = (Interval::new(a, b), Interval::new(c, d));
        prop_assert!(is_bounded(x) && x.mid().is_finite() && x.width() >= 0.0 && x.mignitude() <= x.magnitude());
        for z in [
            x + y, x - y, x * y, x / y, -x, x.hull(y), x.widened(c.abs()), x.sqrt(), x.sin(), x.cos(), x.sinh(), x.cosh(),
            x.exp(), x.ln(), x.asin(), x.acos(), x.squared(),
        ] {
            prop_assert!(is_bounded(z), "{x} {y} {z}");
        }
        prop_assert!(x.meet(y).is_none_or(|z| z.within(x) && z.within(y)) && x.halves().into_iter().all(is_bounded));
        let (p, q) = (Interval::point(a), Interval::point(c));
        for (exact, z) in [(a + c, p + q), (a - c, p - q), (a * c, p * q), (a / c, p / q), (libm::sqrt(a), p.sqrt())] {
            prop_assert!(!exact.is_finite() || !a.is_finite() || !c.is_finite() || z.contains(exact), "{exact} {z}");
        }
    }

    #[test]
    fn a_ball_encloses_or_refuses([a, b] in each(), bits in 0..300_usize, digits in 0..40_usize) {
        let Some(ball) = Ball::enclosing(Interval::new(a, b), bits) else { return Ok(()) };
        prop_assert!(is_bounded(ball.interval()) && ball.interval().contains(Interval::new(a, b).mid()), "{ball:?}");
        for other in [ball.sqrt(), ball.asin(), ball.over(&ball), Some(&ball * &ball)].into_iter().flatten() {
            prop_assert!(is_bounded(other.interval()));
            other.decimal(digits);
        }
        if a.abs().max(b.abs()) < 1e6 {
            prop_assert!(ball.sin_cos().iter().all(|ball| is_bounded(ball.interval())));
        }
    }
}

#[test]
fn a_certified_number_has_the_digits_asked_for_or_says_that_it_has_not() {
    let enclosed = PAPER.values().filter_map(|value| value.enclosure);
    for value in enclosed {
        for digits in [0, 1, 17, 60] {
            let text = value.decimal(digits).unwrap();
            let (_, after) = text.split_once('.').unwrap_or((&text, ""));
            assert_eq!(after.len(), digits, "{text}");
        }
    }
}
