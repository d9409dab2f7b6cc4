//! `exam`: the tasks of the exam in dry friction with their answers, for people and for the engines of others.

use crate::book;
use crate::exam::{Answer, Sat, TASKS, Task, package};
use crate::numerics::error::plain as number;
use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use serde_json::{Value, json as object};
use std::path::PathBuf;
use trialbook::cli::{VERSION, csv, json, show};
use trialbook::publishing::{Failure, Format};

/// Which tasks.
#[derive(Debug, Args)]
pub(super) struct Exam {
    /// Names of tasks; all if none is given
    #[arg(value_name = "TASK", value_parser = names().try_map(|name| task(&name)), hide_possible_values = true)]
    tasks: Vec<&'static Task>,
    /// Write all tasks into a folder of JSON for a program that grades an engine; an earlier one there is replaced as a whole
    #[arg(long, value_name = "FOLDER", conflicts_with_all = ["tasks", "json", "csv"])]
    package: Option<PathBuf>,
}

/// The names of the tasks: the shells complete them, and the nearest one is proposed for a wrong one.
fn names() -> PossibleValuesParser {
    PossibleValuesParser::new(TASKS.iter().map(|task| task.id))
}

fn task(name: &str) -> Result<&'static Task, &'static str> {
    let found = TASKS.iter().find(|task| task.id == name);
    found.ok_or("no such task")
}

impl Exam {
    pub(super) fn run(&self, format: Format) -> Result<u8, Failure> {
        if let Some(folder) = &self.package {
            let written = book::folder(folder, "slipbook-exam", &package::files()?)?;
            show(&format!("{}", written.display()))?;
            return Ok(0);
        }
        let wanted = match &self.tasks[..] {
            [] => TASKS.iter().collect(),
            some => some.to_vec(),
        };
        let sat: Result<Vec<_>, Failure> = wanted
            .into_iter()
            .map(|task| Ok((task, task.sit()?)))
            .collect();
        let sat = sat?;
        match format {
            Format::Text => {
                let parts: Vec<_> = sat.iter().map(|(task, sat)| text(task, sat)).collect();
                show(&parts.join("\n\n"))?;
            }
            Format::Json => {
                let tasks: Vec<_> = sat.iter().map(|(task, sat)| value(task, sat)).collect();
                json(&object!({ "version": VERSION, "tasks": tasks }))?;
            }
            Format::Csv => {
                let head = [
                    "task",
                    "scene",
                    "question",
                    "answer",
                    "unit",
                    "error",
                    "basis",
                    "by_motion",
                ];
                csv(&head, sat.iter().map(|(task, sat)| row(task, sat)))?;
            }
        }
        Ok(0)
    }
}

fn error(sat: &Sat) -> String {
    sat.error
        .map_or(String::new(), |error| format!("{error:.1e}"))
}

fn text(task: &Task, sat: &Sat) -> String {
    let within = match sat.error {
        Some(error) => format!(" within {error:.1e}"),
        None => String::new(),
    };
    format!(
        "{}\n{}\n{}\n  {}   ({}{within})",
        task.id,
        task.setup,
        task.question,
        format!("{} {}", sat.text(), task.unit).trim_end(),
        sat.basis.name()
    )
}

fn value(task: &Task, sat: &Sat) -> Value {
    object!({
        "task": task.id,
        "setup": task.setup,
        "scene": package::scene(&task.posed),
        "protocol": package::protocol(&task.posed),
        "ask": task.posed.ask,
        "question": task.question,
        "answer": sat.answer,
        "interval": sat.interval(),
        "unit": task.unit,
        "error": sat.error,
        "basis": sat.basis,
        "by_motion": sat.motion,
    })
}

fn row(task: &Task, sat: &Sat) -> Vec<String> {
    let answer = |answer: &Answer| match answer {
        Answer::Number(x) => number(*x),
        Answer::Order(order) => order.clone(),
    };
    vec![
        task.id.to_owned(),
        task.posed.scene.to_owned(),
        task.question.to_owned(),
        answer(&sat.answer),
        task.unit.to_owned(),
        error(sat),
        sat.basis.name().to_owned(),
        answer(&sat.motion),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::exam::Basis;

    #[test]
    fn the_answer_and_that_of_the_motion_keep_their_names() {
        let sat = Sat {
            answer: Answer::Number(0.25),
            error: Some(2e-3),
            basis: Basis::Certified,
            motion: Answer::Number(0.5),
        };
        let task = &TASKS[0];
        let row = row(task, &sat);
        assert_eq!(row[..3], [task.id, task.posed.scene, task.question]);
        assert_eq!(row[3..], ["0.25", "v₀/A", "2.0e-3", "certified", "0.5"]);
        let value = value(task, &sat);
        let expected = object!({
            "task": task.id,
            "setup": task.setup,
            "scene": { "body": "block", "mu": 1.5, "g": 1.0, "pull": 1.0, "throw": "1@1.5707963267948966", "until": "stop" },
            "protocol": { "settle": 0.5, "window": null, "scan": null },
            "ask": "t",
            "question": task.question,
            "answer": 0.25,
            "interval": [0.248_f64.next_down(), 0.252_f64.next_up()],
            "unit": "v₀/A",
            "error": 2e-3,
            "basis": "certified",
            "by_motion": 0.5,
        });
        assert_eq!(value, expected);
        assert!(text(task, &sat).ends_with("0.25 v₀/A   (certified within 2.0e-3)"));
    }
}
