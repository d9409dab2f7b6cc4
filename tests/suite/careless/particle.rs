//! A particle on the plane, on accelerations of all kinds.

use super::{any, config, each, finite, on_the_way, or_zeros, some};
use proptest::prelude::*;
use slipbook::motion::{
    Acceleration, Launch, Motion, Plane, Signal, State, onset, run, run_to_stop,
};

fn signal() -> impl Strategy<Value = Signal> {
    let alone = prop_oneof![
        some(4).prop_map(Signal::Polynomial),
        any().prop_map(|rate| Signal::Exponential { rate }),
        each().prop_map(|[frequency, phase]| Signal::Sine { frequency, phase }),
        each().prop_map(|[centre, width]| Signal::Gaussian { centre, width }),
        each().prop_map(|[scale, exponent]| Signal::Power { scale, exponent }),
        each().prop_map(|[start, half]| Signal::Square { start, half }),
        each().prop_map(|[from, to]| Signal::Pulse { from, to }),
    ];
    alone.prop_recursive(2, 6, 3, |inner| {
        let several = || prop::collection::vec(inner.clone(), 0..3);
        prop_oneof![
            several().prop_map(Signal::Sum),
            several().prop_map(Signal::Product),
            (inner.clone(), any()).prop_map(|(signal, factor)| signal.times(factor)),
        ]
    })
}

pub fn plane() -> impl Strategy<Value = Plane> {
    prop_oneof![
        (signal(), signal()).prop_map(|(x, y)| Plane { x, y }),
        each().prop_map(Plane::constant),
        (each(), signal()).prop_map(|(direction, signal)| Plane::along(direction, signal)),
        (signal(), each())
            .prop_map(|(size, [frequency, phase])| Plane::rotating(size, frequency, phase)),
    ]
}

fn numbers(state: State) -> bool {
    finite(&[state.t, state.v[0], state.v[1], state.x[0], state.x[1]])
}

fn sound(motion: &Motion, part: f64, direction: [f64; 2]) -> bool {
    let (start, end) = (motion.start(), motion.end());
    let at = motion.at(on_the_way(start.t, end.t, part));
    let along = motion.first_along(direction);
    numbers(start)
        && numbers(end)
        && motion.nodes().all(numbers)
        && at.is_ok_and(numbers)
        && along.ok().flatten().is_none_or(numbers)
        && finite(motion.stops())
        && finite(motion.starts())
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn a_motion_has_numbers(
        plane in plane(), friction in any(), [t, x, y, until] in each(), [u, v] in or_zeros(), part in 0.0..=1.0, direction in each(),
    ) {
        let start = State { t, v: [u, v], x: [x, y] };
        for until in [until, t + 1.0] {
            for motion in [run(&plane, friction, start, until), run_to_stop(&plane, friction, start, until)] {
                prop_assert!(motion.is_err() || motion.is_ok_and(|m| sound(&m, part, direction)));
            }
        }
    }

    #[test]
    fn a_launch_has_numbers([lambda, a, v0, theta0, until] in each(), part in 0.0..=1.0, direction in each()) {
        let Ok(launch) = Launch::new(lambda, a, v0, theta0) else { return Ok(()) };
        prop_assert!(finite(&launch.velocity()));
        for motion in [launch.motion(until), launch.motion(v0 / a), launch.motion_to_rest()] {
            prop_assert!(motion.is_err() || motion.is_ok_and(|m| sound(&m, part, direction)), "{launch:?}");
        }
    }

    #[test]
    fn an_acceleration_can_be_asked_at_any_time(plane in plane(), t in any()) {
        plane.coefficients(t);
        if let Some(next) = plane.next_break(t) {
            prop_assert!(next > t, "{next} after {t}");
        }
    }

    #[test]
    fn first_moments_have_numbers(limit in any(), longest in any(), drive in each::<8>(), elapsed in 0.0..=1.0) {
        let begun = onset(limit, longest.abs(), |m, c| match m {
            0..4 => [drive[2 * m], drive[2 * m + 1]],
            _ => [c[1][m - 1], -c[0][m - 1]],
        });
        if let Ok(begun) = begun {
            prop_assert!(begun.h >= 0.0, "{begun:?}");
            if begun.h.is_finite() {
                prop_assert!(finite(&begun.at(elapsed * begun.h)), "{begun:?}");
            }
        }
    }
}
