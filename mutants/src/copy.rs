//! The copy of the crate with all changes in it.

use crate::list::Mutant;
use crate::sites::{self, Kind, Row, Site};
use crate::write::instrumented;
use std::collections::{BTreeMap, BTreeSet};
use std::error::Error;
use std::fs;
use std::path::Path;
use std::process::Command;

/// Why a change is not in the copy.
pub const CONSTANT: &str = "in a constant";
pub const CHAIN: &str = "does not compile: || after let";
/// The files that are written in another way.
const OWN: [&str; 4] = [
    "Cargo.toml",
    "src/lib.rs",
    "src/claims/mod.rs",
    "trialbook/src/lib.rs",
];
pub const HIDDEN: &str = "not as a branch: hidden type";
pub const LOST: &str = "its place was not found";

/// Writes the copy without the changes that were given up before; adds those that cannot be in it.
pub fn write(
    mutants: &[Mutant],
    out: &BTreeMap<u32, String>,
    copy: &Path,
) -> Result<BTreeMap<u32, String>, Box<dyn Error>> {
    let mut given_up = out.clone();
    let files = Command::new("git").args(["ls-files"]).output()?.stdout;
    let files = String::from_utf8(files)?;
    let mut rows = Vec::new();
    let mut texts = BTreeMap::new();
    for file in files
        .lines()
        .filter(|f| !f.starts_with("mutants/") && !f.starts_with("fuzz/"))
    {
        if Path::new(file).is_symlink() || !Path::new(file).exists() {
            continue;
        }
        let here: Vec<_> = mutants.iter().filter(|m| m.file == file).collect();
        if here.is_empty() {
            if OWN.contains(&file) {
                continue;
            }
            put(&copy.join(file), &fs::read(file)?)?;
            continue;
        }
        let text = fs::read_to_string(file)?;
        let (found, left) = sites::find(&text, &here)?;
        let mut note = |ids: &mut dyn Iterator<Item = u32>, why: &str| {
            for id in ids {
                given_up.entry(id).or_insert_with(|| why.into());
            }
        };
        note(&mut found.constant.iter().copied(), CONSTANT);
        note(&mut found.chains.iter().copied(), CHAIN);
        note(&mut found.hidden.iter().copied(), HIDDEN);
        note(&mut left.iter().map(|m| m.id), LOST);
        rows.extend(found.rows);
        let kept = found.sites.into_iter().filter_map(|site| {
            let ids: Vec<_> = site
                .ids
                .into_iter()
                .filter(|(id, _)| !out.contains_key(id))
                .collect();
            let stays = !ids.is_empty() || matches!(site.kind, Kind::Text(_));
            stays.then_some(Site { ids, ..site })
        });
        texts.insert(file.to_owned(), instrumented(&text, kept.collect()));
    }
    let rows: Vec<_> = rows
        .into_iter()
        .filter(|r| !out.contains_key(&r.id))
        .collect();
    let claims = fs::read_to_string("src/claims/mod.rs")?;
    put(
        &copy.join("src/claims/mod.rs"),
        topics(&claims, &rows)?.as_bytes(),
    )?;
    for (file, text) in &texts {
        put(&copy.join(file), text.as_bytes())?;
    }
    let library = fs::read_to_string("src/lib.rs")?;
    let switch =
        include_str!("../copy/switch.rs").replace("COUNT]", &format!("{}]", mutants.len() + 1));
    let allow = "#![allow(warnings, arithmetic_overflow, unconditional_panic, clippy::all)]\n";
    put(
        &copy.join("src/lib.rs"),
        format!("{allow}{library}pub use trialbook::{{Either, mutant}};\n").as_bytes(),
    )?;
    let engine = fs::read_to_string("trialbook/src/lib.rs")?;
    put(
        &copy.join("trialbook/src/lib.rs"),
        format!("{allow}{engine}{switch}").as_bytes(),
    )?;
    put(
        &copy.join("tests/mutants.rs"),
        include_bytes!("../copy/claims.rs"),
    )?;
    let manifest = fs::read_to_string("Cargo.toml")?;
    let target = "\n[[test]]\nname = \"mutants\"\nharness = false\n";
    put(
        &copy.join("Cargo.toml"),
        format!("{manifest}{target}").as_bytes(),
    )?;
    Ok(given_up)
}

/// Writes a file if it is not there yet as it should be, so that cargo builds no more than it must.
fn put(path: &Path, bytes: &[u8]) -> std::io::Result<()> {
    if fs::read(path).is_ok_and(|there| there == bytes) {
        return Ok(());
    }
    fs::create_dir_all(path.parent().unwrap_or(path))?;
    fs::write(path, bytes)
}

/// The list of topics, made when it is first read: a row of a claim is constant and can hold no switch.
fn topics(text: &str, rows: &[Row]) -> Result<String, Box<dyn Error>> {
    let (begin, end) = ("static TOPICS: [Topic; 9] = [", "\n];");
    let at = text.find(begin).ok_or("no list of topics")?;
    let length = text[at..]
        .find(end)
        .ok_or("the list of topics has no end")?;
    let list = &text[at + begin.len()..at + length];
    let changes: BTreeSet<_> = rows
        .iter()
        .map(|r| {
            format!(
                "    ({}, {:?}, |c| c.{f} = Claim::BLANK.{f}),\n",
                r.id,
                r.claim,
                f = r.field
            )
        })
        .collect();
    let changes: String = changes.into_iter().collect();
    let made = format!(
        "static TOPICS: std::sync::LazyLock<[Topic; 9]> = std::sync::LazyLock::new(|| {{
    let mut topics = [{list}];
    for (id, claim, change) in CHANGES {{
        if crate::mutant(*id) {{
            for topic in &mut topics {{
                let mut claims = topic.claims.to_vec();
                claims.iter_mut().filter(|c| c.id == *claim).for_each(|c| change(c));
                topic.claims = claims.leak();
            }}
        }}
    }}
    topics
}});

const CHANGES: &[(u32, &str, fn(&mut Claim))] = &[
{changes}];"
    );
    // So is the paper that has them.
    let (constant, made_later) = (
        "pub static PAPER: Paper = Paper {",
        "pub static PAPER: std::sync::LazyLock<Paper> = std::sync::LazyLock::new(|| Paper {",
    );
    let rest = text[at + length + end.len()..].trim_end();
    let rest = rest.strip_suffix("};").ok_or("no paper")?;
    let rest = rest.replace(constant, made_later);
    Ok(format!("{}{made}{rest}}});\n", &text[..at]))
}

/// The changes in rows of claims.
pub fn rows(mutants: &[Mutant]) -> Result<Vec<Row>, Box<dyn Error>> {
    let files: BTreeSet<_> = mutants.iter().map(|m| &m.file).collect();
    let mut rows = Vec::new();
    for file in files {
        let here: Vec<_> = mutants.iter().filter(|m| &m.file == file).collect();
        rows.extend(sites::find(&fs::read_to_string(file)?, &here)?.0.rows);
    }
    Ok(rows)
}

/// The ids of all claims: each has a line in a snapshot.
pub fn claims() -> Result<Vec<String>, Box<dyn Error>> {
    let text = fs::read_to_string("snapshots/dependencies.snap")?;
    let rows = text.splitn(3, "---\n").nth(2).unwrap_or("").lines();
    Ok(rows
        .filter_map(|l| Some(l.split_once(':')?.0.to_owned()))
        .collect())
}
