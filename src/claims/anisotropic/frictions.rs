//! Trials of (47) to (52): the two frictions, and the rates while sliding either way.

use super::prelude::*;
use crate::motion::drive::Drive;

/// A ratio q: moderate, 1 where λ₀ is close to 1, and large in every tenth case.
fn ratio(i: usize, points: &mut Points) -> f64 {
    match i % 10 {
        6 => 1.0,
        8 => points.uniform(8.0, 12.0),
        _ => points.uniform(1.0, 3.0),
    }
}

/// μ₊, μ₋, g, A₀ and a phase. Half of the cases lie in the region without rest, half beyond it.
fn laboratory() -> impl Iterator<Item = [f64; 5]> {
    let mut points = Points::here();
    (0..100).map(move |i| {
        let (g, a0) = (points.uniform(0.2, 5.0), points.log_uniform(0.1, 10.0));
        let lambda = match i % 10 {
            4 => 5e-4,
            6 => 1.0 - 5e-4,
            8 => points.uniform(0.005, 0.015),
            even if even % 2 == 0 => points.uniform(0.05, 0.2),
            _ => points.uniform(0.3, 0.9),
        };
        let mu_plus = lambda * a0 / g;
        [
            mu_plus,
            mu_plus * ratio(i, &mut points),
            g,
            a0,
            // Close to λ₀ = 1 the particle moves for a moment only.
            match i % 20 {
                6 => 1.59,
                16 => 4.73,
                _ => points.uniform(0.0, TAU),
            },
        ]
    })
}

/// ϖ v_x under A₀ sin φ with the decelerations μ₊g and μ₋g: nothing is made dimensionless.
fn dimensional([mu_plus, mu_minus, g, a0, phi]: [f64; 5]) -> Result<f64, Failure> {
    let drive = Drive::new(|phi| a0 * libm::sin(phi), &[])?;
    let friction = Friction::new(mu_plus * g, mu_minus * g)?;
    let settled = drive.attractor(friction, START, 200)?.settled();
    Ok(settled.ok_or("a motion that drifts")?.w(phi))
}

fn against_dimensional(with: &'static str, friction: fn([f64; 5]) -> (f64, f64)) -> Evidence {
    const DIMENSIONAL: &str =
        r"$\varpi v_x$ under $A_0\sin\phi$ and the decelerations $\mu_+g$ and $\mu_-g$";
    Trial::consistency(
        Printed,
        Compared::composed(
            [r"$A_0\mathfrak w$ of the motion with ", with, ""],
            [DIMENSIONAL, "", ""],
        ),
    )
    .over(laboratory(), |case| {
        let [mu_plus, mu_minus, g, a0, phi] = case;
        let (plus, minus) = friction(case);
        let w = || -> Result<f64, Failure> {
            Ok(attractor_from(START, Friction::new(plus, minus)?)?.w(phi))
        };
        Ok(Pair {
            at: format!(
                "μ₊ = {mu_plus:.6}, μ₋ = {mu_minus:.6}, g = {g:.6}, A₀ = {a0:.6}, φ = {phi:.6}"
            ),
            // No motion has a friction below zero.
            stated: w().unwrap_or(f64::NAN) * a0,
            found: dimensional(case)?,
            // With next to no friction the end of a period says little about its periodic state.
            scale: a0 * (0.05 * a0 / (mu_plus * g)).max(1.0),
        })
    })
}

/// A printed rate, integrated within an interval of this sign, with the change of 𝔴 there.
fn summed_rate(
    law: &'static str,
    (way, sign): (&'static str, Sign),
    rate: fn(f64, f64, f64) -> f64,
) -> Evidence {
    let mut points = Points::here();
    // For q < 4 and λ₀ < 1/q there is motion both ways, for large q below (53).
    let cases = (0..300).map(move |i| {
        let (q, lambda0) = match i % 50 {
            24 => (1.0, 1.0 - 5e-4),
            49 => {
                let q = points.uniform(8.0, 30.0);
                (q, points.uniform(0.1, 0.9) * PI / ((q + 1.0) * (q + 1.0)))
            }
            k if k % 3 == 0 => (points.uniform(1.0, 4.0), points.log_uniform(1e-4, 0.1)),
            _ => {
                let q = points.uniform(1.0, 4.0);
                (q, points.uniform(0.1, 0.95) / q)
            }
        };
        let [a, b] = [0.0; 2].map(|_| points.uniform(0.0, 1.0));
        (q, lambda0, a.min(b), a.max(b))
    });
    Trial::quadrature(
        Printed,
        Compared::composed(
            [
                "the integral of ",
                law,
                r" over $\phi$ along a stretch of motion",
            ],
            [r"the change of $\mathfrak w$ there, ", way, ""],
        ),
    )
    .over(cases, |(q, lambda0, a, b)| {
        let motion = attractor(q, lambda0)?;
        let found = motion.intervals().iter().find(|i| i.sign == sign);
        let interval = found.ok_or_else(|| format!("no such motion at {q}, {lambda0}"))?;
        let [from, to] = [a, b].map(|share| interval.start + share * interval.length());
        let sum = integral_within(|phi| rate(q, lambda0, phi), from, to, 1e-13)?.value;
        Ok(Pair::plain(
            format!("q = {q:.6}, λ₀ = {lambda0:.6}, φ from {from:.6} to {to:.6}"),
            sum,
            motion.w(to) - motion.w(from),
        ))
    })
}

attempts![
    // The other friction is entered by hand.
    eq47 = against_dimensional(r"$\lambda_+$ of (47)", |[mu_plus, mu_minus, g, a0, _]| {
        (printed::eq47_lambda_plus(mu_plus, g, a0), mu_minus / a0 * g)
    }),
    eq48 = against_dimensional(r"$\lambda_-$ of (48)", |[mu_plus, mu_minus, g, a0, _]| {
        (
            mu_plus / a0 * g,
            printed::eq48_lambda_minus(mu_minus, g, a0),
        )
    }),
    eq49 = against_dimensional(
        r"$\lambda_+$ of (49), $\lambda_0=\mu_+g/A_0$,",
        |[mu_plus, mu_minus, g, a0, _]| {
            let plus = printed::eq49_lambda_plus(mu_plus * g / a0);
            (plus, mu_minus / a0 * g)
        },
    ),
    eq50 = against_dimensional(
        r"$\lambda_-$ of (50), $q=\mu_-/\mu_+$,",
        |[mu_plus, mu_minus, g, a0, _]| {
            let lambda0 = mu_plus * g / a0;
            let minus = printed::eq50_lambda_minus(mu_minus / mu_plus, lambda0);
            (lambda0, minus)
        },
    ),
    eq51_quadrature = summed_rate("(51)", ("forwards", Sign::Positive), |_, lambda0, phi| {
        printed::eq51_rate(lambda0, phi)
    }),
    eq52_quadrature = summed_rate("(52)", ("backwards", Sign::Negative), printed::eq52_rate)
];
