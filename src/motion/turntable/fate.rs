//! Does the particle come to rest on the table for good, and where?
//!
//! Four properties of a state on the dimensionless table decide. Each follows from Newton's law as in
//! [`intrinsic`](super::intrinsic) (dots are derivatives by τ, ′ those by s with dτ = p ds) and, once true, stays
//! true, so that it is enough to look at the nodes of the integration.
//!
//! - *Near* (p + ρ < 1): comes to rest. ξ ≤ ρ, so that ṗ ≤ ρ − 1; while the particle has gone the way S, ρ has grown
//!   by S at most, so p²/2 falls at least as p₀²/2 − (1 − ρ₀)S + S²/2, which is zero at an S < 1 − ρ₀: the particle
//!   stops inside ρ < 1, where static friction holds it. ξ never decreases (ξ′ = ζ²), so ṗ ≥ ξ₀ − 1. Therefore
//!
//!   ```text
//!   p₀²/(2(1 − ξ₀)) ≤ S ≤ p₀²/(1 − ρ₀ + √((1 − ρ₀)² − p₀²)),    σ² = ρ₀² − p₀² + 2S,
//!   ```
//!
//!   the last since (ρ² − p²)˙ = 2p and p = 0 at rest. Once ζ ≤ −p with 0 < w < 1 (see *ahead*), dw/dS = −ζ²/p² ≤ −1,
//!   hence d(p²/2)/dS = −w ≥ −(w₀ − S), and the first bound becomes p₀²/(w₀ + √(w₀² − p₀²)) with w₀ = 1 − ξ₀ > p₀. The
//!   particle is followed until the bounds are close.
//! - *Energy* (ρ² − p² ≥ 1, p > 0): never rests. ρ² − p² grows, and at rest it would be σ² ≤ 1.
//! - *Outward* (ξ ≥ 1, p > 0): never rests. ξ never decreases, so p does not decrease either.
//! - *Ahead* (0 < ξ < 1, ζ ≤ −p, p > w with w = 1 − ξ): never rests. At ζ = −p, (ζ + p)′ = −2pw < 0, so that ζ ≤ −p
//!   as long as w > 0. Then (p² − w²)′ = 2w(ζ² − p²) ≥ 0, so p² − w² stays above a positive number, and
//!   w′ = −ζ² ≤ −p² below a negative one: w becomes zero, which is the property before.
//!
//! A particle that never rests goes away for ever. If it stayed within bounds, ρ² − p² would converge and the way
//! ∫p dτ be finite, so the place would converge; there the pull would have to be balanced for good: a rest at ρ > 1.
//! It may stop for a moment (a start from rest at ρ > 1, a motion straight inwards).

use super::intrinsic::{Law, Start, check};
use crate::motion::error::MotionError;
use crate::numerics::taylor::{Control, Integrator, Step};

/// What becomes of a particle on the dimensionless table.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Fate {
    /// It comes to rest.
    Rest {
        /// Distance σ of its place from the axis.
        sigma: f64,
        /// When.
        tau: f64,
        /// Half the distance of the bounds of σ: below 2·10⁻¹³ except for 1 − σ below about 10⁻³, where the approach
        /// is so slow that the search ends earlier. The time is known to 10⁻⁹ then.
        error: f64,
    },
    /// It goes away for ever.
    Escape {
        /// Time by which this was certain.
        tau: f64,
        /// The property that made it so.
        because: Escaping,
    },
    /// Neither is certain after the steps allowed: so close to the boundary that rounding decides.
    Undecided {
        /// Time reached.
        tau: f64,
        /// Speed there.
        p: f64,
    },
}

/// Why a particle never comes to rest; see [the proofs](self).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Escaping {
    /// ρ² − p² ≥ 1.
    Energy,
    /// The centrifugal pull along the velocity is at least the friction, ξ ≥ 1.
    Outward,
    /// It is faster than friction can see to: p > 1 − ξ > 0 with ζ ≤ −p.
    Ahead,
}

