//! The figure of the digits that the calculators claim, from the recorded counts.

use super::AllFiguresError;
use crate::figures::digits::{Count, digits};
use trialbook::claims::as_of;
use trialbook::figures::Figure;

/// Counted by `tests/digits`, which in the deep tier also tries whether it still holds.
const RECORD: &str = include_str!("../../../snapshots/digits.csv");

pub(super) fn figures() -> Result<Vec<Figure>, AllFiguresError> {
    let counts: Vec<Count> = RECORD.lines().skip(1).filter_map(count).collect();
    Ok(vec![digits(&counts, as_of(RECORD))?])
}

/// A line of the record, if it is one.
fn count(line: &str) -> Option<Count> {
    let mut cells = line.rsplitn(4, ',');
    let [cases, true_digits, claimed] = [cells.next()?, cells.next()?, cells.next()?];
    Some(Count {
        calculator: cells.next()?.to_owned(),
        claimed: claimed.parse().ok()?,
        true_digits: true_digits.parse().ok()?,
        cases: cases.parse().ok()?,
    })
}
