//! A sphere under constant acceleration: its slip and its spin, at an angle of the slip or at a time.

use super::constant::{At, Formulas, check_moment};
use super::{Answer, Curve, Field, Fields, SolveError, check, size, steps};
use crate::corrections::sphere as corrected;
use crate::motion::Plane;
use crate::motion::sphere::{Ball, Contact, Motion, Sphere};
use crate::numerics::roots::root;
use crate::paper::sphere as printed;
use std::f64::consts::PI;

/// A sphere that starts without spin on a plane with the acceleration −γ x̂, everything in the paper's units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Problem {
    /// γ = A/(μg), from 10⁻¹⁵ to 10⁹.
    pub gamma: f64,
    /// The initial slip u₀, from 10⁻²⁰ to 10²⁰.
    pub u0: f64,
    /// The initial angle θ₀ of the slip with the x axis, in (−π, π].
    pub theta0: f64,
    /// κ = I/(mR²), in [10⁻³, 1].
    pub kappa: f64,
    /// The moment; a time is τ.
    pub at: At,
}

/// Slip and spin at a moment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct State {
    /// The slip |𝐮|.
    pub u: f64,
    /// Its angle with the x axis; while rolling, what it tended to.
    pub theta: f64,
    /// The time τ.
    pub tau: f64,
    /// Slip along x and along y.
    pub slip: [f64; 2],
    /// Spin ζ about x and about y.
    pub zeta: [f64; 2],
    /// When slipping ends and rolling begins, if it does.
    pub rolls_at: Option<f64>,
}

impl Fields for State {
    fn fields(&self) -> Vec<Field> {
        let spin = libm::hypot(self.zeta[0], self.zeta[1]);
        vec![
            Field::new("u", self.u),
            Field::within(1e-60, "theta", self.theta),
            Field::new("tau", self.tau),
            Field::within(self.u, "u_x", self.slip[0]),
            Field::within(self.u, "u_y", self.slip[1]),
            Field::within(spin, "zeta_x", self.zeta[0]),
            Field::within(spin, "zeta_y", self.zeta[1]),
            Field::new("rolls_at", self.rolls_at),
        ]
    }
}

/// Later than this the motion is not followed.
const LATEST: f64 = 1e45;

impl Problem {
    /// Slip and spin at the moment asked for.
    ///
    /// # Errors
    /// [`SolveError::Parameter`] for a parameter out of range or an angle that the slip never has.
    pub fn solve(&self) -> Result<Answer<State>, SolveError> {
        let fit = (1e-15..=1e9).contains(&self.gamma);
        check("gamma", self.gamma, fit, "between 1e-15 and 1e9")?;
        size("u0", self.u0)?;
        let fit = (1e-3..=1.0).contains(&self.kappa);
        check("kappa", self.kappa, fit, "between 1e-3 and 1")?;
        check_moment(self.theta0, self.at)?;
        let formula = self.by_formula()?;
        Answer::by_either(formula, self.by_motion()?, self.note(&formula))
    }

    /// The path of the slip.
    ///
    /// # Errors
    /// As for [`solve`](Self::solve).
    pub fn curve(&self) -> Result<Curve, SolveError> {
        let answer = self.solve()?.best;
        let shown = answer.rolls_at.unwrap_or(3.0 * self.u0 / self.gamma);
        let end = shown.max(answer.tau);
        let motion = self.motion(end)?;
        let points: Result<Vec<_>, _> = steps(end, 400).map(|tau| motion.slip(tau)).collect();
        Ok(Curve {
            title: "The slip under constant acceleration",
            x: "u_x",
            y: "u_y",
            equal: false,
            points: points?,
        })
    }

    fn b(&self) -> f64 {
        printed::eq67_factor(self.kappa)
    }

    /// λ by (80), in the paper's units.
    fn lambda(&self) -> f64 {
        printed::eq80_lambda(self.b(), 1.0, 1.0, self.gamma)
    }

    /// The slip at the start.
    fn start(&self) -> [f64; 2] {
        let sine = match self.theta0 {
            PI => 0.0,
            angle => libm::sin(angle),
        };
        [self.u0 * libm::cos(self.theta0), self.u0 * sine]
    }

