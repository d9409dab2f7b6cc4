//! The committed list of changes that no test notices, each with a reason, beside those that were found.

use crate::list::Mutant;
use crate::run::known;
use std::collections::BTreeMap;
use std::error::Error;
use std::fs;
use std::path::Path;

/// The list: reasons as `> …`, each with its changes below it, as file, change and line with tabs between them and, if
/// it is not one, how often. Lines that begin with `#` are for readers.
const LIST: &str = "mutants/survivors.txt";

/// File, change and the line that it changes.
type Change = [String; 3];

/// How often each change is found, or listed, and why.
type Listed = BTreeMap<Change, (usize, String)>;

fn listed() -> Listed {
    let mut listed = Listed::new();
    let mut reason = String::new();
    for line in fs::read_to_string(LIST).unwrap_or_default().lines() {
        if let Some(text) = line.strip_prefix("> ") {
            reason = text.to_owned();
        } else if let [file, change, code, rest @ ..] = &line.split('\t').collect::<Vec<_>>()[..] {
            let count = rest.first().and_then(|n| n.parse().ok()).unwrap_or(1);
            let change = [file, change, code].map(|cell| (*cell).to_owned());
            listed.insert(change, (count, reason.clone()));
        }
    }
    listed
}

/// Compares what survived with the list, and writes the list as it has to be to `survivors.txt` in `scratch`, with `> ?`
/// where a reason is missing. Says what differs; nothing if nothing does.
pub fn compare(mutants: &[&Mutant], scratch: &Path) -> Result<String, Box<dyn Error>> {
    let known = known(&scratch.join("results.tsv"));
    let mut found = BTreeMap::<Change, usize>::new();
    for m in mutants {
        let survives = known
            .get(&m.id)
            .is_some_and(|(word, _)| ["missed", "unreached", "capped"].contains(&word.as_str()));
        if survives {
            let text = fs::read_to_string(&m.file)?;
            let line = text.lines().nth(m.start.0 - 1).unwrap_or("").trim();
            // The name begins with file, line and column.
            let change = m.name.split_once(": ").map_or("", |(_, change)| change);
            let change = [m.file.as_str(), change, line].map(str::to_owned);
            *found.entry(change).or_default() += 1;
        }
    }
    let listed = listed();
    let mut differs = String::new();
    let mut by_reason = BTreeMap::<&str, String>::new();
    for (change, count) in &found {
        let (before, reason) = listed.get(change).map_or((0, "?"), |(n, why)| (*n, why));
        let times = if *count > 1 {
            format!("\t{count}")
        } else {
            String::new()
        };
        let line = format!("{}{times}\n", change.join("\t"));
        if before != *count {
            differs += &format!("not noticed {count} times, listed {before} times: {line}");
        }
        *by_reason.entry(reason).or_default() += &line;
    }
    for change in listed.keys().filter(|change| !found.contains_key(*change)) {
        differs += &format!("listed and noticed now: {}\n", change.join("\t"));
    }
    let text: String = by_reason
        .iter()
        .map(|(reason, lines)| format!("> {reason}\n{lines}\n"))
        .collect();
    fs::write(scratch.join("survivors.txt"), text)?;
    Ok(differs)
}
