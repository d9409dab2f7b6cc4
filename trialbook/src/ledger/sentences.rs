//! A trial in sentences: formulas in `$…$`, numbers as `2e-13`.

use crate::evidence::{Evidence, Outcome, Route, Subject};
use crate::notation::decimal;

impl Route {
    fn method(self) -> &'static str {
        match self {
            Route::Exact => "in exact arithmetic",
            Route::Certified => "with rigorous bounds",
            Route::Integration => "by integrating the equation of motion",
            Route::Quadrature => "by quadrature",
            Route::Root => "by solving for the root",
            Route::Limit => "by following the approach to the limit",
            Route::Census => "case by case",
            Route::Consistency => "as a test of consistency",
        }
    }
}

impl Evidence {
    /// What was compared, by which method, at which points: one sentence.
    pub fn comparison(&self) -> String {
        let (words, method) = (self.compared.words(), self.route.method());
        if self.compared.found().is_none() {
            return format!("The statement, {method}: {words}.");
        }
        let points = match self.points {
            // A proof of formulas has no points.
            _ if self.route.is_proof() && self.samples.is_empty() => String::new(),
            1 => ", at one point".to_owned(),
            n => format!(", at {} points", count(n)),
        };
        let ranges = self.compared.points();
        let ranges = ranges.or_else(|| self.ranges.words());
        let points = match ranges {
            Some(ranges) if !points.is_empty() => format!("{points}, {ranges}"),
            _ => points,
        };
        format!("{}, {method}{points}.", self.opened())
    }

    /// What came of it, in a sentence, the same on every machine.
    pub fn result(&self) -> String {
        let tolerance = self.tolerance.value;
        if self.route.is_proof() {
            return self.proof_result();
        }
        match self.outcome() {
            Outcome::Agrees if tolerance == 0.0 => {
                "All agree; no disagreement is allowed.".to_owned()
            }
            Outcome::Agrees => format!("All agree to {}.", short(tolerance, 0)),
            // The number of those beyond a tolerance may turn on a last bit.
            Outcome::Disagrees if tolerance > 0.0 => {
                format!("Not all agree to {}.", short(tolerance, 0))
            }
            Outcome::Disagrees => {
                let failed = self.failing();
                format!("{failed}; {}.", self.allowed())
            }
            Outcome::NotANumber | Outcome::TooFewPoints => self.no_result(),
        }
    }

    /// What came of it, and how far the two sides were apart at most.
    pub fn measured(&self) -> String {
        let tolerance = short(self.tolerance.value, 0);
        if self.route.is_proof() {
            return self.proof_result();
        }
        let at = match self.at.as_str() {
            "" => String::new(),
            at => format!(" at {at}"),
        };
        let worst = match self.worst.is_infinite() {
            true => format!("there is no value where the motion has one, for instance{at}"),
            false => format!("the worst differs by {},{at}", short(self.worst, 1)),
        };
        let worst = worst.trim_end_matches([',', ' ']);
        match self.outcome() {
            Outcome::Agrees if self.worst == 0.0 => self.result(),
            Outcome::Agrees => format!("All agree to {tolerance}; {worst}."),
            Outcome::Disagrees if self.tolerance.value > 0.0 => {
                format!("{} by more than {tolerance}; {worst}.", self.failing())
            }
            Outcome::Disagrees => {
                let failing = self.failing();
                format!("{failing}, for instance{at}; {}.", self.allowed())
            }
            Outcome::NotANumber | Outcome::TooFewPoints => self.no_result(),
        }
    }

    fn opened(&self) -> String {
        let words = self.compared.words();
        let mut letters = words.chars();
        let first = letters.next().map(|c| c.to_ascii_uppercase());
        first.into_iter().chain(letters).collect()
    }

