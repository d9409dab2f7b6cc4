//! The figures of section 4, escape. All dimensionless: lengths in μg/Ω², times in 1/Ω.

use super::{AllFiguresError, Drawn, trend::sides};
use crate::claims::{
    escape::growth::{LAG, Power, SIZE, SPEED, corrected_limits, printed_limits},
    escape::trajectories::{Flight, Late, Launch},
};
use crate::motion::{
    MotionError,
    turntable::{self, State, critical_radius, inertial},
};
use std::f64::consts::{SQRT_2, TAU};
use trialbook::plotting::{
    Axis, Curve, Figure, FigureError, Marker, Panel, Plot, Points, Rule, Table,
};

pub(super) fn figures() -> Drawn<Vec<Figure>> {
    let moments = moments()?;
    Ok(vec![
        growths(&moments)?,
        residuals(&moments)?,
        paths()?,
        ray()?,
    ])
}

/// A, α and ψ at the start of three escapes.
const LAUNCHES: [(f64, f64, f64); 3] = [(1.2, 0.3, 1.0), (2.0, 0.5, -1.0), (8.0, 1.0, 2.0)];

/// Of these, over seven decades of the time.
fn moments() -> Drawn<Vec<Vec<Late>>> {
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

fn growths(moments: &[Vec<Late>]) -> Drawn {
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

/// Over its power of the time, with the printed and the corrected limit.
pub(super) struct Compensated {
    /// In the table: `p/tau^2`.
    pub name: &'static str,
    pub axis: &'static str,
    pub range: (f64, f64),
    /// If it has one.
    pub printed: Option<f64>,
    pub corrected: f64,
    /// (τ, value) along several escapes.
    pub escapes: Vec<Vec<[f64; 2]>>,
}

/// Each quantity over the power of τ by which it grows, against τ.
pub(super) fn compensated(quantities: &[Compensated]) -> Result<Figure, FigureError> {
    let mut table = Table::new(&["quantity", "escape", "tau", "value"]);
    let mut plot = Plot::new("escape-compensated", "How an escape grows")
        .caption(
            "Speed, size $A$ and angle of three escapes, each over the power of $\\tau$ by which it grows or \
             falls. A law with the right prefactor becomes a horizontal line. The motions pass the printed \
             values of speed and $A$ ({{line printed}}) on their way and {{settle on}} the corrected ones ({{line corrected}}). The printed \
             $\\pi/2-\\psi$ falls as $\\tau^{-1/2}$ and has no line here.",
        )
        .alt(
            "Three panels over the time from 10 to a hundred million, on a logarithmic axis. In each the three \
             curves join before ten thousand and run level along the line of the corrected value, {{below|above}} the \
             printed one where there is one.",
        );
    let settle = quantities.iter().all(|of| {
        let end = of.escapes.last().and_then(|escape| escape.last());
        end.is_some_and(|end| (end[1] - of.corrected).abs() < 1e-5)
    });
    let beside = quantities
        .iter()
        .filter_map(|of| Some(of.corrected - of.printed?));
    plot = plot
        .says(["settle on"], settle)
        .says(["below|above"], sides(beside, 0.0));
    for quantity in quantities {
        let mut panel = Panel::new(
            Axis::log("τ"),
            Axis::linear(quantity.axis).range(quantity.range.0, quantity.range.1),
        )
        .height(230.0)
        .rule(
            Rule::horizontal(quantity.corrected)
                .solid()
                .key(format!("corrected: {:.6}", quantity.corrected)),
        );
        if let Some(printed) = quantity.printed {
            panel = panel.rule(Rule::horizontal(printed).key(format!("printed: {printed:.6}")));
        }
        for (n, escape) in quantity.escapes.iter().enumerate() {
            table.rows((quantity.name, n as f64 + 1.0), escape)?;
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

/// At rest in the laboratory.
fn put_down(rho: f64, until: f64) -> Result<turntable::Path, MotionError> {
    let start = State {
        t: 0.0,
        x: [rho, 0.0],
        v: [0.0; 2],
    };
    inertial::run(&turntable::Table::default(), &start, until)
}

/// On either side of the critical radius.
fn paths() -> Drawn {
    let mut table = Table::new(&["path", "frame", "tau", "x", "y"]);
    let axis = |name| Axis::linear(name).range(-2.2, 2.2);
    let new = |title: &str| Panel::new(axis("x"), axis("y")).title(title).equal();
    let mut panels = [new("'on the table'"), new("'in the laboratory'")];
    let starts = [(0.86, "ρ_0 = 0.86: rest"), (0.89, "ρ_0 = 0.89: escape")];
    let (mut first, mut circles) = (Vec::new(), false);
    for (n, (rho, label)) in starts.into_iter().enumerate() {
        let run = put_down(rho, 14.0)?;
        let mut ways = [Vec::new(), Vec::new()];
        for i in 0..=400 {
            let t = 14.0 * f64::from(i) / 400.0;
            for (way, seen) in ways.iter_mut().zip([run.on_table(t)?, run.at(t)?]) {
                way.push((t, seen.x));
            }
        }
        first.extend(ways[0].get(1).map(|(_, x)| x[1]));
        if let (true, Some([from, .., to])) = (n == 0, ways[1].get(381..)) {
            let distance = |[x, y]: [f64; 2]| libm::hypot(x, y);
            let moved = distance([0, 1].map(|k| to.1[k] - from.1[k]));
            circles = (distance(from.1) - distance(to.1)).abs() < 1e-6 && moved > 0.1;
        }
        for ((panel, frame), way) in panels.iter_mut().zip(["table", "laboratory"]).zip(&ways) {
            table.rows((label, frame), way)?;
            let curve = Curve::new(way.iter().map(|(_, x)| x));
            let curve = curve.series(n).arrows(&[0.5]).key(label);
            *panel = panel.clone().curve(curve);
        }
    }
    let [on_table, in_laboratory] = panels;
    Ok(Plot::new("escape-paths", "Rest and escape, seen from the table and from the laboratory")
        .caption(
            "Two particles put down at rest in the laboratory, one just inside and one just outside the critical \
             radius. On the table both first slide {{backwards|forwards}}. One comes to rest there and rides in a {{circle}} ever \
             after; the other goes away.",
        )
        .alt(
            "Two panels. On the table two paths run together for a short way, backwards; then one ends and the \
             other bends outwards and leaves the panel. In the laboratory the first winds into a circle about the \
             axis, the second spirals out of the panel.",
        )
        // The table turns counterclockwise: what stays behind goes towards negative y.
        .says(["backwards|forwards"], sides(first.into_iter(), 0.0))
        .says(["circle"], circles)
        .panel(on_table)
        .panel(in_laboratory)
        .figure(table)?)
}

const RAYS: u32 = 12;

/// Put down at rest in the laboratory, on both sides of the critical radius. They are followed along one ray; the
/// others are the same, turned.
fn ray() -> Drawn {
    let critical = critical_radius()?;
    let mut table = Table::new(&["rho_0", "fate", "tau", "x", "y"]);
    let axis = |name| Axis::linear(name).range(-3.0, 3.0);
    let turned = |[x, y]: [f64; 2], ray: u32| {
        let (s, c) = libm::sincos(TAU * f64::from(ray) / f64::from(RAYS));
        [c * x - s * y, s * x + c * y]
    };
    let circle = (0..=180).map(|i| libm::sincos(TAU * f64::from(i) / 180.0));
    let circle = circle.map(|(s, c)| [critical * c, critical * s]);
    let circle = Curve::new(circle).ink().dotted().key("critical radius");
    let mut panel = Panel::new(axis("x"), axis("y")).equal().curve(circle);
    let mut ends = Vec::new();
    let inner = [-0.5, -0.36, -0.24, -0.14, -0.06, -0.01];
    let outer = [0.001, 0.01, 0.05, 0.12, 0.24, 0.4];
    for (rests, words, steps) in [(true, "rest", inner), (false, "escape", outer)] {
        for (n, step) in steps.into_iter().enumerate() {
            let rho = critical + step;
            let run = put_down(rho, 16.0)?;
            if run.resting_place().is_some() != rests {
                return Err(AllFiguresError::Data(format!("ρ₀ = {rho} is no {words}")));
            }
            // What happens at rest, or outside the picture, adds nothing.
            let stop = run.stops().last().copied().filter(|_| rests);
            let end = stop.unwrap_or(16.0);
            let mut way = Vec::new();
            for i in 0..=120 {
                let t = end * f64::from(i) / 120.0;
                let seen = run.on_table(t)?;
                way.push((t, seen.x));
                if seen.radius() > 4.5 {
                    break;
                }
            }
            table.rows((rho, words), &way)?;
            for ray in 0..RAYS {
                let points = way.iter().map(|(_, x)| turned(*x, ray));
                let curve = Curve::new(points).series(usize::from(!rests));
                let curve = curve.solid().width(1.3);
                let first = n == 0 && ray == 0;
                panel = panel.curve(if first { curve.key(words) } else { curve });
                let end = way.last().filter(|_| rests);
                ends.extend(end.map(|(_, x)| turned(*x, ray)));
            }
        }
    }
    let of = |fate: &str| {
        let rows = table.cells().iter().filter(move |row| row[1] == fate);
        rows.filter_map(|row| row[0].parse::<f64>().ok())
            .collect::<Vec<_>>()
    };
    let inside = |inner: &str, outer: &str| {
        let (inner, outer) = (of(inner), of(outer));
        !inner.is_empty()
            && !outer.is_empty()
            && inner
                .iter()
                .all(|rho| outer.iter().all(|other| rho < other))
    };
    Ok(Plot::new("escape-fan", "Put down on a turning record")
        .caption(
            "Particles put down, at rest in the laboratory, on a turning table, along twelve rays, and the paths that they follow on it. \
             Friction carries the {{inner|outer}} ones along: where the dots are they rest. The {{outer|inner}} ones slide off. Next to \
             the critical radius a hair's breadth decides. Lengths in units of $\\mu g/\\Omega^2$.",
        )
        .alt(
            "A wheel of twelve sheaves of curves. In each the inner curves are short and end in dots within a dotted \
             circle, the outer ones sweep backwards around it in widening arcs and leave the picture.",
        )
        .says(["inner|outer", "outer|inner"], [inside("rest", "escape"), inside("escape", "rest")])
        .panel(panel.points(Points::new(ends).series(0).marker(Marker::Disc).size(3.5)))
        .figure(table)?)
}

/// What is left of the speed of the escapes once the leading law is taken off, over 1/τ: it falls along a line in ln τ.
fn residuals(moments: &[Vec<Late>]) -> Drawn {
    let ([limit, ..], slope) = (corrected_limits(), SPEED.corrected_log());
    let left = |late: &Late| [late.tau, (SPEED.over.1(late) / limit - 1.0) * late.tau];
    let mut table = Table::new(&["escape", "tau", "(3 sqrt(2) p/tau^2 - 1) tau"]);
    let mut panel = Panel::new(Axis::log("τ"), Axis::linear("(3√2 p/τ^2 − 1) τ")).height(300.0);
    for (n, moments) in moments.iter().enumerate() {
        let left = moments.iter().map(left);
        table.rows(n as f64 + 1.0, left.clone())?;
        panel = panel.curve(Curve::new(left).series(n).solid());
    }
    let straight = table.groups().iter().all(|rows| {
        let late = rows[rows.len().saturating_sub(40)..].windows(2);
        let slope = |two: &[Vec<f64>]| (two[1][2] - two[0][2]) / libm::log(two[1][1] / two[0][1]);
        late.map(slope).all(|of| (of + 1.5 * SQRT_2).abs() < 0.01)
    });
    if let Some(last) = moments.first().and_then(|moments| moments.last()) {
        let [end, value] = left(last);
        let line = [1e1, end].map(|tau| [tau, value + slope * libm::log(tau / end)]);
        let key = format!("slope {slope:.6} per unit of ln τ");
        panel = panel.curve(Curve::new(line).ink().dashed().key(key));
    }
    Ok(Plot::new("escape-residual", "The logarithm in an escape")
        .caption(
            "How much the speed of three escapes differs from $\\tau^2/(3\\sqrt2)$, relative to it and times $\\tau$. An expansion in powers \
             of $1/\\tau$ would end in horizontal lines. In fact the curves end in parallel lines with the slope $-\\frac{3\\sqrt2}2$ in \
             $\\ln\\tau$ ({{line slope}}): the escape lags by a time that grows as the logarithm. Each escape has a shift of time of its \
             own; two lines are apart by twice the difference of their shifts.",
        )
        .alt(
            "Three curves over the time from 10 to a hundred million on a logarithmic axis. After a short transient they {{fall \
             along straight parallel lines}}; a {{line slope}} line has the same slope.",
        )
        .says(["fall along straight parallel lines"], straight)
        .panel(panel)
        .figure(table)?)
}
