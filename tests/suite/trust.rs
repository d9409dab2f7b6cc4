//! The section "What you have to trust" against the code: what it lists is tried, and is complete. How long it is, the book counts.

use slipbook::book::files_below;
use std::fs;
use std::path::{Path, PathBuf};

/// The modules that it counts, if they are no part of another's, and the tests that it names.
struct Row {
    modules: Vec<String>,
    tests: Vec<String>,
}

fn rows() -> Vec<Row> {
    let page = fs::read_to_string("book/src/methods.md").unwrap();
    let (_, table) = page.split_once("| Tried by |\n").unwrap();
    let row = |line: &str| {
        let (_, rest) = line.split_once(" | ").unwrap();
        let (counted, rest) = rest.split_once(" | ").unwrap();
        let modules = counted.trim_start_matches("{{lines ").strip_suffix("}}");
        let modules = modules.unwrap_or_default().split_whitespace();
        let tests = rest.split('`').skip(1).step_by(2);
        Row {
            modules: modules.map(str::to_owned).collect(),
            tests: tests.map(str::to_owned).collect(),
        }
    };
    let lines = table.lines().skip(1);
    lines
        .take_while(|line| line.starts_with('|'))
        .map(row)
        .collect()
}

#[test]
fn each_part_is_tried_by_tests_that_exist() {
    let rows = rows();
    assert!(rows.len() > 10);
    for Row { modules, tests } in rows {
        assert!(!tests.is_empty(), "{modules:?} is not tried");
        for test in tests {
            assert!(Path::new(&test).is_file(), "there is no {test}");
        }
    }
}

#[test]
fn the_page_is_complete() {
    let rows = rows();
    let listed: Vec<_> = rows.iter().flat_map(|row| &row.modules).collect();
    let mut missing = Vec::new();
    for folder in [
        "trialbook/src/exact",
        "trialbook/src/certified",
        "trialbook/src/trials",
        "trialbook/src/numerics",
        "trialbook/src/seeded",
        "motion/src",
        "src/paper",
        "src/corrections",
    ] {
        let is_listed = |path: &PathBuf| {
            let mut above = path.ancestors();
            above.any(|above| listed.iter().any(|module| Path::new(module) == above))
        };
        let files = files_below(Path::new(folder)).unwrap().into_values();
        let sources = files.filter(|path| path.extension().is_some_and(|e| e == "rs"));
        missing.extend(sources.filter(|path| !is_listed(path)));
    }
    assert!(missing.is_empty(), "not on the page: {missing:?}");
}
