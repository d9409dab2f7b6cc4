//! When the sliding coin moves, by the formulas alone, for many q at one λ₀: a few arithmetic operations each where
//! there is motion one way only, one root from a good guess where a slip has to be followed to its end.

use super::super::{SolveError, check};
use crate::paper::{anisotropic as printed, sinusoidal};
use std::f64::consts::{PI, TAU};

/// Forward and backward motion of a period of the large-time motion; rest in between.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arcs {
    /// Phases at which forward motion begins and ends; the first in [0, π), equal if there is none.
    pub forward: [f64; 2],
    /// Phases at which backward motion begins and ends, not before forward motion ends; equal if there is none.
    pub backward: [f64; 2],
}

/// What depends on q alone.
#[derive(Debug, Clone, Copy)]
pub struct Column {
    q: f64,
    /// K of (53), with its sine and cosine, and K/sin K.
    k: f64,
    sin: f64,
    cos: f64,
    ratio: f64,
}

impl Column {
    /// The column of q = μ₋/μ₊, from 1 to 10³.
    ///
    /// # Errors
    /// [`SolveError::Parameter`] for q out of range.
    pub fn new(q: f64) -> Result<Self, SolveError> {
        check("q", q, (1.0..=1e3).contains(&q), "between 1 and 1e3")?;
        let k = printed::eq53_k(q);
        let (sin, cos) = libm::sincos(k);
        Ok(Self {
            q,
            k,
            sin,
            cos,
            ratio: k / sin,
        })
    }
}

/// The columns at one λ₀, one after the other: neighbours begin their search where the last ones ended theirs.
#[derive(Debug, Clone)]
pub struct Row {
    lambda0: f64,
    /// Forward motion from rest to rest, with the sine and cosine of its last phase.
    forward: [f64; 2],
    sin: f64,
    cos: f64,
    /// The last three ends of backward slips, the newest first, and how many of them there are.
    last: [f64; 3],
    known: usize,
    /// Whether those followed forward motion at once.
    at_once: bool,
}

impl Row {
    /// The row of λ₀ = μ₊g/A₀, from 10⁻⁶ on.
    ///
    /// # Errors
    /// [`SolveError::Parameter`] for λ₀ out of range.
    pub fn new(lambda0: f64) -> Result<Self, SolveError> {
        let fit = (1e-6..=1e6).contains(&lambda0);
        check("lambda0", lambda0, fit, "between 1e-6 and 1e6")?;
        let mut forward = [0.0; 2];
        if lambda0 < 1.0 {
            let begin = sinusoidal::eq27_phi1(lambda0);
            let cos = libm::sqrt((1.0 - lambda0) * (1.0 + lambda0));
            forward = [begin, slip_end(lambda0, begin, cos, 4.0)];
        }
        let (sin, cos) = libm::sincos(forward[1]);
        Ok(Self {
            lambda0,
            forward,
            sin,
            cos,
            last: [0.0; 3],
            known: 0,
            at_once: false,
        })
    }

    /// The motions at the columns, one after the other, are put behind what is in `arcs`.
    pub fn fill(&mut self, columns: &[Column], arcs: &mut Vec<Arcs>) {
        arcs.extend(columns.iter().map(|column| self.at(column)));
    }

    /// The motion at a column.
    #[inline(always)]
    fn at(&mut self, column: &Column) -> Arcs {
        let (plus, minus) = (self.lambda0, column.q * self.lambda0);
        let [_, end] = self.forward;
        let one_way = Arcs {
            forward: self.forward,
            backward: [end; 2],
        };
        // Backward motion needs a drive below −qλ₀ after the end of forward motion.
        if minus >= 1.0 || (end > 1.5 * PI && -self.sin <= minus) {
            return one_way;
        }
        if let Some(arcs) = without_rest(plus, column) {
            return arcs;
        }
        // The backward slip is the forward slip under λ₋, half a period later.
        let at_once = -self.sin >= minus;
        let (start, cos) = if at_once {
            (end - PI, -self.cos)
        } else {
            (libm::asin(minus), libm::sqrt((1.0 - minus) * (1.0 + minus)))
        };
        if at_once != self.at_once {
            (self.at_once, self.known) = (at_once, 0);
        }
        let guess = expected(self.known, self.last, start);
        let stop = slip_end(minus, start, cos, guess);
        self.last = [stop, self.last[0], self.last[1]];
        self.known = (self.known + 1).min(3);
        Arcs {
            backward: [start + PI, stop + PI],
            ..one_way
        }
    }
}

