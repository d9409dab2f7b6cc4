//! The recorded maps of fates: whole, proved again in places, and as the motion has it.

use slipbook::claims::rest::fates::{REACH, Row, open, recorded};
use slipbook::motion::turntable::{Start, fate::rests};
use std::f64::consts::PI;

fn maps() -> Vec<Vec<Row>> {
    recorded().expect("a table of maps")
}

#[test]
fn the_strips_are_the_whole_plane_and_little_is_left_open() {
    let maps = maps();
    let all: Vec<f64> = maps.iter().map(|map| map[0].a).collect();
    assert_eq!(all, [0.5, 0.7, 0.9]);
    for map in &maps {
        // From −π to π or a little beyond, without a gap.
        assert!(map[0].psi[0] < -PI && map[map.len() - 1].psi[1] > PI);
        for (row, next) in map.iter().zip(&map[1..]) {
            assert_eq!((row.psi[1], row.line[1]), (next.psi[0], next.line[0]));
        }
        for row in map {
            assert!(row.psi[0] < row.psi[1], "{row:?}");
            assert!(
                row.line.iter().all(|line| 0.0 < *line && *line < REACH),
                "{row:?}"
            );
            for margin in [row.margins.rest, row.margins.escape] {
                assert!(0.0 < margin && margin < 1.0, "{row:?}");
            }
        }
        assert!(open(map) < 1e-3, "A = {}: {}", map[0].a, open(map));
    }
}

/// Every so many rows: what is recorded is what the proof gives, to the last bit.
#[test]
fn rows_are_proved_again() {
    for map in maps() {
        for row in map.iter().skip(5).step_by(map.len() / 2) {
            assert_eq!(row.strip().margins(), row.margins, "{row:?}");
        }
    }
}

/// Newton's law, without intervals, says the same of starts on both sides, most of them near the line.
#[test]
fn the_motion_ends_as_is_proved() {
    let mut random = fastrand::Rng::with_seed(25);
    for map in maps() {
        let a = map[0].a;
        let (mut starts, mut expected) = (Vec::new(), Vec::new());
        for row in map.iter().flat_map(|row| [row; 20]) {
            let psi = row.psi[0] + random.f64() * (row.psi[1] - row.psi[0]);
            let [rest, escape] = row.proved(psi);
            let near = libm::pow(random.f64(), 6.0);
            for (alpha, rests) in [
                (rest * (1.0 - near), true),
                (escape + near * (REACH - escape), false),
            ] {
                if alpha > 1e-6 {
                    starts.push(Start::hyperbolic(a, alpha, psi).unwrap());
                    expected.push(rests);
                }
            }
        }
        assert!(starts.len() > 2000);
        for (start, expected) in starts.iter().zip(expected) {
            assert_eq!(rests(start).unwrap(), Some(expected), "{start:?}");
        }
    }
}
