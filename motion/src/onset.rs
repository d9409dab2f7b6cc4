//! The first moments of sliding, from sliding speed zero.
//!
//! A contact that begins to slide has the velocity c = q(cos θ, sin θ) with
//!
//! ```text
//! dc/dt = f − L c/|c|:    dq/dt = f·û − L,    q dθ/dt = f·n̂,    û = (cos θ, sin θ), n̂ ⊥ û,
//! ```
//!
//! f being what drives it and L what friction can take away, per unit of mass. At the start q = 0, so that the
//! second law demands f·n̂ = 0: sliding starts along f. Both laws together give the power series of q and θ in t,
//! order by order: the term of order m of f·n̂ contains θₘ only in −|f₀| θₘ, that of q dθ/dt only in m q₁ θₘ.
use crate::numerics::{
    NumericsError, events,
    series::{product, sin_cos, value},
    taylor::{Coefficients, TERMS, reach},
};

/// A start from sliding speed zero.
#[derive(Debug, Clone, PartialEq)]
pub struct Onset {
    /// Coefficients of c about the start, in powers of the time since.
    pub velocity: [Coefficients; 2],
    /// Time for which they serve, in the unit of their powers.
    pub h: f64,
}

/// |f₀| − L below this part of L counts as zero: f outgrows friction at this very moment.
const THRESHOLD: f64 = 1e-12;

/// The start under a drive f whose coefficient m is `drive(m, c)`, from the coefficients of c up to m; `limit` is L. A series
/// that ends serves for the time `longest`, for which the drive's does. The drive at m = 0 must not be zero.
///
/// # Errors
/// [`NumericsError::NotFinite`] when a coefficient or the velocity is not.
pub fn onset(
    limit: f64,
    longest: f64,
    mut drive: impl FnMut(usize, &[Coefficients; 2]) -> [f64; 2],
) -> Result<Onset, NumericsError> {
    let zero = [0.0; TERMS];
    let mut velocity = [zero; 2];
    // f in axes along and across its first direction.
    let first = drive(0, &velocity);
    let size = libm::hypot(first[0], first[1]);
    let axis = [first[0] / size, first[1] / size];
    let [
        mut along,
        mut across,
        mut q,
        mut theta,
        mut sine,
        mut cosine,
    ] = [zero; 6];
    (along[0], cosine[0]) = (size, 1.0);
    for m in 1..TERMS {
        let pull = product(&along, &cosine, m - 1) + product(&across, &sine, m - 1);
        q[m] = (pull - if m == 1 { limit } else { 0.0 }) / m as f64;
        if m == 1 && q[1].abs() < THRESHOLD * limit {
            q[1] = 0.0;
        }
        let turned = [product(&q, &cosine, m), product(&q, &sine, m)];
        velocity[0][m] = axis[0] * turned[0] - axis[1] * turned[1];
        velocity[1][m] = axis[1] * turned[0] + axis[0] * turned[1];
        let f = drive(m, &velocity);
        along[m] = axis[0] * f[0] + axis[1] * f[1];
        across[m] = axis[0] * f[1] - axis[1] * f[0];
        // Of a fixed direction only rounding is left across it, which the recurrence would amplify.
        if across[m].abs() <= 4.0 * f64::EPSILON * libm::hypot(f[0], f[1]) {
            across[m] = 0.0;
        }
        // All but the terms with θₘ, which is still zero here.
        (sine[m], cosine[m]) = sin_cos(&theta, &sine, &cosine, m);
        let known = product(&across, &cosine, m) - product(&along, &sine, m);
        let turning: f64 = (2..=m)
            .map(|i| q[i] * (m - i + 1) as f64 * theta[m - i + 1])
            .sum();
        theta[m] = (known - turning) / (size + m as f64 * q[1]);
        (sine[m], cosine[m]) = sin_cos(&theta, &sine, &cosine, m);
    }
    let mut h = [&q, &theta, &along, &across]
        .map(|series| reach(series))
        .into_iter()
        .fold(f64::INFINITY, f64::min);
    if h == f64::INFINITY {
        // The series of an angle may end; that of its direction does not.
        h = reach(&sine).min(reach(&cosine)).min(longest);
    }
    if velocity.iter().flatten().any(|c| !c.is_finite()) || h.is_nan() {
        return Err(NumericsError::NotFinite {
            what: "a coefficient of the first moments of sliding",
            at: 0.0,
        });
    }
    if h.is_finite()
        && let Some(stop) = events::roots(&q, h)?.first()
    {
        h = 0.5 * stop.at;
    }
    let onset = Onset { velocity, h };
    if h.is_finite() && onset.at(h).iter().any(|c| !c.is_finite()) {
        return Err(NumericsError::NotFinite {
            what: "the first velocity of sliding",
            at: h,
        });
    }
    Ok(onset)
}

