//! Between which ends a trial's points lie, read from what they are called.

use serde::Serialize;

/// Of more a reader keeps none in mind.
const MOST: usize = 5;

/// The least and the greatest value of each coordinate.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
pub struct Ranges {
    coordinates: Vec<(String, [f64; 2])>,
    /// Not all points have the same coordinates, or are numbers.
    mixed: bool,
}

impl Ranges {
    /// Takes in a point with a name such as `λ = 1.5, θ₀ = 0.2`.
    pub fn take(&mut self, at: &str) {
        if self.mixed {
            return;
        }
        let first = self.coordinates.is_empty();
        let mut known = self.coordinates.len();
        for (i, part) in at.split(", ").enumerate() {
            let Some((name, value)) = coordinate(part) else {
                self.mixed = true;
                return;
            };
            if first {
                self.coordinates.push((name.to_owned(), [value; 2]));
                continue;
            }
            match self.coordinates.get_mut(i) {
                Some((other, [low, high])) if other == name => {
                    (*low, *high) = (low.min(value), high.max(value));
                    known -= 1;
                }
                _ => self.mixed = true,
            }
        }
        self.mixed |= known > 0;
    }

    /// `λ from 1.00 to 966, θ₀ from 0 to 3.14`; nothing where that cannot be told.
    pub fn words(&self) -> Option<String> {
        let told = !self.mixed && (1..=MOST).contains(&self.coordinates.len());
        let words = |(name, [low, high]): &(String, [f64; 2])| {
            let [mut from, to] = [short(*low), short(*high)];
            // As where λ > 1 is stated, and points lie as close to 1 as a number can.
            if from == "1" && *low > 1.0 {
                from = "just above 1".to_owned();
            }
            match from == to {
                true => format!("{name} = {from}"),
                false => format!("{name} from {from} to {to}"),
            }
        };
        let words: Vec<_> = self.coordinates.iter().map(words).collect();
        told.then(|| words.join(", "))
    }
}

fn coordinate(part: &str) -> Option<(&str, f64)> {
    let (name, value) = part.split_once(" = ")?;
    let name = name.strip_prefix("from ").unwrap_or(name);
    let value: f64 = value.replace('−', "-").parse().ok()?;
    value.is_finite().then_some((name, value))
}

pub(crate) fn short(value: f64) -> String {
    let scientific = format!("{value:.2e}");
    let Some((digits, power)) = scientific.split_once('e') else {
        return scientific;
    };
    match power.parse() {
        _ if value == 0.0 => "0".to_owned(),
        Ok(e @ -3..=1) => trimmed(&format!("{value:.*}", (2 - e) as usize)),
        Ok(2..=5) => format!("{value:.0}"),
        _ => format!("{}e{power}", trimmed(digits)),
    }
}

fn trimmed(decimal: &str) -> String {
    decimal
        .trim_end_matches('0')
        .trim_end_matches('.')
        .to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(points: &[&str]) -> Option<String> {
        let mut ranges = Ranges::default();
        points.iter().for_each(|point| ranges.take(point));
        ranges.words()
    }

    #[test]
    fn points_are_told_by_their_ends() {
        for (points, words) in [
            (
                &["λ = 1.5, θ₀ = 0", "λ = 0.25, θ₀ = 0"][..],
                "λ from 0.25 to 1.5, θ₀ = 0",
            ),
            (&["p = 1e-20", "p = 1234567"], "p from 1e-20 to 1.23e6"),
        ] {
            assert_eq!(of(points).as_deref(), Some(words));
        }
        for points in [
            &["λ = 1", "μ = 1"][..],
            &["λ = 1, q = 2", "λ = 1"],
            &["λ = 1", "λ = 1, q = 2"],
            &["a sine, λ = 1"],
            &["t = 1 to 2"],
            &[],
        ] {
            assert_eq!(of(points), None, "{points:?}");
        }
    }
}
