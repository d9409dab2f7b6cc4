//! How a trial compares stated and found values, over many points, into one [`Evidence`].

use super::points::Points;
pub use super::runs::Failure;
use super::runs::parts;
use super::tolerances;
pub use crate::evidence::Compared;
use crate::evidence::{Evidence, Lemma, Route, Sample, Subject, Tolerance};
use crate::exact::{Obstacle, Proof, Step};
use crate::numerics::double::Double;
use crate::numerics::number::Real;
use crate::seeded::reading;
use std::borrow::Borrow;
use std::collections::HashSet;

/// One comparison.
pub struct Pair {
    /// The point, in the claim's own symbols.
    pub at: String,
    /// What the claim says.
    pub stated: f64,
    /// What was found without it.
    pub found: f64,
    /// The size in units of which the two may differ: that of the largest term, not less.
    pub scale: f64,
}

impl Pair {
    /// A stated against a found number, in units of 1.
    pub fn plain(at: String, stated: f64, found: f64) -> Self {
        Pair {
            at,
            stated,
            found,
            scale: 1.0,
        }
    }

    /// The difference in units of the scale: infinite where the claim alone has no value, NaN where our own
    /// side has none.
    pub fn disagreement(&self) -> f64 {
        if !self.found.is_finite() || !self.scale.is_finite() || self.scale <= 0.0 {
            f64::NAN
        } else if !self.stated.is_finite() {
            f64::INFINITY
        } else {
            (self.stated - self.found).abs() / self.scale
        }
    }
}

/// The value, where there is one: for what need not have one, such as a curve that ends.
pub fn where_defined<T, E>(found: Result<T, E>) -> Option<T> {
    found.ok()
}

/// 1 if something is so, else 0, to compare.
pub fn is(truth: bool) -> f64 {
    f64::from(u8::from(truth))
}

/// A trial in the making: how, about what, and how close.
pub struct Trial {
    /// The route.
    pub route: Route,
    /// What it speaks about.
    pub subject: Subject,
    /// What is compared with what.
    pub compared: Compared,
    /// What counts as agreement.
    pub tolerance: Tolerance,
}

impl Trial {
    /// A formula or statement against the integrated motion.
    pub fn motion(subject: Subject, compared: impl Into<Compared>) -> Self {
        Self::by(Route::Integration, subject, compared, tolerances::MOTION)
    }

    /// A formula against a quadrature.
    pub fn quadrature(subject: Subject, compared: impl Into<Compared>) -> Self {
        Self::by(Route::Quadrature, subject, compared, tolerances::QUADRATURE)
    }

    /// Something that is so or not, or is counted, case by case.
    pub fn census(subject: Subject, compared: impl Into<Compared>) -> Self {
        Self::by(Route::Census, subject, compared, tolerances::NONE)
    }

    /// Two ways to the same, of which each may have the motion in it.
    pub fn consistency(subject: Subject, compared: impl Into<Compared>) -> Self {
        Self::by(Route::Consistency, subject, compared, tolerances::MOTION)
    }

    /// By any route, to any tolerance.
    pub fn by(
        route: Route,
        subject: Subject,
        compared: impl Into<Compared>,
        tolerance: Tolerance,
    ) -> Self {
        Trial {
            route,
            subject,
            compared: compared.into(),
            tolerance,
        }
    }

    /// Compares at every point; where our own side fails, the evidence is NaN and says why.
    pub fn over<P>(
        &self,
        points: impl IntoIterator<Item = P>,
        mut pair: impl FnMut(P) -> Result<Pair, Failure>,
    ) -> Evidence {
        let mut points = points.into_iter();
        self.gather(&mut || points.next().map(&mut pair))
    }

    /// The same for cases that each draw what else they need, from one stream for all.
    pub fn drawn<P>(
        &self,
        cases: impl IntoIterator<Item = P>,
        mut pair: impl FnMut(P, &mut Points) -> Result<Pair, Failure>,
    ) -> Evidence {
        let mut points = Points::here();
        self.over(cases, |case| pair(case, &mut points))
    }

    /// The same for runs: `at` tells the point, `values` what is stated, what is found and the scale.
    pub fn each<X, P: Borrow<X>, E: Into<Failure>>(
        &self,
        runs: impl IntoIterator<Item = Result<P, E>>,
        at: impl Fn(&X) -> String,
        values: impl Fn(&X) -> Result<[f64; 3], Failure>,
    ) -> Evidence {
        self.over(runs, |run| {
            let run = run.map_err(Into::into)?;
            let [stated, found, scale] = values(run.borrow())?;
            Ok(Pair {
                at: at(run.borrow()),
                stated,
                found,
                scale,
            })
        })
    }

