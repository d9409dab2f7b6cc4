//! What other engines and solvers made of the exam, from the committed result files in `benches/exam/results`.

use super::{Answer, ExamError, TASKS};
use serde::Deserialize;
use std::collections::BTreeMap;

const FILES: [(&str, &str); 7] = [
    (
        "mujoco.json",
        include_str!("../../benches/exam/results/mujoco.json"),
    ),
    (
        "pybullet.json",
        include_str!("../../benches/exam/results/pybullet.json"),
    ),
    (
        "drake.json",
        include_str!("../../benches/exam/results/drake.json"),
    ),
    (
        "rapier.json",
        include_str!("../../benches/exam/results/rapier.json"),
    ),
    (
        "box2d.json",
        include_str!("../../benches/exam/results/box2d.json"),
    ),
    (
        "siconos.json",
        include_str!("../../benches/exam/results/siconos.json"),
    ),
    (
        "events.json",
        include_str!("../../benches/exam/results/events.json"),
    ),
];

/// What `cargo bench -p slipbook-benches --bench exam` wrote.
const OURS: &str = include_str!("../../benches/exam/results/ours.json");

#[derive(Debug, Clone, PartialEq, Deserialize)]
struct File {
    date: String,
    machine: String,
    entries: Vec<Candidate>,
}

/// An engine or a solver with its settings.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct Candidate {
    /// Its name, with its friction cone where it has several.
    pub name: String,
    /// Its version.
    pub version: String,
    /// How it was set up.
    pub settings: String,
    /// What it promises of friction.
    pub promises: String,
    /// What is made smaller from run to run: a time step, a tolerance, a velocity.
    pub knob: String,
    runs: Vec<Run>,
}

#[derive(Debug, Clone, PartialEq, Deserialize)]
struct Run {
    task: String,
    knob: f64,
    answer: Option<f64>,
    cpu: Option<f64>,
    simulated: f64,
}

/// A run beside the answer of the exam.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Mark {
    /// The step, tolerance or velocity.
    pub knob: f64,
    /// The distance from the answer of the exam.
    pub error: f64,
    /// Processor time, in seconds, for each unit of time in the motion.
    pub cost: f64,
}

/// When and on what the candidates ran, and what our own side costs.
#[derive(Debug, Clone, PartialEq, Deserialize)]
pub struct Ours {
    /// The day of the measurement.
    pub date: String,
    /// The kind of machine.
    pub machine: String,
    /// Seconds for each task.
    pub seconds: BTreeMap<String, f64>,
}

/// Why there are no results to show.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum ResultsError {
    /// A damaged file.
    #[error("benches/exam/results/{file}: {error}")]
    File {
        /// Its name.
        file: &'static str,
        /// What is wrong with it.
        error: serde_json::Error,
    },
    /// A task without an answer.
    #[error(transparent)]
    Exam(#[from] ExamError),
    /// A run of a task that is not in the exam, or that asks for no number.
    #[error("`{0}` is no task of the exam with a number")]
    Task(String),
}

/// Everyone who sat, in the order of the files.
///
/// # Errors
/// [`ResultsError::File`] for a damaged file.
pub fn candidates() -> Result<Vec<Candidate>, ResultsError> {
    let read = |(file, text): (&'static str, &str)| {
        let parsed: Result<File, _> = serde_json::from_str(text);
        parsed.map_err(|error| ResultsError::File { file, error })
    };
    let files: Result<Vec<_>, _> = FILES.into_iter().map(read).collect();
    Ok(files?.into_iter().flat_map(|file| file.entries).collect())
}

/// When and on what the candidates sat: the days and machines of the files, each once.
pub(crate) fn circumstances() -> Result<Vec<String>, ResultsError> {
    let mut seen = Vec::new();
    for (file, text) in FILES {
        let parsed: Result<File, _> = serde_json::from_str(text);
        let File { date, machine, .. } =
            parsed.map_err(|error| ResultsError::File { file, error })?;
        let said = format!("{date}, {machine}");
        if !seen.contains(&said) {
            seen.push(said);
        }
    }
    Ok(seen)
}

/// What our own side costs.
///
/// # Errors
/// As [`candidates`].
pub fn ours() -> Result<Ours, ResultsError> {
    let file = "ours.json";
    serde_json::from_str(OURS).map_err(|error| ResultsError::File { file, error })
}

/// The tasks that somebody sat, in the order of the exam, with how long a motion lasts.
///
/// # Errors
/// As [`candidates`].
pub fn tasks() -> Result<Vec<(&'static str, f64)>, ResultsError> {
    let all = candidates()?;
    let lasts = |id: &str| {
        let mut runs = all.iter().flat_map(|candidate| &candidate.runs);
        runs.find(|run| run.task == id).map(|run| run.simulated)
    };
    let found = TASKS
        .iter()
        .filter_map(|task| Some((task.id, lasts(task.id)?)));
    Ok(found.collect())
}

