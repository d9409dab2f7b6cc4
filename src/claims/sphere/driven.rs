//! Trials of (84), (85) and of the statements about a plane that swings: 3.2 to 3.4.

use super::every_drive::rolling_time;
use super::prelude::*;
use crate::claims::anisotropic::simulated::{from_forward, own_digits};
use crate::claims::periodic::drives::Harmonics;
use crate::claims::sinusoidal::reference_motions::drive;
use crate::claims::sinusoidal::regimes::{kind, listed_kind};
use crate::motion::drive::{Attractor, DriveState, Friction, Interval};
use crate::paper::{periodic, sinusoidal};

/// Periods.
const SETTLED: f64 = 10.0;

/// Under sin φ a motion forgets its start in its first rest.
fn settled_after(lambda: f64) -> f64 {
    if lambda > 0.6 { 3.0 } else { SETTLED }
}

fn settled_phase(lambda: f64) -> f64 {
    settled_after(lambda) * TAU
}

/// A sphere on a plane that swings along x with the angular frequency ϖ: A = −A₀ h(ϖ t) x̂.
#[derive(Debug, Clone, Copy)]
pub(super) struct Swing {
    pub(super) sphere: Sphere,
    a0: f64,
    frequency: f64,
    lambda: f64,
}

impl Swing {
    pub(super) fn new(i: usize, points: &mut Points, lambda: f64) -> Self {
        let sphere = sphere(i, points);
        Swing {
            sphere,
            a0: braking(&sphere) / lambda,
            frequency: points.uniform(0.5, 4.0),
            lambda,
        }
    }

    fn sine(&self) -> Plane {
        let sine = Signal::Sine {
            frequency: self.frequency,
            phase: 0.0,
        };
        Plane::along([1.0, 0.0], sine.times(-self.a0))
    }

    pub(super) fn harmonics(&self, shape: &Harmonics) -> Plane {
        let sine = |[k, a, phase]: [f64; 3]| {
            let frequency = k * self.frequency;
            Signal::Sine { frequency, phase }.times(-self.a0 * a)
        };
        Plane::along([1.0, 0.0], Signal::Sum(shape.terms().map(sine).collect()))
    }

    /// Pulses of (42) and (43): half the difference of two square waves, one later by ηπ.
    fn pulses(&self, eta: f64) -> Plane {
        let half = PI / self.frequency;
        let square = |start: f64| Signal::Square { start, half };
        let late = square(eta * half).times(-1.0);
        let both = Signal::Sum(vec![square(0.0), late]);
        Plane::along([1.0, 0.0], both.times(-0.5 * self.a0))
    }

    pub(super) fn t(&self, phi: f64) -> f64 {
        phi / self.frequency
    }

    /// A start at φ = 0 with slip `w` in units of A₀/ϖ, shared between the centre and the turning.
    pub(super) fn start(&self, w: f64, share: f64) -> Ball {
        let slip = w * self.a0 / self.frequency;
        let radius = self.sphere.radius;
        Ball {
            t: 0.0,
            x: [0.0; 2],
            v: [share * slip, 0.0],
            omega: [0.0, -(1.0 - share) * slip / radius, 0.3],
        }
    }

    /// b by (67), with κ by (62).
    fn b(&self) -> f64 {
        let Sphere {
            inertia,
            mass,
            radius,
            ..
        } = self.sphere;
        printed::eq67_factor(printed::eq62_kappa(inertia, mass, radius))
    }

    /// λ₀ by (84).
    pub(super) fn stated(&self) -> f64 {
        printed::eq84_lambda(self.b(), self.sphere.mu, self.sphere.g, self.a0)
    }

    /// λ₀ by (85), μ being that of slip towards +x.
    fn stated_plus(&self) -> f64 {
        printed::eq85_lambda(self.b(), self.sphere.mu, self.sphere.g, self.a0)
    }

    pub(super) fn at(&self) -> String {
        format!(
            "λ₀ = {:.6}, κ = {:.6}, μ = {:.6}",
            self.lambda,
            self.sphere.kappa(),
            self.sphere.mu
        )
    }
}

