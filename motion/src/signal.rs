//! Functions of time that know their own Taylor series: what accelerations are made of.

use crate::numerics::{
    series,
    taylor::{Coefficients, TERMS},
};

/// A function of the time t, dimensionless or with the unit of its constants.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub enum Signal {
    /// Σ cₖ tᵏ; a constant is `Polynomial(vec![c])`.
    Polynomial(Vec<f64>),
    /// exp(rate · t).
    Exponential {
        /// Growth per unit of time, negative for a decay.
        rate: f64,
    },
    /// sin(frequency · t + phase).
    Sine {
        /// Angular frequency.
        frequency: f64,
        /// Angle at t = 0, in radians.
        phase: f64,
    },
    /// exp(−((t − centre)/width)²), and zero beyond 12 widths, where it is below 10⁻⁶².
    Gaussian {
        /// Time of the maximum.
        centre: f64,
        /// Time in which it falls to 1/e; positive.
        width: f64,
    },
    /// (1 + t/scale)^exponent, for t/scale > −1.
    Power {
        /// Unit of time.
        scale: f64,
        /// The exponent, of either sign.
        exponent: f64,
    },
    /// +1 on [start, start + half), −1 on the next half period, and so on for all times.
    Square {
        /// A time at which it jumps to +1.
        start: f64,
        /// Half a period; positive.
        half: f64,
    },
    /// 1 on [from, to), 0 elsewhere.
    Pulse {
        /// When it begins.
        from: f64,
        /// When it ends.
        to: f64,
    },
    /// The sum of signals.
    Sum(Vec<Signal>),
    /// The product of signals.
    Product(Vec<Signal>),
}

/// In widths.
const CUT: f64 = 12.0;

impl Signal {
    /// The same value at all times.
    pub fn constant(value: f64) -> Self {
        Self::Polynomial(vec![value])
    }

    /// This signal times a number.
    pub fn times(self, factor: f64) -> Self {
        Self::Product(vec![Self::constant(factor), self])
    }

    /// Taylor coefficients about `t`, from the right where the signal jumps.
    pub fn coefficients(&self, t: f64) -> Coefficients {
        let mut c = [0.0; TERMS];
        match self {
            Self::Polynomial(given) => {
                for a in given.iter().rev() {
                    for k in (1..given.len().min(TERMS)).rev() {
                        c[k] = c[k] * t + c[k - 1];
                    }
                    c[0] = c[0] * t + a;
                }
            }
            Self::Exponential { rate } => {
                let u = [rate * t, *rate];
                (0..TERMS).for_each(|k| c[k] = series::exp(&u, &c, k));
            }
            Self::Sine { frequency, phase } => {
                let u = [frequency * t + phase, *frequency];
                let mut cosine = [0.0; TERMS];
                (0..TERMS).for_each(|k| (c[k], cosine[k]) = series::sin_cos(&u, &c, &cosine, k));
            }
            Self::Gaussian { centre, width } => {
                if t >= centre - CUT * width && t < centre + CUT * width {
                    let z = (t - centre) / width;
                    let u = [-z * z, -2.0 * z / width, -1.0 / (width * width)];
                    (0..TERMS).for_each(|k| c[k] = series::exp(&u, &c, k));
                }
            }
            Self::Power { scale, exponent } => {
                let u = [1.0 + t / scale, 1.0 / scale];
                (0..TERMS).for_each(|k| c[k] = series::power(&u, *exponent, &c, k));
            }
            Self::Square { start, half } => {
                let odd = edge(t, *start, *half).rem_euclid(2.0) != 0.0;
                c[0] = if odd { -1.0 } else { 1.0 };
            }
            Self::Pulse { from, to } => c[0] = if t >= *from && t < *to { 1.0 } else { 0.0 },
            Self::Sum(parts) => {
                for part in parts {
                    let p = part.coefficients(t);
                    (0..TERMS).for_each(|k| c[k] += p[k]);
                }
            }
            Self::Product(parts) => {
                c[0] = 1.0;
                for part in parts {
                    c = multiplied(&c, &part.coefficients(t));
                }
            }
        }
        c
    }

    /// The next jump after `t`, if there is one.
    pub fn next_break(&self, t: f64) -> Option<f64> {
        let earliest = |times: &[f64]| times.iter().copied().filter(|b| *b > t).reduce(f64::min);
        match self {
            Self::Square { start, half } => {
                earliest(&[start + (edge(t, *start, *half) + 1.0) * half])
            }
            Self::Pulse { from, to } => earliest(&[*from, *to]),
            Self::Gaussian { centre, width } => {
                earliest(&[centre - CUT * width, centre + CUT * width])
            }
            Self::Sum(parts) | Self::Product(parts) => parts
                .iter()
                .filter_map(|part| part.next_break(t))
                .reduce(f64::min),
            _ => None,
        }
    }
}

fn multiplied(a: &Coefficients, b: &Coefficients) -> Coefficients {
    let terms = |c: &Coefficients| c.iter().rposition(|c| *c != 0.0).map_or(0, |k| k + 1);
    let (few, many) = if terms(a) < terms(b) { (a, b) } else { (b, a) };
    let mut product = [0.0; TERMS];
    for (j, factor) in few[..terms(few)].iter().enumerate() {
        for (sum, c) in product[j..].iter_mut().zip(many) {
            *sum += factor * c;
        }
    }
    product
}

