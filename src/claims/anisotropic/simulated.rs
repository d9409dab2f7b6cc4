//! The simulated motions of section 2.4, one by one, and the curves and lists that they are held against.

use super::prelude::*;
pub use crate::claims::sinusoidal::reference_motions::drive;
use crate::motion::drive::Outcome;

/// The order of slips and rests by what is said of it, against that of the simulated motion.
pub const fn orders(by: &'static str) -> Compared {
    Compared::composed(
        [
            "the order of slips and rests in a period by ",
            by,
            " (3 for a forward slip, 2 for a rest, 1 for a backward slip)",
        ],
        ["that of the simulated motion", "", ""],
    )
}

/// The start of every motion unless another is said.
pub(crate) const START: DriveState = DriveState { phi: 0.0, w: 0.0 };
/// Far more periods than any attractor here takes.
const MAX_PERIODS: u32 = 200;

/// The periodic motion that a start leads to.
pub(crate) fn attractor_from(
    start: DriveState,
    friction: Friction,
) -> Result<Attractor<'static>, Failure> {
    match drive()?.attractor(friction, start, MAX_PERIODS)? {
        Outcome::Settles(attractor) => Ok(attractor),
        Outcome::Drifts { per_period } => Err(format!(
            "the motion with λ₊ = {}, λ₋ = {} drifts by {per_period} a period",
            friction.plus(),
            friction.minus()
        )
        .into()),
    }
}

/// The periodic motion with λ₊ = λ₀ and λ₋ = qλ₀.
///
/// # Errors
/// As [`attractor_from`].
pub fn attractor(q: f64, lambda0: f64) -> Result<Attractor<'static>, Failure> {
    attractor_from(START, Friction::new(lambda0, q * lambda0)?)
}

/// The order of a period's intervals, as `+`, `-` and `0`.
pub fn order(intervals: &[Interval]) -> String {
    let letter = |interval: &Interval| match interval.sign {
        Sign::Positive => '+',
        Sign::Negative => '-',
        Sign::Rest => '0',
    };
    intervals.iter().map(letter).collect()
}

/// The signs of 𝔴 on a period's intervals as one number, to compare: a digit each, 3 for 𝔴 > 0, 2 for rest, 1 for 𝔴 < 0.
pub fn digits(signs: impl IntoIterator<Item = f64>) -> f64 {
    let one_more = |digits: f64, sign: f64| 10.0 * digits + 2.0 + sign;
    signs.into_iter().fold(0.0, one_more)
}

/// [`digits`] of the signs of a period that is read from anywhere: from its forward motion on, if it has any.
pub(crate) fn from_forward(mut signs: Vec<f64>) -> f64 {
    let forward = signs.iter().position(|sign| *sign > 0.0);
    signs.rotate_left(forward.unwrap_or(0));
    digits(signs)
}

/// The digits of a simulated motion.
///
/// # Errors
/// As [`attractor_from`].
pub fn simulated(q: f64, lambda0: f64) -> Result<f64, Failure> {
    Ok(own_digits(attractor(q, lambda0)?.intervals()))
}

/// [`digits`] of the intervals of a motion.
pub(crate) fn own_digits(intervals: &[Interval]) -> f64 {
    digits(intervals.iter().map(|interval| interval.sign.factor()))
}

/// [`digits`] of the regions I to V by the words of the list.
pub(crate) fn listed_digits() -> [f64; 5] {
    printed::signs().map(digits)
}

/// The region, 1 to 5, whose printed words have these digits; 0 if none has.
pub fn fits(digits: f64) -> usize {
    let place = listed_digits().iter().position(|listed| *listed == digits);
    place.map_or(0, |i| i + 1)
}

/// Below any curve of the plane.
const LOWEST: f64 = 1e-12;

