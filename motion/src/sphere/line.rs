//! A sphere that moves along x on a plane whose friction depends on the way in which it slides (section 3.4).
//!
//! While its lowest point slides forwards, friction is −μ₊mg, backwards +μ₋mg; it rolls while the force that this takes lies
//! between.

use super::{
    super::acceleration::{Acceleration, check_time, most_steps},
    super::error::{MotionError, finite},
    Sphere, check,
};
use crate::numerics::{
    events::{Way, roots},
    series::value,
    taylor::{Coefficients, TERMS, reach},
};

/// `mu` serves forward sliding, another coefficient backward sliding.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Directed {
    /// The sphere and the plane; `mu` is μ₊.
    pub sphere: Sphere,
    /// μ₋ > 0, dimensionless.
    pub mu_minus: f64,
}

/// Motion along x.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LineState {
    /// Time.
    pub t: f64,
    /// Velocity of the centre, in length/time.
    pub v: f64,
    /// Angular velocity about y, in 1/time.
    pub omega: f64,
    /// Velocity of the lowest point, in length/time.
    pub slip: f64,
}

/// A stretch in which the lowest point moves one way.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stretch {
    /// 1 forwards, −1 backwards, 0 for rolling.
    pub way: i8,
    /// When it begins.
    pub from: f64,
    /// When it ends.
    pub to: f64,
}

/// A finished motion along x.
#[derive(Debug, Clone, PartialEq)]
pub struct LineMotion {
    /// Its stretches in order, without gaps.
    pub stretches: Vec<Stretch>,
    /// State at the end.
    pub end: LineState,
}

/// Forces this close count as equal, in units of their size.
const EQUAL: f64 = 1e-13;

impl Directed {
    /// The motion along x from the velocity `v` of the centre and the angular velocity `omega` about y at the time
    /// `from` until the time `until`; of the plane's acceleration A only the x component
    /// counts, and the sphere is [pulled](super::super) along −A_x.
    ///
    /// # Errors
    /// [`MotionError::Argument`] for a parameter out of range, [`MotionError::Outside`] for times at which the
    /// acceleration is not known, [`MotionError::Steps`] after 50,000 pieces (a hundred more for each of the acceleration's),
    /// [`MotionError::Numerics`] when the acceleration leaves the finite numbers.
    pub fn run(
        &self,
        plane: &dyn Acceleration,
        [v, omega]: [f64; 2],
        from: f64,
        until: f64,
    ) -> Result<LineMotion, MotionError> {
        self.sphere.check()?;
        let fit = (1e-50..=1e50).contains(&self.mu_minus);
        check(
            "mu_minus",
            self.mu_minus,
            fit,
            "positive, between 1e-50 and 1e50",
        )?;
        for (name, given) in [("v", v), ("omega", omega), ("from", from), ("until", until)] {
            let fit = given.abs() <= 1e50;
            check(name, given, fit, "finite, at most 1e50 in absolute value")?;
        }
        check("until", until, until >= from, "not before the start")?;
        check_time(plane, from).and(check_time(plane, until))?;
        let slip = v - self.sphere.radius * omega;
        let mut state = LineState {
            t: from,
            v,
            omega,
            slip,
        };
        let mut stretches: Vec<Stretch> = Vec::new();
        let mut released = None;
        let limit = most_steps(plane);
        for _ in 0..limit {
            if state.t >= until {
                return Ok(LineMotion {
                    stretches,
                    end: state,
                });
            }
            let begin = state.t;
            let (way, next) = self.piece(plane, &mut state, until, released)?;
            released = next;
            match stretches.last_mut() {
                Some(last) if last.way == way => last.to = state.t,
                _ => stretches.push(Stretch {
                    way,
                    from: begin,
                    to: state.t,
                }),
            }
        }
        Err(MotionError::Steps { limit, t: state.t })
    }

