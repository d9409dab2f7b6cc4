//! The motions that the statements about rest are held against: particles followed down to p = 10⁻³⁰.

use super::prelude::*;
use crate::claims::escape::trajectories::{a, alpha, rates};
use std::sync::{Mutex, PoisonError};

#[derive(Debug)]
pub(crate) struct Approach {
    /// ρ, p and ψ at the start.
    pub start: [f64; 3],
    /// ρ at rest.
    pub sigma: f64,
    pub run: Run,
    /// Those that were asked for, by speed.
    moments: Mutex<Vec<(f64, Close)>>,
}

#[derive(Debug, Clone, Copy)]
pub(crate) struct Close {
    /// Time until the stop.
    pub left: f64,
    pub alpha: f64,
    pub psi: f64,
    pub a: f64,
    /// dα/dτ, by differences; so are the three slopes.
    pub alpha_rate: f64,
    /// dψ/dα.
    pub psi_slope: f64,
    /// α d/dα of [`ratio`](Self::ratio).
    pub ratio_slope: f64,
    /// dA/dα.
    pub a_slope: f64,
    /// dA/dα by the way that is still to go, dA² = 2 ds.
    pub a_slope_by_way: f64,
    pub way_left: f64,
}

impl Close {
    /// The order of what (140) to (145) leave out, relative to what they keep.
    pub(crate) fn omitted(&self, sigma: f64) -> f64 {
        (self.alpha * self.alpha + self.psi * self.psi) / (sigma * (1.0 - sigma) * (1.0 - sigma))
    }

    /// What (143) has in brackets, times 1.
    pub(crate) fn ratio(&self) -> f64 {
        self.psi / (2.0 * self.alpha)
    }

    /// The size of what (143) leaves out of [`ratio`](Self::ratio).
    pub(crate) fn left_out(&self) -> f64 {
        (self.alpha * self.alpha + self.psi * self.psi) * self.ratio().abs()
    }
}

impl Approach {
    /// Nothing if it does not come to rest.
    pub(crate) fn new(start: [f64; 3]) -> Result<Option<Self>, Failure> {
        let [rho, p, psi] = start;
        let run = Run::new(&Start::polar(rho, p, psi)?, 50.0)?;
        let end = run.end();
        Ok((end.p() < 1e-29).then_some(Approach {
            start,
            sigma: end.rho(),
            run,
            moments: Mutex::default(),
        }))
    }

    pub(crate) fn at(&self) -> String {
        let ([rho, p, psi], sigma) = (self.start, self.sigma);
        format!("ρ = {rho:.6}, p = {p:.6}, ψ = {psi:.6} at the start, σ = {sigma:.6}")
    }

    /// The moment in the middle of what is left when p falls below `speed`.
    pub(crate) fn close(&self, speed: f64) -> Result<Close, Failure> {
        let mut moments = self.moments.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, close)) = moments.iter().find(|(of, _)| *of == speed) {
            return Ok(*close);
        }
        let close = self.close_at(speed)?;
        moments.push((speed, close));
        Ok(close)
    }

    fn close_at(&self, speed: f64) -> Result<Close, Failure> {
        let node = self.run.nodes().find(|s| s.p() < speed);
        let node = node.ok_or("the speed does not fall so low")?;
        // A clock of its own, so that tiny times keep their digits.
        let tail = Run::new(&node.parts, 50.0)?;
        let end = tail.end();
        let stop = end.tau + end.p() / end.deficit;
        let (t, h) = (0.5 * stop, 2e-3 * stop);
        let [alpha_rate, psi_rate, way_rate] = rates(t, h, |t| {
            let s = tail.at(t)?;
            Ok([alpha(&s), s.psi(), s.s])
        })?;
        // In ln(stop − t), in which a power of the time left is smooth, the steps can be longer: less of rounding is left. What
        // they leave out is the same part of any slope of that power.
        let [ratio_rate, log_rate] = rates(libm::log(stop - t), 0.05, |log| {
            let s = tail.at(stop - libm::exp(log))?;
            Ok([s.psi() / (2.0 * alpha(&s)), libm::log(alpha(&s))])
        })?;
        let [wide_rate] = rates(t, 0.1 * stop, |t| Ok([a(&tail.at(t)?)]))?;
        let now = tail.at(t)?;
        let size = a(&now);
        Ok(Close {
            left: stop - t,
            alpha: alpha(&now),
            psi: now.psi(),
            a: size,
            alpha_rate,
            psi_slope: psi_rate / alpha_rate,
            ratio_slope: ratio_rate / log_rate,
            a_slope: wide_rate / alpha_rate,
            a_slope_by_way: way_rate / (size * alpha_rate),
            way_left: end.s - now.s,
        })
    }
}

/// Motions to rest at σ from 0.05 to 0.98.
pub(crate) static APPROACHES: Runs<Vec<Approach>> = Runs::new(all_approaches);

pub(crate) static OTHER_APPROACHES: Runs<Vec<Approach>> = Runs::new(|| others(all_approaches));

fn all_approaches() -> Result<Vec<Approach>, Failure> {
    let mut points = Points::here();
    let mut found = Vec::new();
    for _ in 0..220 {
        let rho = points.uniform(0.05, 1.0);
        let p = rho.min(1.0 - rho) * points.uniform(0.1, 0.9);
        let start = [rho, p, points.uniform(-2.8, 2.8)];
        // A never decreases: this one ends beyond 0.98, after steps without number if ρ is close enough to 1.
        if rho * rho - p * p > 0.98 * 0.98 {
            continue;
        }
        found.extend(
            Approach::new(start)?.filter(|approach| (0.05..0.98).contains(&approach.sigma)),
        );
    }
    Ok(found)
}

pub(crate) fn approaches_to(
    ranges: &'static [(f64, f64)],
) -> impl Iterator<Item = Result<&'static Approach, Failure>> {
    only(APPROACHES.each(), |approach| {
        let inside = |&(low, high)| low < approach.sigma && approach.sigma < high;
        ranges.iter().any(inside)
    })
}

/// Those that do not start near ψ = π, where the constant c of (143) is large.
pub(crate) fn gentle_approaches_to(
    ranges: &'static [(f64, f64)],
) -> impl Iterator<Item = Result<&'static Approach, Failure>> {
    only(approaches_to(ranges), |approach| {
        approach.start[2].abs() < 2.2
    })
}

/// The ρ of the start is found from the resting place.
pub(crate) static APPROACHES_TO_ONE_HALF: Runs<Vec<Approach>> = Runs::new(|| {
    let mut points = Points::here();
    every((0..20).map(|_| to_one_half(points.uniform(0.05, 0.2), points.uniform(-2.5, 2.5))))
});

fn to_one_half(p: f64, psi: f64) -> Result<Approach, Failure> {
    let resting = |rho: f64| match Start::polar(rho, p, psi).and_then(|s| fate(&s)) {
        Ok(Fate::Rest { sigma, .. }) => sigma - 0.5,
        _ => f64::NAN,
    };
    let rho = root(resting, 0.3, 0.7)?;
    Ok(Approach::new([rho, p, psi])?.ok_or("it does not come to rest")?)
}
