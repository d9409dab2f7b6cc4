//! Fates on both sides of a line that follows the boundary between rest and escape: cells along it are decided nearly up to it.

use super::{Judged, Law, judge};
use crate::scalar::Scalar;
use trialbook::certified::{flow::Tilted, interval::Interval, jet::Jet};

/// Starts with one A, a range of ψ, and α from 0 to a largest one.
#[derive(Debug, Clone, Copy)]
pub struct Strip {
    /// A, dimensionless.
    pub a: Interval,
    /// The ends of the range, in radians.
    pub psi: [f64; 2],
    /// At the ends of a line that is straight in between; positive, below `reach`.
    pub line: [f64; 2],
    /// The largest α.
    pub reach: f64,
}

/// As shares of the way from the line to the strip's end, up to where fates are proved.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Margins {
    /// Below the line b all come to rest with α ≤ (1 − `rest`) b.
    pub rest: f64,
    /// Above it all escape with α ≥ b + `escape` (reach − b).
    pub escape: f64,
}

/// Terms of a series, and how wide the last may be: it takes no more for cells that are not small.
const TERMS: usize = 10;
const ACCURACY: f64 = 1e-7;

const STEPS: usize = 400;

const WIDE: f64 = 1.0;

/// As a share of the way.
const NEAREST: f64 = 1e-12;

/// Of a layer's cell that begins farther out than `THICK`, and of the others.
const THICK: f64 = 1.0 / 16.0;
const HALVINGS: u32 = 12;
const HALVINGS_OF_THIN: u32 = 9;

#[derive(Debug, Clone, Copy, PartialEq)]
enum Side {
    Below,
    Above,
}

impl Margins {
    pub const NONE: Margins = Margins {
        rest: 1.0,
        escape: 1.0,
    };
}

impl Strip {
    /// What can be proved beyond what is `known` already, no nearer to the line than `aim` or 10⁻¹² of the way, by layers
    /// each half as far from it as the one before. At most 40 layers on a side, each of at most 4096 cells.
    pub fn margins(&self, known: Margins, aim: Margins) -> Margins {
        Margins {
            rest: self.margin(Side::Below, known.rest, aim.rest),
            escape: self.margin(Side::Above, known.escape, aim.escape),
        }
    }

    /// The area in (α, ψ) between what rests and what escapes.
    pub fn undecided(&self, margins: &Margins) -> f64 {
        let [from, to] = self.psi;
        let middle = 0.5 * (self.line[0] + self.line[1]);
        (to - from) * (margins.rest * middle + margins.escape * (self.reach - middle))
    }

    /// What is proved of a part of this strip, with a line of its own, where `known` is proved of the whole.
    pub fn inherited(&self, known: Margins, part: &Strip) -> Margins {
        // Along straight lines, where the one bound is within the other at the part's ends.
        let share = |side, known| {
            let proved = Interval::int(1) - Interval::point(known);
            let shares = part.psi.map(|psi| {
                let whole = self.height_at(psi, side);
                Interval::int(1) - proved * whole / part.height_at(psi, side)
            });
            shares[0].hi().max(shares[1].hi()).clamp(0.0, 1.0)
        };
        Margins {
            rest: share(Side::Below, known.rest),
            escape: share(Side::Above, known.escape),
        }
    }

    fn margin(&self, side: Side, known: f64, aim: f64) -> f64 {
        let psi = Interval::new(self.psi[0], self.psi[1]);
        let mut margin = known;
        while margin > aim.max(NEAREST) {
            let nearer = (0.5 * margin).max(aim);
            let halvings = match margin > THICK {
                true => HALVINGS,
                false => HALVINGS_OF_THIN,
            };
            if !self.all([Interval::new(nearer, margin), psi], side, halvings) {
                break;
            }
            margin = nearer;
        }
        margin
    }

    fn height_at(&self, psi: f64, side: Side) -> Interval {
        let line = self.line_at(number(psi)).value;
        match side {
            Side::Below => line,
            Side::Above => Interval::point(self.reach) - line,
        }
    }

    fn line_at(&self, psi: Jet<2>) -> Jet<2> {
        let [from, to] = self.psi.map(number);
        let [first, last] = self.line.map(number);
        first + (psi - from) * ((last - first) / (to - from))
    }

    fn height(&self, side: Side) -> f64 {
        match side {
            Side::Below => self.line[0].max(self.line[1]),
            Side::Above => self.reach - self.line[0].min(self.line[1]),
        }
    }

    /// By the cell as it is or by its parts.
    fn all(&self, cell: [Interval; 2], side: Side, halvings: u32) -> bool {
        if self.decided(cell, side) {
            return true;
        }
        if halvings == 0 {
            return false;
        }
        let [share, psi] = cell;
        let parts = if share.width() * self.height(side) > psi.width() {
            share.halves().map(|share| [share, psi])
        } else {
            psi.halves().map(|psi| [share, psi])
        };
        parts
            .into_iter()
            .all(|part| self.all(part, side, halvings - 1))
    }

