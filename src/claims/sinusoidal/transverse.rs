//! Trials of what section 2.2 says of the velocity across the drive: how it dies, and what it leaves behind.

use super::prelude::*;
use super::reference_motions::printed_late;
use crate::paper::general;

/// Once a period from φ = 0 on.
pub(super) fn strobed(
    lambda: f64,
    w_x: f64,
    w_y: f64,
    periods: u32,
) -> Result<Vec<PlanarState>, Failure> {
    let start = PlanarState {
        phi: 0.0,
        w_x,
        ln_w_y: Scalar::ln(w_y),
    };
    let phases: Vec<_> = (0..=periods).map(|k| TAU * f64::from(k)).collect();
    Ok(drive()?.planar(lambda, start, &phases)?)
}

/// With a velocity across the drive at first, over ten periods.
#[derive(Clone)]
pub(super) struct Flight {
    pub lambda: f64,
    /// 𝔴 and 𝔴_y at φ = π/2.
    start: [f64; 2],
    /// Eight states a period.
    states: Vec<PlanarState>,
}

const A_PERIOD: u32 = 8;
const PERIODS: u32 = 10;

impl Flight {
    fn from(lambda: f64, [w_x, w_y]: [f64; 2]) -> Result<Self, Failure> {
        let start = PlanarState {
            phi: FRAC_PI_2,
            w_x,
            ln_w_y: Scalar::ln(w_y),
        };
        let phase = |k: u32| FRAC_PI_2 + TAU * f64::from(k) / f64::from(A_PERIOD);
        let phases: Vec<_> = (0..=PERIODS * A_PERIOD).map(phase).collect();
        Ok(Flight {
            lambda,
            start: [w_x, w_y],
            states: drive()?.planar(lambda, start, &phases)?,
        })
    }

    pub(super) fn strobe(&self) -> impl Iterator<Item = &PlanarState> {
        self.states.iter().step_by(A_PERIOD as usize)
    }

    pub(super) fn last(&self) -> Result<PlanarState, Failure> {
        Ok(*self.states.last().ok_or("no state")?)
    }

    /// True below λ_c, unless the particle came to rest on the way to its periodic motion: then its v_y is 0.
    pub(super) fn never_rests(&self) -> bool {
        let rested = |s: &&PlanarState| s.ln_w_y == f64::NEG_INFINITY;
        self.lambda < lambda_c() && !self.states.iter().any(|s| rested(&s))
    }

    /// True where (1), in units in which the drive is the sine, lets 𝔴_y grow.
    fn is_to_grow(&self, state: &PlanarState) -> bool {
        let w = [state.w_x, Scalar::exp(state.ln_w_y)];
        let drive = [-Scalar::sin(state.phi), 0.0];
        w[1] * general::eq1_velocity_rate(drive, self.lambda, 1.0, w)[1] > 0.0
    }

    pub(super) fn at(&self) -> String {
        let Flight {
            lambda,
            start: [w_x, w_y],
            ..
        } = self;
        format!("λ₀ = {lambda:.6}, 𝔴 = {w_x:.6}, 𝔴_y = {w_y:.6} at φ = π/2")
    }
}

/// 20 below λ_c, 10 between λ_c and 1, 10 above 1.
pub(super) fn flights_where(
    wanted: fn(&Flight) -> bool,
) -> impl Iterator<Item = Result<&'static Flight, Failure>> {
    static FLIGHTS: Runs<Vec<Flight>> = Runs::new(|| {
        let mut points = Points::here();
        let flight = |i: u32| {
            let lambda = match i % 4 {
                0 | 1 => points.uniform(0.4, lambda_c() - 0.02),
                2 => points.uniform(lambda_c() + 1e-3, 1.0),
                _ => points.uniform(1.0, 1.4),
            };
            let start = [points.uniform(0.2, 1.0), points.log_uniform(0.05, 1.0)];
            Flight::from(lambda, start)
        };
        every((0..40).map(flight))
    });
    only(FLIGHTS.each(), move |flight| wanted(flight))
}

fn at([lambda, w_x, w_y]: [f64; 3]) -> String {
    format!("λ₀ = {lambda:.6}, 𝔴 = {w_x:.6}, 𝔴_y = {w_y:.6}")
}

