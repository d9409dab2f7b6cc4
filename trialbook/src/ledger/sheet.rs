//! A claim's sheet: all that is known of it, as plain text that a physicist can review line by line.

use super::Entry;
use crate::claims::Sort;
use crate::evidence::{Evidence, Outcome};
use std::fmt::Write;

impl Entry {
    /// The claim, its formula, its conditions, its verdict, and each trial with a few compared values.
    ///
    /// Only what is the same on every machine: a disagreement is shown by whether it is within its
    /// tolerance, and values are rounded two digits short of it.
    pub fn sheet(&self) -> String {
        let claim = self.claim;
        let mut text = format!("{}: {}\n", claim.id, claim.title);
        let number = claim
            .equation
            .map_or(String::new(), |n| format!(", equation ({n})"));
        let _ = writeln!(
            text,
            "section {}{number}, {}",
            claim.section,
            claim.kind.name()
        );
        let _ = writeln!(text, "\n    {}\n", claim.plain);
        if let Some(correction) = claim.correction {
            let _ = writeln!(text, "corrected:\n\n    {}\n", correction.plain);
        }
        let formulas = self.paper.formulas.of_claim(claim.id);
        if !formulas.is_empty() {
            let _ = writeln!(text, "in code:\n\n    {}\n", formulas.join("\n    "));
        }
        for condition in claim.conditions {
            let by = match condition.sort {
                Sort::Stated => "stated",
                Sort::Degenerate => "added, degenerate points",
                Sort::Substance => "added",
            };
            let _ = writeln!(text, "condition ({by}): {}", condition.text);
        }
        let _ = writeln!(text, "verdict: {}", self.judgement.verdict.words());
        let _ = writeln!(text, "ground: {}", self.judgement.ground);
        for evidence in &self.evidence {
            trial(&mut text, evidence, self.is_conditional());
        }
        text
    }
}

fn trial(text: &mut String, e: &Evidence, conditional: bool) {
    let tolerance = e.tolerance.value;
    let said = match e.outcome() {
        Outcome::Agrees => format!("agrees to {tolerance:.0e}"),
        Outcome::Disagrees => format!("differs by more than {tolerance:.0e}"),
        Outcome::NotANumber => "gave no number".into(),
        Outcome::TooFewPoints => "has too few points".into(),
    };
    let (route, about) = (e.route.name(), e.about(conditional));
    let _ = writeln!(text, "\ntrial by {route}, {about}: {}", e.compared);
    if let Some(proof) = e.proof_words() {
        let steps = match e.steps.len() {
            0 => String::new(),
            n => format!(" in {n} steps"),
        };
        let _ = writeln!(text, "    {proof}{steps}");
        if !e.title.is_empty() {
            let _ = writeln!(text, "    {}", e.title);
        }
    } else {
        let _ = writeln!(text, "    {} points, {said}", e.points);
    }
    for s in &e.samples {
        let (stated, found) = (rounded(s.stated, tolerance), rounded(s.found, tolerance));
        let _ = writeln!(text, "    {}: stated {stated}, found {found}", s.at);
    }
}

/// `value` with two digits fewer than `tolerance` vouches for, at least three and at most ten.
pub(crate) fn rounded(value: f64, tolerance: f64) -> String {
    if !value.is_finite() {
        return "no value".into();
    }
    let vouched = -libm::log10(tolerance.max(1e-12));
    let digits = (vouched.floor() as i32 - 2).clamp(3, 10) as usize;
    if value.abs() < tolerance.max(1e-300) {
        return "0".into();
    }
    let text = format!("{value:.*e}", digits - 1);
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    match exponent.parse::<i32>() {
        Ok(e) if (-3..6).contains(&e) => {
            let decimals = (digits as i32 - 1 - e).max(0) as usize;
            format!("{value:.decimals$}")
        }
        _ => format!("{mantissa}e{exponent}"),
    }
}

#[cfg(test)]
mod tests {
    use super::rounded;

    #[test]
    fn values_keep_two_digits_fewer_than_the_tolerance_vouches_for() {
        assert_eq!(rounded(0.536_995_469_1, 1e-6), "0.5370");
        assert_eq!(rounded(123.456_789_012_3, 1e-12), "123.4567890");
        assert_eq!(rounded(-2.5e-7, 1e-12), "-2.500000000e-7");
        assert_eq!(rounded(1e-14, 1e-12), "0");
        assert_eq!(rounded(f64::NAN, 1e-12), "no value");
        assert_eq!(rounded(f64::INFINITY, 0.0), "no value");
    }
}
