//! The figures of section 4, escape. All dimensionless: lengths in μg/Ω², times in 1/Ω.

use super::AllFiguresError;
use crate::claims::escape::growth::{LAG, Power, SIZE, SPEED, corrected_limits, printed_limits};
use crate::claims::escape::trajectories::{Flight, Late, Launch};
use crate::motion::MotionError;
use crate::motion::turntable::{self, State, critical_radius, inertial};
use std::f64::consts::TAU;
use trialbook::plotting::{
    Axis, Curve, Figure, FigureError, Marker, Panel, Plot, Points, Rule, Stroke, Table,
};

pub(super) fn figures() -> Result<Vec<Figure>, AllFiguresError> {
    let moments = moments()?;
    Ok(vec![
        growths(&moments)?,
        residuals(&moments)?,
        two_paths()?,
        ray()?,
    ])
}

/// A, α and ψ at the start of three escapes.
const LAUNCHES: [(f64, f64, f64); 3] = [(1.2, 0.3, 1.0), (2.0, 0.5, -1.0), (8.0, 1.0, 2.0)];

/// These, over seven decades of the time.
fn moments() -> Result<Vec<Vec<Late>>, AllFiguresError> {
    let all: Result<_, MotionError> = LAUNCHES
        .into_iter()
        .map(|(a, alpha, psi)| {
            let flight = Flight::new(Launch { a, alpha, psi }, 1e8)?;
            let times = (0..=140).map(|i| libm::pow(10.0, 1.0 + f64::from(i) / 20.0));
            times
                .map(|tau| {
                    Ok(Late {
                        tau,
                        state: flight.run.at(tau)?,
                        alpha_rate: f64::NAN,
                        a_rate: f64::NAN,
                    })
                })
                .collect::<Result<_, MotionError>>()
        })
        .collect();
    Ok(all?)
}

/// What the first correction leaves of their speeds.
fn residuals(moments: &[Vec<Late>]) -> Result<Figure, AllFiguresError> {
    let [limit, ..] = corrected_limits();
    let left = |late: &Late| [late.tau, (SPEED.over.1(late) / limit - 1.0) * late.tau];
    let escapes: Vec<Vec<_>> = moments
        .iter()
        .map(|one| one.iter().map(left).collect())
        .collect();
    Ok(residual(&escapes, SPEED.corrected_log())?)
}

/// Their growth.
fn growths(moments: &[Vec<Late>]) -> Result<Figure, AllFiguresError> {
    let [speed, size, lag] = corrected_limits();
    let [printed_speed, printed_size] = printed_limits();
    let followed = |of: &Power| {
        let (_, quantity) = of.over;
        let one = |moments: &Vec<Late>| moments.iter().map(|l| [l.tau, quantity(l)]).collect();
        moments.iter().map(one).collect()
    };
    Ok(compensated(&[
        Compensated {
            name: "p/tau^2",
            axis: "p/τ^2",
            range: (0.18, 0.26),
            printed: Some(printed_speed),
            corrected: speed,
            escapes: followed(&SPEED),
        },
        Compensated {
            name: "A/tau^(3/2)",
            axis: "A/τ^{3/2}",
            range: (0.34, 0.42),
            printed: Some(printed_size),
            corrected: size,
            escapes: followed(&SIZE),
        },
        Compensated {
            name: "(pi/2 - psi) tau",
            axis: "(π/2 − ψ) τ",
            range: (1.5, 3.0),
            printed: None,
            corrected: lag,
            escapes: followed(&LAG),
        },
    ])?)
}

/// Two particles put down at rest in the laboratory.
fn two_paths() -> Result<Figure, AllFiguresError> {
    let table = turntable::Table::default();
    let path = |rho: f64, until: f64, label: &str| -> Result<_, MotionError> {
        let start = State {
            t: 0.0,
            x: [rho, 0.0],
            v: [0.0; 2],
        };
        let run = inertial::run(&table, &start, until)?;
        let (mut on_table, mut in_laboratory) = (Vec::new(), Vec::new());
        for i in 0..=400 {
            let t = until * f64::from(i) / 400.0;
            let (seen, here) = (run.on_table(t)?, run.at(t)?);
            on_table.push([t, seen.x[0], seen.x[1]]);
            in_laboratory.push([t, here.x[0], here.x[1]]);
        }
        Ok(Path {
            label: label.into(),
            table: on_table,
            laboratory: in_laboratory,
        })
    };
    Ok(paths(&[
        path(0.86, 14.0, "ρ_0 = 0.86: rest")?,
        path(0.89, 14.0, "ρ_0 = 0.89: escape")?,
    ])?)
}

