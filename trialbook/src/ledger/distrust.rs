//! Trials held against mistakes seeded in what they read: each has to notice, and what it finds without the
//! paper has to stay.

use super::{Entry, Key, Ledger, parallel};
use crate::evidence::{Evidence, Outcome, Subject};
use crate::seeded::{self, Mistake, Seed};
use crate::trials::variants::Variant;
use std::collections::BTreeMap;
use std::iter::once;

/// What a trial does when a mistake is seeded.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Reaction {
    /// Its outcome is another one.
    pub rejects: bool,
    /// What it takes for stated is another number somewhere.
    pub stated: bool,
    /// What it finds is another number, or is looked for at other points.
    pub found: bool,
    /// It compares in other units.
    pub scale: bool,
    /// How many of its comparisons disagree.
    pub failed: usize,
}

impl Reaction {
    fn between(before: &Evidence, after: &Evidence) -> Self {
        let measured = !after.route.is_proof();
        let found = |e: &Evidence| (e.sides.found, e.points);
        Reaction {
            rejects: after.outcome() != before.outcome(),
            stated: after.sides.stated != before.sides.stated,
            found: measured && found(after) != found(before),
            scale: measured && after.sides.scale != before.sides.scale,
            failed: after.failed,
        }
    }

    fn leans(&self) -> bool {
        self.found || self.scale
    }
}

/// How many mistakes are seeded in each formula that a trial reads.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Extent {
    /// All.
    Every,
    /// A few, and then others until one is rejected.
    Few,
}

/// Mistakes that [`Extent::Few`] seeds in any case.
const FEW: usize = 4;

/// A trial, and what it does when mistakes are seeded in what it reads.
#[derive(Debug, Clone)]
pub struct Tried {
    /// The number of the entry in the ledger.
    pub entry: usize,
    /// The number of the trial.
    pub trial: usize,
    /// True if it agrees without a mistake.
    pub agrees: bool,
    /// The reactions, with the numbers of the variants.
    pub reactions: Vec<(usize, Reaction)>,
}

impl Tried {
    /// How many mistakes it rejects.
    pub fn rejected(&self) -> usize {
        self.reactions.iter().filter(|(_, r)| r.rejects).count()
    }

    /// How many comparisons disagree with the mistakes, in all.
    pub fn failed(&self) -> usize {
        self.reactions.iter().map(|(_, r)| r.failed).sum()
    }

    /// The first variant that changes what it finds, or its units.
    pub fn leans_on(&self) -> Option<usize> {
        let first = self.reactions.iter().find(|(_, r)| r.leans());
        first.map(|(variant, _)| *variant)
    }
}

/// What a condition excepts may be about a set of motions, whatever a formula says of it; but where it reads
/// one, that has no value there, another one has.
fn has_to_notice(evidence: &Evidence) -> bool {
    let is_a_set = evidence.subject == Subject::Excepted && evidence.read.is_empty();
    evidence.outcome() == Outcome::Agrees && !is_a_set
}

impl Entry {
    /// All that the trial does has to stay on this thread.
    pub(super) fn reaction(&self, trial: usize, seed: Seed) -> Reaction {
        let before = &self.evidence[trial];
        let after = seeded::with(seed, || self.claim.trials[trial].evidence());
        Reaction::between(before, &after)
    }
}

fn by_formula(variants: &[Variant]) -> BTreeMap<&str, Vec<usize>> {
    let mut of_formula = BTreeMap::<&str, Vec<usize>>::new();
    for (i, variant) in variants.iter().enumerate() {
        of_formula.entry(variant.seed.formula).or_default().push(i);
    }
    of_formula
}

impl Ledger {
    /// How often [`Ledger::distrust`] puts a mistake to a trial.
    pub(crate) fn mistakes_put(&self) -> usize {
        let variants = self.paper.formulas.variants();
        let of_formula = by_formula(&variants);
        let read = self.evidence().flat_map(|e| &e.read);
        read.filter_map(|formula| of_formula.get(formula))
            .map(Vec::len)
            .sum()
    }

