mod domain;

use super::*;
use crate::certified::ball::Ball;
use crate::scalar::Scalar;
use proptest::prelude::*;
use std::ops::Range;

/// The ball's value lies in the interval, which is not much wider than the last places of an f64.
fn encloses(interval: Interval, exact: &Ball) -> bool {
    let value = exact.interval();
    interval.lo() <= value.hi()
        && value.lo() <= interval.hi()
        && interval.width() <= 1e-14 * value.magnitude().max(1.0)
}

fn ball(x: f64) -> Ball {
    Ball::enclosing(Interval::point(x), 200).unwrap()
}

#[test]
fn the_constants_are_enclosed() {
    assert!(encloses(PI, &Ball::pi(200)));
    assert_eq!(PI.lo().next_up(), PI.hi());
}

proptest! {
    #[test]
    fn arithmetic_is_rounded_outwards_and_no_farther_than_needed(x in -1e3..1e3, y in 0.1..1e3) {
        let (a, b) = (Interval::point(x), Interval::point(y));
        let (c, d) = (ball(x), ball(y));
        for (interval, exact) in [
            (a + b, &c + &d),
            (a - b, &c - &d),
            (a * b, &c * &d),
            (a / b, c.over(&d).unwrap()),
            (b.sqrt(), d.sqrt().unwrap()),
        ] {
            prop_assert!(interval.lo() <= exact.interval().hi() && exact.interval().lo() <= interval.hi());
            prop_assert!(interval.hi() <= interval.lo().next_up().next_up());
        }
        // The bound that an unbounded quotient has is rounded as if there were two.
        let (a, from_zero) = (Interval::point(x.abs()), Interval::new(0.0, y));
        prop_assert_eq!((a / from_zero).lo(), (a / b).lo());
        prop_assert_eq!((-a / from_zero).hi(), (-a / b).hi());
    }

    #[test]
    fn sine_and_cosine_are_enclosed(x in -50.0..50.0) {
        let [sine, cosine] = ball(x).sin_cos();
        prop_assert!(encloses(Interval::point(x).sin(), &sine));
        prop_assert!(encloses(Interval::point(x).cos(), &cosine));
    }

    #[test]
    fn inverse_functions_undo(x in -0.999_999..0.999_999) {
        let asin = Interval::point(x).asin();
        prop_assert!(asin.sin().contains(x));
        prop_assert!(encloses(asin, &ball(x).asin().unwrap()));
        prop_assert!(Interval::point(x).acos().cos().contains(x));
    }

    #[test]
    fn exponential_and_logarithm_undo(x in -300.0..300.0) {
        let e = Interval::point(x).exp();
        prop_assert!(e.ln().contains(x));
        prop_assert!(e.width() < 1e-13 * e.hi());
        prop_assert!((e * (-Interval::point(x)).exp()).contains(1.0));
    }

    #[test]
    fn functions_of_an_interval_contain_those_of_its_numbers(
        x in -9.0..9.0, width in 0.0..7.0, part in 0.0..1.0
    ) {
        let (wide, at) = (Interval::new(x, x + width), Interval::point(f64::min(x + part * width, x + width)));
        for f in [Scalar::sin, Scalar::cos, Scalar::sinh, Scalar::cosh, Scalar::exp, Scalar::squared] {
            let (all, one): (Interval, Interval) = (f(wide), f(at));
            prop_assert!(all.hull(one).within(all.widened(1e-12 * all.magnitude())), "{all} {one}");
        }
    }
}

#[test]
fn exact_operations_stay_exact() {
    let [one, three] = [1.0, 3.0].map(Interval::point);
    assert_eq!((three * three).sqrt(), three);
    assert_eq!(Interval::ratio(1, 4) * Interval::ratio(12, 1), three);
    assert_eq!(three / one, three);
    assert_eq!((one - one.squared()).sqrt(), Interval::point(0.0));
}

#[test]
fn what_has_no_value_says_nothing() {
    let around_zero = Interval::new(-1.0, 1.0);
    assert_eq!(around_zero / around_zero, Interval::WHOLE);
    assert_eq!(around_zero.sqrt(), Interval::WHOLE);
    assert_eq!(around_zero.ln(), Interval::WHOLE);
    assert_eq!(Interval::new(0.5, 1.5).asin(), Interval::WHOLE);
    assert_eq!(Interval::new(2.0, 1.0), Interval::WHOLE);
    assert_eq!(Interval::point(f64::NAN), Interval::WHOLE);
    let top = Interval::point(f64::MAX);
    assert_eq!((top + top).hi(), f64::INFINITY);
    assert_eq!((top + top).lo(), f64::MAX);
    let half_open = Interval::point(1.0) / Interval::new(0.0, 0.5);
    assert_eq!((half_open.lo(), half_open.hi()), (2.0, f64::INFINITY));
}

#[test]
fn the_extremes_of_the_sine_are_seen() {
    let range = |r: Range<f64>| Interval::new(r.start, r.end);
    assert_eq!(range(1.0..2.0).sin().hi(), 1.0);
    assert!(range(1.0..1.5).sin().hi() < 1.0);
    assert_eq!(range(4.0..5.0).sin().lo(), -1.0);
    assert_eq!(range(-0.1..0.1).cos().hi(), 1.0);
    assert_eq!(range(3.0..4.0).cos().lo(), -1.0);
    assert_eq!(range(0.0..7.0).cos(), Interval::new(-1.0, 1.0));
}

