//! What is enclosed is what was meant, and no wider than it has to be: held against ordinary numbers and the motion.

use slipbook::claims::PAPER;
use slipbook::claims::anisotropic::simulated::{curve_a, curve_b, curve_e, touching};
use slipbook::corrections::escape;
use slipbook::motion::drive::{Drive, DriveState, Friction, Sign};
use slipbook::motion::turntable::{Fate, Start, fate};
use slipbook::numerics::number::Number;
use slipbook::paper::escape as printed;
use slipbook::paper::sinusoidal::eq37_lambda_c;
use slipbook::scalar::Scalar;
use slipbook::validated::drive;
use slipbook::validated::turntable::{self, fate_launched, fate_put_down};
use std::collections::BTreeSet;
use std::f64::consts::{FRAC_1_SQRT_2, TAU};
use trialbook::certified::ball::Ball;
use trialbook::certified::error::CertifiedError;
use trialbook::certified::interval::Interval;
use trialbook::certified::jet::over;

/// The middle of the enclosure.
fn certain(name: &str) -> f64 {
    let enclosure = PAPER.value(name).unwrap().enclosure.unwrap();
    enclosure.interval().unwrap().mid()
}

/// λ₀ on B, and beyond Y on E.
fn border(q: f64) -> f64 {
    curve_b(q).unwrap().or(curve_e(q).unwrap()).unwrap()
}

/// How far C lies above B or E at this distance from Y, over its square.
fn touch(distance: f64) -> f64 {
    let q = touching().unwrap() + distance;
    (1.0 / q - border(q)) / (distance * distance)
}

/// Where the slip under a sine ends that begins with rest, when the drive first exceeds the friction.
fn slip_end(lambda: f64) -> f64 {
    let drive = Drive::new(libm::sin, &[]).unwrap();
    let friction = Friction::new(lambda, lambda).unwrap();
    let rest = DriveState { phi: 0.0, w: 0.0 };
    let path = drive.advance(friction, rest, TAU).unwrap();
    let mut slips = path.intervals.iter().filter(|i| i.sign == Sign::Positive);
    slips.next().unwrap().end
}

/// Each number has fifty certain digits; a formula in ordinary numbers, or the motion, has as many of them as it can.
#[test]
fn every_certified_number_is_found_in_ordinary_numbers() {
    let q_y = touching().unwrap();
    let other = [
        ("lambda-c", eq37_lambda_c()),
        ("critical-phase", libm::asin(eq37_lambda_c())),
        ("fig-4-slip-end", slip_end(FRAC_1_SQRT_2)),
        ("slip-end-0.6", slip_end(0.6)),
        ("slip-end-0.9", slip_end(0.9)),
        ("y-root", libm::sqrt(q_y * q_y - 1.0)),
        ("y-q", q_y),
        ("y-lambda", 1.0 / q_y),
        ("curve-a-2", curve_a(2.0).unwrap()),
        ("curve-a-6", curve_a(6.0).unwrap()),
        ("curve-a-12", curve_a(12.0).unwrap()),
        ("curve-b-2", curve_b(2.0).unwrap().unwrap()),
        ("curve-b-3", curve_b(3.0).unwrap().unwrap()),
        ("curve-e-6", curve_e(6.0).unwrap().unwrap()),
        ("curve-e-12", curve_e(12.0).unwrap().unwrap()),
        ("p", escape::rho(1.0)),
        ("s", escape::s(1.0)),
        ("a", escape::a(1.0)),
        ("winding", escape::winding()),
        ("delay", escape::delay()),
        ("a-printed", printed::eq132_a(1.0)),
        ("p-printed", printed::eq135_p(1.0)),
        ("s-printed", printed::eq137_s(1.0)),
    ];
    for (name, found) in other {
        let certain = certain(name);
        assert!(
            (found - certain).abs() < 1e-11,
            "{name}: {found}, {certain}"
        );
    }
    // A difference of curves has fewer digits: what is left out is odd in the distance, and cancels.
    let (contact, found) = (certain("contact"), 0.5 * (touch(1e-3) + touch(-1e-3)));
    assert!(
        (found - contact).abs() < 1e-5 * contact,
        "{found}, {contact}"
    );
    let names: BTreeSet<_> = other
        .iter()
        .map(|(name, _)| *name)
        .chain(["contact"])
        .collect();
    assert_eq!(
        names,
        PAPER
            .values()
            .filter(|value| value.enclosure.is_some())
            .map(|value| value.id)
            .collect()
    );
}

