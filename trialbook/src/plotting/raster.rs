//! Region diagrams and censuses: a rectangle of equal cells, each of one class..

use super::FigureError;
use super::svg::Colour;

/// A cell that is not drawn.
pub const BLANK: u8 = u8::MAX;

#[derive(Debug, Clone, PartialEq)]
pub(super) struct Class {
    pub label: String,
    pub colour: Colour,
    pub opacity: f64,
}

/// Equal cells that fill a rectangle.
#[derive(Debug, Clone, PartialEq)]
pub struct Raster {
    pub(super) x: (f64, f64),
    pub(super) y: (f64, f64),
    columns: usize,
    rows: usize,
    cells: Vec<u8>,
    pub(super) classes: Vec<Class>,
}

impl Raster {
    /// Cells row by row from the lowest y, each row from the lowest x, over `x` = (from, to) and `y` = (from,
    /// to). A cell is the number of its class or [`BLANK`]. On a logarithmic axis cells are equally wide in
    /// the logarithm. What lies beyond the panel's axes is cut off. [`FigureError::RasterShape`] if the cells
    /// do not fill `columns` × `rows`, [`FigureError::Range`] if an edge is not finite or from ≥ to.
    pub fn new(
        columns: usize,
        rows: usize,
        x: (f64, f64),
        y: (f64, f64),
        cells: Vec<u8>,
    ) -> Result<Self, FigureError> {
        if columns == 0 || rows == 0 || columns.checked_mul(rows) != Some(cells.len()) {
            return Err(FigureError::RasterShape {
                columns,
                rows,
                cells: cells.len(),
            });
        }
        for (name, (from, to)) in [("x of a raster", x), ("y of a raster", y)] {
            if !(from.is_finite() && to.is_finite() && from < to) {
                return Err(FigureError::Range {
                    axis: name.into(),
                    from,
                    to,
                });
            }
        }
        Ok(Raster {
            x,
            y,
            columns,
            rows,
            cells,
            classes: Vec::new(),
        })
    }

    /// Describes the next class, from class 0 on: a label (inside the class if there is room, else in the
    /// key), the colour of series `n`, the opacity from 0 to 1.
    pub fn class(self, label: impl Into<String>, n: usize, opacity: f64) -> Self {
        self.described(label.into(), Colour::Series(n), opacity)
    }

    /// The same in the page's text colour.
    pub fn ink_class(self, label: impl Into<String>, opacity: f64) -> Self {
        self.described(label.into(), Colour::Ink, opacity)
    }

    fn described(mut self, label: String, colour: Colour, opacity: f64) -> Self {
        self.classes.push(Class {
            label,
            colour,
            opacity,
        });
        self
    }

    /// How many cells each described class has.
    pub fn counts(&self) -> Vec<usize> {
        let mut counts = vec![0; self.classes.len()];
        for &cell in &self.cells {
            if let Some(count) = counts.get_mut(usize::from(cell)) {
                *count += 1;
            }
        }
        counts
    }

    pub(super) fn shape(&self) -> (usize, usize) {
        (self.columns, self.rows)
    }

    pub(super) fn check(&self) -> Result<(), FigureError> {
        let classes = self.classes.len();
        let unknown = |cell: &&u8| **cell != BLANK && usize::from(**cell) >= classes;
        match self.cells.iter().find(unknown) {
            Some(&class) => Err(FigureError::RasterClass { classes, class }),
            None => Ok(()),
        }
    }

    pub(super) fn class_at(&self, column: i64, row: i64) -> Option<usize> {
        let (column, row) = (usize::try_from(column).ok()?, usize::try_from(row).ok()?);
        let known = column < self.columns && row < self.rows;
        known.then(|| usize::from(self.cells[row * self.columns + column]))
    }

    fn is(&self, class: u8, column: usize, row: usize) -> bool {
        column < self.columns && row < self.rows && self.cells[row * self.columns + column] == class
    }

