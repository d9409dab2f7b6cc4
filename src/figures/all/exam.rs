//! The figure of the exam, from the committed results.

use super::AllFiguresError;
use crate::exam::results::{Candidate, ResultsError, candidates, ours, tasks};
use crate::exam::{Answer, TASKS};
use crate::figures::exam::{Runs, Sat, exam};
use trialbook::figures::Figure;

/// The tasks drawn: a stop in the plane, and a stick and slip.
const DRAWN: [&str; 2] = ["stop-place", "heat"];

pub(super) fn figures() -> Result<Vec<Figure>, AllFiguresError> {
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
