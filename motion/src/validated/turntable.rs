//! Fates on the turntable, proved: a start comes to rest within certain radii, or goes away for ever.
//!
//! With the speed p, the position ξ along the velocity, w = 1 − ξ, and the component ζ along the velocity of the velocity in the
//! laboratory, ρ² = ξ² + (p − ζ)², and Newton's law in the time s with dτ = p ds is p′ = −p w, w′ = −ζ², ζ′ = −p − ζ + w ζ. p > 0
//! stays so. A state decides its fate, as [`fate`](mod@crate::turntable::fate) proves, if
//!
//! - p + ρ < 1: rest, after a way S ≤ p²/(r + √(r² − p²)) with r = 1 − ρ, and S ≥ p²/(2w), at σ² = ρ² − p² + 2S;
//! - ρ² − p² > 1, or w < 0, or ζ < −p and w < p: no rest.

mod strip;

pub use strip::{Margins, Strip};

use crate::numerics::{
    series::{product, square},
    taylor::System,
};
use crate::scalar::Scalar;
use trialbook::certified::{error::CertifiedError, flow::step, interval::Interval};

/// What becomes of a particle, proved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Fate {
    /// It comes to rest.
    Rest {
        /// At a distance from the axis in this interval (in units of μg/Ω²).
        sigma: Interval,
        /// Steps of validated integration that it took.
        steps: usize,
    },
    /// It goes away for ever.
    Escape {
        /// Steps of validated integration that it took.
        steps: usize,
    },
}

/// Steps after which the fate is not proved.
const STEPS: usize = 2000;

/// Of p, w, ζ and of their derivatives by the start.
struct Law;

impl<const N: usize> System<Interval, 3, N> for Law {
    type Work = ();

    fn begin(&self, _: &Interval, _: &[Interval; 3], (): &mut ()) {}

    fn derivative(
        &self,
        k: usize,
        [p, w, zeta]: &[[Interval; N]; 3],
        (): &mut (),
    ) -> [Interval; 3] {
        [
            -product(p, w, k),
            -square(zeta, k),
            product(w, zeta, k) - p[k] - zeta[k],
        ]
    }
}

impl<const N: usize> System<Interval, 12, N> for Law {
    type Work = ();

    fn begin(&self, _: &Interval, _: &[Interval; 12], (): &mut ()) {}

    fn derivative(&self, k: usize, x: &[[Interval; N]; 12], (): &mut ()) -> [Interval; 12] {
        let [p, w, zeta, ..] = x;
        let mut slope = [Interval::point(0.0); 12];
        slope[..3].copy_from_slice(&[
            -product(p, w, k),
            -square(zeta, k),
            product(w, zeta, k) - p[k] - zeta[k],
        ]);
        for j in 0..3 {
            // Derivatives by the start: of p, of w, of ζ.
            let [dp, dw, dzeta] = [3 + j, 6 + j, 9 + j].map(|i| &x[i]);
            let turn = product(zeta, dzeta, k);
            slope[3 + j] = -(product(dp, w, k) + product(p, dw, k));
            slope[6 + j] = -(turn + turn);
            slope[9 + j] = product(dw, zeta, k) + product(w, dzeta, k) - dp[k] - dzeta[k];
        }
        slope
    }
}

/// The fate of a particle with p = A sinh α, ρ = A cosh α, and the angle ψ from its velocity to its position. The
/// radius at rest is enclosed to within `width`, or as well as can be.
///
/// # Errors
/// [`CertifiedError::NotProved`] if the steps do not settle it: a start too close to the boundary, or too wide.
pub fn fate(start: [Interval; 3], width: f64) -> Result<Fate, CertifiedError> {
    let [a, alpha, psi] = start;
    let (p, rho) = (a * alpha.sinh(), a * alpha.cosh());
    follow(
        [p, Interval::int(1) - rho * psi.cos(), p - rho * psi.sin()],
        width,
    )
}

/// The fate of a particle put down at rest in the laboratory at the distance `r` from the axis, with the
/// radius at rest as for [`fate`].
///
/// # Errors
/// As [`fate`].
pub fn fate_put_down(r: Interval, width: f64) -> Result<Fate, CertifiedError> {
    // Against the table it moves across the radius with the speed r.
    follow([r, Interval::int(1), Interval::int(0)], width)
}

/// The fate of a particle launched from the axis with the speed `u`, with the radius at rest as for [`fate`].
///
/// # Errors
/// As [`fate`].
pub fn fate_launched(u: Interval, width: f64) -> Result<Fate, CertifiedError> {
    follow([u, Interval::int(1), u], width)
}

fn follow(start: [Interval; 3], width: f64) -> Result<Fate, CertifiedError> {
    let mut state = start;
    let (mut rest, mut h) = (None, 1.0);
    let resting = |sigma, steps| Fate::Rest { sigma, steps };
    for steps in 0..STEPS {
        match judge(&state) {
            Some(Judged::Escape) => return Ok(Fate::Escape { steps }),
            Some(Judged::Rest(sigma)) => {
                let closer = rest.map_or(Some(sigma), |known| sigma.meet(known));
                let sigma = closer.ok_or_else(|| unsettled(&state))?;
                if sigma.width() <= width || rest == Some(sigma) {
                    return Ok(resting(sigma, steps));
                }
                rest = Some(sigma);
            }
            None => {}
        }
        state = match (step(&Law, &state, &mut h), rest) {
            (Ok(state), _) => state,
            (Err(_), Some(sigma)) => return Ok(resting(sigma, steps)),
            (Err(error), None) => return Err(error),
        };
    }
    let known = rest.map(|sigma| resting(sigma, STEPS));
    known.ok_or_else(|| unsettled(&start))
}

