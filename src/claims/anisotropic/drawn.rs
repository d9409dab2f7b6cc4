//! What the figures of section 2.4 show: the data of the trials.

use super::census::{self, Column, LAMBDA0, Q};
use super::panels::{PANELS, motion};
use super::prelude::*;
use super::rows::FAR_ROWS;
use super::simulated::fits;

/// q and λ₀, found and printed region.
pub(crate) type Cell = ([f64; 2], usize, Option<usize>);

#[derive(Debug, Clone)]
pub(crate) struct Map {
    /// In order of q.
    pub curves: Vec<Curves>,
    pub q: (f64, f64),
    pub lambda0: (f64, f64),
    /// One in each cell, row by row from the lowest λ₀.
    pub cells: Vec<Cell>,
}

fn inside((low, high): (f64, f64), at: f64) -> bool {
    low < at && at < high
}

/// The census cells of these columns and of the lowest `rows` rows, with the curves over them, Y included.
pub(crate) fn map(columns: std::ops::Range<usize>, rows: usize) -> Result<Map, Failure> {
    let all = census::columns()?;
    let chosen: &[Column] = all.get(columns.clone()).ok_or("no such columns")?;
    let lists: Vec<_> = chosen.iter().map(|column| printed_list(column.q)).collect();
    let cell = |i: usize, j: usize| {
        let (lambda0, found) = chosen[i].cells[j];
        ([chosen[i].q, lambda0], fits(found), lists[i](lambda0))
    };
    let rows = rows.min(census::ROWS);
    let end = |(from, to): (f64, f64), i: usize, n: usize| from + (to - from) * i as f64 / n as f64;
    let along_q = |i: usize| end(Q, i, census::COLUMNS);
    let q = (along_q(columns.start), along_q(columns.end));
    let mut ratios: Vec<f64> = (columns.start..=columns.end).map(along_q).collect();
    // B and C end, and E begins, at Y.
    let y = touching()?;
    ratios.extend(
        [y * (1.0 - 1e-6), y * (1.0 + 1e-6)]
            .iter()
            .filter(|&&at| inside(q, at)),
    );
    ratios.sort_by(f64::total_cmp);
    Ok(Map {
        curves: ratios
            .into_iter()
            .map(Curves::at)
            .collect::<Result<_, _>>()?,
        q,
        lambda0: (LAMBDA0.0, end(LAMBDA0, rows, census::ROWS)),
        cells: (0..rows)
            .flat_map(|j| (0..chosen.len()).map(move |i| (i, j)))
            .map(|(i, j)| cell(i, j))
            .collect(),
    })
}

/// The points X and Y as (q, λ₀), to all digits.
pub(crate) fn corners() -> Result<[[f64; 2]; 2], Failure> {
    let y = touching()?;
    Ok([printed::eq57_x(), [y, printed::eq55_lambda0(y)]])
}

#[derive(Debug, Clone)]
pub(crate) struct Budgets {
    /// Rising.
    pub q: Vec<f64>,
    /// Rising.
    pub lambda0: Vec<f64>,
    /// At these q.
    pub curves: Vec<Curves>,
    /// The mean velocity and what friction takes in a period, by the motion, for each q in turn at all λ₀.
    pub found: Vec<Vec<[f64; 2]>>,
}

/// By simulation at the points of a grid.
pub(crate) fn budgets() -> Result<Budgets, Failure> {
    let q: Vec<f64> = (0..=120).map(|i| 1.0 + f64::from(i) / 20.0).collect();
    let lambda0: Vec<f64> = (1..=48).map(|i| f64::from(i) / 40.0).collect();
    let found = |&q: &f64| -> Result<Vec<_>, Failure> {
        let one = |&lambda0: &f64| -> Result<_, Failure> {
            let motion = attractor(q, lambda0)?;
            Ok([motion.displacement() / (2.0 * PI), motion.lost()])
        };
        lambda0.iter().map(one).collect()
    };
    Ok(Budgets {
        curves: q.iter().map(|&q| Curves::at(q)).collect::<Result<_, _>>()?,
        found: q.iter().map(found).collect::<Result<_, _>>()?,
        q,
        lambda0,
    })
}

/// (φ, 𝔴) over two periods in each panel of fig-6: equal steps and the ends of the intervals.
pub(crate) fn waves() -> Result<Vec<Vec<[f64; 2]>>, Failure> {
    let wave = |panel| -> Result<Vec<[f64; 2]>, Failure> {
        let motion = motion(panel, START)?;
        let mut phases: Vec<f64> = (0..=160).map(|k| 4.0 * PI * f64::from(k) / 160.0).collect();
        let ends = motion
            .intervals()
            .iter()
            .map(|i| i.end.rem_euclid(2.0 * PI));
        phases.extend(ends.flat_map(|end| [end, end + 2.0 * PI]));
        phases.sort_by(f64::total_cmp);
        Ok(phases.into_iter().map(|phi| [phi, motion.w(phi)]).collect())
    };
    (0..PANELS.len()).map(wave).collect()
}

/// λ₀ on E where the map's curves are beyond Y.
pub(crate) fn on_e(curves: &corrected::Curves) -> Option<f64> {
    curves.c.is_none().then_some(curves.b_or_e)
}

/// From q = 1 to 20,000, about equally far apart on a logarithmic scale: some of those that were tried, and a few
/// between them.
pub(crate) fn boundaries() -> Result<Vec<Row>, Failure> {
    let mut all = every(rows().chain(FAR_ROWS.each()).map(|row| row.copied()))?;
    for k in 0..14 {
        let q = 14.0 * libm::exp10(f64::from(k) / 12.0);
        all.push(Row::at(q, 1e-9)?);
    }
    all.sort_by(|a, b| a.q.total_cmp(&b.q));
    let mut last = 0.0;
    all.retain(|row| {
        let keep = row.q > 1.15 * last;
        if keep {
            last = row.q;
        }
        keep
    });
    Ok(all)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_what_is_between_the_ends_is_inside() {
        let places = [0.5, 1.0, 1.5, 2.0, 2.5];
        assert_eq!(
            places.map(|at| inside((1.0, 2.0), at)),
            [false, false, true, false, false]
        );
    }
}
