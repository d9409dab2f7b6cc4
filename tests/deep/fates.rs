//! The recorded maps of fates, in the deep tier: whole, nearly without a gap, in agreement with simulation, and provable again.

use slipbook::claims::rest::fates::{ROUND, Row, open, recorded};
use slipbook::motion::turntable::{Start, fate::rests};
use slipbook::validated::turntable::Margins;

fn maps() -> Vec<Vec<Row>> {
    recorded().unwrap()
}

#[test]
fn three_sections_are_covered_all_round_and_a_thousandth_is_open() {
    let maps = maps();
    let of: Vec<f64> = maps.iter().map(|map| map[0].a).collect();
    assert_eq!(of, [0.7, 0.8, 0.9]);
    for map in &maps {
        assert_eq!((map[0].psi[0], map[map.len() - 1].psi[1]), (-ROUND, ROUND));
        for pair in map.windows(2) {
            assert_eq!(pair[0].psi[1], pair[1].psi[0]);
        }
        assert!(open(map) < 1e-3, "{}", open(map));
        for row in map {
            let shares = [row.rest, row.escape];
            assert!(shares.iter().all(|share| *share > 0.0 && *share < 1.0));
        }
    }
}

#[test]
fn simulation_agrees_just_inside_what_is_proved() {
    for row in maps().concat() {
        let middle = |ends: [f64; 2]| 0.5 * (ends[0] + ends[1]);
        let (inside, outside) = (middle(row.rests()), middle(row.escapes()));
        let sides = [
            (inside, true),
            (0.9 * inside, true),
            (outside, false),
            (1.1 * outside, false),
        ];
        for (alpha, expected) in sides {
            let start = Start::hyperbolic(row.a, alpha, middle(row.psi)).unwrap();
            assert_eq!(
                rests(&start).unwrap(),
                Some(expected),
                "{row:?}, α = {alpha}"
            );
        }
    }
}

#[test]
fn a_strip_of_each_map_is_proved_again_from_nothing() {
    for map in maps() {
        // Near ψ = 0, where the steps are few.
        let row = map[map.len() / 2];
        let again = row.strip().margins(Margins::NONE, row.margins());
        assert_eq!(again, row.margins(), "{row:?}");
    }
}
