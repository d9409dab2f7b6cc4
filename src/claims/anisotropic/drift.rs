//! How far the particle creeps in a period and what friction takes from it: from the closed forms of the slips, which know
//! the regions but no motion. The paper says nothing of either.

use super::prelude::*;
use crate::corrections::anisotropic::{self as corrected, slip_distance};

/// What a period brings, dimensionless.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Budget {
    /// The mean velocity.
    pub drift: f64,
    /// What friction takes, per mass.
    pub lost: f64,
}

impl Budget {
    /// From the slip forwards under the friction `lambda0`, and the one backwards under `q` times that.
    fn of_slips(q: f64, lambda0: f64, forward: f64, backward: f64) -> Self {
        Budget {
            drift: (forward - backward) / TAU,
            lost: lambda0 * (forward + q * backward),
        }
    }
}

/// Half the length of the slip that begins at rest at the phase `from` ≤ π/2 under the friction `lambda` ≤
/// sin(from).
fn half_length(lambda: f64, from: f64) -> Result<f64, Failure> {
    let start = libm::asin(lambda);
    let w = |k: f64| libm::sin(from + k) * libm::sin(k) - lambda * k;
    // The slip is fastest at π − asin λ and over before 2π − asin λ.
    let (fastest, last) = (0.5 * (PI - start - from), 0.5 * (TAU - start - from));
    Ok(root(w, fastest, last)?)
}

/// Of a slip that begins where a rest ends.
fn from_rest(lambda: f64) -> Result<f64, Failure> {
    Ok(slip_distance(
        lambda,
        half_length(lambda, libm::asin(lambda))?,
    ))
}

/// The budget at a point that lies on none of the curves, region by region.
///
/// # Errors
/// A point on a curve; q or λ₀ not positive.
pub fn budget(q: f64, lambda0: f64) -> Result<Budget, Failure> {
    let region = corrected::region(lambda0, &Curves::at(q)?.corrected);
    let slips = |forward: f64, backward: f64| Budget::of_slips(q, lambda0, forward, backward);
    Ok(match region.ok_or("the point lies on a curve")? {
        1 => {
            let k = printed::eq53_k(q);
            Budget {
                drift: corrected::drift_without_rest(lambda0, k),
                lost: corrected::loss_without_rest(q, lambda0, k),
            }
        }
        2 => {
            // The backward slip begins where the forward one ends: half a period less, it is one that begins late.
            let start = libm::asin(lambda0);
            let end = start + 2.0 * half_length(lambda0, start)?;
            let backward = half_length(q * lambda0, end - PI)?;
            slips(from_rest(lambda0)?, slip_distance(q * lambda0, backward))
        }
        3 => slips(from_rest(lambda0)?, from_rest(q * lambda0)?),
        4 => slips(from_rest(lambda0)?, 0.0),
        _ => slips(0.0, 0.0),
    })
}

/// The friction at which friction takes most, for equal frictions, and what it takes: √2/π, which lies below λ_c, and 4/π.
pub fn most_lost() -> [f64; 2] {
    let at = std::f64::consts::SQRT_2 / PI;
    [at, corrected::loss_without_rest(1.0, at, FRAC_PI_2)]
}

#[cfg(test)]
mod tests {
    use super::super::simulated::{attractor, fits, own_digits};
    use super::*;
    use crate::motion::drive::{Interval, Sign};
    use crate::numerics::quadrature::integral_within;

    /// A few hundred of each region but V.
    fn points() -> Vec<(f64, f64)> {
        let mut random = fastrand::Rng::with_seed(24);
        let mut points = Vec::new();
        for _ in 0..3000 {
            let q = 1.0 + 11.0 * random.f64() * random.f64();
            points.push((q, 1.2 * random.f64() * random.f64()));
        }
        points
    }

    #[test]
    fn the_arcs_and_the_motion_bring_the_same() {
        let mut seen = [0; 5];
        for (q, lambda0) in points() {
            let motion = attractor(q, lambda0).unwrap();
            seen[fits(own_digits(motion.intervals())) - 1] += 1;
            let budget = budget(q, lambda0).unwrap();
            // With little friction the motion itself is less certain.
            let error = 1e-12 + TAU * motion.uncertainty();
            let close = |stated: f64, found: f64| (stated - found).abs() < error;
            assert!(
                close(TAU * budget.drift, motion.displacement()),
                "{q} {lambda0} {budget:?}"
            );
            assert!(
                close(budget.lost, motion.lost()),
                "{q} {lambda0} {budget:?}"
            );
            // It creeps the way it glides.
            assert!(budget.drift >= 0.0, "{q} {lambda0}");
        }
        assert!(seen.iter().all(|count| *count > 40), "{seen:?}");
    }

    #[test]
    fn what_friction_takes_the_drive_has_given() {
        for (q, lambda0) in points().into_iter().step_by(50) {
            let motion = attractor(q, lambda0).unwrap();
            let power = |phi: f64| libm::sin(phi) * motion.w(phi);
            let slips = motion
                .intervals()
                .iter()
                .filter(|one| one.sign != Sign::Rest);
            let part = |one: &Interval| {
                integral_within(power, one.start, one.end, 1e-13)
                    .unwrap()
                    .value
            };
            let parts = slips.map(part);
            assert!(
                (parts.sum::<f64>() - motion.lost()).abs() < 1e-12 + TAU * motion.uncertainty(),
                "{q} {lambda0}"
            );
        }
    }

    #[test]
    fn more_friction_and_less_of_a_ratio_slow_it_down() {
        for i in 0..60 {
            for j in 0..60 {
                let (q, lambda0) = (1.03 + 0.1 * f64::from(i), 0.004 + 0.0163 * f64::from(j));
                let drift = |q: f64, lambda0: f64| budget(q, lambda0).unwrap().drift;
                let here = drift(q, lambda0);
                assert!(drift(q, lambda0 + 0.0163) < here, "{q} {lambda0}");
                assert!(drift(q + 0.1, lambda0) > here - 1e-13, "{q} {lambda0}");
                // Never as fast as without friction.
                assert!(here < libm::cos(PI / (q + 1.0)), "{q} {lambda0}");
            }
        }
    }

    #[test]
    fn most_is_lost_with_equal_frictions() {
        let [at, most] = most_lost();
        assert!((most - 4.0 / PI).abs() < 1e-15);
        let lost = |q: f64, lambda0: f64| attractor(q, lambda0).unwrap().lost();
        assert!((lost(1.0, at) - most).abs() < 1e-12);
        for (q, lambda0) in points() {
            assert!(lost(q, lambda0) < most, "{q} {lambda0}");
        }
    }
}