fn settled(drive: &Drive, friction: Friction) -> Result<Attractor<'_>, Failure> {
    let start = DriveState { phi: 0.0, w: 0.0 };
    let outcome = drive.attractor(friction, start, 1000)?;
    Ok(outcome.settled().ok_or("the drive does not settle")?)
}

/// 𝔴 at the phase `phi` of the motion under sin φ from `w` at φ = 0; NaN for a friction below zero, which none has.
fn w_after(plus: f64, minus: f64, w: f64, phi: f64) -> f64 {
    let end = || -> Result<f64, Failure> {
        let friction = Friction::new(plus, minus)?;
        let moved = drive()?.advance(friction, DriveState { phi: 0.0, w }, phi)?;
        Ok(moved.end.w)
    };
    end().unwrap_or(f64::NAN)
}

/// NaN for a friction below zero, with which there is no periodic motion.
pub(super) fn of_settled(
    drive: &Drive,
    plus: f64,
    minus: f64,
    of: impl Fn(&[Interval]) -> f64,
) -> f64 {
    let given = || -> Result<f64, Failure> {
        let attractor = settled(drive, Friction::new(plus, minus)?)?;
        Ok(of(attractor.intervals()))
    };
    given().unwrap_or(f64::NAN)
}

pub(super) fn part(intervals: &[Interval], sign: Sign) -> f64 {
    let own = intervals.iter().filter(|i| i.sign == sign);
    own.map(Interval::length).sum::<f64>() / TAU
}

fn stated_kind(lambda: f64, lambda_c: f64) -> f64 {
    if lambda > 1.0 {
        -1.0
    } else if lambda > lambda_c {
        20.0
    } else {
        2.0
    }
}

fn rolled(motion: &BallMotion, from: f64, to: f64) -> Result<f64, Failure> {
    let within: Vec<_> = motion
        .transitions()
        .iter()
        .filter(|c| c.t > from && c.t <= to)
        .collect();
    let begun = |kind: Contact| {
        let before = |i: usize| {
            if i == 0 {
                motion.contact(from)
            } else {
                Ok(within[i - 1].to)
            }
        };
        (0..within.len())
            .filter(|i| within[*i].to == kind && before(*i) == Ok(Contact::Sliding))
            .count()
    };
    let throughout = within.is_empty() && motion.contact(to)? == Contact::Rolling;
    Ok(kind(
        begun(Contact::Sliding),
        begun(Contact::Rolling),
        throughout,
    ))
}

fn lambda_c() -> Result<f64, Failure> {
    static LAMBDA: Runs<f64> = Runs::new(|| {
        let rests = |lambda: f64| -> Result<bool, Failure> {
            let attractor = settled(drive()?, Friction::new(lambda, lambda)?)?;
            Ok(listed_kind(attractor.intervals()) == 20.0)
        };
        let (mut low, mut high) = (0.1, 0.9);
        for _ in 0..50 {
            let middle = 0.5 * (low + high);
            *(if rests(middle)? { &mut high } else { &mut low }) = middle;
        }
        Ok(high)
    });
    LAMBDA.get().copied()
}

/// With μ₋ = qμ₊, and λ₀ of (85).
fn directed(i: usize, points: &mut Points, q: f64, lambda: f64) -> (Swing, Directed) {
    let swing = Swing::new(i, points, lambda);
    let sphere = swing.sphere;
    (
        swing,
        Directed {
            sphere,
            mu_minus: q * sphere.mu,
        },
    )
}

