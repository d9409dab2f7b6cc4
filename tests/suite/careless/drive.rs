//! The periodic drive along a line, and in the plane.

use super::{SHAPES, any, config, each, finite, some};
use proptest::prelude::*;
use slipbook::motion::drive::{Drive, DriveState, Friction, Outcome, PlanarState};

proptest! {
    #![proptest_config(config())]

    #[test]
    fn a_driven_motion_has_numbers(
        [a, b, plus, minus, phi, w, until, ln_w_y] in each(), breaks in some(2), phases in some(3), shape in 0..SHAPES.len(),
    ) {
        let Ok(drive) = Drive::new(|x| SHAPES[shape](a, b, x), &breaks) else { return Ok(()) };
        prop_assert!(finite(&[drive.mean(), drive.resolution()]));
        let friction = Friction::new(plus, minus).or(Friction::new(0.3, 0.5)).unwrap();
        let start = DriveState { phi, w };
        for until in [until, phi + 7.0] {
            if let Ok(path) = drive.advance(friction, start, until) {
                prop_assert!(finite(&[path.end.phi, path.end.w, path.contraction]), "{drive:?} {friction:?} {start:?}");
                prop_assert!(path.intervals.iter().all(|part| finite(&[part.start, part.end])));
            }
        }
        if let Ok(values) = drive.strobe(friction, start, 20) {
            prop_assert!(finite(&values), "{drive:?} {friction:?} {start:?}");
        }
        match drive.attractor(friction, start, 60) {
            Ok(Outcome::Settles(found)) => {
                let margins = found.margins();
                let all = [margins.shortest, margins.dip, margins.crossing, margins.hold, found.uncertainty()];
                prop_assert!(!all.iter().any(|x| x.is_nan()), "{found:?}");
                prop_assert!(finite(&[found.displacement(), found.largest().w, found.residual(), found.contraction()]), "{found:?}");
                prop_assert!(!until.is_finite() || found.w(until).is_finite(), "{found:?} {until}");
            }
            Ok(Outcome::Drifts { per_period }) => prop_assert!(per_period.is_finite()),
            Err(_) => {}
        }
        if let Ok(agreement) = drive.attractors_agree(friction, &[start, DriveState { phi: 1.0, w: 0.5 }], 60) {
            prop_assert!(agreement.largest_difference.is_finite());
        }
        let phases: Vec<_> = [phi, phi + 1.0].into_iter().chain(phases).collect();
        if let Ok(states) = drive.planar(plus, PlanarState { phi, w_x: w, ln_w_y }, &phases) {
            prop_assert!(states.iter().all(|s| finite(&[s.phi, s.w_x]) && !s.ln_w_y.is_nan()), "{states:?}");
        }
    }

    #[test]
    fn a_friction_is_one_or_named(plus in any(), minus in any()) {
        if let Ok(friction) = Friction::new(plus, minus) {
            prop_assert!(finite(&[friction.plus(), friction.minus()]));
        }
    }
}
