//! A sphere under constant acceleration: its slip and its spin, at an angle of the slip, at a time or when it rolls.
//!
#![doc = include_str!("axes/line.md")]

use super::{
    Answer, Curve, Field, Fields, LEAST_ANGLE, Quantity, RADIANS, ROUNDED, ROUNDING, SMALL, Said,
    SolveError, UNITS, UNSEEN_ANGLE, check,
    constant::{At, Formulas, check_moment},
    followed, size, steps,
};
use crate::corrections::sphere as corrected;
use crate::motion::{
    Plane,
    sphere::{Ball, BallMotion, Contact, Sphere},
};
use crate::numerics::{double::Double, number::Real, roots::root};
use crate::paper::sphere as printed;
use std::f64::consts::PI;

/// A sphere that starts without spin on a plane with the acceleration −γ x̂, everything in the paper's units.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SphereProblem<T = f64> {
    /// γ = A/(μg), from 10⁻¹⁵ to 10⁹.
    pub gamma: T,
    /// The initial slip u₀, in the paper's unit of velocity, from 10⁻²⁰ to 10²⁰.
    pub u0: T,
    /// The initial angle θ₀ of the slip with the x axis, radians in (−π, π].
    pub theta0: T,
    /// κ = I/(mR²), dimensionless, in [10⁻³, 1].
    pub kappa: T,
    /// The moment; a time is τ.
    pub at: At<T>,
}

/// Slip and spin at a moment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SphereState {
    /// The slip |𝐮|.
    pub u: f64,
    /// Its angle with the x axis, radians; while rolling, what it tended to.
    pub theta: f64,
    /// The time τ.
    pub tau: f64,
    /// Slip along x and along y.
    pub slip: [f64; 2],
    /// Spin ζ about x and about y.
    pub zeta: [f64; 2],
    /// When slipping ends and rolling begins, if it does.
    pub rolls_at: Option<f64>,
    u0: f64,
    /// As for [`ConstantState`](super::constant::ConstantState).
    turning: f64,
}

/// The units of slip, time and spin.
pub const SLIP: &str = "√(μgR)";
/// See [`SLIP`].
pub const TIME: &str = "√(R/(μg))";
/// See [`SLIP`].
pub const SPIN: &str = "√(μg/R)";

impl Fields for SphereState {
    fn fields(&self) -> Vec<Field> {
        let spin = libm::hypot(self.zeta[0], self.zeta[1]);
        vec![
            Field::within(self.turning, "u", self.u).of(SLIP),
            Field::within(LEAST_ANGLE, "theta", self.theta)
                .unseen_below(UNSEEN_ANGLE)
                .of(RADIANS),
            Field::new("tau", self.tau).of(TIME),
            Field::within(self.u.max(self.turning), "u_x", self.slip[0]).of(SLIP),
            Field::within(self.u.max(self.turning), "u_y", self.slip[1]).of(SLIP),
            Field::within(spin, "zeta_x", self.zeta[0])
                .out_of(self.u0)
                .of(SPIN),
            Field::within(spin, "zeta_y", self.zeta[1])
                .out_of(self.u0)
                .of(SPIN),
            Field::new("rolls_at", self.rolls_at).of(TIME),
        ]
    }
}

/// Later than this the motion is not followed.
const LATEST: f64 = 1e45;

impl<T: Quantity> SphereProblem<T> {
    /// Slip and spin at the moment asked for.
    ///
    /// # Errors
    /// [`SolveError::Parameter`] for a parameter out of range or an angle that the slip never has, [`SolveError::NoStop`]
    /// where rolling is asked for and never begins.
    pub fn solve(&self) -> Result<Answer<SphereState>, SolveError> {
        let near = self.near();
        near.check()?;
        let said = Said::by(|nudge| match nudge {
            None => self.by_formula(),
            Some(by) => {
                let gamma = by * near.gamma;
                SphereProblem { gamma, ..near }.by_formula()
            }
        })?;
        let motions = near
            .motions()
            .filter(|[motion, _]| !near.loses(&said.rounded, motion));
        let note = near.note(&said.given);
        Answer::by_either(said, motions, 0.0, note)
    }

    /// The path of the slip.
    ///
    /// # Errors
    /// As for [`solve`](Self::solve).
    pub fn curve(&self) -> Result<Curve, SolveError> {
        let (near, answer) = (self.near(), self.solve()?.best);
        let shown = answer.rolls_at.unwrap_or(3.0 * near.u0 / near.gamma);
        let end = shown.max(answer.tau);
        let motion = near.motion(end)?;
        let points: Result<Vec<_>, _> = steps(end, 400).map(|tau| motion.slip(tau)).collect();
        Ok(Curve {
            title: "The slip under constant acceleration",
            x: "u_x",
            y: "u_y",
            units: [SLIP; 2],
            equal: false,
            points: points?,
        })
    }

    fn near(&self) -> SphereProblem {
        SphereProblem {
            gamma: self.gamma.into(),
            u0: self.u0.into(),
            theta0: self.theta0.into(),
            kappa: self.kappa.into(),
            at: self.at.map(Into::into),
        }
    }

