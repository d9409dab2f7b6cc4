//! Newton's law in components along and across the velocity, on the dimensionless table.
//!
//! Let v̂ be the direction of the velocity relative to the table, n̂ = ẑ×v̂, p the speed, χ the angle of v̂ with an
//! axis fixed on the table, and ξ = ρ·v̂, η = ρ·n̂ the components of the position. Along v̂ act the centrifugal
//! force and friction, across it the centrifugal and the Coriolis force, 2p v̂×ẑ = −2p n̂:
//!
//! ```text
//! dp/dτ = ξ − 1,    p dχ/dτ = η − 2p
//! ```
//!
//! The unit vectors turn, v̂′ = χ′n̂ and n̂′ = −χ′v̂, so that ξ′ = p + χ′η, η′ = −χ′ξ. The velocity in the laboratory
//! is pv̂ + ẑ×ρ = (p − η)v̂ + ξn̂. Its component ζ = p − η serves better than η: after a long escape p and η are large
//! and nearly equal. With dτ = p ds and the deficit w = 1 − ξ, by which friction outweighs the pull,
//!
//! ```text
//! dp/ds = −pw,    dw/ds = −ζ²,    dζ/ds = −p − ζ + wζ,    dχ/ds = −p − ζ,    dτ/ds = p,    d(arc length)/ds = p²
//! ```
//!
//! Everything is a polynomial: rest (p = ζ = 0) and the axis (ρ = 0) are ordinary points.

use super::argument;
use crate::clock::Clocked;
use crate::error::MotionError;
use crate::numerics::{
    number::{Number, Real},
    series::{product, square},
    taylor::System,
};

/// A state on the dimensionless table, by components along and across the velocity.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Start {
    /// Speed p relative to the table, in units of μg/Ω.
    pub p: f64,
    /// ξ = ρ·v̂, in units of μg/Ω². At p = 0 the distance from the axis: a particle starts from rest straight away from it.
    pub xi: f64,
    /// p − ρ·(ẑ×v̂): component along v̂ of the velocity in the laboratory, in units of μg/Ω.
    pub zeta: f64,
}

/// Of lengths and speeds: high powers have to be numbers.
pub const LARGEST: f64 = 1e9;

fn size(name: &'static str, value: f64) -> Result<(), MotionError> {
    let allowed = (0.0..=LARGEST).contains(&value);
    argument(name, value, allowed, "between 0 and 1e9")
}

impl Start {
    /// A particle at distance `rho` from the axis with speed `p`; `psi` is the angle from the velocity to the
    /// position, counterclockwise, in radians (of no effect at ρ = 0 or p = 0).
    ///
    /// # Errors
    /// [`MotionError::Argument`] for ρ or p outside [0, 10⁹], ψ not finite or beyond 10⁹.
    pub fn polar(rho: f64, p: f64, psi: f64) -> Result<Self, MotionError> {
        size("rho", rho)?;
        size("p", p)?;
        argument(
            "psi",
            psi,
            psi.abs() <= LARGEST,
            "finite, at most 1e9 in absolute value",
        )?;
        if p == 0.0 {
            return Ok(Self {
                p,
                xi: rho,
                zeta: 0.0,
            });
        }
        let (s, c) = libm::sincos(psi);
        Ok(Self {
            p,
            xi: rho * c,
            zeta: p - rho * s,
        })
    }

    /// p = A sinh α, ρ = A cosh α: a state with p < ρ by A = √(ρ² − p²) and artanh(p/ρ).
    ///
    /// # Errors
    /// [`MotionError::Argument`] for A or α negative or not finite, and as for [`polar`](Self::polar).
    pub fn hyperbolic(a: f64, alpha: f64, psi: f64) -> Result<Self, MotionError> {
        size("A", a)?;
        size("alpha", alpha)?;
        Self::polar(a * libm::cosh(alpha), a * libm::sinh(alpha), psi)
    }

    /// A position and a velocity relative to the table, in its axes.
    ///
    /// # Errors
    /// [`MotionError::Argument`] for |ρ| or p above 10⁹ or not finite.
    pub fn cartesian(position: [f64; 2], velocity: [f64; 2]) -> Result<Self, MotionError> {
        let [x, y] = position;
        let [u, v] = velocity;
        let (rho, p) = (libm::hypot(x, y), libm::hypot(u, v));
        size("rho", rho)?;
        size("p", p)?;
        if p == 0.0 {
            return Ok(Self {
                p,
                xi: rho,
                zeta: 0.0,
            });
        }
        let (cosine, sine) = (u / p, v / p);
        Ok(Self {
            p,
            xi: x * cosine + y * sine,
            zeta: p - (y * cosine - x * sine),
        })
    }

    /// A particle put down at distance `rho` from the axis with no velocity in the laboratory.
    ///
    /// # Errors
    /// [`MotionError::Argument`] for ρ outside [0, 10⁹].
    pub fn put_down(rho: f64) -> Result<Self, MotionError> {
        size("rho", rho)?;
        Ok(Self {
            p: rho,
            xi: 0.0,
            zeta: 0.0,
        })
    }

