//! Trials of the four statements about every A(t), on accelerations of all sorts and on one that breaks each.

use super::accelerations::{Case, SHAPES, along_a_line, any_start, bounded};
use super::examples::{
    AT_REST, OTHERS_PULLED, OTHERS_RETURNING, PULLED, Pulled, RETURNING, Returning, violations,
};
use super::prelude::*;
use crate::motion::run_to_stop;

/// μ and g of unit friction, without rounding.
const UNIT: [f64; 2] = [0.5, 2.0];

fn whether(at: String, stated: bool, found: bool) -> Pair {
    let [stated, found] = [stated, found].map(is);
    Pair::plain(at, stated, found)
}

fn stops_below() -> f64 {
    let [mu, g] = UNIT;
    printed::s2_stops_below(mu, g)
}

fn rest_ends_above() -> f64 {
    let [mu, g] = UNIT;
    printed::s2_rest_ends_above(mu, g)
}

fn speeds_up_above() -> f64 {
    let [mu, g] = UNIT;
    printed::s2_speeds_up_above(mu, g)
}

fn stops_census() -> Evidence {
    let compared = Compared::one(
        r"whether $\max\lvert\bm A\rvert<\mu g$ (1 if so)",
        r"whether the speed falls on every step and the motion stops by $v_0/(\mu g-\max\lvert\bm A\rvert)$, or $20v_0$",
    )
    .over(r"where, above $\mu g$, $\bm A$ is constant, against the velocity");
    let weak = bounded(0.95).map(|case| (0.95, case));
    Trial::census(Printed, compared).over(weak.chain(pulled_along()), |(largest, case)| {
        let stops = unlike_a_stop(&case)? == 0;
        Ok(whether(case.name, largest < stops_below(), stops))
    })
}

/// 1.05 to 3 μg, against which the particle starts, with their sizes; friction 1.
fn pulled_along() -> impl Iterator<Item = (f64, Case)> {
    let mut points = Points::here();
    (0..20).map(move |_| {
        let (size, speed) = (points.uniform(1.05, 3.0), points.log_uniform(0.2, 5.0));
        let start = any_start(&mut points, speed);
        let case = Case {
            name: format!(
                "constant A = {size:.6}, μg = 1, v = ({:.6}, {:.6}) against it",
                start.v[0], start.v[1]
            ),
            plane: Plane::constant(start.v.map(|v| -size * v / speed)),
            friction: 1.0,
            start,
        };
        (size, case)
    })
}

/// The steps on which the speed does not fall, and one if there is no stop by v₀/(μg − max |A|), |A| ≤ 0.95, μg = 1.
fn unlike_a_stop(case: &Case) -> Result<usize, Failure> {
    let latest = case.start.speed() / 0.05;
    let motion = run_to_stop(
        &case.plane,
        case.friction,
        case.start,
        latest * (1.0 + 1e-9),
    )?;
    let rises = violations(&motion, 0.0, |a, b| b.t > a.t && b.speed() >= a.speed());
    let runs_on = usize::from(motion.first_stop().is_none());
    Ok(rises + runs_on)
}

fn long_rests(phases: &[Phase], period: f64) -> usize {
    let rests = phases.iter().filter(|p| p.kind == PhaseKind::Stick);
    rests
        .filter(|p| p.to - p.from > period * (1.0 + 1e-9))
        .count()
}

fn slides(phases: &[Phase], from: f64, to: f64) -> bool {
    phases
        .iter()
        .filter(|p| p.kind == PhaseKind::Slide)
        .any(|p| p.from < to && p.to > from)
}

/// The largest speed that is left; friction 1.
fn pushed(strength: f64, length: f64) -> Result<f64, Failure> {
    let pulse = Signal::Pulse {
        from: 0.5,
        to: 0.5 + length,
    };
    let motion = run(&Plane::along([-strength, 0.0], pulse), 1.0, AT_REST, 10.0)?;
    Ok(motion.nodes().map(|s| s.speed()).fold(0.0, f64::max))
}

