//! The page "What you have to trust" against the code: what it lists exists, is as long as it says, and is complete.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// A row of the page's table: where the code is, how many lines it has as it says, and the tests that it names.
struct Row {
    places: Vec<PathBuf>,
    lines: f64,
    tests: Vec<PathBuf>,
}

fn rows() -> Vec<Row> {
    let page = fs::read_to_string("book/src/trust.md").unwrap();
    let paths = |cell: &str| -> Vec<PathBuf> {
        let code = cell.split('`').skip(1).step_by(2);
        code.map(PathBuf::from).collect()
    };
    let cells = page.lines().filter(|line| line.starts_with("| "));
    let cells = cells.map(|line| line.split('|').map(str::trim).collect::<Vec<_>>());
    let rows = cells.filter_map(|cells| {
        Some(Row {
            places: paths(cells[2]),
            lines: cells[3].parse().ok()?,
            tests: paths(cells[5]),
        })
    });
    rows.collect()
}

/// The files of Rust at or below a path that are no tests.
fn sources(place: &Path) -> BTreeSet<PathBuf> {
    if place.is_file() {
        return BTreeSet::from([place.to_owned()]);
    }
    let entries = fs::read_dir(place).unwrap_or_else(|e| panic!("{}: {e}", place.display()));
    let below = entries.flat_map(|entry| sources(&entry.unwrap().path()));
    let code = |path: &PathBuf| path.extension().is_some_and(|e| e == "rs");
    let tests = |path: &PathBuf| {
        path.components().any(|c| c.as_os_str() == "tests") || path.ends_with("tests.rs")
    };
    below.filter(|path| code(path) && !tests(path)).collect()
}

/// Lines of code, without comments and tests.
fn lines(path: &Path) -> usize {
    let text = fs::read_to_string(path).unwrap();
    let code = text
        .lines()
        .map(str::trim)
        .take_while(|line| *line != "#[cfg(test)]");
    code.filter(|line| !line.is_empty() && !line.starts_with("//"))
        .count()
}

#[test]
fn each_part_is_as_long_as_the_page_says_and_the_tests_that_it_names_exist() {
    let rows = rows();
    assert!(rows.len() > 10);
    for row in rows {
        let files: BTreeSet<_> = row.places.iter().flat_map(|place| sources(place)).collect();
        let counted: usize = files.iter().map(|path| lines(path)).sum();
        let off = (counted as f64 - row.lines).abs();
        // A reader wants to know how much there is, not the last line.
        assert!(
            off <= 10.0_f64.max(0.05 * row.lines),
            "{:?} has {counted} lines, the page says {}",
            row.places,
            row.lines
        );
        for test in &row.tests {
            assert!(test.is_file(), "there is no {}", test.display());
        }
        assert!(!row.tests.is_empty(), "{:?} is not tried", row.places);
    }
}

/// Whatever a proof, a measurement or the judge is made of stands in the table.
#[test]
fn the_page_is_complete() {
    let listed: BTreeSet<_> = rows()
        .iter()
        .flat_map(|row| &row.places)
        .flat_map(|place| sources(place))
        .collect();
    for room in [
        "trialbook/src/exact",
        "trialbook/src/certified",
        "trialbook/src/claims",
        "trialbook/src/numerics",
        "trialbook/src/seeded",
        "src/certified",
        "src/motion",
        "src/paper",
        "src/corrections",
    ] {
        let all = sources(Path::new(room));
        let missing: Vec<_> = all.difference(&listed).collect();
        assert!(missing.is_empty(), "not on the page: {missing:?}");
    }
}

/// Libraries that compute stand on the page; the others give no number to a verdict.
#[test]
fn libraries_that_compute_are_named() {
    let page = fs::read_to_string("book/src/trust.md").unwrap();
    let manifests =
        ["Cargo.toml", "trialbook/Cargo.toml"].map(|file| fs::read_to_string(file).unwrap());
    const NO_NUMBERS: [&str; 21] = [
        "clap",
        "clap_complete",
        "clap_mangen",
        "console",
        "ctrlc",
        "elasticlunr-rs",
        "fastrand",
        "include_dir",
        "indicatif",
        "katex-rs",
        "mdbook-driver",
        "pulldown-cmark",
        "rayon",
        "serde",
        "serde_json",
        "sha2",
        "smallvec",
        "strsim",
        "tempfile",
        "thiserror",
        "trialbook",
    ];
    for manifest in manifests {
        let (_, rest) = manifest.split_once("[dependencies]\n").unwrap();
        let (dependencies, _) = rest.split_once("\n[").unwrap_or((rest, ""));
        for line in dependencies.lines() {
            let Some((name, _)) = line
                .split_once(" = ")
                .filter(|(name, _)| !name.starts_with('#'))
            else {
                continue;
            };
            let family = name.split('-').next().unwrap();
            let named =
                page.contains(&format!("`{name}`")) || page.contains(&format!("`{family}`"));
            assert!(
                named || NO_NUMBERS.contains(&name),
                "{name} is not on the page"
            );
        }
    }
}
