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
use std::process::Command;
use std::sync::LazyLock;

/// All claims, tried.
static LEDGER: LazyLock<Ledger> = LazyLock::new(|| Ledger::try_all(&PAPER, |_| {}));

/// The book, as the main job writes it.
static BOOK: LazyLock<PathBuf> = LazyLock::new(|| {
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join("book");
    let mut job = Command::new(env!("CARGO_BIN_EXE_slipbook"));
    let status = job.arg("--quiet").arg("--out").arg(&out).status();
    assert!(status.expect("it runs").success());
    out
});
