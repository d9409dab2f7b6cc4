//! The motions that the printed formulas of section 2.2 are held against, and the frictions at which they are tried.

use super::prelude::*;
use crate::motion;

pub(crate) fn at(lambda: f64) -> String {
    format!("λ₀ = {lambda:.6}")
}

/// The sine as a drive: the motion knows it as a function to evaluate, no more.
pub fn drive() -> Result<&'static Drive, Failure> {
    static DRIVE: Runs<Drive> = Runs::setting(|| Ok(Drive::new(libm::sin, &[])?));
    DRIVE.get()
}

/// The friction at which a slip from rest ends just where the next one could begin, by the motion alone: it divides
/// the frictions of the trials, and nothing is compared with it. NaN where that fails, which no trial survives.
pub(crate) fn lambda_c() -> f64 {
    struct Onset(f64);
    impl Setting for Onset {}
    static ONSET: Runs<Onset> = Runs::setting(|| Ok(Onset(root(excess_length, 0.2, 0.9)?)));
    ONSET.get().map_or(f64::NAN, |onset| onset.0)
}

/// By how much a slip from rest lasts longer than half a period; NaN where it cannot be followed.
pub(crate) fn excess_length(lambda: f64) -> f64 {
    Slip::of(lambda).map_or(f64::NAN, |slip| slip.end - slip.start - PI)
}

const PERIODS: u32 = 200;

pub(crate) fn settled(lambda: f64, start: DriveState) -> Result<Attractor<'static>, Failure> {
    let friction = Friction::new(lambda, lambda)?;
    let outcome = drive()?.attractor(friction, start, PERIODS)?;
    outcome
        .settled()
        .ok_or_else(|| "the motion drifts".to_owned().into())
}

/// Where the drive is below any friction.
pub(crate) const ORIGIN: DriveState = DriveState { phi: 0.0, w: 0.0 };

/// All over the plane, from far off too.
pub(crate) fn starts() -> [DriveState; 7] {
    [
        (0.0, 0.0),
        (0.9, -6.0),
        (1.8, 4.0),
        (2.7, -0.3),
        (3.6, 0.5),
        (4.5, 2.0),
        (5.4, -25.0),
    ]
    .map(|(phi, w)| DriveState { phi, w })
}

pub(crate) fn forward(list: &[Interval]) -> Option<&Interval> {
    list.iter().find(|i| i.sign == Sign::Positive)
}

/// Below λ_c: down to a millionth, up to a billionth below λ_c.
pub(crate) fn small() -> Vec<f64> {
    let mut points = Points::here();
    let c = lambda_c();
    let mut list: Vec<_> = (0..60).map(|_| points.uniform(0.02, c)).collect();
    list.extend([1e-6, 1e-3, 1e-2, c - 1e-3, c - 1e-6, c - 1e-9]);
    list
}

/// Between λ_c and 1, to a billionth of either.
pub(crate) fn large() -> Vec<f64> {
    let mut points = Points::here();
    let c = lambda_c();
    let mut list: Vec<_> = (0..60).map(|_| points.uniform(c, 1.0)).collect();
    list.extend([c + 1e-9, c + 1e-6, c + 1e-3]);
    list.extend([1.0 - 1e-3, 1.0 - 5e-4, 1.0 - 1e-6, 1.0 - 1e-9]);
    list
}

/// Between 0 and 1, and both ends to a billionth.
pub(crate) fn all() -> Vec<f64> {
    let mut points = Points::here();
    let mut list: Vec<_> = (0..200).map(|_| points.uniform(0.0, 1.0)).collect();
    for near in [1e-9, 1e-6, 1e-3] {
        list.extend([near, 1.0 - near, lambda_c() - near, lambda_c() + near]);
    }
    list.extend([1e-2, 1e-4, 1e-5].map(|near| 1.0 - near));
    list
}

/// Between 0 and 1, with the two ends and λ_c approached to 1e-9.
pub(crate) fn dense() -> Vec<f64> {
    let mut points = Points::here();
    let mut list: Vec<_> = (0..1200).map(|_| points.uniform(1e-3, 1.0)).collect();
    for i in 0..30 {
        let near = libm::pow(10.0, -3.0 - 0.2 * f64::from(i));
        list.extend([near, 1.0 - near, lambda_c() - near, lambda_c() + near]);
    }
    list
}

/// Forward, from rest at phase 0.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Slip {
    /// Where the rest ends.
    pub start: f64,
    /// Where w comes back to zero.
    pub end: f64,
}

