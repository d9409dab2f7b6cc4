//! Trials of what replaces the second stage: an exponential of an exponential, or an end after a finite time.

use super::across::strobed;
use super::runs::{ORIGIN, Particle, drive, lambda_c, settled};
use crate::claims::compare::{Failure, Pair, Trial};
use crate::claims::points::Points;
use crate::claims::tolerances::{LAST_STAGE, LOGARITHM, NONE, PASSAGE};
use crate::corrections::sinusoidal as corrected;
use crate::evidence::{Evidence, Route, Subject};
use crate::motion::drive::{Attractor, PlanarState, Sign};
use crate::numerics::quadrature::integral;
use crate::scalar::Scalar;
use std::f64::consts::{PI, TAU};

/// Frictions below λ_c, where the passages are not too steep to be followed.
fn below(stream: u64, high: f64) -> impl Iterator<Item = f64> {
    let mut points = Points::stream(stream);
    (0..24).map(move |_| points.uniform(0.05, high))
}

fn at(lambda: f64) -> String {
    format!("λ₀ = {lambda:.6}")
}

/// Half way along the forward slip of the periodic motion: phase and velocity.
fn on_the_way(attractor: &Attractor) -> Result<[f64; 2], Failure> {
    let slip = attractor
        .intervals()
        .iter()
        .find(|i| i.sign == Sign::Positive);
    let slip = slip.ok_or("no slip")?;
    let phi = 0.5 * (slip.start + slip.end);
    Ok([phi, attractor.w(phi)])
}

/// λ₀ < λ_c: the factor by which ln 𝔴_y grows in a period, at 𝔴_y about exp(−1e9).
pub fn period_factor() -> Evidence {
    let compared = "((s + λ₀)/(s − λ₀))² with the factor by which ln 𝔴_y grows in a period, from ln 𝔴_y = −1e9 on";
    let trial = Trial::by(Route::Integration, Subject::Corrected, compared, LOGARITHM);
    trial.over(below(170, lambda_c() - 1e-3), |lambda| {
        let [phi, w_x] = on_the_way(&settled(lambda, ORIGIN)?)?;
        let start = PlanarState {
            phi,
            w_x,
            ln_w_y: -1e9,
        };
        let states = drive()?.planar(lambda, start, &[phi + TAU])?;
        let stated = 1.0 / corrected::contraction(lambda);
        Ok::<_, Failure>(Pair {
            at: at(lambda),
            stated,
            found: states[0].ln_w_y / start.ln_w_y,
            scale: stated,
        })
    })
}

/// The same, from an ordinary start: the last of the periods until ln 𝔴_y = −1e8.
pub fn period_factor_reached() -> Evidence {
    let compared = "((s + λ₀)/(s − λ₀))² with the last growth of ln 𝔴_y over a period on the way from 𝔴_y = 0.5 to exp(−1e8)";
    let trial = Trial::by(Route::Limit, Subject::Corrected, compared, PASSAGE);
    let mut points = Points::stream(171);
    trial.over(0..20, |_| {
        let lambda = points.uniform(0.3, lambda_c() - 0.02);
        let states = strobed(lambda, points.uniform(-1.0, 1.0), 0.5, 22)?;
        let last = states
            .iter()
            .rposition(|s| s.ln_w_y > -1e8)
            .ok_or("no state")?;
        let factor = match last.checked_sub(1) {
            Some(before) => states[last].ln_w_y / states[before].ln_w_y,
            None => f64::NAN,
        };
        let stated = 1.0 / corrected::contraction(lambda);
        Ok::<_, Failure>(Pair {
            at: at(lambda),
            stated,
            found: factor,
            scale: stated,
        })
    })
}

/// λ₀ < λ_c, by the other integrator: one passage through zero, from two sizes of v_y.
pub fn passage_limit() -> Evidence {
    let compared = "(s + λ₀)/(s − λ₀) with Δ ln v_y after over Δ ln v_y before a passage of a particle, v_y = 1e-6 and 1e-8";
    let trial = Trial::by(Route::Limit, Subject::Corrected, compared, PASSAGE);
    trial.over(below(172, 0.42), |lambda| {
        let [phi, w_x] = on_the_way(&settled(lambda, ORIGIN)?)?;
        let through = |v_y: f64| {
            let motion = Particle::plain(lambda).run(phi, [w_x, v_y], phi + PI)?;
            Ok::<_, Failure>(Scalar::ln(motion.end().v[1]))
        };
        let after = through(1e-6)? - through(1e-8)?;
        let stated = corrected::passage_factor(lambda, corrected::drive_at_zero(lambda));
        Ok::<_, Failure>(Pair {
            at: at(lambda),
            stated,
            found: after / Scalar::ln(100.0),
            scale: stated,
        })
    })
}