#[test]
fn quotients_hold_all_that_the_signs_allow() {
    let of = |lo: f64, hi: f64| Interval::new(lo, hi);
    let all = f64::INFINITY;
    for (a, b, [lo, hi]) in [
        (of(1.0, 2.0), of(4.0, 8.0), [0.125, 0.5]),
        (of(-2.0, -1.0), of(4.0, 8.0), [-0.5, -0.125]),
        (of(-1.0, 2.0), of(4.0, 8.0), [-0.25, 0.5]),
        (of(1.0, 2.0), of(-8.0, -4.0), [-0.5, -0.125]),
        (of(-2.0, -1.0), of(-8.0, -4.0), [0.125, 0.5]),
        (of(-1.0, 2.0), of(-8.0, -4.0), [-0.5, 0.25]),
        (of(1.0, 2.0), of(0.0, 4.0), [0.25, all]),
        (of(-2.0, -1.0), of(0.0, 4.0), [-all, -0.25]),
        (of(1.0, 2.0), of(-4.0, 0.0), [-all, -0.25]),
        (of(-2.0, -1.0), of(-4.0, 0.0), [0.25, all]),
        (of(-1.0, 2.0), of(0.0, 4.0), [-all, all]),
        (of(1.0, 2.0), of(-4.0, 4.0), [-all, all]),
        (of(1.0, 2.0), of(0.0, 0.0), [-all, all]),
        (of(-2.0, -1.0), of(0.0, 0.0), [-all, all]),
    ] {
        let quotient = a / b;
        assert_eq!([quotient.lo(), quotient.hi()], [lo, hi], "{a:?} / {b:?}");
    }
}

#[test]
fn what_rounding_takes_is_never_lost() {
    // The quotient times 3 rounds to 1, and is not a third.
    let third = Interval::ratio(1, 3);
    assert!(third.lo() < third.hi() && third.hi() > 1.0 / 3.0);
    for x in (2..100_u32).filter(|x| !x.isqrt().pow(2).eq(x)) {
        let root = Interval::point(f64::from(x)).sqrt();
        assert!(root.lo() < root.hi(), "{x}: {root}");
    }
    // (1 + 2⁻⁴²)² = 1 + 2⁻⁴¹ + 2⁻⁸⁴, of which the last is below the last place.
    let close = Interval::point(1.0 + libm::ldexp(1.0, -42));
    let square = close * close;
    assert!(square.contains(1.0 + libm::ldexp(1.0, -41)));
    assert!(square.hi() > 1.0 + libm::ldexp(1.0, -41));
}

#[test]
fn what_reaches_zero_has_no_sign() {
    let sign = |lo, hi| Interval::new(lo, hi).sign();
    let least = f64::from_bits(1);
    assert_eq!([sign(least, 1.0), sign(0.0, 1.0)], [Some(1.0), None]);
    assert_eq!([sign(-1.0, -least), sign(-1.0, 0.0)], [Some(-1.0), None]);
}

#[test]
fn zero_times_any_number_is_zero() {
    let [zero, three] = [0.0, 3.0].map(Interval::point);
    for other in [three, -three, Interval::new(-1.0, f64::MAX)] {
        assert_eq!(zero * other, zero);
        assert_eq!(other * zero, zero);
    }
    // 0/x has no value at 0.
    let some = Interval::new(0.0, 3.0);
    assert_eq!(zero * (three / some), Interval::WHOLE);
    let positive = Interval::new(0.0, f64::INFINITY);
    assert_eq!(some * (three / some), positive);
    // Nor does a bound of the other sign meet the zero of a product.
    assert_eq!((three / some) * -some, -positive);
    assert_eq!((three / -some) * -some, positive);
}

#[test]
fn far_arguments_have_any_sine() {
    for x in [2e5, -3e7, 1e300] {
        assert_eq!(Interval::point(x).sin(), Interval::new(-1.0, 1.0));
        assert_eq!(Interval::point(x).cos(), Interval::new(-1.0, 1.0));
    }
    assert!(Interval::point(1e5).sin().width() < 1e-9);
}

#[test]
fn an_interval_is_written_with_both_bounds() {
    let x = Interval::new(-0.5, 250.0);
    assert_eq!(format!("{x} {x:?}"), "[-0.5, 250] [-5e-1, 2.5e2]");
}

#[test]
fn what_touches_is_neither_inside_nor_below() {
    let of = Interval::new;
    let outer = of(1.0, 2.0);
    assert!(of(1.0_f64.next_up(), 2.0_f64.next_down()).inside(outer));
    for [lo, hi] in [[1.0, 1.5], [1.5, 2.0], [1.0, 2.0], [0.5, 1.5], [1.5, 2.5]] {
        assert!(!of(lo, hi).inside(outer), "[{lo}, {hi}]");
    }
    assert!(!Interval::WHOLE.inside(Interval::WHOLE));
    // Within counts the ends.
    assert!(outer.within(outer) && !outer.inside(outer));
    assert!(of(0.0, 1.0_f64.next_down()).below(outer) && !of(0.0, 1.0).below(outer));
    // What has an end in common meets there.
    assert_eq!(outer.meet(of(2.0, 3.0)), Some(Interval::point(2.0)));
    assert_eq!(outer.meet(of(2.0_f64.next_up(), 3.0)), None);
}
