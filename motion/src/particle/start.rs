//! The first moments of a slide from rest.
//!
//! At rest there is no direction, and in the time s of a slide the start lies infinitely far back. In t the
//! motion is analytic: let χ be the direction of −A(t), v the speed and ϑ the direction of the velocity from
//! that of −A at the start. Newton's law along and across the velocity reads
//!
//! ```text
//! v′ = a_∥ cos ϑ + a_⊥ sin ϑ − μg,      v ϑ′ = a_⊥ cos ϑ − a_∥ sin ϑ,
//! ```
//!
//! with a_∥, a_⊥ the components of −A along and across its direction at the start. Written for σ = sin ϑ
//! (ϑ′ = σ′/cos ϑ), order k of the second equation contains σ_k with the factor a_∥(0) + k v′(0) > 0, and
//! otherwise what lower orders know.

use super::{
    super::creep::{pull, velocity},
    MotionError, Run,
    stick::Release,
};
use crate::numerics::{
    events::roots,
    series::{convolution, product, square},
    taylor::{Coefficients, TERMS, reach},
};

impl Run<'_> {
    pub(super) fn depart(&mut self, release: Release) -> Result<(), MotionError> {
        let local = self.local()?;
        let size = libm::hypot(local.a[0][0], local.a[1][0]);
        let (e, along, across) = pull(&local.a, size);
        let net = match release {
            Release::Smooth => self.holding - self.friction,
            Release::Sudden => size - self.friction,
        };
        let (speed, cosine, sine) = first_moments(&along, &across, net);
        let mut h = local
            .left
            .min(reach(&speed))
            .min(reach(&sine))
            .min(reach(&cosine));
        let mut landing = if h == local.left { local.landing } else { None };
        // Should it stop again, the slide proper has to lead there.
        if let Some(stop) = roots(&speed, h)?.first() {
            (h, landing) = (0.5 * stop.at, None);
        }
        self.arc(velocity(e, &speed, &cosine, &sine), h, landing);
        Ok(())
    }
}

/// With the cosine and sine of the direction from that of −A at the start, when the speed begins to grow with `net`.
fn first_moments(
    along: &Coefficients,
    across: &Coefficients,
    net: f64,
) -> (Coefficients, Coefficients, Coefficients) {
    let [mut v, mut c, mut s, mut turn] = [[0.0; TERMS]; 4];
    c[0] = 1.0;
    for k in 1..TERMS {
        v[k] = if k == 1 {
            net
        } else {
            (product(along, &c, k - 1) + product(across, &s, k - 1)) / k as f64
        };
        // turn = σ′/cos ϑ; its coefficient k − 1 is k σ_k and what is known of it:
        let known = -convolution(&c[1..k], &turn[..k - 1]);
        let push = convolution(&across[1..=k], &c[..k]) - convolution(&along[1..k], &s[1..k]);
        let drag = convolution(&v[2..=k], &turn[..k - 1]) + v[1] * known;
        s[k] = (push - drag) / (along[0] + k as f64 * net);
        turn[k - 1] = k as f64 * s[k] + known;
        c[k] = -0.5 * (square(&s, k) + convolution(&c[1..k], &c[1..k]));
    }
    (v, c, s)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_direction_of_a_start_is_one() {
        // A pull that turns at the rate 2 and one that grows in one direction and across: cos² + sin² = 1.
        let mut turning = [[0.0; TERMS]; 2];
        let mut c = 1.5;
        for k in 0..TERMS {
            turning[k % 2][k] = if k % 4 < 2 { c } else { -c };
            c *= 2.0 / (k + 1) as f64;
        }
        let mut growing = [[0.0; TERMS]; 2];
        (growing[0][0], growing[0][1], growing[1][1]) = (1.5, 0.3, 0.7);
        for [along, across] in [turning, growing] {
            for net in [0.0, 0.5] {
                let (_, cosine, sine) = first_moments(&along, &across, net);
                assert!(sine[1].abs() > 0.1, "{sine:?}");
                let size: f64 = sine.iter().fold(1.0, |size, c| size.max(c.abs()));
                for k in 1..TERMS {
                    let sum = square(&cosine, k) + square(&sine, k);
                    assert!(sum.abs() < 1e-14 * size * size, "{k} {sum}");
                }
            }
        }
    }

    /// The speed is t (t − 1)(t − 3)/10: it stops at t = 1, and the series serves beyond t = 3.
    #[test]
    fn of_two_stops_the_first_decides() {
        use super::super::run;
        use crate::{Plane, Signal, State};
        let pull = Signal::Polynomial(vec![0.5 + 0.3, -0.8, 0.3]);
        for e in [[1.0, 0.0], [0.0, -1.0], [0.6, 0.8]] {
            let plane = Plane::along(e.map(|c: f64| -c), pull.clone());
            let rest = State::moving([0.0; 2]);
            let motion = run(&plane, 0.5, rest, 4.0).unwrap();
            let stop = motion.first_stop().unwrap();
            assert!((stop - 1.0).abs() < 1e-12, "{e:?}: {stop}");
            for (t, way) in [
                (0.5, 0.1 * (0.0625 / 4.0 - 0.5 / 3.0 + 0.375)),
                (2.0, 0.5 / 12.0),
            ] {
                let State { x, .. } = motion.at(t).unwrap();
                let found = x[0] * e[0] + x[1] * e[1];
                assert!((found - way).abs() < 1e-13, "{e:?} {t}: {found} {way}");
            }
        }
    }
}