pub(super) fn first_stage() -> Evidence {
    let trial = Trial::by(
        Limit,
        Printed,
        [
            r"$-\lambda_0$",
            r"the mean slope of $\mathfrak w_y$ over a period, or eight where friction is next to none, in which it stays above $10^4\lvert\mathfrak w\rvert$",
        ],
        FIRST_STAGE,
    );
    trial.drawn(0..36, |i, points| {
        // With next to no friction next to nothing is lost: less of it drowns in the rounding of a smaller velocity, and
        // over more periods.
        let (frictions, most, [low, high], periods) = match i {
            ..30 => ([0.05, 1.5], 1.0, [3e4, 3e5], 1),
            _ => ([7e-4, 1e-3], -0.6, [1.5e4, 2e4], 8),
        };
        let lambda = points.uniform(frictions[0], frictions[1]);
        let w_x = points.uniform(-1.0, most);
        let w_y = points.log_uniform(low, high);
        let states = strobed(lambda, w_x, w_y, periods)?;
        let [first, last] = [0, states.len() - 1].map(|k| Scalar::exp(states[k].ln_w_y));
        Ok(Pair {
            at: at([lambda, w_x, w_y]),
            stated: printed::s22_first_stage_slope(lambda),
            found: (last - first) / (TAU * f64::from(periods)),
            scale: lambda,
        })
    })
}

/// The fall of a logarithm in the third step after the number has fallen below 1e-3, over that in the second.
fn third_over_second(logarithms: &[f64]) -> Result<f64, Failure> {
    let small = logarithms.iter().position(|l| *l < -6.9);
    let small = small.ok_or("v_y stays large")?;
    let fall = |k: usize| match logarithms.get(small + k..small + k + 2) {
        Some([before, after]) => before - after,
        _ => f64::NAN,
    };
    Ok(fall(2) / fall(1))
}

fn ignores(subject: Subject, compared: Compared, [low, high]: [f64; 2]) -> Evidence {
    Trial::census(subject, compared).drawn(0..20, |_, points| {
        let (lambda, w_x) = (points.uniform(low, high), points.uniform(-1.0, 1.0));
        let phases = first_period();
        let mut curves = Vec::new();
        for w_y in [0.1, 1.0, 5.0] {
            let start = PlanarState {
                phi: 0.0,
                w_x,
                ln_w_y: Scalar::ln(w_y),
            };
            let states = drive()?.planar(lambda, start, &phases)?;
            curves.push(states.iter().map(|s| s.w_x).collect::<Vec<_>>());
        }
        Ok(Pair::plain(
            format!("λ₀ = {lambda:.6}, 𝔴 = {w_x:.6} at φ = 0"),
            1.0,
            is(each_differs(&curves)),
        ))
    })
}

/// Its end included.
fn first_period() -> Vec<f64> {
    (1..=16).map(|k| TAU * f64::from(k) / 16.0).collect()
}

/// Whether each curve differs from the next one by more than 0.01 somewhere.
fn each_differs(curves: &[Vec<f64>]) -> bool {
    let apart = |a: &[f64], b: &[f64]| a.iter().zip(b).any(|(a, b)| (a - b).abs() > 0.01);
    curves.windows(2).all(|pair| apart(&pair[0], &pair[1]))
}