/// Particles put down along a ray, on both sides of the critical radius.
fn ray() -> Result<Figure, AllFiguresError> {
    let critical = critical_radius()?;
    let steps = [
        -0.5, -0.36, -0.24, -0.14, -0.06, -0.01, 0.001, 0.01, 0.05, 0.12, 0.24, 0.4,
    ];
    let ways = steps.map(|step| -> Result<_, MotionError> {
        let rho = critical + step;
        let start = State {
            t: 0.0,
            x: [rho, 0.0],
            v: [0.0; 2],
        };
        let run = inertial::run(&turntable::Table::default(), &start, 16.0)?;
        let rests = run.resting_place().is_some();
        // What happens at rest, or outside the picture, adds nothing.
        let end = run
            .stops()
            .last()
            .copied()
            .filter(|_| rests)
            .unwrap_or(16.0);
        let mut way = Vec::new();
        for i in 0..=120 {
            let t = end * f64::from(i) / 120.0;
            let seen = run.on_table(t)?;
            way.push([t, seen.x[0], seen.x[1]]);
            if seen.radius() > 4.5 {
                break;
            }
        }
        Ok(PutDown { rho, rests, way })
    });
    let ways = ways.into_iter().collect::<Result<Vec<_>, _>>()?;
    Ok(fan(&ways, critical)?)
}

/// A quantity over its power of the time, with the printed and the corrected limit.
#[derive(Debug, Clone, PartialEq)]
pub struct Compensated {
    /// Name in the table: `p/tau^2`.
    pub name: &'static str,
    /// Name on the axis.
    pub axis: &'static str,
    /// Ends of the axis.
    pub range: (f64, f64),
    /// The limit as printed, if it has one.
    pub printed: Option<f64>,
    /// The corrected limit.
    pub corrected: f64,
    /// (τ, value) along several escapes.
    pub escapes: Vec<Vec<[f64; 2]>>,
}

/// Compensated plots: each quantity over the power of τ by which it grows, against τ.
///
/// Fails as [`Plot::figure`] does.
pub fn compensated(quantities: &[Compensated]) -> Result<Figure, FigureError> {
    let mut table = Table::new(&["quantity", "escape", "tau", "value"]);
    let mut plot = Plot::new("escape-compensated", "How an escape grows")
        .caption(
            "Speed, size $A$ and angle of three escapes, each over the power of $\\tau$ by which it grows or \
             falls. A law with the right prefactor becomes a horizontal line. The motions pass the printed \
             values of speed and $A$ (dashed) on their way and settle on the corrected ones (solid). The printed \
             $\\pi/2-\\psi$ falls as $\\tau^{-1/2}$ and has no line here.",
        )
        .alt(
            "Three panels over the time from 10 to a hundred million, on a logarithmic axis. In each the three \
             curves join before ten thousand and run level along the line of the corrected value, above the \
             printed one where there is one.",
        );
    for quantity in quantities {
        let mut panel = Panel::new(
            Axis::log("τ"),
            Axis::linear(quantity.axis).range(quantity.range.0, quantity.range.1),
        )
        .height(230.0)
        .rule(
            Rule::horizontal(quantity.corrected)
                .stroke(Stroke::Solid)
                .key(format!("corrected: {:.6}", quantity.corrected)),
        );
        if let Some(printed) = quantity.printed {
            panel = panel.rule(Rule::horizontal(printed).key(format!("printed: {printed:.6}")));
        }
        for (n, escape) in quantity.escapes.iter().enumerate() {
            for [tau, value] in escape {
                let number = n as f64 + 1.0;
                table.row([
                    quantity.name.into(),
                    number.into(),
                    (*tau).into(),
                    (*value).into(),
                ])?;
            }
            let inside = |y: f64| y > quantity.range.0 && y < quantity.range.1;
            let points = escape
                .iter()
                .map(|&[x, y]| if inside(y) { [x, y] } else { [x, f64::NAN] });
            let mut curve = Curve::new(points).series(n);
            // Named once, where there is room.
            if let (None, Some((a, ..))) = (quantity.printed, LAUNCHES.get(n)) {
                curve = curve.key(format!("from A = {a}"));
            }
            panel = panel.curve(curve);
        }
        plot = plot.panel(panel);
    }
    plot.figure(table)
}

