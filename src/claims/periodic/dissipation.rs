//! What friction takes from the motion under pulses, of which the paper says nothing.

use super::drives::{motion, pulses};
use crate::corrections::periodic as supplied;
use trialbook::prelude::*;

/// (η, λ₀): random ones, and both ends of λ₀.
fn cases(
    stream: u64,
    lambda: fn(f64, f64) -> f64,
    ends: [[f64; 2]; 2],
) -> impl Iterator<Item = [f64; 2]> {
    let random = Points::stream(stream).within(60, [[0.05, 1.0], [0.02, 1.0]]);
    let random = random
        .into_iter()
        .map(move |[eta, share]| [eta, lambda(eta, share)]);
    random.chain(ends)
}

fn lost([eta, lambda]: [f64; 2]) -> Result<f64, Failure> {
    let drive = pulses(eta)?;
    let motion = motion(&drive, lambda)?;
    Ok(motion.ok_or("the motion drifts")?.lost())
}

fn against(
    compared: Compared,
    cases: impl Iterator<Item = [f64; 2]>,
    stated: fn(f64, f64) -> f64,
) -> Evidence {
    let trial = Trial::motion(Subject::Remark, compared);
    // None lose more than twice that.
    trial.at(["η", "λ₀"], cases, 1.0, |point| {
        let [eta, lambda] = point;
        Ok([stated(lambda, eta), lost(point)?])
    })
}

/// With rests, λ₀ > η.
fn with_rests() -> Evidence {
    let compared = Compared::one(
        r"$(1-\lambda_0)\eta^2\pi^2$",
        "what friction takes from the motion in a period",
    );
    let lambda = |eta, share| eta + (1.0 - eta) * share;
    let ends = [[2e-4, 5e-4], [0.5, 1.0 - 5e-4]];
    against(
        compared,
        cases(752, lambda, ends),
        supplied::loss_with_rests,
    )
}

/// Without, λ₀ < η.
pub fn without_rest() -> Evidence {
    let compared = Compared::one(
        r"$\frac12\pi^2\lambda_0(2\eta-\eta^2-\lambda_0^2)$",
        "what friction takes from the motion in a period",
    );
    let lambda = |eta, share| eta * share;
    let ends = [[0.3, 5e-4], [1.0 - 1e-4, 1.0 - 5e-4]];
    against(
        compared,
        cases(753, lambda, ends),
        supplied::loss_without_rest,
    )
}

pub(super) const TRIALS: &[Attempt] = trials![with_rests, without_rest];