/// λ₀ on the printed curve A.
///
/// # Errors
/// No solution of (53), which does not happen for 0 < q < 1e5.
pub fn curve_a(q: f64) -> Result<f64, Failure> {
    let k = printed::eq53_k(q);
    let sides = |lambda0| difference(printed::eq53_sides(k, lambda0));
    Ok(root(sides, LOWEST, 1.0)?)
}

/// λ₀ on the printed curve B, if (54) has a solution there. It has at most one: left less right side falls
/// with λ₀ wherever both have values.
///
/// # Errors
/// A value that is not a number, which does not happen for q ≥ 1.
pub fn curve_b(q: f64) -> Result<Option<f64>, Failure> {
    crossing(q, 1.0, printed::eq54_sides)
}

/// λ₀ at which the sides are equal, if their difference has not this sign where qλ₀ = 1.
fn crossing(q: f64, sign: f64, sides: fn(f64, f64) -> [f64; 2]) -> Result<Option<f64>, Failure> {
    let sides = |lambda0| difference(sides(lambda0, q * lambda0));
    let top = largest(q);
    if sign * sides(top) > 0.0 {
        return Ok(None);
    }
    Ok(Some(root(sides, LOWEST, top)?))
}

/// λ₀ on the curve E of the corrections, if there is one. Left less right side is 0 at λ₀ = 0, falls, and
/// rises again, so that there is one more root or none.
///
/// # Errors
/// A value that is not a number, which does not happen for q ≥ 1.
pub fn curve_e(q: f64) -> Result<Option<f64>, Failure> {
    crossing(q, -1.0, corrected::e_sides)
}

fn difference([left, right]: [f64; 2]) -> f64 {
    left - right
}

/// The largest λ₀ with qλ₀ ≤ 1, in floating point too: 1/q is off by less than half the step that follows 1, so that
/// its product with q is not rounded to more than 1.
fn largest(q: f64) -> f64 {
    1.0 / q
}

/// All curves at one q, printed and corrected.
#[derive(Debug, Clone, Copy)]
pub struct Curves {
    /// The ratio q.
    pub q: f64,
    /// As printed.
    pub printed: printed::Curves,
    /// As corrected.
    pub corrected: corrected::Curves,
}

impl Curves {
    /// The curves at this q ≥ 1.
    ///
    /// # Errors
    /// A formula without a root.
    pub fn at(q: f64) -> Result<Self, Failure> {
        let printed = curves_as_printed(q)?;
        Ok(Curves {
            q,
            printed,
            corrected: corrected_by(q, printed)?,
        })
    }
}

/// The printed curves at this q ≥ 1.
pub(crate) fn curves_as_printed(q: f64) -> Result<printed::Curves, Failure> {
    Ok(printed::Curves {
        a: curve_a(q)?,
        b: curve_b(q)?,
        c: printed::eq55_lambda0(q),
        d: printed::eq56_lambda0(),
    })
}

/// The corrected curves at this q ≥ 1.
pub(crate) fn curves_as_corrected(q: f64) -> Result<corrected::Curves, Failure> {
    corrected_by(q, curves_as_printed(q)?)
}

fn corrected_by(
    q: f64,
    printed::Curves { a, b, c, d }: printed::Curves,
) -> Result<corrected::Curves, Failure> {
    let b_or_e = match b {
        Some(b) => Some(b),
        None => curve_e(q)?,
    };
    let neither = || format!("neither B nor E has a point at q = {q}");
    Ok(corrected::Curves {
        a,
        b_or_e: b_or_e.ok_or_else(neither)?,
        c: b.map(|_| c),
        d,
    })
}

/// The region, 1 to 5, of a λ₀ at one q. None on a curve, and where a curve has no value.
pub type Regions = Box<dyn Fn(f64) -> Option<usize>>;

/// The regions at this q by the printed list.
pub(crate) fn printed_list(q: f64) -> Regions {
    let curves = where_defined(curves_as_printed(q));
    Box::new(move |lambda0| printed::region(lambda0, curves.as_ref()?))
}

