//! The figures of section 4 up to (125): motions on the turntable, their energy, and the quasi-fixed point.
//!
//! Dimensionless throughout: lengths in μg/Ω², times in 1/Ω.

use std::f64::consts::PI;
use trialbook::figures::{
    Axis, Curve, Figure, FigureError, Marker, Panel, Plot, Points, Rule, Stroke, Table,
};

/// A particle launched from the axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Launch {
    /// Its speed.
    pub speed: f64,
    /// (τ, x and y on the table, X and Y in the laboratory, p, ρ, s), in order of time.
    pub points: Vec<[f64; 8]>,
    /// When it comes to rest on the table, if it does.
    pub rest: Option<f64>,
}

/// How far from the axis the paths are shown.
const SHOWN: f64 = 2.5;

/// Paths of the launches, on the table above and in the laboratory below.
///
/// Fails as [`Plot::figure`] does, thus when there is no finite point in a panel.
pub fn paths(launches: &[Launch]) -> Result<Figure, FigureError> {
    let mut table = Table::new(&[
        "launch speed (mu g/Omega)",
        "tau",
        "x on the table (mu g/Omega^2)",
        "y on the table (mu g/Omega^2)",
        "X in the laboratory (mu g/Omega^2)",
        "Y in the laboratory (mu g/Omega^2)",
    ]);
    for launch in launches {
        for [tau, x, y, bx, by, ..] in &launch.points {
            let row = [tau, x, y, bx, by].map(|value| value.into());
            table.row([launch.speed.into()].into_iter().chain(row))?;
        }
    }
    let panel = |title: &str, at: usize, labels: [&str; 2]| {
        let axis = |label: &str| Axis::linear(label).range(-SHOWN, SHOWN);
        let mut panel = Panel::new(axis(labels[0]), axis(labels[1]))
            .title(title)
            .equal();
        for (n, launch) in launches.iter().enumerate() {
            let place = |p: &[f64; 8]| [p[at], p[at + 1]];
            let label = format!("p = {} at the start", launch.speed);
            panel = panel.curve(
                Curve::new(launch.points.iter().map(place))
                    .series(n)
                    .arrows(&[0.5])
                    .key(label),
            );
            if let Some(rest) = launch.rest {
                let stopped = launch.points.iter().find(|p| p[0] >= rest).map(place);
                let disc = Points::new(stopped)
                    .series(n)
                    .marker(Marker::Disc)
                    .size(4.5);
                panel = panel.points(disc.key("rest on the table"));
            }
        }
        panel.points(Points::new([[0.0, 0.0]]).ink().size(2.5).label("axis"))
    };
    Plot::new("turntable-paths", "Two launches from the axis of a turntable")
        .caption(
            "Two particles, launched from the axis with different speeds (in units of $\\mu g/\\Omega$). \
             (a) On the table both curve to the right; the slower one comes to rest, the faster one spirals \
             outwards for ever. (b) The same in the laboratory, where friction is the only force: once at rest \
             on the table, the slower one is carried round in a circle.",
        )
        .alt(
            "Two panels with equal axes. In the first, on the table, both curves leave the axis to the right and bend \
             clockwise; the short one ends in a disc, the long one winds outwards. In the second, in the laboratory, \
             the short one runs into a circle about the axis, the long one winds outwards \
             counterclockwise.",
        )
        .panel(panel("'(a)'\u{2003}on the table", 1, ["Ω^2x/(μg)", "Ω^2y/(μg)"]))
        .panel(panel("'(b)'\u{2003}in the laboratory", 3, ["Ω^2X/(μg)", "Ω^2Y/(μg)"]))
        .figure(table)
}

