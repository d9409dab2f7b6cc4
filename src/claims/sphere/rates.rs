//! Trials of (63) to (66), (73) to (75) and (77) to (79): along motions of the rigid sphere.

use super::prelude::*;
use super::spheres::{SLIDING, length, moments};

/// Of a state of the sphere: its name and its value.
type Vector = (&'static str, fn(&Followed, &Ball) -> [f64; 3]);

const VELOCITY: Vector = (r"$\mathrm d\bm r/\mathrm dt$", |_, ball| flat(ball.v));
const SPIN: Vector = (r"$\kappa R^2\bm\omega$", |run, ball| {
    let per_mass = run.case.sphere.inertia / run.case.sphere.mass;
    ball.omega.map(|c| per_mass * c)
});
const SPIN_SHARE: Vector = (r"$(-R\omega_y,R\omega_x)$", spin_share);
const SLIP: Vector = ("the velocity of the sphere's lowest point", slip);
const RHO_RATE: Vector = (r"$\mathrm d\bm\rho/\mathrm d\tau$", rho_rate);
const U: Vector = (r"$\bm u$", u);

const BY_ONE_NUMBER: &str = " along the motion, each vector by the one number $x+2y+3z$";

/// What a printed rate, summed over time along sliding motions, has to be: the change of a quantity.
fn summed(
    law: &'static str,
    (name, quantity): Vector,
    rate: impl Fn(&Followed, &Ball, [f64; 3], f64) -> [f64; 3],
) -> Evidence {
    Trial::quadrature(
        Printed,
        Compared::composed(
            ["the integral of ", law, ""],
            ["the change of ", name, BY_ONE_NUMBER],
        ),
    )
    .each(SLIDING.each(), Followed::at_end, |run| {
        let along = |t: f64| {
            let ball = run.motion.at(t);
            ball.map_or(f64::NAN, |ball| {
                weighed(rate(run, &ball, slip(run, &ball), t))
            })
        };
        let (start, end) = (run.case.start, run.motion.end());
        let (before, after) = (quantity(run, &start), quantity(run, &end));
        let scale = length(before) + length(after);
        Ok([
            sum(along, 0.0, run.until, 1e-13 * scale),
            weighed(after) - weighed(before),
            scale,
        ])
    })
}

fn flat([x, y]: [f64; 2]) -> [f64; 3] {
    [x, y, 0.0]
}

fn spin_share(run: &Followed, ball: &Ball) -> [f64; 3] {
    // The lowest point's velocity about the centre, (−R ω_y, R ω_x).
    let radius = run.case.sphere.radius;
    [-radius * ball.omega[1], radius * ball.omega[0], 0.0]
}

fn slip(run: &Followed, ball: &Ball) -> [f64; 3] {
    flat(run.case.sphere.contact(ball))
}

/// γ and u by (71) and (72).
fn gamma_u(run: &Followed, slip: [f64; 3], t: f64) -> ([f64; 3], [f64; 3]) {
    let (radius, mu, g) = run.case.parameters();
    (
        printed::eq72_acceleration(mu, g, run.case.acceleration(t)),
        printed::eq71_slip(radius, mu, g, slip),
    )
}

fn per_time(run: &Followed, rate: [f64; 3]) -> [f64; 3] {
    rate.map(|c| c * run.tau_rate())
}

/// In the sphere's own units.
fn rho_rate(run: &Followed, ball: &Ball) -> [f64; 3] {
    flat(ball.v).map(|c| c / run.units().speed)
}

/// Likewise.
fn u(run: &Followed, ball: &Ball) -> [f64; 3] {
    slip(run, ball).map(|c| c / run.units().speed)
}

type Spin = fn(f64, [f64; 3], [f64; 3]) -> [f64; 3];

/// Sliding and rolling.
fn spin(subject: Subject, law: &'static str, formula: Spin) -> Evidence {
    const ZETA: &str =
        r"$\bm\zeta$ of the motion, sliding and rolling, each vector by the one number $x+2y+3z$";
    let compared = Compared::one(law, ZETA);
    Trial::motion(subject, compared).over(moments(), |state| {
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

/// ν at a time, zero at the start: what a body without friction loses to the plane, in units of √(μgR).
pub(super) fn nu(run: &Followed, t: f64) -> Result<[f64; 3], Failure> {
    let rest = State::moving([0.0; 2]);
    let [x, y] = crate::motion::run(&run.case.plane, 0.0, rest, t)?.end().v;
    let unit = run.units().speed;
    Ok([-x / unit, -y / unit, 0.0])
}

/// A rate by (77) or (78) less γ, the rate of ν.
fn less_nu(run: &Followed, gamma: [f64; 3], both: [f64; 3]) -> [f64; 3] {
    let nu = printed::eq76_nu_rate(gamma);
    per_time(run, [0, 1, 2].map(|i| both[i] - nu[i]))
}

attempts![
    eq63 = summed("(63) over $t$", VELOCITY, |run, ball, _, t| {
        let (_, mu, g) = run.case.parameters();
        let a = run.case.acceleration(t);
        printed::eq63_velocity_rate(a, mu, g, flat(ball.v), ball.omega, run.case.contact())
    }),
    eq64 = summed("(64) over $t$", SPIN, |run, ball, _, _| {
        let (_, mu, g) = run.case.parameters();
        printed::eq64_spin_rate(mu, g, flat(ball.v), ball.omega, run.case.contact())
    }),
    eq65 = summed("(65) over $t$", SPIN_SHARE, |run, ball, _, _| {
        let (_, mu, g) = run.case.parameters();
        let (v, contact) = (flat(ball.v), run.case.contact());
        printed::eq65_spin_slip_rate(run.case.kappa(), mu, g, v, ball.omega, contact)
    }),
    eq66 = summed("(66) over $t$", SLIP, |run, _, slip, t| {
        let (_, mu, g) = run.case.parameters();
        printed::eq66_slip_rate(run.case.acceleration(t), run.case.b(), mu, g, slip)
    }),
    eq73 = summed(r"(73) over $\tau$", RHO_RATE, |run, _, slip, t| {
        let (gamma, u) = gamma_u(run, slip, t);
        per_time(run, printed::eq73_velocity_rate(gamma, u))
    }),
    eq74 = summed(r"(74) over $\tau$", U, |run, _, slip, t| {
        let (gamma, u) = gamma_u(run, slip, t);
        per_time(run, printed::eq74_slip_rate(run.case.b(), gamma, u))
    }),
    eq75 | corrected75 = spin(
        ("(75)", printed::eq75_spin)
            | (
                r"$\hat{\bm z}\zeta_3-\hat{\bm z}\times(\bm u-\mathrm d\bm\rho/\mathrm d\tau)$",
                corrected::spin
            )
    ),
    eq77 = summed(
        r"(77) less (76) over $\tau$",
        RHO_RATE,
        |run, _, slip, t| {
            let (gamma, u) = gamma_u(run, slip, t);
            less_nu(run, gamma, printed::eq77_rate(u))
        }
    ),
    eq78 = summed(r"(78) less (76) over $\tau$", U, |run, _, slip, t| {
        let (gamma, u) = gamma_u(run, slip, t);
        less_nu(run, gamma, printed::eq78_rate(run.case.b(), u))
    }),
    eq79 = {
        let compared = Compared::one(
            r"(79), with $\bm c$ from the start,",
            r"$\mathrm d\bm\rho/\mathrm d\tau$ of the motion, sliding and rolling, each vector by the one number $x+2y+3z$",
        );
        Trial::motion(Printed, compared).over(moments(), |state| {
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
                scale: length(nu)
                    + length(own.u)
                    + length(own.rho_rate)
                    + length(own_start.rho_rate),
            })
        })
    }
];
