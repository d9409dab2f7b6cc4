//! Axes: from values to places on the page, and back to what a reader reads off.

use super::{
    FigureError,
    svg::number,
    text::{markup, width},
    ticks::{self, Step, Tick},
};

pub(super) const TICK_SIZE: f64 = 15.0;
pub(super) const TEXT_SIZE: f64 = 16.0;

/// Sizes lie below this, spans (and values on a logarithmic axis) above its inverse: no step or ratio
/// overflows.
const LARGEST: f64 = 1e280;

/// An axis as asked for.
#[derive(Debug, Clone, PartialEq)]
pub struct Axis {
    pub(super) label: String,
    log: bool,
    range: Option<(f64, f64)>,
    ticks: Option<Vec<Tick>>,
    grid: bool,
}

impl Axis {
    /// A linear axis. Its ends are ticks around the data, or the data's own with chosen
    /// [`ticks`](Axis::ticks), unless [`range`](Axis::range) sets them. The label may hold a little
    /// mathematics: `v_x`, `A t/v_0`, `10^{-3}`; single quotes keep a lone letter upright.
    pub fn linear(label: impl Into<String>) -> Self {
        Axis {
            label: label.into(),
            log: false,
            range: None,
            ticks: None,
            grid: true,
        }
    }

    /// A logarithmic axis, base 10. Every finite value drawn on it must be > 0.
    pub fn log(label: impl Into<String>) -> Self {
        Axis {
            log: true,
            ..Axis::linear(label)
        }
    }

    /// Fixes the ends, `from` < `to`. What lies outside is cut off.
    pub fn range(mut self, from: f64, to: f64) -> Self {
        self.range = Some((from, to));
        self
    }

    /// Sets the ticks and their labels: `[(0.0, "0"), (PI, "π")]`; an empty label makes a small tick.
    pub fn ticks<L: Into<String>>(mut self, ticks: impl IntoIterator<Item = (f64, L)>) -> Self {
        let ticks = ticks.into_iter().map(|(at, label)| Tick {
            at,
            label: label.into(),
        });
        self.ticks = Some(ticks.collect());
        self
    }

    /// Leaves out the grid lines of this axis, as suits a raster.
    pub fn without_grid(mut self) -> Self {
        self.grid = false;
        self
    }

    /// One that is not finite is a gap, not an error.
    pub(super) fn check(&self, value: f64) -> Result<(), FigureError> {
        if self.log && value.is_finite() && value <= 0.0 {
            return Err(FigureError::NotPositive {
                axis: self.label.clone(),
                value,
            });
        }
        Ok(())
    }

    pub(super) fn settle(
        &self,
        values: impl Iterator<Item = f64>,
        about: usize,
    ) -> Result<Scale, FigureError> {
        let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
        for value in values.filter(|value| value.is_finite()) {
            self.check(value)?;
            low = low.min(value);
            high = high.max(value);
        }
        let refused = |from: f64, to: f64| FigureError::Range {
            axis: self.label.clone(),
            from,
            to,
        };
        let within = |from: f64, to: f64| {
            from.abs().max(to.abs()) < LARGEST && !(self.log && from <= 1.0 / LARGEST)
        };
        let (from, to) = match self.range {
            Some((from, to)) => {
                self.check(from)?;
                (from, to)
            }
            None if low > high => {
                return Err(FigureError::NoData(self.label.clone()));
            }
            None if !within(low, high) => return Err(refused(low, high)),
            // Chosen ticks say that the data's own ends are meant.
            None if self.ticks.is_some() && !narrow(low, high) => (low, high),
            None => self.around(low, high, about),
        };
        let apart = (1e-9 * from.abs().max(to.abs())).max(1.0 / LARGEST);
        if !(to - from > apart && within(from, to)) {
            return Err(refused(from, to));
        }
        let ticks = match &self.ticks {
            Some(ticks) => {
                let slack = 1e-9 * (to - from);
                let inside = |tick: &&Tick| tick.at >= from - slack && tick.at <= to + slack;
                let drawable = |tick: &&Tick| inside(tick) && !(self.log && tick.at <= 0.0);
                ticks.iter().filter(drawable).cloned().collect()
            }
            None if self.log => ticks::log(from, to, about),
            // A step that suited the data suits the ends around them too.
            None => {
                let fixed = self.range.is_some() || narrow(low, high);
                let span = if fixed { to - from } else { high - low };
                ticks::linear(from, to, Step::dividing(span, about))
            }
        };
        Ok(Scale {
            label: self.label.clone(),
            log: self.log,
            grid: self.grid,
            from,
            to,
            ticks,
            pixels: (0.0, 1.0),
        })
    }

