//! Trials of (42) to (46): the train of pulses.

use super::drives::{boundary, motion, phase, phase_of};
use super::prelude::*;

/// Per half period; the joints are added.
const PHASES: u32 = 48;

/// Shares of the gap for large friction, of the pulse for small.
const NEAR_ENDS: [f64; 4] = [1e-6, 1e-3, 1.0 - 1e-3, 1.0 - 1e-6];

/// Over the whole triangle η < λ₀ < 1, and along its edges.
fn above() -> Vec<(f64, f64)> {
    let mut points = Points::here();
    let mut list = square(&mut points, |eta, share| eta + (1.0 - eta) * share);
    list.push((2e-4, 5e-4));
    list
}

/// (η, λ₀) with 0 < λ₀ < η, and along the edges; λ₀ from a hundredth of η, below which rounding, divided by
/// the small loss per period, shows.
fn below() -> Vec<(f64, f64)> {
    let mut points = Points::here();
    square(&mut points, |eta, share| eta * (0.01 + 0.99 * share))
        .into_iter()
        .filter(|(eta, _)| *eta > 0.05)
        .chain([(1.0 - 1e-4, 1.0 - 5e-4)])
        .collect()
}

fn square(points: &mut Points, lambda: impl Fn(f64, f64) -> f64) -> Vec<(f64, f64)> {
    let mut list: Vec<_> = (0..1100)
        .map(|_| {
            let eta = points.uniform(0.0, 1.0);
            (eta, lambda(eta, points.uniform(0.0, 1.0)))
        })
        .collect();
    for edge in NEAR_ENDS {
        for _ in 0..10 {
            let eta = points.uniform(0.0, 1.0);
            list.push((eta, lambda(eta, edge)));
            list.push((edge, lambda(edge, points.uniform(0.0, 1.0))));
        }
    }
    list
}

fn at((eta, lambda): (f64, f64)) -> String {
    format!("η = {eta:.6}, λ₀ = {lambda:.6}")
}

fn phases(start: f64, ends: [f64; 2]) -> impl Iterator<Item = f64> {
    let grid = (0..=PHASES).map(move |k| start + PI * f64::from(k) / f64::from(PHASES));
    let inside = move |phi: &f64| (start..=start + PI).contains(phi);
    grid.chain(ends.into_iter().filter(inside))
}

/// The largest difference of stated and found values, at (phase, stated, found); what is no number is larger than
/// all that are.
fn worst(point: (f64, f64), scale: f64, values: impl Iterator<Item = [f64; 3]>) -> Pair {
    let apart = values.map(|[phi, stated, found]| (phi, (stated - found).abs()));
    let larger = |a: (f64, f64), b: (f64, f64)| if a.1 >= b.1 || a.1.is_nan() { a } else { b };
    let (phi, stated) = apart.fold((0.0, 0.0), larger);
    Pair {
        at: format!("{}, φ = {phi:.6}", at(point)),
        stated,
        found: 0.0,
        scale,
    }
}

/// (44) at φ in [0, π].
fn eq44((eta, lambda): (f64, f64), phi: f64) -> f64 {
    let case = printed::eq44_case(lambda, eta, phi);
    printed::eq44_cases(lambda, eta, phi)[case]
}