/// The terms of (104) along one launch.
///
/// Fails as [`Plot::figure`] does, thus when there is no finite point.
pub fn energy(launch: &Launch) -> Result<Figure, FigureError> {
    let mut table = Table::new(&["tau", "p^2/2", "-rho^2/2", "s", "sum"]);
    let rows: Vec<[f64; 5]> = launch
        .points
        .iter()
        .take_while(|p| p[0] <= launch.rest.unwrap_or(f64::INFINITY) + 0.3)
        .map(|&[tau, .., p, rho, s]| {
            let (kinetic, centrifugal) = (0.5 * p * p, -0.5 * rho * rho);
            [tau, kinetic, centrifugal, s, kinetic + centrifugal + s]
        })
        .collect();
    for row in &rows {
        table.row(row.map(|value| value.into()))?;
    }
    let mut panel = Panel::new(Axis::linear("τ"), Axis::linear("energy in m(μg)^2/Ω^2"));
    for (n, label) in ["p^2/2", "−ρ^2/2", "s"].into_iter().enumerate() {
        let curve = rows.iter().map(|row| [row[0], row[n + 1]]);
        panel = panel.curve(Curve::new(curve).series(n).label_at(label, 0.55));
    }
    let sum = rows.iter().map(|row| [row[0], row[4]]);
    panel = panel.curve(Curve::new(sum).ink().label_at("sum", 0.8));
    if let Some(rest) = launch.rest {
        panel = panel.rule(Rule::vertical(rest).stroke(Stroke::Dotted).label("rest"));
    }
    Plot::new("turntable-energy", "Energy on the turntable")
        .caption(
            "The three terms of (104) for the launch that comes to rest: kinetic energy relative to the \
             table, potential energy of the centrifugal force, and what friction has taken, which is the arc \
             length $s$ in these units. Their sum stays the same.",
        )
        .alt(
            "Three curves against time: the kinetic energy falls to zero, the centrifugal energy falls from \
             zero to a negative value, the arc length rises; their sum is a horizontal line.",
        )
        .panel(panel)
        .figure(table)
}

/// How ψ follows ψ₁ in one escape.
#[derive(Debug, Clone, PartialEq)]
pub struct Following {
    /// A at the start.
    pub a: f64,
    /// (τ, ψ, ψ₁, (π/2 − ψ)/(π/2 − ψ₁)) in order of time; angles in radians.
    pub points: Vec<[f64; 4]>,
}

/// ψ and ψ₁ against time in escapes, and what is left of each to π/2.
///
/// Fails as [`Plot::figure`] does, thus when there is no finite point.
pub fn following(escapes: &[Following]) -> Result<Figure, FigureError> {
    let mut table = Table::new(&[
        "A at the start",
        "tau",
        "psi (rad)",
        "psi_1 (rad)",
        "(pi/2-psi)/(pi/2-psi_1)",
    ]);
    for escape in escapes {
        for point in &escape.points {
            let row = point.map(|value| value.into());
            table.row([escape.a.into()].into_iter().chain(row))?;
        }
    }
    let quarters = [
        (0.0, "0"),
        (PI / 4.0, "π/4"),
        (PI / 2.0, "π/2"),
        (0.75 * PI, ""),
    ];
    let mut angles = Panel::new(
        Axis::log("τ"),
        Axis::linear("ψ, ψ_1").range(0.0, 0.75 * PI).ticks(quarters),
    );
    let mut ratios = Panel::new(
        Axis::log("τ"),
        Axis::linear("(π/2 − ψ)/(π/2 − ψ_1)").range(0.0, 2.0),
    );
    for (n, escape) in escapes.iter().enumerate() {
        let against_time = |k: usize| escape.points.iter().map(move |p| [p[0], p[k]]);
        let key = |what: &str| format!("{what}, A = {} at the start", escape.a);
        angles = angles
            .curve(Curve::new(against_time(1)).series(n).key(key("ψ")))
            .curve(Curve::new(against_time(2)).series(n).width(0.8));
        ratios = ratios.curve(Curve::new(against_time(3)).series(n));
    }
    let follows = Rule::horizontal(1.0).stroke(Stroke::Dotted);
    Plot::new("turntable-following", "How the angle follows its quasi-fixed point")
        .caption(
            "Three escapes. First $\\psi$ (thick) and, at the $\\alpha$ of the same moment, $\\psi_1$ \
             (thin). Both tend to $\\pi/2$. Then what $\\psi$ lacks of $\\pi/2$ over what $\\psi_1$ lacks. \
             Were $\\psi_1$ followed, this ratio would tend to 1 (dotted line).",
        )
        .alt(
            "Two panels against time on a logarithmic axis. In the first, thick and thin curves rise together to \
             a quarter turn. In the second, all three ratios settle at about 1.41, above the dotted line at 1.",
        )
        .panel(angles)
        .panel(ratios.rule(follows.label("followed")))
        .figure(table)
}
