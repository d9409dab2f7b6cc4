//! The numbers with fifty certain digits are the ones meant: each is that of a formula in ordinary numbers, or of the
//! motion, to as many digits as those have.

use slipbook::certified::values::{find, values};
use slipbook::claims::anisotropic::runs::{curve_a, curve_b, curve_e, touching};
use slipbook::corrections::escape;
use slipbook::motion::drive::{Drive, Friction, Sign, State};
use slipbook::paper::sinusoidal::eq37_lambda_c;
use std::collections::BTreeSet;
use std::f64::consts::{FRAC_1_SQRT_2, TAU};

/// The middle of the enclosure.
fn certain(name: &str) -> f64 {
    find(name).unwrap().interval().unwrap().mid()
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
    let rest = State { phi: 0.0, w: 0.0 };
    let path = drive.advance(friction, rest, TAU).unwrap();
    let mut slips = path.intervals.iter().filter(|i| i.sign == Sign::Positive);
    slips.next().unwrap().end
}

#[test]
fn every_certified_number_is_found_in_ordinary_numbers() {
    let q_y = touching().unwrap();
    let other = [
        ("lambda-c", eq37_lambda_c()),
        ("phi-c", libm::asin(eq37_lambda_c())),
        ("slip-end-fig-4", slip_end(FRAC_1_SQRT_2)),
        ("slip-end-0.6", slip_end(0.6)),
        ("slip-end-0.9", slip_end(0.9)),
        ("x-Y", libm::sqrt(q_y * q_y - 1.0)),
        ("q-Y", q_y),
        ("lambda-Y", 1.0 / q_y),
        ("A-2", curve_a(2.0).unwrap()),
        ("A-6", curve_a(6.0).unwrap()),
        ("A-12", curve_a(12.0).unwrap()),
        ("B-2", curve_b(2.0).unwrap().unwrap()),
        ("B-3", curve_b(3.0).unwrap().unwrap()),
        ("E-6", curve_e(6.0).unwrap().unwrap()),
        ("E-12", curve_e(12.0).unwrap().unwrap()),
        ("escape-rho", escape::rho(1.0)),
        ("escape-s", escape::s(1.0)),
        ("escape-A", escape::a(1.0)),
        ("escape-turns", escape::winding()),
        ("escape-delay", escape::delay()),
    ];
    for (name, found) in other {
        let certain = certain(name);
        assert!(
            (found - certain).abs() < 1e-11,
            "{name}: {found}, {certain}"
        );
    }
    // A difference of curves has fewer digits: what is left out is odd in the distance, and cancels.
    let (contact, found) = (certain("contact-Y"), 0.5 * (touch(1e-3) + touch(-1e-3)));
    assert!(
        (found - contact).abs() < 1e-5 * contact,
        "{found}, {contact}"
    );
    let names: BTreeSet<_> = other
        .iter()
        .map(|(name, _)| *name)
        .chain(["contact-Y"])
        .collect();
    assert_eq!(names, values().iter().map(|value| value.name).collect());
}
