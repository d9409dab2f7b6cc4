//! What the words and numbers of the pages are computed by: `{{is name falls|rises}}`, `{{is name six}}`.
//!
//! The name says what the first of the words says.

mod counted;
mod shaken;
mod sliding;
mod told;
mod turning;

use crate::figures::{falls, rises, same};
use trialbook::publishing::{Failure, Word};

type Known<T = f64> = Result<T, Failure>;

pub(super) const WORDS: &[&[Word]] = &[
    sliding::WORDS,
    shaken::WORDS,
    turning::WORDS,
    told::WORDS,
    counted::WORDS,
];

macro_rules! words {
    ($($name:literal => $is:expr;)*) => {
        pub(super) const WORDS: &[Word] = &[$(Word { name: $name, is: || Ok(trialbook::notation::Says::says($is)?) }),*];
    };
}

use words;

fn along(low: f64, high: f64) -> impl Iterator<Item = f64> + Clone {
    (0..=20).map(move |i| low + (high - low) * f64::from(i) / 20.0)
}

/// What is computed along a range, if all of it can be.
fn tried<T>(values: impl Iterator<Item = Known<T>>) -> Known<std::vec::IntoIter<T>> {
    Ok(values.collect::<Known<Vec<_>>>()?.into_iter())
}

fn known<T>(value: T) -> Known<T> {
    Ok(value)
}

fn found<T>(value: Option<T>) -> Known<T> {
    value.ok_or_else(|| "there is none".into())
}