/// λ₀ < λ_c, by quadrature of d ln 𝔴_y = −λ₀ dφ/|𝔴| towards and from a zero of the simulated motion on the line.
pub fn passage_quadrature() -> Evidence {
    let compared = "(s + λ₀)/(s − λ₀) with (1 + q)/(1 − p), p and q the coefficients of the logarithm in λ₀ ∫ dφ/|𝔴| before and after a zero of 𝔴";
    let trial = Trial::by(Route::Quadrature, Subject::Corrected, compared, PASSAGE);
    trial.over(below(173, lambda_c() - 1e-2), |lambda| {
        let attractor = settled(lambda, ORIGIN)?;
        let slip = attractor
            .intervals()
            .iter()
            .find(|i| i.sign == Sign::Positive);
        let zero = slip.ok_or("no slip")?.end;
        // In ln(distance) the integrand is smooth; the coefficient is its mean over two decades.
        let coefficient = |side: f64| {
            let integrand = |x: f64| {
                let distance = Scalar::exp(x);
                lambda * distance / attractor.w(zero + side * distance).abs()
            };
            let (low, high) = (Scalar::ln(1e-8), Scalar::ln(1e-6));
            Ok::<_, Failure>(integral_mean(integrand, low, high)?)
        };
        let (p, q) = (coefficient(-1.0)?, coefficient(1.0)?);
        let stated = corrected::passage_factor(lambda, corrected::drive_at_zero(lambda));
        Ok::<_, Failure>(Pair {
            at: at(lambda),
            stated,
            found: (1.0 + q) / (1.0 - p),
            scale: stated / (1.0 - lambda / corrected::drive_at_zero(lambda)),
        })
    })
}

/// The mean of a function.
fn integral_mean(f: impl Fn(f64) -> f64, low: f64, high: f64) -> Result<f64, Failure> {
    Ok(integral(f, low, high)?.value / (high - low))
}

/// λ₀ > λ_c: v_y is exactly zero after a finite time, and the particle stops during a rest of the motion on the line.
pub fn finite_end() -> Evidence {
    let compared = "1 with 1 where 𝔴_y is exactly 0 after 12 periods, and 𝔴 is then that of the motion on the line";
    let trial = Trial::by(Route::Integration, Subject::Corrected, compared, NONE);
    let mut points = Points::stream(174);
    trial.over(0..30, |_| {
        let lambda = points.uniform(lambda_c() + 1e-3, 1.4);
        let (w_x, w_y) = (points.uniform(-1.0, 1.0), points.uniform(0.1, 3.0));
        let states = strobed(lambda, w_x, w_y, 12)?;
        let last = states.last().ok_or("no state")?;
        let line = settled(lambda, ORIGIN)?.w(last.phi);
        let ended = last.ln_w_y == f64::NEG_INFINITY && (last.w_x - line).abs() < 1e-12;
        Ok::<_, Failure>(Pair {
            at: format!("λ₀ = {lambda:.6}, 𝔴 = {w_x:.6}, 𝔴_y = {w_y:.6}"),
            stated: 1.0,
            found: f64::from(u8::from(ended)),
            scale: 1.0,
        })
    })
}

/// λ₀ > λ_c, by the other integrator: how long the last stage lasts.
pub fn last_stage() -> Evidence {
    let compared = "λ₀ v_y/(λ₀² − h²) with the time that a particle with v_x = 0 and a small v_y takes to stop where |h| < λ₀";
    let trial = Trial::by(Route::Limit, Subject::Corrected, compared, LAST_STAGE);
    let mut points = Points::stream(175);
    trial.over(0..30, |_| {
        let lambda = points.uniform(lambda_c(), 1.4);
        let phi = points.uniform(0.0, 0.9) * Scalar::asin(lambda.min(1.0));
        let h = Scalar::sin(phi);
        let v_y = 1e-6;
        let motion = Particle::plain(lambda).run(phi, [0.0, v_y], phi + 1.0)?;
        let stop = motion.first_stop().ok_or("no stop")?;
        let stated = corrected::last_stage(lambda, h, v_y);
        Ok::<_, Failure>(Pair {
            at: format!("λ₀ = {lambda:.6}, φ = {phi:.6}, v_y = 1e-6"),
            stated,
            found: stop - phi,
            scale: stated,
        })
    })
}
