//! Motions that several trials of the statements about every A(t) look at.

use super::accelerations::{SHAPES, along_a_line, any_start};
use super::prelude::*;

/// Five periods of a motion from rest.
pub(super) struct Returning {
    pub name: String,
    /// What |A| reaches in every period, over μg.
    pub size: f64,
    pub period: f64,
    pub phases: Vec<Phase>,
}

/// Of accelerations that exceed μg again and again, then of those that never do.
pub(super) static RETURNING: Runs<Vec<Returning>> = Runs::new(all_returning);

pub(super) static OTHERS_RETURNING: Runs<Vec<Returning>> = Runs::new(|| others(all_returning));

fn all_returning() -> Result<Vec<Returning>, Failure> {
    let returning = |(name, plane, size, period)| -> Result<_, Failure> {
        let motion = run(&plane, 1.0, AT_REST, 5.0 * period)?;
        Ok(Returning {
            name,
            size,
            period,
            phases: motion.phases().to_vec(),
        })
    };
    let all = strong_that_return().chain(weak_that_return());
    every(all.map(returning))
}

/// Larger than μg once a period at least, from 1.1 to 3 times, of all shapes; friction 1.
fn strong_that_return() -> impl Iterator<Item = (String, Plane, f64, f64)> {
    const KINDS: [&str; 7] = [
        "oscillating",
        "sign-changing",
        "pulsed",
        "constant",
        "growing",
        "decaying",
        "rotating",
    ];
    periodic(&KINDS, [1.1, 3.0])
}

/// Of the shapes that are bounded by their size, from 0.2 to 0.95 μg; friction 1.
fn weak_that_return() -> impl Iterator<Item = (String, Plane, f64, f64)> {
    const KINDS: [&str; 5] = [
        "oscillating",
        "sign-changing",
        "pulsed",
        "constant",
        "rotating",
    ];
    periodic(&KINDS, [0.2, 0.95])
}

fn periodic(
    kinds: &'static [&'static str],
    [low, high]: [f64; 2],
) -> impl Iterator<Item = (String, Plane, f64, f64)> {
    let mut points = Points::here();
    kinds.iter().cycle().take(28).map(move |kind| {
        let (size, period) = (points.uniform(low, high), points.log_uniform(0.5, 5.0));
        let frequency = std::f64::consts::TAU / period;
        let sine = Signal::Sine {
            frequency,
            phase: 0.0,
        };
        let signal = match *kind {
            "oscillating" => sine,
            "sign-changing" => Signal::Square {
                start: 0.0,
                half: 0.5 * period,
            },
            "pulsed" => Signal::Product(vec![sine.clone(), sine]),
            "growing" => Signal::Polynomial(vec![0.0, 1.0 / period]),
            "decaying" => Signal::Sum(vec![
                Signal::constant(1.0),
                Signal::Exponential {
                    rate: -0.2 / period,
                },
            ]),
            _ => Signal::constant(1.0),
        };
        let direction = points.uniform(-3.1, 3.1);
        let along = [size * libm::cos(direction), size * libm::sin(direction)];
        let plane = match *kind {
            "rotating" => Plane::rotating(Signal::constant(size), frequency, direction),
            _ => Plane::along(along, signal),
        };
        let name = format!("{kind} A of size {size:.6}, period {period:.6}, μg = 1");
        (name, plane, size, period)
    })
}

/// What an acceleration of fixed direction does from t = 200 to 400.
pub(super) struct Pulled {
    pub name: String,
    /// What |A| is never below, over μg.
    pub least: f64,
    /// The steps on which the speed does not grow.
    pub falls: usize,
    pub gained: f64,
}

impl Pulled {
    pub(super) fn grows(&self) -> bool {
        self.falls == 0 && self.gained > 0.0
    }
}

/// All strong accelerations, then weak ones.
pub(super) static PULLED: Runs<Vec<Pulled>> = Runs::new(all_pulled);

pub(super) static OTHERS_PULLED: Runs<Vec<Pulled>> = Runs::new(|| others(all_pulled));

fn all_pulled() -> Result<Vec<Pulled>, Failure> {
    let pulled = |(name, plane, least, start)| -> Result<_, Failure> {
        let motion = run(&plane, 1.0, start, 400.0)?;
        Ok(Pulled {
            name,
            least,
            falls: falls(&motion, 200.0),
            gained: motion.end().speed() - motion.at(200.0)?.speed(),
        })
    };
    every(strong().chain(weak()).map(pulled))
}

fn falls(motion: &Motion, from: f64) -> usize {
    violations(motion, from, |a, b| b.t > a.t && b.speed() <= a.speed())
}

/// |A| of 1.2 to 3 with a part that decays, oscillates or grows; friction 1.
fn strong() -> impl Iterator<Item = (String, Plane, f64, State)> {
    let mut points = Points::here();
    (0..32).map(move |i| {
        let rate = points.log_uniform(0.1, 3.0);
        let shape = [0, 2, 3, 4][i % 4];
        let steady = points.uniform(2.2, 3.0);
        let size = Signal::Sum(vec![Signal::constant(steady), along_a_line(shape, rate)]);
        let direction = points.uniform(-3.1, 3.1);
        let speed = points.log_uniform(0.2, 3.0);
        let start = any_start(&mut points, speed);
        let name = format!(
            "|A| ≥ 1.2, {} part of rate {rate:.6}, μg = 1, v = ({:.6}, {:.6})",
            SHAPES[shape], start.v[0], start.v[1]
        );
        let along = [libm::cos(direction), libm::sin(direction)];
        let least = match SHAPES[shape] {
            "oscillating" => steady - 1.0,
            "decaying" => steady,
            _ => steady + 1.0,
        };
        (name, Plane::along(along, size), least, start)
    })
}