impl Candidate {
    /// Its runs of a task, from the coarsest on; none where it gave up or did not sit.
    ///
    /// # Errors
    /// [`ResultsError::Task`] if the exam has no such task with a number.
    pub fn marks(&self, task: &str) -> Result<Vec<Mark>, ResultsError> {
        let none = || ResultsError::Task(task.to_owned());
        let asked = TASKS
            .iter()
            .find(|asked| asked.id == task)
            .ok_or_else(none)?;
        let Answer::Number(right) = asked.by_motion()? else {
            return Err(none());
        };
        let runs = self.runs.iter().filter(|run| run.task == task);
        let mark = |run: &Run| {
            Some(Mark {
                knob: run.knob,
                error: (run.answer? - right).abs(),
                cost: run.cpu? / run.simulated,
            })
        };
        Ok(runs.filter_map(mark).collect())
    }
}

/// The smallest error that two runs in a row keep within, at the knob and the cost of the finer one: an error that passes zero
/// on its way from one sign to the other is luck. A single run counts as it is.
pub fn kept(marks: &[Mark]) -> Option<Mark> {
    let pairs = marks.windows(2).map(|pair| Mark {
        error: pair[0].error.max(pair[1].error),
        ..pair[1]
    });
    let best = pairs.min_by(|a, b| a.error.total_cmp(&b.error));
    best.or(marks.first().copied())
}

/// What it costs to be within `error`: the cheapest run that is, together with the next finer one if there is one; nothing
/// where none is.
pub(crate) fn cost_within(marks: &[Mark], error: f64) -> Option<f64> {
    let within = |n: usize| marks.get(n).is_none_or(|mark| mark.error <= error);
    let fit = (0..marks.len()).filter(|n| within(*n) && within(n + 1));
    fit.map(|n| marks[n].cost).min_by(f64::total_cmp)
}

/// The order at which errors fall: the median of the last three slopes of their logarithm over that of the knob; nothing
/// where they do not fall, or are at rounding.
pub fn order(marks: &[Mark]) -> Option<f64> {
    let slope = |pair: &[Mark]| {
        let (errors, knobs) = (pair[0].error / pair[1].error, pair[0].knob / pair[1].knob);
        (pair[1].error > 1e-14).then(|| libm::log(errors) / libm::log(knobs))
    };
    let mut slopes: Vec<f64> = marks.windows(2).rev().filter_map(slope).take(3).collect();
    slopes.sort_by(f64::total_cmp);
    slopes
        .get(slopes.len() / 2)
        .copied()
        .filter(|order| *order > 0.15)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_run_is_of_a_task_with_a_number() {
        let all = candidates().unwrap();
        assert!(all.len() >= 10);
        for candidate in &all {
            let mut of_the_exam = 0;
            for (task, _) in tasks().unwrap() {
                of_the_exam += candidate.marks(task).unwrap().len();
            }
            let sat = candidate
                .runs
                .iter()
                .filter(|run| run.answer.is_some())
                .count();
            assert_eq!(of_the_exam, sat, "{}", candidate.name);
        }
        assert!(all[0].marks("orders").is_err() && all[0].marks("none").is_err());
    }

    /// What the scripts measured their errors against.
    #[test]
    fn the_scripts_have_the_answers_of_today() {
        let text = include_str!("../../benches/exam/exam.json");
        let written: serde_json::Value = serde_json::from_str(text).unwrap();
        for (task, _) in tasks().unwrap() {
            let known = TASKS.iter().find(|known| known.id == task).unwrap();
            let mut all = written["tasks"].as_array().unwrap().iter();
            let there = all.find(|there| there["task"] == task).unwrap();
            let Answer::Number(now) = known.sit().unwrap().answer else {
                panic!("{task}")
            };
            assert!(
                (there["answer"].as_f64().unwrap() - now).abs() < 1e-12,
                "{task}"
            );
        }
    }

    #[test]
    fn our_side_was_timed_on_all_tasks_of_today() {
        let timed: Vec<_> = ours().unwrap().seconds.into_keys().collect();
        let mut ids: Vec<_> = TASKS.iter().map(|task| task.id).collect();
        ids.sort_unstable();
        assert_eq!(timed, ids);
    }

    #[test]
    fn luck_is_no_accuracy() {
        let mark = |error| Mark {
            knob: 1.0,
            error,
            cost: error,
        };
        let marks = [0.4, 0.2, 1e-9, 0.1, 0.15, 0.3].map(mark);
        let best = kept(&marks).unwrap();
        assert_eq!((best.error, best.cost), (0.1, 0.1));
        assert_eq!(kept(&marks[..1]).unwrap().error, 0.4);
        assert_eq!(kept(&[]), None);
        assert_eq!(cost_within(&marks, 0.2), Some(1e-9));
        assert_eq!(cost_within(&marks, 1e-8), None);
        assert_eq!(cost_within(&marks[..2], 0.3), Some(0.2));
    }

    #[test]
    fn the_order_is_that_of_a_power() {
        let marks = |power: f64| -> Vec<Mark> {
            let knob = |n: i32| libm::exp2(-f64::from(n));
            let mark = |n| Mark {
                knob: knob(n),
                error: 0.3 * libm::pow(knob(n), power),
                cost: 1.0,
            };
            (0..6).map(mark).collect()
        };
        assert!((order(&marks(2.0)).unwrap() - 2.0).abs() < 1e-12);
        assert_eq!(order(&marks(0.0)), None);
        assert_eq!(order(&marks(1.0)[..1]), None);
    }
}