    /// A single value gets room on both sides.
    fn around(&self, low: f64, high: f64, about: usize) -> (f64, f64) {
        match (self.log, narrow(low, high)) {
            (true, true) => ticks::around_log(low / 2.0, high * 2.0),
            (true, false) => ticks::around_log(low, high),
            (false, true) if low == 0.0 => (-1.0, 1.0),
            (false, true) => (low - 0.5 * low.abs(), high + 0.5 * high.abs()),
            (false, false) => Step::dividing(high - low, about).around(low, high),
        }
    }
}

/// Too close to be told apart on an axis between them.
fn narrow(low: f64, high: f64) -> bool {
    high - low <= (1e-9 * low.abs().max(high.abs())).max(1.0 / LARGEST)
}

#[derive(Debug, Clone)]
pub(super) struct Scale {
    pub label: String,
    pub log: bool,
    grid: bool,
    pub from: f64,
    pub to: f64,
    ticks: Vec<Tick>,
    pub pixels: (f64, f64),
}

/// Farther from the page than this nothing is told apart.
const FAR: f64 = 1e7;

impl Scale {
    pub(super) fn at(&self, value: f64) -> f64 {
        if !value.is_finite() {
            return f64::NAN;
        }
        let fraction = if self.log {
            (libm::log10(value) - libm::log10(self.from))
                / (libm::log10(self.to) - libm::log10(self.from))
        } else {
            (value - self.from) / (self.to - self.from)
        };
        let (a, b) = self.pixels;
        (a + fraction * (b - a)).clamp(-FAR, FAR)
    }

    pub(super) fn label_width(&self) -> f64 {
        let widths = self.ticks.iter().map(|tick| width(&tick.label, TICK_SIZE));
        widths.fold(0.0, f64::max)
    }

    /// It hangs over the end of a horizontal axis.
    pub(super) fn overhang(&self) -> f64 {
        self.ticks
            .last()
            .map_or(0.0, |tick| width(&tick.label, TICK_SIZE) / 2.0)
    }

    fn crosses_zero(&self) -> bool {
        !self.log && self.from < 0.0 && self.to > 0.0
    }
}

pub(super) fn frame(x: &Scale, y: &Scale) -> String {
    let (left, right) = x.pixels;
    let (bottom, top) = y.pixels;
    let (mut grid, mut ticks, mut labels) = (String::new(), String::new(), String::new());
    for tick in &x.ticks {
        let at = number(x.at(tick.at));
        let small = tick.label.is_empty();
        if x.grid && !small {
            grid += &format!("M{at} {}V{}", number(bottom), number(top));
        }
        let length = if small { 3.0 } else { 5.0 };
        ticks += &format!("M{at} {}v{length}", number(bottom));
        labels += &text(x.at(tick.at), bottom + 20.0, "middle", &tick.label);
    }
    for tick in &y.ticks {
        let at = number(y.at(tick.at));
        let small = tick.label.is_empty();
        if y.grid && !small {
            grid += &format!("M{} {at}H{}", number(left), number(right));
        }
        let length = if small { 3.0 } else { 5.0 };
        ticks += &format!("M{} {at}h-{length}", number(left));
        labels += &text(left - 9.0, y.at(tick.at) + 5.0, "end", &tick.label);
    }
    let mut zero = String::new();
    if x.crosses_zero() {
        zero += &format!("M{} {}V{}", number(x.at(0.0)), number(bottom), number(top));
    }
    if y.crosses_zero() {
        zero += &format!("M{} {}H{}", number(left), number(y.at(0.0)), number(right));
    }
    let axes = format!(
        "M{0} {1}V{2}H{3}",
        number(left),
        number(top),
        number(bottom),
        number(right)
    );
    let path = |data: &str, opacity: f64| {
        if data.is_empty() {
            return String::new();
        }
        format!(
            "<path d=\"{data}\" fill=\"none\" stroke=\"currentColor\" stroke-opacity=\"{opacity}\"/>\n"
        )
    };
    let x_label = text((left + right) / 2.0, bottom + 43.0, "middle", &x.label);
    let y_label = text(left - 6.0, top - 12.0, "start", &y.label);
    format!(
        "{}{}{}<g fill=\"currentColor\" font-size=\"{TICK_SIZE}\">\n{labels}</g>\n\
         <g fill=\"currentColor\" font-size=\"{TEXT_SIZE}\">\n{x_label}{y_label}</g>\n",
        path(&grid, 0.1),
        path(&zero, 0.35),
        path(&(axes + &ticks), 0.6),
    )
}