    /// The same with more than one pair at a point.
    pub fn pairs<P>(
        &self,
        points: impl IntoIterator<Item = P>,
        pairs: impl FnMut(P) -> Result<Vec<Pair>, Failure>,
    ) -> Evidence {
        let all = points.into_iter().map(pairs).flat_map(parts);
        self.over(all, |pair| pair)
    }

    /// Apart from what is generic, to be compiled once.
    fn gather(&self, next: &mut dyn FnMut() -> Option<Result<Pair, Failure>>) -> Evidence {
        let mut evidence = Evidence::new(self.route, self.subject, self.compared, self.tolerance);
        let mut kept = Taken::default();
        while let Some(pair) = next() {
            if !take(&mut evidence, &mut kept, pair) {
                break;
            }
        }
        evidence
    }
}

impl Trial {
    /// Compares at every point of these coordinates; `scale` is the size of the largest term at any of them.
    pub fn at<const N: usize>(
        &self,
        names: [&str; N],
        points: impl IntoIterator<Item = [f64; N]>,
        scale: f64,
        pair: impl Fn([f64; N]) -> Result<[f64; 2], Failure>,
    ) -> Evidence {
        self.over(points, |point| {
            let [stated, found] = pair(point)?;
            let named = names.iter().zip(point);
            let at: Vec<_> = named.map(|(name, x)| format!("{name} = {x:.3}")).collect();
            Ok(Pair {
                at: at.join(", "),
                stated,
                found,
                scale,
            })
        })
    }
}

fn take(evidence: &mut Evidence, kept: &mut Taken, pair: Result<Pair, Failure>) -> bool {
    let pair = match pair {
        Ok(pair) => pair,
        Err(error) => {
            (evidence.worst, evidence.at) = (f64::NAN, error.to_string());
            return false;
        }
    };
    evidence.points += 1;
    let sides = &mut evidence.sides;
    for (side, value) in [
        (&mut sides.stated, pair.stated),
        (&mut sides.found, pair.found),
        (&mut sides.scale, pair.scale),
    ] {
        *side = with_word(*side, value.to_bits());
    }
    let words = [pair.stated, pair.found, pair.scale].map(f64::to_bits);
    let point = pair.at.bytes().map(u64::from).chain(words);
    evidence.repeated += usize::from(!kept.points.insert(point.fold(0, with_word)));
    let [least, most] = evidence.scales;
    evidence.scales = [least.min(pair.scale), most.max(pair.scale)];
    let disagreement = pair.disagreement();
    if disagreement.is_nan() {
        (evidence.worst, evidence.at) = (f64::NAN, pair.at);
        return false;
    }
    evidence.ranges.take(&pair.at);
    let sample = Sample {
        at: pair.at,
        stated: pair.stated,
        found: pair.found,
    };
    // Of two that differ in last bits only, the first one is named on every machine.
    let farther = disagreement > (1.0 + 1e-9) * evidence.worst;
    evidence.worst = evidence.worst.max(disagreement);
    if evidence.at.is_empty() || farther {
        evidence.at.clone_from(&sample.at);
        evidence.farthest = Some(sample.clone());
    }
    kept.sort.keep(evidence, sample, disagreement);
    true
}

#[derive(Default)]
struct Taken {
    points: HashSet<u64>,
    sort: Kept,
}

/// Those that agree; as soon as one disagrees, those that do; as soon as one does plainly, those: others may
/// turn on a last bit.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Kept {
    #[default]
    Agreeing,
    Beyond,
    Plainly,
}

impl Kept {
    pub(super) fn keep(&mut self, evidence: &mut Evidence, sample: Sample, disagreement: f64) {
        let tolerance = evidence.tolerance.value;
        let sort = match disagreement {
            d if d > PLAINLY * tolerance => Kept::Plainly,
            d if d > tolerance => Kept::Beyond,
            _ => Kept::Agreeing,
        };
        evidence.failed += usize::from(sort > Kept::Agreeing);
        if sort > *self {
            *self = sort;
            evidence.samples.clear();
        }
        if sort == *self && (evidence.samples.len() < SAMPLES || evidence.route.is_proof()) {
            evidence.samples.push(sample);
        }
    }
}

const PLAINLY: f64 = 10.0;

fn with_word(sum: u64, word: u64) -> u64 {
    (sum.rotate_left(5) ^ word).wrapping_mul(0x517c_c1b7_2722_0a95)
}

/// How many compared pairs are kept for readers: the first ones, which do not depend on last bits.
pub const SAMPLES: usize = 3;

impl Pair {
    /// A formula's value against a found one, in units of that. In numbers of twice the width its own
    /// rounding does not show.
    pub fn wide(at: String, stated: Double, found: f64) -> Self {
        Pair {
            at,
            stated: stated.to_f64(),
            found,
            scale: found.abs(),
        }
    }

