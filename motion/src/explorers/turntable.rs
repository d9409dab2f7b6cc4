//! Section 4: a particle on a turntable. Lengths in units of μg/Ω², times in 1/Ω, speeds in μg/Ω.

use super::{Answer, ExplorerError, spread};
use crate::MotionError;
use crate::turntable::{Fate, Start, State, Table, fate, fate::rests, intrinsic, rotating};
use std::f64::consts::{FRAC_PI_2, TAU};

const STEP: f64 = 0.04;
const LONGEST: f64 = 60.0;
const FARTHEST: f64 = 6.0;
const AFTER: f64 = 8.0;
/// In logarithms of the time.
const EARLY: f64 = 0.5;
const LATE: f64 = 1e4;
/// Steps along each side of the first survey of velocities, and their largest component.
const SURVEY: u32 = 10;
const LARGEST: f64 = 3.0;
/// Points of the boundary, and to what they are found: less than a picture shows.
const AROUND: u32 = 96;
const COARSE: u32 = 48;
const WIDTH: f64 = 2e-3;

/// The motion from the place (ρ, 0) with the given velocity relative to the table.
///
/// Values: the fate (1 rest, 0 escape, −1 undecided), the distance σ of the resting place from the axis (0 for an
/// escape), the time of the rest or the time by which the escape was certain, and the time between points. Curves: the path on the table and the
/// path in the laboratory, of a particle at rest for one turn more.
///
/// # Errors
/// Numbers that are not finite or above 10⁹, ρ negative.
pub fn motion(rho: f64, v: [f64; 2]) -> Result<Answer, ExplorerError> {
    let table = Table::default();
    let fate = fate(&start(rho, v)?)?;
    let (mut values, more) = match fate {
        Fate::Rest { sigma, tau, .. } => (vec![1.0, sigma, tau], TAU),
        Fate::Escape { tau, .. } => (vec![0.0, 0.0, tau], AFTER),
        Fate::Undecided { tau, .. } => (vec![-1.0, 0.0, tau], 0.0),
    };
    let until = (values[2] + more).min(LONGEST);
    let begin = State {
        t: 0.0,
        x: [rho, 0.0],
        v,
    };
    let path = rotating::run(&table, &begin, until)?;
    let (mut seen, mut here) = (Vec::new(), Vec::new());
    let n = (until / STEP) as u32 + 1;
    values.push(until / f64::from(n));
    for t in spread(0.0, until, n) {
        let state = path.at(t)?;
        seen.push(state.x);
        here.push(table.to_laboratory(&state).x);
        if state.radius() > FARTHEST {
            break;
        }
    }
    Ok(Answer {
        values,
        curves: vec![seen, here],
    })
}

/// How a particle put down at rest in the laboratory goes away, from τ = 3 to 10⁴.
///
/// Curves, against the logarithm of τ to the base 10, and to its rest, if it comes to rest: ρ/τ², (π/2 − ψ) τ, and
/// where p < ρ A²/τ³, cosh α cosh 2α/A and τ dα/dτ. Last its path in the laboratory from τ = 0 on, drawn at
/// the distance log₁₀ 10ρ, 0 within ρ = 1/10.
///
/// # Errors
/// ρ negative, not finite or above 10⁹.
pub fn growth(rho: f64) -> Result<Answer, ExplorerError> {
    let run = intrinsic::Run::new(&Start::put_down(rho)?, LATE)?;
    let end = run.end().tau;
    let early = libm::exp10(EARLY);
    let late = spread(EARLY, libm::log10(LATE), 140).map(libm::exp10);
    let (mut curves, mut path) = (vec![Vec::new(); 5], Vec::new());
    for tau in spread(0.0, early, 40)
        .take(40)
        .chain(late)
        .filter(|tau| *tau <= end)
    {
        let now = run.at(tau)?;
        let distance = libm::log10(10.0 * now.rho()).max(0.0);
        // Put down at (ρ, 0), it moves on the table along −y at first.
        let (sine, cosine) = libm::sincos(now.turned + now.psi() - FRAC_PI_2 + tau);
        path.push([distance * cosine, distance * sine]);
        if tau < early {
            continue;
        }
        let p = now.p();
        let mut shown = vec![now.rho() / (tau * tau), now.lag() * tau];
        if let Some((a, alpha)) = now.a().zip(now.alpha()) {
            let (cosh, cosh_twice) = (libm::cosh(alpha), libm::cosh(2.0 * alpha));
            // From sinh α = p/A, dp/dτ = −w and dA/dτ = p/A.
            let rate = -(now.deficit + p * p / (a * a)) / (a * cosh);
            shown.extend([a * a / (tau * tau * tau), cosh * cosh_twice / a, tau * rate]);
        }
        for (curve, value) in curves.iter_mut().zip(shown) {
            curve.push([libm::log10(tau), value]);
        }
    }
    curves.push(path);
    Ok(Answer {
        values: Vec::new(),
        curves,
    })
}

