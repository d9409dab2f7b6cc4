//! What the slips bring, of which the paper says nothing: how far the particle goes, and what friction takes.

use super::prelude::*;

/// The less friction takes in a period, the less the motion itself knows of its velocity.
fn blurred(friction: f64) -> f64 {
    (5e-3 / friction).max(1.0)
}

/// q, λ₀ and the direction of a slip, in all regions with slips: from next to no friction to next to all that the drive
/// overcomes.
fn slips() -> Vec<(f64, f64, Sign)> {
    let mut points = Points::here();
    let mut slips = Vec::new();
    for i in 0..100 {
        let share = points.uniform(0.05, 0.95);
        let sign = match i % 3 {
            0 => Sign::Negative,
            _ => Sign::Positive,
        };
        let few = points.uniform(1.0, 4.0);
        slips.push(match i % 10 {
            0..6 => (few, share / few, sign),
            6 | 7 => {
                let many = points.uniform(4.0, 30.0);
                (many, share * PI / (many + 1.0).powi(2), sign)
            }
            // Beyond C there are forward slips alone.
            8 => (few, (1.0 + (few - 1.0) * share) / few, Sign::Positive),
            _ if i % 20 == 9 => (1.0, 1.0 - 1e-3 * share, sign),
            _ => (few, 1e-3 * share, sign),
        });
    }
    slips
}

pub(super) fn distances() -> Evidence {
    let trial = Trial::motion(
        Remark,
        [
            r"$2(\sin K-K\cos K)\sqrt{1-(\lambda K/\sin K)^2}$ for a slip of length $2K$ under the friction $\lambda$",
            "how far the particle goes in that slip of the motion",
        ],
    );
    trial.over(slips(), |(q, lambda0, sign)| {
        let motion = attractor(q, lambda0)?;
        let slip = motion.intervals().iter().find(|i| i.sign == sign);
        let length = slip.ok_or("no such slip")?.length();
        let [forward, backward] = motion.distances();
        let (way, lambda, found) = match sign {
            Sign::Positive => ("forward", lambda0, forward),
            _ => ("backward", q * lambda0, backward),
        };
        Ok(Pair {
            at: format!("q = {q:.6}, λ₀ = {lambda0:.6}, {way}"),
            stated: corrected::slip_distance(lambda, 0.5 * length),
            found,
            scale: length * blurred(lambda0),
        })
    })
}

pub(super) fn without_rest() -> Evidence {
    let trial = Trial::motion(Remark, Compared::many(
        r"the mean velocity $-\cos K\sqrt{1-(\lambda_0K/\sin K)^2}$ and what friction takes in a period, $2(1+q)\lambda_0\sin K$ times that root, with $K$ of (53),",
        "those of the motion",
    )
    .over("region I"));
    let mut points = Points::here();
    let cases = rows().map(|row| {
        let Row { q, changes, .. } = row?;
        Ok((*q, changes.rest * points.uniform(0.02, 1.0)))
    });
    trial.over(with_each(cases, [true, false]), |case| {
        let ((q, lambda0), creeps) = case?;
        let (k, motion) = (printed::eq53_k(q), attractor(q, lambda0)?);
        let (name, stated, found) = if creeps {
            let stated = corrected::drift_without_rest(lambda0, k);
            ("velocity", stated, motion.displacement() / TAU)
        } else {
            let stated = corrected::loss_without_rest(q, lambda0, k);
            ("loss", stated, motion.lost())
        };
        Ok(Pair {
            at: format!("q = {q:.6}, λ₀ = {lambda0:.6}, {name}"),
            stated,
            found,
            scale: blurred(lambda0),
        })
    })
}

attempts![distances, without_rest];