/// A path in one frame.
#[derive(Debug, Clone, PartialEq)]
pub struct Path {
    /// What becomes of the particle.
    pub label: String,
    /// (τ, x, y) on the table.
    pub table: Vec<[f64; 3]>,
    /// (τ, x, y) in the laboratory.
    pub laboratory: Vec<[f64; 3]>,
}

/// Two particles put down at rest in the laboratory, on either side of the critical radius.
///
/// Fails as [`Plot::figure`] does.
pub fn paths(paths: &[Path]) -> Result<Figure, FigureError> {
    let mut table = Table::new(&["path", "frame", "tau", "x", "y"]);
    let new = |title: &str| {
        Panel::new(
            Axis::linear("x").range(-2.2, 2.2),
            Axis::linear("y").range(-2.2, 2.2),
        )
        .title(title)
        .equal()
    };
    let mut panels = [new("'on the table'"), new("'in the laboratory'")];
    for (n, path) in paths.iter().enumerate() {
        for (panel, (frame, points)) in panels
            .iter_mut()
            .zip([("table", &path.table), ("laboratory", &path.laboratory)])
        {
            for [tau, x, y] in points {
                let head = [path.label.as_str().into(), frame.into()];
                table.row(
                    head.into_iter()
                        .chain([(*tau).into(), (*x).into(), (*y).into()]),
                )?;
            }
            let curve = Curve::new(points.iter().map(|&[_, x, y]| [x, y]));
            let curve = curve.series(n).arrows(&[0.5]).key(path.label.clone());
            *panel = panel.clone().curve(curve);
        }
    }
    let [on_table, in_laboratory] = panels;
    Plot::new("escape-paths", "Rest and escape, seen from the table and from the laboratory")
        .caption(
            "Two particles put down at rest in the laboratory, one just inside and one just outside the critical \
             radius. On the table both first slide backwards. One comes to rest there and rides in a circle ever \
             after; the other goes away.",
        )
        .alt(
            "Two panels. On the table two paths run together for a short way, backwards; then one ends and the \
             other bends outwards and leaves the panel. In the laboratory the first winds into a circle about the \
             axis, the second spirals out of the panel.",
        )
        .panel(on_table)
        .panel(in_laboratory)
        .figure(table)
}

/// A particle put down on the table, and the way that it takes there.
#[derive(Debug, Clone, PartialEq)]
pub struct PutDown {
    /// Distance from the axis.
    pub rho: f64,
    /// True if it comes to rest.
    pub rests: bool,
    /// (τ, x, y) on the table.
    pub way: Vec<[f64; 3]>,
}

/// Rays along which the particles of [`fan`] are put down.
const RAYS: u32 = 12;

