//! Maps of fates on the turntable as CSV: for each A that is named, which starts are proved to come to rest and which to
//! escape, strip by strip. It takes long; `snapshots/fates.csv` has those of 0.7, 0.8 and 0.9.

use slipbook::claims::rest::fates::{HEAD, map};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let named: Result<Vec<f64>, _> = std::env::args().skip(1).map(|a| a.parse()).collect();
    println!("{HEAD}");
    for a in named? {
        for row in map(a, || eprint!("."))? {
            println!("{row}");
        }
        eprintln!(" A = {a}");
    }
    Ok(())
}