/// Region I, as in [`super::without_rest`], with the addition theorem in place of sines of its phases.
fn without_rest(plus: f64, column: &Column) -> Option<Arcs> {
    let Column {
        k, sin, cos, ratio, ..
    } = *column;
    let sine = plus * ratio;
    if sine > 1.0 {
        return None;
    }
    let cosine = libm::sqrt((1.0 - sine) * (1.0 + sine));
    // Where forward motion may begin, backward motion may: see there.
    let holds = sine * cos + cosine * sin < plus;
    (!holds).then(|| {
        let middle = PI - libm::asin(sine);
        Arcs {
            forward: [middle - k, middle + k],
            backward: [middle + k, middle - k + TAU],
        }
    })
}

/// Where the next slip is expected to end: half a period after its start if no end is known, else on the constant, the
/// line or the parabola through the last ends, the newest first.
#[inline(always)]
fn expected(known: usize, [a, b, c]: [f64; 3], start: f64) -> f64 {
    match known {
        0 => start + PI,
        1 => a,
        2 => 2.0 * a - b,
        _ => 3.0 * (a - b) + c,
    }
}

/// Where a slip under `lambda` ends that begins from rest at `start`, whose cosine is `cos`: the root of (32) between
/// the phase at which it is fastest and one period after its start, by Halley's method in that bracket.
fn slip_end(lambda: f64, start: f64, cos: f64, guess: f64) -> f64 {
    let (mut low, mut high) = (start, start + TAU);
    let mut x = guess;
    for step in 0..STEPS {
        let slow = step >= BRACKET && step % 2 == 0;
        if slow || !(x > low && x < high) {
            low = low.max(sinusoidal::eq28_phi2(lambda));
            x = 0.5 * (low + high);
        }
        let (sine, cosine) = libm::sincos(x);
        let w = cos - cosine - lambda * (x - start);
        let slope = sine - lambda;
        if w > 0.0 {
            low = x;
        } else {
            high = x;
        }
        let newton = w / slope;
        let bend = 0.5 * cosine / slope;
        x -= newton / (1.0 - newton * bend);
        // The error after a small step is about this times its third power.
        let third = bend * bend + (sine / (6.0 * slope)).abs();
        if slope < 0.0 && (newton * newton * newton * third).abs() < CLOSE {
            return x;
        }
    }
    x
}

