//! The book's page on JSON holds of what the commands write: every field is described, with its type, and every
//! described field is written.

use serde_json::Value;
use std::collections::{BTreeMap, BTreeSet};
use trialbook::cli::described;
use trialbook::data::{Text, text};

const PAGE: Text = text!("book/src/json.md");

type Shape = BTreeMap<String, BTreeSet<String>>;

struct Section {
    id: String,
    commands: Vec<String>,
    described: Shape,
}

fn sections() -> Vec<Section> {
    let all = described(&PAGE, "slipbook").into_iter();
    all.map(|section| Section {
        id: section.id,
        commands: section.commands,
        described: section
            .fields
            .into_iter()
            .map(|field| (field.path, field.types.into_iter().collect()))
            .collect(),
    })
    .collect()
}

fn note(shape: &mut Shape, path: &str, value: &Value) {
    let (kind, inside): (_, Vec<(String, &Value)>) = match value {
        Value::Null => ("null", vec![]),
        Value::Bool(_) => ("boolean", vec![]),
        Value::Number(_) => ("number", vec![]),
        Value::String(_) => ("string", vec![]),
        Value::Array(list) => {
            let objects = list.iter().filter_map(Value::as_object).flatten();
            (
                "array",
                objects.map(|(k, v)| (format!("{path}[].{k}"), v)).collect(),
            )
        }
        Value::Object(_) => ("object", vec![]),
    };
    shape
        .entry(path.to_owned())
        .or_default()
        .insert(kind.to_owned());
    for (path, value) in inside {
        note(shape, &path, value);
    }
}

fn written(command: &str) -> Value {
    let words = command.strip_prefix("slipbook ").unwrap_or(command);
    let words: Vec<_> = words.split(' ').collect();
    let output = crate::slipbook(&words);
    // 1 where a recording has no slip.
    assert!(output.status.code() < Some(2), "{command}");
    serde_json::from_slice(&output.stdout).unwrap()
}

#[test]
fn every_field_is_described_and_every_described_field_is_written() {
    let sections = sections();
    let common = &sections
        .iter()
        .find(|s| s.commands.is_empty())
        .unwrap()
        .described;
    let mut of_all = Shape::new();
    for section in sections.iter().filter(|s| !s.commands.is_empty()) {
        let mut described = section.described.clone();
        let mut shape = Shape::new();
        for command in &section.commands {
            let value = written(command);
            let object = value.as_object().unwrap();
            object
                .iter()
                .for_each(|(name, value)| note(&mut shape, name, value));
            if object.contains_key("by_formula") {
                described.extend(common.clone());
                let ways = ["by_formula", "by_motion"]
                    .iter()
                    .filter_map(|way| object[*way].as_object());
                for way in ways {
                    let names: BTreeSet<_> = way.keys().collect();
                    assert_eq!(names, section.described.keys().collect(), "{command}");
                }
            }
        }
        for (path, kinds) in &described {
            let found = shape.remove(path).unwrap_or_default();
            let common = common.contains_key(path);
            if common {
                let kinds = found.iter().cloned();
                of_all.entry(path.clone()).or_default().extend(kinds);
            }
            assert!(!found.is_empty(), "{}: {path} is never written", section.id);
            assert!(
                found.is_subset(kinds),
                "{}: {path} is {found:?}",
                section.id
            );
            assert!(
                common || found == *kinds,
                "{}: {path} is never all of {kinds:?}",
                section.id
            );
        }
        assert!(shape.is_empty(), "{}: not described: {shape:?}", section.id);
    }
    // Whether it is null anywhere is left open.
    for (path, kinds) in common {
        let found = of_all.remove(path).unwrap_or_default();
        let mut missing = kinds.difference(&found);
        assert!(
            missing.all(|kind| kind == "null"),
            "{path} is only {found:?}"
        );
    }
}