    fn piece(
        &self,
        plane: &dyn Acceleration,
        state: &mut LineState,
        until: f64,
        released: Option<i8>,
    ) -> Result<(i8, Option<i8>), MotionError> {
        let sphere = &self.sphere;
        let a = plane.coefficients(state.t)[0];
        for c in &a {
            check("a Taylor coefficient of A", *c, c.is_finite(), "finite")?;
        }
        let landing = plane.next_break(state.t).map_or(until, |b| b.min(until));
        let left = reach(&a).min(landing - state.t);
        let give = sphere.yielding(1.0);
        let weight = sphere.mass * sphere.g;
        let (forwards, backwards) = (-sphere.mu * weight, self.mu_minus * weight);
        // The force that keeps the lowest point at rest, and by how much it exceeds each limit.
        let holding = a.map(|a| a / give);
        let mut beyond = [holding.map(|f| -f), holding];
        beyond[0][0] += forwards;
        beyond[1][0] -= backwards;
        let mut way = match released {
            Some(way) => way,
            None if state.slip > 0.0 => 1,
            None if state.slip < 0.0 => -1,
            None => 0,
        };
        if way == 0 {
            for (excess, out) in beyond.iter_mut().zip([1, -1]) {
                if excess[0].abs() <= EQUAL * backwards.max(-forwards) {
                    excess[0] = 0.0;
                }
                if excess[0] > 0.0 {
                    way = out;
                }
            }
        }
        let force = match way {
            1 => constant(forwards),
            -1 => constant(backwards),
            _ => holding,
        };
        let mut slip: Coefficients = [0.0; TERMS];
        if way != 0 {
            slip = integral(state.slip, |k| give * force[k] - a[k]);
            // Where rolling ends because A(t) has grown, the force begins with what holds the lowest point.
            if released.is_some() {
                slip[1] = 0.0;
            }
        }
        let (h, next, stopped) = if way == 0 {
            let mut first: Option<(f64, i8)> = None;
            for (excess, out) in beyond.iter().zip([1, -1]) {
                let found = roots(excess, left)?;
                let at = found.iter().find(|root| root.way == Way::Rising);
                if let Some(root) = at
                    && first.is_none_or(|(t, _)| root.at < t)
                {
                    first = Some((root.at, out));
                }
            }
            first.map_or((left, None, false), |(h, out)| (h, Some(out), false))
        } else {
            let stop = roots(&slip, left)?.first().map(|root| root.at);
            stop.map_or((left, None, false), |h| (h, None, true))
        };
        let (by_force, spin): (Vec<f64>, Vec<f64>) = force
            .iter()
            .map(|f| sphere.response([*f, 0.0]))
            .map(|(pull, spin)| (pull[0], spin[1]))
            .unzip();
        let at = |series: Coefficients| value(&series, &h);
        let v = at(integral(state.v, |k| by_force[k] - a[k]));
        let omega = at(integral(state.omega, |k| spin[k]));
        let lands = h == left && landing - state.t <= left;
        *state = LineState {
            t: if lands { landing } else { state.t + h },
            v,
            omega,
            slip: if stopped || way == 0 { 0.0 } else { at(slip) },
        };
        finite(state.t, &[v, omega, state.slip])?;
        Ok((way, next))
    }
}

fn constant(force: f64) -> Coefficients {
    std::array::from_fn(|k| if k == 0 { force } else { 0.0 })
}

fn integral(start: f64, rate: impl Fn(usize) -> f64) -> Coefficients {
    std::array::from_fn(|k| {
        if k == 0 {
            start
        } else {
            rate(k - 1) / k as f64
        }
    })
}

#[cfg(test)]
mod tests {
    use super::super::Ball;
    use super::*;
    use crate::numerics::NumericsError;
    use crate::{Plane, Signal};

    fn swing(amplitude: f64) -> Plane {
        let sine = Signal::Sine {
            frequency: 1.3,
            phase: 0.4,
        };
        Plane::along([1.0, 0.0], sine.times(amplitude))
    }

    #[test]
    fn equal_frictions_are_the_sphere_in_three_dimensions() {
        let sphere = Sphere {
            mass: 1.7,
            radius: 0.6,
            inertia: 0.4 * 1.7 * 0.36,
            mu: 0.3,
            g: 9.0,
        };
        let directed = Directed {
            sphere,
            mu_minus: 0.3,
        };
        for amplitude in [4.0, 9.0, 14.0, 40.0] {
            let plane = swing(amplitude);
            let start = Ball {
                t: 0.0,
                x: [0.0; 2],
                v: [2.0, 0.0],
                omega: [0.0, -1.0, 0.5],
            };
            let space = sphere.run(&plane, &start, 40.0).unwrap().end();
            let line = directed.run(&plane, [2.0, -1.0], 0.0, 40.0).unwrap().end;
            assert!(
                (space.v[0] - line.v).abs() < 1e-11 * amplitude,
                "{amplitude}"
            );
            assert!(
                (space.omega[1] - line.omega).abs() < 1e-11 * amplitude,
                "{amplitude}"
            );
        }
    }

    /// Rolling takes A/(bμg) of friction, b = 7/2: the sphere slides where that is a part in 10¹¹ more than all.
    #[test]
    fn rolling_needs_no_more_than_friction_gives() {
        let directed = Directed {
            sphere: Sphere::with_kappa(0.4),
            mu_minus: 1.0,
        };
        let way = |beyond: f64| {
            let pulled = Plane::constant([-3.5 * (1.0 + beyond), 0.0]);
            directed
                .run(&pulled, [0.0, 0.0], 0.0, 1.0)
                .unwrap()
                .stretches[0]
                .way
        };
        assert_eq!([-1e-11, 0.0, 1e-14, 1e-11].map(way), [0, 0, 0, 1]);
    }

