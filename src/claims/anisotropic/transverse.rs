//! Trials of the velocity across the drive under a friction that depends on the direction of the velocity.

use super::prelude::*;
use crate::paper::general;

/// A friction over the drive's amplitude, by the direction of the velocity, against which it acts: never 0.
#[derive(Debug, Clone, Copy)]
struct Rough {
    least: f64,
    more: f64,
    direction: f64,
    lobes: f64,
}

impl Rough {
    fn any(points: &mut Points) -> Self {
        Rough {
            least: points.uniform(0.15, 0.8),
            more: points.uniform(0.0, 1.0),
            direction: points.uniform(0.0, TAU),
            lobes: points.uniform(1.0, 4.0).floor(),
        }
    }

    fn towards(&self, theta: f64) -> f64 {
        let wave = libm::cos(self.lobes * (theta - self.direction));
        self.least + self.more * (0.5 + 0.5 * wave)
    }
}

/// A velocity (w_x, w_y), w_y > 0, as a = ln(w + w_x) and b = ln(w − w_x), and the phase: w_y may be less than any number.
type Logarithms = [f64; 3];

/// With dφ = w dσ: da/dσ = h − λ(θ), db/dσ = −h − λ(θ).
fn rate(friction: impl Fn(f64) -> f64, [a, b, phi]: Logarithms) -> Logarithms {
    let lambda = friction(2.0 * libm::atan(libm::exp(0.5 * (b - a))));
    let h = libm::sin(phi);
    let w = 0.5 * (libm::exp(a) + libm::exp(b));
    [h - lambda, -h - lambda, w]
}

fn begin([w_x, w_y]: [f64; 2], phi: f64) -> Logarithms {
    let w = libm::hypot(w_x, w_y);
    // Of the two the smaller one is w_y² over the other.
    let large = libm::log(w + w_x.abs());
    let small = 2.0 * libm::log(w_y) - large;
    if w_x < 0.0 {
        [small, large, phi]
    } else {
        [large, small, phi]
    }
}

fn across([a, b, _]: Logarithms) -> f64 {
    libm::exp(0.5 * (a + b))
}

/// The states after pieces of the way, each so long, up to sixty periods or until w_y is 0 to rounding.
fn followed(
    friction: impl Fn(f64) -> f64,
    v: [f64; 2],
    piece: f64,
) -> Result<Vec<Logarithms>, Failure> {
    let mut states = vec![begin(v, FRAC_PI_2)];
    while states.len() < PIECES {
        let last = states[states.len() - 1];
        if last[2] > FRAC_PI_2 + TAU * PERIODS || across(last) == 0.0 {
            return Ok(states);
        }
        let step = |_: f64, state: &Logarithms| rate(&friction, *state);
        states.push(dop853::end(step, 0.0, last, piece, DIGITS, DIGITS)?);
    }
    Err("neither does time pass nor does it stop".into())
}

/// To these the logarithms are followed: whether they grow, and whether they go below every number, needs no more.
const DIGITS: f64 = 1e-6;

const PIECES: usize = 20_000;

const PERIODS: f64 = 60.0;

fn start(points: &mut Points) -> [f64; 2] {
    [points.uniform(-1.0, 1.0), points.log_uniform(0.05, 1.0)]
}

pub(super) fn vanishes() -> Evidence {
    Trial::by(
        Limit,
        Printed,
        Compared::constant(
            "the stated 0",
            r"$\mathfrak w_y$ after sixty periods under a friction that depends on the direction",
        ),
        GONE,
    )
    .drawn(0..24, |_, points| {
        let (rough, v) = (Rough::any(points), start(points));
        let states = followed(|theta| rough.towards(theta), v, 8.0)?;
        let last = states.last().ok_or("no state")?;
        Ok(Pair {
            at: at(&rough, v),
            stated: printed::s24_late_vy(),
            found: across(*last),
            scale: v[1],
        })
    })
}

#[derive(Debug)]
struct Slowed {
    rough: Rough,
    v: [f64; 2],
    states: Vec<Logarithms>,
}

fn never_grows() -> Evidence {
    let trial = Trial::census(
        Printed,
        [
            r"the number of states at which (1), with the friction of their direction, lets $\mathfrak w_y>0$ grow",
            r"that of the pieces of the motion on which $\ln\mathfrak w_y$ grows, over sixty periods",
        ],
    );
    static MOTIONS: Runs<Vec<Slowed>> = Runs::new(|| {
        let mut points = Points::here();
        every((0..24).map(|_| {
            let (rough, v) = (Rough::any(&mut points), start(&mut points));
            let states = followed(|theta| rough.towards(theta), v, 1.0)?;
            Ok::<_, Failure>(Slowed { rough, v, states })
        }))
    });
    trial.over(MOTIONS.each(), |motion| {
        let Slowed { rough, v, states } = motion?;
        let logarithm = |[a, b, _]: &Logarithms| a + b;
        let grows = states
            .windows(2)
            .filter(|s| logarithm(&s[1]) >= logarithm(&s[0]));
        Ok(Pair::plain(
            at(rough, *v),
            states.iter().filter(|s| lets_grow(rough, **s)).count() as f64,
            grows.count() as f64,
        ))
    })
}

/// True where (1) lets w_y grow, by the direction of the velocity alone.
fn lets_grow(rough: &Rough, [a, b, phi]: Logarithms) -> bool {
    let theta = 2.0 * libm::atan(libm::exp(0.5 * (b - a)));
    let v = [libm::cos(theta), libm::sin(theta)];
    let drive = [-libm::sin(phi), 0.0];
    general::eq1_velocity_rate(drive, rough.towards(theta), 1.0, v)[1] > 0.0
}

pub(super) fn outside() -> Evidence {
    Trial::by(
        Integration,
        Outside,
        Compared::constant(
            "the stated 0",
            r"$\mathfrak w_y$ after sixty periods without friction",
        ),
        GONE,
    )
    .drawn(0..20, |_, points| {
        let v = start(points);
        let states = followed(|_| 0.0, v, 8.0)?;
        let last = states.last().ok_or("no state")?;
        Ok(Pair {
            at: format!("λ = 0, 𝔴 = {:.6}, 𝔴_y = {:.6}", v[0], v[1]),
            stated: printed::s24_late_vy(),
            found: across(*last),
            scale: v[1],
        })
    })
}

fn at(rough: &Rough, v: [f64; 2]) -> String {
    let Rough {
        least,
        more,
        direction,
        lobes,
    } = rough;
    format!(
        "λ from {least:.6} to {:.6}, {lobes} times in a turn, most towards {direction:.6}, 𝔴 = {:.6}, 𝔴_y = {:.6}",
        least + more,
        v[0],
        v[1]
    )
}

attempts![vanishes, never_grows, outside];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_velocity_has_its_logarithms() {
        for v in [[0.3, 0.4], [-0.3, 0.4], [0.0, 1e-3]] {
            let state = begin(v, 1.0);
            let [a, b] = [state[0], state[1]].map(libm::exp);
            assert!((0.5 * (a - b) - v[0]).abs() < 1e-15 && (across(state) - v[1]).abs() < 1e-15);
        }
        // The friction of a forward motion, and of one across it.
        let towards = |theta: f64| theta;
        assert!(rate(towards, begin([1.0, 1e-9], 0.0))[0].abs() < 1e-8);
        assert!((rate(towards, begin([0.0, 1.0], 0.0))[1] + FRAC_PI_2).abs() < 1e-15);
    }
}