fn eq85() -> Evidence {
    let trial = Trial::consistency(
        Printed,
        [
            r"$\mathfrak w$ of the drive with $\lambda_+=\lambda_0$ of (85) and $\lambda_-=q\lambda_0$",
            r"$\varpi w_x/A_0$ of the sphere's slip velocity $\bm w$",
        ],
    );
    trial.drawn(0..30, |i, points| {
        let (q, lambda) = (points.uniform(1.0, 7.0), points.uniform(0.05, 1.4));
        let (swing, directed) = directed(i, points, q, lambda);
        let (w, share) = (points.uniform(-2.0, 2.0), points.uniform(-1.0, 2.0));
        let phi = points.uniform(1.0, 15.0);
        let lambda = swing.stated_plus();
        let stated = w_after(lambda, q * lambda, w, phi);
        let start = swing.start(w, share);
        let motion = directed.run(
            &swing.sine(),
            [start.v[0], start.omega[1]],
            0.0,
            swing.t(phi),
        )?;
        Ok(Pair {
            at: format!("{}, q = {q:.6}, 𝔴 = {w:.6}, φ = {phi:.6}", swing.at()),
            stated,
            found: motion.end.slip * swing.frequency / swing.a0,
            scale: 1.0 + w.abs(),
        })
    })
}

/// λ₀ on both sides of every boundary, close to it and all over.
fn frictions(lambda_c: f64) -> Vec<f64> {
    let close = [1e-2, 1e-4, 1e-6];
    let around = |at: f64| {
        close
            .into_iter()
            .flat_map(move |d| [at * (1.0 - d), at * (1.0 + d)])
    };
    let wide = (1..=8).map(|k| 0.1875 * f64::from(k));
    around(lambda_c).chain(around(1.0)).chain(wide).collect()
}

pub(crate) fn trichotomy_census() -> Evidence {
    let trial = Trial::census(
        Within,
        [
            r"the number of zeros plus ten times that of rests in a period (with $\lambda_0$ by (84), 2 below $\lambda_\mathrm c$ of (37), 20 above, $-1$ for rest throughout above 1)",
            "the same count of changes between sliding and rolling of a sphere in a late period",
        ],
    );
    let mut points = Points::here();
    let cases = parts(lambda_c().map(frictions));
    trial.over(cases.enumerate(), |(i, lambda)| {
        let lambda = lambda?;
        let swing = Swing::new(i, &mut points, lambda);
        let start = swing.start(points.uniform(-1.0, 1.0), points.uniform(-1.0, 2.0));
        let late = settled_phase(lambda) + 0.1;
        let (from, to) = (swing.t(late), swing.t(late + TAU));
        let motion = swing.sphere.run(&swing.sine(), &start, to)?;
        Ok(Pair::plain(
            swing.at(),
            stated_kind(swing.stated(), sinusoidal::eq37_lambda_c()),
            rolled(&motion, from, to)?,
        ))
    })
}

pub(crate) fn trichotomy_motion() -> Evidence {
    Trial::motion(
        Within,
        [
            r"the part of a period in which the drive's motion, $\lambda_0$ by (84), rests",
            "that of a late period in which a sphere, started in any direction, rolls",
        ],
    )
    .drawn(0..20, |i, points| {
        let lambda = points.uniform(0.25, 1.5);
        let swing = Swing::new(i, points, lambda);
        let mut start = swing.start(points.uniform(-1.0, 1.0), points.uniform(-1.0, 2.0));
        start.v[1] = points.uniform(-1.0, 1.0) * swing.a0 / swing.frequency;
        let late = settled_phase(lambda);
        let (from, to) = (swing.t(late), swing.t(late + TAU));
        let motion = swing.sphere.run(&swing.sine(), &start, to)?;
        let (drive, lambda) = (drive()?, swing.stated());
        Ok(Pair::plain(
            swing.at(),
            of_settled(drive, lambda, lambda, |all| part(all, Sign::Rest)),
            rolling_time(&motion, from, to)? / (to - from),
        ))
    })
}

pub(crate) fn trichotomy_outside() -> Evidence {
    let trial = Trial::census(
        Outside,
        Compared::constant(
            "the stated 2",
            r"the number of zeros in a period of a slip without friction, of starts with $\mathfrak w>0$ at $\phi=0$,",
        ),
    );
    trial.drawn(0..24, |_, points| {
        let w = points.uniform(0.1, 2.5);
        let outcome =
            drive()?.attractor(Friction::new(0.0, 0.0)?, DriveState { phi: 0.0, w }, 100)?;
        let attractor = outcome.settled().ok_or("the drive does not settle")?;
        Ok(Pair::plain(
            format!("λ₀ = 0, 𝔴 = {w:.6} at φ = 0"),
            2.0,
            listed_kind(attractor.intervals()),
        ))
    })
}

