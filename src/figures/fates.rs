//! The figures of section 4, who comes to rest and how. All dimensionless: lengths in μg/Ω², times in 1/Ω.

use super::{
    Drawn,
    census::Census,
    trend::{column, rises, steepens},
};
use crate::claims::{escape::straight::straight_in, rest::fates as maps};
use crate::motion::{
    MotionError,
    turntable::intrinsic::Run,
    turntable::{Fate, Start, critical_radius, critical_speed, fate},
};
use std::f64::consts::PI;
use trialbook::plotting::{Axis, Curve, Figure, FigureError, Panel, Plot, Points, Rule, Table};

pub(super) fn figures() -> Drawn<Vec<Figure>> {
    Ok(vec![
        resting_places()?,
        stops()?,
        basins()?,
        maps_of_fates()?,
    ])
}

/// Where a particle comes to rest against how it starts in the laboratory.
fn resting_places() -> Drawn {
    type Put = fn(f64) -> Result<Start, MotionError>;
    let starts: [(&str, &str, Put, f64); 2] = [
        (
            "ρ_0",
            "put down at rho_0",
            Start::put_down,
            critical_radius()?,
        ),
        (
            "u_0",
            "launched from the axis with u_0",
            Start::launched,
            critical_speed()?,
        ),
    ];
    let mut table = Table::new(&["start", "value", "sigma"]);
    let mut plot = Plot::new("rest-radius", "Where a particle comes to rest")
        .caption(
            "Distance $\\sigma$ from the axis at which a particle comes to rest on the table: put down at rest in the \
             laboratory at the distance $\\rho_0$, and launched from the axis with the speed $u_0$. At the {{line critical}} line \
             $\\sigma$ reaches 1, with a vertical tangent; beyond it the particle goes away.",
        )
        .alt(
            "Two panels. In each a curve {{rises from the origin, ever more steeply}}, and ends at σ = 1 on a {{line critical}} \
             vertical line.",
        );
    for (axis, name, start, critical) in starts {
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
        table.rows(name, &points)?;
        let panel = Panel::new(
            Axis::linear(axis).range(0.0, 1.25),
            Axis::linear("σ").range(0.0, 1.05),
        )
        .height(230.0)
        .curve(Curve::new(points))
        .rule(Rule::vertical(critical).key(format!("critical: {critical:.6}")));
        plot = plot.panel(panel);
    }
    let steep = |rows: &Vec<Vec<f64>>| {
        rows[0][1..] == [0.0; 2] && rises(column(rows, 2)) && steepens(&rows[1..], 1, 2)
    };
    plot = plot.says(
        ["rises from the origin, ever more steeply"],
        table.groups().iter().all(steep),
    );
    Ok(plot.figure(table)?)
}

const BASIN: usize = 160;

