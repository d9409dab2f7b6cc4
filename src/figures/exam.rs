//! The figure of the exam, from the committed results: what an answer costs each candidate.

use super::{AllFiguresError, Drawn};
use crate::exam::{
    Answer, TASKS,
    results::{Candidate, ResultsError, candidates, ours, tasks},
};
use trialbook::plotting::{Axis, Curve, Figure, FigureError, Marker, Panel, Plot, Points, Table};

/// The tasks drawn: a stop in the plane, and a stick and slip.
const DRAWN: [&str; 2] = ["stop-place", "heat"];

pub(super) fn figures() -> Drawn<Vec<Figure>> {
    let data = sat().map_err(|error| AllFiguresError::Data(error.to_string()))?;
    Ok(vec![exam(&data)?])
}

fn sat() -> Result<Vec<Sat>, ResultsError> {
    let all = candidates()?;
    // The last settings of a name are the tuned ones.
    let last = |n: usize, candidate: &Candidate| {
        all[n + 1..]
            .iter()
            .all(|later| later.name != candidate.name)
    };
    let tuned: Vec<_> = all
        .iter()
        .enumerate()
        .filter(|(n, candidate)| last(*n, candidate))
        .collect();
    let seconds = ours()?.seconds;
    let mut data = Vec::new();
    for (task, lasts) in tasks()?
        .into_iter()
        .filter(|(task, _)| DRAWN.contains(task))
    {
        let mut runs = Vec::new();
        for (_, candidate) in &tuned {
            let points: Vec<_> = candidate
                .marks(task)?
                .iter()
                .map(|mark| [mark.cost, mark.error])
                .collect();
            let name = candidate.name.clone();
            runs.push(Runs { name, points });
        }
        let known = TASKS.iter().find(|known| known.id == task);
        let known = known.ok_or_else(|| ResultsError::Task(task.to_owned()))?;
        let error = match (known.sit()?.answer, known.by_motion()?) {
            (Answer::Number(right), Answer::Number(found)) => (right - found).abs(),
            _ => f64::NAN,
        };
        let cost = seconds.get(task).copied().unwrap_or(f64::NAN) / lasts;
        data.push(Sat {
            task,
            runs,
            ours: [cost, error],
        });
    }
    Ok(data)
}

#[derive(Debug, Clone, PartialEq)]
pub(super) struct Runs {
    pub name: String,
    /// Processor seconds for each unit of time, and the error, from the coarsest run on.
    pub points: Vec<[f64; 2]>,
}

/// A task, everyone who sat it, and our own point.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Sat {
    pub task: &'static str,
    /// The candidates, the same for all tasks; without points for one that did not sit.
    pub runs: Vec<Runs>,
    /// Cost and error.
    pub ours: [f64; 2],
}

/// Errors below this are drawn here: rounding.
const ROUNDING: f64 = 1e-16;

/// Error against cost, a panel for each task.
pub(super) fn exam(tasks: &[Sat]) -> Result<Figure, FigureError> {
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
    let drawn = |[cost, error]: &[f64; 2]| [*cost, error.max(ROUNDING)];
    for sat in tasks {
        let mut panel = Panel::new(Axis::log("'cost'"), Axis::log("'error'"))
            .title(sat.task)
            .height(420.0);
        // Whoever did not sit leaves its colour unused, so that one has the same in all panels.
        let sitting = sat
            .runs
            .iter()
            .enumerate()
            .filter(|(_, runs)| !runs.points.is_empty());
        for (n, runs) in sitting {
            let points = runs.points.iter().map(drawn);
            table.rows((sat.task, &runs.name), points.clone())?;
            let curve = Curve::new(points).series(n).solid();
            panel = panel.curve(curve.label(format!("'{}'", runs.name)));
        }
        let own = drawn(&sat.ours);
        table.row((sat.task, "ours", own))?;
        let own = Points::new([own]).ink().marker(Marker::Square);
        plot = plot.panel(panel.points(own.label("'ours'")));
    }
    plot.figure(table)
}
