//! A sphere that rolls on a plane that turns about a vertical axis: the point of contact moves as the plane under it,
//! c = Ω ẑ×r, seen from the laboratory.
//!
//! ```text
//! m dv/dt = m P + F,    I dω/dt = R×F,    F so that dc/dt = Ω ẑ×v
//! ```
//!
//! P is a pull on a unit of mass, of a tilt for example.

use super::{Sphere, check};
use crate::error::MotionError;
use crate::numerics::taylor::{Control, Path, System, TERMS, integrate};

const STEPS: usize = 50_000;

/// The plane, and the pull.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Turning {
    /// Angular velocity Ω, in 1/time.
    pub omega: f64,
    /// P, in length/time².
    pub pull: [f64; 2],
}

struct Rolls<'s> {
    turning: Turning,
    sphere: &'s Sphere,
}

impl Turning {
    /// A sphere that starts at `x` with the velocity `v`, rolling, until it has done so for the time `lasts`: x, y, v_x and v_y.
    ///
    /// # Errors
    /// [`MotionError::Argument`] for a parameter out of range, or a friction that is too small for it to roll in the
    /// first moment of a step; [`MotionError::Numerics`] after 50,000 steps, or when the motion leaves the finite numbers.
    pub fn roll(
        &self,
        sphere: &Sphere,
        [x, v]: [[f64; 2]; 2],
        lasts: f64,
    ) -> Result<Path<4, TERMS>, MotionError> {
        sphere.check()?;
        let law = Rolls {
            turning: *self,
            sphere,
        };
        let start = [x[0], x[1], v[0], v[1]];
        let path = integrate(&law, 0.0, start, lasts, Control::Largest, STEPS)?;
        for step in &path.steps {
            let [_, _, x, y] = step.at(&0.0);
            let force = law.force([x, y], self.pull);
            let held = libm::hypot(force[0], force[1]) <= sphere.friction();
            check("mu", sphere.mu, held, "large enough for the sphere to roll")?;
        }
        Ok(path)
    }
}

impl Rolls<'_> {
    /// F, by which the contact keeps up with the plane.
    fn force(&self, v: [f64; 2], pull: [f64; 2]) -> [f64; 2] {
        let yielding = self.sphere.yielding(1.0);
        [
            (-self.turning.omega * v[1] - pull[0]) / yielding,
            (self.turning.omega * v[0] - pull[1]) / yielding,
        ]
    }
}

impl System<f64, 4, TERMS> for Rolls<'_> {
    type Work = ();

    fn begin(&self, _: &f64, _: &[f64; 4], (): &mut ()) {}

    fn derivative(&self, k: usize, state: &[[f64; TERMS]; 4], (): &mut ()) -> [f64; 4] {
        let [_, _, x, y] = state;
        let pull = if k == 0 { self.turning.pull } else { [0.0; 2] };
        let ([a, b], _) = self.sphere.response(self.force([x[k], y[k]], pull));
        [x[k], y[k], pull[0] + a, pull[1] + b]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// ω is from R×F/I, by a sum over many short pieces.
    #[test]
    fn the_contact_keeps_up_with_the_plane() {
        let sphere = Sphere {
            mass: 2.0,
            radius: 0.3,
            inertia: 0.05,
            mu: 5.0,
            g: 9.8,
        };
        let turning = Turning {
            omega: 1.7,
            pull: [0.4, -0.2],
        };
        let (x, v) = ([0.5, -0.1], [0.2, 0.3]);
        let path = turning.roll(&sphere, [x, v], 2.0).unwrap();
        let law = Rolls {
            turning,
            sphere: &sphere,
        };
        let contact = |[x, y, _, _]: [f64; 4]| [-turning.omega * y, turning.omega * x];
        let slip = |[x, y]: [f64; 2], v: [f64; 2]| [x - v[0], y - v[1]];
        let [ox, oy] = slip(contact([x[0], x[1], v[0], v[1]]), v);
        // c − v = ω×R = R(−ω_y, ω_x).
        let mut omega = sphere.rolling([-ox, -oy], 0.0);
        let pieces = 20_000;
        for n in 0..pieces {
            let at = path
                .at(2.0 * (f64::from(n) + 0.5) / f64::from(pieces))
                .unwrap();
            let (_, turned) = sphere.response(law.force([at[2], at[3]], turning.pull));
            for (total, rate) in omega.iter_mut().zip(turned) {
                *total += rate * 2.0 / f64::from(pieces);
            }
        }
        let [ox, oy] = slip(contact(path.end), [path.end[2], path.end[3]]);
        let expected = sphere.rolling([-ox, -oy], 0.0);
        for (is, should) in omega.iter().zip(expected) {
            assert!((is - should).abs() < 1e-7, "{omega:?} {expected:?}");
        }
    }

    #[test]
    fn a_smooth_plane_turns_nothing() {
        let sphere = Sphere {
            mu: 1e-3,
            ..Sphere::with_kappa(0.4)
        };
        let turning = Turning {
            omega: 1.0,
            pull: [0.0; 2],
        };
        let slips = turning.roll(&sphere, [[1.0, 0.0], [0.5, 0.0]], 1.0);
        assert!(matches!(
            slips,
            Err(MotionError::Argument { name: "mu", .. })
        ));
    }

    /// F = mP/2 on a slope, F = mΩv/2 on a turning plane: μ = 1/4 does where g = 1.
    #[test]
    fn it_rolls_where_friction_just_suffices() {
        for (omega, v, pull) in [
            (0.0, [0.0; 2], [0.5, 0.0]),
            (0.0, [0.0; 2], [0.0, -0.5]),
            (1.0, [0.5, 0.0], [0.0; 2]),
            (-1.0, [0.0, 0.5], [0.0; 2]),
            (1.0, [0.25, 0.0], [0.0, -0.25]),
        ] {
            let turning = Turning { omega, pull };
            let rolls = |mu: f64| {
                let sphere = Sphere {
                    mu,
                    ..Sphere::with_kappa(1.0)
                };
                turning.roll(&sphere, [[0.0; 2], v], 1e-3)
            };
            assert!(rolls(0.25).is_ok(), "{turning:?}");
            assert!(
                matches!(
                    rolls(0.25_f64.next_down()),
                    Err(MotionError::Argument { name: "mu", .. })
                ),
                "{turning:?}"
            );
        }
    }

    /// A hoop goes around with the velocity of its drift, P/Ω: F is P/2 at first, and 3P/2 half a turn later, after 2π/Ω.
    #[test]
    fn friction_has_to_suffice_all_the_way() {
        let turning = Turning {
            omega: 1.0,
            pull: [0.3, -0.4],
        };
        let rolls = |mu: f64, lasts: f64| {
            let sphere = Sphere {
                mu,
                ..Sphere::with_kappa(1.0)
            };
            turning.roll(&sphere, [[0.0; 2]; 2], lasts)
        };
        assert!(rolls(0.26, 1e-3).is_ok());
        assert!(rolls(0.751, 50.0).is_ok());
        assert!(matches!(
            rolls(0.26, 50.0),
            Err(MotionError::Argument { name: "mu", .. })
        ));
    }
}