fn across_census() -> Evidence {
    Trial::census(Printed, Compared::constant(
        "$-1$, for a fall",
        r"the sign of the change of $\lvert v_\perp\rvert$ on every step (1 if it grows on one, or stays while it is not zero)",
    )).over(fixed_direction(), |case| {
        let falls = grows_across(&case)? == 0;
        Ok(Pair::plain(case.name, printed::s2_across_trend(), if falls { -1.0 } else { 1.0 }))
    })
}

fn grows_across(case: &Across) -> Result<usize, Failure> {
    let motion = run(&case.plane, 1.0, case.start, 10.0)?;
    // Below, only the rounding of the components along the line is left.
    let lost = |s: &State| 1e-12 * s.speed().max(case.start.speed());
    let grows = |a: &State, b: &State| {
        b.t > a.t && case.across(a) > lost(b) && case.across(b) >= case.across(a)
    };
    Ok(violations(&motion, 0.0, grows))
}

fn across_outside() -> Evidence {
    Trial::census(Outside, Compared::constant(
        "$-1$, for a fall",
        r"the sign of the change of $\lvert v_\perp\rvert$ in ten units of time without friction",
    )).over(fixed_direction(), |case| {
        let end = run(&case.plane, 0.0, case.start, 10.0)?.end();
        let (before, after) = (case.across(&case.start), case.across(&end));
        Ok(Pair::plain(case.name, printed::s2_across_trend(), sense(after - before, end.speed())))
    })
}

/// The sign of a change of a component of a velocity; 0 within the rounding of one that becomes this fast.
fn sense(change: f64, speed: f64) -> f64 {
    if change.abs() < 1e-12 * (1.0 + speed) {
        0.0
    } else {
        change.signum()
    }
}

fn across_integration() -> Evidence {
    let trial = Trial::motion(
        Printed,
        [
            r"the smaller of $\lvert v_\perp\rvert$ at a late time and the bound $v_{\perp0}(1+At/v_0)^{-\mu g/A}$, with $A$ up to $30\mu g$,",
            r"$\lvert v_\perp\rvert$ itself",
        ],
    );
    let mut points = Points::here();
    let bounded = fixed_direction().filter(|case| case.largest.is_finite());
    trial.over(bounded, |case| {
        let more = off_friction(points.log_uniform(1.0, 15.0) * case.largest) / case.largest;
        let (largest, late) = (more * case.largest, points.log_uniform(1.0, 30.0));
        let plane = Plane {
            x: case.plane.x.clone().times(more),
            y: case.plane.y.clone().times(more),
        };
        let end = run(&plane, 1.0, case.start, late)?.end();
        let (v0, across0) = (case.start.speed(), case.across(&case.start));
        let bound = across_bound(across0, v0, largest, late);
        let across = case.across(&end);
        Ok(Pair {
            at: format!("{}, {more:.6} times that, t = {late:.6}", case.name),
            stated: across.min(bound),
            found: across,
            scale: across0,
        })
    })
}

/// v⊥₀ (1 + A t/v₀)^(−μg/A), for μg = 1: v⊥ falls at the rate μg v⊥/v.
fn across_bound(across0: f64, v0: f64, largest: f64, late: f64) -> f64 {
    let trend: f64 = printed::s2_across_trend();
    across0 * libm::pow(1.0 + largest * late / v0, trend / largest)
}

struct Across {
    name: String,
    plane: Plane,
    start: State,
    normal: [f64; 2],
    /// Infinite for one that grows for ever.
    largest: f64,
    /// When v⊥ has had the time to fall to a millionth.
    late: f64,
}

impl Across {
    fn across(&self, s: &State) -> f64 {
        (s.v[0] * self.normal[0] + s.v[1] * self.normal[1]).abs()
    }
}

/// A size that does not exceed the friction 1 by next to nothing: a particle that has turned would speed up over steps
/// without number.
fn off_friction(size: f64) -> f64 {
    if size > 1.0 { size.max(1.02) } else { size }
}

