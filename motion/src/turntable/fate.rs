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
//!   particle is followed until the bounds are close, near ρ = 1 by slower equations (`slow`).
//! - *Energy* (ρ² − p² ≥ 1, p > 0): never rests. ρ² − p² grows, and at rest it would be σ² ≤ 1.
//! - *Outward* (ξ ≥ 1, p > 0): never rests. ξ never decreases, so p does not decrease either.
//! - *Ahead* (0 < ξ < 1, ζ ≤ −p, p > w with w = 1 − ξ): never rests. At ζ = −p, (ζ + p)′ = −2pw < 0, so that ζ ≤ −p
//!   as long as w > 0. Then (p² − w²)′ = 2w(ζ² − p²) ≥ 0, so p² − w² stays above a positive number, and
//!   w′ = −ζ² ≤ −p² below a negative one: w becomes zero, which is the property before.
//!
//! Such a particle goes away for ever. If it stayed within bounds, ρ² − p² would converge and the way ∫p dτ be finite, so the
//! place would converge; there the pull would have to be balanced for good, which it is not: ρ > 1 there, or p does not decrease.
//! It may stop for a moment.

use super::{
    intrinsic::{Exact, Law, Start, check},
    slow::{Slow, Width},
};
use crate::error::MotionError;
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
        /// σ is known to this.
        error: f64,
        /// The time is known to this. The closer to the border of rest a motion comes, the more it makes of the rounding
        /// at its start: by h/(1 − σ)², where h is the speed at which it begins to slow down evenly.
        tau_error: f64,
    },
    /// It goes away for ever.
    Escape {
        /// Time by which this was certain.
        tau: f64,
        /// The property that made it so.
        because: Escaping,
    },
    /// Neither is certain: so close to the boundary that rounding decides.
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

/// A rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rest<T> {
    /// σ.
    pub sigma: T,
    /// 1 − σ, with the digits that σ does not show.
    pub gap: T,
    /// When, halfway between the bounds.
    pub tau: T,
    /// Half the distance of the bounds of σ,
    pub error: f64,
    /// and of those of the time.
    pub late: f64,
}

/// The speeds of a motion from which what is lost on it grows.
#[derive(Debug, Default, Clone, Copy, PartialEq)]
pub struct Speeds {
    /// The greatest.
    pub most: f64,
    /// That at which the slow equations began to serve.
    pub entry: Option<f64>,
}

impl<T: Width> Rest<T> {
    /// It grows on the last of the way, the more the closer to the border. A start, too, is rounded. Away from the brink an
    /// eighth is lost, as measured.
    pub fn errors(&self, lost: f64, Speeds { most, entry }: Speeds) -> [f64; 2] {
        let (tau, gap) = (self.tau.to_f64(), self.gap.to_f64());
        if tau == 0.0 {
            return [0.0; 2];
        }
        let (lost, entry) = entry.map_or((lost / 8.0, most), |entry| (lost, entry));
        let growth = entry.max(gap) / gap + 1.0;
        let rounded = T::ROUNDING * entry / (gap * gap);
        [
            self.error + lost * growth,
            self.late + lost * (tau + growth * most.min(1.0) / gap) + rounded,
        ]
    }
}

/// What a state makes certain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Certain<T> {
    Rest(Rest<T>),
    Escape { tau: T, because: Escaping },
}

/// How a motion ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Ending<T> {
    Certain(Certain<T>),
    Undecided { tau: T, p: T },
}

/// An ending, and what the speeds on the way were.
pub type Followed<T> = (Ending<T>, Speeds);

/// Steps after which a fate is undecided: ten times as many as any of 200,000 random starts took.
pub const STEPS: usize = 2_000;

/// The fastest number for steps that need no dense output.
const ORDER: usize = 24;

/// A place closer to the axis need not be known better.
const NOWHERE: f64 = 1e-30;

/// In units of the spacing of the numbers, with the rounding of the start.
const LOST: f64 = 64.0;

