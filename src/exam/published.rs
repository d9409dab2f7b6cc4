//! Numbers that others have published, with ours beside them.
//!
//! Cited is only what was read. Whether a number agrees is computed from its printed digits.

mod balls;
mod blocks;
mod follow;
mod shaken;
pub mod sliding;

use super::ExamError;

/// Where a number comes from.
#[derive(Debug, PartialEq, Eq)]
pub struct Source {
    /// What it is.
    pub title: &'static str,
    /// What of it was read.
    pub read: &'static str,
}

/// A number as it stands in its source.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Printed {
    /// Decimals, good to half a unit of the last one.
    Decimal(&'static str),
    /// A fraction of two whole numbers.
    Fraction(i32, i32),
    /// A formula, and its value.
    Formula(&'static str, f64),
}

/// A published number, and ours.
#[derive(Debug)]
pub struct Case {
    /// Where it stands.
    pub source: &'static Source,
    /// The set-up and what is asked.
    pub asked: &'static str,
    /// The number, and its unit.
    pub printed: Printed,
    /// Its unit; empty for a dimensionless number.
    pub unit: &'static str,
    /// Why the two differ, where they do.
    pub why: &'static str,
    ours: fn() -> Result<f64, ExamError>,
}

/// How a published number stands beside ours.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Standing {
    /// It is the same in all its digits.
    Agrees,
    /// It is off by no more than two units of its last digit.
    Rounded,
    /// It is wrong.
    Wrong,
}

/// What our motions promise, relative.
const OURS: f64 = 1e-11;

/// All cases but those of [`sliding`].
pub fn cases() -> impl Iterator<Item = &'static Case> {
    blocks::CASES
        .iter()
        .chain(&shaken::CASES)
        .chain(&balls::CASES)
}

impl Printed {
    /// The number.
    pub fn value(self) -> f64 {
        match self {
            Self::Decimal(text) => text.parse().unwrap_or(f64::NAN),
            Self::Fraction(n, m) => f64::from(n) / f64::from(m),
            Self::Formula(_, value) => value,
        }
    }

    /// A unit of its last digit; 0 for a number that is exact.
    pub fn unit(self) -> f64 {
        match self {
            Self::Decimal(text) => {
                let (digits, power) = text.split_once('E').unwrap_or((text, "0"));
                let decimals = digits.split_once('.').map_or(0, |(_, after)| after.len());
                let power: f64 = power.parse().unwrap_or(f64::NAN);
                libm::pow(10.0, power - decimals as f64)
            }
            _ => 0.0,
        }
    }
}

impl std::fmt::Display for Printed {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Decimal(text) | Self::Formula(text, _) => f.write_str(text),
            Self::Fraction(n, m) => write!(f, "{n}/{m}"),
        }
    }
}

impl Case {
    /// Our number, in the source's unit, by following the motion.
    ///
    /// # Errors
    /// [`ExamError`] where the motion cannot be followed.
    pub fn ours(&self) -> Result<f64, ExamError> {
        (self.ours)()
    }

    /// How the published number stands beside ours.
    ///
    /// # Errors
    /// As [`ours`](Self::ours).
    pub fn standing(&self) -> Result<Standing, ExamError> {
        let ours = self.ours()?;
        let apart = (self.printed.value() - ours).abs();
        let (unit, known) = (self.printed.unit(), OURS * ours.abs());
        Ok(if apart <= 0.5 * unit + known {
            Standing::Agrees
        } else if apart <= 2.0 * unit {
            Standing::Rounded
        } else {
            Standing::Wrong
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_number_that_differs_has_a_reason_and_no_other() {
        let mut failures = Vec::new();
        for case in cases() {
            let (standing, ours) = (case.standing().unwrap(), case.ours().unwrap());
            if (standing == Standing::Agrees) != case.why.is_empty() {
                failures.push(format!(
                    "{}: {} here {ours} {standing:?}",
                    case.asked, case.printed
                ));
            }
        }
        assert!(failures.is_empty(), "{failures:#?}");
    }

    #[test]
    fn more_than_twenty_have_published() {
        let mut sources: Vec<_> = cases().map(|case| case.source.title).collect();
        sources.push(sliding::PYSLAMMER.title);
        sources.sort_unstable();
        sources.dedup();
        assert!(sources.len() > 20, "{sources:#?}");
    }

    #[test]
    fn the_digits_decide() {
        let case = |text| Case {
            printed: Printed::Decimal(text),
            ours: || Ok(8.0589),
            ..case_of_nothing()
        };
        for (text, standing) in [
            ("8.06", Standing::Agrees),
            ("8.05", Standing::Rounded),
            ("8.03", Standing::Wrong),
            ("8.0589", Standing::Agrees),
            ("8", Standing::Agrees),
            ("0.0806E2", Standing::Agrees),
            ("0.0805E2", Standing::Rounded),
            ("80.5E-1", Standing::Rounded),
            ("80.5", Standing::Wrong),
        ] {
            assert_eq!(case(text).standing().unwrap(), standing, "{text}");
        }
    }

    fn case_of_nothing() -> Case {
        Case {
            source: &sliding::PYSLAMMER,
            asked: "",
            printed: Printed::Fraction(1, 1),
            unit: "",
            why: "",
            ours: || Ok(1.0),
        }
    }
}
