//! All that is tried besides the claims and the pages in a browser: one program, so that what it needs is built and linked
//! once, and the claims are tried once.

mod attractors;
mod breaks;
mod calculators;
mod careless;
mod certificates;
mod certified;
mod claims_list;
mod command;
mod digits;
mod domains;
mod drive;
mod explored;
mod explorers;
mod json;
mod judge;
mod motions;
mod numbers;
mod pages;
mod prose;
mod readme;
mod rows;
mod same;
mod structure;
mod trust;
mod units;

use slipbook::claims::PAPER;
use slipbook::ledger::Ledger;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::LazyLock;

/// All claims, tried.
static LEDGER: LazyLock<Ledger> = LazyLock::new(|| Ledger::try_all(&PAPER, |_| {}));

/// The book, as the main job writes it.
static BOOK: LazyLock<PathBuf> = LazyLock::new(|| {
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join("book");
    let job = slipbook(&["--quiet", "--out", out.to_str().expect("a name")]);
    assert!(job.status.success());
    out
});

/// What the command answers.
fn slipbook(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_slipbook"));
    command.args(arguments).output().expect("it runs")
}

/// The cells of a line of a table; one with a comma stands between quotation marks.
fn cells(line: &str) -> Vec<String> {
    let mut quoted = false;
    let ends = |c| {
        quoted ^= c == '"';
        c == ',' && !quoted
    };
    let cells = line.split(ends);
    cells.map(|cell| cell.replace('"', "")).collect()
}