/// The regions at this q by the corrected list.
pub(crate) fn corrected_list(q: f64) -> Regions {
    let curves = where_defined(curves_as_corrected(q));
    Box::new(move |lambda0| corrected::region(lambda0, curves.as_ref()?))
}

/// Where the kind of motion changes at one q, by simulation alone.
#[derive(Debug, Clone, Copy)]
pub struct Changes {
    /// The least λ₀ with an interval of rest.
    pub rest: f64,
    /// The largest λ₀ at which forward motion turns into backward motion without a rest.
    pub reversal: f64,
    /// The largest λ₀ with backward motion.
    pub backward: f64,
    /// The largest λ₀ with any motion.
    pub motion: f64,
}

impl Changes {
    /// The four from the lowest up.
    pub fn upwards(&self) -> [f64; 4] {
        [self.rest, self.reversal, self.backward, self.motion]
    }

    /// Finds them between `low` and 1.4.
    ///
    /// # Errors
    /// As [`attractor_from`].
    pub fn at(q: f64, low: f64, start: DriveState) -> Result<Self, Failure> {
        let moves = |list: &[Interval]| list.iter().any(|i| i.sign != Sign::Rest);
        Ok(Changes {
            rest: change(q, low, start, restless)?,
            reversal: change(q, low, start, reverses)?,
            backward: change(q, low, start, backward)?,
            motion: change(q, low, start, moves)?,
        })
    }
}

/// The largest λ₀ with backward motion at this q.
pub(crate) fn last_backward(q: f64) -> Result<f64, Failure> {
    change(q, 1e-9, START, backward)
}

fn backward(list: &[Interval]) -> bool {
    list.iter().any(|i| i.sign == Sign::Negative)
}

/// The λ₀ between `low` and 1.4 at which `holds` changes, by bisection on the list of intervals, to neighbouring
/// numbers.
///
/// # Errors
/// As [`attractor_from`].
pub fn change(
    q: f64,
    low: f64,
    start: DriveState,
    holds: impl Fn(&[Interval]) -> bool,
) -> Result<f64, Failure> {
    bisect(low, 1.4, |lambda0| {
        let friction = Friction::new(lambda0, q * lambda0)?;
        Ok(holds(attractor_from(start, friction)?.intervals()))
    })
}

/// Whether there is no interval of rest.
pub(crate) fn restless(list: &[Interval]) -> bool {
    !list.iter().any(|i| i.sign == Sign::Rest)
}

/// Whether forward motion turns into backward motion without a rest.
pub fn reverses(list: &[Interval]) -> bool {
    let next = list.iter().cycle().skip(1);
    list.iter()
        .zip(next)
        .any(|(now, next)| now.sign == Sign::Positive && next.sign == Sign::Negative)
}

/// Where `holds` changes between `low` and `high`, to neighbouring numbers: the side on which it is as at `low`.
pub(crate) fn bisect(
    low: f64,
    high: f64,
    mut holds: impl FnMut(f64) -> Result<bool, Failure>,
) -> Result<f64, Failure> {
    let (mut a, mut b) = (low, high);
    let first = holds(a)?;
    if holds(b)? == first {
        return Err(format!("no change between {low} and {high}").into());
    }
    loop {
        let middle = 0.5 * (a + b);
        if middle <= a.min(b) || middle >= a.max(b) {
            return Ok(a);
        }
        if holds(middle)? == first {
            a = middle;
        } else {
            b = middle;
        }
    }
}

/// The q at which, along C, the forward motion ends just where the drive is lowest: Y by simulation alone.
pub(crate) fn simulated_y(start: DriveState) -> Result<f64, Failure> {
    bisect(2.0, 12.0, |q| {
        let motion = attractor_from(start, Friction::new(1.0 / q, 1.0)?)?;
        let forward = motion.intervals().iter().find(|i| i.sign == Sign::Positive);
        Ok(forward.ok_or("no forward motion on C")?.end < 1.5 * PI)
    })
}

