//! fig-6: one motion for each region, built from the printed rates in the printed order, and simulated.

use super::prelude::*;
use super::simulated::own_digits;

/// (q, λ₀), one in each of the regions I to V, where the motion stays within the mark.
pub(crate) const PANELS: [(f64, f64); 5] = [
    (1.2, 0.35),
    (2.0, 0.38),
    (1.3, 0.6),
    (2.0, 0.55),
    (2.0, 1.1),
];

/// The mark that the panels' vertical axis bears.
pub(crate) const TOP: f64 = 1.0;

struct Stretch {
    sign: f64,
    start: f64,
    end: f64,
}

struct Rates {
    q: f64,
    lambda0: f64,
}

impl Rates {
    fn of(&self, sign: f64, phi: f64) -> f64 {
        match sign {
            1.0 => printed::eq51_rate(self.lambda0, phi),
            -1.0 => printed::eq52_rate(self.q, self.lambda0, phi),
            0.0 => 0.0,
            // No sign at all.
            _ => f64::NAN,
        }
    }

    /// 𝔴 at `phi`, from rest at `start`.
    fn w(&self, sign: f64, start: f64, phi: f64) -> Result<f64, Failure> {
        Ok(integral_within(|x| self.of(sign, x), start, phi, 1e-13)?.value)
    }

    /// The first zero of a motion from rest at `start` after its extremum at `turn`.
    fn stop(&self, sign: f64, start: f64, turn: f64) -> Result<f64, Failure> {
        // A failure of the quadrature inside becomes NaN, which the root-finder reports.
        let w = |phi| self.w(sign, start, phi).unwrap_or(f64::NAN);
        Ok(root(w, turn.max(start), start + TAU)?)
    }

    fn period(&self, signs: &[f64]) -> Result<Vec<Stretch>, Failure> {
        let plus = libm::asin(self.lambda0.min(1.0));
        let minus = libm::asin((self.q * self.lambda0).min(1.0));
        let mut list: Vec<Stretch> = Vec::new();
        let mut phi = if signs.contains(&0.0) {
            plus
        } else {
            self.begin_without_rest()?
        };
        let first = phi;
        for (i, sign) in signs.iter().copied().enumerate() {
            let end = match sign {
                1.0 => self.stop(sign, phi, PI - plus)?,
                -1.0 => self.stop(sign, phi, TAU - minus)?,
                _ if signs.get(i + 1) == Some(&-1.0) => PI + minus,
                _ => first + TAU,
            };
            list.push(Stretch {
                sign,
                start: phi,
                end,
            });
            phi = end;
        }
        Ok(list)
    }

    /// Without rest, forward motion must begin so that the backward motion ends a period later.
    fn begin_without_rest(&self) -> Result<f64, Failure> {
        let plus = libm::asin(self.lambda0);
        let minus = libm::asin(self.q * self.lambda0);
        let late = |start: f64| -> Result<f64, Failure> {
            let turn = self.stop(1.0, start, PI - plus)?;
            Ok(self.stop(-1.0, turn, TAU - minus)? - start - TAU)
        };
        let late = |start| late(start).unwrap_or(f64::NAN);
        Ok(root(late, plus, PI - plus - 0.1)?)
    }
}

pub(crate) fn quadrature() -> Evidence {
    let trial = Trial::quadrature(
        Printed,
        [
            r"$\mathfrak w(\phi)$ in each panel, made of the integrals of (51) and (52) over $\phi$ and of rests, in the order of the list,",
            "the simulated motion over two periods",
        ],
    );
    let panels = PANELS.into_iter().zip(printed::signs());
    let periods: Vec<_> = panels
        .map(|((q, lambda0), signs)| Rates { q, lambda0 }.period(&signs))
        .collect();
    let phases = |panel| (0..=40).map(move |k| (panel, 4.0 * PI * f64::from(k) / 40.0));
    trial.over((0..PANELS.len()).flat_map(phases), |(panel, phi)| {
        let (q, lambda0) = PANELS[panel];
        let w = |period: &[Stretch]| {
            let begin = period.first().map_or(0.0, |stretch| stretch.start);
            let reduced = begin + (phi - begin).rem_euclid(TAU);
            let here = period.iter().find(|stretch| reduced < stretch.end);
            let rates = Rates { q, lambda0 };
            here.map_or(Ok(0.0), |s| rates.w(s.sign, s.start, reduced))
        };
        Ok(Pair {
            at: format!("q = {q}, λ₀ = {lambda0}, φ = {phi:.6}"),
            // Words and rates that make no period have no 𝔴.
            stated: periods[panel]
                .as_ref()
                .map_or(f64::NAN, |period| w(period).unwrap_or(f64::NAN)),
            found: motion(panel, START)?.w(phi),
            scale: 1.0,
        })
    })
}

pub(crate) fn motion(panel: usize, start: DriveState) -> Result<Attractor<'static>, Failure> {
    let (q, lambda0) = PANELS[panel];
    attractor_from(start, Friction::new(lambda0, q * lambda0)?)
}

pub(crate) fn census() -> Evidence {
    let trial = Trial::census(
        Printed,
        Compared::many(
            r"the order of slips and rests in a period by the words of the panel's region (3 for a forward slip, 2 for a rest, 1 for a backward slip), and $\lvert\mathfrak w\rvert$, but not more than 1,",
            r"those of the simulated motion, and the largest $\lvert\mathfrak w\rvert$, from eight starts",
        ),
    );
    let mut points = Points::here();
    let words = listed_digits();
    let mut cases = Vec::new();
    for panel in 0..PANELS.len() {
        for _ in 0..8 {
            let start = DriveState {
                phi: points.uniform(0.0, TAU),
                w: points.uniform(-2.0, 2.0),
            };
            cases.extend([(panel, start, true), (panel, start, false)]);
        }
    }
    trial.over(cases, |(panel, start, order)| {
        let motion = motion(panel, start)?;
        let (q, lambda0) = PANELS[panel];
        let at = format!(
            "q = {q}, λ₀ = {lambda0}, start φ = {:.6}, 𝔴 = {:.6}",
            start.phi, start.w
        );
        let (stated, found) = if order {
            (words[panel], own_digits(motion.intervals()))
        } else {
            let largest = motion.largest().w.abs();
            (largest.min(TOP), largest)
        };
        Ok(Pair::plain(at, stated, found))
    })
}

attempts![quadrature, census];

#[cfg(test)]
mod tests {
    use super::*;

    /// One interval begins where the other ends, and the last one ends a period after the begin of the first.
    #[test]
    fn the_intervals_fill_a_period() {
        for ((q, lambda0), order) in PANELS.into_iter().zip(printed::signs()) {
            let list = Rates { q, lambda0 }.period(&order).unwrap();
            let signs: Vec<f64> = list.iter().map(|stretch| stretch.sign).collect();
            assert_eq!(signs, order);
            assert!(list.windows(2).all(|pair| pair[0].end == pair[1].start));
            assert!(list.iter().all(|stretch| stretch.start < stretch.end));
            let last = list.last().unwrap();
            assert!((last.end - list[0].start - TAU).abs() < 1e-12, "{order:?}");
        }
    }
}
