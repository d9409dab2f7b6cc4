//! Wrong variants of the formulas: each differs from its formula in a single place, and in what it states.

use super::formulas::{claim, formulas, text};
use crate::exact::Expr;
use crate::seeded::{Formula, Mistake, Place, Seed, places, with};

/// A wrong variant of a formula.
#[derive(Debug, Clone)]
pub struct Variant {
    /// The id of the claim that tries the formula.
    pub claim: String,
    /// The formula's name.
    pub formula: &'static str,
    /// The mistake that makes it.
    pub seed: Seed,
    /// The wrong formula as plain text; components one after the other.
    pub text: String,
}

impl Variant {
    /// True if the formula is one of the paper's, false if it replaces one.
    pub fn is_printed(&self) -> bool {
        self.seed.formula.contains("::paper::")
    }
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

/// All wrong variants that no trial rejects. A test holds the list against the trials.
pub const SURVIVORS: [Survivor; 3] = [
    Survivor {
        claim: "eq-75",
        text: "ζ₃ 0 + (0 (u_z − ρ̇_z) − (−1) (u_y − ρ̇_y)); ζ₃ 0 + ((−1) (u_x − ρ̇_x) − 0 (u_z − ρ̇_z)); ζ₃ 1 + (0 (u_y − ρ̇_y) − 0 (u_x − ρ̇_x))",
        reason: "it is the corrected formula: the mistake takes the misprint back",
    },
    Survivor {
        claim: "eq-128",
        text: "√(2)/sinh(2 α) − cosh(α)/A",
        reason: "the formula is stated for large α, where the two hyperbolic functions are equal to leading order",
    },
    Survivor {
        claim: "eq-128",
        text: "√(2)/cosh(2 α) − sinh(α)/A",
        reason: "the formula is stated for large α, where the two hyperbolic functions are equal to leading order",
    },
];

/// The formulas that say that something vanishes or keeps its value: a constant factor does not make them wrong.
const UP_TO_A_FACTOR: [&str; 9] = [
    "constant",
    "eq10_invariant",
    "eq17_invariant",
    "eq32_left",
    "eq34_left",
    "eq35_left",
    "eq104_constant",
    "eq106_constant",
    "eq146_right",
];

/// The formulas that state a sign: a positive factor does not make them wrong.
const UP_TO_A_POSITIVE_FACTOR: [&str; 2] = ["eq110_case", "eq116_case"];

/// Every wrong variant of every formula.
pub fn all() -> Vec<Variant> {
    let trees = formulas::<Expr>();
    let numbers = formulas::<f64>();
    let both = trees.iter().zip(&numbers);
    both.flat_map(|(tree, number)| of(tree, number)).collect()
}

/// The wrong variants of one formula, which is given for trees and for numbers.
fn of(tree: &Formula<Expr>, number: &Formula<f64>) -> Vec<Variant> {
    let Some(claim) = claim(number.path) else {
        return Vec::new();
    };
    let mut random = fastrand::Rng::with_seed(super::points::SEED);
    let points: Vec<_> = (0..20).map(|_| point(number, &mut random)).collect();
    let values = || -> Vec<Vec<f64>> { points.iter().map(|p| (number.value)(p)).collect() };
    let right = values();
    let mut found: Vec<Variant> = Vec::new();
    let passed = places(number.path, || drop(values()));
    for (i, place) in passed.into_iter().enumerate() {
        for mistake in mistakes(place, number.symbols.len()) {
            let seed = Seed {
                formula: number.path,
                place: i,
                mistake,
            };
            let text = with(seed, || text(tree));
            let known = found.iter().any(|v| v.text == text);
            if !known && !same(number.name, &right, &with(seed, values)) {
                found.push(Variant {
                    claim: claim.clone(),
                    formula: number.name,
                    seed,
                    text,
                });
            }
        }
    }
    found
}

/// Arguments between 0 and 1, as the formula is stated for them: vectors of the sphere lie in the plane, but for the
/// angular velocity, and **R** is upright; h in (43) is that of (42).
fn point(formula: &Formula<f64>, random: &mut fastrand::Rng) -> Vec<f64> {
    let value = |letter: &&str| match *letter {
        "ω_z" | "R_z" => random.f64(),
        "R_x" | "R_y" => 0.0,
        letter if letter.ends_with("_z") => 0.0,
        "h" => f64::from(random.u8(0..2)),
        _ => random.f64(),
    };
    formula.symbols.iter().map(value).collect()
}

/// The mistakes that can be made at a place of a formula with so many arguments.
fn mistakes(place: Place, arguments: usize) -> Vec<Mistake> {
    let mut all = vec![Mistake::Sign, Mistake::Factor];
    match place {
        Place::Argument(here) => {
            all.push(Mistake::Exponent);
            let others = (0..arguments).filter(|other| *other != here);
            all.extend(others.map(Mistake::Symbol));
        }
        Place::Operation(true) => all.push(Mistake::Exponent),
        Place::Operation(false) => {}
    }
    all
}

/// True if the values state the same as the right ones, wherever those are finite.
fn same(formula: &str, right: &[Vec<f64>], values: &[Vec<f64>]) -> bool {
    let pairs = || {
        let all = right.iter().flatten().zip(values.iter().flatten());
        all.filter(|(r, _)| r.is_finite())
    };
    let factor = pairs().find(|(r, _)| **r != 0.0).map(|(r, v)| v / r);
    let factor = factor.filter(|f| {
        UP_TO_A_FACTOR.contains(&formula) && *f != 0.0
            || UP_TO_A_POSITIVE_FACTOR.contains(&formula) && *f > 0.0
    });
    let factor = factor.unwrap_or(1.0);
    pairs().all(|(r, v)| (v - factor * r).abs() <= 1e-9 * r.abs())
}

#[cfg(test)]
mod tests {
    use super::*;

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
            let found = [1.0, 3.0, -3.0, 0.0].map(|factor| same(formula, &right, &times(factor)));
            assert_eq!(found, like, "{formula}");
            // No one factor leads there.
            assert!(!same(formula, &right, &[vec![0.0, 0.0], vec![1.0, 2.0]]));
        }
    }
}
