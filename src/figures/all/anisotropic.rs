//! Figures of section 2.4.

use super::AllFiguresError;
use crate::claims::anisotropic::{
    census, drawn as anisotropic_drawn, panels, rows as anisotropic_rows,
    simulated as anisotropic_simulated,
};
use crate::figures::{anisotropic as anisotropic_figures, drift as anisotropic_drift};
use trialbook::figures::Figure;

pub(super) fn figures() -> Result<Vec<Figure>, AllFiguresError> {
    Ok(vec![
        region_diagram()?,
        region_waves()?,
        region_census()?,
        region_boundaries()?,
        budgets()?,
    ])
}

fn heights(curves: &anisotropic_simulated::Curves) -> anisotropic_figures::Heights {
    anisotropic_figures::Heights {
        q: curves.q,
        a: curves.printed.a,
        b: curves.printed.b,
        c: curves.printed.c,
        d: curves.printed.d,
        e: anisotropic_drawn::on_e(&curves.corrected),
    }
}

fn region_map(
    columns: std::ops::Range<usize>,
    rows: usize,
    largest_q: f64,
) -> Result<anisotropic_figures::Map, AllFiguresError> {
    let map = anisotropic_drawn::map(columns, rows)?;
    let count = census::count(largest_q)?;
    // A region is at most 5.
    let cell = |&(at, found, printed): &anisotropic_drawn::Cell| anisotropic_figures::Cell {
        at,
        found: found as u8,
        printed: printed.unwrap_or(0) as u8,
    };
    Ok(anisotropic_figures::Map {
        curves: map.curves.iter().map(heights).collect(),
        q: map.q,
        lambda0: map.lambda0,
        cells: map.cells.iter().map(cell).collect(),
        corners: anisotropic_drawn::corners()?,
        count: [count.points, count.printed_wrong, count.corrected_wrong],
    })
}

/// fig-5.
fn region_diagram() -> Result<Figure, AllFiguresError> {
    Ok(anisotropic_figures::fig5(&region_map(0..180, 180, 7.0)?)?)
}

/// The census beyond Y.
fn region_census() -> Result<Figure, AllFiguresError> {
    let map = region_map(90..330, 36, f64::INFINITY)?;
    Ok(anisotropic_figures::census(&map)?)
}

/// How fast the particle creeps, and what it loses.
fn budgets() -> Result<Figure, AllFiguresError> {
    let all = anisotropic_drawn::budgets()?;
    Ok(anisotropic_drift::drift(&anisotropic_drift::Budgets {
        curves: all.curves.iter().map(heights).collect(),
        shape: all.shape,
        q: all.q,
        lambda0: all.lambda0,
        cells: all.cells,
    })?)
}

/// fig-6.
fn region_waves() -> Result<Figure, AllFiguresError> {
    let wave = |(points, (q, lambda0))| anisotropic_figures::Wave { q, lambda0, points };
    let waves = anisotropic_drawn::waves()?;
    let waves: Vec<_> = waves.into_iter().zip(panels::PANELS).map(wave).collect();
    Ok(anisotropic_figures::fig6(&waves)?)
}

/// The boundaries for large q.
fn region_boundaries() -> Result<Figure, AllFiguresError> {
    let seen = |row: &anisotropic_rows::Row| -> Result<_, AllFiguresError> {
        Ok(anisotropic_figures::Seen {
            curves: heights(&anisotropic_simulated::Curves::at(row.q)?),
            rest: row.changes.rest,
            reversal: row.changes.reversal,
            backward: row.changes.backward,
            motion: row.changes.motion,
        })
    };
    let rows = anisotropic_drawn::boundaries()?;
    let seen = rows.iter().map(seen).collect::<Result<Vec<_>, _>>()?;
    let law = |law: anisotropic_rows::Law| anisotropic_figures::Law {
        exponent: law.exponent,
        prefactor: law.prefactor,
    };
    let laws = anisotropic_rows::far_laws()?.map(law);
    Ok(anisotropic_figures::far(&seen, laws)?)
}