/// The same, found once.
pub(crate) fn own_y() -> Result<f64, Failure> {
    static Y: Runs<f64> = Runs::new(|| simulated_y(START));
    Y.get().copied()
}

/// The point Y from the printed formulas: the q at which λ₀ = 1/q solves (54).
///
/// # Errors
/// No such q.
pub fn touching() -> Result<f64, Failure> {
    let sides = |q: f64| difference(printed::eq54_sides(printed::eq55_lambda0(q), 1.0));
    Ok(root(sides, 2.0, 12.0)?)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_largest_friction_is_within_the_domain() {
        for i in 0..100_000 {
            let q = 1.0 + 0.000_123_456_789 * f64::from(i);
            assert!(q * largest(q) <= 1.0, "{q}");
            assert!(q * (largest(q) * (1.0 + 1e-15)) > 1.0, "{q}");
        }
    }

    /// A region ends on its curves, of which no list says anything, and the next begins at the number beside.
    #[test]
    fn the_regions_end_where_their_curves_are() {
        let (a, b, c, d) = (0.1, 0.2, 0.3, 0.4);
        let printed = printed::Curves {
            a,
            b: Some(b),
            c,
            d,
        };
        let corrected = corrected::Curves {
            a,
            b_or_e: b,
            c: Some(c),
            d,
        };
        for (below, curve) in [(1, a), (2, b), (3, c), (4, d)] {
            let beside = [curve.next_down(), curve, curve.next_up()];
            let regions = [Some(below), None, Some(below + 1)];
            assert_eq!(
                beside.map(|x| printed::region(x, &printed)),
                regions,
                "{curve}"
            );
            assert_eq!(
                beside.map(|x| corrected::region(x, &corrected)),
                regions,
                "{curve}"
            );
        }
        // Beyond Y there is no B, and the list has no III.
        let beyond = printed::Curves { b: None, ..printed };
        assert_eq!(
            [b, c.next_down()].map(|x| printed::region(x, &beyond)),
            [Some(2); 2]
        );
    }

    #[test]
    fn orders_are_the_same_wherever_they_begin() {
        let orders = [
            &[1.0, 0.0, -1.0][..],
            &[0.0, -1.0, 1.0],
            &[-1.0, 0.0],
            &[0.0],
        ];
        let read = orders.map(|signs| from_forward(signs.to_vec()));
        assert_eq!(read, [321.0, 321.0, 12.0, 2.0]);
    }

    #[test]
    fn orders_are_read_as_digits() {
        assert_eq!(listed_digits(), [31.0, 312.0, 3212.0, 32.0, 2.0]);
        assert_eq!(
            [31.0, 312.0, 3212.0, 32.0, 2.0, 13.0].map(fits),
            [1, 2, 3, 4, 5, 0]
        );
    }

    #[test]
    fn a_list_without_rest_is_restless() {
        let list = [Sign::Positive, Sign::Negative, Sign::Rest].map(|sign| Interval {
            sign,
            start: 0.0,
            end: 1.0,
        });
        assert!(restless(&list[..2]) && !restless(&list) && !restless(&list[2..]));
    }

    #[test]
    fn the_curve_is_one_valued() {
        // Left less right side of (54) falls, that of E falls and rises: no second root anywhere.
        for i in 1..400 {
            let q = 1.0 + 0.05 * f64::from(i);
            let changes = |sides: fn(f64, f64) -> [f64; 2]| {
                let value = |k: u32| {
                    let lambda0 = f64::from(k) / 2000.0 / q;
                    difference(sides(lambda0, (q * lambda0).min(1.0)))
                };
                (1..2000).filter(|&k| value(k) * value(k + 1) < 0.0).count()
            };
            let b = usize::from(curve_b(q).unwrap().is_some());
            assert_eq!(changes(printed::eq54_sides), b, "q = {q}");
            assert_eq!(changes(corrected::e_sides), 1 - b, "q = {q}");
        }
    }
}