/// The n with start + n·half ≤ t < start + (n + 1)·half, as those sums are rounded.
fn edge(t: f64, start: f64, half: f64) -> f64 {
    let n = libm::floor((t - start) / half);
    if start + (n + 1.0) * half <= t {
        n + 1.0
    } else if start + n * half > t {
        n - 1.0
    } else {
        n
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// eᵗ · e²ᵗ = e³ᵗ, to the last order.
    #[test]
    fn products_have_all_orders() {
        let product = [1.0, 2.0].map(|rate| Signal::Exponential { rate });
        let product = Signal::Product(product.to_vec()).coefficients(0.2);
        let whole = Signal::Exponential { rate: 3.0 }.coefficients(0.2);
        for (found, right) in product.iter().zip(whole) {
            assert!((found - right).abs() < 1e-13 * right, "{found} {right}");
        }
    }

    #[test]
    fn series_continue_to_the_value_nearby() {
        let signals = [
            Signal::Polynomial(vec![1.0, -2.0, 0.5, 0.25]),
            Signal::Exponential { rate: -0.7 },
            Signal::Sine {
                frequency: 1.3,
                phase: 0.4,
            },
            Signal::Gaussian {
                centre: 0.5,
                width: 1.7,
            },
            Signal::Power {
                scale: 2.0,
                exponent: -2.0,
            },
            Signal::Product(vec![
                Signal::Sine {
                    frequency: 2.0,
                    phase: 0.0,
                },
                Signal::Sum(vec![
                    Signal::constant(2.0),
                    Signal::Exponential { rate: 0.3 },
                ]),
            ]),
        ];
        for signal in signals {
            let from_here = series::value(&signal.coefficients(0.8), &0.25);
            let there = signal.coefficients(1.05)[0];
            assert!(
                (from_here - there).abs() < 1e-14,
                "{signal:?} {from_here} {there}"
            );
        }
        assert!(
            (Signal::Gaussian {
                centre: 1.0,
                width: 2.0
            }
            .coefficients(3.0)[0]
                - libm::exp(-1.0))
            .abs()
                < 1e-16
        );
        assert_eq!(
            Signal::Power {
                scale: 2.0,
                exponent: -2.0
            }
            .coefficients(2.0)[0],
            0.25
        );
        assert_eq!(
            Signal::Polynomial(vec![1.0, -2.0, 0.5]).coefficients(2.0)[..4],
            [-1.0, 0.0, 0.5, 0.0]
        );
    }

    #[test]
    fn a_bump_is_cut_off_where_it_is_nothing() {
        let bump = Signal::Gaussian {
            centre: 3.0,
            width: 0.5,
        };
        for (t, expected) in [
            (-2.99, 144.0 * (5.99 / 6.0) * (5.99 / 6.0)),
            (3.5, 1.0),
            (8.99, 144.0 * (5.99 / 6.0) * (5.99 / 6.0)),
        ] {
            let ratio = libm::log(bump.coefficients(t)[0]) / -expected;
            assert!((ratio - 1.0).abs() < 1e-12, "{t}: {ratio}");
        }
        for t in [-3.01, 9.0, 9.01] {
            assert_eq!(bump.coefficients(t), [0.0; TERMS], "{t}");
        }
        let breaks = [-9.0, -3.0, 3.0, 9.0].map(|t| bump.next_break(t));
        assert_eq!(breaks, [Some(-3.0), Some(9.0), Some(9.0), None]);
    }

    #[test]
    fn breaks_are_met_one_by_one() {
        let square = Signal::Square {
            start: 0.1,
            half: 0.1,
        };
        let mut t = 0.1;
        for i in 0..1000 {
            let expected = if i % 2 == 0 { 1.0 } else { -1.0 };
            assert_eq!(square.coefficients(t)[0], expected, "{t}");
            let next = square.next_break(t).unwrap();
            assert!((next - t - 0.1).abs() < 1e-12, "{t} {next}");
            assert_eq!(square.coefficients(0.5 * (t + next))[0], expected);
            t = next;
        }
        let pulse = Signal::Pulse { from: 1.0, to: 2.0 };
        assert_eq!(
            [0.0, 1.0, 1.5, 2.0].map(|t| pulse.next_break(t)),
            [Some(1.0), Some(2.0), Some(2.0), None]
        );
        assert_eq!(
            [0.0, 1.0, 1.5, 2.0].map(|t| pulse.coefficients(t)[0]),
            [0.0, 1.0, 1.0, 0.0]
        );
        let both = Signal::Sum(vec![pulse, Signal::constant(1.0).times(3.0), square]);
        assert_eq!(both.next_break(1.95), Some(2.0));
        assert_eq!(both.coefficients(1.95)[0], 1.0 + 3.0 + 1.0);
    }

    #[test]
    fn a_square_wave_has_been_there_before_it_starts() {
        let square = Signal::Square {
            start: 0.5,
            half: 1.0,
        };
        for (t, value, next) in [
            (-2.0, -1.0, -1.5),
            (-1.5, 1.0, -0.5),
            (-1.0, 1.0, -0.5),
            (0.0, -1.0, 0.5),
            (0.5, 1.0, 1.5),
        ] {
            assert_eq!(square.coefficients(t)[0], value, "{t}");
            assert_eq!(square.next_break(t), Some(next), "{t}");
        }
    }

    #[test]
    fn products_of_any_number_of_polynomials_are_polynomials() {
        let line = |a, b| Signal::Polynomial(vec![a, b]);
        // (1 + t)(2 − t)(3 + 2t) = 6 + 7t − t² − 2t³.
        let factors = [line(1.0, 1.0), line(2.0, -1.0), line(3.0, 2.0)];
        let expected: [&[f64]; 4] = [
            &[1.0],
            &[1.0, 1.0],
            &[2.0, 1.0, -1.0],
            &[6.0, 7.0, -1.0, -2.0],
        ];
        for (n, expected) in expected.into_iter().enumerate() {
            let found = Signal::Product(factors[..n].to_vec()).coefficients(0.0);
            assert_eq!(found[..expected.len()], *expected);
            assert!(found[expected.len()..].iter().all(|c| *c == 0.0));
        }
    }
}