fn pulse_points(points: &mut Points, count: usize) -> Vec<(f64, f64)> {
    let point = |i: usize| {
        let eta = points.uniform(0.1, 0.9);
        let lambda = match i % 4 {
            0 => eta * (1.0 - points.log_uniform(1e-6, 0.5)),
            1 => eta + (1.0 - eta) * points.log_uniform(1e-6, 0.9),
            2 => points.uniform(0.1, 1.0),
            _ => 1.0 + points.log_uniform(1e-6, 0.5),
        };
        (eta, lambda)
    };
    (0..count).map(point).collect()
}

fn pulse_motion() -> Evidence {
    let mut points = Points::here();
    let all = pulse_points(&mut points, 20);
    Trial::motion(
        Printed,
        [
            r"the part of a period in which the drive's motion, $\lambda_0$ by (84), rests",
            "that of a late period in which the sphere rolls, under the pulses",
        ],
    )
    .over(all.into_iter().enumerate(), |(i, (eta, lambda))| {
        let swing = Swing::new(i, &mut points, lambda);
        let start = swing.start(points.uniform(-1.0, 1.0), points.uniform(-1.0, 2.0));
        let (from, to) = (swing.t(SETTLED * TAU), swing.t((SETTLED + 1.0) * TAU));
        let motion = swing.sphere.run(&swing.pulses(eta), &start, to)?;
        let end = eta * PI;
        let h = |phi: f64| {
            if phi < end {
                1.0
            } else if phi < PI {
                0.0
            } else if phi < PI + end {
                -1.0
            } else {
                0.0
            }
        };
        let drive = Drive::new(h, &[0.0, end, PI, PI + end])?;
        let lambda = swing.stated();
        Ok(Pair::plain(
            format!("η = {eta:.6}, {}", swing.at()),
            of_settled(&drive, lambda, lambda, |all| part(all, Sign::Rest)),
            rolling_time(&motion, from, to)? / (to - from),
        ))
    })
}

/// From a whole number of periods on.
fn late_stretches(
    swing: &Swing,
    directed: &Directed,
    w: f64,
) -> Result<(Vec<i8>, [f64; 3]), Failure> {
    let (from, to) = (swing.t(SETTLED * TAU), swing.t((SETTLED + 1.0) * TAU));
    let start = swing.start(w, 0.7);
    let motion = directed.run(&swing.sine(), [start.v[0], start.omega[1]], 0.0, to)?;
    let mut ways = Vec::new();
    let mut lengths = [0.0; 3];
    for stretch in motion.stretches.iter().filter(|s| s.to > from) {
        ways.push(stretch.way);
        lengths[(stretch.way + 1) as usize] += (stretch.to - stretch.from.max(from)) / (to - from);
    }
    // The last stretch goes on as the first.
    if ways.len() > 1 && ways.first() == ways.last() {
        ways.pop();
    }
    Ok((ways, lengths))
}

fn map_points(points: &mut Points, count: usize) -> Vec<(f64, f64)> {
    (0..count)
        .map(|_| (points.uniform(1.0, 7.0), points.uniform(0.05, 1.4)))
        .collect()
}

/// Of a solid sphere on a swinging plane, over two late periods.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Swinging {
    /// λ₀ of (84).
    pub lambda: f64,
    /// (φ, ϖ w_x/A₀, ϖ v_x/A₀), φ from 0 to 4π; all dimensionless.
    pub points: Vec<[f64; 3]>,
    /// Phases between which it rolls.
    pub rolls: Vec<[f64; 2]>,
}

