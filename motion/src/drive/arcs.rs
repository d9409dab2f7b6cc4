//! Following the motion from piece to piece of h.
//!
//! On a piece, h is monotone. So the size u = |w| is convex or concave there: it has at most one extremum, where h meets the
//! friction's level, and its first zero can be bracketed for certain.

use super::{Drive, Friction, sign::Sign};
use crate::numerics::{
    piecewise::{Piece, Piecewise, Secant},
    roots::falling_root,
};
use std::f64::consts::TAU;

/// On a monotone piece a motion can at most stop, turn, stop again and start again: no more events than this.
const EVENTS_PER_PIECE: usize = 8;

/// From this phase on, until the next mark, the motion has this sign.
#[derive(Debug, Clone, Copy)]
pub(super) struct Mark {
    pub phi: f64,
    pub sign: Sign,
}

pub(super) struct Walker<'d> {
    shape: &'d Piecewise,
    friction: Friction,
    level: f64,
    /// What counts as touching zero.
    touch: f64,
    turn: f64,
    piece: usize,
    s: f64,
    u: f64,
    sign: Sign,
    /// Set from a start until the end of the piece: w grows, whatever rounding says of h − λ at the start.
    fresh: bool,
    contraction: f64,
    lowest: f64,
    touches: bool,
}

impl<'d> Walker<'d> {
    /// `phi` in [0, 2π).
    pub(super) fn new(drive: &'d Drive, friction: Friction, phi: f64, w: f64) -> Self {
        let (piece, s) = drive.shape.locate(phi);
        let mut walker = Walker {
            shape: &drive.shape,
            friction,
            level: drive.resolution(),
            touch: drive.resolution(),
            turn: 0.0,
            piece,
            s,
            u: 0.0,
            sign: Sign::Rest,
            fresh: false,
            contraction: 1.0,
            lowest: 0.0,
            touches: false,
        };
        walker.set(w);
        walker
    }

    /// Forgets what was measured before.
    pub(super) fn set(&mut self, w: f64) {
        self.u = w.abs();
        self.sign = Sign::of(w);
        self.fresh = false;
        self.turn = 0.0;
        self.reset();
    }

    fn reset(&mut self) {
        self.contraction = 1.0;
        self.lowest = self.u;
        self.touches = false;
    }

    pub(super) fn position(&self) -> (usize, f64) {
        (self.piece, self.s)
    }

    pub(super) fn w(&self) -> f64 {
        self.sign.factor() * self.u
    }

    pub(super) fn contraction(&self) -> f64 {
        self.contraction
    }

    /// Since the last period began, if w did not vanish.
    pub(super) fn lowest(&self) -> f64 {
        self.lowest
    }

    pub(super) fn touches(&self) -> bool {
        self.touches
    }

    /// From and to the position `section` where the walker is. Marks count φ from the turn in which the period began.
    pub(super) fn period(&mut self, section: (usize, f64), marks: &mut Vec<Mark>) {
        self.turn = 0.0;
        self.reset();
        marks.clear();
        self.finish_turn(marks);
        self.run_to(section, marks);
    }

    pub(super) fn finish_turn(&mut self, marks: &mut Vec<Mark>) {
        self.begin(marks);
        while self.piece < self.shape.pieces().len() {
            self.finish_piece(self.here().length(), marks);
            self.enter(self.piece + 1);
        }
        self.enter(0);
        self.turn += TAU;
    }

    pub(super) fn run_to(&mut self, (piece, s): (usize, f64), marks: &mut Vec<Mark>) {
        self.begin(marks);
        while self.piece < piece {
            self.finish_piece(self.here().length(), marks);
            self.enter(self.piece + 1);
        }
        self.finish_piece(s, marks);
        self.s = s;
    }

    fn begin(&self, marks: &mut Vec<Mark>) {
        if marks.is_empty() {
            marks.push(self.mark());
        }
    }

    fn mark(&self) -> Mark {
        Mark {
            phi: self.turn + (self.here().start() + self.s),
            sign: self.sign,
        }
    }

