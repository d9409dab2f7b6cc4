//! A plot of a calculator's answer.

use crate::solve;
use trialbook::plotting::{Axis, Figure, FigureError, Panel, Plot, Table};

/// The curve of an answer, on plain axes: equally long units, if they are the same and there is room.
///
/// Fails as [`Plot::figure`] does.
pub fn figure(curve: &solve::Curve) -> Result<Figure, FigureError> {
    let labels = curve.labels();
    let mut table = Table::new(&labels.each_ref().map(String::as_str));
    table.rows((), &curve.points)?;
    let [x, y] = labels.map(Axis::linear);
    let mut panel = Panel::new(x, y).curve(trialbook::plotting::Curve::new(&curve.points));
    let span = |axis: usize| {
        let values = || curve.points.iter().map(|p| p[axis]);
        values().fold(f64::NEG_INFINITY, f64::max) - values().fold(f64::INFINITY, f64::min)
    };
    // A path that is nearly straight would be no more than a line.
    if curve.equal && (0.2..=3.0).contains(&(span(1) / span(0))) {
        panel = panel.equal();
    }
    Plot::new("solve", curve.title)
        .alt(format!("{}: {} against {}.", curve.title, curve.y, curve.x))
        .panel(panel)
        .figure(table)
}
