//! What is said of a periodic motion, held against the motion itself, phase by phase.

use slipbook::motion::drive::{Attractor, Drive, DriveState, Friction, Interval, Margins, Sign};
use std::f64::consts::{PI, TAU};

type Shape = fn(f64) -> f64;

const SHAPES: [(&str, Shape, &[f64]); 7] = [
    ("sine", |x| libm::sin(x), &[]),
    (
        "two sines",
        |x| libm::sin(x) + 0.8 * libm::sin(3.0 * x + 0.4),
        &[],
    ),
    ("square", |x| if x < PI { 1.0 } else { -1.0 }, &[PI]),
    (
        "sawtooth",
        |x| if x < PI { 1.0 - x / PI } else { x / PI - 2.0 },
        &[PI],
    ),
    (
        "steps",
        |x| [0.91, -0.23, 0.68, -0.84, 0.13, -0.69][(x / PI * 3.0) as usize % 6],
        &[PI / 3.0, 2.0 * PI / 3.0, PI, 4.0 * PI / 3.0, 5.0 * PI / 3.0],
    ),
    (
        "rising steps",
        |x| {
            if x < 2.0 {
                0.2 + 0.3 * x
            } else if x < 4.0 {
                -0.9 + 0.1 * x
            } else {
                0.4 - 0.2 * x
            }
        },
        &[2.0, 4.0],
    ),
    (
        "pulses",
        |x| {
            if x < 1.0 {
                1.0
            } else if (PI..PI + 1.0).contains(&x) {
                -1.0
            } else {
                0.0
            }
        },
        &[1.0, PI, PI + 1.0],
    ),
];

const FRICTIONS: [(f64, f64); 9] = [
    (0.05, 0.05),
    (0.1, 0.3),
    (0.3, 0.1),
    (0.5, 0.5),
    (0.7, 0.4),
    (0.4, 0.7),
    (0.95, 0.95),
    (1.3, 0.2),
    (1.9, 2.0),
];

const STEPS: usize = 20_000;

/// From one phase looked at to the next, but at a jump.
const JUMP: f64 = 1e-2;

fn seen(drive: &Drive, found: &Attractor) -> Margins {
    let (list, friction) = (found.intervals(), found.friction());
    let mut margins = Margins {
        shortest: f64::INFINITY,
        dip: f64::INFINITY,
        crossing: f64::INFINITY,
        hold: f64::INFINITY,
    };
    let phases = |i: &Interval| -> Vec<f64> {
        (1..STEPS)
            .map(|k| i.start + i.length() * k as f64 / STEPS as f64)
            .collect()
    };
    for (k, interval) in list.iter().enumerate() {
        if list.len() > 1 {
            margins.shortest = margins.shortest.min(interval.length());
        }
        let before = list[if k == 0 { list.len() - 1 } else { k - 1 }].sign;
        // At a jump the side of the new motion counts.
        let pull = drive.h(interval.start + 1e-9);
        let excess = match (before, interval.sign) {
            (Sign::Negative, Sign::Positive) => pull - friction.plus(),
            (Sign::Positive, Sign::Negative) => -pull - friction.minus(),
            _ => f64::INFINITY,
        };
        margins.crossing = margins.crossing.min(excess);
        let side = match interval.sign {
            Sign::Positive => 1.0,
            Sign::Negative => -1.0,
            Sign::Rest => 0.0,
        };
        let value = |phi: &f64| {
            if side == 0.0 {
                drive.h(*phi)
            } else {
                side * found.w(*phi)
            }
        };
        // The last value before a jump counts.
        let after = (side == 0.0).then_some(interval.end + 1e-9);
        let mut values: Vec<_> = phases(interval).iter().chain(&after).map(value).collect();
        if list.len() == 1 {
            values.extend_from_within(..2);
        }
        for three in values.windows(3) {
            let (up, down) = (three[1] - three[0], three[2] - three[1]);
            if side == 0.0 && (up * down < 0.0 || (up == 0.0) != (down == 0.0) || down.abs() > JUMP)
            {
                let room = (friction.plus() - three[1]).min(friction.minus() + three[1]);
                margins.hold = margins.hold.min(room.max(0.0));
            } else if side != 0.0 && up < 0.0 && down >= 0.0 {
                margins.dip = margins.dip.min(three[1].max(0.0));
            }
        }
    }
    margins
}

