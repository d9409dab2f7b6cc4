//! A formula that the reader breaks, and which trials of its claim notice: what a page of the book asks, compiled to
//! WebAssembly. Some topics take part, to keep the module small.

use crate::claims::{constant, escape, formulas::FORMULAS, rest, sphere};
use crate::evidence::{Evidence, Outcome};
use crate::scalar::Scalar;
use crate::seeded::{Formula, Mistake, Seed, with};
use crate::{corrections, paper};
use serde::Serialize;
use std::collections::BTreeSet;
use trialbook::notation::plain_words;
use trialbook::trials::{
    Claim, Topic,
    formulas::{Formulas, text},
};

/// The topics that take part.
pub static TOPICS: [&Topic; 4] = [
    &constant::TOPIC,
    &sphere::TOPIC,
    &escape::TOPIC,
    &rest::TOPIC,
];

fn own<S: Scalar>() -> Vec<Formula<S>> {
    [
        paper::constant::formulas(),
        paper::sphere::formulas(),
        paper::escape::formulas(),
        paper::rest::formulas(),
        corrections::constant::formulas(),
        corrections::sphere::formulas(),
        corrections::escape::formulas(),
        corrections::rest::formulas(),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// Their formulas.
const OWN: Formulas = Formulas {
    numbers: own,
    trees: own,
    ..FORMULAS
};

/// So large a part of the value is made too much, as one over this number.
const PARTS: [i64; 3] = [100, 100_000, 100_000_000];

/// The claims with a formula that can be broken.
pub fn claims() -> Vec<&'static Claim> {
    let tried: BTreeSet<_> = own::<f64>().iter().filter_map(Formula::claim).collect();
    let all = TOPICS.iter().flat_map(|topic| topic.claims());
    all.filter(|claim| tried.contains(claim.id)).collect()
}

/// A way to break a formula.
#[derive(Debug, Clone, Serialize)]
pub struct Break {
    /// The formula's name in the code.
    pub formula: &'static str,
    /// The formula as it stands, in plain text.
    pub right: String,
    /// As it is broken.
    pub wrong: String,
    /// The mistake.
    #[serde(skip)]
    pub seed: Seed,
}

/// The ways to break the formulas of the claim of this id.
pub fn breaks(id: &str) -> Vec<Break> {
    let trees = own().into_iter().zip(own::<f64>());
    let mine = trees.filter(|(_, f)| f.claim().as_deref() == Some(id));
    mine.flat_map(|(tree, formula)| {
        let right = text(&tree);
        let of = |wrong, seed| Break {
            formula: formula.name,
            right: right.clone(),
            wrong,
            seed,
        };
        let places = OWN.variants_of(formula.name).into_iter();
        let places = places.map(|v| of(v.text, v.seed)).collect::<Vec<_>>();
        let parts = PARTS.iter().filter(|_| OWN.has_a_size(&formula));
        let parts = parts.map(|part| {
            let seed = Seed::of_value(formula.path, Mistake::Part(*part));
            of(format!("({right}) (1 + 1/{part})"), seed)
        });
        places.into_iter().chain(parts).collect::<Vec<_>>()
    })
    .collect()
}

/// By what a module that is made of other formulas or trials is told.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Made {
    /// Id, section and title of the claim.
    pub claim: [&'static str; 3],
    /// Its trials.
    pub trials: Vec<&'static str>,
    /// Of each way to break it the broken formula, and its values at a point; no number is nothing.
    pub ways: Vec<(String, Vec<Option<f64>>)>,
}

/// What the module knows of a claim without trying it.
pub fn made(claim: &Claim) -> Made {
    let formulas = own::<f64>();
    let ways = breaks(claim.id).into_iter().map(|way| {
        let mut broken = formulas.iter().filter(|f| f.path == way.seed.formula);
        let values = broken.next().map_or_else(Vec::new, |formula| {
            let point: Vec<_> = (1..=formula.symbols.len())
                .map(|n| 0.3 + 0.1 * n as f64)
                .collect();
            with(way.seed, || (formula.value)(&point))
        });
        let finite = |value: f64| Some(value).filter(|value| value.is_finite());
        (way.wrong, values.into_iter().map(finite).collect())
    });
    Made {
        claim: [claim.id, claim.section, claim.title],
        trials: claim.trials.iter().map(|trial| trial.name()).collect(),
        ways: ways.collect(),
    }
}

/// What a trial says of the formula as it stands, and broken.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Said {
    /// The trial's name.
    pub trial: &'static str,
    /// What it compares.
    pub compared: String,
    /// True if it reads the broken formula.
    pub reads: bool,
    /// Whether it agrees as the formula stands, and broken.
    pub agrees: [bool; 2],
    /// What it measures as the formula stands, and broken.
    pub measured: [String; 2],
}

