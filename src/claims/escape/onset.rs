//! Trials of what section 4 says about escape in words, and of (126), (127).

use super::growth::{A_RATE, ALPHA_RATE, LAG, SIZE, limits};
use super::prelude::*;
use super::straight::{BEYOND_ONE, StraightIn, time_to_stop};
use super::trajectories::{
    Escape, FLIGHTS, Flight, LATE, Launch, OTHER_ESCAPES, OTHER_FLIGHTS, OTHERS_RELAXED,
    RELAXED_RATIOS, Relaxed, a, alpha, rates, relaxed,
};
use crate::motion::turntable::boundary::between;
use crate::motion::turntable::{State, Table, rotating};
use crate::paper::turntable;

fn after_relaxing(subject: Subject, when: &'static str) -> Evidence {
    const RATE: &str = r"$\mathrm d\alpha/\mathrm d\tau$ of the motion when $\psi$ has relaxed";
    Trial::by(
        Integration,
        subject,
        Compared::composed(["(126)", "", ""], [RATE, when, ""]),
        RELAXED,
    )
    .each(relaxed(), Relaxed::at, |relaxed| {
        Ok([
            printed::eq126_alpha_rate(a(&relaxed.state)),
            relaxed.alpha_rate,
            relaxed.alpha_rate.abs(),
        ])
    })
}

fn eq126_order() -> Evidence {
    let trial = Trial::by(
        Limit,
        Printed,
        [
            "(126)",
            r"$\mathrm d\alpha/\mathrm d\tau$ of the motion from $\psi=\psi_1$, in units of $100(\alpha^2+\psi^2)$",
        ],
        FIRST_OMITTED,
    );
    trial.drawn(0..60, |_, points| {
        let alpha0 = points.log_uniform(1e-3, 3e-2);
        let launch = Launch {
            a: points.uniform(0.7, 3.0),
            alpha: alpha0,
            psi: libm::asin(libm::tanh(2.0 * alpha0)),
        };
        let run = Run::new(&launch.start()?, 0.1 * alpha0)?;
        let t = 0.05 * alpha0;
        let [rate] = rates(t, 0.01 * alpha0, |t| Ok([alpha(&run.at(t)?)]))?;
        let now = run.at(t)?;
        let small = alpha(&now);
        Ok(Pair {
            at: launch.at(),
            stated: printed::eq126_alpha_rate(a(&now)),
            found: rate,
            scale: 100.0 * (small * small + now.psi() * now.psi()),
        })
    })
}

fn above_one(subject: Subject) -> Evidence {
    Trial::census(
        subject,
        Compared::constant(
            "0 where (127) holds, and with itself elsewhere",
            r"whether a random launch stops or is within $\rho=30$ at $\tau=300$ (1 if so)",
        ),
    )
    .over(launches_around_one(), |launch| {
        let found = stays(&Run::new(&launch.start()?, 300.0)?);
        Ok(Pair::plain(
            launch.at(),
            said_to_stay(launch.a, found),
            found,
        ))
    })
}

fn launches_around_one() -> impl Iterator<Item = Launch> {
    let mut points = Points::here();
    (0..250).map(move |i| Launch {
        a: match i {
            200.. => points.uniform(0.05, 0.95),
            _ if i % 4 == 0 => 1.0 + points.log_uniform(1e-2, 1e-1),
            _ => 1.0 + points.uniform(0.1, 4.0),
        },
        alpha: points.log_uniform(1e-2, 3.0),
        psi: points.uniform(-3.0, 3.0),
    })
}

/// By (127) 0 from such an A, about others it says nothing: what is found.
fn said_to_stay(a: f64, found: f64) -> f64 {
    if a > printed::eq127_least_a() {
        0.0
    } else {
        found
    }
}

/// 1 for a particle that is almost at rest at a moment, or near at the end, else 0.
fn stays(run: &Run) -> f64 {
    let stops = run.nodes().any(|s| s.p() < 1e-9);
    is(stops || run.end().rho() < 30.0)
}

