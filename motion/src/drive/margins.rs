//! What is measured on a periodic motion: its extremes, its mean, and how near it is to another kind.

use super::{DriveState, attractor::Attractor, intervals::Interval, sign::Sign};
use std::f64::consts::TAU;

/// How near a periodic motion is to one with another list of intervals; infinite where nothing can change so.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Margins {
    /// Length of the shortest interval (radians): at 0 it disappears.
    pub shortest: f64,
    /// Smallest |w| of a minimum inside a motion: at 0 it is cut in two.
    pub dip: f64,
    /// Least |h| beyond friction where w changes sign: at 0 a rest appears.
    pub crossing: f64,
    /// Least distance of an extremum of h inside a rest from λ₊ and −λ₋: at 0 a motion appears.
    pub hold: f64,
}

struct Stretch {
    piece: usize,
    /// From the left end of the piece.
    s0: f64,
    s1: f64,
    /// At the left end of the piece, not reduced.
    phi: f64,
    /// w at `s0`; of no meaning in a rest.
    w0: f64,
}

/// Phases (radians) that differ by no more differ by rounding alone.
const ROUNDED: f64 = 1e-14;

impl Attractor<'_> {
    /// Where |w| is largest, and w there; the phase in [0, 2π). At rest for ever: w = 0 at phase 0.
    pub fn largest(&self) -> DriveState {
        let mut best = DriveState { phi: 0.0, w: 0.0 };
        self.walk(|interval, stretch| {
            if interval.sign == Sign::Rest {
                return;
            }
            let level = self.level(interval.sign);
            let piece = &self.drive.shape().pieces()[stretch.piece];
            let top = piece.crossing(level, stretch.s0, stretch.s1);
            for s in [top, stretch.s1] {
                let w = stretch.w0 + (s - stretch.s0) * (piece.secant(stretch.s0).mean(s) - level);
                if w.abs() > best.w.abs() {
                    best = DriveState {
                        phi: (stretch.phi + s).rem_euclid(TAU),
                        w,
                    };
                }
            }
        });
        best
    }

    /// ∫ w dφ over one period, dimensionless. Divided by 2π, the mean velocity.
    pub fn displacement(&self) -> f64 {
        let [forward, backward] = self.distances();
        forward - backward
    }

    /// λ₊ and λ₋ times the distances forwards and backwards in a period, taken by friction: energy per mass, dimensionless. In a
    /// periodic motion it is ∮ h w dφ, the work of the drive.
    pub fn lost(&self) -> f64 {
        let [forward, backward] = self.distances();
        self.friction.plus * forward + self.friction.minus * backward
    }

    /// ∫ |w| dφ in a period, forwards and backwards; dimensionless.
    pub fn distances(&self) -> [f64; 2] {
        let [mut forward, mut backward] = [0.0; 2];
        self.walk(
            |interval,
             Stretch {
                 piece, s0, s1, w0, ..
             }| {
                if interval.sign == Sign::Rest {
                    return;
                }
                let level = self.level(interval.sign);
                let piece = &self.drive.shape().pieces()[piece];
                let length = s1 - s0;
                // ∫ w = w₀ ℓ + ∫ (s₁ − s)(h − level) ds.
                let zeroth = length * piece.secant(s0).mean(s1);
                let first = piece.moment(s1) - piece.moment(s0);
                let gone = w0 * length + s1 * zeroth - first - 0.5 * level * length * length;
                match interval.sign {
                    Sign::Positive => forward += gone,
                    _ => backward -= gone,
                }
            },
        );
        [forward, backward]
    }

    /// How near this motion is to one of another kind. Visits every piece of the drive once.
    pub fn margins(&self) -> Margins {
        let mut margins = Margins {
            shortest: f64::INFINITY,
            dip: f64::INFINITY,
            crossing: f64::INFINITY,
            hold: f64::INFINITY,
        };
        let n = self.intervals.len();
        for (i, interval) in self.intervals.iter().enumerate() {
            if n > 1 {
                margins.shortest = margins.shortest.min(interval.length());
            }
            let h = self.drive.h(interval.start);
            let before = self.intervals[(i + n - 1) % n].sign;
            let excess = match (before, interval.sign) {
                (Sign::Negative, Sign::Positive) => h - self.friction.plus(),
                (Sign::Positive, Sign::Negative) => -h - self.friction.minus(),
                _ => continue,
            };
            margins.crossing = margins.crossing.min(excess);
        }
        let pieces = self.drive.shape().pieces();
        self.walk(|interval, stretch| {
            let piece = &pieces[stretch.piece];
            let (h0, h1) = (piece.value(stretch.s0), piece.value(stretch.s1));
            if interval.sign == Sign::Rest {
                let next = &pieces[(stretch.piece + 1) % pieces.len()];
                let inside = piece.length() - stretch.s1 <= ROUNDED;
                let ahead = next.right() - next.left();
                let jumps = (next.left() - h1).abs() > self.drive.resolution();
                let room = |h: f64| (self.friction.plus() - h).min(self.friction.minus() + h);
                if inside && (jumps || (h1 - h0) * ahead <= 0.0) {
                    margins.hold = margins.hold.min(room(h1).max(0.0));
                }
                // After a jump the rest goes on, or it ended there.
                if inside && jumps && room(next.left()) >= 0.0 {
                    margins.hold = margins.hold.min(room(next.left()));
                }
                return;
            }
            let level = self.level(interval.sign);
            let side = interval.sign.factor();
            if side * stretch.w0 <= 0.0 {
                // It sets out from rest, and slows down here by rounding alone.
                return;
            }
            let w_at =
                |s: f64| stretch.w0 + (s - stretch.s0) * (piece.secant(stretch.s0).mean(s) - level);
            if side * (h0 - level) < -self.drive.resolution() && side * (h1 - level) > 0.0 {
                let bottom = piece.crossing(level, stretch.s0, stretch.s1);
                margins.dip = margins.dip.min((side * w_at(bottom)).max(0.0));
            }
            let jump = pieces[(stretch.piece + 1) % pieces.len()].left();
            let ends = stretch.phi + stretch.s1 >= interval.end;
            if !ends && side * (h1 - level) < 0.0 && side * (jump - level) > 0.0 {
                margins.dip = margins.dip.min((side * w_at(stretch.s1)).max(0.0));
            }
        });
        margins
    }

    fn level(&self, sign: Sign) -> f64 {
        match sign {
            Sign::Positive => self.friction.plus(),
            Sign::Negative => -self.friction.minus(),
            Sign::Rest => 0.0,
        }
    }

    fn walk(&self, mut visit: impl FnMut(&Interval, Stretch)) {
        let shape = self.drive.shape();
        let pieces = shape.pieces();
        for interval in &self.intervals {
            let reduced = interval.start.rem_euclid(TAU);
            let (mut piece, mut s0) = shape.locate(reduced);
            let mut phi = interval.start - s0;
            let mut w0 = self.w_start;
            let level = self.level(interval.sign);
            // An interval is at most a period long, so it meets each piece at most twice.
            for _ in 0..2 * pieces.len() + 2 {
                let here = &pieces[piece];
                let left = interval.end - phi;
                let s1 = here.length().min(left);
                if s1 > s0 {
                    visit(
                        interval,
                        Stretch {
                            piece,
                            s0,
                            s1,
                            phi,
                            w0,
                        },
                    );
                    w0 += (s1 - s0) * (here.secant(s0).mean(s1) - level);
                }
                if left <= here.length() {
                    break;
                }
                phi += here.length();
                piece = (piece + 1) % pieces.len();
                s0 = 0.0;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Drive, DriveState, Friction};
    use std::f64::consts::TAU;

    #[test]
    fn the_largest_velocity_has_its_phase_within_a_period() {
        let largest = |late: f64| {
            let drive = Drive::new(|phi| libm::sin(phi - late), &[]).unwrap();
            let friction = Friction::new(0.5, 0.3).unwrap();
            let start = DriveState { phi: 0.0, w: 0.0 };
            let settled = drive.attractor(friction, start, 100).unwrap().settled();
            let attractor = settled.unwrap();
            let largest = attractor.largest();
            assert!((attractor.w(largest.phi) - largest.w).abs() < 1e-12);
            largest
        };
        let first = largest(0.0);
        assert!(first.w.abs() > 0.1, "{first:?}");
        for k in 1..16 {
            let late = TAU * f64::from(k) / 16.0;
            let found = largest(late);
            let phi = (first.phi + late).rem_euclid(TAU);
            assert!((found.phi - phi).abs() < 1e-7, "{late}: {found:?} {phi}");
            assert!((found.w - first.w).abs() < 1e-12, "{late}: {found:?}");
        }
    }
}
