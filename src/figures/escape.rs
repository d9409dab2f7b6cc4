//! The figures of section 4, escape. All dimensionless: lengths in μg/Ω², times in 1/Ω.

use super::{Axis, Curve, Figure, FigureError, Panel, Plot, Rule, Stroke, Table};

/// A quantity over its power of the time, with the printed and the corrected limit.
#[derive(Debug, Clone, PartialEq)]
pub struct Compensated {
    /// Name in the table: `p/tau^2`.
    pub name: &'static str,
    /// Name on the axis.
    pub axis: &'static str,
    /// Ends of the axis.
    pub range: (f64, f64),
    /// The limit as printed, if it has one.
    pub printed: Option<f64>,
    /// The corrected limit.
    pub corrected: f64,
    /// (τ, value) along several escapes.
    pub escapes: Vec<Vec<[f64; 2]>>,
}

/// Compensated plots: each quantity over the power of τ by which it grows, against τ.
///
/// Fails as [`Plot::figure`] does.
pub fn compensated(quantities: &[Compensated]) -> Result<Figure, FigureError> {
    let mut table = Table::new(&["quantity", "escape", "tau", "value"]);
    let mut plot = Plot::new("escape-compensated", "How an escape grows")
        .caption(
            "Speed, size $A$ and angle of three escapes, each over the power of $\\tau$ by which it grows or \
             falls. A law with the right prefactor becomes a horizontal line. The motions pass the printed \
             values (dashed) on their way and settle on the corrected ones (solid).",
        )
        .alt(
            "Three panels over the time from 10 to a hundred million, on a logarithmic axis. In each the three \
             curves join before ten thousand and run level along the line of the corrected value, above the \
             printed one.",
        );
    for quantity in quantities {
        let mut panel = Panel::new(
            Axis::log("τ"),
            Axis::linear(quantity.axis).range(quantity.range.0, quantity.range.1),
        )
        .height(230.0)
        .rule(
            Rule::horizontal(quantity.corrected)
                .stroke(Stroke::Solid)
                .key(format!("corrected: {:.6}", quantity.corrected)),
        );
        if let Some(printed) = quantity.printed {
            panel = panel.rule(Rule::horizontal(printed).key(format!("printed: {printed:.6}")));
        }
        for (n, escape) in quantity.escapes.iter().enumerate() {
            for [tau, value] in escape {
                let number = n as f64 + 1.0;
                table.row([
                    quantity.name.into(),
                    number.into(),
                    (*tau).into(),
                    (*value).into(),
                ])?;
            }
            let inside = |y: f64| y > quantity.range.0 && y < quantity.range.1;
            let points = escape
                .iter()
                .map(|&[x, y]| if inside(y) { [x, y] } else { [x, f64::NAN] });
            panel = panel.curve(Curve::new(points).series(n));
        }
        plot = plot.panel(panel);
    }
    plot.figure(table)
}

/// A path in one frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Path {
    /// What becomes of the particle.
    pub label: String,
    /// (τ, x, y) on the table.
    pub table: Vec<[f64; 3]>,
    /// (τ, x, y) in the laboratory.
    pub laboratory: Vec<[f64; 3]>,
}

/// Two particles put down at rest in the laboratory, on either side of the critical radius.
///
/// Fails as [`Plot::figure`] does.
pub fn paths(paths: &[Path]) -> Result<Figure, FigureError> {
    let mut table = Table::new(&["path", "frame", "tau", "x", "y"]);
    let new = |title: &str| {
        Panel::new(
            Axis::linear("x").range(-2.2, 2.2),
            Axis::linear("y").range(-2.2, 2.2),
        )
        .title(title)
        .equal()
    };
    let mut panels = [new("'on the table'"), new("'in the laboratory'")];
    for (n, path) in paths.iter().enumerate() {
        for (panel, (frame, points)) in panels
            .iter_mut()
            .zip([("table", &path.table), ("laboratory", &path.laboratory)])
        {
            for [tau, x, y] in points {
                let head = [path.label.as_str().into(), frame.into()];
                table.row(
                    head.into_iter()
                        .chain([(*tau).into(), (*x).into(), (*y).into()]),
                )?;
            }
            let curve = Curve::new(points.iter().map(|&[_, x, y]| [x, y]));
            let curve = curve.series(n).arrows(&[0.5]).key(path.label.clone());
            *panel = panel.clone().curve(curve);
        }
    }
    let [on_table, in_laboratory] = panels;
    Plot::new("escape-paths", "Rest and escape, seen from the table and from the laboratory")
        .caption(
            "Two particles put down at rest in the laboratory, one just inside and one just outside the critical \
             radius. On the table both first slide backwards. One comes to rest there and rides in a circle ever \
             after; the other goes away.",
        )
        .alt(
            "Two panels. On the table two paths run together for a short way, backwards; then one ends and the \
             other bends outwards and leaves the panel. In the laboratory the first winds into a circle about the \
             axis, the second spirals out of the panel.",
        )
        .panel(on_table)
        .panel(in_laboratory)
        .figure(table)
}