pub(crate) fn swinging(lambda: f64) -> Result<Swinging, Failure> {
    let sphere = Sphere::with_kappa(0.4);
    let swing = Swing {
        sphere,
        a0: braking(&sphere) / lambda,
        frequency: 1.0,
        lambda,
    };
    let (from, to) = (SETTLED * TAU, (SETTLED + 2.0) * TAU);
    let motion = swing
        .sphere
        .run(&swing.sine(), &swing.start(0.0, 0.0), to)?;
    let samples = 480;
    let mut points = Vec::new();
    let mut mean = 0.0;
    for k in 0..=samples {
        let t = from + (to - from) * f64::from(k) / f64::from(samples);
        let v = motion.at(t)?.v[0];
        if k < samples {
            mean += v / f64::from(samples);
        }
        points.push([t - from, motion.slip(t)?[0] / swing.a0, v / swing.a0]);
    }
    // The centre's mean velocity depends on the start: it is left out.
    for point in &mut points {
        point[2] -= mean / swing.a0;
    }
    let mut rolls = Vec::new();
    let mut since = (motion.contact(from)? == Contact::Rolling).then_some(0.0);
    for change in motion.transitions().iter().filter(|c| c.t > from) {
        match (change.to, since) {
            (Contact::Rolling, None) => since = Some(change.t - from),
            (Contact::Sliding, Some(begin)) => {
                rolls.push([begin, change.t - from]);
                since = None;
            }
            _ => {}
        }
    }
    rolls.extend(since.map(|begin| [begin, to - from]));
    Ok(Swinging {
        lambda,
        points,
        rolls,
    })
}