    #[test]
    fn each_way_has_its_own_friction() {
        let sphere = Sphere::with_kappa(0.4);
        let directed = Directed {
            sphere,
            mu_minus: 2.0,
        };
        let still = Plane::constant([0.0, 0.0]);
        let forwards = directed.run(&still, [1.0, 0.0], 0.0, 5.0).unwrap();
        let backwards = directed.run(&still, [-1.0, 0.0], 0.0, 5.0).unwrap();
        assert!(
            (forwards.stretches[0].to - 2.0 / 7.0).abs() < 1e-15,
            "{forwards:?}"
        );
        assert!(
            (backwards.stretches[0].to - 1.0 / 7.0).abs() < 1e-15,
            "{backwards:?}"
        );
        assert_eq!(
            backwards
                .stretches
                .iter()
                .map(|s| s.way)
                .collect::<Vec<_>>(),
            [-1, 0]
        );
        // Rolling holds up to bμ₊g and bμ₋g.
        for (a, way) in [(-3.4, 0), (-3.6, 1), (6.9, 0), (7.1, -1)] {
            let motion = directed
                .run(&Plane::constant([a, 0.0]), [0.0; 2], 0.0, 1.0)
                .unwrap();
            assert_eq!(motion.stretches.len(), 1);
            assert_eq!(motion.stretches[0].way, way, "A = {a}");
        }
    }

    #[test]
    fn bad_input_is_named() {
        let sphere = Sphere::with_kappa(0.4);
        let plane = swing(1.0);
        let run = |mu_minus, v, until| {
            let error = Directed { sphere, mu_minus }.run(&plane, [v, 0.0], 0.0, until);
            error.unwrap_err().to_string()
        };
        assert!(run(-1.0, 1.0, 1.0).contains("mu_minus"));
        assert!(run(1.0, f64::NAN, 1.0).contains('v'));
        assert!(run(1.0, 1.0, -1.0).contains("until"));
    }

    #[test]
    fn a_pull_that_falls_from_the_limit_is_rolled_on() {
        // |A| = 3.5 at once, which is what rolling can bear, and less from then on until −A is.
        let directed = Directed {
            sphere: Sphere::with_kappa(0.4),
            mu_minus: 1.0,
        };
        for amplitude in [3.5, -3.5] {
            let cosine = Signal::Sine {
                frequency: 1.0,
                phase: std::f64::consts::FRAC_PI_2,
            };
            let plane = Plane::along([1.0, 0.0], cosine.times(amplitude));
            let motion = directed.run(&plane, [0.0; 2], 0.0, 3.0).unwrap();
            let ways: Vec<_> = motion.stretches.iter().map(|s| s.way).collect();
            assert_eq!(ways, [0], "{motion:?}");
        }
    }

    #[test]
    fn it_ends_when_it_shall_before_the_time_zero_and_after_it() {
        let directed = Directed {
            sphere: Sphere::with_kappa(0.4),
            mu_minus: 2.0,
        };
        let motion = |shift: f64| {
            let sine = Signal::Sine {
                frequency: 1.3,
                phase: 0.4 - 1.3 * shift,
            };
            let plane = Plane::along([1.0, 0.0], sine.times(5.0));
            directed.run(&plane, [2.0, -1.0], shift, shift + 20.0)
        };
        let expected = motion(0.0).unwrap();
        assert!(expected.stretches.len() > 4, "{expected:?}");
        for shift in [-30.0, -7.0, 11.1] {
            let found = motion(shift).unwrap();
            assert_eq!(found.end.t, shift + 20.0);
            assert!((found.end.v - expected.end.v).abs() < 1e-11);
            assert!((found.end.omega - expected.end.omega).abs() < 1e-11);
            assert_eq!(found.stretches.len(), expected.stretches.len());
            for (a, b) in found.stretches.iter().zip(&expected.stretches) {
                assert_eq!(a.way, b.way);
                assert!((a.to - shift - b.to).abs() < 1e-11, "{a:?} {b:?}");
            }
        }
    }

    #[test]
    fn a_velocity_beyond_all_numbers_is_an_error() {
        let directed = Directed {
            sphere: Sphere {
                mass: 1e50,
                radius: 1e50,
                inertia: 1e-50,
                mu: 1e50,
                g: 1e50,
            },
            mu_minus: 1e50,
        };
        let plane = Plane::constant([1e299, 0.0]);
        let short = directed.run(&plane, [0.0; 2], 0.0, 1e8).unwrap();
        assert_eq!(short.stretches[0].way, 0);
        assert!((short.end.v / -1e307 - 1.0).abs() < 1e-14);
        let long = directed.run(&plane, [0.0; 2], 0.0, 1e10);
        assert!(matches!(
            long,
            Err(MotionError::Numerics(NumericsError::NotFinite { .. }))
        ));
    }
}
