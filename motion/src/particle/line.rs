//! A block on a line, with its own friction for each of the two ways, and a spring if one holds it.
//!
//! ```text
//! sliding:   dv/dt = P(t) − ω²x − μ₊g for v > 0, + μ₋g for v < 0
//! sticking:  v = 0 while −μ₋g ≤ P(t) − ω²x ≤ μ₊g, with the static ones
//! ```
//!
//! Between events x and v are power series in time.

use super::{
    super::{
        acceleration::{Acceleration, check_time},
        error::{MotionError, check},
        trajectory::{Motion, PhaseKind, Piece, State},
    },
    Friction, Run,
};
use crate::numerics::{
    events::{Way, roots},
    taylor::{Coefficients, TERMS, reach},
};

/// A line on a plane.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// Of any length: of the plane's acceleration only what lies along it counts.
    pub along: [f64; 2],
    /// Friction of a block that moves, or is pulled, that way,
    pub plus: Friction,
    /// and the other.
    pub minus: Friction,
    /// ω of the block on a spring that is relaxed at the origin, without friction, in 1/time; 0 for no spring.
    pub frequency: f64,
}

/// A pull within this part of the friction counts as held.
const HELD: f64 = 4.0 * f64::EPSILON;
/// A part of a velocity across the line that is rounding.
const ACROSS: f64 = 1e-14;

type Release = (f64, f64);

impl Line {
    /// The motion from `start`, whose velocity is along the line, until the time `until`, on a plane that accelerates by A(t),
    /// which [pulls](super::super) the block along −A.
    ///
    /// # Errors
    /// As for [`run`](super::run), and [`MotionError::Argument`] for a direction that is zero or not finite, a frequency
    /// that is negative or above 10⁵⁰, and a velocity across the line.
    pub fn run(
        &self,
        plane: &dyn Acceleration,
        start: State,
        until: f64,
    ) -> Result<Motion, MotionError> {
        self.minus.check()?;
        let fit = (0.0..=1e50).contains(&self.frequency);
        check("frequency", self.frequency, fit, "between 0 and 1e50")?;
        let line = Line {
            along: self.direction()?,
            ..*self
        };
        let mut run = Run::new(plane, self.plus, start, until)?;
        check_time(plane, until)?;
        let [e, f] = line.along;
        let across = start.v[1] * e - start.v[0] * f;
        let fit = across.abs() <= ACROSS * start.speed();
        check("v across the line", across, fit, "0")?;
        while run.state.t < until {
            let from = run.state.t;
            let mut release = None;
            if run.state.v == [0.0; 2] {
                release = line.hold(&mut run)?;
                run.close(PhaseKind::Stick, from);
                if release.is_none() {
                    break;
                }
                run.motion.starts.push(run.state.t);
            }
            let from = run.state.t;
            let stopped = loop {
                let turned = line.glide(&mut run, release.take())?;
                if turned || run.state.v == [0.0; 2] || run.state.t >= until {
                    break turned;
                }
            };
            run.close(PhaseKind::Slide, from);
            if stopped {
                run.motion.stops.push(run.state.t);
            }
        }
        run.done()
    }

    /// What friction has turned into heat, per unit of mass, on a way of this length that has led by `moved` in all.
    ///
    /// # Errors
    /// [`MotionError::Argument`] for a direction that is zero or not finite.
    pub fn heat(&self, way: f64, moved: [f64; 2]) -> Result<f64, MotionError> {
        let [e, f] = self.direction()?;
        let led = e * moved[0] + f * moved[1];
        Ok(0.5 * (self.plus.kinetic * (way + led) + self.minus.kinetic * (way - led)))
    }

    fn direction(&self) -> Result<[f64; 2], MotionError> {
        let length = libm::hypot(self.along[0], self.along[1]);
        let fit = length.is_finite() && length > 0.0;
        check("length of along", length, fit, "finite and not zero")?;
        Ok(self.along.map(|c| c / length))
    }

    fn part(&self, vector: [f64; 2]) -> f64 {
        self.along[0] * vector[0] + self.along[1] * vector[1]
    }

    fn pull(&self, a: &[Coefficients; 2]) -> Coefficients {
        std::array::from_fn(|k| -self.part([a[0][k], a[1][k]]))
    }

    fn friction(&self, way: f64) -> Friction {
        if way > 0.0 { self.plus } else { self.minus }
    }