pub(super) fn text(x: f64, y: f64, anchor: &str, label: &str) -> String {
    if label.is_empty() {
        return String::new();
    }
    let anchor = match anchor {
        "start" => String::new(),
        other => format!(" text-anchor=\"{other}\""),
    };
    format!(
        "<text x=\"{}\" y=\"{}\"{anchor}>{}</text>\n",
        number(x),
        number(y),
        markup(label)
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_logarithmic_axis_refuses_what_has_no_logarithm() {
        for value in [0.0, -1.0] {
            let error = Axis::log("τ")
                .settle([1.0, value].into_iter(), 5)
                .unwrap_err();
            let axis = "τ".to_string();
            assert_eq!(error, FigureError::NotPositive { axis, value });
            assert!(
                Axis::log("τ")
                    .range(value, 1.0)
                    .settle([].into_iter(), 5)
                    .is_err()
            );
        }
    }

    #[test]
    fn ends_that_span_nothing_are_refused() {
        for (from, to) in [
            (1.0, 1.0),
            (1.0, 0.0),
            (f64::NAN, 1.0),
            (0.0, f64::INFINITY),
            (1.0, 1.0 + 1e-10),
            (-1e300, 1e300),
            (f64::MIN, f64::MAX),
            (0.0, 1e-300),
        ] {
            let settled = Axis::linear("q").range(from, to).settle([].into_iter(), 5);
            assert!(
                matches!(settled, Err(FigureError::Range { .. })),
                "{from} {to}"
            );
        }
        let empty = Axis::linear("q").settle([f64::NAN].into_iter(), 5);
        assert!(matches!(empty, Err(FigureError::NoData { .. })));
    }

    #[test]
    fn a_single_value_gets_room() {
        for axis in [
            Axis::linear("q"),
            Axis::log("q"),
            Axis::linear("q").ticks([(3.0, "3")]),
        ] {
            for other in [3.0, 3.0 + 1e-12] {
                let scale = axis.settle([3.0, other].into_iter(), 5).unwrap();
                assert!(scale.from < 3.0 && scale.to > 3.0);
                assert!((1..20).contains(&scale.ticks.len()));
            }
        }
        assert!(Axis::linear("q").settle([0.0].into_iter(), 5).is_ok());
    }

    #[test]
    fn decades_are_equally_wide() {
        let mut scale = Axis::log("p")
            .range(1e-2, 1e2)
            .settle([].into_iter(), 5)
            .unwrap();
        scale.pixels = (100.0, 500.0);
        for (value, pixel) in [(1e-2, 100.0), (1e-1, 200.0), (1.0, 300.0), (1e2, 500.0)] {
            assert!((scale.at(value) - pixel).abs() < 1e-9);
        }
        assert!(scale.at(f64::NAN).is_nan());
        assert_eq!(scale.at(f64::MAX), 300.0 + 100.0 * libm::log10(f64::MAX));
    }
}