    /// In units of cells from the lower left corner, for the even-odd rule. At every corner an even number of
    /// edges meet, so a walk that uses each edge once ends where it began.
    pub(super) fn outline(&self, class: u8) -> String {
        let (w, h) = (self.columns + 1, self.rows + 1);
        let mut level = vec![false; w * h]; // from corner (i, j) to (i + 1, j)
        let mut upright = vec![false; w * h]; // from corner (i, j) to (i, j + 1)
        for j in 0..h {
            for i in 0..w {
                let here = self.is(class, i, j);
                level[j * w + i] = here != (j > 0 && self.is(class, i, j - 1));
                upright[j * w + i] = here != (i > 0 && self.is(class, i - 1, j));
            }
        }
        let mut out = String::new();
        for start in 0..w * h {
            while level[start] {
                let walk = walk(&mut level, &mut upright, w, start);
                out += &format!("M{} {}{walk}z", start % w, start / w);
            }
        }
        out
    }

    /// Lower left corner and side, in cells; of several the one nearest to the middle of the class.
    pub(super) fn largest_square(&self, class: u8) -> Option<(usize, usize, usize)> {
        let (mut count, mut middle) = (0.0f64, [0.0f64; 2]);
        for k in (0..self.cells.len()).filter(|&k| self.cells[k] == class) {
            count += 1.0;
            middle[0] += (k % self.columns) as f64 + 0.5;
            middle[1] += (k / self.columns) as f64 + 0.5;
        }
        let mut side = vec![0usize; self.columns];
        let mut best = ((0, f64::INFINITY), (0, 0));
        for row in 0..self.rows {
            let mut diagonal = 0;
            for column in 0..self.columns {
                let above = side[column];
                let left = if column > 0 { side[column - 1] } else { 0 };
                let inside = self.is(class, column, row);
                side[column] = if inside {
                    1 + above.min(left).min(diagonal)
                } else {
                    0
                };
                diagonal = above;
                let size = side[column];
                if size < best.0.0.max(1) {
                    continue;
                }
                let corner = (column + 1 - size, row + 1 - size);
                let off = |from: usize, axis: usize| {
                    from as f64 + size as f64 / 2.0 - middle[axis] / count
                };
                let distance = libm::hypot(off(corner.0, 0), off(corner.1, 1));
                if size > best.0.0 || distance < best.0.1 {
                    best = ((size, distance), corner);
                }
            }
        }
        let ((size, _), (column, row)) = best;
        (size > 0).then_some((column, row, size))
    }
}

