//! The turntable.

use super::*;
use crate::claims::solve::turntable::{Moment, Problem};

#[test]
fn fates_on_the_table() {
    let polar = |rho, p, psi| Problem::Polar { rho, p, psi };
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
    let polar = Problem::Polar { rho, p, psi };
    let hyperbolic = Problem::Hyperbolic {
        a: (rho * rho - p * p).sqrt(),
        alpha: (p / rho).atanh(),
        psi,
    };
    let cartesian = Problem::Cartesian {
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
    let at = |rho, p, psi, tau| Problem::Polar { rho, p, psi }.at(tau).unwrap();
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
fn psi_is_the_angle_from_the_velocity_to_the_position() {
    for place in [-2.9, -1.0, 0.4, 2.2] {
        for psi in [-3.0, -1.2, 0.0, 0.7, 2.5] {
            let heading: f64 = place - psi;
            let moment = Moment {
                position: [2.0 * libm::cos(place), 2.0 * libm::sin(place)],
                velocity: [0.3 * heading.cos(), 0.3 * heading.sin()],
            };
            assert!((moment.psi() - psi).abs() < 1e-15 * 8.0, "{place} {psi}");
        }
    }
}