    /// Nothing if the pull does not outgrow friction before the end.
    fn hold(&self, run: &mut Run<'_>) -> Result<Option<Release>, MotionError> {
        while run.state.t < run.until {
            let local = run.local()?;
            let State { t, x, .. } = run.state;
            let mut pull = self.pull(&local.a);
            pull[0] -= self.frequency * self.frequency * self.part(x);
            let mut first: Option<(f64, f64)> = None;
            for way in [1.0, -1.0] {
                let Friction { kinetic, holding } = self.friction(way);
                if way * pull[0] > holding * (1.0 + HELD) {
                    return Ok(Some((way, pull[0] - way * kinetic)));
                }
                let mut excess = pull.map(|c| way * c);
                excess[0] -= holding;
                if excess[0].abs() <= HELD * holding {
                    excess[0] = 0.0;
                    // On the threshold: it goes at once if the pull grows.
                    if excess.iter().find(|c| **c != 0.0).is_some_and(|c| *c > 0.0) {
                        first = Some((0.0, way));
                    }
                }
                let found = roots(&excess, local.left)?;
                let rising = found.iter().find(|root| root.way == Way::Rising);
                if let Some(root) = rising.filter(|root| first.is_none_or(|(at, _)| root.at < at)) {
                    first = Some((root.at, way));
                }
            }
            let to = match (first, local.landing) {
                (Some((at, _)), _) => t + at,
                (None, Some(landing)) => landing,
                (None, None) => t + local.left,
            };
            let rest = State {
                t: to.min(run.until),
                ..run.state
            };
            if to > t {
                run.push(Piece::Rest { from: t, x }, rest);
            }
            if let Some((_, way)) = first {
                let Friction { kinetic, holding } = self.friction(way);
                return Ok(Some((way, way * (holding - kinetic))));
            }
        }
        Ok(None)
    }

    /// Until the velocity is zero: then true; or for as long as a series serves.
    fn glide(&self, run: &mut Run<'_>, release: Option<Release>) -> Result<bool, MotionError> {
        let local = run.local()?;
        let stiffness = self.frequency * self.frequency;
        let pull = self.pull(&local.a);
        let (mut x, mut v) = ([0.0; TERMS], [0.0; TERMS]);
        (x[0], v[0]) = (self.part(run.state.x), self.part(run.state.v));
        let way = release.map_or(v[0].signum(), |(way, _)| way);
        for k in 0..TERMS - 1 {
            let friction = if k == 0 {
                way * self.friction(way).kinetic
            } else {
                0.0
            };
            v[k + 1] = (pull[k] - stiffness * x[k] - friction) / (k + 1) as f64;
            if let (0, Some((_, first))) = (k, release) {
                v[1] = first;
            }
            x[k + 1] = v[k] / (k + 1) as f64;
        }
        let h = local.left.min(reach(&x)).min(reach(&v));
        let turn = roots(&v, h)?
            .into_iter()
            .find(|root| root.way != Way::Touching);
        let landing = local.landing.filter(|_| turn.is_none() && h == local.left);
        let at = turn.map_or(h, |root| root.at);
        run.arc(self.along.map(|e| v.map(|c| e * c)), at, landing);
        if turn.is_some() {
            run.state.v = [0.0; 2];
        }
        Ok(turn.is_some())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Plane, Signal, fitted::tests::noisy, run};

    fn line(along: [f64; 2], plus: f64, minus: f64) -> Line {
        Line {
            along,
            plus: plus.into(),
            minus: minus.into(),
            frequency: 0.0,
        }
    }

    /// Friction 1 there and 2 back: from 3, 9/2 and 9/4 far. A pull is held from −2 to 1; a steady one of 1/2 is half lost there.
    #[test]
    fn each_way_has_its_own_friction() {
        for e in [[1.0, 0.0], [-0.6, 0.8], [3.0, 4.0]] {
            let one = line(e, 1.0, 2.0);
            let unit = one.direction().unwrap();
            let go = |pull: Vec<f64>, v: f64| {
                let plane = Plane::along(unit.map(|c| -c), Signal::Polynomial(pull));
                let motion = one
                    .run(&plane, State::moving(unit.map(|c| c * v)), 9.0)
                    .unwrap();
                let moved = unit[0] * motion.end().x[0] + unit[1] * motion.end().x[1];
                let way = motion.track().unwrap().total();
                (moved, way, one.heat(way, motion.end().x).unwrap(), motion)
            };
            for (v, pull, led) in [
                (3.0, 0.0, 4.5),
                (-3.0, 0.0, -2.25),
                (3.0, 0.5, 9.0),
                (-3.0, 1.0, -1.5),
                (0.0, 1.0, 0.0),
                (0.0, -2.0, 0.0),
                (0.0, 1.5, 0.25 * 81.0),
                (0.0, -2.5, -0.25 * 81.0),
            ] {
                let (moved, way, heat, motion) = go(vec![pull], v);
                assert!(
                    (moved - led).abs() < 1e-13 * (1.0 + led.abs()),
                    "{v} {pull}"
                );
                assert!((way - led.abs()).abs() < 1e-13 * (1.0 + way));
                let end = motion.end().speed();
                let lost = 0.5 * (v * v - end * end) + pull * led;
                assert!((heat - lost).abs() < 1e-12 * (1.0 + way), "{heat} {lost}");
            }
            let (_, way, heat, motion) = go(vec![-2.5], 3.0);
            let stop = 3.0 / 3.5;
            let (there, back) = (1.5 * stop, 0.25 * (9.0 - stop) * (9.0 - stop));
            assert!((motion.stops()[0] - stop).abs() < 1e-14 && motion.starts() == motion.stops());
            assert!((way - there - back).abs() < 1e-12);
            assert!((heat - there - 2.0 * back).abs() < 1e-12, "{heat}");
        }
    }