    fn by_formula(&self) -> Result<State, SolveError> {
        let formulas = Formulas {
            lambda: self.lambda(),
            a: self.gamma,
            v0: self.u0,
            theta0: self.theta0,
        };
        let slip = match self.at {
            At::Theta(theta) => formulas.at_theta(theta)?,
            At::Time(tau) => formulas.at_time(tau)?,
        };
        let (b, [x, y]) = (self.b(), self.start());
        let u = [slip.vx, slip.vy, 0.0];
        // Without spin the centre starts with the velocity of the contact: (79) at τ = 0 gives c.
        let c = [(1.0 - 1.0 / b) * x, (1.0 - 1.0 / b) * y, 0.0];
        let nu = [-self.gamma * slip.t, 0.0, 0.0];
        let [zeta_x, zeta_y, _] = corrected::spin(0.0, u, printed::eq79_velocity(b, nu, u, c));
        Ok(State {
            u: slip.v,
            theta: slip.theta,
            tau: slip.t,
            slip: [slip.vx, slip.vy],
            zeta: [zeta_x, zeta_y],
            rolls_at: slip.stop_time,
        })
    }

    fn motion(&self, until: f64) -> Result<Motion, SolveError> {
        let start = Ball {
            t: 0.0,
            x: [0.0; 2],
            v: self.start(),
            omega: [0.0; 3],
        };
        let plane = Plane::constant([-self.gamma, 0.0]);
        Ok(Sphere::with_kappa(self.kappa).run(&plane, &start, until)?)
    }

    /// Nothing where slipping ends, as far as the motion's numbers reach, before it has the angle.
    fn by_motion(&self) -> Result<Option<State>, SolveError> {
        // Slip falls at least at the rate b − γ where that is positive; where it is 0, it stops soon or never.
        let spare = self.b() - self.gamma;
        let long = if spare > 0.0 {
            1.001 * self.u0 / spare
        } else {
            self.u0 / self.gamma
        };
        let motion = self.motion(long)?;
        let rolling = motion.transitions().last();
        let rolls_at = rolling.filter(|t| t.to == Contact::Rolling).map(|t| t.t);
        let (tau, turns) = match self.at {
            At::Time(tau) => (tau, false),
            At::Theta(theta) => match self.reaches(theta, rolls_at)? {
                Some(moment) => moment,
                None => return Ok(None),
            },
        };
        let motion = self.motion(tau)?;
        let ball = motion.end();
        let slip = if turns { [0.0; 2] } else { motion.slip(tau)? };
        let u = libm::hypot(slip[0], slip[1]);
        Ok(Some(State {
            u,
            theta: match u {
                0.0 if self.theta0 == PI && rolls_at.is_some() => PI,
                0.0 => 0.0,
                _ => libm::atan2(slip[1], slip[0]),
            },
            tau,
            slip,
            zeta: [ball.omega[0], ball.omega[1]],
            rolls_at,
        }))
    }

    /// When the slip of the motion has this angle, and whether it is zero there and turns round.
    fn reaches(
        &self,
        theta: f64,
        rolls_at: Option<f64>,
    ) -> Result<Option<(f64, bool)>, SolveError> {
        if theta == self.theta0 {
            return Ok(Some((0.0, false)));
        }
        let across = |slip: [f64; 2]| slip[0] * libm::sin(theta) - slip[1] * libm::cos(theta);
        let first = across(self.start());
        let mut until = rolls_at.unwrap_or(self.u0 / self.gamma);
        while until < LATEST {
            let motion = self.motion(until)?;
            if self.theta0 == PI
                && let Some(turn) = motion.transitions().first()
            {
                return Ok(Some((turn.t, true)));
            }
            // Where slipping ends the slip is zero: look just before.
            let last = if rolls_at.is_some() {
                until.next_down()
            } else {
                until
            };
            if across(motion.slip(last)?) * first < 0.0 {
                let at = |t: f64| motion.slip(t).map_or(f64::NAN, across);
                return Ok(Some((root(at, 0.0, last)?, false)));
            }
            if rolls_at.is_some() {
                break;
            }
            until *= 4.0;
        }
        Ok(None)
    }

    fn note(&self, state: &State) -> String {
        let printed = printed::eq82_time(self.lambda(), self.u0, self.theta0, state.theta);
        let slip = if (printed - state.tau).abs() <= 1e-9 * state.tau {
            "the slip by (81) and (82)"
        } else {
            "the slip by (81) in its regular form and by (82) with the factor 1/γ that it lacks"
        };
        format!("{slip}; the spin by (79) and by (75) with the other sign")
    }
}
