//! The figures of section 4, the boundary of rest. All dimensionless: lengths in μg/Ω², times in 1/Ω.

use super::{AllFiguresError, Drawn, census::Census, trend::sides};
use crate::claims::rest::boundary;
use crate::motion::{
    MotionError,
    turntable::ensemble::rests,
    turntable::intrinsic::Run,
    turntable::{Fate, Start, fate},
};
use std::f64::consts::{PI, TAU};
use trialbook::plotting::{Axis, Curve, Figure, FigureError, Panel, Plot, Points, Rule, Table};

pub(super) fn figures() -> Drawn<Vec<Figure>> {
    Ok(vec![censuses()?, borders()?, phase_space()?])
}

/// Enough that no corner is seen.
const ANGLES: i32 = 192;

/// Largest α of the picture of the phase space.
const REACH: f64 = 0.75;

/// Steps in α from rest, one of which goes across a level line.
const STEP: f64 = 0.05;
const STEPS: i32 = 30;

const HALVINGS: i32 = 9;

/// The level line of the boundary at this A, as (α, ψ): for each angle the first α from which the particle escapes.
fn level(a: f64) -> Drawn<Vec<[f64; 2]>> {
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
    let level = std::iter::zip(alphas, angles);
    Ok(level.map(<[f64; 2]>::from).collect())
}

const SIDE: usize = 60;