    /// What every trial does when mistakes are seeded in what it reads. `done` is called after each trial.
    pub fn distrust(
        &self,
        variants: &[Variant],
        extent: Extent,
        done: impl Fn() + Sync,
    ) -> Vec<Tried> {
        let of_formula = by_formula(variants);
        let entries = self.entries.iter().enumerate();
        let trials: Vec<_> = entries
            .flat_map(|(entry, e)| (0..e.evidence.len()).map(move |trial| (entry, trial)))
            .collect();
        parallel::each(trials.len(), |i| {
            let (entry, trial) = trials[i];
            let evidence = &self.entries[entry].evidence[trial];
            let read = evidence.read.iter();
            let read: Vec<_> = read.filter_map(|f| of_formula.get(f)).collect();
            let reactions = self.reactions(entry, trial, &read, variants, extent);
            done();
            Tried {
                entry,
                trial,
                agrees: has_to_notice(evidence),
                reactions,
            }
        })
    }

    /// The measurements whose findings or units move with a mistake in a formula, with that formula.
    pub fn leaning(&self) -> Vec<(Key, &'static str, &'static str)> {
        let variants = self.paper.formulas.variants();
        let of_formula = by_formula(&variants);
        let entries = self.entries.iter().enumerate();
        let trials = entries.flat_map(|(entry, e)| (0..e.evidence.len()).map(move |t| (entry, t)));
        let read = trials.flat_map(|(entry, trial)| {
            let evidence = &self.entries[entry].evidence[trial];
            let read = evidence.read.iter().filter(|_| !evidence.route.is_proof());
            read.map(move |formula| (entry, trial, *formula))
        });
        let read: Vec<_> = read.collect();
        let leans = parallel::each(read.len(), |i| {
            let (entry, trial, formula) = read[i];
            let half_more = Seed::of_value(formula, Mistake::Part(2));
            let places = of_formula.get(formula).into_iter().flatten();
            let seeds = once(half_more).chain(places.map(|i| variants[*i].seed));
            let reactions = seeds
                .take(FEW)
                .map(|seed| self.entries[entry].reaction(trial, seed));
            let mut seen = reactions.filter(|r| r.stated || r.leans());
            seen.next().is_some_and(|reaction| reaction.leans())
        });
        let leaning = read.into_iter().zip(leans).filter(|(_, leans)| *leans);
        leaning
            .map(|((entry, trial, formula), _)| {
                let of = &self.entries[entry];
                (of.key(trial), of.evidence[trial].trial, formula)
            })
            .collect()
    }

    fn reactions(
        &self,
        entry: usize,
        trial: usize,
        read: &[&Vec<usize>],
        variants: &[Variant],
        extent: Extent,
    ) -> Vec<(usize, Reaction)> {
        let entry = &self.entries[entry];
        let reaction = |i: usize| (i, entry.reaction(trial, variants[i].seed));
        if extent == Extent::Every {
            return read
                .iter()
                .copied()
                .flatten()
                .copied()
                .map(reaction)
                .collect();
        }
        let few = read.iter().flat_map(|of_one| {
            let step = of_one.len().div_ceil(FEW);
            of_one.iter().step_by(step.max(1))
        });
        let mut reactions: Vec<_> = few.copied().map(reaction).collect();
        let agrees = has_to_notice(&entry.evidence[trial]);
        let mut others = read.iter().copied().flatten();
        while agrees
            && reactions.iter().all(|(_, r)| !r.rejects)
            && let Some(other) = others.next()
        {
            reactions.push(reaction(*other));
        }
        reactions
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evidence::{Compared, Route, Sides};
    use crate::trials::tolerances::NONE;

    #[test]
    fn a_trial_leans_on_what_moves_its_own_side_or_its_units() {
        let before = |route| Evidence {
            points: 40,
            ..Evidence::new(route, Subject::Printed, Compared::one("$a$", "$b$"), NONE)
        };
        let sides = |stated, found, scale| Sides {
            stated,
            found,
            scale,
        };
        for (points, sides, leans) in [
            (40, sides(0, 0, 0), false),
            (40, sides(1, 0, 0), false),
            (40, sides(1, 1, 0), true),
            (40, sides(1, 0, 1), true),
            (39, sides(1, 0, 0), true),
        ] {
            for route in [Route::Census, Route::Exact] {
                let before = before(route);
                let after = Evidence {
                    points,
                    sides,
                    ..before.clone()
                };
                let reaction = Reaction::between(&before, &after);
                assert_eq!(reaction.stated, sides.stated == 1);
                let tried = Tried {
                    entry: 0,
                    trial: 0,
                    agrees: true,
                    reactions: vec![(7, reaction)],
                };
                let expected = (leans && route == Route::Census).then_some(7);
                assert_eq!(tried.leans_on(), expected, "{points} {sides:?}");
            }
        }
    }
}
