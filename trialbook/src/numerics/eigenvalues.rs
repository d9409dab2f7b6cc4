//! The eigenvalues of a linearised motion, by `faer`: how fast small deviations grow or fall.

use super::error::NumericsError;
use faer::Mat;

/// The eigenvalues of a square matrix, real and imaginary part, in order of the former, then the latter.
///
/// # Errors
/// [`NumericsError::NotFinite`] for an entry that is not finite, with its row; [`NumericsError::Library`] where the iteration
/// does not converge.
pub fn eigenvalues<const N: usize>(matrix: [[f64; N]; N]) -> Result<[[f64; 2]; N], NumericsError> {
    for (i, row) in matrix.iter().enumerate() {
        if !row.iter().all(|x| x.is_finite()) {
            return Err(NumericsError::NotFinite {
                what: "a row of the matrix",
                at: i as f64,
            });
        }
    }
    let failed = |message: &str| NumericsError::Library {
        method: "eigenvalues",
        message: message.to_owned(),
    };
    let found = Mat::from_fn(N, N, |i, j| matrix[i][j]).eigenvalues();
    let found = found.map_err(|_| failed("the iteration does not converge"))?;
    let mut list = [[0.0; 2]; N];
    for (at, value) in list.iter_mut().zip(found) {
        *at = [value.re, value.im];
    }
    list.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    Ok(list)
}

/// The matrix ∂fᵢ/∂xⱼ of a map at a point, by central differences of the steps `h`, to the order h².
///
/// # Errors
/// Those of the map.
pub fn jacobian<const N: usize, E>(
    mut f: impl FnMut([f64; N]) -> Result<[f64; N], E>,
    at: [f64; N],
    h: [f64; N],
) -> Result<[[f64; N]; N], E> {
    let mut matrix = [[0.0; N]; N];
    for j in 0..N {
        let mut beside = |sign: f64| {
            let mut x = at;
            x[j] += sign * h[j];
            f(x)
        };
        let (above, below) = (beside(1.0)?, beside(-1.0)?);
        for i in 0..N {
            matrix[i][j] = (above[i] - below[i]) / (2.0 * h[j]);
        }
    }
    Ok(matrix)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_a_focus_and_a_decay() {
        // A turn at the rate 2 that grows at 1, turned into other axes, and a decay at 3.
        let found = eigenvalues([[3.0, -4.0, 1.0], [2.0, -1.0, 5.0], [0.0, 0.0, -3.0]]).unwrap();
        for (found, expected) in found.iter().zip([[-3.0, 0.0], [1.0, -2.0], [1.0, 2.0]]) {
            assert!((found[0] - expected[0]).abs() < 1e-13, "{found:?}");
            assert!((found[1] - expected[1]).abs() < 1e-13, "{found:?}");
        }
        assert!(eigenvalues([[f64::NAN]]).is_err());
    }

    #[test]
    fn derivatives_of_a_map() {
        let map = |[x, y]: [f64; 2]| Ok::<_, ()>([x * y, x * x * x]);
        let found = jacobian(map, [2.0, 3.0], [1e-3; 2]).unwrap();
        for (row, expected) in found.iter().zip([[3.0, 2.0], [12.0, 0.0]]) {
            assert!(
                (0..2).all(|j| (row[j] - expected[j]).abs() < 2e-6),
                "{found:?}"
            );
        }
    }
}
