//! The figures of section 4, rest. All dimensionless: lengths in μg/Ω², times in 1/Ω.

use trialbook::figures::{
    Axis, Curve, Figure, FigureError, Panel, Plot, Points, Raster, Rule, Stroke, Table,
};

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
    for motion in motions {
        let what = if motion.rests { "rests" } else { "escapes" };
        for &[alpha, psi] in &motion.way {
            table.row([what.into(), "".into(), alpha.into(), psi.into()])?;
        }
        let curve = Curve::new(motion.way.iter().map(polar))
            .ink()
            .arrows(&[0.4]);
        panel = panel.curve(curve.label_at(what, 0.25));
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

/// Resting places against a start.
#[derive(Debug, Clone, PartialEq)]
pub struct Resting {
    /// What is varied, for the axis.
    pub axis: &'static str,
    /// The same for the table.
    pub name: &'static str,
    /// (start, σ).
    pub points: Vec<[f64; 2]>,
    /// The start beyond which it escapes.
    pub critical: f64,
}

/// Where a particle comes to rest against how it starts in the laboratory.
///
/// Fails as [`Plot::figure`] does.
pub fn resting(list: &[Resting]) -> Result<Figure, FigureError> {
    let mut table = Table::new(&["start", "value", "sigma"]);
    let mut plot = Plot::new("rest-radius", "Where a particle comes to rest")
        .caption(
            "Distance $\\sigma$ from the axis at which a particle comes to rest on the table: put down at rest in the \
             laboratory at the distance $\\rho_0$, and launched from the axis with the speed $u_0$. At the dashed line \
             $\\sigma$ reaches 1, with a vertical tangent; beyond it the particle goes away.",
        )
        .alt(
            "Two panels. In each a curve rises from the origin, ever more steeply, and ends at σ = 1 on a dashed \
             vertical line.",
        );
    for one in list {
        for [start, sigma] in &one.points {
            table.row([one.name.into(), (*start).into(), (*sigma).into()])?;
        }
        let panel = Panel::new(
            Axis::linear(one.axis).range(0.0, 1.25),
            Axis::linear("σ").range(0.0, 1.05),
        )
        .height(230.0)
        .curve(Curve::new(one.points.iter().copied()))
        .rule(Rule::vertical(one.critical).key(format!("critical: {:.6}", one.critical)));
        plot = plot.panel(panel);
    }
    plot.figure(table)
}

/// Which starts come to rest, at a distance from the axis with a velocity in the laboratory in one direction.
#[derive(Debug, Clone, PartialEq)]
pub struct Basin {
    /// The direction of the velocity, for the axis and the title.
    pub axis: &'static str,
    /// The same in words.
    pub name: &'static str,
    /// Cells along each side; cells row by row from the lowest velocity, true for rest.
    pub side: usize,
    /// Rest or not.
    pub rests: Vec<bool>,
    /// Ends of the axis of the distance.
    pub distance: (f64, f64),
    /// Ends of the axis of the velocity.
    pub speed: (f64, f64),
    /// Points on the axes beyond which a particle escapes.
    pub critical: Vec<[f64; 2]>,
}

/// Who comes to rest, by place and velocity in the laboratory; the second panel has the velocity of the table too.
///
/// Fails as [`Plot::figure`] and [`Raster::new`] do.
pub fn basin(list: &[Basin]) -> Result<Figure, FigureError> {
    let mut table = Table::new(&["velocity", "distance", "size", "rests"]);
    let mut plot = Plot::new("rest-basin", "Who comes to rest, seen from the laboratory")
        .caption(
            "What becomes of a particle that starts at the distance $\\rho$ from the axis with a velocity in the laboratory \
             straight outwards (first panel) or along the motion of the table (second panel). The dots are the critical \
             radius and the critical speed. On the dotted line the particle moves with the table; it stays \
             there as long as $\\rho\\le1$.",
        )
        .alt(
            "Two panels with the distance from 0 to 1.3 along the horizontal axis and the velocity from −1.6 to 1.6 along the \
             vertical one. In the first the border of the shaded region of rest slopes from the critical speed through the \
             critical radius, and inward velocities of any size shown lead to rest from some distance on; in the second the \
             region ends in a tip that follows the dotted line.",
        );
    for (n, basin) in list.iter().enumerate() {
        let side = basin.side as f64;
        let at = |(from, to): (f64, f64), i: usize| from + (to - from) * (i as f64 + 0.5) / side;
        for (k, rests) in basin.rests.iter().enumerate() {
            table.row([
                basin.name.into(),
                at(basin.distance, k % basin.side).into(),
                at(basin.speed, k / basin.side).into(),
                f64::from(u8::from(*rests)).into(),
            ])?;
        }
        let cells = basin.rests.iter().map(|rests| u8::from(!rests)).collect();
        let raster = Raster::new(basin.side, basin.side, basin.distance, basin.speed, cells)?
            .class("rest", 0, 0.35)
            .class("escape", 1, 0.08);
        let mut panel = Panel::new(
            Axis::linear("ρ").range(basin.distance.0, basin.distance.1),
            Axis::linear(basin.axis).range(basin.speed.0, basin.speed.1),
        )
        .title(basin.name)
        .height(270.0)
        .raster(raster)
        .points(Points::new(basin.critical.iter().copied()).ink());
        if n == 1 {
            panel = panel.curve(
                Curve::new([[0.0, 0.0], [1.0, 1.0]])
                    .ink()
                    .stroke(Stroke::Dotted),
            );
        }
        plot = plot.panel(panel);
    }
    plot.figure(table)
}

/// Fates at one A: simulated, and proved on both sides of a line.
#[derive(Debug, Clone, PartialEq)]
pub struct Fates {
    /// A.
    pub a: f64,
    /// Cells along each side; cells row by row from the lowest α, true for rest.
    pub side: usize,
    /// Rest or not, by simulation.
    pub simulated: Vec<bool>,
    /// Largest α.
    pub reach: f64,
    /// (ψ, α) below which all are proved to come to rest.
    pub rests: Vec<[f64; 2]>,
    /// (ψ, α) above which all are proved to escape.
    pub escapes: Vec<[f64; 2]>,
    /// (ψ, α) on the boundary, by simulation, in the part that is shown larger.
    pub found: Vec<[f64; 2]>,
}

/// Maps of fates, and a part of the last one so large that the gap between what is proved on both sides is seen;
/// `as_of` says when it was proved.
///
/// Fails as [`Plot::figure`] and [`Raster::new`] do.
pub fn fates(list: &[Fates], as_of: &str) -> Result<Figure, FigureError> {
    use std::f64::consts::PI;
    let mut table = Table::new(&["A", "psi (rad)", "alpha", "proved"]);
    let mut plot = Plot::new("rest-fates", "Who comes to rest, proved")
        .caption(format!(
            "Sections through the phase space. Shaded: cells whose middle comes to rest, by simulation. The two lines, \
             which cannot be told apart, are proved by validated integration: from every start below the lower one the \
             particle comes to rest, from every start shown above the upper one it escapes. The last panel magnifies a piece of the \
             third until the two lines separate, solid for rest and dashed for escape; the dots between them, just above the \
             solid one, are the simulated boundary. {as_of}.",
        ))
        .alt(
            "Three panels with ψ from −π to π to the right and α from 0 to 1.5 upwards. Shaded is what lies below a curve that \
             is lowest near ψ = 0 and rises towards both sides; the larger A, the lower it runs. In a fourth panel two lines \
             run side by side, with dots between them.",
        );
    let section = |reach| {
        let angles = [(-PI, "−π"), (0.0, "0"), (PI, "π")];
        let psi = Axis::linear("ψ").range(-PI, PI).ticks(angles);
        Panel::new(psi, Axis::linear("α").range(0.0, reach)).height(240.0)
    };
    for map in list {
        for (proved, edge) in [
            ("rest", &map.rests),
            ("escape", &map.escapes),
            ("neither: the boundary by simulation", &map.found),
        ] {
            for [psi, alpha] in edge {
                table.row([map.a.into(), (*psi).into(), (*alpha).into(), proved.into()])?;
            }
        }
        let cells = map.simulated.iter().map(|rests| u8::from(!rests)).collect();
        let raster = Raster::new(map.side, map.side, (-PI, PI), (0.0, map.reach), cells)?
            .class("rest", 0, 0.35)
            .class("escape", 1, 0.08);
        let within = |edge: &[[f64; 2]]| {
            Curve::new(edge.iter().map(|&[psi, alpha]| [psi.clamp(-PI, PI), alpha])).ink()
        };
        let panel = section(map.reach)
            .title(format!("A = {}", map.a))
            .raster(raster)
            .curve(within(&map.rests))
            .curve(within(&map.escapes));
        plot = plot.panel(panel);
    }
    // Without a record the section is bare.
    let last = list.last().map_or_else(|| section(1.0), larger);
    plot.panel(last).figure(table)
}

/// The part of a map about the dots.
fn larger(map: &Fates) -> Panel {
    let ends = |axis: usize| {
        let along = map.found.iter().map(|point| point[axis]);
        along.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
            (low.min(x), high.max(x))
        })
    };
    let (from, to) = ends(0);
    let (low, high) = ends(1);
    let room = 5e-4 * map.reach;
    let edge = |edge: &[[f64; 2]]| Curve::new(between(edge, (from, to))).ink();
    Panel::new(
        Axis::linear("ψ").range(from, to),
        Axis::linear("α").range(low - room, high + room),
    )
    .title(format!("A = {}, larger", map.a))
    .height(240.0)
    .curve(edge(&map.rests))
    .curve(edge(&map.escapes).stroke(Stroke::Dashed))
    .points(Points::new(map.found.iter().copied()).ink())
}

