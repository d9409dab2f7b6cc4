//! A common root of several equations, by Krawczyk's operator.

use super::{error::CertifiedError, interval::Interval, jet::Jet};

/// A box has shrunk as far as f64 allow by then.
const STEPS: usize = 20;

/// Proves that the two equations f = 0 have exactly one common root in the box X, and encloses it.
///
/// With m its middle and C about the inverse of the matrix of slopes, K = m − C f(m) + (1 − C f′(X)) (X − m)
/// contains every root in X; if it lies inside X, there is exactly one (Krawczyk 1969, Moore 1977).
///
/// # Errors
/// [`CertifiedError::NotProved`] if the slopes have no inverse in the middle, or the image is not inside the box.
pub fn unique(
    f: impl Fn([Jet<2>; 2]) -> [Jet<2>; 2],
    start: [Interval; 2],
) -> Result<[Interval; 2], CertifiedError> {
    let failed = |why| CertifiedError::unproved(why, &start);
    let image = |x: &[Interval; 2]| -> Option<[Interval; 2]> {
        let middle = x.map(|x| Interval::point(x.mid()));
        let values = f(middle.map(Jet::constant)).map(|jet| jet.value);
        let slopes = f(Jet::variables(x)).map(|jet| jet.slope);
        let c = inverse(slopes.map(|row| row.map(Interval::mid)))?;
        let k = |i: usize| {
            let mut k = middle[i];
            for j in 0..2 {
                k = k - c[i][j] * values[j];
                let product = c[i][0] * slopes[0][j] + c[i][1] * slopes[1][j];
                let unit = Interval::point(if i == j { 1.0 } else { 0.0 });
                k = k + (unit - product) * (x[j] - middle[j]);
            }
            k
        };
        Some([k(0), k(1)])
    };
    let no_inverse = || failed("the slopes have no inverse");
    let mut x = image(&start).ok_or_else(no_inverse)?;
    if !(x[0].inside(start[0]) && x[1].inside(start[1])) {
        return Err(failed("the image of the box is not inside it"));
    }
    for _ in 0..STEPS {
        let next = image(&x).ok_or_else(no_inverse)?;
        let [Some(a), Some(b)] = [0, 1].map(|i| x[i].meet(next[i])) else {
            return Err(failed("the image of the box misses it"));
        };
        if [a, b] == x {
            break;
        }
        x = [a, b];
    }
    Ok(x)
}

/// As point intervals; rounding does not matter.
fn inverse([[a, b], [c, d]]: [[f64; 2]; 2]) -> Option<[[Interval; 2]; 2]> {
    let det = a * d - b * c;
    let entries = [[d, -b], [-c, a]].map(|row| row.map(|x| x / det));
    let finite = entries.as_flattened().iter().all(|x| x.is_finite());
    finite.then(|| entries.map(|row| row.map(Interval::point)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::Scalar;

    fn curves([x, y]: [Jet<2>; 2]) -> [Jet<2>; 2] {
        [x.squared() + y.squared() - Jet::int(5), x * y - Jet::int(2)]
    }

    #[test]
    fn the_only_root_of_a_box_is_found() {
        let [x, y] = unique(curves, [Interval::new(1.9, 2.2), Interval::new(0.9, 1.2)]).unwrap();
        assert!(x.contains(2.0) && y.contains(1.0) && x.width() + y.width() < 1e-14);
    }

    #[test]
    fn no_root_or_two_give_no_proof() {
        for start in [
            [Interval::new(2.1, 2.3), Interval::new(0.9, 1.2)],
            [Interval::new(0.5, 2.5), Interval::new(0.5, 2.5)],
            [Interval::WHOLE; 2],
        ] {
            assert!(unique(curves, start).is_err());
        }
    }

    fn stretched(lo: f64, hi: f64, start: [Interval; 2]) -> Result<[Interval; 2], CertifiedError> {
        let factor = Jet::constant(Interval::new(lo, hi));
        unique(|xy| xy.map(|x| factor * x), start)
    }

    #[test]
    fn an_image_that_touches_the_box_proves_nothing() {
        let unit = Interval::new(-1.0, 1.0);
        // The image of [−1, 1] is 1 − [0, 2] times it: the box itself. Of 0 x all of the box are roots.
        assert!(stretched(0.0, 2.0, [unit; 2]).is_err());
        // Each slope alone: the image of the other coordinate lies inside.
        let number = |lo, hi| Jet::constant(Interval::new(lo, hi));
        for [a, b, c, d] in [
            [number(0.0, 2.0), Jet::int(0), Jet::int(0), Jet::int(1)],
            [Jet::int(1), number(-1.0, 1.0), Jet::int(0), Jet::int(1)],
            [Jet::int(1), Jet::int(0), number(-1.0, 1.0), Jet::int(1)],
            [Jet::int(1), Jet::int(0), Jet::int(0), number(0.0, 2.0)],
        ] {
            assert!(unique(|[x, y]| [a * x + b * y, c * x + d * y], [unit; 2]).is_err());
        }
        // A little less, and it lies inside.
        let least = 2.0_f64.powi(-40);
        let [x, y] = stretched(least, 2.0 - least, [unit; 2]).unwrap();
        assert!(x.contains(0.0) && y.contains(0.0) && x.inside(unit) && y.inside(unit));
    }

    #[test]
    fn an_image_has_to_lie_inside_on_each_side() {
        // x + c = 0 and y = 0 on [−1, 1]²: the image is [−c, −c], at an end for c = ±1, in either direction.
        let unit = Interval::new(-1.0, 1.0);
        for c in [-1, 1] {
            assert!(
                unique(|[x, y]| [x + Jet::int(c), y], [unit; 2]).is_err(),
                "{c}"
            );
            assert!(
                unique(|[x, y]| [x, y + Jet::int(c)], [unit; 2]).is_err(),
                "{c}"
            );
        }
        assert!(unique(|[x, y]| [x + Jet::int(1) / Jet::int(2), y], [unit; 2]).is_ok());
    }

    #[test]
    fn a_double_root_is_not_taken_for_one() {
        // (x − 1)² has its double root in the middle, at an end or off the middle of the box.
        let f = |[x, y]: [Jet<2>; 2]| [(x - Jet::int(1)).squared(), y];
        for [lo, hi] in [
            [0.0, 2.0],
            [1.0, 2.0],
            [0.0, 1.0],
            [0.5, 1.25],
            [0.999, 1.0001],
        ] {
            let start = [Interval::new(lo, hi), Interval::new(-1.0, 1.0)];
            assert!(unique(f, start).is_err(), "{lo} {hi}");
        }
    }
}