/// All shapes that have one; friction 1.
fn fixed_direction() -> impl Iterator<Item = Across> {
    let mut points = Points::here();
    let shapes = (0..SHAPES.len())
        .filter(|&i| SHAPES[i] != "rotating")
        .cycle();
    shapes.take(40).map(move |shape| {
        let rate = points.log_uniform(0.3, 3.0);
        let size = off_friction(points.uniform(0.3, 2.0));
        let direction = points.uniform(-3.1, 3.1);
        let (c, s) = (libm::cos(direction), libm::sin(direction));
        let speed = points.log_uniform(0.2, 3.0);
        let start = any_start(&mut points, speed);
        let grows = SHAPES[shape] == "growing";
        Across {
            name: format!(
                "{} A of size {size:.6}, rate {rate:.6}, μg = 1, v = ({:.6}, {:.6}), A at angle {direction:.6}",
                SHAPES[shape], start.v[0], start.v[1]
            ),
            plane: Plane::along([size * c, size * s], along_a_line(shape, rate)),
            start,
            normal: [-s, c],
            largest: if grows { f64::INFINITY } else { size },
            late: if SHAPES[shape] == "constant" { 1e8 } else { 80.0 / rate },
        }
    })
}

attempts![
    stops_census,
    stops_integration = {
        let trial = Trial::motion(
            Printed,
            [
                "the time at which the motion stops, moved into the bounds that (2) sets where it lies outside,",
                "that time itself",
            ],
        );
        trial.over(bounded(0.9), |case| {
            let v0 = case.start.speed();
            let motion = run_to_stop(&case.plane, case.friction, case.start, 100.0 * v0)?;
            let stop = motion.first_stop().unwrap_or(f64::INFINITY);
            let [soonest, latest] = [0.9, -0.9].map(|a| v0 / (stops_below() + a));
            Ok(Pair {
                at: case.name,
                stated: stop.max(soonest).min(latest),
                found: stop,
                scale: v0,
            })
        })
    },
    rest_census = Trial::census(
        Within,
        [
            r"whether $\lvert\bm A\rvert$ exceeds $\mu g$ in every period (1 if so)",
            "whether no rest lasts longer than a period",
        ],
    )
    .over(RETURNING.each(), |returning| {
        let Returning {
            name,
            size,
            period,
            phases,
        } = returning?;
        let ends = long_rests(phases, *period) == 0;
        Ok(whether(name.clone(), *size > rest_ends_above(), ends))
    }),
    rest_integration = Trial::by(
        Integration,
        Within,
        [
            r"whether $\lvert\bm A\rvert$ exceeds $\mu g$ in every period (1 if so)",
            "whether the motion has slid in each of five periods",
        ],
        NONE,
    )
    .over(OTHERS_RETURNING.each(), |returning| {
        let Returning {
            name,
            size,
            period,
            phases,
        } = returning?;
        let slid = |n: i32| {
            let (from, to) = (f64::from(n) * period, f64::from(n + 1) * period);
            slides(phases, from, to)
        };
        let moves = (0..5).all(slid);
        Ok(whether(name.clone(), *size > rest_ends_above(), moves))
    }),
    // A push at a single instant, as the limit of pushes that last ever shorter: what it leaves of speed is nothing.
    rest_outside = {
        let trial = Trial::by(
            Limit,
            Outside,
            Compared::constant(
                r"1, for motion, where $\lvert\bm A\rvert>\mu g$ at an instant",
                "the largest speed, in units of a push's strength, extrapolated from pushes of two lengths to length 0,",
            ),
            SHORT_PUSH,
        );
        trial.drawn(0..40, |_, points| {
            let (strength, length) = (points.uniform(1.1, 5.0), points.log_uniform(1e-6, 1.0));
            let fastest = |length: f64| pushed(strength, length);
            Ok(Pair {
                at: format!(
                    "A = {strength:.6} μg at one instant, from pushes of {length:.6} and half of it"
                ),
                stated: if strength > rest_ends_above() {
                    strength
                } else {
                    0.0
                },
                found: 2.0 * fastest(length / 2.0)? - fastest(length)?,
                scale: strength,
            })
        })
    },
    grows_census = Trial::census(
        Within,
        [
            r"whether $\lvert\bm A\rvert>\mu g$ at all times (1 if so)",
            "whether the speed grows on every step from $t=200$ to 400",
        ],
    )
    .over(PULLED.each(), |pulled| {
        let pulled = pulled?;
        let stated = pulled.least > speeds_up_above();
        Ok(whether(pulled.name.clone(), stated, pulled.grows()))
    }),
    grows_integration = {
        let trial = Trial::motion(
            Within,
            [
                r"the larger of $0.95\cdot200(\min\lvert\bm A\rvert-\mu g)$ and the speed gained from $t=200$ to 400",
                "the speed gained",
            ],
        );
        trial.over(OTHERS_PULLED.each(), |pulled| {
            let Pulled {
                name,
                least,
                gained,
                ..
            } = pulled?;
            Ok(Pair {
                at: name.clone(),
                stated: gained.max(0.95 * 200.0 * (least - speeds_up_above())),
                found: *gained,
                scale: gained.max(1.0),
            })
        })
    },
    // |A| = μg (1 + e^(−t²)), always above μg: the speed falls for ever.
    grows_outside = Trial::motion(
        Outside,
        ["the larger of the speeds at $t$ and $t+1$", "that at $t+1$"],
    )
    .drawn(0..100, |_, points| {
        let (theta0, t) = (points.uniform(0.8, 2.4), points.uniform(3.0, 8.0));
        let excess = Signal::Gaussian {
            centre: 0.0,
            width: 1.0,
        };
        let size = Signal::Sum(vec![Signal::constant(1.0), excess]);
        let start = State::moving([3.0 * libm::cos(theta0), 3.0 * libm::sin(theta0)]);
        let motion = run(&Plane::along([-1.0, 0.0], size), 1.0, start, t + 1.0)?;
        let (before, after) = (motion.at(t)?.speed(), motion.at(t + 1.0)?.speed());
        // Above 1 at all times, if by less than rounding.
        let strong = speeds_up_above() <= 1.0;
        Ok(Pair {
            at: format!("|A| = μg (1 + exp(−t²)), v₀ = 3, θ₀ = {theta0:.6}, t = {t:.6}"),
            stated: if strong { after.max(before) } else { after },
            found: after,
            scale: before,
        })
    }),
    across_census,
    across_quadrature = Trial::quadrature(
        Printed,
        [
            r"$-\int\mu g/v\,\mathrm dt$ along the motion",
            r"the change of $\ln\lvert v_\perp\rvert$",
        ],
    )
    .over(fixed_direction(), |case| {
        let until = 0.5 * case.start.speed() / (1.0 + case.largest);
        let until = case.plane.next_break(0.0).map_or(until, |b| until.min(b));
        let motion = run(&case.plane, 1.0, case.start, until)?;
        let rate = |t: f64| motion.at(t).map_or(f64::NAN, |s| 1.0 / s.speed());
        let size = integral_within(rate, 0.0, until, 1e-14)?.value;
        Ok(Pair::plain(
            format!("{}, t = {until:.6}", case.name),
            printed::s2_across_trend::<f64>() * size,
            libm::log(case.across(&motion.end()) / case.across(&case.start)),
        ))
    }),
    across_limit = {
        let bounded = fixed_direction().filter(|case| case.largest.is_finite());
        Trial::by(
            Limit,
            Printed,
            Compared::constant(
                "the stated 0",
                r"$\lvert v_\perp\rvert/v_0$ after a long time, with $A$ bounded by twice $\mu g$,",
            ),
            VANISHES,
        )
        .over(bounded, |case| {
            let size = case.start.speed();
            // It never grows: most need not be followed to the end, where it would be below any number of interest.
            let mut late = case.late / 64.0;
            let mut found = f64::INFINITY;
            while late < case.late && found > 1e-3 * VANISHES.value * size {
                late *= 2.0;
                found = case.across(&run(&case.plane, 1.0, case.start, late)?.end());
            }
            Ok(Pair {
                at: format!("{}, t = {late:.6}", case.name),
                stated: size * printed::s2_across_limit::<f64>(),
                found,
                scale: size,
            })
        })
    },
    across_integration,
    across_outside
];

