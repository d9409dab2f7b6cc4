//! The changes that cargo-mutants would make, as it lists them.

use serde_json::Value;
use std::error::Error;
use std::fs;
use std::path::Path;
use std::process::Command;

/// One change.
pub struct Mutant {
    /// Its number: its place in the list, from 1.
    pub id: u32,
    /// The file, from the top of the repository.
    pub file: String,
    /// Line and column where what changes begins, both from 1; columns count characters.
    pub start: (usize, usize),
    /// What stands there instead.
    pub replacement: String,
    /// The sort of change: `FnValue`, `BinaryOperator`, …
    pub genre: String,
    /// Place and change in words.
    pub name: String,
}

/// The list, kept in `scratch` once it is made.
pub fn list(scratch: &Path) -> Result<Vec<Mutant>, Box<dyn Error>> {
    let kept = scratch.join("list.json");
    if !kept.exists() {
        let made = Command::new("cargo")
            .args(["mutants", "--workspace", "--list", "--json"])
            .output()?;
        if !made.status.success() {
            return Err(String::from_utf8_lossy(&made.stderr).into());
        }
        fs::write(&kept, made.stdout)?;
    }
    let all: Vec<Value> = serde_json::from_slice(&fs::read(&kept)?)?;
    let one = |(i, m): (usize, &Value)| {
        let text = |key: &str| m[key].as_str().map(str::to_owned);
        let start = &m["span"]["start"];
        let number = |key: &str| start[key].as_u64().map(|n| n as usize);
        Some(Mutant {
            id: i as u32 + 1,
            file: text("file")?,
            start: (number("line")?, number("column")?),
            replacement: text("replacement")?,
            genre: text("genre")?,
            name: text("name")?,
        })
    };
    let read: Option<Vec<_>> = all.iter().enumerate().map(one).collect();
    read.ok_or_else(|| "the list has another form".into())
}