/// Steps after which a fate is undecided.
pub const STEPS: usize = 50_000;

/// Steps spent on the place and the time of a rest that is certain.
const REFINEMENT: usize = 2000;

/// Terms of the series: the fastest number for steps that need no dense output.
const ORDER: usize = 24;

/// Wanted half-width of the bounds of σ, and width of those of τ.
const RADIUS: f64 = 2e-13;
const TIME: f64 = 1e-9;

/// The fate of a particle.
///
/// # Errors
/// [`MotionError::Argument`] for a start that no constructor of [`Start`] gives, [`MotionError::Numerics`] when
/// numbers overflow.
pub fn fate(start: &Start) -> Result<Fate, MotionError> {
    follow(start, true)
}

/// As [`fate()`], but a rest is reported as soon as it is certain, with σ and τ bounded only roughly.
///
/// # Errors
/// As for [`fate()`].
pub fn rests(start: &Start) -> Result<Option<bool>, MotionError> {
    Ok(match follow(start, false)? {
        Fate::Rest { .. } => Some(true),
        Fate::Escape { .. } => Some(false),
        Fate::Undecided { .. } => None,
    })
}

fn follow(start: &Start, closely: bool) -> Result<Fate, MotionError> {
    check(start)?;
    let state = [0.0, start.p, 1.0 - start.xi, start.zeta];
    let mut integrator = Integrator::<_, _, 4, ORDER>::new(&Law, 0.0, state, Control::Each);
    let mut step = Step::empty();
    let mut refined = 0;
    for _ in 0..STEPS {
        match judge(integrator.state()) {
            Some(Judgement { fate, close }) if close || !closely || refined == REFINEMENT => {
                return Ok(fate);
            }
            Some(_) => refined += 1,
            None => {}
        }
        integrator.expand(&mut step)?;
        integrator.advance(&step);
    }
    let [tau, p, ..] = *integrator.state();
    Ok(Fate::Undecided { tau, p })
}

/// What a state makes certain.
pub(super) struct Judgement {
    pub(super) fate: Fate,
    /// Whether place and time of a rest are known as well as wanted.
    close: bool,
}

