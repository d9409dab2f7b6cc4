//! What became of the changes, counted and listed.

use crate::list::Mutant;
use crate::run::known;
use std::collections::BTreeMap;
use std::error::Error;
use std::path::Path;

/// The outcomes, in the order of the columns.
const WORDS: [&str; 8] = [
    "caught",
    "crashed",
    "slow",
    "missed",
    "unreached",
    "capped",
    "absent",
    "unviable",
];

/// Counts by sort and by folder.
pub fn table(
    mutants: &[Mutant],
    absent: &BTreeMap<u32, String>,
    scratch: &Path,
) -> Result<String, Box<dyn Error>> {
    let known = known(&scratch.join("results.tsv"));
    let mut counts = BTreeMap::<(u8, String), BTreeMap<&str, usize>>::new();
    for m in mutants {
        let word = match (absent.get(&m.id), known.get(&m.id)) {
            (Some(why), _) if why.starts_with("does not compile") => "unviable",
            (Some(_), _) => "absent",
            (None, Some((word, _))) => word,
            (None, None) => continue,
        };
        let word = WORDS.into_iter().find(|w| *w == word).unwrap_or("absent");
        let folder = m.file.split('/').take(2).collect::<Vec<_>>().join("/");
        for row in [(0, m.genre.clone()), (1, folder), (2, "all".into())] {
            *counts.entry(row).or_default().entry(word).or_default() += 1;
        }
    }
    let mut out = format!(
        "| |{}|\n|---|{}\n",
        WORDS.join("|"),
        "---:|".repeat(WORDS.len())
    );
    for ((_, name), row) in counts {
        let cells = WORDS.map(|w| row.get(w).copied().unwrap_or(0).to_string());
        out += &format!("|{name}|{}|\n", cells.join("|"));
    }
    Ok(out)
}
