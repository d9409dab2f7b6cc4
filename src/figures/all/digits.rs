//! The figure of the digits that the calculators claim, from the recorded counts.

use super::AllFiguresError;
use crate::figures::Figure;
use crate::figures::digits::{Count, digits};

/// Written by `tests/digits`, which also tries whether it still holds.
const RECORD: &str = include_str!("../../../snapshots/digits.csv");

pub(super) fn figures() -> Result<Vec<Figure>, AllFiguresError> {
    let counts: Option<Vec<Count>> = RECORD.lines().skip(1).map(count).collect();
    let counts = counts.ok_or_else(|| {
        AllFiguresError::Data("snapshots/digits.csv: calculator,claimed,true,cases".into())
    })?;
    Ok(vec![digits(&counts)?])
}

/// A line of the record.
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