/// Bounds that hold `least` and `most` and are no more than two steps of an f64 away.
#[track_caller]
fn assert_tight(found: Interval, least: f64, most: f64) {
    let below = |x: f64| {
        if x.is_finite() {
            x.next_down().next_down()
        } else {
            x
        }
    };
    let lo = found.lo() <= least && found.lo() >= below(least);
    let hi = found.hi() >= most && -found.hi() >= below(-most);
    assert!(lo && hi, "{found:?} for [{least:e}, {most:e}]");
}

fn intervals() -> Vec<Interval> {
    let ends = [-7.3, -1.0, -0.1, 0.0, 0.3, 1.0, 11.7];
    let from = |lo: f64| {
        ends.into_iter()
            .filter(move |hi| *hi >= lo)
            .map(move |hi| Interval::new(lo, hi))
    };
    ends.into_iter().flat_map(from).collect()
}

/// The least and the largest of the numbers.
fn range(numbers: impl IntoIterator<Item = f64>) -> [f64; 2] {
    let start = [f64::INFINITY, f64::NEG_INFINITY];
    numbers
        .into_iter()
        .fold(start, |[lo, hi], x| [lo.min(x), hi.max(x)])
}

#[test]
fn products_and_quotients_of_intervals_are_bounded_by_those_of_their_ends() {
    for a in intervals() {
        for b in intervals() {
            let [x, y] = [[a.lo(), a.hi()], [b.lo(), b.hi()]];
            let pairs = || x.into_iter().flat_map(|x| y.map(|y| (x, y)));
            let [least, most] = range(pairs().map(|(x, y)| x * y));
            assert_tight(a * b, least, most);
            let quotients = pairs().filter(|(_, y)| *y != 0.0).map(|(x, y)| x / y);
            let [least, most] = range(quotients);
            match (b.lo() < 0.0, b.hi() > 0.0) {
                // Zero is an end: the quotients by what is near it have no bound on the side of their sign.
                (false, true) | (true, false) if b.contains(0.0) && a == Interval::point(0.0) => {
                    assert!((a / b).contains(0.0));
                }
                (false, true) | (true, false) if b.contains(0.0) => {
                    let grows = if b.hi() > 0.0 { a } else { -a };
                    let up = if grows.hi() > 0.0 {
                        f64::INFINITY
                    } else {
                        most
                    };
                    let down = if grows.lo() < 0.0 {
                        f64::NEG_INFINITY
                    } else {
                        least
                    };
                    assert_tight(a / b, down, up);
                }
                (true, true) | (false, false) if b.contains(0.0) => {
                    assert_eq!(a / b, Interval::WHOLE)
                }
                _ => assert_tight(a / b, least, most),
            }
        }
    }
}

#[test]
fn the_slope_of_a_formula_is_its_derivative() {
    let cell = [Interval::point(0.7), Interval::point(-1.9)];
    let jet = over(|[x, y]| -(x * y) / (x - y * y), &cell);
    // By hand, with D = x − y²: −y/D + xy/D², and −x/D − 2xy²/D².
    let (x, y) = (0.7, -1.9);
    let d = x - y * y;
    for (slope, by_hand) in jet
        .slope
        .iter()
        .zip([-y / d + x * y / (d * d), -x / d - 2.0 * x * y * y / (d * d)])
    {
        assert!(
            slope.width() < 1e-14 && (slope.mid() - by_hand).abs() < 1e-14,
            "{slope:?} {by_hand}"
        );
    }
}

#[test]
fn a_ball_lies_inside_another_if_both_of_its_ends_do() {
    let ball = |lo: f64, hi: f64| Ball::enclosing(Interval::new(lo, hi), 100).unwrap();
    let outer = ball(1.0, 2.0);
    assert!(ball(1.1, 1.9).inside(&outer));
    for (lo, hi) in [
        (0.9, 1.5),
        (1.5, 2.1),
        (0.5, 2.5),
        (3.0, 4.0),
        (1.0, 1.5),
        (1.5, 2.0),
        (1.0, 2.0),
    ] {
        assert!(!ball(lo, hi).inside(&outer), "[{lo}, {hi}]");
    }
}

#[test]
fn an_operation_loses_few_bits() {
    const BITS: usize = 400;
    for (n, m) in [(1, 3), (-2, 7), (22, 23), (5, 1000)] {
        let x = Ball::ratio(n, m, BITS).unwrap();
        let [sine, cosine] = x.sin_cos();
        let three = Ball::int(3, BITS);
        let results = [
            ("asin", x.asin().unwrap()),
            ("root", (&x * &x).sqrt().unwrap()),
            ("quotient", three.over(&(&x + &three)).unwrap()),
            ("sine", sine),
            ("cosine", cosine),
        ];
        for (name, result) in results {
            assert!(
                result.known_bits() > BITS - 24,
                "{name} of {n}/{m}: {}",
                result.known_bits()
            );
            let fewer = result.with_bits(100);
            assert!(
                fewer.known_bits() > 95 && fewer.meets(&result),
                "{name} of {n}/{m}"
            );
        }
    }
}

