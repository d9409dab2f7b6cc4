//! A root of one equation: the only one in a box, with as many bits as wanted.

use super::{ball::Ball, error::CertifiedError, interval::Interval};

/// In the first steps the box shrinks to what an f64 can say.
const FIRST: usize = 64;

/// Within these any box that shrinks at all reaches [`FIRST`] bits.
const STEPS: usize = 64;

/// The root of f in the box `start`, to `bits` bits after the point, by Newton's method with balls.
///
/// `f` gives the function and its derivative on a ball. N = m − f(m)/f′(X), m the middle of X, contains every
/// root of f in X; if it lies inside X, there is exactly one. Each further step doubles the bits that are
/// known.
///
/// # Errors
/// [`CertifiedError::NotProved`] if f′ has no sign on the box, or Newton's image of the box is not inside it.
pub fn refine(
    f: impl Fn(&Ball) -> Option<[Ball; 2]>,
    start: Interval,
    bits: usize,
) -> Result<Ball, CertifiedError> {
    let failed = |why| CertifiedError::unproved(why, &[start]);
    let image = |x: &Ball, bits: usize| -> Option<Ball> {
        let [_, slope] = f(x)?;
        let middle = x.middle().with_bits(bits);
        let [value, _] = f(&middle)?;
        Some(&middle - &value.over(&slope)?)
    };
    let mut x = Ball::enclosing(start, FIRST).ok_or_else(|| failed("the box is not finite"))?;
    let first = image(&x, FIRST).ok_or_else(|| failed("the derivative has no sign on the box"))?;
    if !first.inside(&x) {
        return Err(failed("the image of the box is not inside it"));
    }
    let narrower = |x: &Ball, bits| image(x, bits).ok_or_else(|| failed("a step has no value"));
    x = first;
    for _ in 0..STEPS {
        let next = narrower(&x, FIRST)?;
        if next.known_bits() <= x.known_bits() {
            break;
        }
        x = next;
    }
    // Each step doubles the bits, but for a few that the slope and rounding cost.
    let mut steps = vec![bits + 8];
    while let Some(&least) = steps.last().filter(|&&bits| bits + 8 > 2 * x.known_bits()) {
        if least / 2 + 8 >= least {
            break;
        }
        steps.push(least / 2 + 8);
    }
    for &bits in steps.iter().rev() {
        x = narrower(&x, bits)?;
    }
    // A small slope costs more than was reckoned with, in each step anew.
    while x.known_bits() < bits {
        let next = narrower(&x, bits + 8)?;
        if next.known_bits() <= x.known_bits() {
            break;
        }
        x = next;
    }
    if !x.interval().inside(start) {
        return Err(failed("the root may lie outside the box"));
    }
    Ok(x.with_bits(bits))
}

#[cfg(test)]
mod tests;