/// −1 if a list of A² falls, 0 if a motion with this end, by p, α and A, neither rests nor escapes, else 1.
fn trend(energies: &[f64], [p, alpha, a]: [f64; 3]) -> f64 {
    let falls = |w: &[f64]| w[1] < w[0] * (1.0 - 1e-14);
    let rests = p < 1e-29 && alpha < 1e-25;
    if energies.windows(2).any(falls) {
        -1.0
    } else if rests || a > 1e4 {
        1.0
    } else {
        0.0
    }
}

/// ψ over ψ₁, which both vanish.
pub(crate) fn relaxed_ratio() -> Evidence {
    let trial = Trial::by(
        Limit,
        Remark,
        [
            r"$\psi_1A/(2A-1)$",
            r"$\psi$ of a motion in which the ratio $\psi/\psi_1$ has relaxed, $\alpha$ below a millionth",
        ],
        RELAXED,
    );
    trial.each(RELAXED_RATIOS.each(), Relaxed::at, |relaxed| {
        let (found, psi1) = (
            relaxed.state.psi(),
            turntable::eq124_psi1(alpha(&relaxed.state)),
        );
        Ok([
            corrected::relaxed_ratio(a(&relaxed.state)) * psi1,
            found,
            found,
        ])
    })
}

fn factor(law: fn(f64) -> f64) -> f64 {
    (law(LATE) - law(1.0)) / libm::log(LATE)
}

fn grown(values: &[f64]) -> usize {
    values.windows(2).filter(|w| w[1] - w[0] > 1.0).count()
}

/// How often a particle stops in Cartesian axes on the table, up to τ = 20.
///
/// # Errors
/// Those of the motion.
pub fn table_stops(straight: &StraightIn) -> Result<usize, MotionError> {
    let (s, c) = libm::sincos(PI - straight.psi);
    let start = State {
        t: 0.0,
        x: [-straight.rho * c, straight.rho * s],
        v: [straight.p, 0.0],
    };
    Ok(rotating::run(&Table::default(), &start, 20.0)?
        .stops()
        .len())
}

