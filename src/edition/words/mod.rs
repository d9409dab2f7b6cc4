//! What the words and numbers of the pages are computed by: `{{is name falls|rises}}`, `{{is name six}}`.
//!
//! The name says what the first of the words says.

mod shaken;
mod sliding;
mod told;
mod turning;

use trialbook::publishing::{Failure, Word};

type Known<T = f64> = Result<T, Failure>;

/// The words of all pages.
pub(super) const WORDS: &[&[Word]] = &[sliding::WORDS, shaken::WORDS, turning::WORDS, told::WORDS];

/// What says which word it is, or which number.
trait Says {
    fn says(self) -> Known;
}

impl Says for bool {
    fn says(self) -> Known {
        Ok(f64::from(u8::from(!self)))
    }
}

/// Of several the one that is so.
impl<const N: usize> Says for [bool; N] {
    fn says(self) -> Known {
        let mut so = (0..N).filter(|i| self[*i]);
        match (so.next(), so.next()) {
            (Some(i), None) => Ok(i as f64),
            _ => Err(format!("not one of them is so: {self:?}").into()),
        }
    }
}

impl Says for usize {
    fn says(self) -> Known {
        Ok(self as f64)
    }
}

impl Says for f64 {
    fn says(self) -> Known {
        Ok(self)
    }
}

macro_rules! words {
    ($($name:literal => $is:expr;)*) => {
        pub(super) const WORDS: &[Word] = &[$(Word { name: $name, is: || super::Says::says($is) }),*];
    };
}

use words;

/// Numbers from `low` to `high`.
fn along(low: f64, high: f64) -> impl Iterator<Item = f64> + Clone {
    (0..=20).map(move |i| low + (high - low) * f64::from(i) / 20.0)
}

fn falls(values: impl Iterator<Item = f64>) -> bool {
    let values: Vec<_> = values.collect();
    values.windows(2).all(|two| two[0] > two[1])
}

fn rises(values: impl Iterator<Item = f64>) -> bool {
    falls(values.map(|x| -x))
}

fn same(a: f64, b: f64, tolerance: f64) -> bool {
    (a - b).abs() <= tolerance * b.abs()
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
