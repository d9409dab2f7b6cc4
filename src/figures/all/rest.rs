//! Figures of section 4, rest.

use super::AllFiguresError;
use crate::claims::escape::straight::straight_in;
use crate::claims::rest::{boundary, fates as maps};
use crate::figures::rest as rest_figures;
use crate::motion::MotionError;
use crate::motion::turntable::ensemble::rests;
use crate::motion::turntable::intrinsic::{Intrinsic, Run};
use crate::motion::turntable::{Fate, Start, critical_radius, critical_speed, fate};
use std::f64::consts::PI;
use trialbook::figures::Figure;

pub(super) fn figures() -> Result<Vec<Figure>, AllFiguresError> {
    Ok(vec![
        resting()?,
        hodographs()?,
        basin()?,
        census()?,
        around()?,
        fates()?,
        space()?,
    ])
}

/// Angles at which the level lines of the boundary are found: enough that no corner is seen.
const ANGLES: i32 = 192;

/// Largest α of the picture of the phase space.
const REACH: f64 = 0.75;

/// Steps in α from rest, one of which goes across a level line.
const STEP: f64 = 0.05;
const STEPS: i32 = 30;

/// Halvings of such a step.
const HALVINGS: i32 = 9;

/// The level line of the boundary at this A: for each angle the first α from which the particle escapes.
fn level(a: f64) -> Result<rest_figures::Level, AllFiguresError> {
    let angle = |k: i32| 2.0 * PI * f64::from(k) / f64::from(ANGLES) - PI;
    let angles: Vec<f64> = (0..=ANGLES).map(angle).collect();
    let escapes = |alphas: &[f64]| -> Result<Vec<bool>, MotionError> {
        let start = |(alpha, psi): (&f64, &f64)| Start::hyperbolic(a, *alpha, *psi);
        let starts: Result<Vec<_>, _> = alphas.iter().zip(&angles).map(start).collect();
        Ok(rests(&starts?)?
            .iter()
            .map(|rests| *rests == Some(false))
            .collect())
    };
    // A particle at rest (α = 0) stays so for A < 1.
    let mut alphas = vec![f64::NAN; angles.len()];
    for step in 1..=STEPS {
        let alpha = STEP * f64::from(step);
        let all = vec![alpha; angles.len()];
        for (first, escapes) in alphas.iter_mut().zip(escapes(&all)?) {
            if escapes && first.is_nan() {
                *first = alpha;
            }
        }
    }
    if alphas.iter().any(|alpha| alpha.is_nan()) {
        return Err(AllFiguresError::Data(format!(
            "A = {a}: no particle escapes"
        )));
    }
    for halving in 1..=HALVINGS {
        let width = STEP / f64::from(1 << halving);
        let below: Vec<f64> = alphas.iter().map(|alpha| alpha - width).collect();
        for ((alpha, below), escapes) in alphas.iter_mut().zip(&below).zip(escapes(&below)?) {
            if escapes {
                *alpha = *below;
            }
        }
    }
    Ok(rest_figures::Level {
        a,
        found: std::iter::zip(alphas, angles)
            .map(|(alpha, psi)| [alpha, psi])
            .collect(),
        printed: boundary::printed_alpha(a),
    })
}

/// The phase space from above: level lines of the boundary, and motions.
fn space() -> Result<Figure, AllFiguresError> {
    let motion = |[a, alpha, psi]: [f64; 3]| -> Result<_, MotionError> {
        let start = Start::hyperbolic(a, alpha, psi)?;
        let rests = matches!(fate(&start)?, Fate::Rest { .. });
        let run = Run::new(&start, 8.0)?;
        let there = |tau: f64| run.at(tau).map(|x| x.alpha().map(|alpha| [alpha, x.psi()]));
        let way = (0..=800).map(|i| there(0.01 * f64::from(i)));
        let way: Vec<_> = way.collect::<Result<_, _>>()?;
        // Angle and α of a particle at rest are no more.
        let way = way.into_iter().flatten().filter(|[alpha, _]| *alpha > 1e-4);
        Ok(rest_figures::Motion {
            rests,
            way: way.take_while(|[alpha, _]| *alpha < REACH).collect(),
        })
    };
    let levels: Result<Vec<_>, AllFiguresError> =
        [0.9, 0.8, 0.7, 0.6].into_iter().map(level).collect();
    let starts = [
        [0.7, 0.6, 2.4],
        [0.7, 0.6, 1.2],
        [0.8, 0.4, -2.4],
        [0.9, 0.3, -1.2],
    ];
    let motions: Result<Vec<_>, _> = starts.into_iter().map(motion).collect();
    Ok(rest_figures::space(&levels?, &motions?, REACH)?)
}

/// Cells along each side of the census.
const SIDE: usize = 60;