/// An error if it drifts, which no motion without a mean force does.
fn with_motion<T>(
    (eta, lambda): (f64, f64),
    then: impl FnOnce(&Attractor<'_>) -> Result<T, Failure>,
) -> Result<T, Failure> {
    let drive = pulses(eta)?;
    match motion(&drive, lambda)? {
        Some(motion) => then(&motion),
        None => Err("the motion drifts".into()),
    }
}

/// The phases at which the pulse ends and what it has given is used up: (1 − λ₀) ηπ, at the rate λ₀.
fn joints((eta, lambda): (f64, f64)) -> [f64; 2] {
    [eta * PI, eta * PI + (1.0 - lambda) * eta * PI / lambda]
}

fn area([pulse, gap]: [f64; 2], eta: f64, phi: f64) -> f64 {
    let end = phi.min(printed::eq42_end(eta));
    pulse * end + gap * (phi - end)
}

/// `expected` says until when, and how much.
fn gains(trial: &Trial, expected: impl Fn(f64, f64) -> (f64, f64)) -> Evidence {
    trial.drawn(0..200, |i, points| {
        let eta = match i {
            198 => 0.0,
            199 => 1.0,
            _ => points.uniform(0.0, 1.0),
        };
        let (until, stated) = expected(eta, points.uniform(0.0, PI));
        let rest = DriveState { phi: 0.0, w: 0.0 };
        let path = pulses(eta)?.advance(Friction::new(0.0, 0.0)?, rest, until)?;
        Ok(Pair {
            at: format!("η = {eta:.6}, φ = {until:.6}"),
            stated,
            found: path.end.w,
            scale: PI,
        })
    })
}

/// Along a pull in pulses, from rest at φ = 0, and across it. The particle rests before each pulse, so that its
/// first period is like every other.
pub(super) fn on_a_plane((eta, lambda): (f64, f64), angle: f64, phi: f64) -> Result<f64, Failure> {
    let square = |start: f64| Signal::Square { start, half: PI };
    let late = square(eta * PI).times(-1.0);
    let pull = Signal::Sum(vec![square(0.0), late]).times(-0.5);
    let (sine, cosine) = libm::sincos(angle);
    let start = crate::motion::State::moving([0.0; 2]);
    let plane = Plane::along([cosine, sine], pull);
    let [x, y] = run(&plane, lambda, start, phi)?.end().v;
    Ok(x * cosine + y * sine + (x * sine - y * cosine).abs())
}

fn from_rest(compared: Compared, value: impl Fn((f64, f64), f64) -> [f64; 2]) -> Evidence {
    Trial::motion(Printed, compared).drawn(0..30, |_, points| {
        let eta = points.uniform(0.05, 0.95);
        let lambda = points.uniform(eta, 1.0);
        let (phi, angle) = (points.uniform(0.0, PI), points.uniform(-PI, PI));
        let [until, stated] = value((eta, lambda), phi);
        Ok(Pair {
            at: format!("{}, φ = {until:.6}", at((eta, lambda))),
            stated,
            found: on_a_plane((eta, lambda), angle, until)?,
            scale: eta * PI,
        })
    })
}

fn widths() -> Vec<f64> {
    let mut points = Points::here();
    let edges = [1e-6, 1e-3, 1.0 - 1e-3, 1.0 - 1e-6];
    (0..44)
        .map(|_| points.uniform(0.0, 1.0))
        .chain(edges)
        .collect()
}

fn bracketed(eta: f64) -> Result<f64, DriveError> {
    let drive = pulses(eta)?;
    boundary(0.0, 1.0, |lambda| {
        Ok(phase(&drive, lambda)? != Phase::Rests(0))
    })
}

fn extremes_census() -> Evidence {
    let mut points = Points::here();
    let edges = [1e-9, 1e-6, 1e-3, 1.0 - 1e-3, 1.0 - 1e-6, 1.0 - 1e-9];
    let frictions = (0..200).map(|_| points.uniform(0.0, 1.0)).chain(edges);
    Trial::census(
        Printed,
        Compared::constant(
            "0 below (46) and 1 above",
            "the number of rests in a period (1 for a particle at rest for ever)",
        )
        .over(r"$\eta=1$ and $\eta=0$"),
    )
    .over(
        frictions.flat_map(|lambda| [(1.0, lambda), (0.0, lambda)]),
        |(eta, lambda)| {
            let drive = pulses(eta)?;
            // Off rest at first: without pulses a particle at rest would prove nothing.
            let start = DriveState { phi: 0.0, w: 0.5 };
            let friction = Friction::new(lambda, lambda)?;
            let motion = drive.attractor(friction, start, 100)?.settled();
            let found = match motion.map(|m| phase_of(&m)) {
                Some(Phase::Rests(rests)) => rests as f64,
                Some(Phase::Still) => 1.0,
                Some(Phase::Drifts) | None => return Err(Failure::from("the motion drifts")),
            };
            let small = lambda < printed::eq46_lambda_c(eta);
            Ok(Pair::plain(
                at((eta, lambda)),
                if small { 0.0 } else { 1.0 },
                found,
            ))
        },
    )
}

/// η → 1 and η → 0: the phase that is to vanish is as narrow as 1 − η, or as η.
fn extremes_limit() -> Evidence {
    let distances = (1..13).map(|k| Scalar::pow(10.0, -0.25 * f64::from(k)));
    let distances = Points::here().grid(distances).into_iter();
    Trial::by(
        Limit,
        Printed,
        Compared::one(
            r"the width of the vanishing phase by (46), over $\delta$,",
            "that in the motion",
        )
        .over(r"$\eta=1-\delta$ (large friction) and $\eta=\delta$ (small friction)"),
        LIMIT_OF_WIDTH,
    )
    .over(
        distances.flat_map(|delta| [(delta, true), (delta, false)]),
        |(delta, nearly_one)| {
            let eta = if nearly_one { 1.0 - delta } else { delta };
            let width = |threshold: f64| {
                if nearly_one {
                    1.0 - threshold
                } else {
                    threshold
                }
            };
            Ok(Pair::plain(
                format!("η = {eta:.6}"),
                width(printed::eq46_lambda_c(eta)) / delta,
                width(bracketed(eta)?) / delta,
            ))
        },
    )
}

attempts![
    eq42 = {
        let trial = Trial::consistency(
            Printed,
            [
                r"the area of (42) up to $\phi$",
                r"$\mathfrak w$ of a smooth particle that starts at rest under pulses that fill the share $\eta$",
            ],
        );
        gains(&trial, |eta, phi| {
            (phi, area(printed::eq42_cases(), eta, phi))
        })
    },
    eq43 = {
        let trial = Trial::consistency(
            Printed,
            [
                r"the area of (42) and, up to $\pi+\phi$, of (43)",
                r"$\mathfrak w$ of a smooth particle there",
            ],
        );
        gains(&trial, |eta, phi| {
            let first = printed::eq42_cases();
            let second = first.map(printed::eq43_h);
            (PI + phi, area(first, eta, PI) + area(second, eta, phi))
        })
    },
    eq44_motion = {
        let trial = Trial::motion(
            Printed,
            [
                r"the largest difference of (44) from $\mathfrak w$ of the motion, over the first half period,",
                "0",
            ],
        );
        trial.over(above(), |point| {
            with_motion(point, |motion| {
                let ends = joints(point);
                let scale = point.0 * PI;
                let values = phases(0.0, ends).map(|phi| [phi, eq44(point, phi), motion.w(phi)]);
                Ok(worst(point, scale, values))
            })
        })
    },
    eq44_plane = from_rest(
        Compared::one(
            "(44)",
            r"$\mathfrak w$ of a particle on a plane in the direction of the pull, from rest at $\phi=0$",
        ),
        |point, phi| [phi, eq44(point, phi)]
    ),
    eq45_motion = {
        let trial = Trial::motion(
            Printed,
            [
                r"the largest difference of (45), with (44), from $\mathfrak w$ of the motion, over the second half period,",
                "0",
            ],
        );
        trial.over(above(), |point| {
            with_motion(point, |motion| {
                let ends = joints(point);
                let value = |phi| [phi, printed::eq45_w(eq44(point, phi)), motion.w(PI + phi)];
                // π + φ is known to the spacing of numbers near 2π.
                Ok(worst(point, PI, phases(0.0, ends).map(value)))
            })
        })
    },
    eq45_plane = from_rest(
        Compared::one(
            "(45), with (44),",
            r"$\mathfrak w$ of a particle on a plane in the direction of the pull, from rest at $\phi=0$",
        ),
        |point, phi| { [PI + phi, printed::eq45_w(eq44(point, phi))] }
    ),
    eq46_root = Trial::by(
        Root,
        Printed,
        [
            "(46)",
            r"the $\lambda_0$ at which rests appear in the motion",
        ],
        THRESHOLD,
    )
    .over(widths(), |eta| {
        Ok(Pair::plain(
            format!("η = {eta:.6}"),
            printed::eq46_lambda_c(eta),
            bracketed(eta)?,
        ))
    }),
    eq46_census = {
        let points = above().into_iter().zip(below()).flat_map(|(a, b)| [a, b]);
        Trial::census(
            Printed,
            Compared::constant(
                r"2 for $\lambda_0$ above (46) and 0 below",
                "the number of rests in a period of the motion",
            ),
        )
        .over(points, |(eta, lambda)| {
            let found = match phase(&pulses(eta)?, lambda)? {
                Phase::Rests(rests) => rests as f64,
                Phase::Still | Phase::Drifts => return Err(Failure::from("no periodic slip")),
            };
            Ok(Pair::plain(
                at((eta, lambda)),
                if lambda > printed::eq46_lambda_c(eta) {
                    2.0
                } else {
                    0.0
                },
                found,
            ))
        })
    },
    below_motion = {
        let trial = Trial::motion(
            Printed,
            [
                r"the largest difference between our own formula for the motion without rest, for $\lambda_0$ below (46), and $\mathfrak w$ of the motion",
                "0",
            ],
        );
        trial.over(below(), |(eta, lambda)| {
            with_motion((eta, lambda), |motion| {
                let start = motion.intervals().first().map_or(0.0, |i| i.start);
                let start = start.rem_euclid(PI);
                let values = phases(start, [eta * PI, PI]).flat_map(|phi| {
                    let case = supplied::small_friction_case(eta, phi);
                    let w = supplied::small_friction_cases(lambda, eta, phi)[case];
                    [(phi, w), (PI + phi, -w)].map(|(phi, w)| [phi, w, motion.w(phi)])
                });
                Ok(worst((eta, lambda), PI, values))
            })
        })
    },
    extremes_census,
    extremes_limit,
    extremes_outside = {
        let starts = Points::here().within(24, [[0.1, 3.0]]);
        Trial::census(
            Outside,
            Compared::constant("the stated 1", "the number of rests in a period")
                .over(r"$\eta=0$ and $\lambda_0=0$"),
        )
        .at(["𝔴"], starts, 1.0, |[w]| {
            let drive = pulses(0.0)?;
            let start = DriveState { phi: 0.0, w };
            let motion = drive.attractor(Friction::new(0.0, 0.0)?, start, 100)?;
            let small = 0.0 < printed::eq46_lambda_c(0.0);
            let rests = match motion.settled().map(|m| phase_of(&m)) {
                Some(Phase::Rests(rests)) => rests as f64,
                Some(Phase::Still) => 1.0,
                Some(Phase::Drifts) | None => return Err("the motion drifts".into()),
            };
            Ok([if small { 0.0 } else { 1.0 }, rests])
        })
    },
    neither = no_inside(
        "a pair of width and friction",
        r"$\lambda_0=0$",
        [("η", [0.0, 1.0]), ("λ₀", [0.0, 1.0])],
        &[[0.0, 0.0]],
        |[_, lambda0]| lambda0 > 0.0,
    )
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cases_end_at_their_ends() {
        let (lambda, eta) = (0.3, 0.4);
        for (case, end) in printed::eq44_ends(lambda, eta).into_iter().enumerate() {
            let beside = [end.next_down(), end];
            let cases = beside.map(|phi| printed::eq44_case(lambda, eta, phi));
            assert_eq!(cases, [case, case + 1]);
        }
        for (case, end) in supplied::small_friction_ends(eta).into_iter().enumerate() {
            let beside = [end.next_down(), end];
            let cases = beside.map(|phi| supplied::small_friction_case(eta, phi));
            assert_eq!(cases, [case, case + 1]);
        }
        // Of the drive itself: with the pulse's share 0 there is none, not even at the beginning.
        let end = printed::eq42_end(eta);
        let phases = [0.0, end.next_down(), end, PI.next_down()];
        assert_eq!(
            phases.map(|phi| printed::eq42_h(eta, phi)),
            [1.0, 1.0, 0.0, 0.0]
        );
        assert_eq!(printed::eq42_h(0.0, 0.0), 0.0);
    }
}
