//! The command as its users meet it.

use std::fs;
use std::process::{Command, Output};

fn slipbook(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_slipbook"));
    command.args(arguments).output().unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

#[test]
fn the_main_job_prints_the_ledger_and_writes_the_book() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("a book");
    let output = slipbook(&["--out", out.to_str().unwrap()]);
    let (said, complained) = (text(&output.stdout), text(&output.stderr));
    assert_eq!(output.status.code(), Some(0), "{said}\n{complained}");
    for line in [
        "Section 2.1",
        "  eq-13 ",
        "198 claims: ",
        "198 of 198 verdicts as recorded",
    ] {
        assert!(said.contains(line), "no `{line}` in\n{said}");
    }
    assert_eq!(complained, "", "progress shows on a terminal only");
    let page = fs::read_to_string(out.join("index.html")).unwrap();
    assert!(page.contains("Slipbook"));
    assert!(said.contains(out.join("index.html").to_str().unwrap()));
}

#[test]
fn a_folder_that_cannot_be_written_is_named_and_nothing_is_left() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("file");
    fs::write(&file, "mine").unwrap();
    for out in [file.clone(), file.join("below")] {
        let output = slipbook(&["--out", out.to_str().unwrap()]);
        assert_eq!(output.status.code(), Some(2));
        assert!(text(&output.stderr).contains(out.to_str().unwrap()));
    }
    assert_eq!(fs::read_to_string(&file).unwrap(), "mine");
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[test]
fn a_folder_with_something_else_in_it_is_left_alone() {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("thesis.tex"), "mine").unwrap();
    let output = slipbook(&["--out", folder.path().to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(2));
    assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
}

#[test]
fn bad_usage_is_exit_code_2_and_help_has_an_example() {
    assert_eq!(slipbook(&["--nonsense"]).status.code(), Some(2));
    let help = slipbook(&["--help"]);
    assert_eq!(help.status.code(), Some(0));
    assert!(text(&help.stdout).contains("Example"));
}
