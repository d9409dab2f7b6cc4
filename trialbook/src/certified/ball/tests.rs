use super::*;
use proptest::prelude::*;

#[test]
fn the_radius_covers_what_more_bits_show() {
    for k in -40..40 {
        let x = Ball::ratio(7 * k + 3, 11, 120).unwrap();
        let fine = Ball::ratio(7 * k + 3, 11, 400).unwrap();
        let pairs = x.sin_cos().into_iter().zip(fine.sin_cos());
        let [power, finer] = [&x, &fine].map(|x| x.exp().unwrap());
        // exp x makes as much of a unit as it is large.
        assert!(
            power.meets(&finer) && power.known_bits() > 100 - k.max(0) as usize,
            "{k}"
        );
        let logs = x.ln().zip(fine.ln());
        assert_eq!(logs.is_some(), k >= 0);
        let square = [(&x * &x, &fine * &fine)];
        for (coarse, fine) in pairs.chain(square).chain(logs) {
            assert!(coarse.meets(&fine), "{k}");
            assert!(coarse.known_bits() > 100, "{k}");
        }
    }
}

/// What an f64 is in units of 2⁻⁴⁰⁰ is exact here.
#[test]
fn the_interval_around_a_ball_holds_all_of_it_and_little_more() {
    let exact = |x: f64| units(x, 400).unwrap();
    let large = 10_i64.pow(17);
    for (n, m) in [
        (1, 3),
        (2, 3),
        (-1, 3),
        (-2, 3),
        (1, 1),
        (large, 7),
        (-5, large),
    ] {
        for bits in [50, 60, 89, 90, 91, 120, 300] {
            let ball = Ball::ratio(n, m, bits).unwrap();
            for ball in [ball.middle(), ball] {
                let [lo, hi] = ball.with_bits(400).bounds();
                let around = ball.interval();
                let holds = exact(around.lo()) <= lo && hi <= exact(around.hi());
                assert!(holds, "{n}/{m}, {bits} bits: {around}");
                let unit = libm::ldexp(1.0, -(bits.min(90) as i32));
                let spare = 8.0 * unit + 1e-15 * around.magnitude();
                assert!(around.width() <= spare, "{n}/{m}, {bits} bits: {around}");
            }
        }
    }
}

#[test]
fn functions_fulfil_their_equations() {
    for k in 1..20 {
        let x = Ball::ratio(k, 20, 500).unwrap();
        let angle = x.asin().unwrap();
        let [s, c] = angle.sin_cos();
        assert!(s.meets(&x) && s.known_bits() > 480);
        assert!((&s * &s + &c * &c).meets(&Ball::int(1, 500)));
        let root = x.sqrt().unwrap();
        assert!((&root * &root).meets(&x));
        let log = x.ln().unwrap();
        let back = log.exp().unwrap();
        assert!(back.meets(&x) && back.known_bits() > 480);
        let (power, inverse) = (x.exp().unwrap(), (-&x).exp().unwrap());
        assert!((&power * &inverse).meets(&Ball::int(1, 500)) && inverse.known_bits() > 480);
    }
    // e and the logarithm of 10³⁰, by their decimals.
    let e = Ball::int(1, 120).exp().unwrap();
    assert_eq!(e.decimal(30).unwrap(), "2.718281828459045235360287471353");
    let large = whole_power_of_ten(30).ln().unwrap();
    assert_eq!(large.decimal(25).unwrap(), "69.0775527898213705205397436");
    let [s, c] = Ball::pi(300).sin_cos();
    assert!(s.holds_zero() && s.known_bits() > 290 && c.meets(&Ball::int(-1, 300)));
}

fn whole_power_of_ten(n: usize) -> Ball {
    let ten = Ball::int(10, 120);
    std::iter::repeat_n(&ten, n).fold(Ball::int(1, 120), |power, ten| &power * ten)
}

#[test]
fn only_certain_decimals_are_given() {
    let third = Ball::ratio(-1, 3, 30).unwrap();
    assert_eq!(third.decimal(5).unwrap(), "-0.33333");
    assert_eq!(third.decimal(20), None);
    let small = Ball::ratio(1, 400, 60).unwrap();
    assert_eq!(small.decimal(4).unwrap(), "0.0025");
    assert_eq!(small.decimal(0).unwrap(), "0");
    assert_eq!(Ball::int(-3, 0).decimal(2).unwrap(), "-3.00");
}

#[test]
fn what_has_no_value_is_none() {
    let around_zero = Ball::enclosing(Interval::new(-1.0, 1.0), 60).unwrap();
    let zero = Ball::int(0, 60);
    assert_eq!((around_zero.sqrt(), zero.sqrt()), (None, Some(zero)));
    assert!(Ball::int(1, 60).over(&around_zero).is_none());
    assert!(around_zero.asin().is_none());
    assert!(around_zero.ln().is_none() && Ball::int(-1, 60).ln().is_none());
    assert!(Ball::int(1 << 10, 60).exp().is_none() && Ball::int(1000, 60).exp().is_some());
    let wide = Ball::enclosing(Interval::new(-2.0, 2.0), 60).unwrap();
    assert!(wide.exp().is_none());
    assert!(Ball::enclosing(Interval::WHOLE, 60).is_none());
}