    /// A particle launched from the axis with the given speed.
    ///
    /// # Errors
    /// [`MotionError::Argument`] for a speed outside [0, 10⁹].
    pub fn launched(speed: f64) -> Result<Self, MotionError> {
        size("speed", speed)?;
        Ok(Self {
            p: speed,
            xi: 0.0,
            zeta: speed,
        })
    }

    /// Distance ρ from the axis.
    pub fn rho(&self) -> f64 {
        libm::hypot(self.xi, self.p - self.zeta)
    }

    /// ρ² − p², without cancellation late in an escape. Its derivative is 2(ξp − p(ξ − 1)) = 2p.
    pub fn energy(&self) -> f64 {
        self.xi * self.xi + self.zeta * (self.zeta - 2.0 * self.p)
    }
}

/// A start in numbers of any width, with the deficit w = 1 − ξ in place of ξ: close to rest at ρ = 1 all three are small.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Exact<T> {
    pub p: T,
    pub deficit: T,
    pub zeta: T,
}

impl<T: Real> From<&Start> for Exact<T> {
    fn from(start: &Start) -> Self {
        let [p, xi, zeta] = [start.p, start.xi, start.zeta].map(T::from_f64);
        Self {
            p,
            deficit: T::from_f64(1.0) - xi,
            zeta,
        }
    }
}

impl<T> Exact<T> {
    pub fn map<U>(self, f: impl Fn(T) -> U) -> Exact<U> {
        let [p, deficit, zeta] = [self.p, self.deficit, self.zeta].map(f);
        Exact { p, deficit, zeta }
    }
}

impl<T: Real> Exact<T> {
    /// As [`Start::polar`], where the numbers are in range.
    pub fn polar(rho: T, p: T, psi: T) -> Self {
        let [one, two, zero] = [1.0, 2.0, 0.0].map(T::from_f64);
        if p == zero {
            return Self {
                p,
                deficit: one - rho,
                zeta: zero,
            };
        }
        let ((sine, _), (half, _)) = (psi.sin_cos(), (psi / two).sin_cos());
        Self {
            p,
            deficit: (one - rho) + two * rho * half * half,
            zeta: p - rho * sine,
        }
    }

    /// As [`Start::cartesian`], where the numbers are in range.
    pub fn cartesian([x, y]: [T; 2], [u, v]: [T; 2]) -> Self {
        let p = (u * u + v * v).sqrt();
        let one = T::from_f64(1.0);
        if p == T::from_f64(0.0) {
            let rho = (x * x + y * y).sqrt();
            return Self::polar(rho, p, p);
        }
        Self {
            p,
            deficit: one - (x * u + y * v) / p,
            zeta: p - (y * u - x * v) / p,
        }
    }

    /// A start beside this one, by the part `delta` of its sizes, and by what rounding a place near ρ = 1 makes of 1 − ξ.
    pub fn beside(&self, delta: T) -> Self {
        let Self { p, deficit, zeta } = *self;
        let size = |x: T| T::from_f64(x.magnitude());
        Self {
            p: p + delta * p,
            deficit: deficit + delta * (size(deficit) + size(zeta)) + T::from_f64(T::ROUNDING),
            zeta: zeta + delta * (size(zeta) + p),
        }
    }
}

/// Coefficient `k` of the derivatives of τ, p, w, ζ.
#[inline(always)]
fn derivatives<T: Number>(k: usize, p: &[T], w: &[T], zeta: &[T]) -> [T; 4] {
    [
        p[k].clone(),
        -product(p, w, k),
        -square(zeta, k),
        product(w, zeta, k) - p[k].clone() - zeta[k].clone(),
    ]
}

/// The rates of p, w = 1 − ξ and ζ by the s of dτ = p ds, in which a rest lies at infinity. Dimensionless.
pub fn rates([p, w, zeta]: [f64; 3]) -> [f64; 3] {
    let [_, speed, deficit, forward] = derivatives(0, &[p], &[w], &[zeta]);
    [speed, deficit, forward]
}

pub(super) struct Law;

impl<T: Number, const N: usize> System<T, 4, N> for Law {
    type Work = ();

    fn begin(&self, _: &T, _: &[T; 4], (): &mut ()) {}

    #[inline(always)]
    fn derivative(&self, k: usize, x: &[[T; N]; 4], (): &mut ()) -> [T; 4] {
        derivatives(k, &x[1], &x[2], &x[3])
    }
}

pub(super) struct Tracked;

impl<T: Number, const N: usize> System<T, 6, N> for Tracked {
    type Work = ();

    fn begin(&self, _: &T, _: &[T; 6], (): &mut ()) {}

    #[inline(always)]
    fn derivative(&self, k: usize, x: &[[T; N]; 6], (): &mut ()) -> [T; 6] {
        let [_, p, w, zeta, _, _] = x;
        let [time, speed, deficit, forward] = derivatives(k, p, w, zeta);
        let turned = -p[k].clone() - zeta[k].clone();
        [time, speed, deficit, forward, turned, square(p, k)]
    }
}