attempts![
    eq84 = Trial::consistency(
        Printed,
        [
            r"$\mathfrak w$ of the one-dimensional drive with $\lambda_0$ by (84)",
            r"$\varpi w_x/A_0$ of the sphere's slip velocity $\bm w$",
        ],
    )
    .drawn(0..20, |i, points| {
        let lambda = points.uniform(0.05, 1.5);
        let swing = Swing::new(i, points, lambda);
        let (w, share) = (points.uniform(-2.0, 2.0), points.uniform(-1.0, 2.0));
        let phi = points.uniform(1.0, 15.0);
        let lambda = swing.stated();
        let stated = w_after(lambda, lambda, w, phi);
        let motion = swing
            .sphere
            .run(&swing.sine(), &swing.start(w, share), swing.t(phi))?;
        let found = motion.slip(swing.t(phi))?[0] * swing.frequency / swing.a0;
        Ok(Pair {
            at: format!("{}, 𝔴 = {w:.6}, φ = {phi:.6}", swing.at()),
            stated,
            found,
            scale: 1.0 + w.abs(),
        })
    }),
    eq85,
    trichotomy_census,
    trichotomy_motion,
    rolling_ends = Trial::by(
        Root,
        Within,
        [
            r"the root $\phi$ of $\sin\phi=\lambda_0$, with $\lambda_0$ by (84),",
            r"the phase at which a sphere that rolls at $\phi=0$ begins to slide",
        ],
        MOTION,
    )
    .drawn(0..24, |i, points| {
        let lambda = points.uniform(0.05, 0.95);
        let swing = Swing::new(i, points, lambda);
        let stated = root(|phi| libm::sin(phi) - swing.stated(), 0.0, FRAC_PI_2);
        let motion = swing
            .sphere
            .run(&swing.sine(), &swing.start(0.0, 0.4), swing.t(2.0))?;
        let first = motion.transitions().first().ok_or("it does not slide")?;
        Ok(Pair {
            at: swing.at(),
            // There is no root beyond 1.
            stated: stated.unwrap_or(f64::NAN),
            found: first.t * swing.frequency,
            scale: 1.0 / libm::sqrt(1.0 - lambda * lambda),
        })
    }),
    trichotomy_outside,
    pulse_census = {
        let trial = Trial::census(
            Printed,
            [
                r"the number of zeros plus ten times that of rests in a period (with $\lambda_0$ by (84), 2 below $\lambda_\mathrm c$ of (46), 20 above, $-1$ for rest throughout above 1)",
                "that of a sphere's late period under the pulses",
            ],
        );
        let mut points = Points::here();
        let all = pulse_points(&mut points, 20);
        trial.over(all.into_iter().enumerate(), |(i, (eta, lambda))| {
            let swing = Swing::new(i, &mut points, lambda);
            let start = swing.start(points.uniform(-1.0, 1.0), points.uniform(-1.0, 2.0));
            let (from, to) = (
                swing.t(SETTLED * TAU + 0.01),
                swing.t((SETTLED + 1.0) * TAU + 0.01),
            );
            let motion = swing.sphere.run(&swing.pulses(eta), &start, to)?;
            Ok(Pair::plain(
                format!("η = {eta:.6}, {}", swing.at()),
                stated_kind(swing.stated(), periodic::eq46_lambda_c(eta)),
                rolled(&motion, from, to)?,
            ))
        })
    },
    pulse_motion,
    anisotropic_census = {
        let trial = Trial::census(
            Printed,
            [
                r"the order of slips and rests in a period of the drive, with $\lambda_0$ by (85) (3 for a forward slip, 2 for a rest, 1 for a backward slip),",
                "that of the sphere's slip",
            ],
        );
        let mut points = Points::here();
        let all = map_points(&mut points, 40);
        trial.over(all.into_iter().enumerate(), |(i, (q, lambda))| {
            let (swing, directed) = directed(i, &mut points, q, lambda);
            let (ways, _) = late_stretches(&swing, &directed, points.uniform(-1.0, 1.0))?;
            let (drive, lambda) = (drive()?, swing.stated_plus());
            Ok(Pair::plain(
                format!("q = {q:.6}, {}", swing.at()),
                of_settled(drive, lambda, q * lambda, own_digits),
                from_forward(ways.into_iter().map(f64::from).collect()),
            ))
        })
    },
    anisotropic_motion = {
        let trial = Trial::motion(
            Printed,
            Compared::many(
                r"the parts of a period of backward motion and rest, the second one taken twice, of the drive with $\lambda_0$ of (85), where it rests at all,",
                "those of the sphere's slip",
            ),
        );
        let mut points = Points::here();
        let resting = |(q, lambda): &(f64, f64)| q * lambda > 1.0;
        let all = map_points(&mut points, 40).into_iter().filter(resting);
        trial.over(all.enumerate(), |(i, (q, lambda))| {
            let (swing, directed) = directed(i, &mut points, q, lambda);
            let (_, lengths) = late_stretches(&swing, &directed, points.uniform(-1.0, 1.0))?;
            let (drive, lambda) = (drive()?, swing.stated_plus());
            Ok(Pair::plain(
                format!("q = {q:.6}, {}", swing.at()),
                of_settled(drive, lambda, q * lambda, |all| {
                    part(all, Sign::Negative) + 2.0 * part(all, Sign::Rest)
                }),
                lengths[0] + 2.0 * lengths[1],
            ))
        })
    }
];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::Acceleration;

    #[test]
    fn a_motion_settles_in_three_periods_or_ten() {
        assert_eq!([0.5, 0.6, 0.7].map(settled_after), [10.0, 10.0, 3.0]);
        assert_eq!(settled_phase(0.7), 6.0 * PI);
    }

    /// −A₀ h(ϖ t), h by (42), (43): 1 for ηπ, nothing, −1 for ηπ, nothing.
    #[test]
    fn the_pulses_are_those_of_the_drive() {
        let mut points = Points::here();
        let swing = Swing::new(0, &mut points, 0.5);
        let plane = swing.pulses(0.25);
        for (phi, h) in [
            (0.1, 1.0),
            (0.7, 1.0),
            (0.9, 0.0),
            (3.0, 0.0),
            (3.3, -1.0),
            (4.0, 0.0),
            (6.4, 1.0),
        ] {
            let [x, y] = plane.coefficients(swing.t(phi)).map(|c| c[0]);
            assert_eq!([x, y], [-h * swing.a0, 0.0], "φ = {phi}");
        }
    }

    /// With λ₀ > 1 friction is never exceeded.
    #[test]
    fn a_sphere_that_always_rolls_rolls_to_the_end() {
        let swinging = swinging(1.5).unwrap();
        assert_eq!(swinging.rolls.len(), 1);
        let [begin, end] = swinging.rolls[0];
        assert_eq!(begin, 0.0);
        assert!((end - 4.0 * PI).abs() < 1e-13, "{end}");
    }
}
