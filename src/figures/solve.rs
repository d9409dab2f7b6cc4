//! A plot of a calculator's answer.

use super::{Axis, Figure, FigureError, Panel, Plot, Table};
use crate::claims::solve;

/// The curve of an answer, on plain axes.
///
/// Fails as [`Plot::figure`] does.
pub fn figure(curve: &solve::Curve) -> Result<Figure, FigureError> {
    let mut table = Table::new(&[curve.x, curve.y]);
    for [x, y] in &curve.points {
        table.row([x.into(), y.into()])?;
    }
    let mut panel = Panel::new(Axis::linear(curve.x), Axis::linear(curve.y))
        .curve(super::Curve::new(curve.points.iter().copied()));
    if curve.equal {
        panel = panel.equal();
    }
    Plot::new("solve", curve.title)
        .alt(format!("{}: {} against {}.", curve.title, curve.y, curve.x))
        .panel(panel)
        .figure(table)
}