    fn by_formula(&self) -> Result<SphereState, SolveError> {
        let [gamma, u0, theta0, kappa] =
            [self.gamma, self.u0, self.theta0, self.kappa].map(Into::<Double>::into);
        let (one, zero) = (Double::from(1.0), Double::from(0.0));
        let b = printed::eq67_factor(kappa);
        let lambda = printed::eq80_lambda(b, one, one, gamma);
        // Friction and drive that are equal but for rounding are equal.
        let equal = f64::abs((lambda - one).to_f64()) <= ROUNDED;
        let formulas = Formulas {
            lambda: if equal { one } else { lambda },
            a: gamma,
            v0: u0,
            theta0,
        };
        let slip = formulas.at(self.at.map(Into::into))?;
        let start = formulas.at(At::Time(zero))?;
        let [x, y] = start.velocity;
        let [u_x, u_y] = slip.velocity;
        // Without spin the centre starts with the velocity of the contact: (79) at τ = 0 gives c.
        let c = [(one - one / b) * x, (one - one / b) * y, zero];
        let nu = [-(gamma * slip.t), zero, zero];
        let u = [u_x, u_y, zero];
        let [zeta_x, zeta_y, _] = corrected::spin(zero, u, printed::eq79_velocity(b, nu, u, c));
        let near = |pair: [Double; 2]| pair.map(Double::to_f64);
        // A spin that is no more than the rounding of what it is a difference of is none.
        let least = ROUNDED * u0.to_f64();
        let spin = near([zeta_x, zeta_y]).map(|x| if x.abs() <= least { 0.0 } else { x });
        Ok(SphereState {
            u: slip.v.to_f64(),
            theta: slip.theta.to_f64(),
            tau: slip.t.to_f64(),
            slip: near(slip.velocity),
            zeta: spin,
            rolls_at: slip.stop_time.map(Double::to_f64),
            u0: u0.to_f64(),
            turning: self.near().turning(),
        })
    }
}

impl SphereProblem {
    fn check(&self) -> Result<(), SolveError> {
        let fit = (1e-15..=1e9).contains(&self.gamma);
        check("gamma", self.gamma, fit, "between 1e-15 and 1e9")?;
        size("u0", self.u0)?;
        let fit = (1e-3..=1.0).contains(&self.kappa);
        check("kappa", self.kappa, fit, "between 1e-3 and 1")?;
        check_moment(self.theta0, self.at)
    }

    fn turning(&self) -> f64 {
        if self.theta0 == PI && self.gamma > self.b() {
            SMALL * self.u0
        } else {
            0.0
        }
    }

    fn b(&self) -> f64 {
        printed::eq67_factor(self.kappa)
    }

    /// λ by (80), in the paper's units.
    fn lambda(&self) -> f64 {
        printed::eq80_lambda(self.b(), 1.0, 1.0, self.gamma)
    }

    /// Whether the motion ends a slip that only becomes so small that its numbers lose it.
    fn loses(&self, formula: &SphereState, motion: &SphereState) -> bool {
        let (None, Some(tau)) = (formula.rolls_at, motion.rolls_at) else {
            return false;
        };
        let at = At::Time(tau);
        let there = SphereProblem { at, ..*self }.by_formula();
        there.is_ok_and(|there| there.u <= ROUNDING * self.u0)
    }

    fn start(&self) -> [f64; 2] {
        let sine = match self.theta0 {
            PI => 0.0,
            angle => libm::sin(angle),
        };
        [self.u0 * libm::cos(self.theta0), self.u0 * sine]
    }

    fn motion(&self, until: f64) -> Result<BallMotion, SolveError> {
        let start = Ball {
            t: 0.0,
            x: [0.0; 2],
            v: self.start(),
            omega: [0.0; 3],
        };
        let plane = Plane::constant([-self.gamma, 0.0]);
        Ok(Sphere::with_kappa(self.kappa).run(&plane, &start, until)?)
    }

    /// The motion, and the motion in other units: those of length and time as much larger as each other.
    fn motions(&self) -> Option<[SphereState; 2]> {
        let other = SphereProblem {
            u0: UNITS * self.u0,
            at: match self.at {
                At::Time(tau) => At::Time(UNITS * tau),
                at => at,
            },
            ..*self
        };
        let back = |state: SphereState| SphereState {
            u: state.u / UNITS,
            theta: state.theta,
            tau: state.tau / UNITS,
            slip: state.slip.map(|x| x / UNITS),
            zeta: state.zeta.map(|x| x / UNITS),
            rolls_at: state.rolls_at.map(|tau| tau / UNITS),
            u0: self.u0,
            turning: self.turning(),
        };
        let motion = followed(self.by_motion())?;
        Some([motion, followed(other.by_motion()).map_or(motion, back)])
    }

    /// Nothing where slipping ends, as far as the motion's numbers reach, before it has the angle.
    fn by_motion(&self) -> Result<Option<SphereState>, SolveError> {
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
            At::Stop => match rolls_at {
                Some(tau) => (tau, true),
                None => return Ok(None),
            },
            At::Theta(theta) => match self.reaches(theta, rolls_at)? {
                Some(moment) => moment,
                None => return Ok(None),
            },
        };
        let motion = self.motion(tau)?;
        let ball = motion.end();
        let slip = if turns { [0.0; 2] } else { motion.slip(tau)? };
        let u = libm::hypot(slip[0], slip[1]);
        Ok(Some(SphereState {
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
            u0: self.u0,
            turning: self.turning(),
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
                let tau = root(at, 0.0, last)?;
                // Where nothing is left of the component across, the angle is lost.
                let lost = motion.slip(tau)?[1] == 0.0;
                return Ok((!lost).then_some((tau, false)));
            }
            if rolls_at.is_some() {
                break;
            }
            until *= 4.0;
        }
        Ok(None)
    }

    fn note(&self, state: &SphereState) -> String {
        let printed = printed::eq82_time(self.lambda(), self.u0, self.theta0, state.theta);
        let slip = if (printed - state.tau).abs() <= 1e-9 * state.tau {
            "the slip by (81) and (82)"
        } else {
            "the slip by (81) in its regular form and by (82) with the factor 1/γ that it lacks"
        };
        format!("{slip}; the spin by (79) and by (75) with the other sign")
    }
}
