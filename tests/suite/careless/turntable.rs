//! The turntable, in all its axes.

use super::{any, config, each, finite, on_the_way, or_zeros};
use proptest::prelude::*;
use slipbook::motion::{
    turntable::ensemble::{End, Horizon},
    turntable::fate::rests,
    turntable::{
        Fate, Start, State, Table, boundary, boundary::between, fate, inertial, intrinsic, rotating,
    },
};

fn start() -> impl Strategy<Value = Start> {
    prop_oneof![
        each().prop_filter_map("out of range", |[rho, p, psi]| Start::polar(rho, p, psi)
            .ok()),
        each().prop_filter_map("out of range", |[a, alpha, psi]| Start::hyperbolic(
            a, alpha, psi
        )
        .ok()),
        each().prop_filter_map("out of range", |[x, y, u, v]| Start::cartesian(
            [x, y],
            [u, v]
        )
        .ok()),
        any().prop_filter_map("out of range", |rho| Start::put_down(rho).ok()),
        any().prop_filter_map("out of range", |speed| Start::launched(speed).ok()),
        each().prop_map(|[p, xi, zeta]| Start { p, xi, zeta }),
    ]
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn a_fate_has_numbers(start in start()) {
        match fate(&start) {
            Ok(Fate::Rest { sigma, tau, error, .. }) => prop_assert!(finite(&[sigma, tau, error])),
            Ok(Fate::Escape { tau, .. }) => prop_assert!(tau.is_finite()),
            Ok(Fate::Undecided { tau, p }) => prop_assert!(finite(&[tau, p])),
            Err(_) => {}
        }
        let _ = rests(&start);
    }

    #[test]
    fn an_ensemble_ends_with_numbers(starts in prop::collection::vec(start(), 0..40), [rho, tau] in each()) {
        for horizon in [Horizon { rho, tau }, Horizon { rho: 100.0, tau: 50.0 }] {
            let Ok(ends) = horizon.follow_alone(&starts) else { continue };
            prop_assert_eq!(ends.len(), starts.len());
            for end in ends.into_iter().flatten() {
                prop_assert!(match end {
                    End::Rest { sigma, tau, .. } => finite(&[sigma, tau]),
                    End::Far { tau, .. } => tau.is_finite(),
                    End::Late(start) | End::Unfinished(start) => finite(&[start.p, start.xi, start.zeta]),
                }, "{end:?}");
            }
        }
    }

    #[test]
    fn a_path_has_numbers([omega, mu, g, mass] in each(), [t, x, y, until] in each(), [u, v] in or_zeros(), part in 0.0..=1.0) {
        let start = State { t, x: [x, y], v: [u, v] };
        for table in [Table { omega, mu, g, mass }, Table::default()] {
            for until in [until, t + 1.0] {
                for path in [rotating::run(&table, &start, until), inertial::run(&table, &start, until)].into_iter().flatten() {
                    let at = on_the_way(t, path.end(), part);
                    for state in [path.at(at), path.on_table(at), path.at(path.end())] {
                        prop_assert!(state.is_ok_and(|s| finite(&s.x) && finite(&s.v)), "{table:?} {start:?} {at}");
                    }
                    prop_assert!(finite(path.stops()) && path.resting_place().is_none_or(|x| finite(&x)));
                }
            }
        }
    }

    #[test]
    fn a_run_has_numbers(start in start(), until in any(), at in any()) {
        if let Ok(run) = intrinsic::Run::new(&start, until) {
            let states = [run.end()].into_iter().chain(run.at(at)).chain(run.nodes());
            for state in states {
                prop_assert!(finite(&[state.tau, state.p(), state.rho(), state.psi(), state.lag(), state.turned, state.s]), "{state:?}");
            }
        }
    }

    #[test]
    fn a_boundary_is_a_number([alpha, psi, rest, escape, width] in each()) {
        let ends = [boundary(alpha, psi), between(Start::put_down, rest, escape, width), between(Start::launched, rest, escape, width)];
        for end in ends.into_iter().flatten() {
            prop_assert!(end.is_finite());
        }
    }
}