attempts![
    vanishes_limit = Trial::by(
        Limit,
        Printed,
        Compared::constant(
            "the stated 0",
            r"$\mathfrak w_y$ after ten periods, from $\ln\mathfrak w_y$,",
        ),
        GONE,
    )
    .each(flights_where(|_| true), Flight::at, |flight| {
        Ok([
            printed::s22_late_vy(),
            Scalar::exp(flight.last()?.ln_w_y),
            flight.start[1],
        ])
    }),
    vanishes_motion = Trial::by(
        Integration,
        Printed,
        Compared::constant(
            "the stated 0",
            "$v_y$ of a particle on the plane after five periods",
        ),
        GONE,
    )
    .drawn(0..20, |_, points| {
        let lambda = points.uniform(0.25, 1.4);
        let v = [points.uniform(-1.0, 1.0), points.uniform(0.05, 1.0)];
        let end = Particle::plain(lambda).run(0.0, v, 5.0 * TAU)?.end();
        Ok(Pair {
            at: at([lambda, v[0], v[1]]),
            stated: printed::s22_late_vy(),
            found: end.v[1],
            scale: v[1],
        })
    }),
    vanishes_census = {
        let trial = Trial::census(
            Printed,
            [
                r"the number of states at which (1) lets $\mathfrak w_y>0$ grow",
                r"that of the steps of an eighth of a period on which $\ln\mathfrak w_y$ grows, over ten periods",
            ],
        );
        trial.each(flights_where(|_| true), Flight::at, |flight| {
            let steps = flight.states.windows(2);
            // Beside a huge logarithm a change of order one is lost in rounding.
            let rounding = |s: &PlanarState| 1e-13 * s.ln_w_y.abs().min(f64::MAX);
            let grows = steps.filter(|s| s[1].ln_w_y > s[0].ln_w_y + rounding(&s[0]));
            Ok([
                flight
                    .states
                    .iter()
                    .filter(|s| flight.is_to_grow(s))
                    .count() as f64,
                grows.count() as f64,
                1.0,
            ])
        })
    },
    vanishes_outside = {
        let starts = Points::here().within(20, [[-1.0, 1.0], [0.05, 1.0]]);
        Trial::by(
            Integration,
            Outside,
            Compared::constant(
                "the expected 0",
                "$v_y$ of a particle on the plane after five periods without friction",
            ),
            GONE,
        )
        .over(starts, |v| {
            let end = Particle::plain(0.0).run(0.0, v, 5.0 * TAU)?.end();
            Ok(Pair {
                at: at([0.0, v[0], v[1]]),
                stated: printed::s22_late_vy(),
                found: end.v[1],
                scale: v[1],
            })
        })
    },
    first_stage,
    second_stage = {
        let trial = Trial::by(
            Integration,
            Printed,
            Compared::constant(
                "the stated 1",
                r"the fall of $\ln\mathfrak w_y$ in the third period after $\mathfrak w_y$ has fallen below $10^{-3}$, over that in the second, for $\lambda_0<\lambda_\mathrm c$,",
            ),
            EXPONENTIAL,
        );
        trial.each(flights_where(Flight::never_rests), Flight::at, |flight| {
            let strobe: Vec<_> = flight.strobe().map(|s| s.ln_w_y).collect();
            Ok([
                printed::s22_second_stage_ratio(),
                third_over_second(&strobe)?,
                1.0,
            ])
        })
    },
    ignores_motion = Trial::by(
        Integration,
        Printed,
        [
            r"$\mathfrak w$ by (38), (33) or rest, as $\lambda_0$ says,",
            r"$\mathfrak w$ of a motion in the plane at eight phases of its tenth period",
        ],
        FORGOTTEN,
    )
    .pairs(flights_where(|_| true), |flight| {
        let flight = flight?;
        let last = flight.states.iter().rev().take(A_PERIOD as usize);
        let pair = |state: &PlanarState| {
            Pair::plain(
                format!("{}, φ = {:.6}", flight.at(), state.phi),
                printed_late(flight.lambda, state.phi),
                state.w_x,
            )
        };
        Ok(last.map(pair).collect())
    }),
    ignores_census = ignores(
        Printed,
        Compared::constant(
            "the expected 1",
            r"whether the first period's $\mathfrak w$ differs by more than 0.01 between $\mathfrak w_y=0.1$, 1 and 5 at the start (1 if so)",
        ),
        [0.15, 1.4]
    ),
    ignores_outside = ignores(
        Outside,
        Compared::constant(
            "the expected 1",
            r"whether, without friction, the first period's $\mathfrak w$ differs by more than 0.01 between $\mathfrak w_y=0.1$, 1 and 5 at the start (1 if so)",
        ),
        [0.0, 0.0]
    )
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn falls_are_counted_from_the_first_small_number() {
        let logarithms = [0.0, -5.0, -8.0, -10.0, -14.0, -20.0];
        assert_eq!(third_over_second(&logarithms).unwrap(), 1.5);
        assert!(third_over_second(&logarithms[..5]).unwrap().is_nan());
        assert!(third_over_second(&logarithms[..2]).is_err());
    }

    #[test]
    fn the_first_period_is_looked_at_to_its_end() {
        let phases = first_period();
        assert_eq!((phases[0], phases[15], phases.len()), (TAU / 16.0, TAU, 16));
    }

    #[test]
    fn every_curve_must_differ_from_the_next() {
        let curves = |ends: [f64; 3]| ends.map(|end| vec![1.0, 1.0, end]);
        assert!(each_differs(&curves([1.0, 1.02, 1.0])));
        assert!(!each_differs(&curves([1.0, 1.02, 1.02])));
        assert!(!each_differs(&curves([1.0, 1.0, 1.02])));
        assert!(!each_differs(&curves([1.0, 1.005, 1.01])));
    }

    #[test]
    fn a_flight_below_the_threshold_never_rests_unless_it_has_rested() {
        let flight = |lambda: f64, ln_w_y: f64| Flight {
            lambda,
            start: [0.0, 1.0],
            states: [0.0, ln_w_y]
                .map(|ln_w_y| PlanarState {
                    phi: 0.0,
                    w_x: 0.0,
                    ln_w_y,
                })
                .to_vec(),
        };
        assert!(flight(0.4, -1e9).never_rests());
        assert!(!flight(0.4, f64::NEG_INFINITY).never_rests());
        assert!(!flight(0.9, -1e9).never_rests());
    }
}
