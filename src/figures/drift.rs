//! The figure of the drift under anisotropic friction, and of what it costs. Dimensionless, as in [`super::anisotropic`].

use super::AllFiguresError;
use super::anisotropic::{Heights, heights};
use crate::claims::anisotropic::drawn::{self, Budgets};
use trialbook::plotting::{
    Axis, BLANK, Curve, Figure, FigureError, Panel, Plot, Raster, Stroke, Table,
};

pub(super) fn figures() -> Result<Vec<Figure>, AllFiguresError> {
    Ok(vec![drift(&drawn::budgets()?)?])
}

/// Ends of the bands of the mean velocity, from 0 on.
const DRIFTS: [f64; 6] = [0.05, 0.2, 0.35, 0.5, 0.65, 0.8];

/// Ends of the bands of what is lost in a period.
const LOSSES: [f64; 6] = [0.05, 0.25, 0.5, 0.75, 1.0, 1.2];

/// The map of the mean velocity, and that of what friction takes.
///
/// # Errors
/// As [`Plot::figure`].
pub fn drift(budgets: &Budgets) -> Result<Figure, FigureError> {
    let mut table = Table::new(&["q", "lambda_0", "mean velocity", "lost in a period"]);
    let (columns, rows) = budgets.shape;
    let middle = |(from, to): (f64, f64), i: usize, n: usize| {
        from + (to - from) * (i as f64 + 0.5) / n as f64
    };
    for (k, [drift, lost]) in budgets.cells.iter().enumerate() {
        let q = middle(budgets.q, k % columns, columns);
        let lambda0 = middle(budgets.lambda0, k / columns, rows);
        table.row([q.into(), lambda0.into(), drift.into(), lost.into()])?;
    }
    Plot::new("anisotropic-drift", "How fast it creeps, and what that costs")
        .caption(
            "By simulation, in bands. The first map has the mean velocity, in units of $A_0/\\varpi$; the second what friction \
             takes in a period, per mass and in units of $A_0^2/\\varpi^2$. The curves are those of the corrected diagram.",
        )
        .alt(
            "Two maps with q from 1 to 7 along the horizontal axis and λ₀ from 0 to 1.2 along the vertical one. In the first the \
             bands of the mean velocity are horizontal in region IV, bend at the curves, and the fastest band lies in the \
             corner of large q and small λ₀. In the second the bands of the loss surround a place at q = 1, λ₀ = 0.45.",
        )
        .panel(map(budgets, "mean velocity", 0, &DRIFTS)?)
        .panel(map(budgets, "loss per period", 1, &LOSSES)?)
        .figure(table)
}

/// One of the maps; the bands are cut at `ends`.
fn map(budgets: &Budgets, title: &str, which: usize, ends: &[f64]) -> Result<Panel, FigureError> {
    let band = |cell: &[f64; 2]| match ends.iter().filter(|end| **end <= cell[which]).count() {
        0 => BLANK,
        n => n as u8 - 1,
    };
    let (columns, rows) = budgets.shape;
    let cells = budgets.cells.iter().map(band).collect();
    let mut raster = Raster::new(columns, rows, budgets.q, budgets.lambda0, cells)?;
    for (n, end) in ends.iter().enumerate() {
        let label = match ends.get(n + 1) {
            Some(next) => format!("{end}–{next}"),
            None => format!("above {end}"),
        };
        raster = raster.class(label, which, 0.1 + 0.12 * n as f64);
    }
    let curve = |of: fn(&Heights) -> Option<f64>| {
        let points = budgets
            .curves
            .iter()
            .map(heights)
            .filter_map(move |h| Some([h.q, of(&h)?]));
        Curve::new(points).ink().width(1.0)
    };
    Ok(Panel::new(
        Axis::linear("q")
            .range(budgets.q.0, budgets.q.1)
            .without_grid(),
        Axis::linear("λ_0")
            .range(budgets.lambda0.0, budgets.lambda0.1)
            .without_grid(),
    )
    .title(title)
    .height(300.0)
    .raster(raster)
    .curve(curve(|h| Some(h.d)).label_at("'D'", 0.9))
    .curve(curve(|h| h.e.is_none().then_some(h.c)).label_at("'C'", 0.3))
    .curve(curve(|h| h.b).stroke(Stroke::Dotted).label_at("'B'", 0.1))
    .curve(curve(|h| h.e).label_at("'E'", 0.8))
    .curve(curve(|h| Some(h.a)).label_at("'A'", 0.3)))
}
