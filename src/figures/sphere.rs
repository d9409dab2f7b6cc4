//! The figures of section 3: a sphere that slides and rolls.

use super::Drawn;
use crate::claims::{
    sphere::angle,
    sphere::driven::{self, Swinging},
};
use crate::motion::{
    MotionError,
    sphere::{Sphere, Turning},
    turntable::{State, Table as Turntable, inertial},
};
use std::f64::consts::{PI, TAU};
use trialbook::plotting::{Area, Axis, Curve, Figure, FigureError, Panel, Plot, Points, Table};

/// λ₀ below λ_c, between λ_c and 1, above 1.
const LAMBDAS: [f64; 3] = [0.3, 0.75, 1.2];

pub(super) fn figures() -> Drawn<Vec<Figure>> {
    let motions: Result<Vec<_>, _> = LAMBDAS.into_iter().map(driven::swinging).collect();
    Ok(vec![
        times(&angle::times_over_printed()?)?,
        swinging(&motions?)?,
        let_go(&ball()?, &coin()?)?,
    ])
}

/// Where a ball and a coin ride with the table, in units of μg/Ω²: the coin's friction does not suffice for it.
const RIDES: f64 = 1.2;
const SHOWN: u32 = 180;
const EDGE: f64 = 8.0;

/// (τ, x, y) of the ball that is let go, until it is back.
fn ball() -> Result<Vec<[f64; 3]>, MotionError> {
    let (solid, turning) = (
        Sphere::with_kappa(0.4),
        Turning {
            omega: 1.0,
            pull: [0.0; 2],
        },
    );
    let lasts = 3.5 * TAU;
    let path = turning.roll(&solid, [[RIDES, 0.0], [0.0, RIDES]], lasts)?;
    let times = (0..=SHOWN).map(|i| lasts * f64::from(i) / f64::from(SHOWN));
    Ok(times
        .map(|t| path.at(t).map(|[x, y, ..]| [t, x, y]))
        .collect::<Result<_, _>>()?)
}

/// (τ, x, y) of the coin, until it has left the picture.
fn coin() -> Result<Vec<[f64; 3]>, MotionError> {
    let start = State {
        t: 0.0,
        x: [RIDES, 0.0],
        v: [0.0, RIDES],
    };
    let lasts = 10.0;
    let path = inertial::run(&Turntable::default(), &start, lasts)?;
    let times = (0..=SHOWN).map(|i| lasts * f64::from(i) / f64::from(SHOWN));
    let points = times.map(|t| path.at(t).map(|at| [t, at.x[0], at.x[1]]));
    let mut points = points.collect::<Result<Vec<_>, _>>()?;
    points.retain(|[_, x, y]| x.abs().max(y.abs()) <= EDGE);
    Ok(points)
}

/// In the laboratory, of a solid ball and of a coin that rode with a turntable and were let go: (τ, x, y).
pub(super) fn let_go(ball: &[[f64; 3]], coin: &[[f64; 3]]) -> Result<Figure, FigureError> {
    let mut table = Table::new(&["body", "tau", "x", "y"]);
    let axis = |name| Axis::linear(name).range(-EDGE, EDGE);
    let mut panel = Panel::new(axis("x"), axis("y")).equal();
    for (n, (body, path)) in [("ball", ball), ("coin", coin)].into_iter().enumerate() {
        table.rows(body, path)?;
        let curve = Curve::new(path.iter().map(|&[_, x, y]| [x, y]));
        panel = panel.curve(curve.series(n).solid().key(body));
    }
    Plot::new("sphere-turntable", "A ball and a coin let go on a turntable")
        .caption(
            "A solid ball and a coin that ride with the table at $\\rho=1.2$ and are let go, seen from the laboratory. \
             The ball rolls round a circle of $\\frac72$ times that radius, about a point beyond the axis, once in $\\frac72$ turns \
             of the table. The coin slides, and spirals away. Lengths in units of $\\mu g/\\Omega^2$.",
        )
        .alt(
            "Two curves from a point to the right of the axis. One is a closed circle, most of it to the left of the axis, \
             the other winds outwards and leaves the picture.",
        )
        .panel(panel.points(Points::new([[0.0, 0.0]]).ink().size(3.0)))
        .figure(table)
}

