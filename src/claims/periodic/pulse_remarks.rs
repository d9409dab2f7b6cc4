//! Trials of two remarks on the pulses: what becomes nonzero again at φ = π, and that their largest size is 1.

use super::drives::motion;
use super::prelude::*;
use super::pulses::on_a_plane;
use crate::corrections::periodic as corrected;

/// Motions of small friction, λ₀ < η, in the gap before π and as far behind π, in the next pulse: what is said to become
/// nonzero again there, with the pull. A short stretch of a motion that does not change its direction tells the acceleration.
fn around_pi(
    route: Route,
    subject: Subject,
    compared: Compared,
    pair: impl Fn([f64; 3]) -> Result<[f64; 2], Failure>,
) -> Evidence {
    let trial = Trial::by(route, subject, compared, GAINED);
    let points = Points::here().within(40, [[0.3, 0.8], [0.05, 0.6], [0.1, 0.8]]);
    let points = points
        .into_iter()
        .enumerate()
        .map(|(i, [eta, share, place])| {
            let before = (1.0 - eta).min(eta) * place * PI;
            let phi = if i % 2 == 0 {
                PI - before
            } else {
                PI + 0.5 * before
            };
            [eta, eta * share, phi]
        });
    trial.at(["η", "λ₀", "φ"], points, 1.0, pair)
}

/// The length of such a stretch, in phase.
const STEP: f64 = 1e-2;

/// The acceleration of friction in the periodic motion: what the drive does not give.
pub(crate) fn friction([eta, lambda, phi]: [f64; 3]) -> Result<f64, Failure> {
    let drive = pulses(eta)?;
    let motion = motion(&drive, lambda)?.ok_or("the motion drifts")?;
    Ok((motion.w(phi + STEP) - motion.w(phi)) / STEP - drive.h(phi))
}

/// The acceleration of the pull: that of a particle without friction.
fn pull([eta, _, phi]: [f64; 3]) -> Result<f64, Failure> {
    let start = DriveState { phi, w: 0.0 };
    let end = pulses(eta)?.advance(Friction::new(0.0, 0.0)?, start, phi + STEP)?;
    Ok(end.end.w / STEP)
}

fn pull_on_a_plane([eta, _, phi]: [f64; 3]) -> Result<f64, Failure> {
    let at = |phi| on_a_plane((eta, 0.0), 0.3, phi);
    Ok((at(phi + STEP)? - at(phi)?) / STEP)
}

fn largest(
    route: Route,
    subject: Subject,
    compared: Compared,
    etas: Vec<[f64; 1]>,
    found: impl Fn(f64) -> Result<f64, Failure>,
) -> Evidence {
    Trial::by(route, subject, compared, NONE).at(["η"], etas, 1.0, |[eta]| {
        Ok([printed::s23_largest(), found(eta)?])
    })
}

fn widths() -> Vec<[f64; 1]> {
    let mut widths = Points::here().within(40, [[0.0, 1.0]]);
    widths.extend([[1e-6], [1.0]]);
    widths
}

/// In the middle of each quarter of the cases.
fn seen(eta: f64) -> Result<f64, Failure> {
    let drive = pulses(eta)?;
    let middles = [0.5 * eta, 0.5 * (1.0 + eta)].map(|share| PI * share);
    let phases = middles.into_iter().flat_map(|phi| [phi, PI + phi]);
    Ok(phases.map(|phi| drive.h(phi).abs()).fold(0.0, f64::max))
}

/// What rounding leaves of a number of order one.
fn twelve_digits(x: f64) -> f64 {
    libm::round(1e12 * x) / 1e12
}

attempts![
    friction_again = around_pi(
        Integration,
        Printed,
        Compared::one(
            r"the acceleration of friction, which is said to become nonzero again at $\pi$,",
            r"the acceleration of a particle without friction, before and after $\pi$",
        ),
        |point| { Ok([printed::s23_nonzero_again(friction(point)?), pull(point)?]) }
    ),
    pull_again = around_pi(
        Integration,
        Corrected,
        Compared::one(
            r"the drive, which becomes nonzero again at $\pi$,",
            r"the acceleration of a particle without friction, before and after $\pi$",
        ),
        |point| {
            let [eta, _, phi] = point;
            Ok([corrected::nonzero_again(pulses(eta)?.h(phi)), pull(point)?])
        }
    ),
    pull_again_on_a_plane = around_pi(
        Quadrature,
        Corrected,
        Compared::one(
            r"the drive in the middle of a short stretch before or after $\pi$",
            "what a particle gains on a smooth plane over the stretch, divided by its length",
        ),
        |point| {
            let [eta, _, phi] = point;
            let drive = pulses(eta)?;
            let middle = corrected::nonzero_again(drive.h(phi + 0.5 * STEP));
            Ok([middle, pull_on_a_plane(point)?])
        }
    ),
    largest_census = largest(
        Census,
        Within,
        Compared::one(
            r"the largest $\lvert h\rvert$ that is assumed, 1,",
            "that of the pulses",
        ),
        widths(),
        seen
    ),
    largest_integration = largest(
        Integration,
        Within,
        Compared::one(
            r"the largest $\lvert h\rvert$ that is assumed, 1,",
            "what a pulse gives a particle without friction, divided by the length of the pulse, to 12 digits",
        ),
        widths(),
        |eta| {
            let rest = DriveState { phi: 0.0, w: 0.0 };
            let end = pulses(eta)?.advance(Friction::new(0.0, 0.0)?, rest, eta * PI)?;
            Ok(twelve_digits(end.end.w / (eta * PI)))
        },
    ),
    // Pulses of no width.
    largest_outside = {
        let compared = Compared::one(
            r"the largest $\lvert h\rvert$ that is assumed, 1,",
            r"$\lvert h\rvert$ of pulses of no width",
        );
        let phases = Points::here().within(20, [[0.0; 2], [0.0, TAU]]);
        Trial::census(Outside, compared).at(["η", "φ"], phases, 1.0, |[eta, phi]| {
            Ok([printed::s23_largest(), pulses(eta)?.h(phi).abs()])
        })
    },
    no_width = no_inside(
        "a pulse",
        r"$\eta=0$",
        [("η", [0.0, 1.0])],
        &[[0.0]],
        |[eta]| eta > 0.0,
    )
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_thirteenth_digit_is_rounded_and_no_other() {
        let rounded = [1.0 + 4e-13, 1.0 + 2e-12].map(twelve_digits);
        assert_eq!(rounded, [1.0, 1.000_000_000_002]);
    }
}
