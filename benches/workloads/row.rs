//! When the sliding coin moves, by the formulas alone, for many q at one λ₀: one root from a good guess where a slip has to be
//! followed to its end.

use slipbook::paper::{anisotropic as printed, sinusoidal};
use std::f64::consts::{PI, TAU};

/// Of a period of the large-time motion; rest in between.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Arcs {
    /// The first in [0, π); equal if there is none.
    pub forward: [f64; 2],
    /// Not before forward motion ends; equal if there is none.
    pub backward: [f64; 2],
}

/// What depends on q alone.
#[derive(Debug, Clone, Copy)]
pub struct Column {
    pub q: f64,
    pub k: f64,
    pub sin: f64,
    pub cos: f64,
    pub ratio: f64,
}

impl Column {
    /// The column of q = μ₋/μ₊, from 1 to 10³.
    ///
    /// # Errors
    /// For q out of range.
    pub fn new(q: f64) -> Result<Self, String> {
        let fits = (1.0..=1e3).contains(&q);
        fits.then_some(())
            .ok_or_else(|| format!("q = {q} is not between 1 and 1e3"))?;
        let k = printed::eq53_k(q);
        let (sin, cos) = libm::sincos(k);
        Ok(Self {
            q,
            k,
            sin,
            cos,
            ratio: k / sin,
        })
    }
}

/// One after the other: neighbours begin their search where the last ones ended theirs.
#[derive(Debug, Clone)]
pub struct Row {
    pub lambda0: f64,
    /// From rest to rest, with the sine and cosine of its last phase.
    pub forward: [f64; 2],
    pub sin: f64,
    pub cos: f64,
    /// The newest first.
    pub last: [f64; 3],
    pub known: usize,
    /// Whether those followed forward motion at once.
    pub at_once: bool,
}

impl Row {
    /// The row of λ₀ = μ₊g/A₀, from 10⁻⁶ on.
    ///
    /// # Errors
    /// For λ₀ out of range.
    pub fn new(lambda0: f64) -> Result<Self, String> {
        let fit = (1e-6..=1e6).contains(&lambda0);
        fit.then_some(())
            .ok_or_else(|| format!("lambda0 = {lambda0} is not between 1e-6 and 1e6"))?;
        let mut forward = [0.0; 2];
        if lambda0 < 1.0 {
            let begin = sinusoidal::eq27_phi1(lambda0);
            let cos = libm::sqrt((1.0 - lambda0) * (1.0 + lambda0));
            forward = [begin, slip_end(lambda0, begin, cos, 4.0)];
        }
        let (sin, cos) = libm::sincos(forward[1]);
        Ok(Self {
            lambda0,
            forward,
            sin,
            cos,
            last: [0.0; 3],
            known: 0,
            at_once: false,
        })
    }

    /// Put behind what is in `arcs`.
    pub fn fill(&mut self, columns: &[Column], arcs: &mut Vec<Arcs>) {
        arcs.extend(columns.iter().map(|column| self.at(column)));
    }

    #[inline(always)]
    pub fn at(&mut self, column: &Column) -> Arcs {
        let (plus, minus) = (self.lambda0, column.q * self.lambda0);
        let [_, end] = self.forward;
        let one_way = Arcs {
            forward: self.forward,
            backward: [end; 2],
        };
        // Backward motion needs a drive below −qλ₀ after the end of forward motion.
        if minus >= 1.0 || (end > 1.5 * PI && -self.sin <= minus) {
            return one_way;
        }
        if let Some(arcs) = without_rest(plus, column) {
            return arcs;
        }
        let at_once = -self.sin >= minus;
        let (start, cos) = if at_once {
            (end - PI, -self.cos)
        } else {
            (libm::asin(minus), libm::sqrt((1.0 - minus) * (1.0 + minus)))
        };
        if at_once != self.at_once {
            (self.at_once, self.known) = (at_once, 0);
        }
        let guess = expected(self.known, self.last, start);
        let stop = slip_end(minus, start, cos, guess);
        self.last = [stop, self.last[0], self.last[1]];
        self.known = (self.known + 1).min(3);
        Arcs {
            backward: [start + PI, stop + PI],
            ..one_way
        }
    }
}

/// Region I, as in `without_rest`, with the addition theorem in place of sines of its phases.
pub fn without_rest(plus: f64, column: &Column) -> Option<Arcs> {
    let Column {
        k, sin, cos, ratio, ..
    } = *column;
    let sine = plus * ratio;
    if sine > 1.0 {
        return None;
    }
    let cosine = libm::sqrt((1.0 - sine) * (1.0 + sine));
    let holds = sine * cos + cosine * sin < plus;
    (!holds).then(|| {
        let middle = PI - libm::asin(sine);
        Arcs {
            forward: [middle - k, middle + k],
            backward: [middle + k, middle - k + TAU],
        }
    })
}

/// Half a period after its start if no end is known, else on the constant, the line or the parabola through the last ends, the
/// newest first.
#[inline(always)]
pub fn expected(known: usize, [a, b, c]: [f64; 3], start: f64) -> f64 {
    match known {
        0 => start + PI,
        1 => a,
        2 => 2.0 * a - b,
        _ => 3.0 * (a - b) + c,
    }
}

/// From rest at `start`, whose cosine is `cos`: the root of (32) between the phase at which it is fastest and one period after
/// its start, by Halley's method in that bracket.
pub fn slip_end(lambda: f64, start: f64, cos: f64, guess: f64) -> f64 {
    let (mut low, mut high) = (start, start + TAU);
    let mut x = guess;
    for step in 0..STEPS {
        let slow = step >= BRACKET && step % 2 == 0;
        if slow || !(x > low && x < high) {
            low = low.max(sinusoidal::eq28_phi2(lambda));
            x = 0.5 * (low + high);
        }
        let (sine, cosine) = libm::sincos(x);
        let w = cos - cosine - lambda * (x - start);
        let slope = sine - lambda;
        if w > 0.0 {
            low = x;
        } else {
            high = x;
        }
        let newton = w / slope;
        let bend = 0.5 * cosine / slope;
        x -= newton / (1.0 - newton * bend);
        // The error after a small step is about this times its third power.
        let third = bend * bend + (sine / (6.0 * slope)).abs();
        if slope < 0.0 && (newton * newton * newton * third).abs() < CLOSE {
            return x;
        }
    }
    x
}

const CLOSE: f64 = 1e-17;
/// Steps after which every other one halves the bracket, and steps in all.
const BRACKET: usize = 8;
const STEPS: usize = 80;
