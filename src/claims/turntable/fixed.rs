//! Trials of the quasi-fixed points (124) and (125): where ψ stands still, and what deviations do. And how well ψ follows
//! ψ₁ when α moves, for a figure.

use super::prelude::*;
use super::singular_starts::rate_at_start;
use crate::numerics::{NumericsError, dop853, roots};

/// At the beginning of a motion.
fn psi_rate(a: f64, alpha: f64, psi: f64) -> Result<f64, Failure> {
    let h = 1e-3 * alpha.min(1.0);
    let run = Run::new(&Start::hyperbolic(a, alpha, psi)?, 5.0 * h)?;
    Ok(rate_at_start(h, |t| {
        // ψ is compared with its first value, so that its turns do not matter.
        let change = run.at(t)?.psi() - psi;
        Ok(change - TAU * libm::round(change / TAU))
    })?)
}

fn state(points: &mut Points) -> (f64, f64) {
    (points.log_uniform(0.3, 3.0), points.log_uniform(0.1, 1.0))
}

/// Large and small α, for which ψ stands still as well.
fn far_states(points: &mut Points) -> Vec<(f64, f64)> {
    let [large, small] = [[3.0, 8.0], [1e-3, 1e-2]];
    let of = |[low, high]: [f64; 2]| {
        let mut one = || (points.log_uniform(0.3, 3.0), points.log_uniform(low, high));
        [one(), one(), one(), one(), one()]
    };
    [large, small].map(of).concat()
}

fn at(a: f64, alpha: f64) -> String {
    format!("A = {a:.6}, α = {alpha:.6}")
}

