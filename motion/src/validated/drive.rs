//! Numbers of the sinusoidal drive, from its arcs alone.
//!
//! A forward slip after a rest, which ends at φ₁ with sin φ₁ = λ₀, has by Newton's law the velocity w(φ) = cos φ₁ − cos φ − λ₀ (φ
//! − φ₁). Everything here is a zero of such an arc. Friction backwards is q times as large.

use crate::scalar::Scalar;
use trialbook::certified::{ball::Ball, error::CertifiedError, interval::Interval, root::refine};

/// For what follows a root, beyond the bits asked for.
const SPARE: usize = 16;

/// w at `to` after a rest that ended at `from`, for any kind of number; `lambda` is the friction sin `from`.
pub fn arc<S: Scalar>(from: S, to: S, lambda: S) -> S {
    from.cos() - to.cos() - lambda * (to - from)
}

fn valued(ball: Option<Ball>, bits: usize) -> Result<Ball, CertifiedError> {
    let none = || CertifiedError::unproved("an operation has no value", &[]);
    ball.map(|ball| ball.with_bits(bits)).ok_or_else(none)
}

/// The φ₁ of the critical friction: an arc from it ends half a period later, w(φ₁ + π) = 2 cos φ₁ − π sin φ₁ = 0.
pub(crate) fn critical_phase(bits: usize) -> Result<Ball, CertifiedError> {
    let pi = Ball::pi(bits + SPARE);
    let arc = |phi: &Ball| {
        let [s, c] = phi.sin_cos();
        let pi = pi.with_bits(phi.bits());
        Some([&c + &c - &pi * &s, -(&s + &s + &pi * &c)])
    };
    refine(arc, Interval::new(0.5, 0.6), bits)
}

/// The critical friction λ_c = sin φ₁, above which the large-time motion rests.
///
/// # Errors
/// As [`critical_phase`].
pub fn lambda_c(bits: usize) -> Result<Ball, CertifiedError> {
    let [sine, _] = critical_phase(bits + SPARE)?.sin_cos();
    Ok(sine.with_bits(bits))
}

/// Where the forward slip under the friction `lambda` ends: the only zero of its arc after φ₂ = π − φ₁ and before
/// 2π − φ₁, φ₁ = `phi1` = asin `lambda`. It is looked for within 1/100 of `near`.
///
/// # Errors
/// [`CertifiedError::NotProved`] if Newton's method does not prove it from that box.
pub fn slip_end(
    lambda: &Ball,
    phi1: &Ball,
    near: f64,
    bits: usize,
) -> Result<Ball, CertifiedError> {
    let [_, c1] = phi1.sin_cos();
    let arc = |phi: &Ball| {
        let [s, c] = phi.sin_cos();
        Some([&c1 - c - lambda * (phi - phi1), s - lambda])
    };
    refine(arc, Interval::point(near).widened(0.01), bits)
}

/// The length x of the arc whose end is at the drive's minimum, 3π/2, with λ₀ = 1/q: tan x = x, π < x < 3π/2.
///
/// With φ₁ = 3π/2 − x, λ₀ = −cos x and cos φ₁ = −sin x, and the arc ends where −sin x + x cos x = 0.
pub(crate) fn touching_length(bits: usize) -> Result<Ball, CertifiedError> {
    let arc = |x: &Ball| {
        let [s, c] = x.sin_cos();
        Some([x * c - &s, -(x * s)])
    };
    refine(arc, Interval::new(4.4, 4.6), bits)
}

/// The point Y as (q, λ₀), with q = √(1 + x²) = 1/λ₀.
///
/// # Errors
/// As [`touching_length`].
pub fn y(bits: usize) -> Result<[Ball; 2], CertifiedError> {
    let x = touching_length(bits + SPARE)?;
    let q = valued((Ball::int(1, x.bits()) + &x * &x).sqrt(), bits + SPARE)?;
    let lambda = valued(Ball::int(1, q.bits()).over(&q), bits)?;
    Ok([q.with_bits(bits), lambda])
}

/// How closely the border of direct reversals touches λ₀ = 1/q at Y: the distance over (q − q_Y)², to lowest order,
/// (q_Y − 1)/(2 q_Y³ (q_Y + 1)).
///
/// # Errors
/// As [`y`].
pub fn contact(bits: usize) -> Result<Ball, CertifiedError> {
    let [q, _] = y(bits + SPARE)?;
    let one = Ball::int(1, q.bits());
    let below = (&q + &q) * &q * &q * (&q + &one);
    valued((q - one).over(&below), bits)
}

/// λ₀ where a rest appears at this q. Over a period friction takes as much forward as backward, so that the forward motion
/// from φ₁ lasts D = 2πq/(q+1); it returns to zero, cos φ₁ − cos(φ₁ + D) = D sin φ₁.
///
/// # Errors
/// [`CertifiedError::NotProved`] for q ≤ 0.
pub fn rest_appears(q: &Ball, bits: usize) -> Result<Ball, CertifiedError> {
    let cotangent = || {
        (q.interval().lo() > 0.0).then_some(())?;
        let one = Ball::int(1, q.bits());
        let pi = Ball::pi(q.bits());
        let d = ((&pi + &pi) * q).over(&(q + &one))?;
        let [s, c] = d.sin_cos();
        let cot = (d - s).over(&(&one - &c))?;
        one.over(&(&one + &cot * &cot).sqrt()?)
    };
    valued(cotangent(), bits)
}

/// Where forward motion from a rest ends at the edge of the stretch in which the drive could pull backward.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Edge {
    /// At its beginning, π + asin(qλ₀): curve B.
    Beginning,
    /// At its end, 2π − asin(qλ₀): curve E.
    End,
}

/// λ₀ where direct reversals end at this q, by β = asin(qλ₀) within 1/100 of `near`.
pub(crate) fn reversals_end(
    edge: Edge,
    q: &Ball,
    near: f64,
    bits: usize,
) -> Result<Ball, CertifiedError> {
    let pi = Ball::pi(bits + 2 * SPARE);
    let arc = |beta: &Ball| {
        let [s, c] = beta.sin_cos();
        // λ₀ and its derivative by β.
        let (lambda, rate) = (s.over(q)?, c.over(q)?);
        let alpha = lambda.asin()?;
        let [_, cosine] = alpha.sin_cos();
        let pi = pi.with_bits(beta.bits());
        let way = match edge {
            Edge::Beginning => &pi + beta,
            Edge::End => &pi + &pi - beta,
        } - alpha;
        // The arc, and by β: its end moves with β, the friction with λ₀; the beginning does not matter.
        let lost = &lambda * &way;
        Some(match edge {
            Edge::Beginning => [cosine + c - lost, -(s + rate * way + lambda)],
            Edge::End => [cosine - c - lost, s + lambda - rate * way],
        })
    };
    let beta = refine(arc, Interval::point(near).widened(0.01), bits + SPARE)?;
    let [s, _] = beta.sin_cos();
    valued(s.over(q), bits)
}