fn censuses() -> Drawn {
    let (alphas, sizes) = ((0.0, 0.3), (0.6, 1.05));
    let one = |(name, psi)| -> Drawn<_> {
        let start = |[alpha, a]: [f64; 2]| Start::hyperbolic(a, alpha, psi);
        let line = |f: &dyn Fn(f64) -> f64| {
            let alphas = (0..=60).map(|i| 0.005 * f64::from(i));
            alphas.map(|alpha| [alpha, f(alpha)]).collect()
        };
        Ok(Section {
            psi: name,
            census: Census::new(SIDE, [alphas, sizes], start)?,
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
fn edge(far: f64, (low, high): (f64, f64), psi: f64) -> Drawn<Vec<[f64; 2]>> {
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

/// A census of starts in the (α, A) plane at one ψ, with the boundary as (α, A).
pub(super) struct Section {
    /// Name of the angle.
    pub psi: &'static str,
    pub census: Census,
    /// (147).
    pub printed: Vec<[f64; 2]>,
    /// To second order.
    pub corrected: Vec<[f64; 2]>,
    /// By bisection on the motion.
    pub found: Vec<[f64; 2]>,
}

/// At several ψ, with the printed and the corrected boundary.
pub(super) fn census(list: &[Section]) -> Result<Figure, FigureError> {
    let mut table = Table::new(&["psi", "alpha", "A", "rests"]);
    let mut plot = Plot::new("rest-census", "Who comes to rest")
        .caption(
            "What becomes of particles that start with the given $\\alpha$ and $A$, for three angles $\\psi$. Every \
             cell is one motion, followed until its fate is certain. Shaded: it comes to rest. The true boundary \
             depends on $\\psi$ ({{line by bisection}}: by bisection on the motion; {{line to second order}}: to second order in \
             $\\alpha$, which is good while $\\alpha$ is small), the printed envelope (147) ({{line (147)}}) does not.",
        )
        .alt(
            "Three panels with α to the right and A upwards. The shaded region of rest lies below a line that falls \
             from A = 1, steeply at ψ = 0, half as steeply at ψ = π/2, and hardly at all at ψ = 5π/6; the \
             {{line by bisection}} line is its edge, the {{line to second order}} curve follows it where α is small, the {{line (147)}} \
             curve runs well below.",
        );
    for section in list {
        let (psi, found) = (section.psi, &section.found);
        table.rows(psi, section.census.rows())?;
        table.rows(psi, found.iter().map(|at| (at, "border")))?;
        let panel = (section.census)
            .panel([Axis::linear("α"), Axis::linear("A")])?
            .title(format!("ψ = {psi}"))
            .height(240.0)
            .curve(Curve::new(found).ink().key("by bisection"))
            .curve(
                Curve::new(&section.corrected)
                    .ink()
                    .dotted()
                    .key("to second order"),
            )
            .curve(Curve::new(&section.printed).ink().dashed().key("(147)"));
        plot = plot.panel(panel);
    }
    plot.figure(table)
}

/// How far the boundary lies below A = 1, in units of α, all round ψ: by bisection at the trials' points.
fn borders() -> Drawn {
    // (ψ, A) for each α.
    let mut list: Vec<(f64, Vec<[f64; 2]>)> = Vec::new();
    for border in boundary::borders() {
        let border = border?;
        let known = list.iter().position(|(alpha, _)| *alpha == border.alpha);
        let index = known.unwrap_or_else(|| {
            list.push((border.alpha, Vec::new()));
            list.len() - 1
        });
        list[index].1.push([border.psi, border.a]);
    }
    // The smallest first: it is the nearest to the limit. The largest is beyond the reach of second order.
    list.retain(|(alpha, _)| *alpha < 0.2);
    list.reverse();
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
    for (n, (alpha, found)) in list.iter().enumerate() {
        table.rows(alpha, found)?;
        let scaled = |[psi, a]: [f64; 2]| [psi, (1.0 - a) / alpha];
        let angles = (0..=120).map(|k| PI * (f64::from(k) - 60.0) / 60.0);
        let corrected = angles.map(|psi| scaled([psi, boundary::corrected_a(*alpha, psi)]));
        let found = Points::new(found.iter().copied().map(scaled));
        panel = panel
            .curve(Curve::new(corrected).series(n).solid())
            .points(found.series(n).key(format!("α = {alpha}")));
    }
    let found = || {
        list.iter()
            .flat_map(|(alpha, found)| found.iter().map(move |[_, a]| (1.0 - a) / alpha))
    };
    let mut printed = f64::NAN;
    if let Some((alpha, _)) = list.first() {
        printed = (1.0 - boundary::printed_a(*alpha)) / alpha;
        panel = panel.rule(Rule::horizontal(printed).key(format!("(147), α = {alpha}")));
    }
    Ok(Plot::new("rest-boundary", "The boundary all round")
        .caption(
            "How far {{above|below}} $A=1$ the boundary between rest and escape lies, in units of $\\alpha$, against $\\psi$: by \
             bisection (marks) and to second order in $\\alpha$ (curves). For $\\alpha\\to0$ it is $\\cos^2(\\psi/2)$. The \
             printed envelope, at the smallest of these $\\alpha$, is the {{line (147)}} line, the same for all $\\psi$.",
        )
        .alt(format!(
            "Bell-shaped curves over ψ from −π to π, with marks on them: close to 1 at ψ = 0 and to 0 at ±π. The \
             {{{{line (147)}}}} line runs at {printed:.1}, {{{{over|under}}}} all of them.",
        ))
        .says(["above|below"], sides(found(), 0.0))
        .says(["over|under"], sides(found(), printed))
        .panel(panel)
        .figure(table)?)
}

/// The phase space (A, α, ψ) from above: level lines of the boundary, and motions.
fn phase_space() -> Drawn {
    let polar = |&[alpha, psi]: &[f64; 2]| [alpha * libm::cos(psi), alpha * libm::sin(psi)];
    let mut table = Table::new(&["what", "A", "alpha", "psi (rad)"]);
    let axis = |name: &str| Axis::linear(name).range(-REACH, REACH);
    let mut panel = Panel::new(axis("α cos ψ"), axis("α sin ψ")).equal();
    for (n, a) in [0.9, 0.8, 0.7, 0.6].into_iter().enumerate() {
        let (found, printed) = (level(a)?, boundary::printed_alpha(a));
        table.rows(("boundary", a), &found)?;
        let circle = (0..=90).map(|i| polar(&[printed, TAU * f64::from(i) / 90.0]));
        let found = Curve::new(found.iter().map(polar)).series(n).solid();
        panel = panel
            .curve(found.label_at(format!("A = {a}"), 0.22))
            .curve(Curve::new(circle).series(n).dotted().width(1.2));
    }
    // Every 25th point of the lines, from the middle and from beyond.
    let mut inside = [true; 2];
    for row in table.numbers().iter().step_by(25) {
        let rests = |times: f64| {
            Ok(matches!(
                fate(&Start::hyperbolic(row[1], times * row[2], row[3])?)?,
                Fate::Rest { .. }
            ))
        };
        let [nearer, farther]: [Drawn<bool>; 2] = [rests(0.9), rests(1.1)];
        let (nearer, farther) = (nearer?, farther?);
        inside = [
            inside[0] && nearer && !farther,
            inside[1] && farther && !nearer,
        ];
    }
    // Those that leave run together, and have one label.
    let mut leaving = Some("escape");
    for [a, alpha, psi] in [
        [0.7, 0.6, 2.4],
        [0.7, 0.6, 1.2],
        [0.8, 0.4, -2.4],
        [0.9, 0.3, -1.2],
    ] {
        let start = Start::hyperbolic(a, alpha, psi)?;
        let rests = matches!(fate(&start)?, Fate::Rest { .. });
        let run = Run::new(&start, 8.0)?;
        let there = |tau: f64| run.at(tau).map(|x| x.alpha().map(|alpha| [alpha, x.psi()]));
        let way = (0..=800).map(|i| there(0.01 * f64::from(i)));
        let way: Vec<_> = way.collect::<Result<_, _>>()?;
        // Angle and α of a particle at rest are no more.
        let way = way.into_iter().flatten().filter(|[alpha, _]| *alpha > 1e-4);
        let way: Vec<_> = way.take_while(|[alpha, _]| *alpha < REACH).collect();
        let what = if rests { "rests" } else { "escapes" };
        table.rows((what, ""), &way)?;
        let curve = Curve::new(way.iter().map(polar)).ink().arrows(&[0.4]);
        panel = panel.curve(match rests {
            true => curve.label_at(what, 0.25),
            false => match leaving.take() {
                Some(both) => curve.label_at(both, 0.7),
                None => curve,
            },
        });
    }
    Ok(Plot::new("rest-space", "The phase space from above")
        .caption(
            "The space of $A$, $\\alpha$ and $\\psi$ seen along the $A$ axis, with $\\alpha$ as the distance from the middle \
             and $\\psi$ as the angle; the middle is rest. A start with the given $A$ comes to rest {{inside|outside}} its line ({{line A = }}, \
             by bisection on the motion) and escapes {{outside|inside}}. The printed envelope (147) would make the lines circles \
             (dotted). In ink, four motions: as a particle slows down, $\\psi$ turns towards 0 and it falls into the middle \
             along the right half of the axis, or turns around and leaves.",
        )
        .alt(
            "A polar diagram. Closed lines around the middle, one for each A, the narrower the larger A is; each \
             bulges far to the left, where the particle moves inwards. The printed circles do not follow them. Four curves with arrows \
             run in from the left; some end in the middle, some leave to the right.",
        )
        .says(["inside|outside", "outside|inside"], inside)
        .panel(panel)
        .figure(table)?)
}
