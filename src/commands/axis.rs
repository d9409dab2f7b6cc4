//! Numbers of the command line: one, several by name, or equally spaced ones; and the grid that several such make.

use crate::numerics::{
    error::plain,
    expression::{ExpressionError, expression},
};
use crate::solve::Double;
use std::str::FromStr;

/// One number, several that are listed, or several with equal differences or ratios.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Axis {
    low: Double,
    high: Double,
    count: u64,
    /// Whether it is given as a range, be it one of a single number.
    range: bool,
    /// Whether the ratios are equal.
    log: bool,
    /// Whether it names degrees.
    degrees: bool,
    /// The numbers, where they are listed: kept as long as the command line.
    listed: Option<&'static [Double]>,
}

/// A decimal number, as it stands, or an expression.
pub(super) fn number(text: &str) -> Result<Double, String> {
    if let Ok(number) = text.parse::<Double>() {
        return Ok(number);
    }
    let told = |error: ExpressionError| match error {
        ExpressionError::Missing {
            wanted: "an operator",
            ..
        } => {
            format!("{error}; a number with a unit is for `slipbook scene`")
        }
        other => other.to_string(),
    };
    expression(text, |digits| digits.parse().ok()).map_err(told)
}

impl FromStr for Axis {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let degrees = text.contains("deg") || text.contains('°');
        if text.contains(',') && !text.contains(':') {
            let listed = listed(text)?;
            return Ok(Self {
                low: listed[0],
                high: listed[listed.len() - 1],
                count: listed.len() as u64,
                range: true,
                degrees,
                listed: Some(listed.leak()),
                ..Self::default()
            });
        }
        let (low, high, count, log) = match text.split(':').collect::<Vec<_>>()[..] {
            [one] => {
                return Ok(Self {
                    degrees,
                    ..number(one)?.into()
                });
            }
            [low, high, count] => (finite(low)?, finite(high)?, count, false),
            [low, high, count, "log"] => (finite(low)?, finite(high)?, count, true),
            _ => return Err(FORMS.into()),
        };
        let count = count.parse().unwrap_or(0);
        if !(1..=1_000_000_000).contains(&count) {
            return Err("COUNT must be a whole number from 1 to 10⁹".into());
        }
        if log && !(f64::from(low) > 0.0 && f64::from(high) > 0.0) {
            return Err("LOW and HIGH must be positive for equal ratios".into());
        }
        Ok(Self {
            low,
            high,
            count,
            range: true,
            log,
            degrees,
            listed: None,
        })
    }
}

/// What may stand for a number.
const FORMS: &str = "a number, several between commas, LOW:HIGH:COUNT or LOW:HIGH:COUNT:log";

/// Numbers between commas; behind a single one there is a comma too. What may be one number with a decimal comma is refused.
fn listed(text: &str) -> Result<Vec<Double>, String> {
    let parts: Vec<_> = text.strip_suffix(',').unwrap_or(text).split(',').collect();
    let whole = |part: &&str| part.bytes().all(|b| b.is_ascii_digit());
    if let [one, two] = parts[..]
        && whole(&one.trim_start_matches(['-', '−']))
        && whole(&two)
        && !text.ends_with(',')
    {
        return Err(format!(
            "`{text}`: the decimal sign is a point; the two numbers are `{text},`"
        ));
    }
    parts.into_iter().map(finite).collect()
}

fn finite(part: &str) -> Result<Double, String> {
    let number = number(part)?;
    let fit = f64::from(number).is_finite();
    fit.then_some(number)
        .ok_or_else(|| format!("`{part}` is not finite"))
}

impl From<Double> for Axis {
    fn from(one: Double) -> Self {
        Self {
            low: one,
            high: one,
            count: 1,
            range: false,
            log: false,
            degrees: false,
            listed: None,
        }
    }
}

impl Default for Axis {
    fn default() -> Self {
        Double::default().into()
    }
}

impl Axis {
    /// How many numbers these are.
    pub(super) fn count(&self) -> u64 {
        self.count
    }

    /// The number of this index. One between the ends is a decimal fraction of fifteen digits, so that what is shown is what is
    /// calculated.
    pub(super) fn at(&self, i: u64) -> Double {
        if let Some(listed) = self.listed {
            return listed.get(i as usize).copied().unwrap_or(self.high);
        }
        if i == 0 {
            return self.low;
        }
        if i + 1 >= self.count {
            return self.high;
        }
        let share = i as f64 / (self.count - 1) as f64;
        let [low, high] = [self.low, self.high].map(f64::from);
        let [from, to] = [low, high].map(|end| if self.log { libm::log10(end) } else { end });
        let between = from * (1.0 - share) + to * share;
        let between = if self.log {
            libm::exp10(between)
        } else {
            between
        };
        // What is nothing beside both ends is rounding.
        if !self.log && between.abs() < 1e-15 * low.abs().max(high.abs()) {
            return Double::default();
        }
        let text = format!("{between:.14e}");
        text.parse().unwrap_or_else(|_| between.into())
    }
}

/// A place in a grid while it is taken apart: the first axis asked runs fastest.
pub(super) struct Point {
    index: u64,
    /// How many points the axes asked so far have together; nothing if more than 2⁶⁴.
    pub(super) total: Option<u64>,
    /// Names and numbers of the axes that are ranges.
    pub(super) swept: Vec<(&'static str, f64)>,
}

impl Point {
    pub(super) fn new(index: u64) -> Self {
        Self {
            index,
            total: Some(1),
            swept: Vec::new(),
        }
    }

