//! The figures of section 4, the boundary of rest. All dimensionless: lengths in μg/Ω², times in 1/Ω.

use super::AllFiguresError;
use crate::claims::rest::boundary;
use crate::motion::MotionError;
use crate::motion::turntable::ensemble::rests;
use crate::motion::turntable::intrinsic::Run;
use crate::motion::turntable::{Fate, Start, fate};
use std::f64::consts::PI;
use trialbook::plotting::{
    Axis, Curve, Figure, FigureError, Panel, Plot, Points, Raster, Rule, Stroke, Table,
};

pub(super) fn figures() -> Result<Vec<Figure>, AllFiguresError> {
    Ok(vec![censuses()?, borders()?, phase_space()?])
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
fn level(a: f64) -> Result<Level, AllFiguresError> {
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
    Ok(Level {
        a,
        found: std::iter::zip(alphas, angles)
            .map(|(alpha, psi)| [alpha, psi])
            .collect(),
        printed: boundary::printed_alpha(a),
    })
}

/// The phase space from above: level lines of the boundary, and motions.
fn phase_space() -> Result<Figure, AllFiguresError> {
    let motion = |[a, alpha, psi]: [f64; 3]| -> Result<_, MotionError> {
        let start = Start::hyperbolic(a, alpha, psi)?;
        let rests = matches!(fate(&start)?, Fate::Rest { .. });
        let run = Run::new(&start, 8.0)?;
        let there = |tau: f64| run.at(tau).map(|x| x.alpha().map(|alpha| [alpha, x.psi()]));
        let way = (0..=800).map(|i| there(0.01 * f64::from(i)));
        let way: Vec<_> = way.collect::<Result<_, _>>()?;
        // Angle and α of a particle at rest are no more.
        let way = way.into_iter().flatten().filter(|[alpha, _]| *alpha > 1e-4);
        Ok(Motion {
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
    Ok(space(&levels?, &motions?, REACH)?)
}

/// Cells along each side of the census.
const SIDE: usize = 60;

fn censuses() -> Result<Figure, AllFiguresError> {
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
        Ok(Census {
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
    Ok(census(&list?)?)
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
fn borders() -> Result<Figure, AllFiguresError> {
    let mut list: Vec<Around> = Vec::new();
    for border in boundary::borders() {
        let border = border?;
        let known = list.iter().position(|one| one.alpha == border.alpha);
        let index = known.unwrap_or_else(|| {
            let angles = (0..=120).map(|k| PI * (f64::from(k) - 60.0) / 60.0);
            let corrected = |psi| [psi, boundary::corrected_a(border.alpha, psi)];
            list.push(Around {
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
    Ok(around(&list)?)
}

/// A census of starts in the (α, A) plane at one ψ.
#[derive(Debug, Clone, PartialEq)]
pub struct Census {
    /// Name of the angle.
    pub psi: &'static str,
    /// Cells along each side; cells row by row from the lowest A, true for rest.
    pub side: usize,
    /// Rest or not.
    pub rests: Vec<bool>,
    /// Ends of the α axis.
    pub alpha: (f64, f64),
    /// Ends of the A axis.
    pub a: (f64, f64),
    /// (147): (α, A).
    pub printed: Vec<[f64; 2]>,
    /// The second-order boundary: (α, A).
    pub corrected: Vec<[f64; 2]>,
    /// The boundary by bisection on the motion: (α, A).
    pub found: Vec<[f64; 2]>,
}

/// Who comes to rest, at several ψ, with the printed and the corrected boundary.
///
/// Fails as [`Plot::figure`] and [`Raster::new`] do.
pub fn census(list: &[Census]) -> Result<Figure, FigureError> {
    let mut table = Table::new(&["psi", "alpha", "A", "rests"]);
    let mut plot = Plot::new("rest-census", "Who comes to rest")
        .caption(
            "What becomes of particles that start with the given $\\alpha$ and $A$, for three angles $\\psi$. Every \
             cell is one motion, followed until its fate is certain. Shaded: it comes to rest. The true boundary \
             depends on $\\psi$ (solid: by bisection on the motion; dotted: to second order in $\\alpha$, which is good while $\\alpha$ \
             is small), the printed envelope (147) (dashed) does not.",
        )
        .alt(
            "Three panels with α to the right and A upwards. The shaded region of rest lies below a line that falls \
             from A = 1, steeply at ψ = 0, half as steeply at ψ = π/2, and hardly at all at ψ = 5π/6; the solid \
             line is its edge, the dotted curve follows it where α is small, the dashed curve runs well below.",
        );
    for census in list {
        let side = census.side as f64;
        for (k, rests) in census.rests.iter().enumerate() {
            let at =
                |(from, to): (f64, f64), i: usize| from + (to - from) * (i as f64 + 0.5) / side;
            let (alpha, a) = (
                at(census.alpha, k % census.side),
                at(census.a, k / census.side),
            );
            table.row([
                census.psi.into(),
                alpha.into(),
                a.into(),
                f64::from(u8::from(*rests)).into(),
            ])?;
        }
        for [alpha, a] in &census.found {
            table.row([
                census.psi.into(),
                (*alpha).into(),
                (*a).into(),
                "border".into(),
            ])?;
        }
        let cells = census.rests.iter().map(|rests| u8::from(!rests)).collect();
        let raster = Raster::new(census.side, census.side, census.alpha, census.a, cells)?
            .class("rest", 0, 0.35)
            .class("escape", 1, 0.08);
        let panel = Panel::new(
            Axis::linear("α").range(census.alpha.0, census.alpha.1),
            Axis::linear("A").range(census.a.0, census.a.1),
        )
        .title(format!("ψ = {}", census.psi))
        .height(240.0)
        .raster(raster)
        .curve(
            Curve::new(census.found.iter().copied())
                .ink()
                .key("by bisection"),
        )
        .curve(
            Curve::new(census.corrected.iter().copied())
                .ink()
                .stroke(Stroke::Dotted)
                .key("to second order"),
        )
        .curve(
            Curve::new(census.printed.iter().copied())
                .ink()
                .stroke(Stroke::Dashed)
                .key("(147)"),
        );
        plot = plot.panel(panel);
    }
    plot.figure(table)
}

/// The boundary at one α.
#[derive(Debug, Clone, PartialEq)]
pub struct Around {
    /// α.
    pub alpha: f64,
    /// (ψ, A) by bisection.
    pub found: Vec<[f64; 2]>,
    /// (ψ, A) to second order.
    pub corrected: Vec<[f64; 2]>,
    /// A by (147).
    pub printed: f64,
}

/// How far the boundary lies below A = 1, in units of α, all round ψ.
///
/// Fails as [`Plot::figure`] does.
pub fn around(list: &[Around]) -> Result<Figure, FigureError> {
    use std::f64::consts::PI;
    let mut table = Table::new(&["alpha", "psi (rad)", "A, by bisection"]);
    let angles = [
        (-PI, "−π"),
        (-PI / 2.0, "−π/2"),
        (0.0, "0"),
        (PI / 2.0, "π/2"),
        (PI, "π"),
    ];
    let mut panel = Panel::new(
        Axis::linear("ψ").range(-PI, PI).ticks(angles),
        Axis::linear("(1 − A)/α").range(0.0, 1.5),
    );
    for (n, one) in list.iter().enumerate() {
        for [psi, a] in &one.found {
            table.row([one.alpha.into(), (*psi).into(), (*a).into()])?;
        }
        let scaled = |&[psi, a]: &[f64; 2]| [psi, (1.0 - a) / one.alpha];
        panel = panel
            .curve(
                Curve::new(one.corrected.iter().map(scaled))
                    .series(n)
                    .stroke(Stroke::Solid),
            )
            .points(
                Points::new(one.found.iter().map(scaled))
                    .series(n)
                    .key(format!("α = {}", one.alpha)),
            );
    }
    if let Some(first) = list.first() {
        let printed = (1.0 - first.printed) / first.alpha;
        panel = panel.rule(Rule::horizontal(printed).key(format!("(147), α = {}", first.alpha)));
    }
    Plot::new("rest-boundary", "The boundary all round")
        .caption(
            "How far below $A=1$ the boundary between rest and escape lies, in units of $\\alpha$, against $\\psi$: by \
             bisection (marks) and to second order in $\\alpha$ (curves). For $\\alpha\\to0$ it is $\\cos^2(\\psi/2)$. The \
             printed envelope, at the smallest of these $\\alpha$, is the dashed line, the same for all $\\psi$.",
        )
        .alt(
            "Bell-shaped curves over ψ from −π to π, with marks on them: close to 1 at ψ = 0 and to 0 at ±π. The \
             dashed line runs at 1.4, above all of them.",
        )
        .panel(panel)
        .figure(table)
}

/// A level line of the boundary.
#[derive(Debug, Clone, PartialEq)]
pub struct Level {
    /// A.
    pub a: f64,
    /// (α, ψ) by bisection.
    pub found: Vec<[f64; 2]>,
    /// α by (147), the same for all ψ.
    pub printed: f64,
}

/// A motion through the phase space.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    /// Whether it comes to rest.
    pub rests: bool,
    /// (α, ψ) on the way.
    pub way: Vec<[f64; 2]>,
}

/// The phase space (A, α, ψ) from above, out to α = `reach`: the boundary's level lines, and motions.
///
/// Fails as [`Plot::figure`] does.
pub fn space(levels: &[Level], motions: &[Motion], reach: f64) -> Result<Figure, FigureError> {
    use std::f64::consts::TAU;
    let polar = |&[alpha, psi]: &[f64; 2]| [alpha * libm::cos(psi), alpha * libm::sin(psi)];
    let mut table = Table::new(&["what", "A", "alpha", "psi (rad)"]);
    let axis = |name: &str| Axis::linear(name).range(-reach, reach);
    let mut panel = Panel::new(axis("α cos ψ"), axis("α sin ψ")).equal();
    for (n, level) in levels.iter().enumerate() {
        for &[alpha, psi] in &level.found {
            table.row(["boundary".into(), level.a.into(), alpha.into(), psi.into()])?;
        }
        let circle = (0..=90).map(|i| polar(&[level.printed, TAU * f64::from(i) / 90.0]));
        panel = panel
            .curve(
                Curve::new(level.found.iter().map(polar))
                    .series(n)
                    .stroke(Stroke::Solid)
                    .label_at(format!("A = {}", level.a), 0.22),
            )
            .curve(
                Curve::new(circle)
                    .series(n)
                    .stroke(Stroke::Dotted)
                    .width(1.2),
            );
    }
    // Those that leave run together, and have one label.
    let mut leaving = Some("escape");
    for motion in motions {
        let what = if motion.rests { "rests" } else { "escapes" };
        for &[alpha, psi] in &motion.way {
            table.row([what.into(), "".into(), alpha.into(), psi.into()])?;
        }
        let curve = Curve::new(motion.way.iter().map(polar))
            .ink()
            .arrows(&[0.4]);
        panel = panel.curve(match motion.rests {
            true => curve.label_at(what, 0.25),
            false => match leaving.take() {
                Some(both) => curve.label_at(both, 0.7),
                None => curve,
            },
        });
    }
    Plot::new("rest-space", "The phase space from above")
        .caption(
            "The space of $A$, $\\alpha$ and $\\psi$ seen along the $A$ axis, with $\\alpha$ as the distance from the middle \
             and $\\psi$ as the angle; the middle is rest. A start with the given $A$ comes to rest inside its line (solid, \
             by bisection on the motion) and escapes outside. The printed envelope (147) would make the lines circles \
             (dotted). In ink, four motions: as a particle slows down, $\\psi$ turns towards 0 and it falls into the middle \
             along the right half of the axis, or turns around and leaves.",
        )
        .alt(
            "A polar diagram. Closed lines around the middle, one for each A, the narrower the larger A is; each \
             bulges far to the left, where the particle moves inwards. The printed circles do not follow them. Four curves with arrows \
             run in from the left; some end in the middle, some leave to the right.",
        )
        .panel(panel)
        .figure(table)
}