/// Slip and velocity of the centre against the phase, one panel for each λ₀.
pub(super) fn swinging(motions: &[Swinging]) -> Result<Figure, FigureError> {
    let mut table = Table::new(&[
        "lambda_0",
        "phi (rad)",
        "slip (A_0/omega)",
        "centre less mean (A_0/omega)",
    ]);
    let mut plot = Plot::new("sphere-swinging", "A solid sphere on a swinging plane")
        .caption(
            "Slip $w_x$ of the lowest point ({{line slip}}) and velocity $v_x$ of the centre without its mean ({{line centre}}) of \
             a solid sphere over two late periods of the plane, in units of $A_0/\\varpi$; grey where it rolls. \
             From the top: $\\lambda_0=0.3$, slip all the time but for two instants per period; $0.75$, two \
             intervals of rolling; $1.2$, rolling throughout.",
        )
        .alt(
            "Three panels against the phase from 0 to 4π. In the first the slip passes through zero twice per period. \
             In the second it stays at zero for two intervals per period, shaded. In the third it is zero throughout \
             and the whole panel is shaded. The centre swings in all three.",
        );
    for (n, motion) in motions.iter().enumerate() {
        table.rows(motion.lambda, &motion.points)?;
        let phases = [0, 1, 2, 3, 4].map(|k| {
            let name = ["0", "π", "2π", "3π", "4π"][k];
            (k as f64 * PI, name)
        });
        let mut panel = Panel::new(
            Axis::linear("φ").range(0.0, 4.0 * PI).ticks(phases),
            Axis::linear("'velocity' (A_0/ϖ)").range(-1.0, 1.0),
        )
        .title(format!("λ_0 = {}", motion.lambda))
        .height(210.0);
        for [from, to] in &motion.rolls {
            let corners = [[*from, -1.0], [*to, -1.0], [*to, 1.0], [*from, 1.0]];
            panel = panel.area(Area::new(corners).ink().opacity(0.12));
        }
        let against = |k: usize| motion.points.iter().map(move |p| [p[0], p[k]]);
        let mut slip = Curve::new(against(1)).series(0).solid();
        let mut centre = Curve::new(against(2)).series(1).dashed();
        if n == 0 {
            slip = slip.key("slip");
            centre = centre.key("centre");
        }
        plot = plot.panel(panel.curve(slip).curve(centre));
    }
    plot.figure(table)
}

/// The time of the motion over that of (82) against γ, with the lines 1 (as printed) and 1/γ (as corrected);
/// `points` are (γ, ratio).
pub(super) fn times(points: &[[f64; 2]]) -> Result<Figure, FigureError> {
    let mut table = Table::new(&["gamma", "tau of the motion over (82)"]);
    table.rows((), points)?;
    let (low, high) = points
        .iter()
        .fold((1.0_f64, 1.0_f64), |(low, high), [g, _]| {
            (low.min(*g), high.max(*g))
        });
    let panel = Panel::new(Axis::log("γ"), Axis::log("τ/'(82)'"))
        .curve(
            Curve::new([[low, 1.0], [high, 1.0]])
                .series(1)
                .dashed()
                .label_at("as printed: 1", 0.2),
        )
        .curve(
            Curve::new([[low, 1.0 / low], [high, 1.0 / high]])
                .series(0)
                .solid()
                .label_at("as corrected: 1/γ", 0.75),
        )
        .points(Points::new(points).ink().size(3.0));
    Plot::new("sphere-times", "The factor that (82) lacks")
        .caption(
            "The time $\\tau$ that a sphere in three dimensions takes to turn its slip from $\\theta_0$ to $\\theta$, \
             over the value of (82) as printed, against $\\gamma=A/(\\mu g)$: one point for each sphere of the trial.",
        )
        .alt(
            "Points on logarithmic axes, all on the {{falling line 1/γ}}; they meet the horizontal line 1 only at γ = 1.",
        )
        .says(["falling line 1/γ"], points.iter().all(|[gamma, ratio]| (ratio * gamma - 1.0).abs() < 1e-6))
        .panel(panel)
        .figure(table)
}
