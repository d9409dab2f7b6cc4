//! Every change that cargo-mutants would make, in one build.
//!
//! A copy of the crate is written in which each change stands behind a switch, and is built once. A run of a test
//! switches one change on; the tests that never come to a change need not be run for it.
//!
//! All is kept in `target/mutants`, and a run that was stopped goes on. After a change of the crate, delete it.

mod compile;
mod copy;
mod cover;
mod list;
mod run;
mod sites;
mod survivors;
mod table;
mod write;

use std::collections::BTreeMap;
use std::error::Error;
use std::fs;
use std::path::Path;

/// For how many seconds a change is tried in the first round, and in the second; which tries again those that took longer.
const ROUNDS: [(f64, bool); 2] = [(5.0, false), (180.0, true)];

fn main() -> Result<(), Box<dyn Error>> {
    let scratch = Path::new("target/mutants");
    fs::create_dir_all(scratch)?;
    let mutants = list::list(scratch)?;
    let copy = scratch.join("copy");
    let absent = compile::until_it_compiles(&mutants, scratch)?;
    let programs = cover::build(&copy)?;
    let ids = copy::claims()?;
    let units = cover::cover(&programs, &ids, &copy, scratch)?;
    let own: BTreeMap<_, _> = copy::rows(&mutants)?
        .into_iter()
        .map(|r| (r.id, r.claim))
        .collect();
    let present: Vec<_> = mutants
        .iter()
        .filter(|m| !absent.contains_key(&m.id))
        .collect();
    for round in ROUNDS {
        run::run_all(&present, &own, &units, &copy, scratch, round)?;
        println!("{}", table::table(&mutants, &absent, scratch)?);
    }
    let differs = survivors::compare(&present, scratch)?;
    print!("{differs}");
    if !differs.is_empty() {
        return Err("the list of survivors is another".into());
    }
    Ok(())
}