/// Who comes to rest, by distance and velocity in the laboratory; the second panel has the velocity of the table too.
fn basins() -> Drawn {
    // Relative to the table, whose own velocity is ρ, across.
    type Velocity = fn(f64, f64) -> [f64; 2];
    let directions: [(&str, &str, Velocity); 2] = [
        ("outward", "outward velocity", |rho, u| [u, -rho]),
        (
            "along",
            "velocity along the motion of the table",
            |rho, u| [0.0, u - rho],
        ),
    ];
    let (radius, launch) = (critical_radius()?, critical_speed()?);
    let critical = [[radius, 0.0], [0.0, launch], [0.0, -launch]];
    let mut table = Table::new(&["velocity", "distance", "size", "rests"]);
    let mut plot = Plot::new("rest-basin", "Who comes to rest, seen from the laboratory")
        .caption(
            "What becomes of a particle that starts at the distance $\\rho$ from the axis with a velocity in the laboratory \
             straight outwards (first panel) or along the motion of the table (second panel). The dots are the critical \
             radius and the critical speed. On the dotted line the particle {{moves with the table; it stays \
             there as long as $\\rho\\le1$}}.",
        )
        .alt(
            "Two panels with the distance from 0 to 1.3 along the horizontal axis and the velocity from −1.6 to 1.6 along the \
             vertical one. In the first the border of the shaded region of rest slopes from the critical speed through the \
             critical radius, and inward velocities of any size shown lead to rest from some distance on; in the second the \
             region {{ends in a tip that follows}} the dotted line.",
        );
    for (n, (axis, name, velocity)) in directions.into_iter().enumerate() {
        let start = |[rho, u]: [f64; 2]| Start::cartesian([rho, 0.0], velocity(rho, u));
        let census = Census::new(BASIN, [(0.0, 1.3), (-1.6, 1.6)], start)?;
        table.rows(name, census.rows())?;
        let mut panel = census
            .panel([Axis::linear("ρ"), Axis::linear(axis)])?
            .title(name)
            .height(270.0)
            .points(Points::new(critical).ink());
        if n == 1 {
            panel = panel.curve(Curve::new([[0.0, 0.0], [1.0, 1.0]]).ink().dotted());
        }
        plot = plot.panel(panel);
    }
    // Distance, velocity, rest, of those that start along the motion of the table.
    let groups = table.groups();
    let along = || {
        groups
            .iter()
            .skip(1)
            .flatten()
            .map(|row| [row[1], row[2], row[3]])
    };
    let rest = |speed: f64, reach: f64| {
        let near =
            |[rho, u, _]: &[f64; 3]| (u - speed * rho).abs() < 0.02 && (rho - reach).abs() < 0.06;
        along().any(|cell| near(&cell)) && along().filter(near).all(|cell| cell[2] == 1.0)
    };
    let tip = || along().filter(|[rho, _, rests]| *rests == 1.0 && *rho > 0.96);
    let ends = tip().count() > 0 && tip().all(|[rho, u, _]| rho < 1.0 && (u - rho).abs() < 0.1);
    plot = plot
        .says(
            ["moves with the table; it stays there as long as $\\rho\\le1$"],
            rest(1.0, 0.93) && !rest(1.0, 1.1) && !rest(0.0, 0.93),
        )
        .says(["ends in a tip that follows"], ends);
    Ok(plot.figure(table)?)
}

const FATES: usize = 64;

/// Where the boundary is found for the part that is shown larger.
const PART: [f64; 5] = [0.60, 0.62, 0.64, 0.66, 0.68];