/// Particles put down at rest in the laboratory along rays, and what becomes of them on the table; `critical` is the
/// radius that parts them. The ways are those along one ray; the others are the same, turned.
///
/// Fails as [`Plot::figure`] does.
pub fn fan(ways: &[PutDown], critical: f64) -> Result<Figure, FigureError> {
    let mut table = Table::new(&["rho_0", "fate", "tau", "x", "y"]);
    let axis = |name| Axis::linear(name).range(-3.0, 3.0);
    let turned = |[x, y]: [f64; 2], ray: u32| {
        let (s, c) = libm::sincos(TAU * f64::from(ray) / f64::from(RAYS));
        [c * x - s * y, s * x + c * y]
    };
    let circle = (0..=180).map(|i| libm::sincos(TAU * f64::from(i) / 180.0));
    let circle = circle.map(|(s, c)| [critical * c, critical * s]);
    let mut panel = Panel::new(axis("x"), axis("y")).equal().curve(
        Curve::new(circle)
            .ink()
            .stroke(Stroke::Dotted)
            .key("critical radius"),
    );
    let mut ends = Vec::new();
    for (rests, words) in [(true, "rest"), (false, "escape")] {
        for (n, way) in ways.iter().filter(|way| way.rests == rests).enumerate() {
            for [tau, x, y] in &way.way {
                let cells = [
                    way.rho.into(),
                    words.into(),
                    (*tau).into(),
                    (*x).into(),
                    (*y).into(),
                ];
                table.row(cells)?;
            }
            for ray in 0..RAYS {
                let points = way.way.iter().map(|&[_, x, y]| turned([x, y], ray));
                let curve = Curve::new(points).series(usize::from(!rests));
                let curve = curve.stroke(Stroke::Solid).width(1.3);
                let first = n == 0 && ray == 0;
                panel = panel.curve(if first { curve.key(words) } else { curve });
                let end = way.way.last().filter(|_| rests);
                ends.extend(end.map(|&[_, x, y]| turned([x, y], ray)));
            }
        }
    }
    Plot::new("escape-fan", "Put down on a turning record")
        .caption(
            "Particles put down, at rest in the laboratory, on a turning table, along twelve rays, and the paths that they follow on it. \
             Friction carries the inner ones along: where the dots are they rest. The outer ones slide off. Next to \
             the critical radius a hair's breadth decides. Lengths in units of $\\mu g/\\Omega^2$.",
        )
        .alt(
            "A wheel of twelve sheaves of curves. In each the inner curves are short and end in dots within a dotted \
             circle, the outer ones sweep backwards around it in widening arcs and leave the picture.",
        )
        .panel(panel.points(Points::new(ends).series(0).marker(Marker::Disc).size(3.5)))
        .figure(table)
}

/// What is left of the speed of several escapes once the leading law is taken off, over 1/τ: it falls along a line in ln τ.
///
/// Fails as [`Plot::figure`] does.
pub fn residual(escapes: &[Vec<[f64; 2]>], slope: f64) -> Result<Figure, FigureError> {
    let mut table = Table::new(&["escape", "tau", "(3 sqrt(2) p/tau^2 - 1) tau"]);
    let mut panel = Panel::new(Axis::log("τ"), Axis::linear("(3√2 p/τ^2 − 1) τ")).height(300.0);
    for (n, escape) in escapes.iter().enumerate() {
        for [tau, value] in escape {
            table.row([(n as f64 + 1.0).into(), (*tau).into(), (*value).into()])?;
        }
        panel = panel.curve(
            Curve::new(escape.iter().copied())
                .series(n)
                .stroke(Stroke::Solid),
        );
    }
    // Through the last point of the first escape.
    if let Some([end, value]) = escapes.first().and_then(|escape| escape.last()).copied() {
        let line = [1e1, end].map(|tau| [tau, value + slope * libm::log(tau / end)]);
        let key = format!("slope {slope:.6} per unit of ln τ");
        panel = panel.curve(Curve::new(line).ink().stroke(Stroke::Dashed).key(key));
    }
    Plot::new("escape-residual", "The logarithm in an escape")
        .caption(
            "How much the speed of three escapes differs from $\\tau^2/(3\\sqrt2)$, relative to it and times $\\tau$. An expansion in powers \
             of $1/\\tau$ would end in horizontal lines. In fact the curves end in parallel lines with the slope $-\\frac{3\\sqrt2}2$ in \
             $\\ln\\tau$ (dashed): the escape lags by a time that grows as the logarithm. Each escape has a shift of time of its \
             own; two lines are apart by twice the difference of their shifts.",
        )
        .alt(
            "Three curves over the time from 10 to a hundred million on a logarithmic axis. After a short transient they fall \
             along straight parallel lines; a dashed line has the same slope.",
        )
        .panel(panel)
        .figure(table)
}