#[test]
fn the_margins_are_those_of_the_motion_looked_at() {
    let mut kinds = [0; 4];
    for (name, shape, breaks) in SHAPES {
        let drive = Drive::new(shape, breaks).unwrap();
        for (plus, minus) in FRICTIONS {
            let friction = Friction::new(plus, minus).unwrap();
            let start = DriveState { phi: 0.3, w: 0.1 };
            let Some(found) = drive.attractor(friction, start, 400).unwrap().settled() else {
                continue;
            };
            let (told, seen) = (found.margins(), seen(&drive, &found));
            let pairs = [
                ("shortest", told.shortest, seen.shortest),
                ("dip", told.dip, seen.dip),
                ("crossing", told.crossing, seen.crossing),
                ("hold", told.hold, seen.hold),
            ];
            for (i, (margin, told, seen)) in pairs.into_iter().enumerate() {
                let same = told == seen || (told - seen).abs() < 1e-3;
                assert!(
                    same,
                    "{name}, λ₊ = {plus}, λ₋ = {minus}: {margin} {told}, seen {seen}; {:?}",
                    found.intervals()
                );
                kinds[i] += usize::from(seen.is_finite());
            }
        }
    }
    assert!(kinds.iter().all(|n| *n >= 5), "{kinds:?}");
}

/// Every motion that these shapes and frictions settle to, from this phase.
fn settled(phi: f64) -> Vec<(String, Vec<Interval>)> {
    let mut all = Vec::new();
    for (name, shape, breaks) in SHAPES {
        let drive = Drive::new(shape, breaks).unwrap();
        for (plus, minus) in FRICTIONS {
            let friction = Friction::new(plus, minus).unwrap();
            let outcome = drive
                .attractor(friction, DriveState { phi, w: 0.1 }, 400)
                .unwrap();
            if let Some(found) = outcome.settled() {
                let name = format!("{name}, λ₊ = {plus}, λ₋ = {minus}, from {phi}");
                all.push((name, found.intervals().to_vec()));
            }
        }
    }
    all
}

#[test]
fn a_period_is_listed_once_from_where_it_is_said_to_begin() {
    for (name, list) in settled(0.3) {
        let (first, last) = (&list[0], &list[list.len() - 1]);
        assert!((0.0..TAU).contains(&first.start), "{name}: {list:?}");
        assert!(
            (last.end - first.start - TAU).abs() < 1e-13,
            "{name}: {list:?}"
        );
        for pair in list.windows(2) {
            assert!(
                (pair[0].end - pair[1].start).abs() < 1e-13 && pair[0].sign != pair[1].sign,
                "{name}: {list:?}"
            );
        }
        if list.len() == 1 {
            continue;
        }
        let rank = |i: usize| match (list[(i + list.len() - 1) % list.len()].sign, list[i].sign) {
            (Sign::Rest, Sign::Positive) => 0,
            (Sign::Rest, _) => 1,
            (Sign::Negative, Sign::Positive) => 2,
            _ => 3,
        };
        let place = |i: usize| (rank(i), list[i].start.rem_euclid(TAU));
        let best = (0..list.len())
            .map(place)
            .min_by(|a, b| a.partial_cmp(b).unwrap());
        assert_eq!(best, Some(place(0)), "{name}: {list:?}");
    }
}

#[test]
fn the_list_of_a_period_does_not_depend_on_where_the_motion_was_begun() {
    let from_the_start = settled(0.3);
    for phi in [0.0, 1.7, 2.6, 4.0, 5.9] {
        for ((name, a), (_, b)) in settled(phi).iter().zip(&from_the_start) {
            let signs = |list: &[Interval]| list.iter().map(|i| i.sign).collect::<Vec<_>>();
            assert_eq!(signs(a), signs(b), "{name}: {a:?}, {b:?}");
            for (a, b) in a.iter().zip(b) {
                // A motion that is not at rest in the period settles only in the limit.
                assert!(
                    (a.start - b.start).abs() < 1e-9 && (a.end - b.end).abs() < 1e-9,
                    "{name}: {a:?}, {b:?}"
                );
            }
        }
    }
}

