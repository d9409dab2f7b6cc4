//! Wrong variants: each differs from its formula in a single place, and in what it states.

use super::Paper;
use super::formulas::{Formulas, text};
use crate::exact::Expr;
use crate::seeded::{Corner, Formula, Mistake, Seed, with};
use std::collections::BTreeMap;

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

impl Formulas {
    /// Every wrong variant of every formula.
    pub fn variants(&self) -> Vec<Variant> {
        self.of_those(|_| true)
    }

    /// The wrong variants of the formula of this name.
    pub fn variants_of(&self, name: &str) -> Vec<Variant> {
        self.of_those(|formula| formula.name == name)
    }

    /// The wrong variants of the formulas that the claim of this id tries.
    pub(crate) fn variants_of_claim(&self, id: &str) -> Vec<Variant> {
        self.of_those(|formula| formula.claim().is_some_and(|claim| claim == id))
    }

    fn of_those(&self, wanted: impl Fn(&Formula<f64>) -> bool) -> Vec<Variant> {
        let (trees, numbers) = ((self.trees)(), (self.numbers)());
        let both = trees.iter().zip(&numbers).filter(|(_, f)| wanted(f));
        both.flat_map(|(tree, number)| self.of(tree, number))
            .collect()
    }

    fn of(&self, tree: &Formula<Expr>, number: &Formula<f64>) -> Vec<Variant> {
        let Some(claim) = number.claim() else {
            return Vec::new();
        };
        let points = self.sample(number);
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

    /// True if a factor makes the formula wrong.
    pub fn has_a_size(&self, formula: &Formula<f64>) -> bool {
        let name = formula.name;
        let sample = self.sample(formula);
        let mut values = sample.iter().flat_map(|p| (formula.value)(p));
        !self.up_to_a_factor.contains(&name)
            && !self.up_to_a_positive_factor.contains(&name)
            && !name.ends_with("_sides")
            && values.any(|value| value != 0.0)
    }

    fn sample(&self, formula: &Formula<f64>) -> Vec<Vec<f64>> {
        let mut random = fastrand::Rng::with_seed(super::points::SEED);
        (0..20).map(|_| self.point(formula, &mut random)).collect()
    }

    fn point(&self, formula: &Formula<f64>, random: &mut fastrand::Rng) -> Vec<f64> {
        let letters = formula.symbols.iter();
        letters
            .map(|letter| (self.argument)(letter, random))
            .collect()
    }

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

impl Paper {
    /// Every formula with its inverse functions on another branch over half of their range, and with a
    /// mistake of a hundredth in each of its claim's corners.
    pub fn corners(&self) -> Vec<Variant> {
        let all = &self.formulas;
        let stated: BTreeMap<_, _> = self
            .claims()
            .map(|(_, claim)| (claim.id, claim.domain))
            .collect();
        let of = |formula: &Formula<f64>| {
            let Some(claim) = formula.claim() else {
                return Vec::new();
            };
            let domain = stated.get(&*claim).copied().unwrap_or_default();
            let sample = all.sample(formula);
            let values =
                || -> Vec<Vec<f64>> { sample.iter().map(|p| (formula.value)(p)).collect() };
            let right = values();
            let branches = formula.branches(&sample[0]).into_iter().enumerate();
            let branches = branches
                .filter(|(_, seed)| !all.same(formula.name, &right, &with(*seed, values)))
                .map(|(i, seed)| (seed, branch(i / 2 + 1, seed.mistake)));
            let letters = formula.symbols.iter().enumerate();
            let corners = letters.flat_map(|(i, letter)| {
                let corners = all.corners.iter().filter(|c| c.letter == *letter);
                corners.map(move |corner| (i, corner))
            });
            let corners = corners
                .filter(|(_, corner)| all.has_a_size(formula) && is_stated(domain, corner))
                .map(|(i, corner)| {
                    let seed = Seed::of_value(formula.path, Mistake::Corner(corner, i));
                    (seed, format!("1 % more where {corner}"))
                });
            branches
                .chain(corners)
                .map(|(seed, text)| Variant {
                    claim: claim.clone(),
                    formula: formula.name,
                    printed: all.is_printed(formula.path),
                    seed,
                    text: format!("{} {text}", formula.name),
                })
                .collect()
        };
        (all.numbers)().iter().flat_map(of).collect()
    }
}

fn is_stated(domain: &[Corner], corner: &Corner) -> bool {
    let own = domain.iter().find(|part| part.letter == corner.letter);
    own.is_none_or(|part| part.meets(corner))
}

fn branch(number: usize, mistake: Mistake) -> String {
    let half = if mistake == Mistake::Branch(true) {
        "upper"
    } else {
        "lower"
    };
    format!("with inverse function {number} on the other branch over the {half} half of its range")
}

#[cfg(test)]
mod tests {
    use super::*;

    const FORMULAS: Formulas = Formulas {
        numbers: Vec::new,
        trees: Vec::new,
        corrections: "::right::",
        up_to_a_factor: &["eq104_constant"],
        up_to_a_positive_factor: &["eq116_case"],
        corners: &[],
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
