//! Wrong variants of the formulas: each differs from its formula in a single place, and in what it states.

use crate::exact::Expr;
use crate::scalar::Scalar;
use crate::seeded::{Formula, Mistake, Place, Seed, places, with};
use crate::{corrections, paper};

/// A wrong variant of a formula.
#[derive(Debug, Clone)]
pub struct Variant {
    /// The id of the claim that tries the formula.
    pub claim: String,
    /// The formula's name.
    pub formula: &'static str,
    /// The mistake that makes it.
    pub seed: Seed,
    /// The wrong formula as plain text, under the names of its arguments; components one after the other.
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
        text: "zeta3 0 + (0 (u₃ − rho_rate₃) − (−1) (u₂ − rho_rate₂)); zeta3 0 + ((−1) (u₁ − rho_rate₁) − 0 (u₃ − rho_rate₃)); zeta3 1 + (0 (u₂ − rho_rate₂) − 0 (u₁ − rho_rate₁))",
        reason: "it is the corrected formula: the mistake takes the misprint back",
    },
    Survivor {
        claim: "eq-128",
        text: "√(2)/sinh(2 alpha) − cosh(alpha)/a",
        reason: "the formula is stated for large α, where the two hyperbolic functions are equal to leading order",
    },
    Survivor {
        claim: "eq-128",
        text: "√(2)/cosh(2 alpha) − sinh(alpha)/a",
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

/// The formulas without a number of their own, and the claims that try them. What serves no claim is not here.
const TRIED_IN: [(&str, &str); 32] = [
    ("corrections::anisotropic::a_far", "eq-53"),
    ("corrections::anisotropic::contact", "s24-Y"),
    ("corrections::anisotropic::e_far", "eq-54"),
    ("corrections::anisotropic::e_sides", "eq-54"),
    ("corrections::constant::speed", "eq-11"),
    ("corrections::escape::a", "eq-132"),
    ("corrections::escape::a_rate", "eq-131"),
    ("corrections::escape::alpha", "eq-133"),
    ("corrections::escape::alpha_by_a", "eq-130"),
    ("corrections::escape::alpha_rate", "eq-128"),
    ("corrections::escape::amplitude", "eq-135"),
    ("corrections::escape::delay", "eq-134"),
    ("corrections::escape::lag", "eq-134"),
    ("corrections::escape::product_over_a", "eq-129"),
    ("corrections::escape::rho", "eq-135"),
    ("corrections::escape::s", "eq-137"),
    ("corrections::escape::thrice_alpha_exp", "eq-130"),
    ("corrections::escape::twice_alpha_exp", "eq-133"),
    ("corrections::rest::alpha_rate_straight_in", "eq-140"),
    ("corrections::rest::angle_straight_in", "s4-near-rest"),
    ("corrections::rest::boundary_a", "s4-envelope-is-boundary"),
    (
        "corrections::rest::boundary_curvature",
        "s4-envelope-is-boundary",
    ),
    (
        "corrections::rest::boundary_slope",
        "s4-envelope-is-boundary",
    ),
    (
        "corrections::sinusoidal::drive_at_zero",
        "s22-vy-two-stages",
    ),
    (
        "corrections::sinusoidal::first_stage_lean",
        "s22-vy-two-stages",
    ),
    ("corrections::sinusoidal::last_stage", "s22-vy-two-stages"),
    (
        "corrections::sinusoidal::passage_factor",
        "s22-vy-two-stages",
    ),
    ("corrections::sphere::slip_at_time", "eq-83"),
    ("corrections::sphere::spin", "eq-75"),
    ("corrections::sphere::time", "eq-82"),
    ("corrections::turntable::constant", "eq-106"),
    ("paper::turntable::friction_work", "s4-coriolis-no-work"),
];

/// Every wrong variant of every formula.
pub fn all() -> Vec<Variant> {
    let trees = formulas::<Expr>();
    let numbers = formulas::<f64>();
    let both = trees.iter().zip(&numbers);
    both.flat_map(|(tree, number)| of(tree, number)).collect()
}

/// Every formula of the paper, and every one that replaces one or adds to it.
pub fn formulas<S: Scalar>() -> Vec<Formula<S>> {
    [
        paper::general::formulas(),
        paper::constant::formulas(),
        paper::sinusoidal::formulas(),
        paper::periodic::formulas(),
        paper::anisotropic::formulas(),
        paper::sphere::formulas(),
        paper::turntable::formulas(),
        paper::escape::formulas(),
        paper::rest::formulas(),
        corrections::constant::formulas(),
        corrections::sinusoidal::formulas(),
        corrections::anisotropic::formulas(),
        corrections::sphere::formulas(),
        corrections::turntable::formulas(),
        corrections::escape::formulas(),
        corrections::rest::formulas(),
    ]
    .into_iter()
    .flatten()
    .collect()
}

/// The id of the claim that tries the formula of this path: `slipbook::paper::constant::eq13_time`.
pub fn claim(path: &str) -> Option<String> {
    let name = path.rsplit("::").next()?;
    let number = name
        .strip_prefix("eq")
        .and_then(|rest| rest.split('_').next());
    let tried_in = || {
        let path = path.strip_prefix("slipbook::")?;
        let (_, id) = TRIED_IN.iter().find(|(formula, _)| *formula == path)?;
        Some((*id).to_owned())
    };
    number.map(|n| format!("eq-{n}")).or_else(tried_in)
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
    let symbols: Vec<_> = tree.symbols.iter().map(|s| Expr::symbol(s)).collect();
    let mut found: Vec<Variant> = Vec::new();
    let passed = places(number.path, || drop(values()));
    for (i, place) in passed.into_iter().enumerate() {
        for mistake in mistakes(place, symbols.len()) {
            let seed = Seed {
                formula: number.path,
                place: i,
                mistake,
            };
            let parts = with(seed, || (tree.value)(&symbols));
            let parts: Vec<_> = parts.iter().map(Expr::to_string).collect();
            let text = parts.join("; ");
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
    let sphere = formula.path.contains("::sphere::");
    let value = |symbol: &&str| match *symbol {
        "omega₃" | "contact₃" => random.f64(),
        "contact₁" | "contact₂" => 0.0,
        symbol if sphere && symbol.ends_with('₃') => 0.0,
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
    fn a_formula_is_tried_by_the_claim_of_its_number_or_of_the_list() {
        let formulas = formulas::<f64>();
        let tried = |path: &str| {
            let formula = formulas.iter().find(|f| f.path.ends_with(path));
            claim(formula.unwrap_or_else(|| panic!("{path}")).path)
        };
        for (path, id) in TRIED_IN {
            assert_eq!(tried(path).as_deref(), Some(id), "{path}");
            assert!(crate::claims::find(id).is_some(), "{id}");
        }
        assert_eq!(tried("constant::eq13_time").as_deref(), Some("eq-13"));
        assert_eq!(tried("corrections::escape::winding"), None);
    }

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