/// |A| of 0.2 to 0.9, constant but for its sign; friction 1.
fn weak() -> impl Iterator<Item = (String, Plane, f64, State)> {
    let mut points = Points::here();
    (0..16).map(move |i| {
        let shape = [0, 5][i % 2];
        let (size, rate) = (points.uniform(0.2, 0.9), points.log_uniform(0.1, 3.0));
        let direction = points.uniform(-3.1, 3.1);
        let speed = points.log_uniform(0.2, 3.0);
        let start = any_start(&mut points, speed);
        let name = format!(
            "|A| = {size:.6}, {}, rate {rate:.6}, μg = 1, v = ({:.6}, {:.6})",
            SHAPES[shape], start.v[0], start.v[1]
        );
        let along = [size * libm::cos(direction), size * libm::sin(direction)];
        (
            name,
            Plane::along(along, along_a_line(shape, rate)),
            size,
            start,
        )
    })
}

pub(super) const AT_REST: State = State::moving([0.0; 2]);

/// Of neighbouring nodes, from a time on.
pub(super) fn violations(
    motion: &Motion,
    from: f64,
    broken: impl Fn(&State, &State) -> bool,
) -> usize {
    let nodes: Vec<_> = motion.nodes().filter(|s| s.t >= from).collect();
    nodes.windows(2).filter(|w| broken(&w[0], &w[1])).count()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::Acceleration;

    #[test]
    fn a_speed_grows_if_it_does_on_every_step() {
        let grows = |(falls, gained)| {
            let name = String::new();
            Pulled {
                name,
                least: 2.0,
                falls,
                gained,
            }
            .grows()
        };
        let cases = [(0, 1e-9), (1, 1.0), (0, 0.0), (0, -1.0)];
        assert_eq!(cases.map(grows), [true, false, false, false]);
    }

    #[test]
    fn what_breaks_a_statement_is_counted() {
        let start = State {
            v: [1.0, 1.0],
            ..AT_REST
        };
        let motion = run(&Plane::constant([-1.0, 0.0]), 1.5, start, 5.0).unwrap();
        let stop = motion.first_stop().unwrap();
        let times = motion.nodes().map(|s| s.t);
        let times: Vec<_> = times.filter(|t| *t <= stop).collect();
        let slower = |a: &State, b: &State| b.speed() < a.speed();
        assert!(times.len() > 3, "{times:?}");
        assert_eq!(violations(&motion, 0.0, slower), times.len() - 1);
        assert_eq!(violations(&motion, times[1], slower), times.len() - 2);
        assert_eq!(violations(&motion, 0.0, |a, b| slower(b, a)), 0);
    }

    /// Friction alone slows the particle on every step; a strong pull along its velocity speeds it up on every one.
    #[test]
    fn steps_without_growth_are_counted() {
        let start = State {
            v: [10.0, 0.0],
            ..AT_REST
        };
        let slides = |a: f64| run(&Plane::constant([a, 0.0]), 1.0, start, 5.0).unwrap();
        let motion = slides(0.5);
        let times: Vec<_> = motion.nodes().map(|s| s.t).collect();
        let steps = times.windows(2).filter(|w| w[0] < w[1]).count();
        assert!(steps > 1);
        assert_eq!(falls(&motion, 0.0), steps);
        assert_eq!(falls(&motion, times[1]), steps - 1);
        assert_eq!(falls(&slides(-2.0), 0.0), 0);
    }

    #[test]
    fn accelerations_that_return_have_their_shapes() {
        let e = libm::exp(-0.2);
        let mut kinds = 0;
        for (name, plane, _, period) in strong_that_return() {
            let size: f64 = name.split(&[' ', ','][..]).nth(4).unwrap().parse().unwrap();
            let at = |quarters: f64| {
                plane
                    .coefficients(quarters * period / 4.0)
                    .map(|c| c[0] / size)
            };
            let first = at(1.0);
            // Components along A in the first quarter and across it.
            let seen = |quarters: f64| {
                let ([x, y], length) = (at(quarters), libm::hypot(first[0], first[1]));
                let along = (x * first[0] + y * first[1]) / length;
                [along, (y * first[0] - x * first[1]) / length]
            };
            let kind = name.split(' ').next().unwrap();
            let expected = match kind {
                "oscillating" => [[1.0, 0.0], [0.0, 0.0], [-1.0, 0.0], [1.0, 0.0]],
                "sign-changing" => [[1.0, 0.0], [-1.0, 0.0], [-1.0, 0.0], [1.0, 0.0]],
                "pulsed" => [[1.0, 0.0], [0.0, 0.0], [1.0, 0.0], [1.0, 0.0]],
                "growing" => [[0.25, 0.0], [0.5, 0.0], [0.75, 0.0], [1.25, 0.0]],
                "decaying" => [1.0, 2.0, 3.0, 5.0].map(|n| [1.0 + libm::pow(e, n / 4.0), 0.0]),
                "rotating" => [[1.0, 0.0], [0.0, 1.0], [-1.0, 0.0], [1.0, 0.0]],
                _ => [[1.0, 0.0]; 4],
            };
            for (n, wanted) in [1.0, 2.0, 3.0, 5.0].into_iter().zip(expected) {
                let seen = seen(n);
                let off = libm::hypot(seen[0] - wanted[0], seen[1] - wanted[1]);
                assert!(off < 2e-6, "{name}: {seen:?} after {n} quarters");
            }
            kinds += 1;
        }
        assert_eq!(kinds, 28);
    }
}