    /// The same, in units of this size.
    pub fn within(self, scale: f64) -> Self {
        Pair { scale, ..self }
    }
}

/// What a trial brings, with the formulas that it has read.
pub fn noted(trial: impl FnOnce() -> Evidence) -> Evidence {
    let (mut evidence, read) = reading::of(trial);
    if read.failures > 0 && !evidence.worst.is_nan() {
        evidence.worst = f64::NAN;
        evidence.at = format!("{} runs or values failed and were left out", read.failures);
    }
    evidence.read.extend(read.formulas);
    evidence.runs.extend(read.runs);
    evidence
}

fn steps(proof: &Proof) -> Vec<String> {
    proof.steps().iter().map(Step::to_string).collect()
}

pub(super) fn lemma(proof: &Proof) -> Lemma {
    Lemma {
        title: proof.title().to_owned(),
        steps: steps(proof),
    }
}

/// Evidence from a proof, with its steps.
pub fn proved(proof: &Proof, subject: Subject, compared: Compared) -> Evidence {
    // Of two sides that are said to be compared, the proof itself has to compare something.
    let is_idle = compared.found().is_some() && !proof.compares();
    Evidence {
        points: 1,
        // A step that cannot be carried out says nothing about the claim.
        worst: match proof.obstacle() {
            None if is_idle => f64::NAN,
            None => 0.0,
            Some(Obstacle::NotZero { .. }) => f64::INFINITY,
            Some(_) => f64::NAN,
        },
        at: match proof.obstacle() {
            Some(Obstacle::NotZero { says, normal_form }) => {
                format!("the step “{says}” leaves the difference {normal_form}, not 0")
            }
            Some(obstacle) => format!("a step of the proof fails ({obstacle})"),
            None if is_idle => "it compares nothing itself".to_owned(),
            None => String::new(),
        },
        steps: steps(proof),
        lemmas: proof.premises().into_iter().map(lemma).collect(),
        title: proof.title().to_owned(),
        positive: proof.positive().into_iter().map(str::to_owned).collect(),
        ..Evidence::new(Route::Exact, subject, compared, tolerances::NONE)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::Scalar;

    #[test]
    fn what_disagrees_is_counted_and_kept_for_readers() {
        let trial = Trial::by(
            Route::Census,
            Subject::Printed,
            Compared::one("$n$", "what is found"),
            tolerances::NONE,
        );
        let of = |fails: fn(u8) -> bool| {
            trial.over(0..30, |n| {
                Ok(Pair {
                    at: format!("n = {n}"),
                    stated: f64::from(n),
                    found: f64::from(n) + f64::from(u8::from(fails(n))),
                    scale: 1.0,
                })
            })
        };
        let shown = |e: &Evidence| -> Vec<f64> { e.samples.iter().map(|s| s.stated).collect() };
        let agrees = of(|_| false);
        assert_eq!((agrees.failed, shown(&agrees)), (0, vec![0.0, 1.0, 2.0]));
        assert_eq!(agrees.result(), "All agree; no disagreement is allowed.");
        let fails = of(|n| n % 10 == 4);
        assert_eq!((fails.failed, shown(&fails)), (3, vec![4.0, 14.0, 24.0]));
        assert_eq!(
            format!("{} {}", fails.comparison(), fails.result()),
            "$n$ was compared with what is found, case by case, at 30 points, n from 0 to 29. \
             3 of 30 disagree; no disagreement is allowed."
        );
    }

    #[test]
    fn without_a_size_nothing_is_compared() {
        let of = |stated, found, scale| {
            let at = String::new();
            let pair = Pair {
                at,
                stated,
                found,
                scale,
            };
            pair.disagreement()
        };
        for scale in [0.0, -0.0, -1.0, f64::NAN, f64::INFINITY] {
            for found in [1.0, 2.0] {
                assert!(of(1.0, found, scale).is_nan(), "{found} {scale}");
            }
        }
        assert_eq!(of(1.0, 2.0, 4.0), 0.25);
    }

    #[test]
    fn what_cancels_in_a_formula_widens_no_scale() {
        let plain = |x: Double| x.squared();
        let padded = |x: Double| x.squared() + Double::int(1_000_000) - Double::int(1_000_000);
        for found in [0.01, 0.01 * (1.0 + 1e-12)] {
            let [one, other] = [plain(0.1.into()), padded(0.1.into())]
                .map(|stated| Pair::wide(String::new(), stated, found));
            assert_eq!(one.scale, other.scale);
            assert_eq!(one.disagreement(), other.disagreement());
            let tolerance = tolerances::MOTION.value;
            assert_eq!(other.disagreement() <= tolerance, found == 0.01);
        }
    }
}
