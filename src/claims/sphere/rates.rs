//! Trials of (63) to (66), (73) to (75) and (77) to (79): along motions of the rigid sphere.

use super::spheres::{Run, length, mixed, sliding, times, weighed};
use crate::corrections::sphere as corrected;
use crate::evidence::{Evidence, Subject};
use crate::motion::State;
use crate::motion::sphere::Ball;
use crate::numerics::quadrature::integral_within;
use crate::paper::sphere as printed;
use trialbook::claims::attempt::{Attempt, trials};
use trialbook::claims::compare::{Compared, Failure, Pair, Trial};

/// What a printed rate, summed over time along sliding motions, has to be: the change of a quantity.
fn summed(
    compared: Compared,
    rate: impl Fn(&Run, &Ball, [f64; 3], f64) -> [f64; 3],
    quantity: impl Fn(&Run, &Ball) -> [f64; 3],
) -> Evidence {
    Trial::quadrature(Subject::Printed, compared).over(sliding(), |run| {
        let run = run?;
        let along = |t: f64| {
            let ball = run.motion.at(t);
            ball.map_or(f64::NAN, |ball| {
                weighed(rate(run, &ball, slip(run, &ball), t))
            })
        };
        let (start, end) = (run.case.start, run.motion.end());
        let (before, after) = (quantity(run, &start), quantity(run, &end));
        let scale = length(before) + length(after);
        Ok(Pair {
            at: run.at(run.until),
            // A rate that has no value somewhere has no sum.
            stated: integral_within(along, 0.0, run.until, 1e-13 * scale)
                .map_or(f64::NAN, |sum| sum.value),
            found: weighed(after) - weighed(before),
            scale,
        })
    })
}

fn flat([x, y]: [f64; 2]) -> [f64; 3] {
    [x, y, 0.0]
}

fn spin_share(run: &Run, ball: &Ball) -> [f64; 3] {
    // The lowest point's velocity about the centre, (−R ω_y, R ω_x).
    let radius = run.case.sphere.radius;
    [-radius * ball.omega[1], radius * ball.omega[0], 0.0]
}

fn slip(run: &Run, ball: &Ball) -> [f64; 3] {
    flat(run.case.sphere.contact(ball))
}

/// (63).
pub fn eq63() -> Evidence {
    let compared = Compared::one(
        "the integral of (63) over $t$",
        r"the change of $\mathrm d\bm r/\mathrm dt$ of the motion, each vector by the one number $x+2y+3z$",
    );
    let rate = |run: &Run, ball: &Ball, _, t| {
        let (_, mu, g) = run.case.parameters();
        let a = run.case.acceleration(t);
        printed::eq63_velocity_rate(a, mu, g, flat(ball.v), ball.omega, run.case.contact())
    };
    summed(compared, rate, |_, ball| flat(ball.v))
}

/// (64).
pub fn eq64() -> Evidence {
    let compared = Compared::one(
        "the integral of (64) over $t$",
        r"the change of $\kappa R^2\bm\omega$ of the motion, each vector by the one number $x+2y+3z$",
    );
    let rate = |run: &Run, ball: &Ball, _, _| {
        let (_, mu, g) = run.case.parameters();
        printed::eq64_spin_rate(mu, g, flat(ball.v), ball.omega, run.case.contact())
    };
    summed(compared, rate, |run, ball| {
        let per_mass = run.case.sphere.inertia / run.case.sphere.mass;
        ball.omega.map(|c| per_mass * c)
    })
}

/// (65).
pub fn eq65() -> Evidence {
    let compared = Compared::one(
        "the integral of (65) over $t$",
        r"the change of $(-R\omega_y,R\omega_x)$ of the motion, each vector by the one number $x+2y+3z$",
    );
    let rate = |run: &Run, ball: &Ball, _, _| {
        let (_, mu, g) = run.case.parameters();
        let (v, contact) = (flat(ball.v), run.case.contact());
        printed::eq65_spin_slip_rate(run.case.kappa(), mu, g, v, ball.omega, contact)
    };
    summed(compared, rate, spin_share)
}

/// (66).
pub fn eq66() -> Evidence {
    let compared = Compared::one(
        "the integral of (66) over $t$",
        "the change of the velocity of the sphere's lowest point, each vector by the one number $x+2y+3z$",
    );
    let rate = |run: &Run, _: &Ball, slip, t| {
        let (_, mu, g) = run.case.parameters();
        printed::eq66_slip_rate(run.case.acceleration(t), run.case.b(), mu, g, slip)
    };
    summed(compared, rate, slip)
}

/// γ and u by (71) and (72).
fn gamma_u(run: &Run, slip: [f64; 3], t: f64) -> ([f64; 3], [f64; 3]) {
    let (radius, mu, g) = run.case.parameters();
    (
        printed::eq72_acceleration(mu, g, run.case.acceleration(t)),
        printed::eq71_slip(radius, mu, g, slip),
    )
}

fn per_time(run: &Run, rate: [f64; 3]) -> [f64; 3] {
    rate.map(|c| c * run.tau_rate())
}

/// dρ/dτ of a state, in the sphere's own units.
fn rho_rate(run: &Run, ball: &Ball) -> [f64; 3] {
    flat(ball.v).map(|c| c / run.units().speed)
}

/// u, likewise.
fn u(run: &Run, ball: &Ball) -> [f64; 3] {
    slip(run, ball).map(|c| c / run.units().speed)
}

/// (73).
pub fn eq73() -> Evidence {
    let compared = Compared::one(
        r"the integral of (73) over $\tau$",
        r"the change of $\mathrm d\bm\rho/\mathrm d\tau$ of the motion, each vector by the one number $x+2y+3z$",
    );
    let rate = |run: &Run, _: &Ball, slip, t| {
        let (gamma, u) = gamma_u(run, slip, t);
        per_time(run, printed::eq73_velocity_rate(gamma, u))
    };
    summed(compared, rate, rho_rate)
}