/// Straight on where possible.
fn walk(level: &mut [bool], upright: &mut [bool], w: usize, start: usize) -> String {
    let mut runs: Vec<(bool, i64)> = Vec::new(); // along x?, by how much
    let mut at = start;
    loop {
        let ahead = [
            (true, 1i64, level[at]),
            (true, -1, !at.is_multiple_of(w) && level[at - 1]),
            (false, 1, upright[at]),
            (false, -1, at >= w && upright[at - w]),
        ];
        let straight = runs.last().map(|&(along_x, by)| (along_x, by.signum()));
        let free = || ahead.iter().filter(|edge| edge.2);
        let chosen = free()
            .find(|edge| straight == Some((edge.0, edge.1)))
            .or(free().next());
        let Some(&(along_x, by, _)) = chosen else {
            break;
        };
        let to = match (along_x, by) {
            (true, 1) => at + 1,
            (true, _) => at - 1,
            (false, 1) => at + w,
            (false, _) => at - w,
        };
        if along_x {
            level[at.min(to)] = false;
        } else {
            upright[at.min(to)] = false;
        }
        at = to;
        match runs.last_mut() {
            Some(last) if last.0 == along_x && last.1.signum() == by => last.1 += by,
            _ => runs.push((along_x, by)),
        }
    }
    runs.pop(); // "z" draws it
    let letter = |along_x| if along_x { 'h' } else { 'v' };
    runs.iter()
        .map(|&(along_x, by)| format!("{}{by}", letter(along_x)))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn raster(columns: usize, rows: usize, cells: Vec<u8>) -> Raster {
        Raster::new(columns, rows, (0.0, 1.0), (0.0, 1.0), cells).unwrap()
    }

    /// A ray to the left crosses the vertical runs.
    fn filled(path: &str, columns: usize, rows: usize) -> Vec<bool> {
        let mut inside = vec![false; columns * rows];
        for part in path.split('z').filter(|part| !part.is_empty()) {
            let (start, steps) = part[1..].split_at(part[1..].find(['h', 'v']).unwrap());
            let mut numbers = start.split(' ').map(|n| n.parse::<i64>().unwrap());
            let (x0, y0) = (numbers.next().unwrap(), numbers.next().unwrap());
            let (mut x, mut y) = (x0, y0);
            let mut upright = |x: i64, from: i64, to: i64| {
                for row in from.min(to)..from.max(to) {
                    for column in x..columns as i64 {
                        let cell = &mut inside[(row * columns as i64 + column) as usize];
                        *cell = !*cell;
                    }
                }
            };
            let mut rest = steps;
            while !rest.is_empty() {
                let end = rest[1..].find(['h', 'v']).map_or(rest.len(), |k| k + 1);
                let by: i64 = rest[1..end].parse().unwrap();
                if rest.starts_with('h') {
                    x += by;
                } else {
                    upright(x, y, y + by);
                    y += by;
                }
                rest = &rest[end..];
            }
            assert!(x == x0 || y == y0, "the closing line must not be oblique");
            upright(x, y, y0);
        }
        inside
    }

    proptest! {
        #[test]
        fn the_outline_fills_the_cells_of_the_class(
            (columns, rows, cells) in (1usize..12, 1usize..12).prop_flat_map(|(c, r)| {
                (Just(c), Just(r), proptest::collection::vec(0u8..3, c * r))
            }),
        ) {
            let raster = raster(columns, rows, cells.clone()).class("a", 0, 0.2).class("b", 1, 0.2);
            for class in 0..2 {
                let drawn = filled(&raster.outline(class), columns, rows);
                let wanted: Vec<bool> = cells.iter().map(|&cell| cell == class).collect();
                prop_assert_eq!(&drawn, &wanted);
                let count = drawn.iter().filter(|&&inside| inside).count();
                prop_assert_eq!(raster.counts()[usize::from(class)], count);
            }
        }

        #[test]
        fn the_largest_square_is_of_one_class_and_none_is_larger(
            (columns, rows, cells) in (1usize..9, 1usize..9).prop_flat_map(|(c, r)| {
                (Just(c), Just(r), proptest::collection::vec(0u8..2, c * r))
            }),
        ) {
            let raster = raster(columns, rows, cells);
            let square = |i: usize, j: usize, side: usize| {
                (0..side).all(|a| (0..side).all(|b| raster.is(0, i + a, j + b)))
            };
            let found = raster.largest_square(0);
            let side = found.map_or(0, |found| found.2);
            prop_assert!(found.is_none_or(|(i, j, side)| square(i, j, side)));
            for j in 0..rows {
                for i in 0..columns {
                    prop_assert!(!square(i, j, side + 1));
                }
            }
        }
    }

    #[test]
    fn a_raster_must_be_full_and_its_classes_known() {
        for (columns, rows, cells) in [(2, 2, 3), (0, 1, 0), (usize::MAX, 2, 4)] {
            let made = Raster::new(columns, rows, (0.0, 1.0), (0.0, 1.0), vec![0; cells]);
            let error = FigureError::RasterShape {
                columns,
                rows,
                cells,
            };
            assert_eq!(made, Err(error));
        }
        for x in [(0.0, f64::NAN), (1.0, 0.0), (f64::NEG_INFINITY, 0.0)] {
            let made = Raster::new(1, 1, x, (0.0, 1.0), vec![0]);
            assert!(matches!(made, Err(FigureError::Range { .. })));
        }
        let raster = raster(2, 1, vec![BLANK, 1]).class("a", 0, 0.2);
        let error = FigureError::RasterClass {
            classes: 1,
            class: 1,
        };
        assert_eq!(raster.check(), Err(error));
        assert_eq!(raster.class("b", 1, 0.2).check(), Ok(()));
    }

    #[test]
    fn a_large_simple_region_is_a_short_text() {
        let cells = (0..500 * 500)
            .map(|k| u8::from(k % 500 > k / 500))
            .collect();
        let raster = raster(500, 500, cells)
            .class("a", 0, 0.2)
            .class("b", 1, 0.2);
        assert!(raster.outline(0).len() < 5_000);
    }
}
