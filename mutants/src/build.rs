//! The copy of the crate with all mistakes in it.

use crate::list::Mistake;
use crate::patch::{self, Place};
use std::collections::BTreeMap;
use std::error::Error;
use std::fmt;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

const PARTS: [&str; 7] = [
    "src",
    "motion/src",
    "claims",
    "book",
    "snapshots",
    "benches/results.json",
    "benches/exam",
];

pub struct Lost {
    pub mistake: String,
    file: String,
    right: String,
    why: &'static str,
}

impl fmt::Display for Lost {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Lost {
            mistake,
            file,
            right,
            why,
        } = self;
        write!(
            f,
            "{mistake} cannot be made: of {file} it is said\n{right}\nbut this {why}"
        )
    }
}

/// Returns the mistakes that cannot be made.
pub fn write(mistakes: &[Mistake], copy: &Path) -> Result<Vec<Lost>, Box<dyn Error>> {
    let mut places = BTreeMap::<&str, Vec<Place>>::new();
    let mut lost = Vec::new();
    for (id, mistake) in (1..).zip(mistakes) {
        for change in &mistake.changes {
            let source = fs::read_to_string(&change.file)
                .map_err(|e| format!("{}, {}: {e}", mistake.name, change.file))?;
            match patch::find(&source, &change.right) {
                Ok(range) => places.entry(&change.file).or_default().push(Place {
                    id,
                    range,
                    wrong: change.wrong.clone(),
                }),
                Err(why) => lost.push(Lost {
                    mistake: mistake.name.clone(),
                    file: change.file.clone(),
                    right: change.right.clone(),
                    why,
                }),
            }
        }
    }
    let listed = Command::new("git")
        .args(["ls-files", "--cached", "--others", "--exclude-standard"])
        .args(PARTS)
        .output()?;
    let listed = String::from_utf8(listed.stdout)?;
    for file in listed.lines().filter(|f| Path::new(f).is_file()) {
        let bytes = match places.remove(file) {
            None => fs::read(file)?,
            Some(places) => patch::patched(&fs::read_to_string(file)?, places)
                .map_err(|[a, b]| {
                    let name = |id: usize| &mistakes[id - 1].name;
                    format!("{} and {} overlap in {file}", name(a), name(b))
                })?
                .into_bytes(),
        };
        let allowed = b"#![allow(warnings, clippy::all)]\n".as_slice();
        let bytes = match file {
            "src/lib.rs" => {
                let switches = b"pub use slipbook_motion::{NOTED, go_wrong, passed};\n";
                [allowed, &bytes, switches].concat()
            }
            "motion/src/lib.rs" => {
                [allowed, &bytes, include_bytes!("../copy/wrong.rs")].concat()
            }
            _ => bytes,
        };
        put(&copy.join(file), &bytes)?;
    }
    put(
        &copy.join("verdicts.rs"),
        include_bytes!("../copy/verdicts.rs"),
    )?;
    for crate_of in ["", "motion/"] {
        let path = format!("{crate_of}Cargo.toml");
        let manifest = manifest(&fs::read_to_string(&path)?);
        put(&copy.join(path), manifest.as_bytes())?;
    }
    // So that the same versions are built; cargo notes the other name in it.
    if !copy.join("Cargo.lock").exists() {
        fs::copy("Cargo.lock", copy.join("Cargo.lock"))?;
    }
    Ok(lost)
}

/// Another name, so that its artefacts can lie beside those of the crate, and no tests.
fn manifest(text: &str) -> String {
    let mut out = String::new();
    let mut kept = false;
    for line in text.lines() {
        if line.starts_with('[') {
            let dropped = ["[workspace", "[[", "[dev-dependencies"];
            kept = !dropped.iter().any(|d| line.starts_with(d));
        }
        let line = match line {
            "name = \"slipbook\"" => "name = \"slipbook-wrong\"\nautobins = false",
            _ => line,
        };
        if kept {
            let engine = |path: &str| format!("path = \"{path}trialbook\"");
            let line = line.replace(&engine("../"), &engine("../../../"));
            out += &line.replace(&engine(""), &engine("../../"));
            out.push('\n');
        }
    }
    match out.contains("name = \"slipbook-wrong\"") {
        true => out + "[workspace]\n\n[[bin]]\nname = \"verdicts\"\npath = \"verdicts.rs\"\n",
        false => out,
    }
}

/// If it is another, so that cargo builds no more than it must.
fn put(path: &Path, bytes: &[u8]) -> std::io::Result<()> {
    if fs::read(path).is_ok_and(|there| there == bytes) {
        return Ok(());
    }
    fs::create_dir_all(path.parent().unwrap_or(path))?;
    fs::write(path, bytes)
}

/// Returns the program that tries the ledger.
pub fn build(copy: &Path) -> Result<PathBuf, Box<dyn Error>> {
    let target = std::path::absolute("target")?;
    let built = Command::new("cargo")
        .args(["build", "--bin", "verdicts", "--target-dir"])
        .arg(&target)
        .current_dir(copy)
        .status()?;
    if !built.success() {
        return Err("the copy does not compile".into());
    }
    Ok(target.join("debug/verdicts"))
}