/// The piece of a line between two values of its first coordinate.
fn between(line: &[[f64; 2]], (from, to): (f64, f64)) -> Vec<[f64; 2]> {
    let mut piece = Vec::new();
    for ends in line.windows(2) {
        let [[x0, y0], [x1, y1]] = [ends[0], ends[1]];
        let (left, right) = (x0.max(from), x1.min(to));
        if left < right {
            piece.extend([left, right].map(|x| [x, y0 + (x - x0) / (x1 - x0) * (y1 - y0)]));
        }
    }
    piece
}

/// A stop: the velocity on the table, along the position and counterclockwise across it.
#[derive(Debug, Clone, PartialEq)]
pub struct Stop {
    /// How it began.
    pub name: String,
    /// (τ, outward, across).
    pub points: Vec<[f64; 3]>,
}

/// Hodographs of stops on the table.
///
/// Fails as [`Plot::figure`] does.
pub fn hodographs(stops: &[Stop]) -> Result<Figure, FigureError> {
    let mut table = Table::new(&["start", "tau", "outward", "across"]);
    let mut panel = Panel::new(
        Axis::linear("p cos ψ").range(-0.4, 0.4),
        Axis::linear("−p sin ψ").range(-0.9, 0.2),
    )
    .height(330.0);
    for (n, stop) in stops.iter().enumerate() {
        for [tau, outward, across] in &stop.points {
            table.row([
                stop.name.as_str().into(),
                (*tau).into(),
                (*outward).into(),
                (*across).into(),
            ])?;
        }
        let curve = Curve::new(stop.points.iter().map(|&[_, x, y]| [x, y]));
        panel = panel.curve(curve.series(n).arrows(&[0.5]).key(stop.name.clone()));
    }
    Plot::new("rest-hodograph", "The velocity of a stopping particle")
        .caption(
            "Hodographs on the table: the velocity's outward component and the one in the sense of the table's rotation. \
             Particles put down at rest in the laboratory, and one that slides straight in. A stop is the point in the middle. \
             All but the last arrive there moving outwards, with $\\psi\\to0$; for $\\sigma$ close to 1 the turn is done long before the stop. The \
             last one, with $\\psi\\to\\pi$, arrives from the other side.",
        )
        .alt(
            "Curves in the plane of the velocity. They start on the negative vertical axis, bend towards positive horizontal \
             velocities and run into the origin along the horizontal axis. A single curve comes from negative horizontal \
             velocities.",
        )
        .panel(panel)
        .figure(table)
}
