//! The figure of the exam: what an answer costs each candidate.

use super::{Axis, Curve, Figure, FigureError, Marker, Panel, Plot, Points, Table};

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
    /// The candidates.
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
            "The error of the answer against the processor time for a unit of time in the motion, both logarithmic; each candidate with \
             ever smaller steps, tolerances or velocity scales from left to right, tuned where it was. The black square is our motion, which goes \
             from event to event. Errors below $10^{-16}$ are drawn there.",
        )
        .alt(
            "Panels with the cost to the right and the error upwards. The lines of the engines fall slowly or become level; those of the \
             solvers with events fall steeply to rounding; the square of our motion lies at the lower left.",
        );
    for sat in tasks {
        let mut panel = Panel::new(Axis::log("'cost, s'"), Axis::log("'error'")).title(sat.task);
        for (n, runs) in sat.runs.iter().enumerate() {
            for [cost, error] in &runs.points {
                let cells = [
                    sat.task.into(),
                    runs.name.as_str().into(),
                    (*cost).into(),
                    (*error).into(),
                ];
                table.row(cells)?;
            }
            let points = runs
                .points
                .iter()
                .map(|[cost, error]| [*cost, error.max(ROUNDING)]);
            panel = panel.curve(Curve::new(points).series(n).key(runs.name.as_str()));
        }
        let [cost, error] = sat.ours;
        table.row([sat.task.into(), "ours".into(), cost.into(), error.into()])?;
        let own = Points::new([[cost, error.max(ROUNDING)]])
            .ink()
            .marker(Marker::Square);
        plot = plot.panel(panel.points(own.key("ours")));
    }
    plot.figure(table)
}
