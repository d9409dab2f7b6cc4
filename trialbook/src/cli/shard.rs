//! Shares of work for several jobs, cut by index.

use std::str::FromStr;

/// A part of work that several share: the K-th of N.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shard {
    part: u64,
    of: u64,
}

impl FromStr for Shard {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let parts = text.split_once('/');
        let parts = parts.and_then(|(part, of)| Some((part.parse().ok()?, of.parse().ok()?)));
        match parts {
            Some((part, of)) if 1 <= part && part <= of && of <= 1_000_000 => Ok(Self { part, of }),
            _ => Err("K/N, with K from 1 to N and N up to 10⁶".into()),
        }
    }
}

impl Shard {
    /// All of it.
    pub const WHOLE: Self = Self { part: 1, of: 1 };

    /// The indices of `total` that are this part's.
    pub fn range(self, total: u64) -> std::ops::Range<u64> {
        let bound = |part: u64| (u128::from(total) * u128::from(part) / u128::from(self.of)) as u64;
        bound(self.part - 1)..bound(self.part)
    }

    /// Whether it has the beginning.
    pub fn is_first(self) -> bool {
        self.part == 1
    }

    /// Whether it has the end.
    pub fn is_last(self) -> bool {
        self.part == self.of
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_are_all_of_it_and_none_twice() {
        for total in [0, 1, 7, 100, u64::MAX] {
            let mut next = 0;
            for part in 1..=16 {
                let range = Shard { part, of: 16 }.range(total);
                assert_eq!(range.start, next);
                next = range.end;
            }
            assert_eq!(next, total);
        }
        for wrong in ["", "1", "0/3", "4/3", "1/0", "a/b", "1/2/3"] {
            assert!(wrong.parse::<Shard>().is_err(), "{wrong}");
        }
    }
}
