//! Where an axis has its ticks: at multiples of 1, 2 or 5 times a power of ten.

/// In steps: an end this close to a tick counts as on it.
const SLACK: f64 = 1e-6;

#[derive(Debug, Clone, PartialEq)]
pub(super) struct Tick {
    pub at: f64,
    /// Empty for a small tick between others.
    pub label: String,
}

fn decimal(mantissa: i64, exponent: i32) -> f64 {
    format!("{mantissa}e{exponent}").parse().unwrap_or(f64::NAN)
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Step(i64, i32);

impl Step {
    /// Into about `about` parts, rather fewer, of `span` > 0.
    pub(super) fn dividing(span: f64, about: usize) -> Self {
        let raw = span / about.max(1) as f64;
        let exponent = libm::floor(libm::log10(raw)) as i32;
        [
            (1, exponent),
            (2, exponent),
            (5, exponent),
            (1, exponent + 1),
            (2, exponent + 1),
        ]
        .into_iter()
        .find(|&(m, e)| decimal(m, e) >= 0.999 * raw)
        .map_or(Step(5, exponent + 1), |(m, e)| Step(m, e))
    }

    fn size(self) -> f64 {
        decimal(self.0, self.1)
    }

    fn times(self, k: i64) -> f64 {
        decimal(k.saturating_mul(self.0), self.1)
    }

    /// The first multiple not below and the last not above.
    fn inside(self, from: f64, to: f64) -> (i64, i64) {
        let step = self.size();
        (
            libm::ceil(from / step - SLACK) as i64,
            libm::floor(to / step + SLACK) as i64,
        )
    }

    pub(super) fn around(self, low: f64, high: f64) -> (f64, f64) {
        let step = self.size();
        (
            self.times(libm::floor(low / step + SLACK) as i64),
            self.times(libm::ceil(high / step - SLACK) as i64),
        )
    }
}

pub(super) fn linear(from: f64, to: f64, step: Step) -> Vec<Tick> {
    let (first, last) = step.inside(from, to);
    let size = libm::floor(libm::log10(from.abs().max(to.abs()))) as i32;
    (first..=last)
        .map(|k| Tick {
            at: step.times(k),
            label: written(k.saturating_mul(step.0), step.1, size),
        })
        .collect()
}

/// On an axis whose largest number is of the order `10^size`.
fn written(mantissa: i64, exponent: i32, size: i32) -> String {
    if mantissa == 0 {
        return "0".into();
    }
    let plain = (-3..5).contains(&size);
    let shift = if plain { 0 } else { size };
    let decimals = (shift - exponent).max(0) as usize;
    let number = format!("{:.decimals$}", decimal(mantissa, exponent - shift)).replace('-', "−");
    if plain {
        number
    } else {
        format!("{number}×{}", power(size))
    }
}

fn power(exponent: i32) -> String {
    match exponent {
        0 => "1".into(),
        1 => "10".into(),
        n => format!("10^{{{}}}", n.to_string().replace('-', "−")),
    }
}

pub(super) fn log(from: f64, to: f64, about: usize) -> Vec<Tick> {
    let (low, high) = (libm::log10(from), libm::log10(to));
    let (first, last) = (
        libm::ceil(low - 1e-9) as i32,
        libm::floor(high + 1e-9) as i32,
    );
    if last - first >= 2 {
        let stride = 1 + (last - first) / about.max(1) as i32;
        let decades = (first - 1..=last).flat_map(|n| {
            let most = if stride == 1 && last - first <= 5 {
                9
            } else {
                1
            };
            std::iter::once((1, n)).chain((2..=most).map(move |m| (m, n)))
        });
        let unlabelled = last - first <= 20;
        return decades
            .map(|(m, n)| Tick {
                at: decimal(m, n),
                label: if m == 1 && n.rem_euclid(stride) == 0 {
                    power(n)
                } else {
                    String::new()
                },
            })
            .filter(|tick| tick.at >= from * (1.0 - 1e-9) && tick.at <= to * (1.0 + 1e-9))
            .filter(|tick| unlabelled || !tick.label.is_empty())
            .collect();
    }
    let coarse: Vec<Tick> = (first - 1..=last)
        .flat_map(|n| [1, 2, 5].map(|m| (m, n)))
        .map(|(m, n)| Tick {
            at: decimal(m, n),
            label: written(m, n, n),
        })
        .filter(|tick| tick.at >= from * (1.0 - 1e-9) && tick.at <= to * (1.0 + 1e-9))
        .collect();
    if coarse.len() >= 3 {
        coarse
    } else {
        linear(from, to, Step::dividing(to - from, about.min(4)))
    }
}

/// Ends at 1, 2 or 5 times a power of ten, at powers of ten alone if the interval is wider than a hundred.
pub(super) fn around_log(low: f64, high: f64) -> (f64, f64) {
    let mantissas: &[i64] = if high / low > 100.0 { &[1] } else { &[1, 2, 5] };
    let near = |x: f64| {
        let n = libm::floor(libm::log10(x)) as i32;
        let around = (n - 1..=n + 2).flat_map(|n| mantissas.iter().map(move |&m| decimal(m, n)));
        around.collect::<Vec<_>>()
    };
    let below = near(low)
        .into_iter()
        .rfind(|&x| x <= low * (1.0 + 1e-9))
        .unwrap_or(low);
    let above = near(high)
        .into_iter()
        .find(|&x| x >= high * (1.0 - 1e-9))
        .unwrap_or(high);
    (below, above)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn labels(ticks: &[Tick]) -> Vec<&str> {
        ticks
            .iter()
            .map(|tick| tick.label.as_str())
            .filter(|label| !label.is_empty())
            .collect()
    }

    #[test]
    fn labels_are_what_one_would_write() {
        assert_eq!(
            labels(&linear(-1.0, 1.0, Step::dividing(1.0 + 1.0, 4))),
            ["−1.0", "−0.5", "0", "0.5", "1.0"]
        );
        assert_eq!(
            labels(&linear(0.0, 7.0, Step::dividing(7.0 - 0.0, 8))),
            ["0", "1", "2", "3", "4", "5", "6", "7"]
        );
        assert_eq!(
            labels(&linear(0.0, 3e-9, Step::dividing(3e-9 - 0.0, 3))),
            ["0", "1×10^{−9}", "2×10^{−9}", "3×10^{−9}"]
        );
        assert_eq!(
            labels(&log(0.01, 100.0, 6)),
            ["10^{−2}", "10^{−1}", "1", "10", "10^{2}"]
        );
        assert_eq!(labels(&log(1.0, 10.0, 6)), ["1", "2", "5", "10"]);
        assert_eq!(labels(&log(1e-300, 1.0, 6)).len(), 6);
    }

    #[test]
    fn a_narrow_logarithmic_axis_still_has_ticks() {
        assert!(log(1.0, 1.01, 6).len() >= 3);
        assert!(log(0.9, 11.0, 6).len() >= 3);
    }

    proptest! {
        #[test]
        fn linear_ticks_cover_the_data(a in -1e6f64..1e6, size in -8f64..8.0, about in 2usize..9) {
            let b = a + libm::pow(10.0, size).max(1e-9 * a.abs());
            let step = Step::dividing(b - a, about);
            let (from, to) = step.around(a, b);
            let slack = 2e-6 * (b - a);
            prop_assert!(from <= a + slack && to >= b - slack);
            let ticks = linear(from, to, step);
            prop_assert_eq!(ticks.first().unwrap().at, from);
            prop_assert_eq!(ticks.last().unwrap().at, to);
            prop_assert!((2..=about + 3).contains(&ticks.len()), "{}", ticks.len());
        }

        #[test]
        fn logarithmic_ticks_cover_the_data(a in -200f64..200.0, decades in 0.1f64..80.0) {
            let (low, high) = (libm::pow(10.0, a), libm::pow(10.0, a + decades));
            let (from, to) = around_log(low, high);
            prop_assert!(from <= low * (1.0 + 1e-8) && to >= high * (1.0 - 1e-8));
            let ticks = log(from, to, 6);
            prop_assert!((2..=60).contains(&ticks.len()), "{}", ticks.len());
            prop_assert!(labels(&ticks).len() <= 12);
            prop_assert!(ticks.windows(2).all(|pair| pair[0].at < pair[1].at));
        }
    }
}
