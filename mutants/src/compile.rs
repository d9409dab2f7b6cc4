//! Takes out of the copy what the compiler rejects, until it compiles.

use crate::copy;
use crate::list::Mutant;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::error::Error;
use std::fs;
use std::path::Path;
use std::process::Command;

/// Writes and checks the copy; the changes that are not in it, with the reasons.
pub fn until_it_compiles(
    mutants: &[Mutant],
    scratch: &Path,
) -> Result<BTreeMap<u32, String>, Box<dyn Error>> {
    let kept = scratch.join("out.json");
    let mut out: BTreeMap<u32, String> = match fs::read(&kept) {
        Ok(text) => serde_json::from_slice(&text)?,
        Err(_) => BTreeMap::new(),
    };
    let crate_of = scratch.join("copy");
    loop {
        let all = copy::write(mutants, &out, &crate_of)?;
        let rejected = check(&crate_of)?;
        eprintln!(
            "{} changes written, {} rejected",
            mutants.len() - all.len(),
            rejected.len()
        );
        if rejected.is_empty() {
            fs::write(
                scratch.join("absent.json"),
                serde_json::to_vec_pretty(&json!(all))?,
            )?;
            return Ok(all);
        }
        out.extend(rejected);
        fs::write(&kept, serde_json::to_vec_pretty(&json!(out))?)?;
    }
}

/// What the compiler rejects, with its reasons.
fn check(copy: &Path) -> Result<BTreeMap<u32, String>, Box<dyn Error>> {
    let made = Command::new("nice")
        .args([
            "-n",
            "10",
            "cargo",
            "check",
            "-j2",
            "--workspace",
            "--lib",
            "--message-format=json",
        ])
        .env(
            "CARGO_TARGET_DIR",
            std::path::absolute("target/mutants/target")?,
        )
        .current_dir(copy)
        .output()?;
    let mut rejected = BTreeMap::new();
    let mut unknown = Vec::new();
    for line in String::from_utf8_lossy(&made.stdout).lines() {
        let message = &serde_json::from_str::<Value>(line)?["message"];
        if message["level"] != "error" || message["spans"].as_array().is_none_or(Vec::is_empty) {
            continue;
        }
        let code = message["code"]["code"].as_str().unwrap_or("?");
        let words = format!("{code}: {}", message["message"].as_str().unwrap_or("?"));
        let spans = message["spans"].as_array().into_iter().flatten();
        let (first, other): (Vec<_>, Vec<_>) = spans.partition(|s| s["is_primary"] == true);
        let mut found = false;
        for mut span in first.into_iter().chain(other) {
            // What a macro writes is where the macro is used.
            while span["expansion"].is_object() {
                span = &span["expansion"]["span"];
            }
            let file = span["file_name"].as_str().unwrap_or("");
            let text = fs::read_to_string(copy.join(file)).unwrap_or_default();
            let byte = |key: &str| span[key].as_u64().unwrap_or(0) as usize;
            let (at, end) = (byte("byte_start"), byte("byte_end"));
            let within = || text.get(at..end).map(within).filter(|ids| !ids.is_empty());
            let around = around(&text, at, code == "E0004");
            let Some((own, ids)) = around.or_else(|| Some((false, within()?))) else {
                continue;
            };
            // An iterator over something else is no branch’s fault.
            let why = if own || code == "E0271" {
                format!("does not compile: {words}")
            } else {
                format!("not as a branch: {words}")
            };
            rejected.extend(ids.into_iter().map(|id| (id, why.clone())));
            found = true;
            break;
        }
        if !found {
            unknown.push(message["rendered"].as_str().unwrap_or("?").to_owned());
        }
    }
    if rejected.is_empty() && !made.status.success() {
        let said = String::from_utf8_lossy(&made.stderr).into_owned();
        return Err(format!("{}\n{said}", unknown.join("\n")).into());
    }
    unknown
        .iter()
        .take(5)
        .for_each(|u| eprintln!("elsewhere: {u}"));
    Ok(rejected)
}

/// The innermost mark around a place: whether it is around one change alone, and the changes.
fn around(text: &str, at: usize, arms: bool) -> Option<(bool, Vec<u32>)> {
    let mut open = Vec::new();
    let mut rest = 0;
    while let Some(next) = text[rest..].find("/*<") {
        let begin = rest + next + 3;
        let end = begin + text[begin..].find(">*/")?;
        if begin > at {
            break;
        }
        match &text[begin..end] {
            closed if closed.starts_with('/') => drop(open.pop()),
            mark => open.push(mark),
        }
        rest = end;
    }
    let numbers = |mark: &str| {
        mark[1..]
            .split(',')
            .filter_map(|n| n.parse().ok())
            .collect()
    };
    let fits = |mark: &&&str| mark.starts_with('m') == arms;
    let mark = open.iter().rev().find(fits)?;
    let mut ids: Vec<u32> = numbers(mark);
    // Of several iterators the first is empty and fits most types: it goes last.
    if mark.starts_with('i') && ids.len() > 1 {
        ids.drain(..ids.len() - 1);
    }
    Some((arms || mark.starts_with('a'), ids))
}

/// The changes of the marks within a text.
fn within(text: &str) -> Vec<u32> {
    let marks = text
        .split("/*<g")
        .skip(1)
        .filter_map(|rest| rest.split(">*/").next());
    marks
        .flat_map(|mark| mark.split(',').filter_map(|n| n.parse().ok()))
        .collect()
}
