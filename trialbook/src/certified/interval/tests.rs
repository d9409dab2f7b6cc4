mod domain;

use super::*;
use crate::certified::ball::Ball;
use crate::scalar::Scalar;
use proptest::prelude::*;

/// The interval is not much wider than the last places of an f64.
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

}

#[test]
fn bounds_in_the_wrong_order_and_sums_beyond_all_numbers_say_nothing() {
    assert_eq!(Interval::new(2.0, 1.0), Interval::WHOLE);
    let top = Interval::point(f64::MAX);
    assert_eq!((top + top).hi(), f64::INFINITY);
    assert_eq!((top + top).lo(), f64::MAX);
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
    assert!(outer.within(outer) && !outer.inside(outer));
    assert!(of(0.0, 1.0_f64.next_down()).below(outer) && !of(0.0, 1.0).below(outer));
    assert_eq!(outer.meet(of(2.0, 3.0)), Some(Interval::point(2.0)));
    assert_eq!(outer.meet(of(2.0_f64.next_up(), 3.0)), None);
}
