//! Directed rounding from round-to-nearest arithmetic, by the exact error of each operation.
//!
//! IEEE 754 rounds +, −, ×, ÷ and √ correctly. The error of each is itself a number that can be computed (Knuth's
//! two-sum; Veltkamp's and Dekker's product), and its sign says on which side of the result the true value lies. So
//! a bound moves by one place, or not at all where the operation is exact. Where a product may over- or underflow
//! on the way, both bounds move.

/// Below and above a + b, neither closer than the neighbouring number.
pub(super) fn sum(a: f64, b: f64) -> [f64; 2] {
    let s = a + b;
    let part = s - a;
    around(s, (a - (s - part)) + (b - part))
}

/// Below and above a · b. An infinite bound times zero is zero: zero times any number is.
pub(super) fn product(a: f64, b: f64) -> [f64; 2] {
    if a == 0.0 || b == 0.0 {
        return [0.0; 2];
    }
    let p = a * b;
    around(p, product_error(a, b, p))
}

/// Below and above a / b, for b ≠ 0.
pub(super) fn quotient(a: f64, b: f64) -> [f64; 2] {
    if a == 0.0 || b.is_infinite() {
        // A quotient by an infinite bound is a limit: zero is right for it.
        return [0.0; 2];
    }
    let q = a / b;
    let p = q * b;
    let rest = (a - p) - product_error(q, b, p);
    around(q, if b > 0.0 { rest } else { -rest })
}

/// Below and above √x, for x ≥ 0.
pub(super) fn sqrt(x: f64) -> [f64; 2] {
    let r = x.sqrt();
    if x == 0.0 || x.is_infinite() {
        return [r; 2];
    }
    let p = r * r;
    around(r, (x - p) - product_error(r, r, p))
}

/// The bounds of a number that was rounded to `x` and lies on the side of the sign of `error`; both, if that is
/// not a number.
fn around(x: f64, error: f64) -> [f64; 2] {
    let down = if error >= 0.0 { x } else { x.next_down() };
    let up = if error <= 0.0 { x } else { x.next_up() };
    [down, up]
}

/// a·b − p exactly, where p is a·b rounded; NaN where that cannot be promised.
fn product_error(a: f64, b: f64, p: f64) -> f64 {
    const SAFE: std::ops::Range<f64> = 1e-140..1e140;
    if ![a, b, p].iter().all(|x| SAFE.contains(&x.abs())) {
        return f64::NAN;
    }
    let split = |x: f64| {
        let c = 134_217_729.0 * x;
        let high = c - (c - x);
        (high, x - high)
    };
    let ((a1, a2), (b1, b2)) = (split(a), split(b));
    ((a1 * b1 - p) + a1 * b2 + a2 * b1) + a2 * b2
}
