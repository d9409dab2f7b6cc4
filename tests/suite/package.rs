//! The exam as a folder: whole, readable by the commands, and enough for a grader in another language.

use crate::{check_success, slipbook};
use serde_json::Value;
use slipbook::exam::{TASKS, posed::FIELDS};
use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;
use tempfile::TempDir;

fn written() -> (TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("new/exam");
    let output = slipbook(&["exam", "--package", out.to_str().unwrap()]);
    assert_eq!(check_success(&output), Ok(()));
    (folder, out)
}

fn read(out: &Path, name: &str) -> Value {
    serde_json::from_str(&fs::read_to_string(out.join(name)).unwrap()).unwrap()
}

#[test]
fn every_task_is_a_file_with_a_scene_and_an_answer() {
    let (_folder, out) = written();
    let ids = TASKS.iter().map(|task| task.id);
    let ids: Vec<_> = ids.chain(FIELDS.iter().map(|field| field.id)).collect();
    let files: Vec<_> = ids.iter().map(|id| format!("{id}.json")).collect();
    let list = read(&out, "exam.json");
    assert_eq!(list["files"], Value::from(files.clone()));
    let page = fs::read_to_string(out.join("README.md")).unwrap();
    let told = |name: &str| assert!(page.contains(&format!("`{name}`")), "{name}");
    let mut cells = 0;
    for (id, name) in ids.iter().zip(files) {
        let task = read(&out, &name);
        assert_eq!(task["task"], *id);
        told(task["ask"].as_str().unwrap());
        for part in ["scene", "protocol"] {
            task[part]
                .as_object()
                .unwrap()
                .keys()
                .for_each(|name| told(name));
        }
        let number = task["ask"] != "order";
        let holds = |answer: &Value| match number {
            true => answer[0].as_f64().unwrap() <= answer[1].as_f64().unwrap(),
            false => answer.as_str().unwrap().starts_with('F'),
        };
        let field = FIELDS.iter().any(|field| field.id == *id);
        assert!(
            task["answer"].is_null() == field && (field || holds(&task["answer"])),
            "{id}"
        );
        for cell in task["cells"].as_array().unwrap() {
            cells += 1;
            assert!(holds(&cell["answer"]), "{id}");
            for (name, x) in cell["at"].as_object().unwrap() {
                assert!(
                    task["grid"][name].as_array().unwrap().contains(x),
                    "{id} {name}"
                );
            }
        }
    }
    assert!(cells > 100, "{cells}");
    let creep = out.join("slip-time.json");
    let output = slipbook(&["scene", creep.to_str().unwrap(), "--json"]);
    assert_eq!(check_success(&output), Ok(()));
    let answer: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert!((answer["answer"]["t"].as_f64().unwrap() - 2.0 / 7.0).abs() < 1e-11);
}

#[test]
fn what_is_not_ours_stays_and_what_is_goes_as_a_whole() {
    let (_folder, out) = written();
    fs::write(out.join("old.json"), "").unwrap();
    let again = slipbook(&["exam", "--package", out.to_str().unwrap()]);
    assert_eq!(check_success(&again), Ok(()));
    assert!(!out.join("old.json").exists() && out.join("exam.json").exists());
    for file in ["thesis", ".slipbook"] {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join(file), "").unwrap();
        let refused = slipbook(&["exam", "--package", folder.path().to_str().unwrap()]);
        assert_eq!(refused.status.code(), Some(2));
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }
}

#[test]
fn the_example_grades_a_block_in_python() {
    if Command::new("python3").arg("--version").output().is_err() {
        // Not captured, as what `eprintln!` says would be.
        writeln!(
            std::io::stderr(),
            "skipped: there is no python3 to grade with"
        )
        .unwrap();
        return;
    }
    let (_folder, out) = written();
    let graded = |step: &str| -> Vec<Value> {
        let output = Command::new("python3")
            .arg(out.join("grade.py"))
            .arg(step)
            .output()
            .unwrap();
        assert_eq!(check_success(&output), Ok(()));
        let lines = String::from_utf8(output.stdout).unwrap();
        lines
            .lines()
            .map(|line| serde_json::from_str(line).unwrap())
            .collect()
    };
    let worst = |marks: &[Value], task: &str| {
        let errors = marks.iter().filter(|mark| mark["task"] == task);
        errors
            .map(|mark| mark["error"].as_f64().unwrap())
            .fold(0.0, f64::max)
    };
    let [coarse, fine] = ["0.01", "0.001"].map(graded);
    assert!(fine.len() == coarse.len() && fine.len() > 40);
    // It holds, and stops the nearer the smaller its steps are.
    for marks in [&coarse, &fine] {
        assert_eq!(worst(marks, "creep"), 0.0);
    }
    let [far, near] = [&coarse, &fine].map(|marks| worst(marks, "stop-place"));
    assert!(near < 0.2 * far && near > 0.0, "{far} {near}");
    assert!(fine.iter().all(|mark| mark["right"] == true));
    assert!(coarse.iter().any(|mark| mark["right"] == false));
}
