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
use std::sync::LazyLock;

/// All claims, tried.
static LEDGER: LazyLock<Ledger> = LazyLock::new(|| Ledger::try_all(&PAPER, |_| {}));
