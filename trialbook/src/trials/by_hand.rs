//! Why a claim fails, with a case to see it with paper and pencil.

use super::compare::Failure;
use std::panic::Location;

/// The two numbers of a claim's case; the words are in the claim's entry.
#[derive(Debug, Clone, Copy)]
pub struct Numbers {
    /// Id of the claim.
    pub claim: &'static str,
    /// The number by the claim as printed.
    pub stated: fn() -> Result<f64, Failure>,
    /// The number that the motion has.
    pub found: fn() -> Result<f64, Failure>,
    pub(super) place: &'static Location<'static>,
}

impl Numbers {
    /// The numbers of the case of the claim of this id.
    #[track_caller]
    pub const fn new(
        claim: &'static str,
        stated: fn() -> Result<f64, Failure>,
        found: fn() -> Result<f64, Failure>,
    ) -> Self {
        Self {
            claim,
            stated,
            found,
            place: Location::caller(),
        }
    }
}

/// A case of a claim that fails.
#[derive(Debug, Clone, Copy)]
pub struct ByHand {
    /// What is wrong, in a few words: `the sign of the second term`; formulas in `$…$`.
    pub wrong: &'static str,
    /// Where the derivation goes wrong; formulas in `$…$`.
    pub reason: &'static str,
    /// The case; formulas in `$…$`, `{stated}` and `{found}` for the two numbers.
    pub case: &'static str,
    /// Digits shown of the numbers.
    pub digits: usize,
    /// Both numbers once more, as expressions worked out with paper and pencil.
    pub pencil: [&'static str; 2],
    /// The other decimals of the texts, likewise.
    pub decimals: &'static [&'static str],
    /// The numbers.
    pub computed: Numbers,
}

impl ByHand {
    /// The stated and the found number, as shown.
    ///
    /// # Errors
    /// A motion that cannot be followed.
    pub fn numbers(&self) -> Result<[String; 2], Failure> {
        let shown = |value: f64| {
            let text = format!("{value:.*}", self.digits);
            // No sign is left of a zero.
            let zero = text
                .strip_prefix('-')
                .filter(|size| size.parse() == Ok(0.0));
            zero.map_or(text.clone(), str::to_owned)
        };
        let Numbers { stated, found, .. } = self.computed;
        Ok([shown(stated()?), shown(found()?)])
    }

    /// The case with its numbers, formulas in `$…$`.
    ///
    /// # Errors
    /// As [`ByHand::numbers`].
    pub fn words(&self) -> Result<String, Failure> {
        let [stated, found] = self.numbers()?;
        let words = self.case.replace("{stated}", &stated);
        Ok(words.replace("{found}", &found))
    }
}