    fn allowed(&self) -> &'static str {
        match self.subject {
            Subject::Outside => "that is why the condition is needed",
            _ => "no disagreement is allowed",
        }
    }

    fn failing(&self) -> String {
        match (self.failed, self.points) {
            (1, 1) => "The two sides disagree".to_owned(),
            (failed, points) if failed == points => format!("All {} disagree", count(points)),
            (1, points) => format!("1 of {} disagrees", count(points)),
            (failed, points) => format!("{} of {} disagree", count(failed), count(points)),
        }
    }

    fn proof_result(&self) -> String {
        let steps = match self.steps.len() {
            0 => String::new(),
            1 => " in one step".to_owned(),
            n => format!(" in {n} steps"),
        };
        match self.outcome() {
            Outcome::Agrees if self.is_in_words() => {
                format!("Checked{steps}; why that is enough is not checked here.")
            }
            Outcome::Agrees => format!("Shown{steps}{}.", self.quantified()),
            Outcome::Disagrees if self.failed > 0 => {
                format!("Disproved: {}.", self.failing().to_lowercase())
            }
            Outcome::Disagrees => format!("Disproved: {}.", self.at.trim_end_matches('.')),
            Outcome::NotANumber | Outcome::TooFewPoints => self.no_result(),
        }
    }

    fn quantified(&self) -> String {
        let words = self.compared.words();
        let says = ["every ", "all ", "any "]
            .iter()
            .any(|of| words.contains(of));
        let mut text = String::new();
        if self.route == Route::Exact && self.compared.found().is_some() && !says {
            text += ", for all values of the symbols for which both sides have one";
        }
        if let [others @ .., last] = &self.positive[..] {
            let all = match others {
                [] => format!("{last} is"),
                _ => format!("{} and {last} are", others.join(", ")),
            };
            text += if text.is_empty() { ", where " } else { " and " };
            text += &format!("{all} positive");
        }
        text
    }

    fn no_result(&self) -> String {
        let what = match self.route.is_proof() {
            true => "Not proved",
            false => "No number was found",
        };
        match self.outcome() {
            Outcome::TooFewPoints => {
                let least = self.needed();
                format!("Too few points: at least {least} different ones are needed.")
            }
            _ if self.at.is_empty() => format!("{what}."),
            _ => format!("{what}: {}.", self.at.trim_end_matches('.')),
        }
    }
}

/// With so many decimals of its mantissa, without a power of ten where none is needed.
fn short(size: f64, decimals: usize) -> String {
    let scientific = format!("{size:.decimals$e}");
    decimal(&scientific).unwrap_or(scientific)
}

pub(super) fn rounded_up(size: f64) -> String {
    let nearest = format!("{size:.0e}");
    match nearest.parse::<f64>() {
        Ok(rounded) if rounded < size => {
            let unit = 10f64.powf(size.log10().floor());
            short(rounded + unit, 0)
        }
        _ => short(size, 0),
    }
}

pub(crate) fn count(n: usize) -> String {
    let digits = n.to_string();
    let mut out = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            out.push(',');
        }
        out.push(digit);
    }
    out
}

/// `1 point`, `20 points`.
#[cfg(feature = "book")]
pub(crate) fn counted(n: usize, noun: &str) -> String {
    let plural = if n == 1 { "" } else { "s" };
    format!("{} {noun}{plural}", count(n))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::evidence::Compared;
    use crate::trials::tolerances::NONE;

    #[test]
    fn a_bound_is_never_below_what_it_bounds() {
        for (size, bound) in [
            (1.2e-13, "2e-13"),
            (1.7e-13, "2e-13"),
            (3e-13, "3e-13"),
            (9.1e-13, "1e-12"),
            (9.6e-13, "1e-12"),
            (0.21, "0.3"),
            (0.96, "1"),
        ] {
            assert_eq!(rounded_up(size), bound, "{size}");
        }
    }

    #[test]
    fn an_identity_says_for_what_it_holds() {
        let said = |route, compared| {
            let proved = Evidence {
                points: 1,
                ..Evidence::new(route, Subject::Printed, compared, NONE)
            };
            proved.result()
        };
        let identity = Compared::one("$a$", "$b$");
        let all = "Shown, for all values of the symbols for which both sides have one.";
        assert_eq!(said(Route::Exact, identity), all);
        for (route, compared) in [
            (Route::Certified, identity),
            (Route::Exact, Compared::one("$a$ for every $x$", "$b$")),
        ] {
            assert_eq!(said(route, compared), "Shown.");
        }
        let in_words = said(Route::Exact, Compared::shown("it never stops"));
        assert_eq!(in_words, "Checked; why that is enough is not checked here.");
    }

    #[test]
    fn thousands_are_parted() {
        for (n, written) in [
            (0, "0"),
            (999, "999"),
            (1000, "1,000"),
            (327_046, "327,046"),
            (12_345_678, "12,345,678"),
        ] {
            assert_eq!(count(n), written);
        }
    }
}