fn unsettled(state: &[Interval]) -> CertifiedError {
    CertifiedError::unproved("the integration does not settle the fate", state)
}

enum Judged {
    Rest(Interval),
    Escape,
}

/// Nothing unless p is positive.
fn judge(&[p, w, zeta]: &[Interval; 3]) -> Option<Judged> {
    if p.sign() != Some(1.0) {
        return None;
    }
    let one = Interval::int(1);
    let xi = one - w;
    let energy = xi.squared() + zeta * (zeta - p - p);
    let ahead = zeta.below(-p) && w.below(p);
    if w.sign() == Some(-1.0) || one.below(energy) || ahead {
        return Some(Judged::Escape);
    }
    let rho = (xi.squared() + (p - zeta).squared()).sqrt();
    let room = one - rho;
    if !p.below(room) {
        return None;
    }
    let least = p.squared() / (w + w);
    let most = p.squared() / (room + (room.squared() - p.squared()).sqrt());
    let way = least.hull(most);
    let square = energy + way + way;
    let possible = square.meet(Interval::new(0.0, 1.0))?;
    Some(Judged::Rest(possible.sqrt()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn from(start: [f64; 3]) -> Result<Fate, CertifiedError> {
        fate(start.map(Interval::point), 1e-6)
    }

    #[test]
    fn fates_are_proved() {
        for start in [[0.88, 0.1, 0.2], [0.9, 0.1, -2.0], [0.5, 0.3, 3.0]] {
            let Ok(Fate::Rest { sigma, .. }) = from(start) else {
                panic!("{start:?}");
            };
            assert!(sigma.width() <= 1e-6, "{sigma}");
        }
        for start in [[0.5, 2.5, 2.0], [0.95, 0.3, 0.2], [1.1, 3.0, 1.0]] {
            assert!(matches!(from(start), Ok(Fate::Escape { .. })), "{start:?}");
        }
    }

    #[test]
    fn what_is_not_certain_is_not_said() {
        let [alpha, psi] = [0.1, 0.2].map(Interval::point);
        assert!(fate([Interval::new(0.8, 1.2), alpha, psi], 1e-6).is_err());
        assert!(fate([Interval::WHOLE, alpha, psi], 1e-6).is_err());
        // At rest from the beginning: nothing is said of p = 0.
        assert!(fate([0.5, 0.0, 0.2].map(Interval::point), 1e-6).is_err());
    }

    fn rates(state: [f64; 12]) -> [f64; 12] {
        let series: [[_; 1]; 12] = state.map(|x| [Interval::point(x)]);
        Law.derivative(0, &series, &mut ()).map(Interval::mid)
    }

    #[test]
    fn the_law_is_that_of_the_table() {
        let mut state = [0.0; 12];
        state[..3].copy_from_slice(&[0.7, 0.4, -0.3]);
        let [p, w, zeta, ..] = rates(state);
        assert!(
            (p + 0.28).abs() < 1e-15 && (w + 0.09).abs() < 1e-15 && (zeta + 0.52).abs() < 1e-15
        );
    }

    #[test]
    fn the_derivatives_by_the_start_grow_as_differences_of_motions_do() {
        let state = [
            0.7, 0.4, -0.3, 1.3, -0.2, 0.9, 0.5, 1.7, -0.6, 2.1, 0.8, -1.1,
        ];
        let found = rates(state);
        for j in 0..3 {
            // The law is of the second degree: difference quotients are derivatives.
            let beside = |sign: f64| {
                let mut state = state;
                for i in 0..3 {
                    state[i] += sign * state[3 + 3 * i + j];
                }
                rates(state)
            };
            let (after, before) = (beside(1.0), beside(-1.0));
            for i in 0..3 {
                let expected = 0.5 * (after[i] - before[i]);
                let found = found[3 + 3 * i + j];
                assert!(
                    (found - expected).abs() < 1e-14,
                    "{i} {j}: {found} {expected}"
                );
            }
        }
    }

    #[test]
    fn each_sign_of_escape_is_enough() {
        let judged = |state: [f64; 3]| judge(&state.map(Interval::point));
        // Each sign alone: w < 0; ρ² − p² > 1; ζ < −p and w < p.
        for state in [[1.0, -0.1, 1.0], [0.1, 0.5, -1.0], [0.4, 0.3, -0.41]] {
            assert!(matches!(judged(state), Some(Judged::Escape)), "{state:?}");
        }
        // One part of the last sign without the other.
        for state in [[0.2, 0.5, -0.3], [0.4, 0.3, -0.39]] {
            assert!(!matches!(judged(state), Some(Judged::Escape)), "{state:?}");
        }
        assert!(matches!(judged([0.1, 0.9, 0.1]), Some(Judged::Rest(_))));
    }
}
