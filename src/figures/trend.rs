//! What curves do, for the words of captions and pages.

pub(super) fn column(rows: &[Vec<f64>], i: usize) -> impl Iterator<Item = f64> + Clone {
    rows.iter().map(move |row| row[i])
}

pub(crate) fn falls(values: impl Iterator<Item = f64>) -> bool {
    let values: Vec<_> = values.collect();
    values.len() > 1 && values.windows(2).all(|two| two[0] > two[1])
}

pub(crate) fn rises(values: impl Iterator<Item = f64>) -> bool {
    falls(values.map(|x| -x))
}

/// Whether it falls, and whether it rises.
pub(super) fn way(values: impl Iterator<Item = f64> + Clone) -> [bool; 2] {
    [falls(values.clone()), rises(values)]
}

/// Whether a column falls in all groups, and whether it rises in all.
pub(super) fn ways(groups: &[Vec<Vec<f64>>], i: usize) -> [bool; 2] {
    let each = groups.iter().map(|rows| way(column(rows, i)));
    [0, 1].map(|k| each.clone().all(|way| way[k]))
}

/// Whether all are below a value, and whether all are above it.
pub(super) fn sides(values: impl Iterator<Item = f64> + Clone, than: f64) -> [bool; 2] {
    let there = values.clone().next().is_some();
    [
        there && values.clone().all(|x| x < than),
        there && values.clone().all(|x| x > than),
    ]
}

pub(crate) fn same(a: f64, b: f64, tolerance: f64) -> bool {
    (a - b).abs() <= tolerance * b.abs()
}

pub(super) fn steepens(rows: &[Vec<f64>], x: usize, y: usize) -> bool {
    let slope = |two: &[Vec<f64>]| (two[1][y] - two[0][y]) / (two[1][x] - two[0][x]);
    let slopes: Vec<f64> = rows.windows(2).map(slope).collect();
    slopes.len() > 1 && slopes.windows(2).all(|two| two[0] <= two[1])
}

/// Where a column has its largest value, and that.
pub(super) fn peak(rows: &[Vec<f64>], x: usize, y: usize) -> [f64; 2] {
    let peak = rows.iter().map(|row| [row[x], row[y]]);
    let peak = peak.max_by(|a, b| a[1].total_cmp(&b[1]));
    peak.unwrap_or([f64::NAN; 2])
}
