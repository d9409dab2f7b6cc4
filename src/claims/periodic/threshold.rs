//! Trials of what is said of a threshold λ_c for any h: that there is one, and that there may be more.

use super::drives::{
    Named, biased, boundary, level_at_median, named, phase, steps_between, third_harmonic,
};
use super::prelude::*;

const SAMPLES: usize = 4096;
/// Half the distance of two samples, times the steepest slope of three harmonics of size 1, and some more.
const MARGIN: f64 = 3e-3;

#[derive(Debug, Clone, Copy)]
pub(crate) struct Bounds {
    /// No rest for 0 < λ₀ < low: |h| > λ₀ wherever |H − c| ≤ πλ₀.
    pub low: f64,
    /// Rest for high < λ₀ < 1: the mean of |h|.
    pub high: f64,
}

/// Those of [`crate::corrections::periodic`], from samples, each moved to the safe side by more than h or H/π
/// changes between two samples.
pub(crate) fn bounds(drive: &Drive) -> Bounds {
    let places = (0..SAMPLES).map(|k| TAU * (k as f64 + 0.5) / SAMPLES as f64);
    let samples: Vec<[f64; 2]> = places
        .map(|phi| [drive.h(phi).abs(), drive.shape().antiderivative(phi)])
        .collect();
    let mean = samples.iter().map(|[size, _]| size).sum::<f64>() / SAMPLES as f64;
    let mut levels: Vec<f64> = samples.iter().map(|[_, level]| *level).collect();
    levels.sort_by(f64::total_cmp);
    let median = 0.5 * (levels[SAMPLES / 2 - 1] + levels[SAMPLES / 2]);
    // The criterion fails at λ₀ if some sample has |h| ≤ λ₀ and |H − c| ≤ πλ₀.
    let fails_from = |[size, level]: &[f64; 2]| size.max((level - median).abs() / PI);
    let low = samples.iter().map(fails_from).fold(f64::INFINITY, f64::min);
    Bounds {
        low: (low - MARGIN).max(0.0),
        high: mean + MARGIN,
    }
}

pub(crate) fn mean_size(drive: &Drive) -> f64 {
    bounds(drive).high - MARGIN
}

/// Under much friction or little: whether rests are stated, and whether they are there.
fn rests(name: &str, drive: &Drive, lambda: f64, much: bool) -> Result<Pair, Failure> {
    let found = phase(drive, lambda)?;
    Ok(Pair {
        at: format!("{name}: λ₀ = {lambda:.6}"),
        stated: printed::s23_rests()[usize::from(much)],
        // Neither rests nor none: at rest for ever, or never periodic.
        found: match found {
            Phase::Rests(rests) => is(rests > 0),
            Phase::Still => 2.0,
            Phase::Drifts => -1.0,
        },
        scale: 1.0,
    })
}

/// The named ones that are generic and without a mean, and random ones.
fn admitted() -> Result<Vec<Named>, DriveError> {
    let mut points = Points::here();
    let mut list: Vec<Named> = named()?.into_iter().filter(|d| d.generic).collect();
    for _ in 0..24 {
        list.push(Named {
            name: "three harmonics at random",
            drive: Harmonics::random(&mut points)?.drive()?,
            generic: true,
        });
    }
    Ok(list)
}

/// λ_c of a drive whose motion without rest has two zeros: they are half a period apart, at a and a + π with
/// ∫ h = πλ₀ between them, and the rest appears where the weaker of h(a) and −h(a + π) has sunk to λ₀.
fn two_zero_threshold(shape: &Harmonics) -> Result<f64, Failure> {
    let mean = |a: f64| -> Result<f64, Failure> {
        Ok(integral_within(|x| shape.h(x), a, a + PI, 1e-13)?.value / PI)
    };
    let excess =
        |a: f64| -> Result<f64, Failure> { Ok(mean(a)? - shape.h(a).min(-shape.h(a + PI))) };
    // From λ₀ = 0, where the half-period mean vanishes with h(a) > 0 > h(a + π), back to where they meet.
    let step = TAU / 64.0;
    let mut start = None;
    for k in 0..64 {
        let a = step * f64::from(k);
        if mean(a)? > 0.0 && mean(a + step)? <= 0.0 {
            start = Some(a + step);
        }
    }
    let mut a = start.ok_or("no zero of the half-period mean")?;
    for _ in 0..64 {
        if excess(a - step)? > 0.0 {
            let at = root(|a| excess(a).unwrap_or(f64::NAN), a - step, a)?;
            return mean(at);
        }
        a -= step;
    }
    Err("the two levels do not meet".into())
}

