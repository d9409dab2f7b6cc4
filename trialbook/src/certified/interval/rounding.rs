//! Directed rounding from round-to-nearest arithmetic: the true value lies between the neighbours of the
//! rounded one (IEEE 754). A result that is plainly exact stays.

pub(super) fn sum_down(a: f64, b: f64) -> f64 {
    let (s, rest) = two_sum(a, b);
    if rest >= 0.0 { s } else { s.next_down() }
}

pub(super) fn sum_up(a: f64, b: f64) -> f64 {
    let (s, rest) = two_sum(a, b);
    if rest <= 0.0 { s } else { s.next_up() }
}

/// Zero times an infinite bound is no number: behind that bound there may be no value.
pub(super) fn product_down(a: f64, b: f64) -> f64 {
    let p = a * b;
    if a == 0.0 || b == 0.0 || is_short_product(a, b, p) {
        p
    } else {
        p.next_down()
    }
}

pub(super) fn product_up(a: f64, b: f64) -> f64 {
    -product_down(-a, b)
}

/// For b > 0. A quotient by an infinite bound is a limit: zero is right for it.
pub(super) fn quotient_down(a: f64, b: f64) -> f64 {
    if a == 0.0 || b == f64::INFINITY {
        return 0.0;
    }
    let q = a / b;
    let back = q * b;
    if back == a && is_short_product(q, b, back) {
        q
    } else {
        q.next_down()
    }
}

/// For b > 0.
pub(super) fn quotient_up(a: f64, b: f64) -> f64 {
    -quotient_down(-a, b)
}

/// Below and above, for x ≥ 0.
pub(super) fn sqrt(x: f64) -> [f64; 2] {
    let r = x.sqrt();
    let back = r * r;
    let exact = x == 0.0 || x == f64::INFINITY || (back == x && is_short_product(r, r, back));
    if exact {
        [r; 2]
    } else {
        [r.next_down(), r.next_up()]
    }
}

/// The rest is no number where an infinity is involved.
fn two_sum(a: f64, b: f64) -> (f64, f64) {
    let s = a + b;
    let part = s - a;
    (s, (a - (s - part)) + (b - part))
}

/// a and b together have 53 bits at most, and p is far from the smallest and the largest f64.
fn is_short_product(a: f64, b: f64, p: f64) -> bool {
    let zeros = |x: f64| (x.to_bits() | 1 << 52).trailing_zeros();
    zeros(a) + zeros(b) >= 53 && (1e-200..1e200).contains(&p.abs())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_are_exact_up_to_53_bits_and_strictly_enclosed_beyond() {
        // Odd numbers, all of whose bits are ones.
        let ones = |bits: u32| (1_u64 << bits) - 1;
        for (a, b) in (1..=53).flat_map(|a| (1..=53).map(move |b| (a, b))) {
            let exact = u128::from(ones(a)) * u128::from(ones(b));
            let [m, n] = [a, b].map(|bits| ones(bits) as f64);
            let product = [product_down(m, n), product_up(m, n)];
            let [low, high] = product.map(|x| x as u128);
            if a + b <= 53 {
                assert_eq!([low, high], [exact; 2], "{a} {b}");
                let [p, _] = product;
                assert_eq!([quotient_down(p, n), quotient_up(p, n)], [m; 2], "{a} {b}");
                assert!(a != b || sqrt(p) == [m; 2], "{a}");
            } else if exact >= 1 << 53 {
                // An odd number of more bits is no f64.
                assert!(low < exact && exact < high, "{a} {b}");
            } else {
                assert!(low <= exact && exact <= high, "{a} {b}");
            }
        }
    }

    #[test]
    fn near_the_smallest_numbers_nothing_counts_as_exact() {
        // 2⁻¹⁰⁷⁴ is the last one: half of it is lost.
        let [small, half] = [libm::ldexp(1.0, -1074), 0.5];
        assert!(product_down(small, half) <= 0.0 && product_up(small, half) >= small);
        assert_eq!(quotient_up(small, 2.0), small);
    }
}
