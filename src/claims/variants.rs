//! Wrong variants of the formulas: each differs from its formula in a single place, and in what it states.

use super::formulas::{claim, formulas, text};
use crate::exact::Expr;
use crate::seeded::{Formula, Seed, with};

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

const BY_ITS_SINE: &str =
    "the proof knows a phase by its sine alone; which phase it is, the motions tell";
const BY_ITS_SQUARE: &str = "λ_c enters by its square; its sign is told by enclosure";
const LARGE: &str = "the law is stated for large α, where sinh and cosh are equal to leading order";

const fn spared(claim: &'static str, formula: &'static str, reason: &'static str) -> Spared {
    Spared {
        claim,
        formula,
        reason,
    }
}

/// All of them. A test holds the list against the proofs.
pub const SPARED: [Spared; 14] = [
    spared(
        "eq-21",
        "eq21_acceleration",
        "(26) is about the motion along the drive: what pulls across it does not enter",
    ),
    spared("eq-28", "eq28_phi2", BY_ITS_SINE),
    spared("eq-29", "eq29_phi3", BY_ITS_SINE),
    spared("eq-30", "eq30_phi4", BY_ITS_SINE),
    spared(
        "eq-33",
        "eq33_ends",
        "the proof is about the slips; how long the rest between them lasts, the motions tell",
    ),
    spared("eq-36", "eq36_sides", BY_ITS_SQUARE),
    spared(
        "eq-39",
        "eq39_phi_t1",
        "the proof knows the phase by its cosine alone; which phase it is, the motions tell",
    ),
    spared("eq-40", "eq40_sides", BY_ITS_SQUARE),
    spared("eq-57", "eq57_x", BY_ITS_SQUARE),
    spared(
        "eq-79",
        "eq79_velocity",
        "another constant is a constant too",
    ),
    spared("eq-125", "eq125_psi2", BY_ITS_SINE),
    spared("eq-128", "alpha_rate", LARGE),
    spared("eq-129", "eq129_a", LARGE),
    spared(
        "eq-143",
        "eq143_exponent",
        "the proof is about ψ as it stands in (143), with its own exponent",
    ),
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

/// The wrong variants of the formula of this name.
pub fn of_formula(name: &str) -> Vec<Variant> {
    let named = all().into_iter();
    named.filter(|variant| variant.formula == name).collect()
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
    for seed in number.seeds(&points[0]) {
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