proptest! {
    #[test]
    fn what_has_a_value_everywhere_is_enclosed_and_all_else_is_none(
        lo in prop_oneof![-3.0..3.0, -1.1..1.1, prop::sample::select(&[-1.0, 0.0, 1.0][..])],
        width in prop_oneof![0.0..1e-6, 0.0..0.2, 0.0..4.0],
        parts in prop::collection::vec(0.0..1.0, 5),
        bits in 60..200_usize,
    ) {
        let cell = Interval::new(lo, lo + width);
        let ball = Ball::enclosing(cell, bits).unwrap();
        let known = [
            ("sqrt", ball.sqrt(), libm::sqrt as fn(f64) -> f64),
            ("asin", ball.asin(), libm::asin),
            ("exp", ball.exp(), libm::exp),
            ("ln", ball.ln(), libm::log),
            ("1/x", Ball::int(1, bits).over(&ball), |x| 1.0 / x),
            ("sin", Some(ball.sin_cos()[0].clone()), libm::sin),
            ("cos", Some(ball.sin_cos()[1].clone()), libm::cos),
        ];
        let numbers = parts.into_iter().map(|part: f64| lo + part * width);
        for x in numbers.chain([lo, 0.0]).filter(|&x| cell.contains(x)) {
            for (name, result, at) in &known {
                let (value, result) = (at(x), result.as_ref().map(Ball::interval));
                let holds = |bounds: Interval| bounds.widened(1e-14 * value.abs()).contains(value);
                prop_assert!(result.is_none_or(holds), "{name} on {cell}: {result:?}, but {value:e} at {x:e}");
            }
        }
    }
}

#[test]
fn a_quotient_holds_all_quotients_even_where_its_middle_is_cut_to_zero() {
    let ball = |mid: i64, rad: u8| Ball {
        mid: IBig::from(mid),
        rad: UBig::from(rad),
        bits: 0,
    };
    // 99/1 = 99, while 99/100 is cut to 0.
    let quotient = ball(99, 0).over(&ball(100, 99)).unwrap();
    let [lo, hi] = quotient.bounds();
    assert!(lo <= IBig::ZERO && hi >= IBig::from(99), "{quotient:?}");
}

/// All small balls of some bits: what is cut off counts most there.
fn small_balls() -> impl Iterator<Item = Ball> + Clone {
    let of = |bits| (-9..=9).flat_map(move |mid| (0..=3).map(move |rad| (mid, rad, bits)));
    (0..=2).flat_map(of).map(|(mid, rad, bits)| Ball {
        mid: IBig::from(mid),
        rad: UBig::from(rad as u8),
        bits,
    })
}

fn ends(ball: &Ball) -> [i64; 2] {
    let unit = 1 << (8 - ball.bits);
    ball.bounds().map(|end| i64::try_from(end).unwrap() * unit)
}

#[test]
fn with_fewer_bits_no_number_is_lost() {
    for ball in small_balls() {
        let [low, high] = ends(&ball);
        for bits in 0..=4 {
            let [from, to] = ends(&ball.with_bits(bits));
            assert!(from <= low && high <= to, "{ball:?} {bits}");
            // By two units and what their rounding takes, at most.
            let wider = if bits < ball.bits { 3 << (8 - bits) } else { 0 };
            assert!(low - from <= wider && to - high <= wider, "{ball:?} {bits}");
        }
    }
}

#[test]
fn sums_products_and_quotients_hold_those_of_the_ends() {
    for (a, b) in small_balls().flat_map(|a| small_balls().map(move |b| (a.clone(), b))) {
        let [sum, difference, product] = [&a + &b, &a - &b, &a * &b].map(|ball| ends(&ball));
        let quotient = a.over(&b).map(|ball| ends(&ball));
        let holds = |[from, to]: [i64; 2], x: i64| from <= x && x <= to;
        for x in ends(&a) {
            for y in ends(&b) {
                let all = holds(sum, x + y) && holds(difference, x - y);
                // x y is in units of 2⁻¹⁶.
                let times = product.map(|end| 256 * end);
                assert!(all && holds(times, x * y), "{a:?} {b:?}");
                if let Some([from, to]) = quotient {
                    let over = [from * y, to * y];
                    let over = if y > 0 { over } else { [over[1], over[0]] };
                    assert!(holds(over, 256 * x), "{a:?} {b:?}");
                }
            }
        }
        assert_eq!(quotient.is_none(), holds(ends(&b), 0), "{b:?}");
    }
}

#[test]
fn the_inverse_sine_is_told_close_to_its_ends_and_at_them() {
    let right_angle = &Ball::pi(201) * &Ball::ratio(1, 2, 201).unwrap();
    for (x, expected) in [(1, right_angle.clone()), (-1, -right_angle)] {
        let angle = Ball::int(x, 200).asin().unwrap();
        assert!(
            angle.meets(&expected) && angle.known_bits() > 190,
            "{angle:?}"
        );
    }
    for bits in [20, 24] {
        let x = Ball::int(1, 200) - Ball::ratio(1, 1 << bits, 200).unwrap();
        let [s, _] = x.asin().unwrap().sin_cos();
        assert!(s.meets(&x) && s.known_bits() > 150);
    }
}

#[test]
fn of_large_arguments_the_sine_is_not_told() {
    let known = |x: i64| Ball::int(x, 60).sin_cos().map(|value| value.known_bits());
    assert!(known((1 << 32) - 1).iter().all(|bits| *bits > 50));
    assert_eq!(known(1 << 32), [0, 0]);
    assert_eq!(known(-(1 << 40)), [0, 0]);
}

#[test]
fn the_largest_numbers_have_an_interval() {
    // In units of 2⁻⁵³ neither bound is an f64.
    for [lo, hi] in [[3.6e292, f64::MAX], [1e300, 2e300], [-f64::MAX, -1e295]] {
        for bits in [0, 53, 200] {
            let x = Interval::new(lo, hi);
            let found = Ball::enclosing(x, bits).unwrap().interval();
            assert!(x.within(found), "{x} {found}");
            assert!(
                found.lo() >= lo - 1e-9 * lo.abs() && found.hi() <= hi.max(-lo) * 1.000_001
                    || lo == -f64::MAX,
                "{x} {found}"
            );
        }
    }
}
