//! What people ask, with the answers as they are computed: `book/questions.toml` as a page.

use super::explorer::TEXTS;
use crate::commands::answered;
use crate::numerics::{error::plain, expression::expression};
use rayon::prelude::*;
use serde::Deserialize;
use serde_json::Value;
use std::fs;
use trialbook::book::{code, table};
use trialbook::data::text;
use trialbook::publishing::{Failure, Filled, Format};

fn recording(name: &str) -> bool {
    [".csv", ".AT2"].iter().any(|end| name.ends_with(end))
}

#[derive(Deserialize)]
struct Asked {
    question: Vec<Question>,
}

/// A question: the head of the file says what its parts are.
#[derive(Deserialize)]
struct Question {
    part: Option<[String; 2]>,
    id: String,
    title: String,
    asked: String,
    kind: String,
    source: String,
    url: String,
    command: String,
    held: Vec<String>,
    why: String,
}

fn asked(command: &str, format: Format) -> Result<Value, Failure> {
    let folder = tempfile::tempdir()?;
    for (name, text) in TEXTS.iter().filter(|(name, _)| recording(name)) {
        fs::write(folder.path().join(name), text.as_str())?;
    }
    let parts = command.split('\'').enumerate();
    let words = parts.flat_map(|(i, part)| match i % 2 {
        0 => part.split_whitespace().collect(),
        _ => vec![part],
    });
    let words = words.skip(1).map(|word| match recording(word) {
        true => folder.path().join(word).to_string_lossy().into_owned(),
        false => word.to_owned(),
    });
    answered(&words.collect::<Vec<_>>(), format)
}

pub(super) fn one(command: &str) -> Result<Filled, Failure> {
    let answer = asked(command, Format::Text)?;
    let lines = format!("$ {command}\n{}", answer.as_str().unwrap_or_default());
    Ok(Filled::Block(code(&lines)))
}

pub(super) fn all(_: &str) -> Result<Filled, Failure> {
    let text = text!("book/questions.toml");
    let questions: Asked = toml::from_str(text.read()?)?;
    let html = questions.question.par_iter().map(|one| {
        let answer = asked(&one.command, Format::Json);
        let html = answer.and_then(|answer| one.html(&answer));
        html.map_err(|error| format!("{}: {error}", one.id).into())
    });
    html.collect::<Result<String, Failure>>().map(Filled::Block)
}

fn heading(level: u8, id: &str, text: &str) -> String {
    format!("<h{level} id=\"{id}\"><a class=\"header\" href=\"#{id}\">{text}</a></h{level}>\n")
}

impl Question {
    fn html(&self, answer: &Value) -> Result<String, Failure> {
        let part = self.part.iter().map(|[id, name]| heading(2, id, name));
        let part: String = part.collect();
        let rows = self
            .held
            .iter()
            .map(|held| row(answer, held).ok_or_else(|| format!("no `{held}` in {answer}")));
        let rows: Vec<_> = rows.collect::<Result<_, _>>()?;
        Ok(format!(
            "{part}{}<p>{}</p>\n{}<pre><code class=\"language-text\">{}</code></pre>\n<p>{} {} Source: <a href=\"{}\">{}</a> ({}).</p>\n",
            heading(3, &format!("asked-{}", self.id), &self.title),
            self.asked,
            table("asked", ["What", "Answer", "Otherwise"], rows),
            self.command,
            film(answer, &self.command).unwrap_or_default(),
            self.why,
            self.url,
            self.source,
            self.kind,
        ))
    }
}

/// Its name, its value, and what it is otherwise.
fn row(answer: &Value, held: &str) -> Option<[String; 3]> {
    let (name, other) = held.split_once(' ')?;
    let path = name.replace('.', "/");
    let of_scene = answer.pointer(&format!("/answer/{path}"));
    let found = match of_scene.or_else(|| answer.pointer(&format!("/{path}")))? {
        Value::Array(ends) => {
            let ends = ends.iter().filter_map(Value::as_f64);
            let ends: Vec<_> = ends.map(|x| format!("{x:.3}")).collect();
            ends.join(" to ")
        }
        number => rounded(number.as_f64()?),
    };
    let unit = &answer["units"][name.rsplit('.').next()?];
    let unit = answer["unit"].as_str().or(unit.as_str());
    let name = answer["find"].as_str().unwrap_or(name);
    let other = other.split(' ').next()?;
    let value = rounded(expression(other, |digits| digits.parse::<f64>().ok()).ok()?);
    let other = match other.parse::<f64>() {
        Ok(_) => value,
        Err(_) => format!("{value} = <code>{other}</code>"),
    };
    let found = format!("<strong>{found}</strong>&nbsp;{}", unit.unwrap_or_default());
    Some([format!("<code>{name}</code>"), found, other])
}

/// A number with the digits that a scene has at most.
fn rounded(x: f64) -> String {
    plain(format!("{x:.11e}").parse().unwrap_or(x)).replace('-', "−")
}

/// The way to where it is seen, without a recording.
fn film(answer: &Value, command: &str) -> Option<String> {
    let mut scene = command.to_owned();
    if let Some((before, _)) = command.split_once(" --find ") {
        let (word, unit) = (answer["find"].as_str()?, answer["unit"].as_str()?);
        let x = answer["solutions"][0].as_f64()?;
        scene = format!("{before} --{word} {}{unit}", plain(x));
    }
    let line = scene.replace(' ', "%20").replace('\'', "%27");
    let link = format!("<a href=\"scenes.html#own?{line}\">▶ See it.</a>");
    (!command.split(' ').any(recording)).then_some(link)
}