attempts![
    eq126_relaxed = after_relaxing(Printed, r" and $\alpha$ is below a millionth"),
    eq126_order,
    above_one_census = above_one(Printed),
    eq127_root = {
        let angles = (0..20).map(|i| 2.8 * (f64::from(i) - 9.5) / 9.5);
        Trial::by(
            Root,
            Printed,
            Compared::one(
                "the bound of (127)",
                "the $A$ at which the motion passes from rest to escape",
            )
            .over(r"$\alpha=10^{-4}$"),
            NEAR_CORNER,
        )
        .over(Points::here().grid(angles), |psi| {
            let launch = |a: f64| Start::hyperbolic(a, 1e-4, psi);
            let found = between(launch, 0.99, 1.01, 1e-6)?;
            Ok(Pair::plain(
                format!("α = 0.0001, ψ = {psi:.6}"),
                printed::eq127_least_a(),
                found,
            ))
        })
    },
    above_one_straight = Trial::census(
        Outside,
        [
            "whether (127) holds at the start (1 if so, for an escape)",
            "what becomes of a particle that comes straight in (0 if it stops)",
        ],
    )
    .each(BEYOND_ONE.each(), StraightIn::at, |straight| {
        let start = libm::sqrt((straight.rho - straight.p) * (straight.rho + straight.p));
        Ok([
            is(start > printed::eq127_least_a()),
            is(table_stops(straight)? == 0),
            1.0,
        ])
    }),
    alpha_by_a_grows = limits(
        Printed,
        (r"$\mathrm d\alpha/\mathrm d\ln A$", |l| {
            l.alpha_rate * SIZE.over.1(l) / A_RATE.1(l)
        }),
        r"the factor that (130) has before $\ln A$",
        factor(printed::eq130_alpha)
    ),
    alpha_grows = limits(
        Printed,
        ALPHA_RATE,
        r"the factor of $\ln\tau$ in (133)",
        factor(printed::eq133_alpha)
    ),
    psi_goes_upright = limits(
        Printed,
        (r"$\psi$", |l| FRAC_PI_2 - LAG.over.1(l)),
        "the limit of (134)",
        FRAC_PI_2 - printed::eq134_lag(LATE * LATE)
    ),
    never_decreases_way = Trial::motion(
        Printed,
        [
            "$A^2$ at the start, and more by $2s$,",
            "$A^2$ at the end, along the motion",
        ],
    )
    .each(FLIGHTS.each(), Flight::at, |flight| {
        let end = flight.run.end();
        let (before, found) = (flight.launch.a * flight.launch.a, end.parts.energy());
        Ok([
            before + 2.0 * printed::s4_a_trend::<f64>() * end.s,
            found,
            found,
        ])
    }),
    never_decreases_census = {
        let trial = Trial::census(
            Printed,
            Compared::constant(
                "1, for growth",
                r"the sign of the change of $A$ ($-1$ if it falls on a step, 0 if at the end $\alpha$ is not small nor $A$ large)",
            ),
        );
        trial.each(OTHER_FLIGHTS.each(), Flight::at, |flight| {
            let energies: Vec<f64> = flight.run.nodes().map(|s| s.parts.energy()).collect();
            let end = flight.run.end();
            Ok([
                printed::s4_a_trend(),
                trend(&energies, [end.p(), alpha(&end), a(&end)]),
                1.0,
            ])
        })
    },
    small_alpha_angle = Trial::by(
        Limit,
        Within,
        [
            r"$\psi_1$",
            r"$\psi$ of the motion when it has relaxed after a start with $\alpha<10^{-11}$",
        ],
        RELAXED,
    )
    .each(OTHERS_RELAXED.each(), Relaxed::at, |relaxed| {
        Ok([
            turntable::eq124_psi1(alpha(&relaxed.state)),
            relaxed.state.psi(),
            1.0,
        ])
    }),
    small_alpha_rate = after_relaxing(Within, r" after a start with $\alpha<10^{-11}$"),
    small_alpha_straight = {
        let trial = Trial::by(
            Integration,
            Outside,
            [
                r"$\psi_1$",
                r"$\psi$ of a motion that comes straight in, when $\alpha$ has fallen below a ten-thousandth",
            ],
            RELAXED,
        );
        trial.each(BEYOND_ONE.each(), StraightIn::at, |straight| {
            let state = straight.with_alpha_below(1e-4);
            Ok([turntable::eq124_psi1(alpha(&state)), state.psi(), 1.0])
        })
    },
    relaxed_ratio,
    relaxed_ratio_rate = {
        let trial = Trial::by(
            Consistency,
            Remark,
            [
                r"the relative rate of $\psi$ by (115) at $\psi=\psi_1A/(2A-1)$ over that of $\alpha$ by (126)",
                "the expected 1",
            ],
            RELAXED,
        );
        let points = Points::here().within(40, [[1.2, 5.0], [-8.0, -4.0]]);
        trial.at(["A", "lg α"], points, 1.0, |[size, power]| {
            let small = libm::exp10(power);
            let psi = corrected::relaxed_ratio(size) * turntable::eq124_psi1(small);
            let turn = turntable::eq115_psi_rate(small, psi) / psi;
            Ok([turn * small / printed::eq126_alpha_rate(size), 1.0])
        })
    },
    above_one_within = above_one(Within),
    a_grows = limits(Within, SIZE.over, "$2^{1/4}/3$", corrected::a(1.0)),
    straight_stops = Trial::by(
        Integration,
        Outside,
        Compared::constant(
            "the stated 0",
            "the number of stops of a particle that comes straight in from $A>1$",
        ),
        NONE,
    )
    .each(BEYOND_ONE.each(), StraightIn::at, |straight| {
        Ok([0.0, table_stops(straight)? as f64, 1.0])
    }),
    straight_rate = {
        let trial = Trial::by(
            Integration,
            Corrected,
            [
                r"$-1-1/\rho$",
                r"$\mathrm d\alpha/\mathrm d\tau$ of a particle that has almost stopped, coming straight in",
            ],
            DIFFERENCES,
        );
        trial.each(BEYOND_ONE.each(), StraightIn::at, |straight| {
            let state = straight.with_alpha_below(1e-5);
            let time = time_to_stop(&state);
            let run = Run::new(&state.parts, 0.5 * time)?;
            let [rate] = rates(0.25 * time, 1e-2 * time, |t| Ok([alpha(&run.at(t)?)]))?;
            let stated = crate::corrections::rest::alpha_rate_straight_in(state.rho());
            Ok([stated, rate, rate.abs()])
        })
    },
    alpha_census = {
        let trial = Trial::census(
            Printed,
            [
                r"the number of decades of $\tau$ from 100 to $10^8$ over which $\alpha$ of (133) grows by more than 1",
                r"that of those over which $\alpha$ of the motion does",
            ],
        );
        let times = || (2..=8).map(|n| libm::pow(10.0, f64::from(n)));
        trial.each(OTHER_ESCAPES.each(), Escape::at, |escape| {
            let stated: Vec<f64> = times().map(printed::eq133_alpha).collect();
            let found: Result<Vec<_>, MotionError> =
                times().map(|tau| Ok(alpha(&escape.run.at(tau)?))).collect();
            Ok([grown(&stated) as f64, grown(&found?) as f64, 1.0])
        })
    }
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::escape::straight::WITHIN_ONE;

    /// The way of counting by which none of them stops finds stops where there are some.
    #[test]
    fn a_stop_on_the_table_is_counted() {
        for straight in WITHIN_ONE.each() {
            let straight = straight.unwrap();
            assert_eq!(table_stops(straight).unwrap(), 1, "{}", straight.at());
        }
        let (rho, p, psi) = (3.0, 0.5, 0.3);
        let run = Run::new(&Start::polar(rho, p, psi).unwrap(), 1.0).unwrap();
        let outwards = StraightIn { rho, p, psi, run };
        assert_eq!(table_stops(&outwards).unwrap(), 0);
    }

    #[test]
    fn who_stops_or_is_near_stays() {
        let run = |a: f64, until: f64| {
            let start = Start::hyperbolic(a, 0.3, 0.5).unwrap();
            Run::new(&start, until).unwrap()
        };
        let stopped = Run::new(&Start::polar(40.0, 0.0, 0.0).unwrap(), 1.0).unwrap();
        assert!(stopped.end().rho() > 30.0);
        let runs = [run(0.4, 300.0), run(2.0, 1.0), run(2.0, 300.0), stopped];
        assert_eq!(runs.map(|run| stays(&run)), [1.0, 1.0, 0.0, 1.0]);
    }

    #[test]
    fn of_a_start_up_to_one_nothing_is_said() {
        let said = [0.5, 1.0, 1.0_f64.next_up(), 1.05].map(|a| said_to_stay(a, 1.0));
        assert_eq!(said, [1.0, 1.0, 0.0, 0.0]);
    }

    #[test]
    fn a_fall_and_an_odd_end_are_noticed() {
        let (rest, escape, odd) = ([1e-30, 1e-26, 0.5], [1e5, 5.0, 2e4], [0.1, 0.2, 0.5]);
        let (grows, falls) = (
            [1.0, 2.0, 2.0 * (1.0 - 1e-15), 3.0],
            [1.0, 2.0, 2.0 * (1.0 - 2e-14), 3.0],
        );
        assert_eq!(
            [rest, escape, odd].map(|end| trend(&grows, end)),
            [1.0, 1.0, 0.0]
        );
        assert_eq!([rest, escape, odd].map(|end| trend(&falls, end)), [-1.0; 3]);
        // Neither slow nor near α = 0 is at rest.
        assert_eq!(trend(&[], [1e-30, 1e-24, 1e-6]), 0.0);
        assert_eq!(trend(&[], [1e-27, 1e-27, 1.0]), 0.0);
    }

    #[test]
    fn steps_that_grow_by_more_than_one_are_counted() {
        assert_eq!(grown(&[0.0, 2.0, 4.5, 4.6, 4.0, 7.0]), 3);
        assert_eq!(grown(&[1.0, 2.5, 4.0]), 2);
    }
}