/// What is proved of all starts in a box holds for each of them, and says little more than they do.
#[test]
fn the_radius_at_rest_of_a_box_of_starts_is_that_of_its_motions() {
    type Place = fn(f64) -> Start;
    type Put = fn(Interval, f64) -> Result<turntable::Fate, CertifiedError>;
    let down = |r| Start {
        p: r,
        xi: 0.0,
        zeta: 0.0,
    };
    let launched = |u| Start {
        p: u,
        xi: 0.0,
        zeta: u,
    };
    // A launch along the axis has two equal components; as a box these are any two, and the radius is that much wider.
    let cases: [(Put, Place, f64); 2] =
        [(fate_put_down, down, 2.0), (fate_launched, launched, 8.0)];
    for (enclosed, start, wider) in cases {
        for from in [0.1, 0.25, 0.4] {
            let to = from + 1e-3;
            let turntable::Fate::Rest { sigma, .. } =
                enclosed(Interval::new(from, to), 1e-9).unwrap()
            else {
                panic!("{from} goes away");
            };
            let rest = |x: f64| match fate(&start(x)).unwrap() {
                Fate::Rest { sigma, .. } => sigma,
                other => panic!("{x}: {other:?}"),
            };
            let [least, most] =
                range((0..=10).map(|k| rest(from + (to - from) * f64::from(k) / 10.0)));
            assert!(
                sigma.lo() <= least && most <= sigma.hi(),
                "{sigma}, [{least}, {most}]"
            );
            assert!(
                sigma.width() < wider * (most - least),
                "{sigma}, [{least}, {most}]"
            );
        }
    }
}

/// Bounds that hold the numbers and are no more than this part of them away.
#[track_caller]
fn assert_near(found: Interval, least: f64, most: f64, room: f64) {
    let holds = found.contains(least) && found.contains(most);
    let near = found.lo() >= least - room * least.abs() && found.hi() <= most + room * most.abs();
    assert!(holds && near, "{found:?} for [{least:e}, {most:e}]");
}

/// Also where they change over to another way, and beyond what they know.
#[test]
fn functions_of_intervals_enclose_the_values_of_numbers() {
    for x in [
        -699.9, -30.0, -0.4, -1e-300, 0.0, 1e-5, 0.36, 1.0, 30.0, 699.9, -700.0, 700.0,
    ] {
        let value = libm::exp(x);
        assert_near(Scalar::exp(Interval::point(x)), value, value, 1e-12);
    }
    for (x, least, most) in [(-700.1, 0.0, 1e-300), (700.1, 1e300, f64::INFINITY)] {
        let found = Scalar::exp(Interval::point(x));
        assert!(
            found.lo() >= least && found.hi() <= most && found.contains(libm::exp(x)),
            "{found:?}"
        );
    }
    for x in [1e-290, 1e-10, 0.5, 0.999, 1.5, 2.0, 1e10, 1e290] {
        let value = libm::log(x);
        assert_near(Scalar::ln(Interval::point(x)), value, value, 1e-12);
    }
    assert!(Scalar::ln(Interval::point(1.0)).magnitude() < 1e-15);
    for (x, least, most) in [
        (0.9e-290, f64::NEG_INFINITY, -667.0),
        (1.1e290, 667.0, f64::INFINITY),
    ] {
        let found = Scalar::ln(Interval::point(x));
        assert!(
            found.lo() >= least && found.hi() <= most && found.contains(libm::log(x)),
            "{found:?}"
        );
    }
    let powers = range([libm::pow(2.0, 1.5), libm::pow(3.0, 1.5)]);
    assert_near(
        Scalar::pow(Interval::new(2.0, 3.0), Interval::point(1.5)),
        powers[0],
        powers[1],
        1e-13,
    );
    for x in [-0.99, -0.75, -0.7, -1e-8, 0.3, 0.74, 0.76, 1.0] {
        let value = libm::asin(x);
        assert_near(Scalar::asin(Interval::point(x)), value, value, 1e-14);
    }
    assert_eq!(Number::magnitude(&Interval::new(-3.0, 2.0)), 3.0);
}

#[test]
fn no_rest_is_enclosed_for_a_ratio_that_is_not_positive() {
    let rest_appears = |q: i64| drive::rest_appears(&Ball::int(q, 80), 64);
    assert!(rest_appears(1).is_ok());
    for q in [0, -1, -3] {
        let error = rest_appears(q).unwrap_err();
        assert!(
            matches!(error, CertifiedError::NotProved { .. }),
            "{q}: {error}"
        );
    }
}
