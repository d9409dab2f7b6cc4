//! The arcs by the formulas alone, of `benches/workloads`, held against the motion.

#[path = "../../benches/workloads/row.rs"]
mod row;

use row::*;
use slipbook::motion::drive::{Drive, DriveState, Friction, Interval, Sign};
use slipbook::paper::sinusoidal;
use std::f64::consts::{PI, TAU};

fn moved(intervals: &[Interval], sign: Sign, near: [f64; 2]) -> [f64; 2] {
    let found = intervals.iter().find(|i| i.sign == sign);
    found.map_or([near[1]; 2], |i| {
        let turn = TAU * libm::round((near[0] - i.start) / TAU);
        [i.start + turn, i.start + turn + i.length()]
    })
}

#[test]
fn arcs_are_those_of_the_motion() {
    let drive = Drive::new(libm::sin, &[]).unwrap();
    let columns: Vec<_> = (0..150)
        .map(|i| 1.0 + 0.04 * f64::from(i))
        .map(|q| (q, Column::new(q).unwrap()))
        .collect();
    let (mut forward_only, mut both) = (0, 0);
    for j in 0..50 {
        let lambda0 = 0.011 + 0.0211 * f64::from(j);
        let mut row = Row::new(lambda0).unwrap();
        let mut found = Vec::new();
        row.fill(
            &columns.iter().map(|(_, c)| *c).collect::<Vec<_>>(),
            &mut found,
        );
        for ((q, _), arcs) in columns.iter().zip(found) {
            let friction = Friction::new(lambda0, q * lambda0).unwrap();
            let outcome = drive.attractor(friction, DriveState { phi: 0.0, w: 0.0 }, 1000);
            let motion = outcome.unwrap().settled().unwrap();
            let intervals = motion.intervals();
            for (sign, arc) in [
                (Sign::Positive, arcs.forward),
                (Sign::Negative, arcs.backward),
            ] {
                for (a, b) in arc.iter().zip(moved(intervals, sign, arc)) {
                    assert!(
                        (a - b).abs() < 1e-10,
                        "{q} {lambda0} {arcs:?} {intervals:?}"
                    );
                }
            }
            let wait = arcs.backward[0] - arcs.forward[1];
            assert!(
                (0.0..PI).contains(&arcs.forward[0]),
                "{q} {lambda0} {arcs:?}"
            );
            assert!((-1e-14..TAU).contains(&wait), "{q} {lambda0} {arcs:?}");
            forward_only += usize::from(arcs.backward[0] == arcs.backward[1]);
            both += usize::from(arcs.backward[0] < arcs.backward[1]);
        }
    }
    assert!(forward_only > 1000 && both > 1000, "{forward_only} {both}");
}

#[test]
fn the_end_of_a_slip_is_found_from_any_guess() {
    for lambda in [1e-6, 1e-3, 0.05, 0.3, 0.6, 0.8, 0.95, 0.99] {
        let fastest = sinusoidal::eq28_phi2(lambda);
        let first = PI - fastest;
        for part in [0.0, 0.2, 0.5, 0.9] {
            let start = first + part * (fastest - first);
            let w = |x: f64| libm::cos(start) - libm::cos(x) - lambda * (x - start);
            let (mut low, mut high) = (fastest, start + TAU);
            for _ in 0..200 {
                let middle = 0.5 * (low + high);
                *(if w(middle) > 0.0 { &mut low } else { &mut high }) = middle;
            }
            for guess in [
                -20.0,
                start - 1e-9,
                start,
                start + 0.01,
                first,
                0.5 * PI,
                fastest,
                fastest + 1e-9,
                3.0,
                4.0,
                5.0,
                6.2,
                start + TAU - 1e-6,
                start + TAU,
                40.0,
                f64::NAN,
            ] {
                let end = slip_end(lambda, start, libm::cos(start), guess);
                // What rounding of w can move the root.
                let room = 1e-14 + 4e-16 / (libm::sin(low) - lambda).abs();
                assert!(
                    (end - low).abs() < room,
                    "{lambda} {start} {guess}: {end} {low}"
                );
            }
        }
    }
}

#[test]
fn the_end_of_a_slip_is_found_where_every_other_step_has_to_halve_the_bracket() {
    // From this guess steps without a halving run in a circle.
    let (lambda, start, guess) = (0.9367950615036835, 1.213354850618772, 1.213354850619964);
    let end = slip_end(lambda, start, libm::cos(start), guess);
    assert!((end - 2.290371042685266).abs() < 1e-13, "{end}");
}

#[test]
fn the_shortest_backward_slips_are_not_missed() {
    // Shortly before the drive is strongest, and that is hardly strong enough.
    let mut row = Row::new(0.226).unwrap();
    assert!(row.forward[1] > 1.5 + PI && row.forward[1] < 1.5 * PI);
    let q = 0.9999 / 0.226;
    let arcs = row.at(&Column::new(q).unwrap());
    let length = arcs.backward[1] - arcs.backward[0];
    let problem = slipbook::solve::anisotropic::AnisotropicProblem { q, lambda0: 0.226 };
    let period = problem.solve().unwrap().best;
    assert_eq!(period.region, "III");
    assert!(
        (length - period.negative).abs() < 1e-10,
        "{length} {period:?}"
    );
    // Three times as long as the drive takes from λ₋ to its height.
    let rise = libm::acos(0.9999);
    assert!((length / rise - 3.0).abs() < 1e-3, "{length} {rise}");
}