    /// Of a cell: a range of shares of the way from the line, and one of ψ.
    fn decided(&self, cell: [Interval; 2], side: Side) -> bool {
        let variables = Jet::variables(&cell);
        let alpha = self.alpha(variables, side).value;
        if (self.a * alpha.exp()).below(Interval::int(1)) {
            // p + ρ < 1: rest, and where α = 0, too. No other fate is possible.
            return side == Side::Below;
        }
        let middle = cell.map(|x| Jet::constant(Interval::point(x.mid())));
        let mut set = Tilted::new(
            self.state(middle, side).map(|x| x.value),
            self.state(variables, side).map(|x| x.slope),
            cell.map(|x| (0.5 * x.width()).next_up()),
        );
        let mut h = 1.0;
        for _ in 0..STEPS {
            let hull = set.hull();
            match (judge(&hull), side) {
                (Some(Judged::Rest(_)), Side::Below) | (Some(Judged::Escape), Side::Above) => {
                    return true;
                }
                (None, _) if hull.iter().all(|x| x.width() < WIDE) => {}
                _ => return false,
            }
            match set.step::<_, TERMS>(&Law, &mut h, ACCURACY) {
                Ok(next) => set = next,
                Err(_) => return false,
            }
        }
        false
    }

    fn alpha(&self, [share, psi]: [Jet<2>; 2], side: Side) -> Jet<2> {
        let line = self.line_at(psi);
        match side {
            Side::Below => (number(1.0) - share) * line,
            Side::Above => line + share * (number(self.reach) - line),
        }
    }

    /// p, w and ζ.
    fn state(&self, variables: [Jet<2>; 2], side: Side) -> [Jet<2>; 3] {
        let (alpha, psi) = (self.alpha(variables, side), variables[1]);
        let a = Jet::constant(self.a);
        let (p, rho) = (a * alpha.sinh(), a * alpha.cosh());
        [p, number(1.0) - rho * psi.cos(), p - rho * psi.sin()]
    }
}

fn number(x: f64) -> Jet<2> {
    Jet::constant(Interval::point(x))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Near ψ = 0; the boundary at A = 0.5 is at α = 0.7547.
    fn strip(line: f64) -> Strip {
        Strip {
            a: Interval::decimal(0.5),
            psi: [-0.02, 0.02],
            line: [line; 2],
            reach: 1.0,
        }
    }

    const LINE: Margins = Margins {
        rest: 0.0,
        escape: 0.0,
    };

    #[test]
    fn fates_are_proved_nearly_up_to_the_boundary() {
        let strip = strip(0.7547);
        let margins = strip.margins(Margins::NONE, LINE);
        assert!(margins.rest < 1e-2 && margins.escape < 1e-2, "{margins:?}");
        let area = 0.04 * (margins.rest * 0.7547 + margins.escape * 0.2453);
        assert!((strip.undecided(&margins) - area).abs() < 1e-15);
    }

    #[test]
    fn beyond_the_boundary_nothing_is_proved() {
        // 0.05 too low, then too high: what lies between the line and the boundary stays open.
        let low = strip(0.7047).margins(Margins::NONE, LINE);
        assert!(low.escape * 0.2953 > 0.05 && low.rest < 1e-6, "{low:?}");
        let high = strip(0.8047).margins(Margins::NONE, LINE);
        assert!(high.rest * 0.8047 > 0.05 && high.escape < 1e-6, "{high:?}");
    }

    #[test]
    fn it_goes_no_nearer_than_it_has_to() {
        let aim = Margins {
            rest: 0.3,
            escape: 0.2,
        };
        assert_eq!(strip(0.7547).margins(Margins::NONE, aim), aim);
        assert_eq!(strip(0.7547).margins(LINE, aim), LINE);
    }

    #[test]
    fn a_part_inherits_no_more_than_is_proved_of_the_whole() {
        let whole = Strip {
            line: [0.5, 0.75],
            ..strip(0.0)
        };
        let known = Margins {
            rest: 0.25,
            escape: 0.5,
        };
        // Up to α = 0.375 at one end and 0.5625 at the other, and from 0.75 and 0.875 on; in the middle 0.46875 and 0.8125.
        let part = Strip {
            psi: [-0.02, 0.0],
            line: [0.5, 0.75],
            ..whole
        };
        let inherited = whole.inherited(known, &part);
        let rest = f64::max(1.0 - 0.375 / 0.5, 1.0 - 0.46875 / 0.75);
        let escape = f64::max(1.0 - 0.25 / 0.5, 1.0 - 0.1875 / 0.25);
        for (inherited, by_hand) in [(inherited.rest, rest), (inherited.escape, escape)] {
            assert!(
                inherited >= by_hand && inherited - by_hand < 1e-12,
                "{inherited} {by_hand}"
            );
        }
    }

    #[test]
    fn the_set_that_is_followed_holds_all_starts_of_its_cell() {
        let strip = Strip {
            a: Interval::decimal(0.5),
            psi: [0.25, 0.75],
            line: [0.5, 0.875],
            reach: 1.0,
        };
        let cell = [Interval::new(0.25, 0.5), Interval::new(0.25, 0.75)];
        for side in [Side::Below, Side::Above] {
            let slopes = strip.state(Jet::variables(&cell), side).map(|x| x.slope);
            let at = |share, psi| strip.state([share, psi].map(number), side).map(|x| x.value);
            let [share, psi] = cell.map(Interval::mid);
            let middle = at(share, psi);
            let parts = (0..=8).map(|k| f64::from(k) / 8.0);
            let pairs = parts
                .clone()
                .flat_map(|a| parts.clone().map(move |b| [a, b]));
            for place in pairs {
                let [to, toward] =
                    [0, 1].map(|i| cell[i].lo() + place[i] * (cell[i].hi() - cell[i].lo()));
                let there = at(to, toward);
                for i in 0..3 {
                    let [by_share, by_psi] = slopes[i];
                    let moved = middle[i]
                        + by_share * Interval::point(to - share)
                        + by_psi * Interval::point(toward - psi);
                    assert!(
                        there[i].within(moved.widened(1e-14)),
                        "{side:?} {place:?} {i}: {} {moved}",
                        there[i]
                    );
                }
            }
        }
    }
}