/// A step after which the next would be below rounding.
const CLOSE: f64 = 1e-17;
/// Steps after which every other one halves the bracket, and steps in all.
const BRACKET: usize = 8;
const STEPS: usize = 80;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::motion::drive::{Drive, Friction, Interval, Sign, State};

    /// Begin and end of the motion of one sign, within a turn of `near`.
    fn moved(intervals: &[Interval], sign: Sign, near: [f64; 2]) -> [f64; 2] {
        let found = intervals.iter().find(|i| i.sign == sign);
        found.map_or([near[1]; 2], |i| {
            let turn = TAU * libm::round((near[0] - i.start) / TAU);
            [i.start + turn, i.start + turn + i.length()]
        })
    }

    #[test]
    fn arcs_are_those_of_the_motion() {
        let drive = Drive::new(libm::sin, &[]).unwrap();
        let columns: Vec<_> = (0..150)
            .map(|i| 1.0 + 0.04 * f64::from(i))
            .map(|q| (q, Column::new(q).unwrap()))
            .collect();
        let (mut forward_only, mut both) = (0, 0);
        for j in 0..50 {
            let lambda0 = 0.011 + 0.0211 * f64::from(j);
            let mut row = Row::new(lambda0).unwrap();
            let mut found = Vec::new();
            row.fill(
                &columns.iter().map(|(_, c)| *c).collect::<Vec<_>>(),
                &mut found,
            );
            for ((q, _), arcs) in columns.iter().zip(found) {
                let friction = Friction::new(lambda0, q * lambda0).unwrap();
                let outcome = drive.attractor(friction, State { phi: 0.0, w: 0.0 }, 1000);
                let motion = outcome.unwrap().settled().unwrap();
                let intervals = motion.intervals();
                for (sign, arc) in [
                    (Sign::Positive, arcs.forward),
                    (Sign::Negative, arcs.backward),
                ] {
                    for (a, b) in arc.iter().zip(moved(intervals, sign, arc)) {
                        assert!(
                            (a - b).abs() < 1e-10,
                            "{q} {lambda0} {arcs:?} {intervals:?}"
                        );
                    }
                }
                // The phases themselves, not only up to a turn.
                let wait = arcs.backward[0] - arcs.forward[1];
                assert!(
                    (0.0..PI).contains(&arcs.forward[0]),
                    "{q} {lambda0} {arcs:?}"
                );
                assert!((-1e-14..TAU).contains(&wait), "{q} {lambda0} {arcs:?}");
                forward_only += usize::from(arcs.backward[0] == arcs.backward[1]);
                both += usize::from(arcs.backward[0] < arcs.backward[1]);
            }
        }
        assert!(forward_only > 1000 && both > 1000, "{forward_only} {both}");
    }

    #[test]
    fn the_end_of_a_slip_is_found_from_any_guess() {
        for lambda in [1e-6, 1e-3, 0.05, 0.3, 0.6, 0.8, 0.95, 0.99] {
            let fastest = sinusoidal::eq28_phi2(lambda);
            let first = PI - fastest;
            for part in [0.0, 0.2, 0.5, 0.9] {
                let start = first + part * (fastest - first);
                let w = |x: f64| libm::cos(start) - libm::cos(x) - lambda * (x - start);
                let (mut low, mut high) = (fastest, start + TAU);
                for _ in 0..200 {
                    let middle = 0.5 * (low + high);
                    *(if w(middle) > 0.0 { &mut low } else { &mut high }) = middle;
                }
                for guess in [
                    -20.0,
                    start - 1e-9,
                    start,
                    start + 0.01,
                    first,
                    0.5 * PI,
                    fastest,
                    fastest + 1e-9,
                    3.0,
                    4.0,
                    5.0,
                    6.2,
                    start + TAU - 1e-6,
                    start + TAU,
                    40.0,
                    f64::NAN,
                ] {
                    let end = slip_end(lambda, start, libm::cos(start), guess);
                    // What rounding of w can move the root.
                    let room = 1e-14 + 4e-16 / (libm::sin(low) - lambda).abs();
                    assert!(
                        (end - low).abs() < room,
                        "{lambda} {start} {guess}: {end} {low}"
                    );
                }
            }
        }
    }

    #[test]
    fn the_end_of_a_slip_is_found_where_every_other_step_has_to_halve_the_bracket() {
        // From this guess steps without a halving run in a circle.
        let (lambda, start, guess) = (0.9367950615036835, 1.213354850618772, 1.213354850619964);
        let end = slip_end(lambda, start, libm::cos(start), guess);
        assert!((end - 2.290371042685266).abs() < 1e-13, "{end}");
    }

    #[test]
    fn what_lies_outside_is_named() {
        assert!(
            Column::new(0.5)
                .unwrap_err()
                .to_string()
                .contains("q = 0.5")
        );
        assert!(
            Row::new(f64::NAN)
                .unwrap_err()
                .to_string()
                .contains("lambda0")
        );
    }

    #[test]
    fn the_shortest_backward_slips_are_not_missed() {
        // Forward motion ends shortly before the drive is strongest, and that is hardly strong enough.
        let mut row = Row::new(0.226).unwrap();
        assert!(row.forward[1] > 1.5 + PI && row.forward[1] < 1.5 * PI);
        let q = 0.9999 / 0.226;
        let arcs = row.at(&Column::new(q).unwrap());
        let length = arcs.backward[1] - arcs.backward[0];
        let problem = crate::claims::solve::anisotropic::Problem { q, lambda0: 0.226 };
        let period = problem.solve().unwrap().best;
        assert_eq!(period.region, "III");
        assert!(
            (length - period.negative).abs() < 1e-10,
            "{length} {period:?}"
        );
        // So short a slip lasts three times as long as the drive takes from λ₋ to its height.
        let rise = libm::acos(0.9999);
        assert!((length / rise - 3.0).abs() < 1e-3, "{length} {rise}");
    }

    #[test]
    fn ends_are_expected_on_the_parabola_through_the_last_three() {
        let ends = [9.0, 4.0, 1.0];
        let expected = [0, 1, 2, 3].map(|known| expected(known, ends, 0.5));
        assert_eq!(expected, [0.5 + PI, 9.0, 14.0, 16.0]);
    }

    #[test]
    fn the_last_ends_are_forgotten_where_slips_begin_otherwise() {
        let (mut changes, mut full) = (0, 0);
        for lambda0 in [0.25, 0.3, 0.35, 0.4] {
            let mut row = Row::new(lambda0).unwrap();
            let (mut known, mut kind) = (0, None);
            for i in 0..300 {
                let column = Column::new(1.0 + 0.01 * f64::from(i)).unwrap();
                let before = row.last;
                let arcs = row.at(&column);
                if row.last == before {
                    continue;
                }
                let at_once = (arcs.backward[0] - arcs.forward[1]).abs() < 1e-12;
                if kind.is_some_and(|kind| kind != at_once) {
                    changes += 1;
                    known = 0;
                }
                kind = Some(at_once);
                known = (known + 1).min(3);
                full += usize::from(known == 3);
                assert_eq!((row.known, row.at_once), (known, at_once), "{}", column.q);
                assert_eq!(row.last[0] + PI, arcs.backward[1]);
                assert_eq!(row.last[1..], before[..2]);
            }
        }
        assert!(changes > 0 && full > 100, "{changes} {full}");
    }
}