/// A state on the way, everything dimensionless.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Intrinsic {
    /// Time.
    pub tau: f64,
    /// The state by components.
    pub parts: Start,
    /// w = 1 − ξ, friction less the centrifugal pull, without cancellation.
    pub deficit: f64,
    /// χ minus that at the start, in radians, counted through all turns.
    pub turned: f64,
    /// Arc length s on the table since the start.
    pub s: f64,
}

impl Intrinsic {
    fn new([tau, p, w, zeta, turned, s]: [f64; 6]) -> Self {
        Self {
            tau,
            parts: Start {
                p,
                xi: 1.0 - w,
                zeta,
            },
            deficit: w,
            turned,
            s,
        }
    }

    /// Speed p.
    pub fn p(&self) -> f64 {
        self.parts.p
    }

    /// Distance ρ from the axis.
    pub fn rho(&self) -> f64 {
        self.parts.rho()
    }

    /// Angle ψ from the velocity to the position, in (−π, π].
    pub fn psi(&self) -> f64 {
        libm::atan2(self.parts.p - self.parts.zeta, self.parts.xi)
    }

    /// π/2 − ψ, with all its digits where it is small; in (−π, π].
    pub fn lag(&self) -> f64 {
        libm::atan2(self.parts.xi, self.parts.p - self.parts.zeta)
    }

    /// A = √(ρ² − p²), or nothing if ρ < p.
    pub fn a(&self) -> Option<f64> {
        let energy = self.parts.energy();
        (energy >= 0.0).then(|| libm::sqrt(energy))
    }

    /// α with tanh α = p/ρ, or nothing unless ρ > p.
    pub fn alpha(&self) -> Option<f64> {
        let a = self.a().filter(|a| *a > 0.0)?;
        Some(libm::asinh(self.parts.p / a))
    }
}

/// The time and the way that are left are far below any rounding.
const STOP: f64 = 1e-30;

/// A run in these components, from τ = 0.
#[derive(Debug, Clone, PartialEq)]
pub struct Run {
    slide: Clocked<6>,
}

impl Run {
    /// Follows a particle to the time `until`, or to its stop. At the stop p is about 10⁻³⁰; the states on the way
    /// there keep their relative accuracy. A start with p = 0 is at its stop.
    ///
    /// # Errors
    /// [`MotionError::Argument`] for a time not finite or negative or a start that no constructor gives,
    /// [`MotionError::Steps`] after 200,000 steps, [`MotionError::Numerics`] for an escape so far out that high
    /// powers overflow (about τ = 10⁹).
    pub fn new(start: &Start, until: f64) -> Result<Self, MotionError> {
        let allowed = until.is_finite() && until >= 0.0;
        argument("until", until, allowed, "finite and not negative")?;
        check(start)?;
        let state = [0.0, start.p, 1.0 - start.xi, start.zeta, 0.0, 0.0];
        let slide = Clocked::run(&Tracked, state, until, super::rotating::STEPS, |x| {
            x[1] < STOP
        })?;
        Ok(Self { slide })
    }

    /// State at time `tau`: that at the nearer end for a time outside.
    ///
    /// # Errors
    /// [`MotionError::Numerics`] for a time that is not a number.
    pub fn at(&self, tau: f64) -> Result<Intrinsic, MotionError> {
        Ok(Intrinsic::new(self.slide.at(tau)?))
    }

    /// State at the end.
    pub fn end(&self) -> Intrinsic {
        Intrinsic::new(*self.slide.end())
    }

    /// At the ends of the integrator's steps. Near rest, where τ hardly changes, they are the ones to use.
    pub fn nodes(&self) -> impl Iterator<Item = Intrinsic> + '_ {
        self.slide.nodes().map(Intrinsic::new)
    }
}

pub(super) fn check(start: &Start) -> Result<(), MotionError> {
    size("p", start.p)?;
    for (name, value) in [("xi", start.xi), ("zeta", start.zeta)] {
        let allowed = value.abs() <= 2.0 * LARGEST;
        argument(
            name,
            value,
            allowed,
            "finite, at most 2e9 in absolute value",
        )?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_start_beside_one_at_the_corner_is_another() {
        let corner = Exact {
            p: 0.0,
            deficit: 0.0,
            zeta: 0.0,
        };
        let beside = corner.beside(1e-15);
        assert_eq!(
            beside.deficit,
            <f64 as crate::numerics::number::Real>::ROUNDING
        );
        let start = Exact {
            p: 1.0,
            deficit: -2.0,
            zeta: -0.5,
        };
        let Exact { p, deficit, zeta } = start.beside(1e-3);
        let moved = [p - 1.0, deficit + 2.0, zeta + 0.5];
        for (moved, expected) in moved.into_iter().zip([1e-3, 2.5e-3, 1.5e-3]) {
            assert!((moved - expected).abs() < 1e-15, "{moved}");
        }
    }
}
