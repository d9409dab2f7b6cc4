//! What friction takes from the motion under pulses, of which the paper says nothing.

use super::drives::motion;
use super::prelude::*;

fn lost([eta, lambda]: [f64; 2]) -> Result<f64, Failure> {
    let drive = pulses(eta)?;
    let motion = motion(&drive, lambda)?;
    Ok(motion.ok_or("the motion drifts")?.lost())
}

/// What is stated, at random η and a friction that is a share of its range for each, and at both ends of this range.
fn against(
    stated: (&'static str, fn(f64, f64) -> f64),
    lambda: fn(f64, f64) -> f64,
    ends: [[f64; 2]; 2],
) -> Evidence {
    let (words, stated) = stated;
    let compared = Compared::one(words, "what friction takes from the motion in a period");
    let random = Points::here().within(60, [[0.05, 1.0], [0.02, 1.0]]);
    let random = random
        .into_iter()
        .map(|[eta, share]| [eta, lambda(eta, share)]);
    // None lose more than twice the scale.
    Trial::motion(Remark, compared).at(["η", "λ₀"], random.chain(ends), 1.0, |point| {
        let [eta, lambda] = point;
        Ok([stated(lambda, eta), lost(point)?])
    })
}

attempts![
    // λ₀ > η.
    with_rests = against(
        (r"$(1-\lambda_0)\eta^2\pi^2$", supplied::loss_with_rests),
        |eta, share| eta + (1.0 - eta) * share,
        [[2e-4, 5e-4], [0.5, 1.0 - 5e-4]]
    ),
    // λ₀ < η.
    without_rest = against(
        (
            r"$\frac12\pi^2\lambda_0(2\eta-\eta^2-\lambda_0^2)$",
            supplied::loss_without_rest
        ),
        |eta, share| eta * share,
        [[0.3, 5e-4], [1.0 - 1e-4, 1.0 - 5e-4]]
    )
];