#[cfg(test)]
mod tests {
    use super::*;

    fn along_x(v: [f64; 2]) -> State {
        State { v, ..AT_REST }
    }

    /// The steps of a motion that take time.
    fn steps(plane: &Plane, start: State, until: f64) -> usize {
        let motion = run(plane, 1.0, start, until).unwrap();
        let times: Vec<_> = motion.nodes().map(|s| s.t).collect();
        times.windows(2).filter(|w| w[0] < w[1]).count()
    }

    #[test]
    fn steps_without_a_fall_and_late_stops_are_counted() {
        let case = |a: f64, friction: f64| Case {
            name: String::new(),
            plane: Plane::constant([a, 0.0]),
            friction,
            start: along_x([-1.0, 0.0]),
        };
        let broken = |case: Case| unlike_a_stop(&case).unwrap();
        assert_eq!(broken(case(0.95, 1.0)), 0);
        assert_eq!(broken(case(0.95, 1.0 - 1e-6)), 1);
        let pulled = case(2.0, 1.0);
        let all = steps(&pulled.plane, pulled.start, 20.0 * (1.0 + 1e-9));
        assert!(all > 1);
        assert_eq!(broken(pulled), all + 1);
    }

    #[test]
    fn a_change_beyond_rounding_has_a_sense() {
        assert_eq!(
            [-3e-12, -1e-12, 3e-12].map(|by| sense(by, 1.0)),
            [-1.0, 0.0, 1.0]
        );
    }

