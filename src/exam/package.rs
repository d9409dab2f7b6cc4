//! The exam as a folder of JSON, for who grades an engine in any language.

use super::posed::{Cell, FIELDS, Posed, SETTLE};
use super::{Answer, Basis, ExamError, TASKS};
use serde_json::{Map, Value, json};

/// Which description of the folder holds: it changes when a field goes or changes its meaning.
pub const VERSION: u32 = 1;

/// A word's text, which is a number where it can be, and `true` for a word that stands alone.
fn text(text: &str) -> Value {
    match text.parse::<f64>() {
        Ok(number) => json!(number),
        Err(_) if text.is_empty() => json!(true),
        Err(_) => json!(text),
    }
}

/// Its scene as `slipbook scene` reads it from a file.
pub fn scene(posed: &Posed) -> Value {
    let (body, words) = posed.words();
    let words = words.iter().map(|(name, of)| (*name, text(of)));
    object([("body", json!(body))].into_iter().chain(words))
}

/// How its scene is run.
pub fn protocol(posed: &Posed) -> Value {
    json!({ "settle": SETTLE, "window": posed.window, "scan": posed.scan })
}

fn object<'a>(fields: impl Iterator<Item = (&'a str, Value)>) -> Value {
    let fields = fields.map(|(name, value)| (name.to_owned(), value));
    Value::Object(fields.collect::<Map<_, _>>())
}

/// An interval, or an order.
fn answer(answer: &Answer, interval: Option<[f64; 2]>) -> Value {
    interval.map_or_else(|| json!(answer), |interval| json!(interval))
}

fn file(
    [id, question]: [&str; 2],
    posed: &Posed,
    own: Value,
    basis: Basis,
) -> Result<(String, String), ExamError> {
    let cells = posed.cells()?;
    let names = posed.grid.map_or(&[][..], |grid| grid.names);
    let values = |k: usize| {
        let mut values: Vec<_> = cells.iter().map(|cell| cell.at[k]).collect();
        values.sort_by(f64::total_cmp);
        values.dedup();
        json!(values)
    };
    let cell = |cell: &Cell| {
        let at = names.iter().zip(&cell.at);
        let words = cell.words.iter();
        json!({
            "at": object(at.map(|(name, x)| (*name, json!(x)))),
            "scene": object(words.map(|(name, of)| (*name, text(of)))),
            "answer": answer(&cell.answer, cell.interval),
        })
    };
    let whole = json!({
        "task": id,
        "question": question,
        "scene": scene(posed),
        "protocol": protocol(posed),
        "ask": posed.ask,
        "answer": own,
        "unit": posed.unit(),
        "basis": basis,
        "grid": object(names.iter().enumerate().map(|(k, name)| (*name, values(k)))),
        "cells": cells.iter().map(cell).collect::<Vec<_>>(),
    });
    Ok((format!("{id}.json"), format!("{whole:#}\n")))
}

/// The files of the folder, by their names.
///
/// Cost: every task is sat once, and every scene of a grid is run twice.
///
/// # Errors
/// [`ExamError`] where a task has no answer.
pub fn files() -> Result<Vec<(String, String)>, ExamError> {
    let tasks = TASKS.iter().map(|task| {
        let sat = task.sit()?;
        let own = answer(&sat.answer, sat.interval());
        file([task.id, task.question], &task.posed, own, sat.basis)
    });
    // Of a field, the cells are the answers.
    let fields = FIELDS.iter().map(|field| {
        let [id, question] = [field.id, field.question];
        file([id, question], &field.posed, Value::Null, Basis::Integrated)
    });
    let mut files = tasks.chain(fields).collect::<Result<Vec<_>, _>>()?;
    let names: Vec<_> = files.iter().map(|(name, _)| name.as_str()).collect();
    let slipbook = env!("CARGO_PKG_VERSION");
    let list = json!({ "version": VERSION, "slipbook": slipbook, "files": names });
    files.extend([
        ("exam.json".to_owned(), format!("{list:#}\n")),
        (
            "README.md".to_owned(),
            include_str!("package/README.md").to_owned(),
        ),
        (
            "grade.py".to_owned(),
            include_str!("package/grade.py").to_owned(),
        ),
    ]);
    Ok(files)
}
