//! Wrong variants of the formulas: each differs from its formula in a single place, and in what it states.

use super::formulas::{Formulas, text};
use crate::exact::Expr;
use crate::seeded::{Formula, Seed, with};

/// A wrong variant of a formula.
#[derive(Debug, Clone)]
pub struct Variant {
    /// The id of the claim that tries the formula.
    pub claim: String,
    /// The formula's name.
    pub formula: &'static str,
    /// True if the formula is one of the paper's, false if it replaces one.
    pub printed: bool,
    /// The mistake that makes it.
    pub seed: Seed,
    /// The wrong formula as plain text; components one after the other.
    pub text: String,
}

/// A wrong variant that no trial rejects, and why none has to.
#[derive(Debug, Clone, Copy)]
pub struct Survivor {
    /// The id of the claim.
    pub claim: &'static str,
    /// The wrong formula, as [`Variant::text`] has it.
    pub text: &'static str,
    /// Why it is not rejected.
    pub reason: &'static str,
}

/// A trial that agrees and notices no mistake in what it reads, or reads no formula, and why.
#[derive(Debug, Clone, Copy)]
pub struct Idle {
    /// The id of the claim.
    pub claim: &'static str,
    /// The trial's name.
    pub trial: &'static str,
    /// What of the claim no formula says.
    pub reason: &'static str,
}

/// A formula of a claim of which a proof of the claim does not reject every wrong variant; the claim's other trials do.
#[derive(Debug, Clone, Copy)]
pub struct Spared {
    /// The id of the claim.
    pub claim: &'static str,
    /// The name of the formula.
    pub formula: &'static str,
    /// What of it does not enter the proof.
    pub reason: &'static str,
}

impl Formulas {
    /// Every wrong variant of every formula.
    pub fn variants(&self) -> Vec<Variant> {
        let (trees, numbers) = ((self.trees)(), (self.numbers)());
        let both = trees.iter().zip(&numbers);
        both.flat_map(|(tree, number)| self.of(tree, number))
            .collect()
    }

    /// The wrong variants of the formula of this name.
    pub fn variants_of(&self, name: &str) -> Vec<Variant> {
        let named = self.variants().into_iter();
        named.filter(|variant| variant.formula == name).collect()
    }

    /// The wrong variants of one formula, which is given for trees and for numbers.
    fn of(&self, tree: &Formula<Expr>, number: &Formula<f64>) -> Vec<Variant> {
        let Some(claim) = self.claim(number.path) else {
            return Vec::new();
        };
        let mut random = fastrand::Rng::with_seed(super::points::SEED);
        let points: Vec<_> = (0..20).map(|_| self.point(number, &mut random)).collect();
        let values = || -> Vec<Vec<f64>> { points.iter().map(|p| (number.value)(p)).collect() };
        let right = values();
        let mut found: Vec<Variant> = Vec::new();
        for seed in number.seeds(&points[0]) {
            let text = with(seed, || text(tree));
            let known = found.iter().any(|v| v.text == text);
            if !known && !self.same(number.name, &right, &with(seed, values)) {
                found.push(Variant {
                    claim: claim.clone(),
                    formula: number.name,
                    printed: self.is_printed(number.path),
                    seed,
                    text,
                });
            }
        }
        found
    }

    /// Arguments between 0 and 1, as the formula is stated for them.
    fn point(&self, formula: &Formula<f64>, random: &mut fastrand::Rng) -> Vec<f64> {
        let letters = formula.symbols.iter();
        letters
            .map(|letter| (self.argument)(letter, random))
            .collect()
    }

    /// True if the values state the same as the right ones, wherever those are finite.
    fn same(&self, formula: &str, right: &[Vec<f64>], values: &[Vec<f64>]) -> bool {
        let pairs = || {
            let all = right.iter().flatten().zip(values.iter().flatten());
            all.filter(|(r, _)| r.is_finite())
        };
        let factor = pairs().find(|(r, _)| **r != 0.0).map(|(r, v)| v / r);
        let factor = factor.filter(|f| {
            self.up_to_a_factor.contains(&formula) && *f != 0.0
                || self.up_to_a_positive_factor.contains(&formula) && *f > 0.0
        });
        let factor = factor.unwrap_or(1.0);
        pairs().all(|(r, v)| (v - factor * r).abs() <= 1e-9 * r.abs())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const FORMULAS: Formulas = Formulas {
        numbers: Vec::new,
        trees: Vec::new,
        corrections: "::right::",
        tried_in: &[],
        up_to_a_factor: &["eq104_constant"],
        up_to_a_positive_factor: &["eq116_case"],
        argument: |_, _| 0.0,
    };

    #[test]
    fn a_factor_counts_but_for_what_vanishes_keeps_its_value_or_has_a_sign() {
        let right = [vec![0.0, f64::NAN], vec![1.0, -2.0]];
        let times = |factor: f64| {
            right
                .clone()
                .map(|v| v.iter().map(|x| factor * x).collect())
        };
        for (formula, like) in [
            ("eq13_time", [true, false, false, false]),
            ("eq104_constant", [true, true, true, false]),
            ("eq116_case", [true, true, false, false]),
        ] {
            let found =
                [1.0, 3.0, -3.0, 0.0].map(|factor| FORMULAS.same(formula, &right, &times(factor)));
            assert_eq!(found, like, "{formula}");
            // No one factor leads there.
            assert!(!FORMULAS.same(formula, &right, &[vec![0.0, 0.0], vec![1.0, 2.0]]));
        }
    }
}
