//! The launch of section 2.1's particle: constant acceleration, given by four numbers and checked.

use super::{
    acceleration::Plane,
    error::MotionError,
    error::check,
    particle::{run, run_to_stop},
    trajectory::{Motion, State},
};
use std::f64::consts::PI;

/// From the origin at t = 0 with speed v₀ and angle θ₀ from the x axis, on a plane that accelerates with −A x̂: the particle is
/// [pulled](super) along +x. One that moves as the plane gets faster has θ₀ = π.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Launch {
    lambda: f64,
    a: f64,
    v0: f64,
    theta0: f64,
}

/// Sizes whose products, too, are within what [`run`] takes.
const SIZES: std::ops::RangeInclusive<f64> = 1e-20..=1e20;

impl Launch {
    /// A launch with friction λ = μg/A (dimensionless), acceleration A (length/time²), initial speed v₀
    /// (length/time) and initial angle θ₀ (radians).
    ///
    /// # Errors
    /// [`MotionError::Argument`] names the first parameter that is not a number, infinite or out of range: λ is 0
    /// or between 10⁻²⁰ and 10²⁰, A and v₀ are between 10⁻²⁰ and 10²⁰, θ₀ is in (−π, π].
    pub fn new(lambda: f64, a: f64, v0: f64, theta0: f64) -> Result<Self, MotionError> {
        let fit = lambda == 0.0 || SIZES.contains(&lambda);
        check("λ", lambda, fit, "0 or between 1e-20 and 1e20")?;
        for (name, size) in [("A", a), ("v₀", v0)] {
            let range = "positive, between 1e-20 and 1e20";
            check(name, size, SIZES.contains(&size), range)?;
        }
        let fit = theta0 > -PI && theta0 <= PI;
        check("θ₀", theta0, fit, "in (−π, π]")?;
        Ok(Launch {
            lambda,
            a,
            v0,
            theta0,
        })
    }

    /// (v_x, v_y) at the launch. At θ₀ = π it is exactly along the axis, which the sine of the rounded π is not.
    pub fn velocity(&self) -> [f64; 2] {
        let sine = if self.theta0 == PI {
            0.0
        } else {
            libm::sin(self.theta0)
        };
        [self.v0 * libm::cos(self.theta0), self.v0 * sine]
    }

    /// The motion until the time `until`.
    ///
    /// # Errors
    /// As for [`run`].
    pub fn motion(&self, until: f64) -> Result<Motion, MotionError> {
        run(&self.plane(), self.friction(), self.start(), until)
    }

    /// For λ > 1, and at λ = 1 for θ₀ = π, straight against the inertial force.
    pub fn comes_to_rest(&self) -> bool {
        self.lambda > 1.0 || self.lambda == 1.0 && self.theta0 == PI
    }

    /// The motion until the particle stops; its cost is that of [`run_to_stop`].
    ///
    /// # Errors
    /// [`MotionError::Argument`] if it does not [come to rest](Self::comes_to_rest); else as for [`run_to_stop`].
    pub fn motion_to_rest(&self) -> Result<Motion, MotionError> {
        let range = "above 1, or 1 with θ₀ = π, for the particle to stop";
        check("λ", self.lambda, self.comes_to_rest(), range)?;
        let rate = self.friction() - self.a;
        let latest = if rate > 0.0 {
            2.0 * self.v0 / rate
        } else {
            self.v0 / self.a
        };
        run_to_stop(&self.plane(), self.friction(), self.start(), latest)
    }

    fn plane(&self) -> Plane {
        Plane::constant([-self.a, 0.0])
    }

    fn friction(&self) -> f64 {
        self.lambda * self.a
    }

    fn start(&self) -> State {
        State {
            t: 0.0,
            v: self.velocity(),
            x: [0.0; 2],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn a_bad_parameter_is_named_with_its_range() {
        let (good, infinite) = ([0.5, 1.0, 2.0, 1.0], f64::INFINITY);
        let bad: [(&str, &[f64]); 4] = [
            ("λ", &[-0.1, f64::NAN, infinite, 1e-21, 1e21]),
            ("A", &[0.0, -1.0, f64::NAN, infinite, 1e-21, 1e21]),
            ("v₀", &[0.0, -1.0, f64::NAN, infinite, 1e-21, 1e21]),
            ("θ₀", &[-PI, PI * (1.0 + 1e-15), 7.0, f64::NAN, -infinite]),
        ];
        for (i, (expected, values)) in bad.into_iter().enumerate() {
            for &wrong in values {
                let mut given = good;
                given[i] = wrong;
                let [lambda, a, v0, theta0] = given;
                match Launch::new(lambda, a, v0, theta0) {
                    Err(MotionError::Argument { name, range, .. }) => {
                        assert_eq!(name, expected, "{wrong}");
                        assert!(!range.is_empty());
                    }
                    other => panic!("{expected} = {wrong}: {other:?}"),
                }
            }
        }
    }

    #[test]
    fn the_message_is_a_sentence() {
        let error = Launch::new(-1.0, 1.0, 1.0, 0.0).unwrap_err();
        assert_eq!(
            error.to_string(),
            "λ = -1 must be 0 or between 1e-20 and 1e20"
        );
    }

    #[test]
    fn against_the_inertial_force_it_stops_by_both_forces_and_stays_on_the_line() {
        let motion = Launch::new(3.0, 2.0, 4.0, PI)
            .unwrap()
            .motion_to_rest()
            .unwrap();
        assert!((motion.end().t - 4.0 / (2.0 * (3.0 + 1.0))).abs() < 1e-14);
        assert_eq!(motion.end().x[1], 0.0);
    }

    #[test]
    fn friction_1_stops_a_launch_against_the_pull() {
        let launch = |theta0| Launch::new(1.0, 4.0, 3.0, theta0).unwrap();
        let motion = launch(PI).motion_to_rest().unwrap();
        assert_eq!((motion.end().t, motion.end().speed()), (3.0 / 8.0, 0.0));
        assert!(!launch(3.0).comes_to_rest());
    }

    #[test]
    fn a_particle_that_need_not_stop_is_not_followed_to_rest() {
        let error = Launch::new(1.0, 1.0, 1.0, 0.0).unwrap().motion_to_rest();
        assert!(matches!(
            error,
            Err(MotionError::Argument { name: "λ", .. })
        ));
    }

    proptest! {
        #[test]
        fn any_motion_to_rest_ends_at_rest(excess in -9.0..6.0, a in -3.0..3.0, v0 in -3.0..3.0, theta0 in -3.2..3.2) {
            let [excess, a, v0] = [excess, a, v0].map(|e: f64| libm::pow(10.0, e));
            let Ok(launch) = Launch::new(1.0 + excess, a, v0, theta0) else { return Ok(()); };
            let motion = launch.motion_to_rest();
            prop_assert!(motion.as_ref().is_ok_and(|m| m.end().speed() == 0.0 && m.first_stop() == Some(m.end().t)), "{launch:?}: {motion:?}");
        }
    }

    #[test]
    fn a_fast_particle_that_the_plane_carries_on_has_time_to_stop() {
        for k in 1..60 {
            let launch = Launch::new(1.0 + 0.037 * f64::from(k), 1.3, 1e18, 0.0).unwrap();
            let motion = launch.motion_to_rest().unwrap();
            assert_eq!(motion.first_stop(), Some(motion.end().t), "{launch:?}");
        }
    }
}