#[test]
fn places_are_counted_as_the_page_says() {
    let found = written("find 0.53701 --json");
    let best = &found["matches"][0];
    assert_eq!(
        (&best["right"], &best["first_wrong"]),
        (&4.into(), &5.into())
    );
    let column = best["column"].as_u64().unwrap() as usize;
    assert_eq!(&found["number"].as_str().unwrap()[column..], "1");
    // The angle of (124) is found by iteration, and every mistake in it is noticed.
    let distrusted = written("distrust eq-124 --json");
    let mistakes = distrusted["mistakes"].as_array().unwrap().iter();
    let own = mistakes.enumerate().filter(|(_, m)| m["claim"] == "eq-124");
    let own: Vec<Value> = own.map(|(place, _)| place.into()).collect();
    let own = Value::from(own);
    let mut trials = distrusted["trials"].as_array().unwrap().iter();
    assert!(trials.any(|trial| trial["rejects"] == own), "{own}");
    assert!(own.as_array().unwrap().len() > 10);
}

#[test]
fn answers_at_special_points_have_the_types_described() {
    let sections = sections();
    let mut asked = 0;
    for line in [
        "sinusoidal --lambda0 2/sqrt(4+pi^2)",
        "sinusoidal --lambda0 2/sqrt(4+pi^2)+1e-30",
        "sinusoidal --lambda0 0.53702927214631508",
        "sinusoidal --lambda0 1-1e-20",
        "pulse --eta 1/3 --lambda0 1/3",
        "pulse --eta 1/3 --lambda0 1/3+1e-31",
        "pulse --eta 1e-300 --lambda0 0.5",
        "pulse --eta 1e-12 --lambda0 0.5",
        "pulse --eta 1e-6 --lambda0 1e-6",
        "pulse --eta 0 --lambda0 0.5",
        "pulse --eta 1 --lambda0 1",
        "anisotropic --q 1 --lambda0 2/sqrt(4+pi^2)",
        "anisotropic --q 1+1e-28 --lambda0 0.5",
        "anisotropic --q 4.603338848751700 --lambda0 1/4.603338848751700",
        "anisotropic --q 2 --lambda0 0.5",
        "anisotropic --q 0.5 --lambda0 1",
        "sphere --gamma 3.5 --u0 1 --theta0 pi --time 5",
        "sphere --gamma 3.5 --u0 1 --theta0 0 --time 5",
        "sphere --gamma 9 --u0 1 --theta0 pi --time 1/12.5",
        "sphere --gamma 4 --kappa 1/3 --u0 1 --theta0 1 --time 5",
        "constant --lambda 0 --v0 1 --theta0 pi --time 1",
        "constant --lambda 0.25 --v0 1 --theta0 pi --time 0.8",
        "constant --lambda 1 --v0 1 --theta0 pi --time 0.5",
        "constant --lambda 1.5 --v0 1 --theta0 pi/2 --time 1.2",
        "turntable --rho 1 --p 0 --psi 0",
        "turntable --rho 1 --p 1 --psi pi",
        "turntable --A 1 --alpha 0 --psi 0",
        "turntable --rho 1 --p 0 --psi 0 --time 1",
        "turntable --x 0 --y 0 --vx 0 --vy 0 --time 2",
        "turntable-boundary --alpha 0 --psi pi",
    ] {
        let problem = line.split(' ').next().unwrap();
        let id = match line.contains("--time") && problem == "turntable" {
            true => "solve-turntable-time".to_owned(),
            false => format!("solve-{problem}"),
        };
        let mut found = sections.iter();
        let section = found.find(|s| s.id == id).unwrap();
        let answer = written(&format!("solve {line} --json"));
        for (name, kinds) in &section.described {
            let mut shape = Shape::new();
            note(&mut shape, name, &answer[name]);
            assert!(
                shape[name].is_subset(kinds),
                "{line}: {name} is {}",
                answer[name]
            );
            asked += 1;
        }
        assert!(answer["digits"].as_u64().unwrap() >= 10, "{line}: {answer}");
    }
    assert!(asked > 100, "{asked}");
}