/// The boundary between rest and escape among the velocities of a particle at the distance ρ from the axis.
///
/// Curves: the boundary, to 2 · 10⁻³ at half as many points if it may be coarse, as seen from the middle of the velocities
/// that lead to rest, empty if a survey finds none with both components below 3; and the circle within which friction holds a particle at rest.
///
/// # Errors
/// ρ negative, not finite or above 10⁹.
pub fn boundary(rho: f64, coarse: bool) -> Result<Answer, ExplorerError> {
    let (mut middle, mut count) = ([0.0; 2], 0.0);
    for u in spread(-LARGEST, LARGEST, SURVEY) {
        for v in spread(-LARGEST, LARGEST, SURVEY) {
            if rests(&start(rho, [u, v])?)? == Some(true) {
                middle = [middle[0] + u, middle[1] + v];
                count += 1.0;
            }
        }
    }
    let mut curve = Vec::new();
    if count > 0.0 {
        let [u, v] = middle.map(|sum| sum / count);
        // The distances of the last two points from the middle say where the next will be.
        let mut last = [f64::NAN; 2];
        for angle in spread(0.0, TAU, if coarse { COARSE } else { AROUND }) {
            let (sine, cosine) = libm::sincos(angle);
            let at = |p: f64| [u + p * cosine, v + p * sine];
            let rests = |p: f64| Ok(rests(&start(rho, at(p))?)? == Some(true));
            let distance = edge(rests, 2.0 * last[1] - last[0])?;
            last = [if last[1].is_nan() { distance } else { last[1] }, distance];
            curve.push(at(distance));
        }
    }
    let length = Table::default().length();
    let circle = spread(0.0, TAU, 72).map(|angle| {
        let (sine, cosine) = libm::sincos(angle);
        [length * cosine, length * sine]
    });
    Ok(Answer {
        values: Vec::new(),
        curves: vec![curve, circle.collect()],
    })
}

/// Looked for from the expected one, if any, as far around as it takes, then by bisection.
fn edge(
    rests: impl Fn(f64) -> Result<bool, MotionError>,
    expected: f64,
) -> Result<f64, MotionError> {
    let [mut rest, mut escape] = [0.0, 2.0 * LARGEST];
    let (mut next, mut away) = (expected, WIDTH);
    // Without anything to expect, this is no number.
    while next > rest && next < escape {
        if rests(next)? {
            rest = next;
            next += away;
        } else {
            escape = next;
            next -= away;
        }
        away *= 2.0;
    }
    while escape - rest > WIDTH {
        let middle = 0.5 * (rest + escape);
        if rests(middle)? {
            rest = middle;
        } else {
            escape = middle;
        }
    }
    Ok(0.5 * (rest + escape))
}

fn start(rho: f64, v: [f64; 2]) -> Result<Start, MotionError> {
    Start::cartesian([rho, 0.0], v)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_growth_ends_with_the_rest() {
        let shown = |rho| growth(rho).unwrap().curves.remove(0);
        let Fate::Rest { sigma, tau, .. } = fate(&Start::put_down(0.8719).unwrap()).unwrap() else {
            panic!("it comes to rest")
        };
        let resting = shown(0.8719);
        let [decades, ratio] = resting[resting.len() - 1];
        assert!(
            decades <= libm::log10(tau) && libm::log10(tau) - decades < 0.05,
            "{decades} {tau}"
        );
        let last = libm::exp10(decades);
        assert!((ratio * last * last - sigma).abs() < 0.1, "{ratio} {sigma}");
        let escaping = shown(1.0);
        assert!((escaping[escaping.len() - 1][0] - 4.0).abs() < 1e-12 && escaping.len() == 141);
    }
}
