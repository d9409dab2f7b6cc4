//! A set of starts carried without being boxed at each step: it turns and shears as the motions do.

use super::{Extended, GROW, Image, LONGEST, SHORTEST, SHRINK, image};
use crate::certified::{error::CertifiedError, interval::Interval};
use crate::numerics::taylor::System;
use std::array::from_fn;

type Matrix<T, const N: usize> = [[T; N]; 3];

/// The states c + C r + Q e with r in the square from −1 to 1 and e in a small box (Lohner, "Computation of
/// guaranteed enclosures for the solutions of ordinary initial and boundary value problems", 1992): the
/// derivative of the flow carries C along, Q e holds what this leaves out.
#[derive(Debug, Clone, Copy)]
pub struct Tilted {
    centre: [f64; 3],
    shape: Matrix<f64, 2>,
    axes: Matrix<f64, 3>,
    error: [Interval; 3],
}

impl Tilted {
    /// All values of a function on a box of two numbers: `middle` encloses its value in the middle, `slope`
    /// the derivatives on the whole box; `half` are half the widths, or more.
    pub fn new(middle: [Interval; 3], slope: Matrix<Interval, 2>, half: [f64; 2]) -> Self {
        let spread = slope.map(|row| from_fn(|j| row[j] * Interval::point(half[j])));
        let (centre, shape) = (middle.map(Interval::mid), middles(&spread));
        Tilted {
            centre,
            shape,
            axes: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            error: left_out(&middle, &centre, &spread, &shape),
        }
    }

    /// A box around all states.
    pub fn hull(&self) -> [Interval; 3] {
        from_fn(|i| {
            let straight = self.shape[i]
                .iter()
                .fold(Interval::point(self.centre[i]), |sum, x| {
                    sum + Interval::point(*x) * unit()
                });
            straight + dot(&self.axes[i].map(Interval::point), &self.error)
        })
    }

    /// The states after a step, by series of `N` terms, the last at most `accuracy` wide unless the step is
    /// short. `h` is the length to try first, and becomes the one to try next.
    ///
    /// # Errors
    /// [`CertifiedError::NotProved`] if no box is found that the motions do not leave.
    pub fn step<S, const N: usize>(
        &self,
        system: &S,
        h: &mut f64,
        accuracy: f64,
    ) -> Result<Self, CertifiedError>
    where
        S: System<Interval, 12, N> + System<Interval, 3, N>,
    {
        let hull = self.hull();
        let failed = |why| CertifiedError::unproved(why, &hull);
        *h = h.min(LONGEST);
        while *h > SHORTEST {
            let Some(Image { all, centre }) = image(system, &hull, self.centre, *h, accuracy)
            else {
                *h *= SHRINK;
                continue;
            };
            *h *= GROW;
            return self
                .carried(&all, &centre)
                .ok_or_else(|| failed("the axes are flat"));
        }
        Err(failed("no step encloses the motion"))
    }

    fn carried(&self, all: &Extended, middle: &[Interval; 3]) -> Option<Self> {
        let slope: Matrix<Interval, 3> = from_fn(|i| from_fn(|j| all[3 + 3 * i + j]));
        let spread = times(&slope, &points(&self.shape));
        let turned = times(&slope, &points(&self.axes));
        let (centre, shape) = (middle.map(Interval::mid), middles(&spread));
        let widths = self.error.map(Interval::width);
        let axes = upright(&middles(&turned).map(|row| from_fn(|k| row[k] * widths[k])));
        let back = inverse(&points(&axes))?;
        let (old, new) = (
            times(&back, &turned),
            left_out(middle, &centre, &spread, &shape),
        );
        Some(Tilted {
            centre,
            shape,
            axes,
            error: from_fn(|i| dot(&old[i], &self.error) + dot(&back[i], &new)),
        })
    }
}

fn unit() -> Interval {
    Interval::new(-1.0, 1.0)
}

fn points<const N: usize>(m: &Matrix<f64, N>) -> Matrix<Interval, N> {
    m.map(|row| row.map(Interval::point))
}

fn middles<const N: usize>(m: &Matrix<Interval, N>) -> Matrix<f64, N> {
    m.map(|row| row.map(Interval::mid))
}

fn left_out(
    middle: &[Interval; 3],
    centre: &[f64; 3],
    spread: &Matrix<Interval, 2>,
    shape: &Matrix<f64, 2>,
) -> [Interval; 3] {
    from_fn(|i| {
        let rows = spread[i].iter().zip(&shape[i]);
        rows.fold(middle[i] - Interval::point(centre[i]), |sum, (all, one)| {
            sum + (*all - Interval::point(*one)) * unit()
        })
    })
}

