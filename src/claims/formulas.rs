//! Every formula, printed and corrected, and the claim that tries it.

use super::corners::{CORNERS, DOMAINS};
use super::variants::{UP_TO_A_FACTOR, UP_TO_A_POSITIVE_FACTOR, argument};
use crate::scalar::Scalar;
use crate::seeded::Formula;
use crate::{corrections, paper};
use trialbook::claims::formulas::Formulas;

/// The formulas without a number of their own, and the claims that try them. What serves no claim is not here.
const TRIED_IN: &[(&str, &str)] = &[
    ("corrections::anisotropic::a_far", "eq-53"),
    ("corrections::anisotropic::contact", "s24-Y"),
    ("corrections::anisotropic::e_far", "eq-54"),
    ("corrections::anisotropic::e_sides", "eq-54"),
    ("corrections::constant::speed", "eq-11"),
    ("corrections::constant::time", "eq-13"),
    (
        "corrections::constant::turning_slope",
        "s21-large-friction-stops",
    ),
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
    ("corrections::periodic::small_friction_cases", "eq-46"),
    ("corrections::periodic::small_friction_ends", "eq-46"),
    ("corrections::periodic::small_friction_start", "eq-46"),
    (
        "corrections::rest::boundary_curvature",
        "s4-envelope-is-boundary",
    ),
    (
        "corrections::rest::boundary_slope",
        "s4-envelope-is-boundary",
    ),
    ("corrections::rest::psi_at_one_half", "eq-143"),
    ("corrections::rest::surface_slope", "eq-146"),
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
    (
        "corrections::turntable::friction_work",
        "s4-coriolis-no-work",
    ),
    ("paper::escape::s4_a_trend", "s4-A-never-decreases"),
    ("paper::general::s2_across_limit", "s2-perpendicular-decays"),
    ("paper::general::s2_across_trend", "s2-perpendicular-decays"),
    ("paper::general::s2_rest_ends_above", "s2-no-permanent-rest"),
    (
        "paper::general::s2_speeds_up_above",
        "s2-speeds-up-if-strong",
    ),
    ("paper::general::s2_stops_below", "s2-stops-if-weak"),
    ("paper::rest::s4_near_rest_limits", "s4-near-rest"),
    ("paper::turntable::coriolis_power", "s4-coriolis-no-work"),
    ("paper::anisotropic::s24_fifth_signs", "fig-6"),
    ("paper::anisotropic::s24_first_signs", "fig-6"),
    ("paper::anisotropic::s24_fourth_signs", "fig-6"),
    ("paper::anisotropic::s24_mirrored", "s24-q-at-least-one"),
    ("paper::anisotropic::s24_second_signs", "fig-6"),
    ("paper::anisotropic::s24_third_signs", "fig-6"),
    ("paper::sphere::s3_zeta3_rate", "s3-spin-constant"),
    (
        "paper::constant::s21_keeps_moving_sides",
        "s21-small-friction-aligns",
    ),
    (
        "paper::constant::s21_late_angle",
        "s21-small-friction-aligns",
    ),
    ("paper::constant::s21_parabola", "s21-frictionless-parabola"),
    ("paper::periodic::s23_rest_sides", "s23-rest-above-one"),
    (
        "paper::sinusoidal::s22_first_stage_slope",
        "s22-vy-two-stages",
    ),
    ("paper::sinusoidal::s22_late_vy", "s22-vy-vanishes"),
    ("paper::sinusoidal::s22_points", "s22-four-points"),
    (
        "paper::sinusoidal::s22_second_stage_ratio",
        "s22-vy-two-stages",
    ),
    ("paper::turntable::friction_work", "s4-coriolis-no-work"),
];

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
    tried_in: TRIED_IN,
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
    fn a_formula_is_tried_by_the_claim_of_its_number_or_of_the_list() {
        let formulas = formulas::<f64>();
        let tried = |path: &str| {
            let formula = formulas.iter().find(|f| f.path.ends_with(path));
            FORMULAS.claim(formula.unwrap_or_else(|| panic!("{path}")).path)
        };
        for &(path, id) in TRIED_IN {
            assert_eq!(tried(path).as_deref(), Some(id), "{path}");
            assert!(PAPER.find(id).is_some(), "{id}");
        }
        assert_eq!(tried("constant::eq13_time").as_deref(), Some("eq-13"));
        assert_eq!(tried("corrections::escape::winding"), None);
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
