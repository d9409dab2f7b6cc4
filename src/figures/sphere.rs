//! The figures of section 3: a sphere that slides and rolls.

use super::AllFiguresError;
use crate::claims::sphere::angle;
use crate::claims::sphere::driven::{self, Swinging};
use std::f64::consts::PI;
use trialbook::figures::{
    Area, Axis, Curve, Figure, FigureError, Panel, Plot, Points, Stroke, Table,
};

/// λ₀ below λ_c, between λ_c and 1, above 1.
const LAMBDAS: [f64; 3] = [0.3, 0.75, 1.2];

pub(super) fn figures() -> Result<Vec<Figure>, AllFiguresError> {
    let motions: Result<Vec<_>, _> = LAMBDAS.into_iter().map(driven::swinging).collect();
    Ok(vec![
        times(&angle::times_over_printed()?)?,
        swinging(&motions?)?,
    ])
}

/// Slip and velocity of the centre against the phase, one panel for each λ₀.
///
/// Fails as [`Plot::figure`] does, thus when there is no finite point in a panel.
pub fn swinging(motions: &[Swinging]) -> Result<Figure, FigureError> {
    let mut table = Table::new(&[
        "lambda_0",
        "phi (rad)",
        "slip (A_0/omega)",
        "centre less mean (A_0/omega)",
    ]);
    let mut plot = Plot::new("sphere-swinging", "A solid sphere on a swinging plane")
        .caption(
            "Slip $w_x$ of the lowest point (solid) and velocity $v_x$ of the centre without its mean (dashed) of \
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
        for [phi, slip, v] in &motion.points {
            table.row([motion.lambda.into(), phi.into(), slip.into(), v.into()])?;
        }
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
        let mut slip = Curve::new(against(1)).series(0).stroke(Stroke::Solid);
        let mut centre = Curve::new(against(2)).series(1).stroke(Stroke::Dashed);
        if n == 0 {
            slip = slip.key("slip");
            centre = centre.key("centre");
        }
        plot = plot.panel(panel.curve(slip).curve(centre));
    }
    plot.figure(table)
}

/// The time of the motion over that of (82) against γ, with the lines 1 (as printed) and 1/γ (as corrected).
///
/// `points` are (γ, ratio), both positive and dimensionless.
///
/// Fails as [`Plot::figure`] does.
pub fn times(points: &[[f64; 2]]) -> Result<Figure, FigureError> {
    let mut table = Table::new(&["gamma", "tau of the motion over (82)"]);
    for [gamma, ratio] in points {
        table.row([gamma.into(), ratio.into()])?;
    }
    let (low, high) = points
        .iter()
        .fold((1.0_f64, 1.0_f64), |(low, high), [g, _]| {
            (low.min(*g), high.max(*g))
        });
    let panel = Panel::new(Axis::log("γ"), Axis::log("τ/'(82)'"))
        .curve(
            Curve::new([[low, 1.0], [high, 1.0]])
                .series(1)
                .stroke(Stroke::Dashed)
                .label_at("as printed: 1", 0.2),
        )
        .curve(
            Curve::new([[low, 1.0 / low], [high, 1.0 / high]])
                .series(0)
                .stroke(Stroke::Solid)
                .label_at("as corrected: 1/γ", 0.75),
        )
        .points(Points::new(points.iter().copied()).ink().size(3.0));
    Plot::new("sphere-times", "The factor that (82) lacks")
        .caption(
            "The time $\\tau$ that a sphere in three dimensions takes to turn its slip from $\\theta_0$ to $\\theta$, \
             over the value of (82) as printed, against $\\gamma=A/(\\mu g)$: one point for each sphere of the trial.",
        )
        .alt(
            "Points on logarithmic axes, all on the falling line 1/γ; they meet the horizontal line 1 only at γ = 1.",
        )
        .panel(panel)
        .figure(table)
}