    /// This axis's number at the place.
    pub(super) fn on(&mut self, name: &'static str, axis: &Axis) -> Double {
        let number = axis.at(self.index % axis.count);
        self.index /= axis.count;
        self.total = self.total.and_then(|total| total.checked_mul(axis.count));
        if axis.range {
            self.swept.push((name, number.into()));
        }
        number
    }
}

/// A warning for an angle of more than a turn that does not say whether it is in degrees.
pub(super) fn is_it_degrees(name: &str, axis: &Axis) -> Option<String> {
    let ends = [axis.low, axis.high];
    let ends = axis.listed.unwrap_or(&ends).iter().copied().map(f64::from);
    let turns = |angle: &f64| angle.is_finite() && angle.abs() > std::f64::consts::TAU;
    let mut ends = ends;
    let turns = ends.find(turns).filter(|_| !axis.degrees);
    turns.map(|angle| {
        let angle = plain(angle);
        format!("{name} = {angle} is in radians, more than a turn; {angle}deg is in degrees")
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_axis_is_a_number_or_two_ends_and_a_count() {
        let axis: Axis = "-1:2:4".parse().unwrap();
        for (i, expected) in [(0, -1.0), (1, 0.0), (2, 1.0), (3, 2.0)] {
            assert!((f64::from(axis.at(i)) - expected).abs() < 1e-15);
        }
        let axis: Axis = "0:1:11".parse().unwrap();
        assert_eq!(axis.at(3), "0.3".parse().unwrap());
        for (axis, i, shown) in [
            // Fifteen digits, no fewer and no more.
            ("0:1:4", 1, "0.333333333333333"),
            ("0:2e9:4", 2, "1333333333.33333"),
            ("-0.2:0.1:4", 2, "0"),
            // Small beside the ends, and not their rounding.
            ("-1:1.00001:3", 1, "5e-6"),
            ("-1:1.000000001:3", 1, "5e-10"),
            ("-1e-30:2e-30:4", 2, "1e-30"),
        ] {
            let axis: Axis = axis.parse().unwrap();
            let rounding = 1e-16 * f64::from(axis.high);
            let (found, shown) = (axis.at(i), shown.parse::<Double>().unwrap());
            let apart = f64::from(found - shown).abs();
            assert!(apart <= rounding, "{found:?} {shown:?}");
        }
        let [one, decades]: [Axis; 2] = ["5:7:1", "1e-3:1:4:log"].map(|axis| axis.parse().unwrap());
        assert!((one.count(), one.range, one.at(0)) == (1, true, 5.0.into()));
        assert_eq!([1, 2].map(|i| f64::from(decades.at(i))), [0.01, 0.1]);
        let axis: Axis = "0.5,-0.1,pi".parse().unwrap();
        let all = [0, 1, 2].map(|i| f64::from(axis.at(i)));
        assert_eq!(all, [0.5, -0.1, std::f64::consts::PI]);
        for (text, count) in [("1,2,", 2), ("3,", 1), ("1,2,3", 3), ("1.5,2", 2)] {
            let axis: Axis = text.parse().unwrap();
            assert!((axis.count(), axis.range) == (count, true), "{text}");
        }
        assert_eq!("0.5".parse::<Axis>().unwrap().at(0), 0.5.into());
        let axis: Axis = "-pi:180deg:3".parse().unwrap();
        assert!(f64::from(axis.at(2)) == std::f64::consts::PI && f64::from(axis.at(1)) == 0.0);
        for wrong in [
            "",
            "1:2",
            "1:2:0",
            "1:2:x",
            "nan:1:2",
            "1:inf:3",
            "1:2:3:4",
            "0,5",
            "-0,5",
            "0.1,,2",
            ",",
            "1,inf,2",
            "1,2:3:4",
            "0:1:3:log",
        ] {
            assert!(wrong.parse::<Axis>().is_err(), "{wrong}");
        }
    }

    #[test]
    fn an_angle_that_names_its_degrees_is_not_warned_of() {
        let warned = |text: &str| is_it_degrees("psi", &text.parse().unwrap());
        assert!(warned("720").unwrap().contains("720deg"));
        assert!(warned("-720:0:3").unwrap().contains("-720deg"));
        assert!(warned("0:720:3").unwrap().contains(" 720deg"));
        // A turn itself is none too many.
        assert!(warned("6.29").is_some() && warned("-2*pi:2*pi:3").is_none());
        assert!(warned("1,720,2").unwrap().contains("720deg"));
        for fine in ["720deg", "720°", "6", "0:720deg:3"] {
            assert_eq!(warned(fine), None, "{fine}");
        }
    }

    #[test]
    fn a_point_of_a_grid_has_a_number_of_each_axis() {
        let [a, b]: [Axis; 2] = ["0:1:2", "5:7:3"].map(|axis| axis.parse().unwrap());
        let mut seen = Vec::new();
        for index in 0..6 {
            let mut point = Point::new(index);
            let (b, a) = (point.on("b", &b), point.on("a", &a));
            assert_eq!(point.total, Some(6));
            seen.push([f64::from(a), f64::from(b)]);
        }
        assert_eq!(seen[0], [0.0, 5.0]);
        assert_eq!(seen[1], [0.0, 6.0]);
        assert_eq!(seen[5], [1.0, 7.0]);
    }
}
