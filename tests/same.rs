//! The same results everywhere: in two runs, on one thread and on many, in the debug and in the release profile.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Command;

/// What the main job says as JSON, and every file of the book that it writes.
fn run(jobs: &str) -> (String, BTreeMap<String, Vec<u8>>) {
    let folder = tempfile::tempdir().unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_slipbook"))
        .args(["--json", "--out", "book", "--jobs", jobs])
        .current_dir(folder.path())
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(0), "on {jobs} threads");
    let mut files = BTreeMap::new();
    read(&folder.path().join("book"), "", &mut files);
    // The address of the book is the only thing that may differ.
    let said = String::from_utf8(output.stdout).unwrap();
    let (ledger, _) = said.split_once("\"book\": ").unwrap();
    (ledger.to_owned(), files)
}

fn read(folder: &Path, below: &str, files: &mut BTreeMap<String, Vec<u8>>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = format!("{below}/{}", path.file_name().unwrap().to_str().unwrap());
        if path.is_dir() {
            read(&path, &name, files);
        } else {
            files.insert(name, fs::read(&path).unwrap());
        }
    }
}

#[test]
fn one_thread_and_many_give_the_same_ledger_and_the_same_book() {
    let (ledger, book) = run("1");
    let (other_ledger, other_book) = run("4");
    assert!(ledger.contains("\"eq-147\"") && ledger == other_ledger);
    assert!(book.keys().any(|name| name.ends_with(".csv")));
    let names = |book: &BTreeMap<String, Vec<u8>>| book.keys().cloned().collect::<Vec<_>>();
    assert_eq!(names(&book), names(&other_book));
    let differ = book
        .iter()
        .filter(|(name, bytes)| other_book[*name] != **bytes);
    let differ: Vec<_> = differ.map(|(name, _)| name).collect();
    assert!(differ.is_empty(), "{differ:?}");
}

/// The figures are the recorded ones, to the byte, in whatever profile and on whatever machine this runs. The sheets
/// are so too: `snapshots` has them as they are.
#[test]
fn the_figures_are_the_recorded_ones() {
    let figures = slipbook::figures::all().unwrap();
    let line = |id: &str, kind: &str, text: &str| format!("{id} {kind} {:016x}\n", fnv1a(text));
    let lines = figures
        .iter()
        .map(|f| line(f.id, "csv", &f.csv) + &line(f.id, "svg", &f.svg));
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(concat!(env!("CARGO_MANIFEST_DIR"), "/snapshots"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!("figures", lines.collect::<String>()));
}

/// The Fowler–Noll–Vo hash of 64 bits: enough to see a change, and the same in every version of Rust.
fn fnv1a(text: &str) -> u64 {
    text.bytes().fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
    })
}