impl Onset {
    /// The velocity c at the time `elapsed` after the start.
    pub fn at(&self, elapsed: f64) -> [f64; 2] {
        [0, 1].map(|i| value(&self.velocity[i], &elapsed))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_steady_drive_speeds_up_by_what_friction_leaves() {
        // f = (3, −4) and L = 2: 3 along the unit vector (0.6, −0.8).
        let steady = |m: usize, _: &_| if m == 0 { [3.0, -4.0] } else { [0.0; 2] };
        let start = onset(2.0, f64::INFINITY, steady).unwrap();
        assert_eq!(start.h, f64::INFINITY);
        for t in [0.0, 0.5, 7.0] {
            let [x, y] = start.at(t);
            assert!((x - 1.8 * t).abs() < 1e-14 && (y + 2.4 * t).abs() < 1e-14);
        }
    }

    #[test]
    fn a_drive_that_is_no_number_is_named() {
        for bad in [f64::NAN, f64::INFINITY] {
            let drive = |m: usize, _: &_| match m {
                0 => [3.0, 0.0],
                5 => [bad, 0.0],
                _ => [0.0; 2],
            };
            let Err(NumericsError::NotFinite { what, .. }) = onset(2.0, 1.0, drive) else {
                panic!("{bad}")
            };
            assert!(what.contains("coefficient"), "{what}");
        }
    }

    #[test]
    fn units_change_no_bit_of_the_first_moments() {
        for excess in [0.0, 3e-13, 1e-10, 0.5] {
            let of = |unit: f64| {
                let drive = move |m: usize, _: &_| match m {
                    0 => [unit * (1.0 + excess), 0.0],
                    1 => [0.5 * unit, -0.25 * unit],
                    _ => [0.0; 2],
                };
                onset(unit, 10.0, drive).unwrap()
            };
            let one = of(1.0);
            for k in [-60, -20, 20, 60] {
                let unit = libm::ldexp(1.0, k);
                let other = of(unit);
                assert_eq!(other.velocity, one.velocity.map(|c| c.map(|c| unit * c)));
                assert_eq!(other.h, one.h, "{excess} {k}");
            }
            // Just above the threshold it begins with what is above it.
            if excess == 1e-10 {
                assert!((one.velocity[0][1] / excess - 1.0).abs() < 1e-5);
            }
        }
    }

    /// f = 6/5 − t and L = 1: q = t/5 − t²/2 stops at t = 2/5, and the slide proper has to lead there.
    #[test]
    fn first_moments_end_before_a_stop() {
        let drive = |m: usize, _: &_| match m {
            0 => [0.72, 0.96],
            1 => [-0.6, -0.8],
            _ => [0.0; 2],
        };
        for longest in [0.5, 1e3] {
            let start = onset(1.0, longest, drive).unwrap();
            let [x, y] = start.at(start.h);
            assert!(0.1 < start.h && start.h < 0.39, "{}", start.h);
            assert!(x > 0.0 && y > 0.0);
        }
        assert_eq!(onset(1.0, 0.3, drive).unwrap().h, 0.3);
        // Before the first: of q = t (t − 1)(t − 3)/10.
        let twice = |m: usize, _: &_| match m {
            0 => [0.6 * 1.3, 0.8 * 1.3],
            1 => [-0.6 * 0.8, -0.8 * 0.8],
            2 => [0.6 * 0.3, 0.8 * 0.3],
            _ => [0.0; 2],
        };
        for longest in [3.5, 1e3] {
            let start = onset(1.0, longest, twice).unwrap();
            assert!(0.1 < start.h && start.h < 0.99, "{}", start.h);
        }
    }
}