impl Slip {
    pub(crate) fn of(lambda: f64) -> Result<Self, Failure> {
        let friction = Friction::new(lambda, lambda)?;
        let path = drive()?.advance(friction, ORIGIN, 9.0)?;
        let slip = path.intervals.iter().find(|i| i.sign == Sign::Positive);
        let slip = slip.ok_or("no forward slip")?;
        Ok(Slip {
            start: slip.start,
            end: slip.end,
        })
    }
}

/// By the printed (32): its root between φ₂ and φ₄; not a number if there is none.
pub(crate) fn phi_t2(lambda: f64) -> f64 {
    let phi1 = printed::eq27_phi1(lambda);
    let left = |phi: f64| printed::eq32_left(lambda, phi1, phi);
    root(left, printed::eq28_phi2(lambda), printed::eq30_phi4(lambda)).unwrap_or(f64::NAN)
}

/// How far a unit of rounding in 𝔴, whose terms are at most 2 + λ₀φ, moves the end of a slip.
pub(crate) fn end_spread(lambda: f64, end: f64) -> f64 {
    (2.0 + lambda * end) / (libm::sin(end) - lambda).abs()
}

/// On the plane of (21), in length and time units of its own.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Particle {
    /// Friction per mass, μg.
    pub friction: f64,
    pub a0: f64,
    pub varpi: f64,
}

impl Particle {
    /// With A₀ = ϖ = 1, so that μg is λ₀, t is φ and v is w.
    pub(crate) fn plain(lambda: f64) -> Self {
        Particle {
            friction: lambda,
            a0: 1.0,
            varpi: 1.0,
        }
    }

    pub(crate) fn run(&self, t: f64, v: [f64; 2], until: f64) -> Result<Motion, Failure> {
        let sine = Signal::Sine {
            frequency: self.varpi,
            phase: 0.0,
        };
        let start = motion::State { t, v, x: [0.0; 2] };
        let plane = Plane::along([-self.a0, 0.0], sine);
        Ok(motion::run(&plane, self.friction, start, until)?)
    }
}

/// How many of the sorted `ends` come before `phi`: the index of a formula's case.
pub(crate) fn case_of(ends: &[f64], phi: f64) -> usize {
    let inner = &ends[1..ends.len() - 1];
    inner.iter().filter(|end| **end <= phi).count()
}

/// At a phase between φ₁ and φ₁ + 2π.
pub(crate) fn eq33(lambda: f64, phi_t2: f64, phi: f64) -> Double {
    let (phi1, phi3) = (printed::eq27_phi1(lambda), printed::eq29_phi3(lambda));
    let ends = printed::eq33_ends(phi1, phi_t2, phi3);
    let [l, phi_n] = [lambda, phi].map(Double::from);
    let cases = printed::eq33_w(l, printed::eq27_phi1(l), printed::eq29_phi3(l), phi_n);
    cases[case_of(&ends, phi)]
}

/// With (39), at a phase between φ̃₁ and φ̃₁ + 2π.
pub(crate) fn eq38(lambda: f64, phi: f64) -> Double {
    let ends = printed::eq38_ends(printed::eq39_phi_t1(lambda));
    let [l, phi_n] = [lambda, phi].map(Double::from);
    let cases = printed::eq38_w(l, printed::eq39_phi_t1(l), phi_n);
    cases[case_of(&ends, phi)]
}

/// (38) below the printed λ_c, (33) up to 1, rest above.
pub(crate) fn printed_late(lambda: f64, phi: f64) -> f64 {
    let within = |from: f64| from + (phi - from).rem_euclid(TAU);
    let [left, right] = printed::eq25_sides(lambda);
    if lambda < printed::eq37_lambda_c() {
        eq38(lambda, within(printed::eq39_phi_t1(lambda))).to_f64()
    } else if left < right {
        let from = printed::eq27_phi1(lambda);
        eq33(lambda, phi_t2(lambda), within(from)).to_f64()
    } else {
        0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn forward_motion_is_found_among_others() {
        let list: Vec<_> = [Sign::Rest, Sign::Negative, Sign::Positive, Sign::Positive]
            .into_iter()
            .zip(0..)
            .map(|(sign, k)| Interval {
                sign,
                start: f64::from(k),
                end: f64::from(k + 1),
            })
            .collect();
        assert_eq!(forward(&list).unwrap().start, 2.0);
        assert!(forward(&list[..2]).is_none());
    }

    #[test]
    fn motions_start_on_both_sides_of_rest() {
        let starts = starts();
        let count = |sign: f64| starts.iter().filter(|s| s.w * sign > 0.0).count();
        assert_eq!([count(1.0), count(-1.0)], [3, 3]);
    }
}
