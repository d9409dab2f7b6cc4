//! What is enclosed is what was meant: held against ordinary numbers and the motion.

use slipbook::claims::{
    PAPER,
    anisotropic::simulated::{curve_a, curve_b, curve_e},
};
use slipbook::motion::{
    drive::{Drive, DriveState, Friction, Sign},
    turntable::{Fate, Start, fate},
};
use slipbook::paper::sinusoidal::eq37_lambda_c;
use slipbook::validated::{
    drive,
    turntable::{self, fate_launched, fate_put_down},
};
use std::f64::consts::{FRAC_1_SQRT_2, TAU};
use trialbook::certified::{ball::Ball, error::CertifiedError, interval::Interval};

fn certain(name: &str) -> f64 {
    let enclosure = PAPER.value(name).unwrap().enclosure.unwrap();
    enclosure.interval().unwrap().mid()
}

/// Begun from rest, when the drive first exceeds the friction.
fn slip_end(lambda: f64) -> f64 {
    let drive = Drive::new(libm::sin, &[]).unwrap();
    let friction = Friction::new(lambda, lambda).unwrap();
    let rest = DriveState { phi: 0.0, w: 0.0 };
    let path = drive.advance(friction, rest, TAU).unwrap();
    let mut slips = path.intervals.iter().filter(|i| i.sign == Sign::Positive);
    slips.next().unwrap().end
}

#[test]
fn every_certified_number_is_found_in_ordinary_numbers() {
    let other = [
        ("critical-phase", libm::asin(eq37_lambda_c())),
        ("fig-4-slip-end", slip_end(FRAC_1_SQRT_2)),
        ("slip-end-0.6", slip_end(0.6)),
        ("slip-end-0.9", slip_end(0.9)),
        ("curve-a-2", curve_a(2.0).unwrap()),
        ("curve-a-6", curve_a(6.0).unwrap()),
        ("curve-a-12", curve_a(12.0).unwrap()),
        ("curve-b-2", curve_b(2.0).unwrap().unwrap()),
        ("curve-b-3", curve_b(3.0).unwrap().unwrap()),
        ("curve-e-6", curve_e(6.0).unwrap().unwrap()),
        ("curve-e-12", curve_e(12.0).unwrap().unwrap()),
    ];
    for (name, found) in other {
        let certain = certain(name);
        assert!(
            (found - certain).abs() < 1e-11,
            "{name}: {found}, {certain}"
        );
    }
}

fn range(numbers: impl IntoIterator<Item = f64>) -> [f64; 2] {
    let start = [f64::INFINITY, f64::NEG_INFINITY];
    numbers
        .into_iter()
        .fold(start, |[lo, hi], x| [lo.min(x), hi.max(x)])
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
    // Two equal components are any two in a box, and the radius is that much wider.
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
