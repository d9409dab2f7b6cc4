//! The claims of the paper, as they are recorded. To try them takes a hundred crates more.

use crate::wrong;
use include_dir::{Dir, include_dir};
use pyo3::prelude::*;

/// By topic, with the verdicts in the paper's order.
static SNAPSHOTS: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/../snapshots");

type Text = &'static str;

#[derive(IntoPyObject)]
pub struct Claim {
    id: Text,
    title: Text,
    section: Text,
    equation: Option<u16>,
    plain: Text,
    verdict: Text,
    wrong: Option<Text>,
    ground: Text,
    standing: Option<Text>,
    correction: Option<Text>,
}

/// Without its head.
fn snapshot(name: &str) -> Option<Text> {
    let text = SNAPSHOTS.get_file(name)?.contents_utf8()?;
    text.splitn(3, "---\n").nth(2)
}

/// All that is recorded of a claim, in the words of `slipbook show`: its conditions, and each trial with a few numbers.
#[pyfunction]
pub fn sheet(id: &str) -> PyResult<Text> {
    let sheet = SNAPSHOTS.dirs().find_map(|topic| {
        let text = snapshot(&format!("{}/{id}.snap", topic.path().display()))?;
        text.starts_with(&format!("{id}: ")).then_some(text)
    });
    sheet.ok_or_else(|| wrong(format!("there is no claim `{id}`: claims() names all")))
}

/// The claims of the paper in its order, each a dict of what `slipbook list --json` says: the number of an equation, the statement
/// in plain letters, what is wrong with it, if anything, the ground of its verdict, and its standing: how that is known, "proved",
/// "argued", "measured" or "defined". The correction is what is right in its place.
#[pyfunction]
pub fn claims() -> Vec<Claim> {
    let verdicts = snapshot("verdicts.snap").unwrap_or_default().lines();
    let verdicts = verdicts.filter_map(|line| line.split_once(": "));
    let claim = |(id, verdict)| claim(id, verdict, sheet(id).ok()?.split("\n\ntrial by ").next()?);
    verdicts.filter_map(claim).collect()
}

fn claim(id: Text, verdict: Text, head: Text) -> Option<Claim> {
    let said = |name| {
        let mut lines = head.lines();
        lines.find_map(|line| line.strip_prefix(name)?.strip_prefix(": "))
    };
    let parts: Vec<_> = head.split("\n\n").map(str::trim).collect();
    let place: Vec<_> = head.lines().nth(1)?.split([' ', ',', '(', ')']).collect();
    let corrected = parts.iter().position(|part| *part == "corrected:");
    Some(Claim {
        id,
        title: said(id)?,
        section: place.get(1)?,
        equation: place.iter().skip(2).find_map(|word| word.parse().ok()),
        plain: parts.get(1)?,
        verdict,
        wrong: said("in short"),
        ground: said("ground")?,
        standing: said("known"),
        correction: corrected.and_then(|at| parts.get(at + 1).copied()),
    })
}