/// (74).
pub fn eq74() -> Evidence {
    let compared = Compared::one(
        r"the integral of (74) over $\tau$",
        r"the change of $\bm u$ of the motion, each vector by the one number $x+2y+3z$",
    );
    let rate = |run: &Run, _: &Ball, slip, t| {
        let (gamma, u) = gamma_u(run, slip, t);
        per_time(run, printed::eq74_slip_rate(run.case.b(), gamma, u))
    };
    summed(compared, rate, u)
}

/// (77): its right-hand side less γ, the rate of ν, changes dρ/dτ.
pub fn eq77() -> Evidence {
    let compared = Compared::one(
        r"the integral of (77) less (76) over $\tau$",
        r"the change of $\mathrm d\bm\rho/\mathrm d\tau$ of the motion, each vector by the one number $x+2y+3z$",
    );
    let rate = |run: &Run, _: &Ball, slip, t| {
        let (gamma, u) = gamma_u(run, slip, t);
        let (both, nu) = (printed::eq77_rate(u), printed::eq76_nu_rate(gamma));
        per_time(run, [0, 1, 2].map(|i| both[i] - nu[i]))
    };
    summed(compared, rate, rho_rate)
}

/// (78), likewise.
pub fn eq78() -> Evidence {
    let compared = Compared::one(
        r"the integral of (78) less (76) over $\tau$",
        r"the change of $\bm u$ of the motion, each vector by the one number $x+2y+3z$",
    );
    let rate = |run: &Run, _: &Ball, slip, t| {
        let (gamma, u) = gamma_u(run, slip, t);
        let both = printed::eq78_rate(run.case.b(), u);
        let nu = printed::eq76_nu_rate(gamma);
        per_time(run, [0, 1, 2].map(|i| both[i] - nu[i]))
    };
    summed(compared, rate, u)
}

type Spin = fn(f64, [f64; 3], [f64; 3]) -> [f64; 3];

/// A formula for ζ, sliding and rolling.
fn spin(subject: Subject, compared: Compared, formula: Spin) -> Evidence {
    let states = mixed().flat_map(|run| match run {
        Ok(run) => times(run).map(|t| Ok((run, t))).to_vec(),
        Err(error) => vec![Err(error)],
    });
    Trial::motion(subject, compared).over(states, |state| {
        let (run, t) = state?;
        let (now, own) = (run.dimensionless(t)?, run.own(t)?);
        Ok(Pair {
            at: run.at(t),
            stated: weighed(formula(now.zeta[2], now.u, now.rho_rate)),
            found: weighed(own.zeta),
            scale: length(own.zeta) + length(own.rho_rate),
        })
    })
}

/// (75) as printed.
pub fn eq75() -> Evidence {
    let compared = Compared::one(
        "(75)",
        r"$\bm\zeta$ of the motion, sliding and rolling, each vector by the one number $x+2y+3z$",
    );
    spin(Subject::Printed, compared, printed::eq75_spin)
}

/// (75) with the other sign.
pub fn corrected75() -> Evidence {
    let compared = Compared::one(
        r"$\hat{\bm z}\zeta_3-\hat{\bm z}\times(\bm u-\mathrm d\bm\rho/\mathrm d\tau)$",
        r"$\bm\zeta$ of the motion, sliding and rolling, each vector by the one number $x+2y+3z$",
    );
    spin(Subject::Corrected, compared, corrected::spin)
}

/// ν at a time, zero at the start: what a body without friction loses to the plane, in units of √(μgR).
pub(super) fn nu(run: &Run, t: f64) -> Result<[f64; 3], Failure> {
    let rest = State {
        t: 0.0,
        v: [0.0; 2],
        x: [0.0; 2],
    };
    let [x, y] = crate::motion::run(&run.case.plane, 0.0, rest, t)?.end().v;
    let unit = run.units().speed;
    Ok([-x / unit, -y / unit, 0.0])
}

/// (79), with c from the start, through sliding and rolling.
pub fn eq79() -> Evidence {
    let compared = Compared::one(
        r"(79), with $\bm c$ from the start,",
        r"$\mathrm d\bm\rho/\mathrm d\tau$ of the motion, sliding and rolling, each vector by the one number $x+2y+3z$",
    );
    let states = mixed().flat_map(|run| match run {
        Ok(run) => times(run).map(|t| Ok((run, t))).to_vec(),
        Err(error) => vec![Err(error)],
    });
    Trial::motion(Subject::Printed, compared).over(states, |state| {
        let (run, t) = state?;
        let (start, now, b) = (run.dimensionless(0.0)?, run.dimensionless(t)?, run.case.b());
        let (own, own_start) = (run.own(t)?, run.own(0.0)?);
        let zero = [0.0; 3];
        let without = printed::eq79_velocity(b, zero, start.u, zero);
        let c = [0, 1, 2].map(|i| start.rho_rate[i] - without[i]);
        let nu = nu(run, t)?;
        Ok(Pair {
            at: run.at(t),
            stated: weighed(printed::eq79_velocity(b, nu, now.u, c)),
            found: weighed(own.rho_rate),
            scale: length(nu) + length(own.u) + length(own.rho_rate) + length(own_start.rho_rate),
        })
    })
}

pub(super) const TRIALS: &[Attempt] = trials![
    eq63,
    eq64,
    eq65,
    eq66,
    eq73,
    eq74,
    eq75,
    corrected75,
    eq77,
    eq78,
    eq79
];
