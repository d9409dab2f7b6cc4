//! The list of intervals in which the motion is positive, negative or at rest.

use super::arcs::Mark;
use super::sign::Sign;
use std::f64::consts::TAU;

/// Intervals at most this long (radians) are not listed: the spacing of numbers near 2π is a tenth of it.
pub const ZERO_LENGTH: f64 = 1e-14;

/// An interval of the phase, with the direction of motion in it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Interval {
    /// Direction of motion.
    pub sign: Sign,
    /// Where it begins (radians).
    pub start: f64,
    /// Where it ends; larger than `start`, so possibly beyond 2π.
    pub end: f64,
}

impl Interval {
    /// Length, radians.
    pub fn length(&self) -> f64 {
        self.end - self.start
    }
}

/// Those of length zero left out.
pub(super) fn between(marks: &[Mark], until: f64) -> Vec<Interval> {
    let mut list: Vec<Interval> = Vec::with_capacity(marks.len());
    let ends = marks.iter().skip(1).map(|m| m.phi).chain([until]);
    for (mark, end) in marks.iter().zip(ends) {
        if end - mark.phi <= ZERO_LENGTH {
            continue;
        }
        match list.last_mut() {
            Some(last) if last.sign == mark.sign => last.end = end,
            last => {
                let start = last.map_or(marks[0].phi, |last| last.end);
                list.push(Interval {
                    sign: mark.sign,
                    start,
                    end,
                });
            }
        }
    }
    list
}

pub(super) fn drops_one(marks: &[Mark], until: f64) -> bool {
    marks.windows(2).any(|pair| {
        pair[1].phi - pair[0].phi <= ZERO_LENGTH
            && pair[0].phi - marks[0].phi > ZERO_LENGTH
            && until - pair[1].phi > ZERO_LENGTH
    })
}

/// As [`Attractor::intervals`](super::Attractor::intervals) are; without a beginning of that kind the list keeps its own.
pub(super) fn canonical(mut list: Vec<Interval>) -> Vec<Interval> {
    let n = list.len();
    if n > 1 && list[0].sign == list[n - 1].sign {
        list.remove(0);
    }
    let n = list.len();
    let rank = |i: usize| {
        let (before, now) = (list[(i + n - 1) % n].sign, list[i].sign);
        match (before, now) {
            (Sign::Rest, Sign::Positive) => 0,
            (Sign::Rest, Sign::Negative) => 1,
            (Sign::Negative, Sign::Positive) => 2,
            _ => 3,
        }
    };
    let reduced = |i: usize| list[i].start.rem_euclid(TAU);
    let best = (0..n).min_by(|&i, &j| {
        rank(i)
            .cmp(&rank(j))
            .then(reduced(i).total_cmp(&reduced(j)))
    });
    let Some(best) = best.filter(|_| n > 1) else {
        return list;
    };
    for interval in &mut list[..best] {
        interval.start += TAU;
    }
    list.rotate_left(best);
    let shift = TAU * (list[0].start / TAU).floor();
    let first = list[0].start - shift;
    for i in 0..n {
        list[i].start -= shift;
        list[i].end = list
            .get(i + 1)
            .map_or(first + TAU, |next| next.start - shift);
    }
    list
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The list begins behind the one that ends first in [0, 2π).
    #[test]
    fn of_several_beginnings_the_first_is_taken() {
        let interval = |sign, start, end| Interval { sign, start, end };
        let list = vec![
            interval(Sign::Positive, 4.0, 5.0),
            interval(Sign::Rest, 5.0, 7.0),
            interval(Sign::Positive, 7.0, 8.0),
            interval(Sign::Rest, 8.0, 4.0 + TAU),
        ];
        let list = canonical(list);
        assert!((list[0].start - (7.0 - TAU)).abs() < 1e-15, "{list:?}");
        assert_eq!(list[0].sign, Sign::Positive);
        assert!(
            (list[3].end - list[0].start - TAU).abs() < 1e-14,
            "{list:?}"
        );
    }
}