    #[test]
    fn rests_longer_than_a_period_are_counted() {
        let phase = |kind, to| Phase {
            kind,
            from: 0.0,
            to,
        };
        let phases = [
            phase(PhaseKind::Stick, 2.0),
            phase(PhaseKind::Stick, 2.0 + 1e-8),
            phase(PhaseKind::Stick, 3.5),
            phase(PhaseKind::Slide, 9.0),
        ];
        assert_eq!(long_rests(&phases, 2.0), 2);
        assert_eq!(long_rests(&phases[..1], 2.0), 0);
        assert_eq!(long_rests(&phases, 3.5), 0);
    }

    #[test]
    fn a_slide_counts_only_while_it_lasts() {
        let phase = |kind, from, to| Phase { kind, from, to };
        let phases = [
            phase(PhaseKind::Stick, 0.0, 2.0),
            phase(PhaseKind::Slide, 2.0, 3.0),
            phase(PhaseKind::Stick, 3.0, 9.0),
        ];
        for (from, to, slid) in [
            (0.0, 1.0, false),
            (1.0, 2.0, false),
            (1.0, 2.5, true),
            (2.2, 2.4, true),
            (2.5, 4.0, true),
            (1.0, 4.0, true),
            (3.0, 4.0, false),
            (5.0, 6.0, false),
        ] {
            assert_eq!(slides(&phases, from, to), slid, "{from} to {to}");
        }
    }

    /// During the push the speed grows as (A − μg) t.
    #[test]
    fn a_push_leaves_what_exceeds_friction() {
        for (strength, length) in [(3.0, 0.25), (1.5, 1.0)] {
            let speed = pushed(strength, length).unwrap();
            assert!((speed - (strength - 1.0) * length).abs() < 1e-14, "{speed}");
        }
    }

    #[test]
    fn growth_across_is_counted() {
        let case = |normal: [f64; 2]| Across {
            name: String::new(),
            plane: Plane::constant([-3.0, 0.0]),
            start: along_x([1.0, 1.0]),
            normal,
            largest: 3.0,
            late: 0.0,
        };
        let along = case([1.0, 0.0]);
        let all = steps(&along.plane, along.start, 10.0);
        assert!(all > 1);
        assert_eq!(grows_across(&along).unwrap(), all);
        assert_eq!(grows_across(&case([0.0, 1.0])).unwrap(), 0);
    }

    /// Worked by hand: 3 · 2⁻² and 5 · 3⁻¹ᐟ².
    #[test]
    fn the_bound_across_is_a_power_of_the_bound_of_the_speed() {
        let near = |value: f64, expected: f64| assert!((value - expected).abs() < 1e-15, "{value}");
        near(across_bound(3.0, 2.0, 0.5, 4.0), 0.75);
        near(across_bound(5.0, 2.0, 2.0, 2.0), 5.0 / libm::sqrt(3.0));
    }
}
