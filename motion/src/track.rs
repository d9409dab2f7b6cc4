//! How long the way of a motion is, and when it has become so long or led so far.
//!
//! Along a piece the speed is analytic in the piece's time, so a Gauss–Legendre rule is exact. Where what moves passes through
//! rest, as the centre of a ball may, the piece is parted: a rule that sees no point beyond the corner would take the speed for
//! negative there.

use super::error::{MotionError, check};
use crate::numerics::{
    NumericsError,
    events::{Way, roots},
    quadrature::integral_within,
    roots::falling_root,
    series::{arrival, change, value, value_slope},
};
use std::borrow::Cow;

fn squared(x: &[Cow<'_, [f64]>; 2], centre: [f64; 2]) -> Vec<f64> {
    let longest = x[0].len().max(x[1].len());
    let mut sum = vec![0.0; (2 * longest).max(1)];
    for (x, c) in x.iter().zip(centre) {
        for (i, a) in x.iter().enumerate() {
            for (k, b) in x.iter().enumerate() {
                let from = |k, x: f64| if k == 0 { x - c } else { x };
                sum[i + k] += from(i, *a) * from(k, *b);
            }
        }
    }
    sum
}

#[derive(Debug, Clone)]
pub(super) struct Part<'m> {
    from: f64,
    /// Its length in its own time.
    h: f64,
    /// The time as a series, where its own time is another.
    clock: Option<&'m [f64]>,
    v: [Cow<'m, [f64]>; 2],
    x: [Cow<'m, [f64]>; 2],
    corners: Vec<f64>,
    /// Where the change of the place is the way, without an integral.
    along: Option<usize>,
    /// The way up to it.
    before: f64,
}

impl<'m> Part<'m> {
    /// With t − `from` as its time, from the series of velocity and place.
    pub(super) fn timed(
        from: f64,
        h: f64,
        v: [impl Into<Cow<'m, [f64]>>; 2],
        x: [impl Into<Cow<'m, [f64]>>; 2],
    ) -> Self {
        Self {
            from,
            h,
            clock: None,
            v: v.map(Into::into),
            x: x.map(Into::into),
            corners: Vec::new(),
            along: None,
            before: 0.0,
        }
    }

    /// Of what never turns round within a piece.
    pub(super) fn one_way(mut self) -> Self {
        let still = |v: &[f64]| v.iter().all(|c| *c == 0.0);
        self.along = [1, 0].into_iter().find(|along| still(&self.v[1 - along]));
        self
    }

    /// Where it passes through rest, or close by.
    pub(super) fn cornered(mut self) -> Result<Self, NumericsError> {
        let square = squared(&self.v, [0.0; 2]);
        let slope = square.iter().enumerate().skip(1).map(|(k, c)| c * k as f64);
        let found = roots(&slope.collect::<Vec<_>>(), self.h)?;
        self.corners = found.into_iter().map(|root| root.at).collect();
        Ok(self)
    }

    /// By a time of its own, in which t is the series `clock`.
    pub(super) fn clocked(
        clock: &'m [f64],
        h: f64,
        v: [impl Into<Cow<'m, [f64]>>; 2],
        x: [impl Into<Cow<'m, [f64]>>; 2],
    ) -> Self {
        let from = clock.first().copied().unwrap_or_default();
        Self {
            clock: Some(clock),
            ..Self::timed(from, h, v, x)
        }
    }

    fn rate(&self, s: f64) -> f64 {
        let speed = libm::hypot(value(&self.v[0], &s), value(&self.v[1], &s));
        speed * self.clock.map_or(1.0, |clock| value_slope(clock, s).1)
    }

    /// The way up to the piece's own time `s`.
    fn way(&self, s: f64) -> Result<f64, NumericsError> {
        if let Some(along) = self.along {
            return Ok(change(&self.x[along], &s).abs());
        }
        let (mut sum, mut from) = (0.0, 0.0);
        for &to in self.corners.iter().filter(|c| **c < s).chain([&s]) {
            let size = self.rate(from) + self.rate(0.5 * (from + to)) + self.rate(to);
            // Far below what is promised; not zero, where nothing moves.
            let within = (1e-14 * size * (to - from)).max(f64::MIN_POSITIVE);
            sum += integral_within(|s| self.rate(s), from, to, within)?.value;
            from = to;
        }
        Ok(sum)
    }

    fn own(&self, t: f64) -> f64 {
        match self.clock {
            Some(clock) => arrival(clock, t - self.from, self.h),
            None => (t - self.from).min(self.h),
        }
    }

    fn time(&self, s: f64) -> f64 {
        self.from + self.clock.map_or(s, |clock| change(clock, &s))
    }
}

/// The way of a motion, relative to what it slides on, from the start on; right to 10⁻¹² of itself.
#[derive(Debug, Clone)]
pub struct Track<'m> {
    parts: Vec<Part<'m>>,
    times: [f64; 2],
    place: [f64; 2],
    total: f64,
}

impl<'m> Track<'m> {
    pub(super) fn new(
        times: [f64; 2],
        place: [f64; 2],
        parts: impl Iterator<Item = Result<Part<'m>, NumericsError>>,
    ) -> Result<Self, MotionError> {
        let mut total = 0.0;
        let mut all = Vec::new();
        for part in parts {
            let part = part?;
            let before = total;
            total += part.way(part.h)?;
            all.push(Part { before, ..part });
        }
        Ok(Self {
            parts: all,
            times,
            place,
            total,
        })
    }

    /// The length of all of it.
    pub fn total(&self) -> f64 {
        self.total
    }

    /// The length from the start to the time `t`.
    ///
    /// # Errors
    /// [`MotionError::Argument`] for a time before the start or after the end.
    pub fn at(&self, t: f64) -> Result<f64, MotionError> {
        let [start, end] = self.times;
        let range = "between the start and the end of the motion";
        check("t", t, t >= start && t <= end, range)?;
        let index = self.parts.partition_point(|piece| piece.from <= t);
        match index.checked_sub(1).and_then(|i| self.parts.get(i)) {
            Some(piece) => Ok(piece.before + piece.way(piece.own(t))?),
            None => Ok(0.0),
        }
    }

    /// The time at which the way has become so long; nothing if it does not. Close to a stop it is only as sharp as the way tells.
    ///
    /// # Errors
    /// [`MotionError::Argument`] for a negative length.
    pub fn when(&self, length: f64) -> Result<Option<f64>, MotionError> {
        check("length", length, length >= 0.0, "0 or positive")?;
        if length > self.total {
            return Ok(None);
        }
        let index = self.parts.partition_point(|p| p.before < length);
        let Some(piece) = index.checked_sub(1).and_then(|i| self.parts.get(i)) else {
            return Ok(Some(self.times[0]));
        };
        let rest = length - piece.before;
        let after = self.parts.get(index).map_or(self.total, |p| p.before);
        let guess = piece.h * rest / (after - piece.before);
        let s = falling_root(0.0, piece.h, guess, |s| {
            (rest - piece.way(s).unwrap_or(f64::NAN), -piece.rate(s))
        });
        piece.way(s)?;
        Ok(Some(piece.time(s).min(self.times[1])))
    }

    /// The first time at which its distance from a place exceeds `radius`: the start, if it does there; nothing if it does not.
    pub(crate) fn first_beyond(
        &self,
        centre: [f64; 2],
        radius: f64,
    ) -> Result<Option<f64>, MotionError> {
        for (name, c) in [
            ("x of the centre", centre[0]),
            ("y of the centre", centre[1]),
        ] {
            check(name, c, c.is_finite(), "finite")?;
        }
        let fit = radius >= 0.0 && radius.is_finite();
        check("radius", radius, fit, "0 or positive, finite")?;
        let [x, y] = [0, 1].map(|i| self.place[i] - centre[i]);
        if libm::hypot(x, y) > radius {
            return Ok(Some(self.times[0]));
        }
        for piece in &self.parts {
            let mut beyond = squared(&piece.x, centre);
            beyond[0] -= radius * radius;
            // Between two pieces it may go by rounding alone.
            let out = beyond.iter().find(|c| **c != 0.0);
            if out.is_some_and(|c| *c > 0.0) {
                return Ok(Some(piece.from));
            }
            let found = roots(&beyond, piece.h)?;
            if let Some(root) = found.iter().find(|root| root.way == Way::Rising) {
                return Ok(Some(piece.time(root.at).min(self.times[1])));
            }
        }
        Ok(None)
    }
}

#[cfg(test)]
mod tests {
    use crate::sphere::{Ball, Sphere};
    use crate::turntable::{Path, Table, inertial, rotating};
    use crate::{Friction, Plane, Signal, State, run};

    fn near(found: f64, expected: f64) {
        let off = (found - expected).abs();
        assert!(off <= 1e-12 * expected.abs(), "{found} {expected}");
    }

    fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
        a[0] * b[0] + a[1] * b[1]
    }

    /// Against a pull of 1 with μg = 1/2: 3t − 3t²/4 until it stops at 2, then (t − 2)²/4 back.
    #[test]
    fn there_and_back_by_hand() {
        let plane = Plane::constant([-1.0, 0.0]);
        let motion = run(&plane, 0.5, State::moving([-3.0, 0.0]), 6.0).unwrap();
        let track = motion.track().unwrap();
        for (t, way) in [(0.0, 0.0), (1.0, 2.25), (2.0, 3.0), (3.0, 3.25), (6.0, 7.0)] {
            assert!((track.at(t).unwrap() - way).abs() < 1e-13, "{t}");
        }
        let when = |way: f64| track.when(way).unwrap();
        near(when(1.0).unwrap(), (3.0 - 6.0_f64.sqrt()) / 1.5);
        near(when(5.0).unwrap(), 2.0 + 8.0_f64.sqrt());
        assert_eq!((when(0.0), when(7.1)), (Some(0.0), None));
        let beyond = |x: f64, radius: f64| track.first_beyond([x, 0.0], radius).unwrap();
        near(beyond(0.0, 2.0).unwrap(), (3.0 - 3.0_f64.sqrt()) / 1.5);
        // From 1 it is never farther than 4 on the way there, and on the way back not before the end.
        assert_eq!(beyond(1.0, 4.1), None);
        near(beyond(-4.0, 4.5).unwrap(), 2.0 + 14.0_f64.sqrt());
        assert_eq!((beyond(5.0, 4.9), beyond(0.0, 0.0)), (Some(0.0), Some(0.0)));
        assert!(track.when(-1.0).is_err() && track.when(f64::NAN).is_err());
        assert!(track.at(6.1).is_err() && track.first_beyond([0.0; 2], f64::NAN).is_err());
    }

    /// A load lets go at once, and has slid 1.81 m after √(2·1.81/(2.15 − 0.16 g)).
    #[test]
    fn a_lost_load() {
        let friction = Friction {
            kinetic: 0.16 * 9.8,
            holding: 0.18 * 9.8,
        };
        let plane = Plane::constant([0.0, 2.15]);
        let motion = run(&plane, friction, State::moving([0.0; 2]), 9.0).unwrap();
        let track = motion.track().unwrap();
        let time = libm::sqrt(3.62 / (2.15 - 0.16 * 9.8));
        near(track.when(1.81).unwrap().unwrap(), time);
        near(track.first_beyond([0.0; 2], 1.81).unwrap().unwrap(), time);
    }

    #[test]
    fn the_way_is_what_friction_took() {
        for k in 0..40 {
            let (s, c) = libm::sincos(0.4 * f64::from(k));
            let v = [1.0 + 0.05 * f64::from(k), 0.3 * s];
            for (size, until) in [(0.5, 9.0), (0.99, 3.0), (1.3, 9.0)] {
                let a = [size * c, size * s];
                let motion = run(&Plane::constant(a), 1.0, State::moving(v), until).unwrap();
                let end = motion.end();
                let taken = 0.5 * (dot(v, v) - dot(end.v, end.v)) - dot(a, end.x);
                let track = motion.track().unwrap();
                near(track.total(), taken);
                let half = track.when(0.5 * track.total()).unwrap().unwrap();
                near(track.at(half).unwrap(), 0.5 * track.total());
                let State { x, v: w, .. } = motion.at(half).unwrap();
                near(
                    0.5 * track.total(),
                    0.5 * (dot(v, v) - dot(w, w)) - dot(a, x),
                );
                let Some(out) = track.first_beyond([0.1, 0.0], 0.7).unwrap() else {
                    continue;
                };
                let from = |t: f64| {
                    let x = motion.at(t).unwrap().x;
                    libm::hypot(x[0] - 0.1, x[1])
                };
                near(from(out), 0.7);
                assert!((0..99).all(|i| from(0.01 * f64::from(i) * out) < 0.7));
            }
        }
    }

    /// It slides with the speed √(A² − (μg)²)/ω; one that sticks and slips goes as far as many short chords.
    #[test]
    fn on_a_plane_that_is_shaken() {
        let plane = Plane::rotating(Signal::constant(2.0), 1.5, 0.0);
        let speed = 3.0_f64.sqrt() / 1.5;
        // v turns with −A, and lags behind it by the angle whose cosine is μg/A.
        let (s, c) = libm::sincos(std::f64::consts::PI - (0.5_f64).acos());
        let motion = run(&plane, 1.0, State::moving([speed * c, speed * s]), 8.0).unwrap();
        near(motion.track().unwrap().at(5.0).unwrap(), 5.0 * speed);
        let noisy = crate::fitted::tests::noisy(0.0, 600, 3);
        let motion = run(&noisy, 1.96, State::moving([0.0; 2]), 1.19).unwrap();
        assert!(motion.stops().len() > 1);
        let chords = |n: u32| {
            let place = |k: u32| motion.at(1.19 * f64::from(k) / f64::from(n)).unwrap().x;
            let chord =
                |k| libm::hypot(place(k + 1)[0] - place(k)[0], place(k + 1)[1] - place(k)[1]);
            (0..n).map(chord).sum::<f64>()
        };
        let (coarse, fine) = (chords(20_000), chords(40_000));
        let off = (motion.track().unwrap().total() - fine).abs();
        assert!(off <= fine - coarse + 1e-13, "{off:e}");
    }

    /// ½v² + ½κR²ω² falls by μg for each unit that the lowest point slides.
    #[test]
    fn what_a_ball_loses_it_slides() {
        let sphere = Sphere {
            mu: 0.7,
            ..Sphere::with_kappa(0.4)
        };
        let start = Ball {
            t: 0.0,
            x: [0.0; 2],
            v: [1.0, 0.4],
            omega: [2.0, -3.0, 1.0],
        };
        let energy = |ball: &Ball, a: [f64; 2]| {
            let turning: f64 = ball.omega.iter().map(|o| o * o).sum();
            0.5 * (dot(ball.v, ball.v) + 0.4 * turning) + dot(a, ball.x)
        };
        for a in [[0.0, 0.0], [0.5, -0.2], [2.0, 3.0], [-3.0, 0.0]] {
            let motion = sphere.run(&Plane::constant(a), &start, 5.0).unwrap();
            let slipped = motion.slipped().unwrap();
            let lost = energy(&start, a) - energy(&motion.end(), a);
            near(0.7 * slipped.total(), lost);
            let t = slipped.when(0.3 * slipped.total()).unwrap().unwrap();
            near(0.7 * slipped.at(t).unwrap(), 0.3 * lost);
        }
        // Spun backwards it comes back: its centre stops after 1, with 1/2 done, and rolls from 22/7·… on.
        let back = Ball {
            v: [1.0, 0.0],
            omega: [0.0, -10.0, 0.0],
            ..start
        };
        let sphere = Sphere::with_kappa(0.4);
        let motion = sphere.run(&Plane::constant([0.0; 2]), &back, 5.0).unwrap();
        let track = motion.track().unwrap();
        // It rolls from 11/(7/2) on, with 1 − 22/7.
        let rolls = 22.0 / 7.0;
        for (t, way) in [
            (1.0, 0.5),
            (2.0, 1.0),
            (rolls, 0.5 + 0.5 * (rolls - 1.0) * (rolls - 1.0)),
            (
                5.0,
                0.5 + 0.5 * (rolls - 1.0) * (rolls - 1.0) + (rolls - 1.0) * (5.0 - rolls),
            ),
        ] {
            near(track.at(t).unwrap(), way);
            // Where it stands the time is as sharp as a square root.
            let off = (track.when(way).unwrap().unwrap() - t).abs();
            assert!(off < if t == 1.0 { 1e-7 } else { 1e-12 }, "{t}: {off:e}");
        }
        near(motion.slipped().unwrap().total(), 0.5 * 11.0 * rolls);
        near(
            track.first_beyond([0.5, 0.0], 1.0).unwrap().unwrap(),
            1.0 + 2.0_f64.sqrt(),
        );
    }

    /// ½(v² − Ω²r²) falls by μg for each unit of the way; without friction, from the axis, that is ∫ v√(1 + Ω²t²) dt.
    #[test]
    fn on_a_turntable() {
        let table = Table {
            omega: -1.3,
            mu: 0.4,
            g: 2.0,
            ..Table::default()
        };
        for (v, until) in [([0.5, 0.2], 4.0), ([1.0, -2.0], 6.0), ([0.0, 0.0], 3.0)] {
            let start = State {
                x: [0.6, 0.1],
                ..State::moving(v)
            };
            let turning = rotating::run(&table, &start, until).unwrap();
            let resting = inertial::run(&table, &table.to_laboratory(&start), until).unwrap();
            let lost = |path: &Path, t: f64| {
                table.energy(&start) - table.energy(&path.on_table(t).unwrap())
            };
            for path in [&turning, &resting] {
                let track = path.track().unwrap();
                for t in [0.3 * until, until] {
                    let off = 0.8 * track.at(t).unwrap() - lost(path, t);
                    assert!(
                        off.abs()
                            < 1e-12 * (1.0 + table.energy(&start).abs()) * (1.0 + track.total()),
                        "{off:e}"
                    );
                }
                if let Some(out) = track.first_beyond([0.0; 2], 0.9).unwrap() {
                    near(path.at(out).unwrap().radius(), 0.9);
                }
            }
        }
        let free = Table {
            mu: 0.0,
            omega: 1.0,
            ..table
        };
        let path = rotating::run(&free, &State::moving([0.5, 0.0]), 3.0).unwrap();
        let way = 0.25 * (3.0 * 10.0_f64.sqrt() + libm::asinh(3.0));
        near(path.track().unwrap().total(), way);
    }
}