fn stands_still(
    [law, side]: [&'static str; 2],
    range: [f64; 2],
    formula: fn(f64) -> f64,
) -> Evidence {
    let angle = [
        "the angle ",
        side,
        r" $\pi/2$ at which $\psi$ of the motion stands still for a moment",
    ];
    let compared = Compared::composed([law, "", ""], angle);
    let trial = Trial::by(Root, Printed, compared, STANDS_STILL);
    let mut points = Points::here();
    let mut states: Vec<_> = (0..30).map(|_| state(&mut points)).collect();
    states.extend(far_states(&mut points));
    trial.over(states, |(a, alpha)| {
        Ok(Pair {
            at: at(a, alpha),
            stated: formula(alpha),
            found: standstill(a, alpha, range)?,
            // At large α the angle hardly turns near where it stands still.
            scale: (0.5 * libm::cosh(2.0 * alpha)).max(1.0),
        })
    })
}

/// The angle in a range at which ψ of the motion stands still for a moment.
fn standstill(a: f64, alpha: f64, [low, high]: [f64; 2]) -> Result<f64, Failure> {
    let rate = |psi: f64| psi_rate(a, alpha, psi).unwrap_or(f64::NAN);
    match roots::root(rate, low, high) {
        // At large α it is so near π/2 that rounding may hide the sign there.
        Err(NumericsError::NoSignChange {
            at_low, at_high, ..
        }) if at_low.abs().min(at_high.abs()) < HIDDEN => Ok(if at_low.abs() < at_high.abs() {
            low
        } else {
            high
        }),
        found => Ok(found?),
    }
}

/// A rate of ψ that rounding may make of none, beside rates of 2.
const HIDDEN: f64 = 1e-12;

/// Where ψ₁ is looked for, and where ψ₂.
const BELOW_AND_ABOVE: [[f64; 2]; 2] = [[0.0, FRAC_PI_2], [FRAC_PI_2, PI]];

/// How much faster the position turns than the velocity, with p = sinh α, ρ = cosh α: the velocity is turned by the
/// centrifugal force ρ sin ψ and the Coriolis force 2p across it.
fn turning(alpha: f64, psi: f64) -> f64 {
    let (p, rho, sine) = (libm::sinh(alpha), libm::cosh(alpha), libm::sin(psi));
    let across = rho * sine - 2.0 * p;
    -p * sine / rho - across / p
}

/// (A, α, ψ).
pub(crate) const ESCAPES: [[f64; 3]; 3] = [[1.2, 0.3, 0.5], [2.0, 0.5, 1.5], [3.0, 0.2, 2.0]];

#[derive(Debug, Clone, Copy)]
pub(crate) struct Following {
    pub tau: f64,
    /// Radians.
    pub psi: f64,
    /// At the α of that moment, radians.
    pub psi1: f64,

    /// (π/2 − ψ)/(π/2 − ψ₁).
    pub ratio: f64,
}

/// From τ = 0.1 to 1000.
pub(crate) fn following([a, alpha, psi]: [f64; 3]) -> Result<Vec<Following>, MotionError> {
    let run = Run::new(&Start::hyperbolic(a, alpha, psi)?, 1000.0)?;
    let moment = |i: u32| {
        let tau = libm::exp10(f64::from(i) / 20.0 - 1.0);
        let state = run.at(tau)?;
        let psi1 = printed::eq124_psi1(state.alpha().unwrap_or(f64::NAN));
        Ok(Following {
            tau,
            psi: state.psi(),
            psi1,

            ratio: state.lag() / (FRAC_PI_2 - psi1),
        })
    };
    (0..=80).map(moment).collect()
}

attempts![
    psi1 = stands_still(["(124)", "below"], BELOW_AND_ABOVE[0], printed::eq124_psi1),
    psi2 = stands_still(["(125)", "above"], BELOW_AND_ABOVE[1], printed::eq125_psi2),
    separation = {
        let trial = Trial::census(
            Printed,
            [
                r"which angle it is where $\psi$ stands still ($-1$ for $\psi_1$, 1 for $\psi_2$)",
                r"the sign of the rate at which two motions with the same $A$ and $\alpha$, and with $\psi$ smaller and larger by $10^{-4}$, move apart",
            ],
        );
        trial.drawn(0..40, |i, points| {
            let (a, alpha) = state(points);
            let psi = standstill(a, alpha, BELOW_AND_ABOVE[i % 2])?;
            let parting = psi_rate(a, alpha, psi + 1e-4)? - psi_rate(a, alpha, psi - 1e-4)?;
            let is = |formula: f64| (psi - formula).abs() < STANDS_STILL.value;
            let stated = match [
                is(printed::eq124_psi1(alpha)),
                is(printed::eq125_psi2(alpha)),
            ] {
                [true, false] => -1.0,
                [false, true] => 1.0,
                _ => f64::NAN,
            };
            Ok(Pair::plain(
                format!("{}, ψ = {psi:.6}", at(a, alpha)),
                stated,
                f64::signum(parting),
            ))
        })
    },
    frozen = {
        let trial = Trial::by(
            Integration,
            Printed,
            Compared::many(
                r"the angles, up to turns, to which (115) leads from any $\psi$ at fixed $\alpha$, forwards and backwards in time,",
                r"the angles below and above $\pi/2$ at which the forces turn velocity and position equally fast",
            ),
            FOREIGN,
        );
        trial.drawn(0..40, |i, points| {
            let (alpha, start) = (points.log_uniform(0.1, 1.5), points.uniform(-3.1, 3.1));
            let direction = [1.0, -1.0][i % 2];
            let rate =
                |_: f64, psi: &[f64; 1]| [direction * printed::eq115_psi_rate(alpha, psi[0])];
            // Fifty times the time in which a small deviation falls to a third.
            let until = 50.0 * 0.5 * libm::sinh(2.0 * alpha);
            let end = dop853::end(rate, 0.0, [start], until, 1e-13, 1e-13);
            let [low, high] = BELOW_AND_ABOVE[i % 2];
            let found = roots::root(|psi| turning(alpha, psi), low, high)?;
            Ok(Pair::plain(
                format!("α = {alpha:.6}, from ψ = {start:.6}"),
                end.map_or(f64::NAN, |[end]| {
                    end - TAU * libm::round((end - found) / TAU)
                }),
                found,
            ))
        })
    }
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_angle_turns_at_the_rate_of_the_law() {
        for psi in [0.4, -2.0, PI - 1e-9, 1e-9 - PI] {
            for (a, alpha) in [(0.5, 0.3), (2.0, 0.8)] {
                let (rate, law) = (
                    psi_rate(a, alpha, psi).unwrap(),
                    printed::eq115_psi_rate(alpha, psi),
                );
                assert!(
                    (rate - law).abs() < 1e-8 * (1.0 + law.abs()),
                    "ψ = {psi}: {rate}, {law}"
                );
                let own = turning(alpha, psi);
                assert!(
                    (own - law).abs() < 1e-14 * (1.0 + law.abs()),
                    "{own}, {law}"
                );
            }
        }
    }
}