/// The fate of a particle: for 1 − σ above 10⁻³, σ to 10⁻¹² and τ to 10⁻⁹; closer to the border the answer says what is
/// known.
///
/// Cost: at most [`STEPS`] steps of the integrator, each of 24 terms.
///
/// # Errors
/// [`MotionError::Argument`] for a start that no constructor of [`Start`] gives, [`MotionError::Numerics`] when
/// numbers overflow.
pub fn fate(start: &Start) -> Result<Fate, MotionError> {
    check(start)?;
    let (ending, speeds) = follow::<f64, ORDER>(&Exact::from(start), true)?;
    Ok(match ending {
        Ending::Certain(Certain::Rest(rest)) => {
            let [error, tau_error] = rest.errors(LOST * f64::EPSILON, speeds);
            Fate::Rest {
                sigma: rest.sigma,
                tau: rest.tau,
                error,
                tau_error,
            }
        }
        Ending::Certain(Certain::Escape { tau, because }) => Fate::Escape { tau, because },
        Ending::Undecided { tau, p } => Fate::Undecided { tau, p },
    })
}

/// As [`fate()`], in cost too, but a rest is reported as soon as it is certain, without place and time.
///
/// # Errors
/// As for [`fate()`].
pub fn rests(start: &Start) -> Result<Option<bool>, MotionError> {
    check(start)?;
    let (ending, _) = follow::<f64, ORDER>(&Exact::from(start), false)?;
    Ok(ending.rests())
}

impl<T> Ending<T> {
    /// Whether it is a rest, where that is certain.
    pub fn rests(&self) -> Option<bool> {
        match self {
            Self::Certain(certain) => Some(matches!(certain, Certain::Rest(_))),
            Self::Undecided { .. } => None,
        }
    }
}

impl<T: Width> Ending<T> {
    /// The time reached, and the speed there where nothing is certain.
    pub fn reached(&self) -> (f64, f64) {
        match *self {
            Self::Certain(Certain::Rest(Rest { tau, .. }) | Certain::Escape { tau, .. }) => {
                (tau.to_f64(), 0.0)
            }
            Self::Undecided { tau, p } => (tau.to_f64(), p.to_f64()),
        }
    }
}

/// By series of `N` terms, until the fate is certain, and place and time of a rest are `closely` known.
pub fn follow<T: Width, const N: usize>(
    start: &Exact<T>,
    closely: bool,
) -> Result<Followed<T>, MotionError> {
    let zero = T::from_f64(0.0);
    let settled = |state: &[T; 4]| {
        let certain = judge(state)?;
        let open = closely && matches!(&certain, (Certain::Rest(_), close) if !close);
        (!open).then_some(Ending::Certain(certain.0))
    };
    let state = [zero, start.p, start.deficit, start.zeta];
    let mut fast = Integrator::<_, _, 4, N>::new(&Law, zero, state, Control::Each);
    let mut step = Step::empty();
    let (mut slow, mut speeds) = (None, Speeds::default());
    for _ in 0..STEPS {
        let &[tau, p, w, zeta] = fast.state();
        speeds.most = speeds.most.max(p.to_f64());
        if let Some(ending) = settled(&[tau, p, w, zeta]) {
            return Ok((ending, speeds));
        }
        if p.magnitude() < T::TUBE && w.magnitude() < T::TUBE {
            let law = slow.get_or_insert_with(Slow::new);
            if law.serves(p, w, zeta) {
                speeds.entry = Some(p.to_f64());
                let ending = follow_slowly::<T, N>(law, [tau, p, w], settled)?;
                return Ok((ending, speeds));
            }
        }
        fast.expand(&mut step)?;
        fast.advance(&step);
    }
    let [tau, p, ..] = *fast.state();
    Ok((Ending::Undecided { tau, p }, speeds))
}

