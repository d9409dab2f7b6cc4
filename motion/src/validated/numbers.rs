//! Numbers of the drive, each with as many certain digits as one asks for.

use super::drive::{self, Edge};
use trialbook::certified::{ball::Ball, enclosure::Enclosure, error::CertifiedError};

/// The critical friction.
pub const LAMBDA_C: Enclosure = Enclosure(drive::lambda_c);

/// The phase at which the slip begins at the critical friction.
pub const CRITICAL_PHASE: Enclosure = Enclosure(drive::critical_phase);

/// Where the forward slip ends at λ₀ = 1/√2.
pub const SLIP_END_FIG_4: Enclosure = Enclosure(|bits| {
    let half = Ball::ratio(1, 2, bits + 8).and_then(|half| half.sqrt());
    let lambda = half.ok_or_else(|| no_value(&Ball::int(2, 1)))?;
    let pi = Ball::pi(bits + 8);
    slip_end(&lambda, pi.over(&Ball::int(4, bits)), 3.197, bits)
});

/// Where the forward slip ends at λ₀ = 3/5.
pub const SLIP_END_3_5: Enclosure = Enclosure(|bits| slip_end_at(3, 5, 3.523, bits));

/// Where the forward slip ends at λ₀ = 9/10.
pub const SLIP_END_9_10: Enclosure = Enclosure(|bits| slip_end_at(9, 10, 2.482, bits));

/// The root of tan x = x between π and 3π/2: the forward motion at Y.
pub const X_Y: Enclosure = Enclosure(drive::touching_length);

/// The q of Y.
pub const Q_Y: Enclosure = Enclosure(|bits| drive::y(bits).map(|[q, _]| q));

/// The λ₀ of Y.
pub const LAMBDA_Y: Enclosure = Enclosure(|bits| drive::y(bits).map(|[_, lambda]| lambda));

/// B and E to C at Y: their distance over (q − q_Y)².
pub const CONTACT: Enclosure = Enclosure(drive::contact);

/// Curve A at q = 2.
pub const A_2: Enclosure = Enclosure(|bits| drive::rest_appears(&Ball::int(2, bits + 16), bits));

/// Curve A at q = 6.
pub const A_6: Enclosure = Enclosure(|bits| drive::rest_appears(&Ball::int(6, bits + 16), bits));

/// Curve A at q = 12.
pub const A_12: Enclosure = Enclosure(|bits| drive::rest_appears(&Ball::int(12, bits + 16), bits));

/// Curve B at q = 2.
pub const B_2: Enclosure = Enclosure(|bits| reversals_end(Edge::Beginning, 2, 0.951, bits));

/// Curve B at q = 3.
pub const B_3: Enclosure = Enclosure(|bits| reversals_end(Edge::Beginning, 3, 1.236, bits));

/// Curve E at q = 6.
pub const E_6: Enclosure = Enclosure(|bits| reversals_end(Edge::End, 6, 1.358, bits));

/// Curve E at q = 12.
pub const E_12: Enclosure = Enclosure(|bits| reversals_end(Edge::End, 12, 0.846, bits));

fn reversals_end(edge: Edge, q: i64, near: f64, bits: usize) -> Result<Ball, CertifiedError> {
    drive::reversals_end(edge, &Ball::int(q, bits + 32), near, bits)
}

fn no_value(of: &Ball) -> CertifiedError {
    CertifiedError::unproved("an operation has no value", &[of.interval()])
}

/// φ̃₂ at λ₀ = n/m.
fn slip_end_at(n: i64, m: i64, near: f64, bits: usize) -> Result<Ball, CertifiedError> {
    let lambda = Ball::ratio(n, m, bits + 16).ok_or_else(|| no_value(&Ball::int(m, 1)))?;
    let phi1 = lambda.asin();
    slip_end(&lambda, phi1, near, bits)
}

fn slip_end(
    lambda: &Ball,
    phi1: Option<Ball>,
    near: f64,
    bits: usize,
) -> Result<Ball, CertifiedError> {
    let phi1 = phi1.ok_or_else(|| no_value(lambda))?;
    drive::slip_end(lambda, &phi1, near, bits)
}
