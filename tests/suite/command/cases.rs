//! The command as cases: lines and their answers, in `cases.txt` to the letter, in `held.txt` as numbers from elsewhere.

use super::{json, text, words};
use crate::slipbook;
use serde_json::Value;
use slipbook::numerics::expression::expression;
use std::fs;

const CASES: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/suite/command/cases.txt");

fn cases(text: &str) -> Vec<(&str, String)> {
    let mut cases: Vec<(&str, String)> = Vec::new();
    for line in text.lines() {
        match cases.last_mut() {
            Some((_, below)) if !line.starts_with(['$', '#']) => *below += &format!("{line}\n"),
            _ => cases.push((line, String::new())),
        }
    }
    cases
}

/// The exit code if it is not 0, what is printed, and the first paragraph of what is said besides.
fn answer(line: &str) -> String {
    let mut parts = line.split(" | ");
    let words = words(parts.next().unwrap());
    let output = slipbook(&words[1..]);
    let (said, besides) = (text(&output.stdout), text(&output.stderr));
    // Excel takes other letters for several.
    let is_table = line.contains(" --csv") && ["solve", "ensemble", "scene"].contains(&words[1]);
    assert!(
        !is_table || said.is_ascii() && !said.contains('?'),
        "{said}"
    );
    let mut lines: Vec<_> = said.lines().map(str::to_owned).collect();
    for filter in parts {
        match filter.split_once(' ') {
            Some(("grep", word)) => lines.retain(|line| line.contains(word.trim_matches('\''))),
            Some(("head", count)) => lines.truncate(count[1..].parse().unwrap()),
            _ => panic!("`{filter}` is no filter"),
        }
    }
    let code = output.status.code().filter(|code| *code != 0);
    let besides = besides.lines().take_while(|line| !line.is_empty());
    let besides = besides.filter(|line| !line.contains("[possible values"));
    code.map(|code| format!("? {code}"))
        .into_iter()
        .chain(lines)
        .chain(besides.map(|line| format!("! {line}")))
        .map(|line| {
            line.replace(
                concat!("slipbook ", env!("CARGO_PKG_VERSION")),
                "slipbook VERSION",
            ) + "\n"
        })
        .collect()
}

#[test]
fn every_line_has_its_answer() {
    let (mut now, mut wrong) = (String::new(), Vec::new());
    for (line, below) in cases(&fs::read_to_string(CASES).unwrap()) {
        let found = line.strip_prefix("$ ").map_or(String::new(), answer);
        if found.trim_end() != below.trim_end() {
            wrong.push(format!(
                "{line}\nhas to be answered\n{below}and is\n{found}"
            ));
        }
        let gap = if format!("\n{below}").ends_with("\n\n") {
            "\n"
        } else {
            ""
        };
        now += &format!("{line}\n{found}{gap}");
    }
    if std::env::var("INSTA_UPDATE").is_ok_and(|update| update == "always") {
        return fs::write(CASES, now).unwrap();
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

fn is_held(answer: &Value, row: &str) -> bool {
    let (name, wanted) = row.split_once(' ').unwrap();
    let place = format!("/{}", name.replace('.', "/"));
    let of_scene = answer.pointer(&format!("/answer{place}"));
    // A scene has twelve digits, a calculator fifteen.
    let rounding = if answer["scene"].is_object() {
        1e-11
    } else {
        1e-12
    };
    let number = || {
        let (wanted, error) = wanted.split_once(" ±").unwrap_or((wanted, ""));
        let (wanted, unit) = wanted.split_once(' ').unwrap_or((wanted, ""));
        let number = expression(wanted, |decimal| decimal.parse::<f64>().ok());
        let number = number.unwrap_or_else(|_| panic!("{row}"));
        let error = error.parse().unwrap_or(rounding * number.abs());
        (number, error, unit)
    };
    match of_scene.or_else(|| answer.pointer(&place)) {
        None => false,
        Some(Value::Null) => wanted == "none",
        Some(Value::String(word)) => match wanted.strip_suffix('…') {
            Some(begin) => word.starts_with(begin),
            None => word == wanted,
        },
        Some(Value::Array(ends)) => {
            let (number, error, _) = number();
            let [from, to] = [0, 1].map(|i| ends[i].as_f64().unwrap() - number);
            -error <= from && from <= 0.0 && 0.0 <= to && to <= error
        }
        Some(found) => {
            let (number, error, unit) = number();
            (found.as_f64().unwrap() - number).abs() <= error
                && (unit.is_empty() || answer["units"][name] == unit)
        }
    }
}

#[test]
fn every_number_is_that_of_another_source() {
    let mut wrong = Vec::new();
    for (line, below) in cases(include_str!("held.txt")) {
        let Some(line) = line.strip_prefix("$ slipbook ") else {
            continue;
        };
        let answer = json(line);
        let of_calculator = line.starts_with("solve") && !below.contains("digits ");
        if of_calculator && answer["digits"].as_u64() < Some(11) {
            wrong.push(format!("{line}: {} digits", answer["digits"]));
        }
        let rows = below.lines().filter(|row| !row.is_empty());
        let rows = rows.filter(|row| !is_held(&answer, row));
        wrong.extend(rows.map(|row| format!("{line}: {row}, not as in {answer}")));
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn every_question_is_answered_rightly() {
    let file: toml::Table = toml::from_str(&text!("book/questions.toml")).unwrap();
    let questions = file["question"].as_array().unwrap();
    let mut kinds = String::new();
    for question in questions {
        let text = |name| question.get(name).and_then(|text| text.as_str()).unwrap();
        let answer = json(text("command").strip_prefix("slipbook ").unwrap());
        let held = question["held"].as_array().unwrap();
        let said = ["asked", "source", "why"]
            .iter()
            .all(|part| !text(part).is_empty());
        assert!(said && !held.is_empty(), "{question}");
        for row in held.iter().map(|row| row.as_str().unwrap()) {
            assert!(
                is_held(&answer, row),
                "{}: {row}, not as in {answer}",
                text("id")
            );
        }
        kinds += text("kind");
    }
    assert!(questions.len() >= 60);
    for (kind, least) in [
        ("textbook", 10),
        ("forum", 10),
        ("issue", 10),
        ("laboratory", 8),
    ] {
        assert!(kinds.matches(kind).count() >= least, "{kind}");
    }
}

#[test]
fn the_sketch_on_the_page_is_that_of_the_help() {
    let page = text!("book/src/scenes.md");
    let (_, sketch) = page.split_once("```text\n").unwrap();
    let help = text(&slipbook(&["scene", "--help"]).stdout);
    let mut lines = sketch.split("```").next().unwrap().lines();
    assert!(lines.all(|line| help.contains(line.trim())));
}