    fn here(&self) -> &'d Piece {
        &self.shape.pieces()[self.piece]
    }

    fn enter(&mut self, piece: usize) {
        self.piece = piece;
        self.s = 0.0;
        self.fresh = false;
    }

    fn finish_piece(&mut self, end: f64, marks: &mut Vec<Mark>) {
        for _ in 0..EVENTS_PER_PIECE {
            let event = match self.sign {
                Sign::Rest => self.leave(end),
                Sign::Positive | Sign::Negative => self.slide(end),
            };
            match event {
                None => break,
                Some((s, sign)) => {
                    self.fresh = self.sign == Sign::Rest;
                    self.s = s;
                    self.u = 0.0;
                    self.sign = sign;
                    if sign == Sign::Rest {
                        self.contraction = 0.0;
                    }
                    marks.push(self.mark());
                }
            }
        }
    }

    fn leave(&self, end: f64) -> Option<(f64, Sign)> {
        let piece = self.here();
        let (first, last) = self.ends(piece, end);
        for (sign, value, level) in [
            (Sign::Positive, first, self.friction.plus),
            (Sign::Negative, -first, self.friction.minus),
        ] {
            if value > level + self.level {
                return Some((self.s, sign));
            }
        }
        for (sign, value, level) in [
            (Sign::Positive, last, self.friction.plus),
            (Sign::Negative, -last, self.friction.minus),
        ] {
            if value > level + self.level {
                let s = piece.crossing(sign.factor() * level, self.s, end);
                return Some((s, sign));
            }
        }
        None
    }

    fn ends(&self, piece: &Piece, end: f64) -> (f64, f64) {
        let first = if self.s == 0.0 {
            piece.left()
        } else {
            piece.value(self.s)
        };
        let last = if end == piece.length() {
            piece.right()
        } else {
            piece.value(end)
        };
        (first, last)
    }

    fn slide(&mut self, end: f64) -> Option<(f64, Sign)> {
        let piece = self.here();
        let (s0, u0, side) = (self.s, self.u, self.sign.factor());
        let friction = if side > 0.0 {
            self.friction.plus
        } else {
            self.friction.minus
        };
        let (first, last) = self.ends(piece, end);
        let (mut g0, g1) = (side * first - friction, side * last - friction);
        if self.fresh {
            g0 = g0.max(0.0);
        }
        if u0 <= 0.0 && (g0 < 0.0 || g0 == 0.0 && g1 < 0.0) {
            return Some((s0, self.after(first)));
        }
        let whole = s0 == 0.0 && end == piece.length();
        let gain = if whole {
            side * piece.integral() - friction * end
        } else {
            (end - s0) * (side * piece.secant(s0).mean(end) - friction)
        };
        let u1 = u0 + gain;
        let arc = |s: f64, secant: &Secant| {
            let (mean, value) = secant.mean_value(s);
            (
                u0 + (s - s0) * (side * mean - friction),
                side * value - friction,
            )
        };
        if g0 < 0.0 && g1 > 0.0 {
            // |w| falls, then rises: all depends on its minimum.
            let bottom = piece.crossing(side * friction, s0, end);
            let secant = piece.secant(s0);
            let (depth, _) = arc(bottom, &secant);
            if depth < -self.touch {
                let s = falling_root(s0, bottom, s0, |s| arc(s, &secant));
                return Some(self.stop(piece, s));
            }
            self.touches |= depth <= self.touch;
            self.lowest = self.lowest.min(depth.max(0.0));
        } else if g1 < 0.0 && u1 <= 0.0 {
            // |w| falls at the end, monotonically or after a maximum: one zero, on the falling side.
            let secant = piece.secant(s0);
            let guess = if g0 > 0.0 || g1 < g0 { end } else { s0 };
            let s = falling_root(s0, end, guess, |s| arc(s, &secant));
            return Some(self.stop(piece, s));
        } else if g0 < 0.0 && u1 <= 0.0 {
            // It falls all the way, with h back at the level just at the end.
            if u1 < -self.touch {
                let secant = piece.secant(s0);
                let s = falling_root(s0, end, s0, |s| arc(s, &secant));
                return Some(self.stop(piece, s));
            }
            self.touches = true;
        }
        self.u = u1.max(0.0);
        self.lowest = self.lowest.min(self.u);
        None
    }

    /// What comes then, and how much a small change of w shrinks by it.
    fn stop(&mut self, piece: &Piece, s: f64) -> (f64, Sign) {
        let h = piece.value(s);
        let next = self.after(h);
        let (before, after) = match next {
            Sign::Negative => (h - self.friction.plus, h + self.friction.minus),
            Sign::Positive => (h + self.friction.minus, h - self.friction.plus),
            Sign::Rest => (1.0, 0.0),
        };
        self.contraction *= (after / before).clamp(0.0, 1.0);
        (s, next)
    }

    /// The sign that follows a zero of w where the drive is `h`.
    fn after(&self, h: f64) -> Sign {
        if h > self.friction.plus + self.level {
            Sign::Positive
        } else if -h > self.friction.minus + self.level {
            Sign::Negative
        } else {
            Sign::Rest
        }
    }
}