fn census() -> Result<Figure, AllFiguresError> {
    let (alphas, sizes) = ((0.0, 0.3), (0.6, 1.05));
    let at = |(from, to): (f64, f64), i: usize| from + (to - from) * (i as f64 + 0.5) / SIDE as f64;
    let one = |(name, psi): (&'static str, f64)| -> Result<_, AllFiguresError> {
        let start = |k: usize| Start::hyperbolic(at(sizes, k / SIDE), at(alphas, k % SIDE), psi);
        let starts: Result<Vec<_>, _> = (0..SIDE * SIDE).map(start).collect();
        let certain: Option<Vec<bool>> = rests(&starts?)?.into_iter().collect();
        let undecided = || AllFiguresError::Data("the fate of a cell is not certain".into());
        let line = |f: &dyn Fn(f64) -> f64| {
            let alphas = (0..=60).map(|i| 0.005 * f64::from(i));
            alphas.map(|alpha| [alpha, f(alpha)]).collect()
        };
        Ok(rest_figures::Census {
            psi: name,
            side: SIDE,
            rests: certain.ok_or_else(undecided)?,
            alpha: alphas,
            a: sizes,
            printed: line(&boundary::printed_a),
            corrected: line(&|alpha| boundary::corrected_a(alpha, psi)),
            found: edge(alphas.1, sizes, psi)?,
        })
    };
    let angles = [("0", 0.0), ("π/2", PI / 2.0), ("5π/6", 5.0 * PI / 6.0)];
    let list: Result<Vec<_>, _> = angles.into_iter().map(one).collect();
    Ok(rest_figures::census(&list?)?)
}

/// The A at which rest turns into escape, for α out to `far`; at rest it is 1.
fn edge(far: f64, (low, high): (f64, f64), psi: f64) -> Result<Vec<[f64; 2]>, AllFiguresError> {
    let alphas: Vec<f64> = (1..=30).map(|k| far * f64::from(k) / 30.0).collect();
    let mut bounds = vec![(low, high); alphas.len()];
    for _ in 0..=HALVINGS {
        let start = |(alpha, (low, high)): (&f64, &(f64, f64))| {
            Start::hyperbolic(0.5 * (low + high), *alpha, psi)
        };
        let starts: Result<Vec<_>, _> = alphas.iter().zip(&bounds).map(start).collect();
        for ((low, high), rest) in bounds.iter_mut().zip(rests(&starts?)?) {
            let middle = 0.5 * (*low + *high);
            if rest == Some(true) {
                *low = middle;
            } else {
                *high = middle;
            }
        }
    }
    let found = alphas.iter().zip(&bounds);
    let found = found.map(|(alpha, (low, high))| [*alpha, 0.5 * (low + high)]);
    Ok(std::iter::once([0.0, 1.0]).chain(found).collect())
}

/// The boundary by bisection at the trials' points.
fn around() -> Result<Figure, AllFiguresError> {
    let mut list: Vec<rest_figures::Around> = Vec::new();
    for border in boundary::borders() {
        let border = border?;
        let known = list.iter().position(|one| one.alpha == border.alpha);
        let index = known.unwrap_or_else(|| {
            let angles = (0..=120).map(|k| PI * (f64::from(k) - 60.0) / 60.0);
            let corrected = |psi| [psi, boundary::corrected_a(border.alpha, psi)];
            list.push(rest_figures::Around {
                alpha: border.alpha,
                found: Vec::new(),
                corrected: angles.map(corrected).collect(),
                printed: boundary::printed_a(border.alpha),
            });
            list.len() - 1
        });
        list[index].found.push([border.psi, border.a]);
    }
    // The smallest first: it is the nearest to the limit. The largest is beyond the reach of second order.
    list.retain(|one| one.alpha < 0.2);
    list.reverse();
    Ok(rest_figures::around(&list)?)
}

fn resting() -> Result<Figure, AllFiguresError> {
    let line =
        |critical: f64, start: fn(f64) -> Result<Start, MotionError>| -> Result<_, MotionError> {
            let mut points = Vec::new();
            for i in 0..=80 {
                // Closer and closer to the critical value, where the curve is steep.
                let left = 1.0 - f64::from(i) / 80.0;
                let x = critical * (1.0 - left * left);
                let sigma = match fate(&start(x)?)? {
                    Fate::Rest { sigma, .. } => sigma,
                    _ => 1.0,
                };
                points.push([x, sigma]);
            }
            Ok(points)
        };
    let (radius, speed) = (critical_radius()?, critical_speed()?);
    Ok(rest_figures::resting(&[
        rest_figures::Resting {
            axis: "ρ_0",
            name: "put down at rho_0",
            points: line(radius, Start::put_down)?,
            critical: radius,
        },
        rest_figures::Resting {
            axis: "u_0",
            name: "launched from the axis with u_0",
            points: line(speed, Start::launched)?,
            critical: speed,
        },
    ])?)
}

/// Cells along each side of the basin's maps.
const BASIN: usize = 160;