fn follow_slowly<T: Width, const N: usize>(
    law: &Slow<T>,
    [tau, p, w]: [T; 3],
    settled: impl Fn(&[T; 4]) -> Option<Ending<T>>,
) -> Result<Ending<T>, MotionError> {
    let zero = T::from_f64(0.0);
    let mut slow = Integrator::<_, _, 5, N>::new(law, zero, [tau, p, w, zero, zero], Control::Each);
    let mut step = Step::empty();
    loop {
        let &[tau, p, w, ..] = slow.state();
        if let Some(ending) = settled(&[tau, p, w, law.zeta(p, w)]) {
            return Ok(ending);
        }
        // Friction and pull cannot be told apart any more.
        if p.magnitude() < T::ROUNDING {
            return Ok(Ending::Undecided { tau, p });
        }
        slow.expand(&mut step)?;
        slow.advance(&step);
    }
}

/// If certain, and whether place and time of a rest are known as well as wanted.
pub fn judge<T: Width>(&[tau, p, w, zeta]: &[T; 4]) -> Option<(Certain<T>, bool)> {
    let [zero, half, one, two] = [0.0, 0.5, 1.0, 2.0].map(T::from_f64);
    let (xi, eta) = (one - w, p - zeta);
    let energy = xi * xi + zeta * (zeta - two * p);
    // 1 − ρ² and 1 − (ρ² − p²), without cancellation near rest at ρ = 1.
    let inside = w * (two - w) - eta * eta;
    let spare = inside + p * p;
    let certain = |certain| Some((certain, true));
    let escape = |because| certain(Certain::Escape { tau, because });
    // σ² = ρ² − p² + 2S.
    let place = |way: T| {
        let gap = spare - way - way;
        let sigma = if energy < half {
            (energy + way + way).max(zero).sqrt()
        } else {
            (one - gap).max(zero).sqrt()
        };
        (sigma, gap / (one + sigma))
    };
    if p == zero {
        let (sigma, gap) = place(zero);
        return if inside >= zero {
            certain(Certain::Rest(Rest {
                sigma,
                gap,
                tau,
                error: 0.0,
                late: 0.0,
            }))
        } else {
            escape(Escaping::Energy)
        };
    }
    if w <= zero {
        return escape(Escaping::Outward);
    }
    if spare <= zero {
        return escape(Escaping::Energy);
    }
    if w < one && zeta <= -p && p > w {
        return escape(Escaping::Ahead);
    }
    let rho = (xi * xi + eta * eta).sqrt();
    let room = inside / (one + rho);
    if p >= room {
        return None;
    }
    let way = |w: T| p * p / (w + ((w - p) * (w + p)).sqrt());
    let least = if zeta <= -p && w < one {
        way(w)
    } else {
        half * p * p / w
    };
    // Rounding may exchange the two.
    let most = way(room).max(least);
    // The deceleration is between w and room − most.
    let (soonest, latest) = (p / w, p / (room - most));
    // Not farther from here than the way, and σ² is between bounds.
    let (sigma, gap) = place(half * (least + most));
    let error = most.min((most - least) / (rho + sigma).max(most)).to_f64();
    let close = error <= T::CLOSE * sigma.to_f64().max(NOWHERE)
        && (latest - soonest).to_f64() <= T::CLOSE * (tau + latest).to_f64();
    let rest = Rest {
        sigma,
        gap,
        tau: tau + half * (soonest + latest),
        error,
        late: 0.5 * (latest - soonest).to_f64(),
    };
    Some((Certain::Rest(rest), close))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::{double::Double, number::Number};

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
            let Some((
                Certain::Rest(Rest {
                    sigma,
                    tau,
                    error,
                    gap,
                    late,
                }),
                false,
            )) = judge(&[5.0, p, w, zeta])
            else {
                panic!("{xi} {zeta}")
            };
            assert!((sigma + gap - 1.0).abs() < 1e-15);
            assert!((late - 0.5 * (p / slowest - p / w)).abs() < 1e-15);
            let expected = libm::sqrt(rho * rho - p * p + least + most);
            assert!((sigma - expected).abs() < 1e-15, "{sigma} {expected}");
            let time = 5.0 + 0.5 * (p / w + p / slowest);
            assert!((tau - time).abs() < 4e-15, "{tau} {time}");
            let half = (most - least) / (rho + sigma);
            assert!((error - half).abs() < 1e-15, "{error} {half}");
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
        let Fate::Rest {
            sigma, tau, error, ..
        } = fate(&tiny).unwrap()
        else {
            panic!("{tiny:?}")
        };
        assert!(
            sigma <= p && tau <= 2.0 * p && (0.0..1e-12).contains(&error),
            "{sigma} {tau} {error}"
        );
    }

    #[test]
    fn who_is_faster_than_friction_can_see_to_is_ahead() {
        // ξ = 0.8, ζ = −p = −0.3: ρ² − p² = 0.64 + 3·0.09 < 1, and p > w = 0.2.
        let because = |state| match judge(&state) {
            Some((Certain::Escape { because, .. }, _)) => Some(because),
            _ => None,
        };
        assert_eq!(because([0.0, 0.3, 0.2, -0.3]), Some(Escaping::Ahead));
        assert_eq!(because([0.0, 0.3, 0.2, -0.29]), None);
        assert_eq!(because([0.0, 0.19, 0.2, -0.3]), None);
        assert_eq!(because([0.0, 0.3, 0.0, -0.3]), Some(Escaping::Outward));
        assert_eq!(because([0.0, 0.3, 0.2, -0.4]), Some(Escaping::Energy));
    }

    #[test]
    fn a_slow_approach_is_followed_to_its_end() {
        // By an implicit integration in ln p, 1 − ρ and ψ at forty digits.
        for (rho, p, sigma, tau) in [
            (0.9999, 1e-4, 0.9999988455574359, 5.154601306786737),
            (0.999999, 1e-6, 0.9999999988452771, 7.457041106957004),
        ] {
            let start = Start::polar(rho, p, 0.0).unwrap();
            let Fate::Rest {
                sigma: place,
                tau: time,
                error,
                tau_error,
            } = fate(&start).unwrap()
            else {
                panic!("{rho}")
            };
            assert!((place - sigma).abs() <= error && error < 2e-11, "{place}");
            assert!(
                (time - tau).abs() <= tau_error && (time - tau).abs() < 1e-9,
                "{time}"
            );
        }
    }

    /// In numbers of twice the width, what is lost is nothing beside this.
    #[test]
    fn place_and_time_are_known_as_closely_as_is_said() {
        let mut worst = [0.0_f64; 2];
        for psi in [0.0, 0.7, 1.4, 2.1, -0.7, -1.6] {
            for alpha in [0.1, 0.3, 0.9] {
                let a = crate::turntable::boundary(alpha, psi).unwrap();
                for k in 1..=12 {
                    let start =
                        Start::hyperbolic(a * (1.0 - libm::exp2(-f64::from(k))), alpha, psi);
                    let start = start.unwrap();
                    let (exact, _) = follow::<Double, 44>(&Exact::from(&start), true).unwrap();
                    let Ending::Certain(Certain::Rest(exact)) = exact else {
                        panic!("{start:?}")
                    };
                    let (near, speeds) = follow::<f64, ORDER>(&Exact::from(&start), true).unwrap();
                    let Ending::Certain(Certain::Rest(rest)) = near else {
                        panic!("{start:?}")
                    };
                    let stated = rest.errors(LOST * f64::EPSILON, speeds);
                    let off = [
                        exact.sigma - Double::from(rest.sigma),
                        exact.tau - Double::from(rest.tau),
                    ];
                    for i in 0..2 {
                        let share = off[i].magnitude() / stated[i];
                        assert!(share <= 1.0, "{start:?} {share}");
                        if speeds.entry.is_none() {
                            worst[i] = worst[i].max(share);
                        }
                    }
                }
            }
        }
        assert!(worst[1] > 0.2, "{worst:?}");
    }
}