/// h = 1, then −b on [1, 2], 1 again to 3, then −1, with λ₊ = 0.3: w at 2 is 0.4 − b.
#[test]
fn a_motion_grazes_where_it_just_touches_zero() {
    for (b, grazes) in [
        (0.4, true),
        (0.4 - 1e-6, false),
        (0.4 + 1e-6, false),
        (0.2, false),
    ] {
        let h = move |x: f64| match x {
            x if x < 1.0 => 1.0,
            x if x < 2.0 => -b,
            x if x < 3.0 => 1.0,
            _ => -1.0,
        };
        let drive = Drive::new(h, &[1.0, 2.0, 3.0]).unwrap();
        let friction = Friction::new(0.3, 1.5).unwrap();
        let found = drive
            .attractor(friction, DriveState { phi: 0.0, w: 0.0 }, 200)
            .unwrap();
        assert_eq!(found.settled().unwrap().grazes(), grazes, "b = {b}");
    }
}

#[test]
fn a_settled_motion_is_as_certain_as_it_says() {
    let drive = Drive::new(libm::sin, &[]).unwrap();
    for lambda in [0.05, 0.2, 0.4] {
        let friction = Friction::new(lambda, 1.1 * lambda).unwrap();
        let from = |w| {
            drive
                .attractor(friction, DriveState { phi: 0.0, w }, 1000)
                .unwrap()
                .settled()
                .unwrap()
        };
        let (a, b) = (from(3.0), from(-3.0));
        let apart =
            (0..100).map(|k| (a.w(0.0628 * f64::from(k)) - b.w(0.0628 * f64::from(k))).abs());
        let apart = apart.fold(0.0, f64::max);
        assert!(
            apart <= a.uncertainty() + b.uncertainty(),
            "{lambda}: {apart:e}"
        );
        assert!(
            a.uncertainty() < 1e-11 && a.uncertainty() > 0.0,
            "{lambda}: {:e}",
            a.uncertainty()
        );
    }
    // Nothing draws a motion without friction to another one.
    let free = Friction::new(0.0, 0.0).unwrap();
    let found = drive
        .attractor(free, DriveState { phi: 0.0, w: 0.7 }, 100)
        .unwrap()
        .settled()
        .unwrap();
    assert_eq!(found.uncertainty(), f64::INFINITY);
}

#[test]
fn the_periods_to_the_large_time_motion_are_those_that_it_takes() {
    let mut kinds = [0; 2];
    for (name, shape, breaks) in SHAPES {
        let drive = Drive::new(shape, breaks).unwrap();
        for (plus, minus) in FRICTIONS {
            let friction = Friction::new(plus, minus).unwrap();
            for w in [0.0, 0.4, 3.0, -4.0, 25.0, -60.0] {
                let start = DriveState { phi: 0.3, w };
                let outcome = drive.attractor(friction, start, 1000).unwrap();
                let Some(found) = outcome.settled() else {
                    continue;
                };
                let mut state = start;
                let mut counted = 0_u64;
                loop {
                    counted += 1;
                    let end = drive.advance(friction, state, state.phi + TAU).unwrap().end;
                    let change = (end.w - state.w).abs();
                    state = DriveState { phi: 0.3, w: end.w };
                    if change <= 1e-12 * drive.shape().size() {
                        break;
                    }
                }
                let told = found.periods().plain.unwrap();
                let room = 2.max(counted / 5);
                assert!(
                    told.abs_diff(counted) <= room,
                    "{name}, λ₊ = {plus}, λ₋ = {minus}, from {w}: {told}, counted {counted}"
                );
                kinds[usize::from(found.contraction() > 0.0)] += 1;
            }
        }
    }
    assert!(kinds.iter().all(|n| *n > 20), "{kinds:?}");
}
