//! Every formula, printed and corrected, and the claim that tries it.

use super::edges::CORNERS;
use super::variants::{UP_TO_A_FACTOR, UP_TO_A_POSITIVE_FACTOR, argument};
use crate::scalar::Scalar;
use crate::seeded::Formula;
use crate::{corrections, paper};
use trialbook::trials::formulas::Formulas;

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
        corrections::periodic::formulas(),
        corrections::anisotropic::formulas(),
        corrections::sphere::formulas(),
        corrections::turntable::formulas(),
        corrections::escape::formulas(),
        corrections::rest::formulas(),
    ]
    .concat()
}

/// The formulas, with what their trials and their wrong variants have to know of them.
pub const FORMULAS: Formulas = Formulas {
    numbers: formulas,
    trees: formulas,
    corrections: "::corrections::",
    up_to_a_factor: &UP_TO_A_FACTOR,
    up_to_a_positive_factor: &UP_TO_A_POSITIVE_FACTOR,
    corners: CORNERS,
    argument,
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::PAPER;
    use crate::seeded::reading::of;
    use crate::seeded::symbol;
    use crate::symbols::SYMBOLS;
    use std::collections::BTreeSet;

    #[test]
    fn a_formula_is_tried_by_the_claim_of_its_number_or_the_one_it_names() {
        let formulas = formulas::<f64>();
        for formula in &formulas {
            let numbered = formula.name.starts_with("eq");
            assert!(
                !(numbered && formula.tried_in.is_some()),
                "{}",
                formula.path
            );
            if let Some(id) = formula.claim() {
                assert!(PAPER.find(&id).is_some(), "{id} of {}", formula.path);
            }
        }
        let tried = |path: &str| {
            formulas
                .iter()
                .find(|f| f.path.ends_with(path))
                .unwrap()
                .claim()
        };
        assert_eq!(tried("constant::eq13_time").as_deref(), Some("eq-13"));
        assert_eq!(
            tried("constant::turning_slope").as_deref(),
            Some("s21-large-friction-stops")
        );
        assert_eq!(tried("escape::winding").as_deref(), Some("eq-136"));
    }

    /// The functions of the corrections that are no formulas, because they distinguish cases: each is asked at a point, to see
    /// what it reads.
    const CASES: &[(&str, fn())] = &[
        ("anisotropic::region", || {
            let curves = corrections::anisotropic::Curves {
                a: 0.1,
                b_or_e: 0.2,
                c: Some(0.3),
                d: 1.0,
            };
            corrections::anisotropic::region(0.5, &curves);
        }),
        ("periodic::small_friction_case", || {
            corrections::periodic::small_friction_case(0.5, 1.0);
        }),
    ];

    /// Of the corrections, by their paths, as the files have them.
    fn functions() -> BTreeSet<String> {
        let folder = std::fs::read_dir("src/corrections").unwrap();
        let mut all = BTreeSet::new();
        for file in folder.map(|file| file.unwrap().path()) {
            let stem = file.file_stem().unwrap().to_str().unwrap().to_owned();
            let text = std::fs::read_to_string(&file).unwrap();
            let text = text.split("#[cfg(test)]").next().unwrap();
            for function in text.split("\npub fn ").skip(1) {
                let name = function.split(['<', '(']).next().unwrap();
                all.insert(format!("{stem}::{name}"));
            }
        }
        all
    }

    /// A claim tries each formula; and what distinguishes cases reads one of the same claim's, which decides where they end or
    /// what they are.
    #[test]
    fn mistakes_are_tried_in_every_correction() {
        let mut left = functions();
        assert!(left.len() > 30, "{left:?}");
        let mut tried = BTreeSet::new();
        for formula in formulas::<f64>() {
            if let Some((_, path)) = formula.path.split_once("::corrections::") {
                assert!(formula.claim().is_some(), "no claim tries {path}");
                assert!(left.remove(path), "{path}");
                tried.insert(formula.path);
            }
        }
        assert!(
            left.iter().eq(CASES.iter().map(|(name, _)| name)),
            "{left:?}"
        );
        for (name, ask) in CASES {
            let ((), read) = of(ask);
            assert!(!tried.is_disjoint(&read.formulas), "{name}: {read:?}");
        }
    }

    #[test]
    fn every_argument_is_a_declared_symbol_and_introduced_by_a_claim() {
        for formula in formulas::<f64>() {
            let module = formula.path.rsplit_once("::").unwrap().0;
            for argument in formula.arguments {
                assert!(
                    symbol(SYMBOLS, module, argument).is_some(),
                    "{argument} of {}",
                    formula.path
                );
            }
            let letters: BTreeSet<_> = formula.symbols.iter().collect();
            assert_eq!(letters.len(), formula.symbols.len(), "{}", formula.path);
        }
        for symbol in SYMBOLS {
            assert!(PAPER.find(symbol.claim).is_some(), "{}", symbol.argument);
        }
    }
}
