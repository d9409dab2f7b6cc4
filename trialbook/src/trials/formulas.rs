//! The formulas of a paper, printed and corrected, and the claims that try them.

use crate::exact::Expr;
use crate::seeded::{Corner, Formula};

/// All formulas of a paper.
#[derive(Debug, Clone, Copy)]
pub struct Formulas {
    /// Their values.
    pub numbers: fn() -> Vec<Formula<f64>>,
    /// Their trees, in the same order.
    pub trees: fn() -> Vec<Formula<Expr>>,
    /// What stands in the path of a formula that replaces a printed one or adds to it, only.
    pub corrections: &'static str,
    /// The names of those that say that something vanishes or is constant: a constant factor does not make
    /// them wrong.
    pub up_to_a_factor: &'static [&'static str],
    /// The names of those that state a sign: a positive factor does not make them wrong.
    pub up_to_a_positive_factor: &'static [&'static str],
    /// The corners in which mistakes are made.
    pub corners: &'static [Corner],
    /// A random value of the argument of this letter, between 0 and 1.
    pub argument: fn(&str, &mut fastrand::Rng) -> f64,
}

impl Formulas {
    /// No formulas.
    pub const NONE: Self = Self {
        numbers: Vec::new,
        trees: Vec::new,
        corrections: "::corrections::",
        up_to_a_factor: &[],
        up_to_a_positive_factor: &[],
        corners: &[],
        argument: |_, random| 0.5 + 0.5 * random.f64(),
    };

    /// The formula of this path is one of the paper's.
    pub(crate) fn is_printed(&self, path: &str) -> bool {
        !path.contains(self.corrections)
    }

    /// The formulas that this claim tries, the paper's first: `paper::topic::eq13_time(λ, A, …) = …`.
    pub fn of_claim(&self, id: &str) -> Vec<String> {
        let own = (self.trees)().into_iter();
        own.filter(|formula| formula.claim().as_deref() == Some(id))
            .map(|formula| {
                let path = formula.path.split_once("::").map_or("", |(_, path)| path);
                format!(
                    "{path}({}) = {}",
                    formula.symbols.join(", "),
                    text(&formula)
                )
            })
            .collect()
    }
}

/// The [`Formulas`] of modules that list theirs by `formulas!`, with nothing special about them.
#[macro_export]
macro_rules! formulas_of {
    ($($module:ident),* $(,)?) => {
        $crate::trials::formulas::Formulas {
            numbers: || [$($module::formulas()),*].into_iter().flatten().collect(),
            trees: || [$($module::formulas()),*].into_iter().flatten().collect(),
            ..$crate::trials::formulas::Formulas::NONE
        }
    };
}

pub use formulas_of;

/// A formula as plain text, from what the code computes.
pub fn text(formula: &Formula<Expr>) -> String {
    let symbols: Vec<_> = formula.symbols.iter().map(|s| Expr::symbol(s)).collect();
    let parts = (formula.value)(&symbols);
    parts
        .iter()
        .map(Expr::to_string)
        .collect::<Vec<_>>()
        .join("; ")
}
