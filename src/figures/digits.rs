//! The figure of the digits that the calculators claim, from the recorded counts.

use super::Drawn;
use trialbook::data::{Text, text};
use trialbook::plotting::{Axis, Curve, Figure, FigureError, Panel, Plot, Raster, Table};
use trialbook::trials::as_of;

/// Counted by `tests/digits`, which in the deep tier also tries whether it still holds.
pub(crate) const RECORD: Text = text!("snapshots/digits.csv");

pub(super) fn figures() -> Drawn<Vec<Figure>> {
    let counts: Vec<Count> = RECORD.lines().skip(1).filter_map(count).collect();
    Ok(vec![digits(&counts, as_of(&RECORD))?])
}

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

/// How often an answer claimed so many digits, and so many were true.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Count {
    pub calculator: String,
    /// From 0 to 15.
    pub claimed: u32,
    /// From 0 to 15; more are not counted.
    pub true_digits: u32,
    pub cases: usize,
}

/// Numbers of digits: 0 to 15.
const SIDE: usize = 16;

/// By digits claimed, to the right, and digits true, upwards, all calculators together.
fn cells(counts: &[Count]) -> [usize; SIDE * SIDE] {
    let mut cells = [0; SIDE * SIDE];
    for count in counts {
        let (x, y) = (count.claimed as usize, count.true_digits as usize);
        if x < SIDE && y < SIDE {
            cells[y * SIDE + x] += count.cases;
        }
    }
    cells
}

/// All calculators together; `as_of` says when they were counted.
pub(super) fn digits(counts: &[Count], as_of: &str) -> Result<Figure, FigureError> {
    let mut table = Table::new(&["calculator", "claimed", "true", "cases"]);
    for count in counts {
        let [claimed, right] = [count.claimed, count.true_digits].map(f64::from);
        table.row((&count.calculator, claimed, right, count.cases as f64))?;
    }
    let cells = cells(counts);
    let class = |cases: &usize| match cases {
        0 => trialbook::plotting::BLANK,
        1..10 => 0,
        10..100 => 1,
        100..1000 => 2,
        _ => 3,
    };
    let ends = (-0.5, SIDE as f64 - 0.5);
    let raster = Raster::new(SIDE, SIDE, ends, ends, cells.iter().map(class).collect())?
        .class("1 to 9 cases", 0, 0.15)
        .class("10 to 99", 0, 0.35)
        .class("100 to 999", 0, 0.6)
        .class("1000 and more", 0, 0.9);
    let all: usize = counts.iter().map(|count| count.cases).sum();
    let panel = Panel::new(
        Axis::linear("digits claimed").range(ends.0, ends.1),
        Axis::linear("digits true").range(ends.0, ends.1),
    )
    .equal()
    .raster(raster)
    .curve(
        Curve::new([[ends.0, ends.0], [ends.1, ends.1]])
            .ink()
            .dashed()
            .key("as many"),
    );
    Plot::new("digits", "Digits claimed and digits true")
        .caption(format!(
            "What the calculators claimed in {all} cases over their whole domains, their edges on purpose, and what was true: \
             the digits of the worst number of each answer, against solutions of a higher precision. No answer is off by \
             more than one unit of the last digit that it claims; a case right below the dashed line has a unit of that \
             digit that is large beside the number. Far above the line the motion could not confirm what the formula knew. {as_of}.",
        ))
        .alt(
            "A grid of digits claimed to the right and digits true upwards, both from 0 to 15. Nearly all cases lie in the \
             upper right corner, fifteen digits claimed and true; the others lie on or above the diagonal.",
        )
        .panel(panel)
        .figure(table)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_claimed_goes_to_the_right_and_what_is_true_upwards() {
        let count = |claimed, true_digits, cases| Count {
            calculator: "one".to_owned(),
            claimed,
            true_digits,
            cases,
        };
        let counts = [
            count(3, 12, 5),
            count(3, 12, 2),
            count(15, 0, 1),
            count(0, 15, 4),
            count(0, 16, 9),
        ];
        let found = cells(&counts);
        // Row by row from the lowest.
        for (x, y, cases) in [(3, 12, 7), (12, 3, 0), (15, 0, 1), (0, 15, 4)] {
            assert_eq!(found[16 * y + x], cases, "{x} {y}");
        }
        assert_eq!(found.iter().sum::<usize>(), 12);
        let figure = digits(&counts, "As of today").unwrap();
        assert!(figure.csv.contains("one,3,12,5"), "{}", figure.csv);
    }
}