    /// A pull t/2 is held up to 3/2 and braked by 1; back, −t/2 up to 5/2 and by 2: the force at once is 1/2.
    #[test]
    fn what_holds_more_lets_go_with_a_force() {
        let both = Line {
            plus: Friction {
                kinetic: 1.0,
                holding: 1.5,
            },
            minus: Friction {
                kinetic: 2.0,
                holding: 2.5,
            },
            ..line([1.0, 0.0], 0.0, 0.0)
        };
        for (way, from) in [(1.0, 3.0), (-1.0, 5.0)] {
            let plane = Plane::along([-way, 0.0], Signal::Polynomial(vec![0.0, 0.5]));
            let motion = both.run(&plane, State::moving([0.0; 2]), 7.0).unwrap();
            assert!((motion.starts()[0] - from).abs() < 1e-14);
            for t in [from + 0.1, 7.0] {
                let v = way * (t - from) * (0.5 + 0.25 * (t - from));
                assert!((motion.at(t).unwrap().v[0] - v).abs() < 1e-13, "{t}");
            }
        }
    }

    /// Each with the friction that brings closest to rest, and no more than there is.
    #[test]
    fn a_record_moves_it_as_short_steps_do() {
        let uneven = line([1.0, 0.0], 1.8, 2.3);
        for seed in 0..4 {
            let plane = noisy(0.0, 600, seed);
            let stepped = |parts: u32| {
                let h = 0.002 / f64::from(parts);
                let (mut v, mut x, mut heat) = (0.0, 0.0, 0.0);
                for k in 0..599 * parts {
                    let a = plane.coefficients((f64::from(k) + 0.5) * h)[0][0];
                    let free: f64 = v - h * a;
                    let friction = if free > 0.0 { 1.8 } else { 2.3 };
                    let next = free.signum() * (free.abs() - h * friction).max(0.0);
                    let step = 0.5 * h * (v + next);
                    (v, x, heat) = (next, x + step, heat + friction * step.abs());
                }
                [v, x, heat]
            };
            let [coarse, fine] = [stepped(40), stepped(80)];
            let motion = uneven
                .run(&plane, State::moving([0.0; 2]), 0.002 * 599.0)
                .unwrap();
            let State { v, x, .. } = motion.end();
            assert!(motion.stops().len() > 1);
            let heat = uneven.heat(motion.track().unwrap().total(), x).unwrap();
            for (i, found) in [v[0], x[0], heat].into_iter().enumerate() {
                let (step, off) = ((coarse[i] - fine[i]).abs(), (found - fine[i]).abs());
                assert!(off <= 2.0 * step + 1e-9, "{seed} {i}: {off:e} {step:e}");
            }
        }
    }

    #[test]
    fn with_equal_frictions_it_is_the_block_on_a_plane() {
        let sine = Signal::Sine {
            frequency: 1.0,
            phase: 0.3,
        };
        let plane = Plane::along([0.6, -0.8], sine.times(1.7));
        let rest = State::moving([0.0; 2]);
        let alone = line([-0.6, 0.8], 1.0, 1.0).run(&plane, rest, 40.0).unwrap();
        let other = run(&plane, 1.0, rest, 40.0).unwrap();
        assert_eq!(alone.phases().len(), other.phases().len());
        for (one, two) in alone.phases().iter().zip(other.phases()) {
            assert!((one.to - two.to).abs() < 1e-11 && one.kind == two.kind);
        }
        assert!((alone.end().x[0] - other.end().x[0]).abs() < 1e-11);
    }

    #[test]
    fn bad_input_is_named() {
        let plane = Plane::constant([0.0; 2]);
        let name = |line: Line, v| match line.run(&plane, State::moving(v), 1.0) {
            Err(MotionError::Argument { name, .. }) => name,
            other => panic!("{other:?}"),
        };
        let good = line([1.0, 1.0], 1.0, 2.0);
        assert_eq!(name(good, [1.0, 0.5]), "v across the line");
        assert_eq!(name(line([0.0; 2], 1.0, 2.0), [0.0; 2]), "length of along");
        assert_eq!(name(line([1.0; 2], 1.0, -2.0), [0.0; 2]), "friction");
        let loose = Friction {
            kinetic: 1.0,
            holding: 0.5,
        };
        assert_eq!(
            name(
                Line {
                    minus: loose,
                    ..good
                },
                [0.0; 2]
            ),
            "holding"
        );
        assert_eq!(
            name(
                Line {
                    frequency: f64::NAN,
                    ..good
                },
                [0.0; 2]
            ),
            "frequency"
        );
    }
}
