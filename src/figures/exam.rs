//! The figure of the exam: what an answer costs each candidate.

use trialbook::figures::{Axis, Curve, Figure, FigureError, Marker, Panel, Plot, Points, Table};

/// A candidate's runs of one task.
#[derive(Debug, Clone, PartialEq)]
pub struct Runs {
    /// Who.
    pub name: String,
    /// Processor seconds for each unit of time, and the error, from the coarsest run on.
    pub points: Vec<[f64; 2]>,
}

/// A task, everyone who sat it, and our own point.
#[derive(Debug, Clone, PartialEq)]
pub struct Sat {
    /// The task's name.
    pub task: &'static str,
    /// The candidates, the same for all tasks; without points for one that did not sit.
    pub runs: Vec<Runs>,
    /// Our cost and error.
    pub ours: [f64; 2],
}

/// Errors below this are drawn here: rounding.
const ROUNDING: f64 = 1e-16;

/// Error against cost, a panel for each task.
///
/// # Errors
/// As [`Plot::figure`].
pub fn exam(tasks: &[Sat]) -> Result<Figure, FigureError> {
    let mut table = Table::new(&["task", "candidate", "cost", "error"]);
    let mut plot = Plot::new("exam", "What an answer costs")
        .caption(
            "The error of the answer against the processor time, in seconds, for a unit of time in the motion. Each candidate was run with \
             various steps, tolerances or velocity scales, tuned where it was; the square is our motion, which goes from event to event. \
             An error within rounding is drawn at $10^{-16}$.",
        )
        .alt(
            "A panel for each task, with logarithmic axes: cost and error. Each candidate is a line that begins at its coarsest run. The lines of the \
             engines end far from rounding, those of the solvers with events at it, where the square of our motion is, too.",
        );
    for sat in tasks {
        let mut panel = Panel::new(Axis::log("'cost'"), Axis::log("'error'")).title(sat.task);
        // Whoever did not sit leaves its colour unused, so that one has the same in all panels.
        let sitting = sat
            .runs
            .iter()
            .enumerate()
            .filter(|(_, runs)| !runs.points.is_empty());
        for (n, runs) in sitting {
            for [cost, error] in &runs.points {
                let cells = [
                    sat.task.into(),
                    runs.name.as_str().into(),
                    (*cost).into(),
                    error.max(ROUNDING).into(),
                ];
                table.row(cells)?;
            }
            let points = runs
                .points
                .iter()
                .map(|[cost, error]| [*cost, error.max(ROUNDING)]);
            panel = panel.curve(Curve::new(points).series(n).key(format!("'{}'", runs.name)));
        }
        let [cost, error] = sat.ours;
        table.row([
            sat.task.into(),
            "ours".into(),
            cost.into(),
            error.max(ROUNDING).into(),
        ])?;
        let own = Points::new([[cost, error.max(ROUNDING)]])
            .ink()
            .marker(Marker::Square);
        plot = plot.panel(panel.points(own.key("'ours'")));
    }
    plot.figure(table)
}