fn dot(a: &[Interval; 3], b: &[Interval; 3]) -> Interval {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn times<const N: usize>(a: &Matrix<Interval, 3>, b: &Matrix<Interval, N>) -> Matrix<Interval, N> {
    a.map(|row| from_fn(|j| dot(&row, &from_fn(|k| b[k][j]))))
}

/// Nearly at right angles, the longest column first (Gram and Schmidt). Columns that add nothing give way to
/// the axes.
fn upright(columns: &Matrix<f64, 3>) -> Matrix<f64, 3> {
    let dot = |a: &[f64; 3], b: &[f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let mut longest: [[f64; 3]; 3] = from_fn(|j| from_fn(|i| columns[i][j]));
    longest.sort_by(|a, b| dot(b, b).total_cmp(&dot(a, a)));
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let mut found: Vec<[f64; 3]> = Vec::with_capacity(3);
    for column in longest.into_iter().chain(axes) {
        let mut rest = column;
        // Twice, or rounding would show.
        for _ in 0..2 {
            for known in &found {
                let along = dot(known, &rest);
                rest = from_fn(|i| rest[i] - along * known[i]);
            }
        }
        let (left, length) = (dot(&rest, &rest).sqrt(), dot(&column, &column).sqrt());
        if found.len() < 3 && left > FLAT * length {
            found.push(rest.map(|x| x / left));
        }
    }
    from_fn(|i| from_fn(|j| found[j][i]))
}

/// A column adds nothing if this part of it, or less, is new.
const FLAT: f64 = 1e-6;

fn inverse(m: &Matrix<Interval, 3>) -> Option<Matrix<Interval, 3>> {
    let cofactor = |i: usize, j: usize| {
        let ([a, b], [c, d]) = ([i + 1, i + 2].map(|i| i % 3), [j + 1, j + 2].map(|j| j % 3));
        m[a][c] * m[b][d] - m[a][d] * m[b][c]
    };
    let determinant = dot(&m[0], &from_fn(|j| cofactor(0, j)));
    determinant.sign()?;
    Some(from_fn(|i| from_fn(|j| cofactor(j, i) / determinant)))
}

#[cfg(test)]
mod tests {
    use super::super::tests::Known;
    use super::*;
    use crate::scalar::Scalar;

    fn square(half: f64) -> Tilted {
        let [one, zero] = [1, 0].map(Interval::int);
        let slope = [[one, zero], [zero, one], [zero, zero]];
        Tilted::new([1.0, 0.0, 0.1].map(Interval::point), slope, [half; 2])
    }

    fn follow(mut set: Tilted, steps: usize) -> Tilted {
        let mut h = 0.5;
        for _ in 0..steps {
            set = set.step::<_, 12>(&Known, &mut h, 1e-10).unwrap();
        }
        set
    }

    /// A box would grow by a factor of up to 1.4 in each of these steps.
    #[test]
    fn a_square_turns_without_growing() {
        let set = follow(square(0.01), 12);
        let [x, y, z] = set.hull();
        // x′ = y, y′ = −x, z = 1/(10 − t).
        let t = Interval::int(10) - Interval::int(1) / z;
        let size = 0.02 * (t.cos().magnitude() + t.sin().magnitude());
        for (found, middle) in [(x, t.cos()), (y, -t.sin())] {
            assert!(found.meet(middle).is_some(), "{found} {middle}");
            assert!((found.width() / size - 1.0).abs() < 1e-4, "{found} {size}");
        }
    }

    #[test]
    fn each_motion_from_the_square_is_within() {
        let set = follow(square(0.1), 5);
        let hull = set.hull();
        let t = Interval::int(10) - Interval::int(1) / hull[2];
        let (cos, sin) = (t.cos(), t.sin());
        for (dx, dy) in [
            (0.1, 0.1),
            (-0.1, 0.1),
            (0.1, -0.1),
            (-0.1, -0.1),
            (0.03, -0.07),
        ] {
            let (x, y) = (Interval::point(1.0 + dx), Interval::point(dy));
            for (found, there) in [(hull[0], x * cos + y * sin), (hull[1], y * cos - x * sin)] {
                assert!(
                    there.mid() >= found.lo() && there.mid() <= found.hi(),
                    "{found} {there}"
                );
            }
        }
    }

    #[test]
    fn a_curved_start_is_enclosed() {
        let x = Interval::new(0.9, 1.1);
        let zero = Interval::int(0);
        let middle = Interval::point(1.0).squared();
        let slope = [[x + x, zero], [zero, Interval::int(1)], [zero, zero]];
        let set = Tilted::new(
            [middle, zero, Interval::point(0.1)],
            slope,
            [0.1 + 1e-16, 0.1],
        );
        let hull = set.hull()[0];
        assert!(
            hull.lo() <= 0.81 && hull.hi() >= 1.21 && hull.width() < 0.45,
            "{hull}"
        );
    }

    #[test]
    fn an_inverse_is_one() {
        let m = points(&[[2.0, 1.0, 0.5], [0.0, 3.0, -1.0], [1.0, 0.25, 4.0]]);
        let product = times(&inverse(&m).unwrap(), &m);
        for (i, row) in product.iter().enumerate() {
            for (j, x) in row.iter().enumerate() {
                let expected = if i == j { 1.0 } else { 0.0 };
                assert!(x.contains(expected) && x.width() < 1e-14, "{i} {j}: {x}");
            }
        }
        assert!(
            inverse(&points(&[
                [1.0, 2.0, 3.0],
                [2.0, 4.0, 6.0],
                [0.0, 0.0, 1.0]
            ]))
            .is_none()
        );
    }

    #[test]
    fn axes_are_at_right_angles_even_where_columns_are_none() {
        for columns in [
            [[1.0, 1.0, 0.0], [0.0, 1e-9, 0.0], [0.0, 0.0, 0.0]],
            [[0.0; 3]; 3],
            [[3.0, 1.0, 2.0], [0.0, 1.0, 5.0], [1.0, -1.0, 0.5]],
        ] {
            let axes = upright(&columns);
            for i in 0..3 {
                for j in 0..3 {
                    let dot: f64 = (0..3).map(|k| axes[k][i] * axes[k][j]).sum();
                    let expected = if i == j { 1.0 } else { 0.0 };
                    assert!((dot - expected).abs() < 1e-12, "{columns:?}");
                }
            }
        }
    }
}
