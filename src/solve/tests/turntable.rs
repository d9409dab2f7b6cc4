//! The turntable.

use crate::solve::turntable::{Moment, TurntableProblem};

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