/// The fate, if the state makes it certain.
pub(super) fn judge(&[tau, p, w, zeta]: &[f64; 4]) -> Option<Judgement> {
    let now = Start {
        p,
        xi: 1.0 - w,
        zeta,
    };
    let rho = now.rho();
    let certain = |fate| Some(Judgement { fate, close: true });
    let escape = |because| certain(Fate::Escape { tau, because });
    if p == 0.0 {
        return if rho <= 1.0 {
            certain(Fate::Rest {
                sigma: rho,
                tau,
                error: 0.0,
            })
        } else {
            escape(Escaping::Energy)
        };
    }
    if w <= 0.0 {
        return escape(Escaping::Outward);
    }
    if now.energy() >= 1.0 {
        return escape(Escaping::Energy);
    }
    if w < 1.0 && zeta <= -p && p > w {
        return escape(Escaping::Ahead);
    }
    let room = 1.0 - rho;
    if p >= room {
        return None;
    }
    let way = |w: f64| p * p / (w + libm::sqrt((w - p) * (w + p)));
    let least = if zeta <= -p && w < 1.0 {
        way(w)
    } else {
        0.5 * p * p / w
    };
    // Rounding may exchange the two.
    let most = way(room).max(least);
    // The deceleration is between w and room − most.
    let (soonest, latest) = (p / w, p / (room - most));
    // The resting place is not farther from this one than the way, and σ² is between bounds.
    let sigma = libm::sqrt((now.energy() + least + most).max(0.0)).min(1.0);
    let error = most.min((most - least) / (rho + sigma).max(most));
    Some(Judgement {
        fate: Fate::Rest {
            sigma,
            tau: tau + 0.5 * (soonest + latest),
            error,
        },
        close: error <= RADIUS && latest - soonest <= TIME,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_state_makes_certain_what_its_bounds_allow() {
        // For τ = 5, p = 0.1, η = 0.3: the ways in other words, p²/(w + √(w² − p²)) = w − √(w² − p²).
        let p = 0.1;
        for (xi, zeta, ahead) in [(0.1, -0.2, true), (-0.2, -0.2, false), (0.1, 0.05, false)] {
            let (w, eta): (f64, f64) = (1.0 - xi, p - zeta);
            let rho = libm::hypot(xi, eta);
            let slowest = libm::sqrt((1.0 - rho) * (1.0 - rho) - p * p);
            let most = 1.0 - rho - slowest;
            let least = if ahead {
                w - libm::sqrt(w * w - p * p)
            } else {
                p * p / (2.0 * w)
            };
            let Some(Judgement {
                fate: Fate::Rest { sigma, tau, error },
                close: false,
            }) = judge(&[5.0, p, w, zeta])
            else {
                panic!("{xi} {zeta}")
            };
            let expected = libm::sqrt(rho * rho - p * p + least + most);
            assert!((sigma - expected).abs() < 1e-15, "{sigma} {expected}");
            let time = 5.0 + 0.5 * (p / w + p / slowest);
            assert!((tau - time).abs() < 4e-15, "{tau} {time}");
            let half = (most - least) / (rho + sigma);
            assert!((error - half).abs() < 1e-15, "{error} {half}");
            // And the resting place is within the bounds.
            let Fate::Rest { sigma: exact, .. } = fate(&Start { p, xi, zeta }).unwrap() else {
                panic!("{xi} {zeta}")
            };
            assert!((sigma - exact).abs() <= error, "{sigma} {exact} {error}");
        }
    }

    #[test]
    fn a_speed_whose_square_is_lost_is_a_rest_on_the_spot() {
        let p = 2.2298285418344866e-162;
        let tiny = Start {
            p,
            xi: 0.0,
            zeta: p,
        };
        let Fate::Rest { sigma, tau, error } = fate(&tiny).unwrap() else {
            panic!("{tiny:?}")
        };
        assert!(
            sigma <= p && tau <= 2.0 * p && (0.0..=p).contains(&error),
            "{sigma} {tau} {error}"
        );
    }

    #[test]
    fn who_is_faster_than_friction_can_see_to_is_ahead() {
        // ξ = 0.8, ζ = −p = −0.3: ρ² − p² = 0.64 + 3·0.09 < 1, and p > w = 0.2.
        let because = |state| match judge(&state).map(|judgement| judgement.fate) {
            Some(Fate::Escape { because, .. }) => Some(because),
            _ => None,
        };
        assert_eq!(because([0.0, 0.3, 0.2, -0.3]), Some(Escaping::Ahead));
        // Not yet ahead: ζ > −p, or slower than w.
        assert_eq!(because([0.0, 0.3, 0.2, -0.29]), None);
        assert_eq!(because([0.0, 0.19, 0.2, -0.3]), None);
        assert_eq!(because([0.0, 0.3, 0.0, -0.3]), Some(Escaping::Outward));
        assert_eq!(because([0.0, 0.3, 0.2, -0.4]), Some(Escaping::Energy));
    }

    #[test]
    fn a_slow_approach_ends_the_search_with_wider_bounds() {
        // Outwards from close to ρ = 1: certain to rest, but where is not found as closely as elsewhere.
        for (psi, place) in [(0.0, 1.0 - 4.359e-6), (1.0, 1.0 - 7.208e-6)] {
            let start = Start::polar(1.0 - 1e-5, 9e-6, psi).unwrap();
            let Fate::Rest { sigma, error, .. } = fate(&start).unwrap() else {
                panic!("{psi}")
            };
            assert!(error > 1e-12 && error < 1e-9, "{error}");
            assert!((sigma - place).abs() < 1e-9, "{sigma}");
        }
    }
}
