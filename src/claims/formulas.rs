//! Every formula, printed and corrected, and the claim that tries it.

use super::corners::{CORNERS, DOMAINS};
use super::variants::{UP_TO_A_FACTOR, UP_TO_A_POSITIVE_FACTOR, argument};
use crate::scalar::Scalar;
use crate::seeded::Formula;
use crate::{corrections, paper};
use trialbook::claims::formulas::Formulas;

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
    .into_iter()
    .flatten()
    .collect()
}

/// The formulas, with what their trials and their wrong variants have to know of them.
pub const FORMULAS: Formulas = Formulas {
    numbers: formulas,
    trees: formulas,
    corrections: "::corrections::",
    up_to_a_factor: &UP_TO_A_FACTOR,
    up_to_a_positive_factor: &UP_TO_A_POSITIVE_FACTOR,
    corners: CORNERS,
    domains: DOMAINS,
    argument,
};

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::PAPER;
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
        assert_eq!(tried("corrections::escape::winding"), None);
    }

    /// What the corrections have and no claim tries mistakes in: its path, and what tries it over all values for which it is
    /// used.
    const BESIDE: &[(&str, &str)] = &[
        ("anisotropic::drift_without_rest", DRIFT),
        ("anisotropic::loss_without_rest", DRIFT),
        ("anisotropic::region", DRIFT),
        ("anisotropic::slip_distance", DRIFT),
        (
            "anisotropic::y_from_root",
            "the code of its page, at the one point that there is",
        ),
        ("escape::winding", "tests/certified.rs: it is a number"),
        ("periodic::loss_with_rests", DRIFT),
        ("periodic::loss_without_rest", DRIFT),
        (
            "periodic::small_friction_case",
            "pulses::below_motion, which asks it for every phase",
        ),
    ];
    const DRIFT: &str = "the tests of anisotropic::drift, by motions all over the plane";

    #[test]
    fn mistakes_are_tried_in_every_correction_or_it_is_listed() {
        let folder = std::fs::read_dir("src/corrections").unwrap();
        let mut left = BTreeSet::new();
        for file in folder.map(|file| file.unwrap().path()) {
            let stem = file.file_stem().unwrap().to_str().unwrap().to_owned();
            let text = std::fs::read_to_string(&file).unwrap();
            let text = text.split("#[cfg(test)]").next().unwrap();
            for function in text.split("\npub fn ").skip(1) {
                let name = function.split(['<', '(']).next().unwrap();
                left.insert(format!("{stem}::{name}"));
            }
        }
        assert!(left.len() > 30, "{left:?}");
        for formula in formulas::<f64>() {
            if let Some((_, path)) = formula.path.split_once("::corrections::")
                && formula.claim().is_some()
            {
                assert!(left.remove(path), "{path}");
            }
        }
        assert!(
            left.iter()
                .map(String::as_str)
                .eq(BESIDE.iter().map(|beside| beside.0)),
            "{left:?}"
        );
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