fn drifting(drive: &Drive, lambda: f64) -> Result<Pair, Failure> {
    let pair = rests("sine with a mean", drive, lambda, false)?;
    Ok(Pair {
        stated: -1.0,
        ..pair
    })
}

pub(crate) fn two_valued() -> Evidence {
    let trial = Trial::census(
        Remark,
        Compared::constant(
            "the expected 0",
            r"whether the motion has rests (1 if so), for steps between 1 and $-1$ and $\lambda_0$ just below 1,",
        ),
    );
    trial.drawn(0..60, |_, points| {
        let (x, y) = (points.uniform(0.2, 2.9), points.uniform(0.2, 2.9));
        let drive = steps_between(x, y)?;
        let lambda = 1.0 - points.log_uniform(1e-6, 1e-1);
        rests("steps between 1 and −1", &drive, lambda, false)
    })
}

/// H level at its median: rests however small the friction.
///
/// The antiderivative of sin φ + sin(2φ + p) has the same value at π/2, at 3π/2 and, for 0 < p < π/2, at its
/// minimum π − p between them. With little friction w rises through 0 at π/2 − πλ₀/2; at π − p it would then be
/// λ₀ (p − (π/2) sin p) < 0, all before scaling.
pub(crate) fn level() -> Evidence {
    let trial = Trial::census(
        Remark,
        Compared::constant(
            "the expected 1",
            r"whether the motion has rests (1 if so), for $\sin\phi+\sin(2\phi+p)$, scaled, $0<p<\pi/2$, and small $\lambda_0$,",
        ),
    );
    trial.drawn(0..60, |_, points| {
        let p = points.uniform(0.1, 1.5);
        let lambda = points.log_uniform(1e-5, 1e-2);
        let name = format!("p = {p:.6}");
        rests(&name, &level_at_median(p)?, lambda, true)
    })
}

