//! A claim's sheet: all that is known of it, as plain text to review.

use super::{Entry, Tally};
use crate::evidence::{Evidence, Outcome, Sample, Subject, ranges};
use crate::notation::plain_words;
use crate::trials::{Sort, compare::SAMPLES};
use std::fmt::Write;

impl Entry {
    /// The claim, its formula, its conditions, its verdict, and each trial with a few compared values,
    /// rounded so that they are the same on every machine.
    pub fn sheet(&self) -> String {
        plain_words(&self.snapshot())
    }

    /// The sheet as recorded, for [`Ledger::recorded`](super::Ledger::recorded): the formulas of what has to
    /// be changed stand in `$…$`.
    pub fn snapshot(&self) -> String {
        let claim = self.claim;
        let mut text = format!("{}: {}\n", claim.id, claim.title);
        let number = claim
            .equation
            .map_or(String::new(), |n| format!(", equation ({n})"));
        let _ = writeln!(
            text,
            "section {}{number}, {}",
            claim.section,
            claim.kind_name()
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
                Sort::Stated => "condition (stated)",
                Sort::Degenerate => "condition (added, degenerate points)",
                Sort::Convention => "condition (convention)",
                Sort::Substance => "condition (added)",
                Sort::Reading => "our reading",
                Sort::Remark => "our remark",
            };
            let _ = writeln!(text, "{by}: {}", plain_words(condition.text));
        }
        let _ = writeln!(text, "verdict: {}", self.judgement.verdict.words());
        if let Some(words) = self.in_short() {
            let _ = writeln!(text, "in short: {}", plain_words(&words));
        }
        let _ = writeln!(text, "ground: {}", self.judgement.ground);
        if let Some(standing) = self.standing() {
            let _ = writeln!(text, "known: {}", standing.word());
        }
        let Tally { rejected, tried } = self.tally();
        if tried > 0 {
            let _ = writeln!(text, "wrong variants: {rejected} of {tried} are rejected");
        }
        if !claim.argument.is_empty() {
            let _ = writeln!(text, "argument: {}", plain_words(claim.argument));
        }
        for evidence in &self.evidence {
            trial(&mut text, evidence, self);
        }
        text
    }
}

fn trial(text: &mut String, e: &Evidence, entry: &Entry) {
    let verdict = entry.judgement.verdict;
    let about = e.about(verdict.has_condition(), entry.claim.ours);
    let route = e.route.name();
    let (mut comparison, result) = (e.comparison(), e.result());
    if !verdict.asks_for_change() {
        comparison = plain_words(&comparison);
    }
    let _ = writeln!(
        text,
        "\ntrial by {route}, {about}:\n    {comparison} {result}"
    );
    if !e.route.is_proof() || e.points != 1 {
        let _ = write!(text, "    {} of {} points differ", e.different(), e.points);
        if e.subject == Subject::Outside && verdict.asks_for_change() {
            let _ = write!(text, ", {} disagree", e.failed);
        }
        if !e.route.is_proof() {
            let [least, most] = e.scales.map(ranges::short);
            let _ = write!(text, "; in units of {least}");
            if least != most {
                let _ = write!(text, " to {most}");
            }
        }
        text.push('\n');
    }
    if !e.title.is_empty() {
        let _ = writeln!(text, "    {}", e.title);
    }
    // A premise that is lost, of the proof or of one of its lemmas, is missed here.
    let lemmas = e.lemmas.iter().map(|of| (of.title.as_str(), &of.steps));
    for (title, steps) in std::iter::once(("it", &e.steps)).chain(lemmas) {
        let known = steps
            .iter()
            .filter_map(|step| step.strip_prefix("Shown before: "));
        for known in known {
            let _ = writeln!(text, "    {title} rests on: {known}");
        }
    }
    for s in e.samples.iter().take(SAMPLES) {
        let [stated, found] = match e.outcome() {
            Outcome::Disagrees => apart(s, e.tolerance.value),
            _ => counts(s, e.tolerance.value).unwrap_or_else(|| {
                [s.stated, s.found].map(|value| rounded(value, e.tolerance.value))
            }),
        };
        let _ = writeln!(text, "    {}: stated {stated}, found {found}", s.at);
    }
}

fn apart(sample: &Sample, tolerance: f64) -> [String; 2] {
    if let Some(counts) = counts(sample, tolerance) {
        return counts;
    }
    // What is nothing beside the other side is rounding, and another number on another machine.
    let [stated, found] = [sample.stated, sample.found];
    let nothing = |x: f64, other: f64| {
        if other.is_finite() && x.abs() < 1e-15 * other.abs() {
            0.0
        } else {
            x
        }
    };
    let sides = [nothing(stated, found), nothing(found, stated)];
    let both = |digits| sides.map(|value| with_digits(value, digits));
    let differ = |[stated, found]: &[String; 2]| stated != found;
    // One digit more than the first that differs.
    let first = (digits(tolerance)..17).find(|digits| differ(&both(*digits)));
    match first {
        Some(first) if first > digits(tolerance) => both(first + 1),
        _ => both(digits(tolerance)),
    }
}

fn counts(sample: &Sample, tolerance: f64) -> Option<[String; 2]> {
    let sides = [sample.stated, sample.found];
    let whole = |value: f64| value.fract() == 0.0 && value.abs() < 1e9;
    let counted = tolerance == 0.0 && sides.into_iter().all(whole);
    counted.then(|| sides.map(|value| format!("{value:.0}")))
}

/// Two digits fewer than `tolerance` vouches for, at least three and at most ten.
pub(crate) fn rounded(value: f64, tolerance: f64) -> String {
    match value.abs() < tolerance.max(1e-300) {
        true => "0".into(),
        false => with_digits(value, digits(tolerance)),
    }
}

fn digits(tolerance: f64) -> usize {
    let vouched = -libm::log10(tolerance.max(1e-12));
    (vouched.floor() as i32 - 2).clamp(3, 10) as usize
}

fn with_digits(value: f64, digits: usize) -> String {
    if !value.is_finite() {
        return "no value".into();
    }
    if value == 0.0 {
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
    use super::{apart, rounded};
    use crate::evidence::Sample;

    #[test]
    fn values_keep_two_digits_fewer_than_the_tolerance_vouches_for() {
        assert_eq!(rounded(0.536_995_469_1, 1e-6), "0.5370");
        assert_eq!(rounded(123.456_789_012_3, 1e-12), "123.4567890");
        assert_eq!(rounded(-2.5e-7, 1e-12), "-2.500000000e-7");
        assert_eq!(rounded(1e-14, 1e-12), "0");
        assert_eq!(rounded(f64::NAN, 1e-12), "no value");
        assert_eq!(rounded(f64::INFINITY, 0.0), "no value");
    }

    #[test]
    fn what_disagrees_is_seen_to() {
        let of = |stated, found| {
            let at = String::new();
            apart(&Sample { at, stated, found }, 1e-6)
        };
        assert_eq!(of(1.0, 1.000_002_5), ["1.0000000", "1.0000025"]);
        assert_eq!(of(2.0, 3.0), ["2.000", "3.000"]);
        assert_eq!(of(0.0, 3e-9), ["0", "3.000e-9"]);
        assert_eq!(of(f64::NAN, 1.0), ["no value", "1.000"]);
    }
}
