//! `exam`: the tasks of the exam in dry friction with their answers, for the engines of others.

use crate::exam::{Answer, Basis, Sat, TASKS, Task};
use crate::numerics::error::plain as number;
use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use serde_json::{Map, Value, json as object};
use trialbook::cli::{VERSION, csv, json, show};
use trialbook::publishing::{Failure, Format};

/// Which tasks.
#[derive(Debug, Args)]
pub(super) struct Exam {
    /// Names of tasks; all if none is given
    #[arg(value_name = "TASK", value_parser = names().try_map(|name| task(&name)), hide_possible_values = true)]
    tasks: Vec<&'static Task>,
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
                    "given",
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

fn basis(basis: Basis) -> &'static str {
    match basis {
        Basis::Certified => "certified",
        Basis::Integrated => "integrated",
    }
}

/// The numbers of the set-up.
fn given(task: &Task) -> String {
    let given: Vec<_> = task
        .given
        .iter()
        .map(|(name, x)| format!("{name} = {}", number(*x)))
        .collect();
    given.join(", ")
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
        basis(sat.basis)
    )
}

fn value(task: &Task, sat: &Sat) -> Value {
    let given: Map<_, _> = task
        .given
        .iter()
        .map(|(name, x)| ((*name).to_owned(), object!(x)))
        .collect();
    object!({
        "task": task.id,
        "setup": task.setup,
        "given": given,
        "question": task.question,
        "answer": sat.answer,
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
        given(task),
        task.question.to_owned(),
        answer(&sat.answer),
        task.unit.to_owned(),
        error(sat),
        basis(sat.basis).to_owned(),
        answer(&sat.motion),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

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
        assert_eq!(row[..3], [task.id, &given(task), task.question]);
        assert_eq!(row[3..], ["0.25", "v₀/A", "2.0e-3", "certified", "0.5"]);
        let value = value(task, &sat);
        let mut expected = object!({
            "task": task.id,
            "setup": task.setup,
            "given": {},
            "question": task.question,
            "answer": 0.25,
            "unit": "v₀/A",
            "error": 2e-3,
            "basis": "certified",
            "by_motion": 0.5,
        });
        for (name, given) in task.given {
            expected["given"][*name] = object!(given);
        }
        assert_eq!(value, expected);
        assert!(text(task, &sat).ends_with("0.25 v₀/A   (certified within 2.0e-3)"));
    }
}