fn maps_of_fates() -> Drawn {
    let recorded = maps::recorded().unwrap_or_default();
    let one = |rows: Vec<maps::Row>| -> Drawn<_> {
        let a = rows.first().map_or(f64::NAN, |row| row.a);
        let start = |[psi, alpha]: [f64; 2]| Start::hyperbolic(a, alpha, psi);
        let edge = |ends: fn(&maps::Row) -> [f64; 2]| {
            let ends = rows
                .iter()
                .flat_map(|row| std::iter::zip(row.psi, ends(row)));
            ends.map(|(psi, alpha)| [psi, alpha]).collect()
        };
        Ok(Fates {
            a,
            simulated: Census::new(FATES, [(-PI, PI), (0.0, maps::REACH)], start)?,
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

pub(super) struct Fates {
    a: f64,
    /// To the right ψ, upwards α.
    simulated: Census,
    /// (ψ, α) below which all are proved to come to rest.
    rests: Vec<[f64; 2]>,
    /// (ψ, α) above which all are proved to escape.
    escapes: Vec<[f64; 2]>,
    /// (ψ, α) on the boundary, by simulation, in the part that is shown larger.
    found: Vec<[f64; 2]>,
}

/// Maps of fates, and a part of the last one so large that the gap between what is proved on both sides is seen;
/// `as_of` says when it was proved.
pub(super) fn fates(list: &[Fates], as_of: &str) -> Result<Figure, FigureError> {
    let mut table = Table::new(&["A", "psi (rad)", "alpha", "proved"]);
    let mut plot = Plot::new("rest-fates", "Who comes to rest, proved")
        .caption(format!(
            "Sections through the phase space. Shaded: cells whose middle comes to rest, by simulation. The two lines, \
             which cannot be told apart, are proved by validated integration: from every start below the lower one the \
             particle comes to rest, from every start shown above the upper one it escapes. The last panel magnifies a piece of the \
             third until the two lines separate, solid for rest and dashed for escape; the dots between them, {{{{just above the \
             solid one}}}}, are the simulated boundary. {as_of}.",
        ))
        .alt(
            "Three panels with ψ from −π to π to the right and α from 0 to 1.5 upwards. Shaded is what lies below a curve that \
             is lowest near ψ = 0 and rises towards both sides; {{the larger A, the lower it runs}}. In a fourth panel two lines \
             run side by side, with dots between them.",
        );
    let axes = || {
        let angles = [(-PI, "−π"), (0.0, "0"), (PI, "π")];
        [
            Axis::linear("ψ").range(-PI, PI).ticks(angles),
            Axis::linear("α"),
        ]
    };
    for map in list {
        for (proved, edge) in [
            ("rest", &map.rests),
            ("escape", &map.escapes),
            ("neither: the boundary by simulation", &map.found),
        ] {
            table.rows(map.a, edge.iter().map(|at| (at, proved)))?;
        }
        let within = |edge: &[[f64; 2]]| {
            Curve::new(edge.iter().map(|&[psi, alpha]| [psi.clamp(-PI, PI), alpha])).ink()
        };
        let panel = (map.simulated)
            .panel(axes())?
            .height(240.0)
            .title(format!("A = {}", map.a))
            .curve(within(&map.rests))
            .curve(within(&map.escapes));
        plot = plot.panel(panel);
    }
    // Of the dots, those of the last map.
    let above = |edge: &[[f64; 2]], dot: &[f64; 2]| {
        let ends = edge
            .windows(2)
            .find(|two| (two[0][0]..=two[1][0]).contains(&dot[0]));
        ends.map(|two| {
            dot[1]
                - (two[0][1]
                    + (dot[0] - two[0][0]) / (two[1][0] - two[0][0]) * (two[1][1] - two[0][1]))
        })
    };
    let just = list.iter().all(|map| {
        map.found.iter().all(
            |dot| match (above(&map.rests, dot), above(&map.escapes, dot)) {
                (Some(over), Some(under)) => 0.0 < over && over < -under,
                _ => false,
            },
        )
    });
    let mut by_size: Vec<&Fates> = list.iter().collect();
    by_size.sort_by(|one, other| one.a.total_cmp(&other.a));
    let lower = [-3.0, -1.5, 0.0, 1.5, 3.0].iter().all(|psi| {
        let near = |map: &&Fates| {
            let off = |at: &[f64; 2]| (at[0] - psi).abs();
            let nearest = map
                .rests
                .iter()
                .min_by(|one, other| off(one).total_cmp(&off(other)));
            nearest.map_or(f64::NAN, |at| at[1])
        };
        by_size.windows(2).all(|two| near(&two[0]) > near(&two[1]))
    });
    plot = plot
        .says(["just above the solid one"], just)
        .says(["the larger A, the lower it runs"], lower);
    // Without a record the section is bare.
    let bare = || {
        let [psi, alpha] = axes();
        Panel::new(psi, alpha.range(0.0, 1.0)).height(240.0)
    };
    let last = list.last().map_or_else(bare, larger);
    plot.panel(last).figure(table)
}

fn larger(map: &Fates) -> Panel {
    let ends = |axis: usize| {
        let along = map.found.iter().map(|point| point[axis]);
        along.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
            (low.min(x), high.max(x))
        })
    };
    let (from, to) = ends(0);
    let (low, high) = ends(1);
    let room = 5e-4 * map.simulated.ends[1].1;
    let edge = |edge: &[[f64; 2]]| Curve::new(between(edge, (from, to))).ink();
    Panel::new(
        Axis::linear("ψ").range(from, to),
        Axis::linear("α").range(low - room, high + room),
    )
    .title(format!("A = {}, larger", map.a))
    .height(240.0)
    .curve(edge(&map.rests))
    .curve(edge(&map.escapes).dashed())
    .points(Points::new(&map.found).ink())
}

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

fn stops() -> Drawn {
    let mut runs = Vec::new();
    for rho in [0.3, 0.6, 0.8, 0.87] {
        let run = Run::new(&Start::put_down(rho)?, 20.0)?;
        let end = run.end().tau;
        runs.push((format!("ρ_0 = {rho}"), run, end));
    }
    let straight = straight_in(0.6, 0.4)?;
    let end = straight.stop().tau;
    runs.push(("'straight in'".to_owned(), straight.run, end));
    let mut table = Table::new(&["start", "tau", "p", "psi (rad)"]);
    let mut panel = Panel::new(Axis::log("p"), Axis::log("ψ")).height(300.0);
    for (n, (name, run, end)) in runs.into_iter().enumerate() {
        let near = (0..=100).map(|i| run.at(end * (1.0 - libm::exp10(-0.05 * f64::from(i)))));
        let mut states = near.collect::<Result<Vec<_>, _>>()?;
        states.extend(run.nodes().filter(|state| state.tau < end));
        states.sort_by(|a, b| a.tau.total_cmp(&b.tau));
        // Rounding turns a particle that comes straight in, but not before it is slower than this.
        states.retain(|state| state.p() > 1e-3);
        let rows = states
            .iter()
            .map(|state| [state.tau, state.p(), state.psi()]);
        table.rows(name.trim_matches('\''), rows)?;
        let curve = Curve::new(states.iter().map(|state| [state.p(), state.psi()]));
        let curve = curve.series(n).solid().arrows(&[0.5]);
        panel = panel.curve(curve.label_at(name, 0.8));
    }
    // Start, τ, p, ψ; the last one comes straight in.
    let groups = table.groups();
    let slope = |rows: &Vec<Vec<f64>>| match &rows[..] {
        [.., a, b] => libm::log(b[3] / a[3]) / libm::log(b[2] / a[2]),
        _ => f64::NAN,
    };
    let slopes: Vec<f64> = groups.iter().map(slope).collect();
    let alike = slopes
        .iter()
        .skip(1)
        .take(3)
        .all(|slope| (slope - 1.0).abs() < 0.1);
    let ends = groups
        .iter()
        .map(|rows| (rows[0][3], rows[rows.len() - 1][3]));
    let outwards = ends.clone().take(4).all(|(first, end)| end < 0.3 * first)
        && ends.clone().next_back().is_some_and(|(_, end)| end > 3.0);
    Ok(Plot::new("rest-turning", "The last moments before a stop")
        .caption(
            "The angle $\\psi$ from the velocity to the position against the speed $p$, for particles put down at rest in the laboratory, \
             at the distance $\\rho_0$, and one that slides straight in. The others stop with $\\psi\\to0$, moving {{outwards}}: the angle of \
             the one that stops below $\\sigma=\\frac12$ falls more {{slowly|quickly}} than the speed, those of the others in proportion to it. The one that \
             slides straight in stops with $\\psi\\to\\pi$.",
        )
        .alt(
            "Logarithmic axes. Four curves begin at the upper right, at a quarter turn, and fall to the lower left, three of them along \
             parallel lines and one along a flatter line. A fifth stays at half a turn.",
        )
        .says(["outwards"], outwards)
        .says(["slowly|quickly"], [alike && slopes[0] < 0.5, alike && slopes[0] > 1.5])
        .panel(panel)
        .figure(table)?)
}
