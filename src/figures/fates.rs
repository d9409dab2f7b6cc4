//! The figures of section 4, who comes to rest and how. All dimensionless: lengths in μg/Ω², times in 1/Ω.

use super::AllFiguresError;
use crate::claims::escape::straight::straight_in;
use crate::claims::rest::fates as maps;
use crate::motion::MotionError;
use crate::motion::turntable::ensemble::rests;
use crate::motion::turntable::intrinsic::Run;
use crate::motion::turntable::{Fate, Start, critical_radius, critical_speed, fate};
use std::f64::consts::PI;
use trialbook::plotting::{
    Axis, Curve, Figure, FigureError, Panel, Plot, Points, Raster, Rule, Stroke, Table,
};

pub(super) fn figures() -> Result<Vec<Figure>, AllFiguresError> {
    Ok(vec![
        resting_places()?,
        stops()?,
        basins()?,
        maps_of_fates()?,
    ])
}

fn resting_places() -> Result<Figure, AllFiguresError> {
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
    Ok(resting(&[
        Resting {
            axis: "ρ_0",
            name: "put down at rho_0",
            points: line(radius, Start::put_down)?,
            critical: radius,
        },
        Resting {
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
fn basins() -> Result<Figure, AllFiguresError> {
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
        Ok(Basin {
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
    Ok(basin(&[
        one("outward", "outward velocity", |rho, u| [u, -rho])?,
        one(
            "along",
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
fn maps_of_fates() -> Result<Figure, AllFiguresError> {
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
        Ok(Fates {
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
    Ok(fates(&list?, maps::as_of())?)
}

/// Speed and angle before a stop.
fn stops() -> Result<Figure, AllFiguresError> {
    let stop = |name: String, run: &Run, end: f64| -> Result<_, MotionError> {
        // Closer and closer to the stop.
        let near = (0..=100).map(|i| run.at(end * (1.0 - libm::exp10(-0.05 * f64::from(i)))));
        let mut states = near.collect::<Result<Vec<_>, _>>()?;
        states.extend(run.nodes().filter(|state| state.tau < end));
        states.sort_by(|a, b| a.tau.total_cmp(&b.tau));
        // Rounding turns a particle that comes straight in, but not before it is slower than this.
        let seen = states.iter().filter(|state| state.p() > 1e-3);
        let points = seen
            .map(|state| [state.tau, state.p(), state.psi()])
            .collect();
        Ok(Stop { name, points })
    };
    let mut list = Vec::new();
    for rho in [0.3, 0.6, 0.8, 0.87] {
        let run = Run::new(&Start::put_down(rho)?, 20.0)?;
        list.push(stop(format!("ρ_0 = {rho}"), &run, run.end().tau)?);
    }
    let straight = straight_in(0.6, 0.4)?;
    list.push(stop(
        "'straight in'".to_owned(),
        &straight.run,
        straight.stop().tau,
    )?);
    Ok(turning(&list)?)
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

/// A stop.
#[derive(Debug, Clone, PartialEq)]
pub struct Stop {
    /// How it began.
    pub name: String,
    /// (τ, p, ψ).
    pub points: Vec<[f64; 3]>,
}

/// How the velocity turns before a stop.
///
/// Fails as [`Plot::figure`] does.
pub fn turning(stops: &[Stop]) -> Result<Figure, FigureError> {
    let mut table = Table::new(&["start", "tau", "p", "psi (rad)"]);
    let mut panel = Panel::new(Axis::log("p"), Axis::log("ψ")).height(300.0);
    for (n, stop) in stops.iter().enumerate() {
        for [tau, p, psi] in &stop.points {
            let name = stop.name.trim_matches('\'');
            table.row([name.into(), (*tau).into(), (*p).into(), (*psi).into()])?;
        }
        let curve = Curve::new(stop.points.iter().map(|&[_, p, psi]| [p, psi]));
        let curve = curve.series(n).stroke(Stroke::Solid).arrows(&[0.5]);
        panel = panel.curve(curve.label_at(stop.name.clone(), 0.8));
    }
    Plot::new("rest-turning", "The last moments before a stop")
        .caption(
            "The angle $\\psi$ from the velocity to the position against the speed $p$, for particles put down at rest in the laboratory, \
             at the distance $\\rho_0$, and one that slides straight in. The others stop with $\\psi\\to0$, moving outwards: the angle of \
             the one that stops below $\\sigma=\\frac12$ falls more slowly than the speed, those of the others in proportion to it. The one that \
             slides straight in stops with $\\psi\\to\\pi$.",
        )
        .alt(
            "Logarithmic axes. Four curves begin at the upper right, at a quarter turn, and fall to the lower left, three of them along \
             parallel lines and one along a flatter line. A fifth stays at half a turn.",
        )
        .panel(panel)
        .figure(table)
}
