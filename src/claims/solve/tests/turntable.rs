//! The turntable.

use super::*;
use crate::claims::solve::turntable::{Moment, TurntableProblem};

#[test]
fn fates_on_the_table() {
    let polar = |rho, p, psi| TurntableProblem::Polar { rho, p, psi };
    // ρ, p, ψ; σ, τ.
    for ([rho, p, psi], [sigma, tau]) in [
        ([0.5, 0.3, 1.0], [0.5388513871127943, 0.47019289739479453]),
        ([0.3, 0.3, -2.0], [0.29993733072794343, 0.3249383022484465]),
        ([0.0, 0.6, 0.0], [0.18973897668648543, 0.6788828245194629]),
        ([0.9, 0.05, 2.5], [0.8995562314182963, 0.06779762710499142]),
        ([0.2, 0.9, 0.7], [0.6085225770018554, 1.3830539298690765]),
        ([0.7, 0.0, 0.0], [0.7, 0.0]),
        ([1.0, 0.0, 3.0], [1.0, 0.0]),
    ] {
        let answer = polar(rho, p, psi).fate().unwrap();
        assert_eq!(word(&answer), "rest");
        agrees(&answer, &[("sigma", sigma), ("tau_rest", tau)]);
    }
    for start in [
        polar(1.5, 0.2, 1.0),
        polar(1.0 + 1e-9, 0.0, 0.0),
        polar(0.3, 5.0, 0.0),
    ] {
        let answer = start.fate().unwrap();
        assert_eq!((word(&answer), answer.digits), ("escape", None));
    }
}

#[test]
fn the_three_ways_to_give_a_start_agree() {
    let (rho, p, psi): (f64, f64, f64) = (0.5, 0.3, 1.0);
    let polar = TurntableProblem::Polar { rho, p, psi };
    let hyperbolic = TurntableProblem::Hyperbolic {
        a: (rho * rho - p * p).sqrt(),
        alpha: (p / rho).atanh(),
        psi,
    };
    let cartesian = TurntableProblem::Cartesian {
        position: [0.0, rho],
        velocity: [p * psi.sin(), p * psi.cos()],
    };
    for other in [hyperbolic, cartesian] {
        agrees(
            &other.fate().unwrap(),
            &[("sigma", polar.fate().unwrap().best.sigma.unwrap())],
        );
    }
}

#[test]
fn moments_on_the_table() {
    let at = |rho, p, psi, tau| TurntableProblem::Polar { rho, p, psi }.at(tau).unwrap();
    agrees(
        &at(0.5, 0.3, 1.0, 0.2),
        &[
            ("x", 0.523613356567098),
            ("y", -0.0389484305275615),
            ("vx", 0.08327200512389173),
            ("vy", -0.13286626923551856),
        ],
    );
    agrees(
        &at(2.0, 1.0, 1.0, 5.0),
        &[
            ("x", -8.03132415136837),
            ("y", -3.898400950430977),
            ("vx", -4.891269942423172),
            ("vy", 4.692322631067637),
        ],
    );
    agrees(
        &at(0.5, 0.3, 1.0, 0.0),
        &[
            ("x", 0.5),
            ("y", 0.0),
            ("rho", 0.5),
            ("p", 0.3),
            ("psi", 1.0),
        ],
    );
    agrees(
        &at(0.5, 0.3, 1.0, 3.0),
        &[("rho", 0.5388513871127943), ("p", 0.0), ("psi", 0.0)],
    );
}

#[test]
fn a_start_from_rest_goes_straight_out_wherever_it_is() {
    for angle in [0.3, 1.7, 3.0, -2.2_f64] {
        let out = [angle.cos(), angle.sin()];
        let start = TurntableProblem::Cartesian {
            position: out.map(|c| 2.0 * c),
            velocity: [0.0; 2],
        };
        for tau in [1e-25, 1e-6] {
            let soon = start.at(tau).unwrap().best;
            // ρ − 1 is what the centrifugal force has to spare.
            assert!(
                (soon.p / tau - 1.0).abs() < 1e-5,
                "{angle} {tau}: {}",
                soon.p
            );
            for (found, out) in soon.velocity.iter().zip(out) {
                let off = (found - soon.p * out).abs();
                assert!(off < 1e-5 * soon.p, "{angle} {tau}: {:?}", soon.velocity);
            }
        }
    }
}

#[test]
fn rest_has_no_angle_whatever_the_signs_of_its_zeros() {
    for (x, y) in [(-0.5, -0.3), (0.5, 0.0), (-0.5, 0.0), (0.0, 0.0)] {
        for zero in [0.0, -0.0] {
            let start = TurntableProblem::Cartesian {
                position: [x, y],
                velocity: [zero, -zero],
            };
            let answer = start.at(1.0).unwrap();
            assert_eq!((answer.best.psi, answer.digits), (0.0, Some(15)), "{x} {y}");
        }
    }
    let mut rng = fastrand::Rng::with_seed(20);
    for _ in 0..40 {
        let start = TurntableProblem::Polar {
            rho: rng.f64(),
            p: rng.f64(),
            psi: 6.0 * rng.f64() - 3.0,
        };
        let answer = start.at(10.0).unwrap();
        assert!(answer.digits >= Some(13), "{start:?} {answer:?}");
    }
}

#[test]
fn a_typed_decimal_is_taken_as_it_stands() {
    // 1 − 0.999999 = 10⁻⁶, as no f64 has it. By an implicit integration in ln p, 1 − ρ and ψ.
    let given = ["0.999999", "0.000001", "0"].map(|text| text.parse::<Double>().unwrap());
    let [rho, p, psi] = given;
    let answer = TurntableProblem::Polar { rho, p, psi }.fate().unwrap();
    assert_eq!(answer.digits, Some(15));
    let tau = answer.best.tau_rest.unwrap();
    assert!((tau - 7.4570627).abs() < 5e-8, "{tau}");
    let near = TurntableProblem::Polar {
        rho: 0.999999,
        p: 0.000001,
        psi: 0.0,
    };
    let tau = near.fate().unwrap().best.tau_rest.unwrap();
    assert!((tau - 7.457041106957004).abs() < 1e-14, "{tau}");
}

#[test]
fn psi_is_the_angle_from_the_velocity_to_the_position() {
    for place in [-2.9, -1.0, 0.4, 2.2] {
        for psi in [-3.0, -1.2, 0.0, 0.7, 2.5] {
            let heading: f64 = place - psi;
            let position = [2.0 * libm::cos(place), 2.0 * libm::sin(place)];
            let moment = Moment::of(position, [0.3 * heading.cos(), 0.3 * heading.sin()]);
            assert!((moment.psi - psi).abs() < 1e-15 * 8.0, "{place} {psi}");
        }
    }
}