/// Who comes to rest, by distance and velocity in the laboratory.
fn basin() -> Result<Figure, AllFiguresError> {
    let (distance, speed) = ((0.0, 1.3), (-1.6, 1.6));
    let at =
        |(from, to): (f64, f64), i: usize| from + (to - from) * (i as f64 + 0.5) / BASIN as f64;
    let (radius, launch) = (critical_radius()?, critical_speed()?);
    let one = |axis, name, velocity: fn(f64, f64) -> [f64; 2]| -> Result<_, AllFiguresError> {
        let start = |k: usize| {
            let (rho, u) = (at(distance, k % BASIN), at(speed, k / BASIN));
            Start::cartesian([rho, 0.0], velocity(rho, u))
        };
        let starts: Result<Vec<_>, _> = (0..BASIN * BASIN).map(start).collect();
        let certain: Option<Vec<bool>> = rests(&starts?)?.into_iter().collect();
        let undecided = || AllFiguresError::Data("the fate of a cell is not certain".into());
        Ok(rest_figures::Basin {
            axis,
            name,
            side: BASIN,
            rests: certain.ok_or_else(undecided)?,
            distance,
            speed,
            critical: vec![[radius, 0.0], [0.0, launch], [0.0, -launch]],
        })
    };
    // Relative to the table, whose own velocity is ρ, across.
    Ok(rest_figures::basin(&[
        one("outward", "outward velocity", |rho, u| [u, -rho])?,
        one(
            "across",
            "velocity along the motion of the table",
            |rho, u| [0.0, u - rho],
        )?,
    ])?)
}

/// Cells along each side of what is simulated of a map of fates.
const FATES: usize = 64;

/// The angles at which the boundary is found for the part that is shown larger.
const PART: [f64; 5] = [0.60, 0.62, 0.64, 0.66, 0.68];

/// What is proved of the fates in three sections, beside what is simulated.
fn fates() -> Result<Figure, AllFiguresError> {
    let recorded = maps::recorded().unwrap_or_default();
    let one = |rows: Vec<maps::Row>| -> Result<_, AllFiguresError> {
        let a = rows.first().map_or(f64::NAN, |row| row.a);
        let at =
            |(from, to): (f64, f64), i: usize| from + (to - from) * (i as f64 + 0.5) / FATES as f64;
        let start = |k: usize| {
            Start::hyperbolic(
                a,
                at((0.0, maps::REACH), k / FATES),
                at((-PI, PI), k % FATES),
            )
        };
        let starts: Result<Vec<_>, _> = (0..FATES * FATES).map(start).collect();
        let certain: Option<Vec<bool>> = rests(&starts?)?.into_iter().collect();
        let undecided = || AllFiguresError::Data("the fate of a cell is not certain".into());
        let edge = |ends: fn(&maps::Row) -> [f64; 2]| {
            let ends = rows
                .iter()
                .flat_map(|row| std::iter::zip(row.psi, ends(row)));
            ends.map(|(psi, alpha)| [psi, alpha]).collect()
        };
        Ok(rest_figures::Fates {
            a,
            side: FATES,
            simulated: certain.ok_or_else(undecided)?,
            reach: maps::REACH,
            rests: edge(maps::Row::rests),
            escapes: edge(maps::Row::escapes),
            found: (PART.iter())
                .map(|&psi| Ok([psi, maps::line(a, psi)?]))
                .collect::<Result<_, MotionError>>()?,
        })
    };
    let list: Result<Vec<_>, _> = recorded.into_iter().map(one).collect();
    Ok(rest_figures::fates(&list?, maps::as_of())?)
}

/// The velocity before a stop.
fn hodographs() -> Result<Figure, AllFiguresError> {
    let stop = |name: String, run: &Run, end: f64| -> Result<_, MotionError> {
        let even = (0..=200).map(|i| run.at(end * f64::from(i) / 200.0));
        let mut states = even.collect::<Result<Vec<_>, _>>()?;
        states.extend(run.nodes().filter(|state| state.tau < end));
        states.sort_by(|a, b| a.tau.total_cmp(&b.tau));
        let point = |state: &Intrinsic| {
            let (s, c) = libm::sincos(state.psi());
            [state.tau, state.p() * c, -state.p() * s]
        };
        // Rounding turns a particle that comes straight in, but not before it is too slow to be seen.
        let seen = states.iter().filter(|state| state.p() > 1e-3);
        let points = seen.map(point).collect();
        Ok(rest_figures::Stop { name, points })
    };
    let mut stops = Vec::new();
    for rho in [0.3, 0.6, 0.8, 0.87] {
        let run = Run::new(&Start::put_down(rho)?, 20.0)?;
        stops.push(stop(format!("put down at ρ = {rho}"), &run, run.end().tau)?);
    }
    let straight = straight_in(0.6, 0.4)?;
    stops.push(stop(
        "straight in".to_owned(),
        &straight.run,
        straight.stop().tau,
    )?);
    Ok(rest_figures::hodographs(&stops)?)
}
