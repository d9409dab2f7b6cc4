//! No digit that is not known: what the calculators claim against solutions of a higher precision.
//!
//! The vectors in `tests/data/digits` come from a foreign program (see the scripts there). For the turntable, where each
//! case takes longer, there is besides a Taylor integration in numbers of 31 digits in the table's own axes, which the
//! vectors test too. Of all cases a part is tried each time; all ten thousand of a kind with
//!
//! ```text
//! SLIPBOOK_DIGITS=10000 cargo test --test suite digits::
//! ```
//!
//! which also compares the counts with `snapshots/digits.csv`, from which the book draws its figure, and writes them anew
//! beside it where they differ.

mod certified;
mod explorers;
mod tally;
mod turntable;
mod values;
mod vectors;

use slipbook::numerics::double::Double;

const TERMS: usize = 44;

struct Room<const N: usize>([[Double; TERMS]; N]);

impl<const N: usize> Default for Room<N> {
    fn default() -> Self {
        Room([[Double::default(); TERMS]; N])
    }
}

fn cases(usual: usize) -> usize {
    let wanted = std::env::var("SLIPBOOK_DIGITS").ok();
    wanted.map_or(usual, |n| n.parse().expect("SLIPBOOK_DIGITS is a number"))
}