/// What the claim's trials say: the verdict by itself as the formula stands, and broken, and every trial.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Answer {
    /// The words of the verdicts.
    pub verdicts: [&'static str; 2],
    /// The trials, in their order.
    pub trials: Vec<Said>,
}

/// Tries the claim as its formula stands and with the mistake; on this thread alone.
pub fn answer(claim: &Claim, seed: Seed) -> Answer {
    let evidence = || -> Vec<Evidence> { claim.trials.iter().map(|t| t.evidence()).collect() };
    // What the trials keep of motions is made without a mistake.
    let right = evidence();
    let wrong = with(seed, evidence);
    let both = right.iter().zip(&wrong);
    let trials = both.map(|(right, wrong)| {
        let both = [right, wrong];
        Said {
            trial: right.trial,
            compared: plain_words(&right.comparison()),
            reads: right.read.contains(seed.formula),
            agrees: both.map(|e| e.outcome() == Outcome::Agrees),
            measured: both.map(|e| plain_words(&e.measured())),
        }
    });
    Answer {
        trials: trials.collect(),
        verdicts: [&right, &wrong].map(|e| claim.judged(e).verdict.words()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_sign_in_the_time_is_noticed_by_what_reads_it_alone() {
        let claims = claims();
        let time = claims.iter().find(|c| c.id == "eq-13").unwrap();
        let all = breaks(time.id);
        let sign = &all[0];
        assert_eq!(
            (sign.formula, sign.seed.mistake),
            ("eq13_time", Mistake::Sign)
        );
        let answer = answer(time, sign.seed);
        assert_ne!(answer.verdicts[0], answer.verdicts[1]);
        for said in &answer.trials {
            assert!(
                said.reads || said.agrees[0] == said.agrees[1],
                "{}",
                said.trial
            );
        }
        let red = answer.trials.iter().filter(|s| s.agrees == [true, false]);
        assert!(red.count() > 2);
    }

    #[test]
    fn every_claim_offered_can_be_broken() {
        for claim in claims() {
            let all = breaks(claim.id);
            assert!(!all.is_empty(), "{}", claim.id);
            assert!(all.iter().all(|b| b.wrong != b.right), "{}", claim.id);
        }
    }

    /// What each trial measures is told of the right formula first, and of the broken one behind it.
    #[test]
    fn an_answer_says_what_each_trial_does_itself() {
        let claims = claims();
        let time = claims.iter().find(|c| c.id == "eq-13").unwrap();
        let all = breaks(time.id);
        for (n, seed) in [(0, all[0].seed), (all.len() - 1, all[all.len() - 1].seed)] {
            let answer = answer(time, seed);
            assert_eq!(answer.trials.len(), time.trials.len());
            for (said, trial) in answer.trials.iter().zip(time.trials) {
                let both = [trial.evidence(), with(seed, || trial.evidence())];
                let agrees = [0, 1].map(|i| both[i].outcome() == Outcome::Agrees);
                let measured = [0, 1].map(|i| plain_words(&both[i].measured()));
                assert_eq!((said.trial, said.agrees), (trial.name(), agrees), "{n}");
                assert_eq!(said.measured, measured, "{n}: {}", said.trial);
            }
            let differ = |said: &&Said| said.measured[0] != said.measured[1];
            assert!(n > 0 || answer.trials.iter().filter(differ).count() > 2);
        }
    }

    /// A part is as large as is said, and each formula has them all or, where a factor does not make it wrong, none.
    #[test]
    fn a_value_is_made_too_large_by_the_parts_that_are_named() {
        let mut without = BTreeSet::new();
        for claim in claims() {
            let all = breaks(claim.id);
            let formulas: BTreeSet<_> = all.iter().map(|b| b.formula).collect();
            for formula in formulas {
                let own = all.iter().filter(|b| b.formula == formula);
                let parts: Vec<_> = own
                    .filter_map(|b| match b.seed.mistake {
                        Mistake::Part(part) => Some((part, b)),
                        _ => None,
                    })
                    .collect();
                for (part, way) in &parts {
                    assert_eq!(way.wrong, format!("({}) (1 + 1/{part})", way.right));
                }
                let parts: Vec<_> = parts.iter().map(|(part, _)| *part).collect();
                if parts.is_empty() {
                    without.insert(formula);
                } else {
                    assert!(!formula.ends_with("_sides"), "{formula}");
                    assert_eq!(parts, [100, 100_000, 100_000_000], "{formula}");
                }
            }
        }
        for (formula, none) in [
            ("eq10_invariant", true),
            ("eq17_invariant", true),
            ("eq11_speed", false),
            ("eq13_time", false),
        ] {
            assert_eq!(without.contains(formula), none, "{formula}");
        }
    }
}