attempts![
    both_ends = {
        let trial = Trial::census(
            Printed,
            Compared::constant(
                r"0 where $\lvert h\rvert>\lambda_0$ wherever $\lvert H-c\rvert\le\pi\lambda_0$, and 1 where $\langle\lvert h\rvert\rangle<\lambda_0<1$",
                "whether the motion has rests (1 if so)",
            ),
        );
        trial.pairs(parts(admitted()), |one| {
            let Named { name, drive, .. } = one?;
            let Bounds { low, high } = bounds(&drive);
            let below = [0.5, 0.99, 0.1].map(|share| (low * share, false));
            let above = [0.5, 0.01, 0.999].map(|share| (high + (1.0 - high) * share, true));
            let cases = below.into_iter().zip(above).flat_map(|(a, b)| [a, b]);
            // A random drive may come so near to a level median that the lower bound is lost in the sampling.
            let cases = cases.filter(|(lambda, _)| *lambda > 0.0);
            cases
                .map(|(lambda, much)| rests(name, &drive, lambda, much))
                .collect()
        })
    },
    two_zeros_root = {
        let trial = Trial::by(
            Root,
            Printed,
            [
                r"the $\lambda_0$ at which $\int h=\pi\lambda_0$ between zeros half a period apart and $h$ is $\lambda_0$ at one",
                r"the $\lambda_0$ at which rests appear in the motion",
            ],
            THRESHOLD,
        );
        trial.drawn(0..20, |_, points| {
            let (a, p) = (points.uniform(0.0, 0.3), points.uniform(0.0, TAU));
            let (b, r) = (points.uniform(0.0, 0.08), points.uniform(0.0, TAU));
            let shape = Harmonics::new(0.0, &[(1, 1.0, 0.0), (2, a, p), (3, b, r)])?;
            let drive = shape.drive()?;
            let Bounds { low, high } = bounds(&drive);
            Ok(Pair::plain(
                format!("sin φ + {a:.6} sin(2φ + {p:.6}) + {b:.6} sin(3φ + {r:.6}), scaled"),
                two_zero_threshold(&shape)?,
                boundary(low, high, |lambda| {
                    Ok::<_, DriveError>(phase(&drive, lambda)?.rests())
                })?,
            ))
        })
    },
    again_and_again = {
        let trial = Trial::census(
            Printed,
            Compared::constant(
                "the stated 3",
                r"the number of times that rests appear or disappear for $\sin\phi+a\sin3\phi$ as $\lambda_0$ grows from 0 to 1",
            ),
        );
        let amplitudes = (0..20).map(|k| 1.4 + 0.15 * (f64::from(k) + 0.5) / 20.0);
        trial.over(Points::here().grid(amplitudes), |a| {
            let drive = third_harmonic(a)?;
            let seen: Result<Vec<bool>, _> = (1..200)
                .map(|k| Ok::<_, DriveError>(phase(&drive, 0.005 * f64::from(k))?.rests()))
                .collect();
            let changes = seen?.windows(2).filter(|w| w[0] != w[1]).count();
            Ok(Pair::plain(format!("a = {a:.6}"), 3.0, changes as f64))
        })
    },
    with_mean = Trial::census(
        Printed,
        Compared::constant(
            r"0 below the mean of $h$, and 1 where $\langle\lvert h\rvert\rangle<\lambda_0<1$",
            "whether the motion has rests (1 if so; one that drifts has none)",
        )
        .over("sines with a mean"),
    )
    .drawn(0..60, |i, points| {
        let drive = biased(points.sign() * points.uniform(0.02, 0.9))?;
        let (share, large) = (points.uniform(0.001, 0.999), i % 2 == 0);
        let high = bounds(&drive).high;
        let lambda = match large {
            true => high + (1.0 - high) * share,
            false => drive.mean().abs() * share,
        };
        let pair = rests("sine with a mean", &drive, lambda, large)?;
        Ok(Pair {
            // What drifts has no rest.
            found: pair.found.max(0.0),
            ..pair
        })
    }),
    with_mean_drift = {
        let trial = Trial::census(
            Remark,
            Compared::constant(
                "the expected $-1$, for a drift",
                r"0 or 1 for a periodic motion without or with rests, $-1$ for one that drifts, at $\lambda_0$ below the mean of $h$,",
            ),
        );
        trial.drawn(0..60, |_, points| {
            let drive = biased(points.sign() * points.uniform(0.02, 0.9))?;
            let lambda = drive.mean().abs() * points.uniform(0.001, 0.999);
            drifting(&drive, lambda)
        })
    },
    with_mean_close = {
        let trial = Trial::census(
            Remark,
            Compared::constant(
                "the expected $-1$, for a drift",
                r"0 or 1 for a periodic motion without or with rests, $-1$ for one that drifts, at $\lambda_0$ a part in $10^3$ or less below the mean of $h$,",
            ),
        );
        trial.drawn(0..24, |_, points| {
            let drive = biased(points.sign() * points.uniform(0.02, 0.9))?;
            let lambda = drive.mean().abs() * (1.0 - points.log_uniform(1e-5, 1e-3));
            drifting(&drive, lambda)
        })
    },
    two_valued,
    level
];

#[cfg(test)]
mod tests {
    use super::*;

    /// For the sine: tan φ = 2/π, so that λ_c = 1/√(1 + (π/2)²).
    #[test]
    fn the_threshold_of_the_sine_is_found() {
        let sine = Harmonics::new(0.0, &[(1, 1.0, 0.0)]).unwrap();
        let expected = 2.0 / libm::sqrt(4.0 + PI * PI);
        assert!((two_zero_threshold(&sine).unwrap() - expected).abs() < 1e-12);
    }
}
