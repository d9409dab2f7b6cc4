//! The figures of section 2.1: constant acceleration.
//!
//! Units throughout: speeds in v₀, the initial speed; times in v₀/A. λ = μg/A is the friction over
//! the acceleration, θ the angle between the velocity and the inertial force, θ₀ its initial value.

use super::AllFiguresError;
use crate::claims::constant::drawn;
use crate::motion::MotionError;
use std::f64::consts::PI;
use trialbook::plotting::{Axis, Curve, Figure, FigureError, Marker, Panel, Plot, Points, Table};

pub(super) fn figures() -> Result<Vec<Figure>, AllFiguresError> {
    Ok(vec![portraits()?, histories()?, stopping_times()?])
}

/// fig-1.
fn portraits() -> Result<Figure, AllFiguresError> {
    let panel = |lambdas: &[f64]| -> Result<Vec<_>, MotionError> {
        Ok(drawn::panel(lambdas)?.iter().map(hodograph).collect())
    };
    Ok(fig1(&Hodographs {
        weak: panel(&drawn::WEAK)?,
        strong: panel(&drawn::STRONG)?,
    })?)
}

fn hodograph(curve: &drawn::Curve) -> Hodograph {
    let end = curve.motion.end();
    Hodograph {
        lambda: curve.lambda,
        theta0: curve.theta0,
        points: sampled(curve).map(|s| [s.t, s.v[0], s.v[1]]).collect(),
        ending: if end.speed() == 0.0 {
            Ending::Rest
        } else if curve.lambda == 1.0 {
            Ending::Terminal(end.v)
        } else {
            Ending::Onward
        },
    }
}

/// Points of a motion dense enough to draw: equal steps in time, and the integrator's own nodes where it
/// turns fast.
fn sampled(curve: &drawn::Curve) -> impl Iterator<Item = crate::motion::State> {
    let motion = &curve.motion;
    let end = motion.end().t;
    let mut states: Vec<_> = (0..=120)
        .filter_map(|i| motion.at(end * f64::from(i) / 120.0).ok())
        .collect();
    states.extend(motion.nodes());
    states.sort_by(|a, b| a.t.total_cmp(&b.t));
    states.dedup_by(|a, b| a.t == b.t);
    states.into_iter()
}

/// Speed and angle against time, from θ₀ = 2π/3.
fn histories() -> Result<Figure, AllFiguresError> {
    let history = |lambda: f64| -> Result<_, MotionError> {
        let curve = drawn::curve(lambda, 2.0 * PI / 3.0)?;
        Ok(History {
            lambda,
            points: sampled(&curve)
                .filter(|s| s.t <= 4.0)
                .map(|s| [s.t, s.speed(), s.direction()])
                .collect(),
            rests: curve.motion.end().speed() == 0.0,
        })
    };
    let histories: Result<Vec<_>, _> = [0.0, 0.5, 1.0, 2.0].into_iter().map(history).collect();
    Ok(speed_and_angle(&histories?)?)
}

/// Time of stopping against the launch angle.
fn stopping_times() -> Result<Figure, AllFiguresError> {
    let times = |lambda: f64| -> Result<_, MotionError> {
        let time = |i: u32| {
            let theta0 = PI * f64::from(i) / 60.0;
            Ok([theta0, drawn::curve(lambda, theta0)?.motion.end().t])
        };
        Ok(StoppingTimes {
            lambda,
            points: (0..=60).map(time).collect::<Result<_, MotionError>>()?,
        })
    };
    let all: Result<Vec<_>, _> = [1.2, 1.5, 2.0, 5.0].into_iter().map(times).collect();
    Ok(stopping_time(&all?)?)
}

/// How a trajectory ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Ending {
    /// It goes on beyond the last point.
    Onward,
    /// It tends to this velocity (v_x, v_y), in units of v₀, for ever.
    Terminal([f64; 2]),
    /// It is at rest from the last point on.
    Rest,
}

/// One path of the velocity.
#[derive(Debug, Clone, PartialEq)]
pub struct Hodograph {
    /// λ, dimensionless.
    pub lambda: f64,
    /// θ₀ in radians.
    pub theta0: f64,
    /// (t, v_x, v_y) in order of time; t in v₀/A, velocities in v₀.
    pub points: Vec<[f64; 3]>,
    /// What comes after the last point.
    pub ending: Ending,
}

/// What fig-1 shows.
#[derive(Debug, Clone, PartialEq)]
pub struct Hodographs {
    /// Panel (a): λ ≤ 1, curves of the same λ together.
    pub weak: Vec<Hodograph>,
    /// Panel (b): λ > 1, curves of the same λ together.
    pub strong: Vec<Hodograph>,
}

/// fig-1: phase portraits in the (v_x, v_y)-plane, λ ≤ 1 above and λ > 1 below. Of each λ the curve
/// that starts nearest to θ₀ = π/2 carries the label.
///
/// Fails as [`Plot::figure`] does, thus when there is no finite point in a panel.
pub fn fig1(curves: &Hodographs) -> Result<Figure, FigureError> {
    let mut table = Table::new(&[
        "panel",
        "lambda",
        "theta_0 (rad)",
        "t (v_0/A)",
        "v_x (v_0)",
        "v_y (v_0)",
    ]);
    for (name, panel) in [("a", &curves.weak), ("b", &curves.strong)] {
        for curve in panel {
            for [t, vx, vy] in &curve.points {
                let head = [name.into(), curve.lambda.into(), curve.theta0.into()];
                table.row(head.into_iter().chain([t.into(), vx.into(), vy.into()]))?;
            }
        }
    }
    let count = |panel: &[Hodograph]| lambdas(panel.iter().map(|curve| curve.lambda)).len();
    Plot::new("fig-1", "Velocity under constant acceleration and dry friction")
        .caption(format!(
            "How the velocity changes under a constant acceleration along $x$ and dry friction, from \
             the same speed $v_0$ in several directions. (a) $\\lambda\\le 1$: the particle goes on \
             for ever and turns into the direction of the inertial force; for $\\lambda=1$ its velocity \
             tends to a constant (circles). (b) $\\lambda>1$: it comes to rest (disc). {}",
            super::after("fig-1")
        ))
        .alt(format!(
            "Two panels with the velocity along x to the right and that along y upwards, in units of the \
             initial speed. Every curve starts on the unit circle. Above, for {} values of λ up to 1, the \
             curves bend to the right and leave the panel, or for λ = 1 end on the axis of x. Below, for {} \
             values of λ above 1, all curves run into the origin.",
            count(&curves.weak),
            count(&curves.strong)
        ))
        .panel(portrait(&curves.weak, "'(a)'\u{2003}λ ≤ 1"))
        .panel(portrait(&curves.strong, "'(b)'\u{2003}λ > 1"))
        .figure(table)
}

fn portrait(curves: &[Hodograph], title: &str) -> Panel {
    let mut panel = Panel::new(Axis::linear("v_x/v_0"), Axis::linear("v_y/v_0"))
        .title(title)
        .equal();
    let (mut starts, mut rests) = (Vec::new(), Vec::new());
    for (n, lambda) in lambdas(curves.iter().map(|curve| curve.lambda))
        .into_iter()
        .enumerate()
    {
        let mut ends = Vec::new();
        let own: Vec<_> = curves
            .iter()
            .filter(|curve| curve.lambda == lambda)
            .collect();
        let labelled = (0..own.len()).min_by(|&i, &j| {
            let off = |k: usize| (own[k].theta0 - PI / 2.0).abs();
            off(i).total_cmp(&off(j))
        });
        for (i, curve) in own.into_iter().enumerate() {
            let path = curve.points.iter().map(|&[_, vx, vy]| [vx, vy]);
            let mut drawn = Curve::new(path).series(n).arrows(&[0.55]);
            if Some(i) == labelled {
                drawn = drawn.label_at(format!("λ = {lambda}"), 0.4);
            }
            panel = panel.curve(drawn);
            starts.extend(curve.points.first().map(|&[_, vx, vy]| [vx, vy]));
            match curve.ending {
                Ending::Onward => {}
                Ending::Terminal(velocity) => ends.push(velocity),
                Ending::Rest => rests.extend(curve.points.last().map(|&[_, vx, vy]| [vx, vy])),
            }
        }
        if !ends.is_empty() {
            let circles = Points::new(ends).series(n).marker(Marker::Circle).size(4.5);
            panel = panel.points(circles.key("terminal velocity"));
        }
    }
    panel = panel.points(Points::new(starts).ink().size(2.2));
    // All come to rest at the same velocity: one disc says so.
    panel.points(
        Points::new(rests.into_iter().take(1))
            .ink()
            .size(5.0)
            .label("rest"),
    )
}

/// Speed and direction of one motion against time.
#[derive(Debug, Clone, PartialEq)]
pub struct History {
    /// λ, dimensionless.
    pub lambda: f64,
    /// (t, v, θ) in order of time: t in v₀/A, v in v₀, θ in radians.
    pub points: Vec<[f64; 3]>,
    /// True if the particle is at rest from the last point on.
    pub rests: bool,
}

/// Speed and angle against time for several λ and one θ₀; one panel each.
///
/// Fails as [`Plot::figure`] does, thus when there is no finite point.
pub fn speed_and_angle(histories: &[History]) -> Result<Figure, FigureError> {
    let mut table = Table::new(&["lambda", "t (v_0/A)", "v (v_0)", "theta (rad)"]);
    for history in histories {
        for [t, v, theta] in &history.points {
            table.row([history.lambda.into(), t.into(), v.into(), theta.into()])?;
        }
    }
    let angles = [
        (0.0, "0"),
        (PI / 3.0, "π/3"),
        (2.0 * PI / 3.0, "2π/3"),
        (PI, "π"),
    ];
    let top = histories
        .iter()
        .flat_map(|h| &h.points)
        .map(|p| p[2])
        .fold(PI / 3.0, f64::max);
    let mut speed = Panel::new(
        Axis::linear("A t/v_0"),
        Axis::linear("v/v_0").range(0.0, 2.0),
    );
    let mut angle = Panel::new(
        Axis::linear("A t/v_0"),
        Axis::linear("θ").range(0.0, top.min(PI)).ticks(angles),
    );
    for (n, history) in histories.iter().enumerate() {
        let against_time = |k: usize| history.points.iter().map(move |p| [p[0], p[k]]);
        let label = format!("λ = {}", history.lambda);
        speed = speed.curve(
            Curve::new(against_time(1))
                .series(n)
                .label_at(label.clone(), 0.85),
        );
        angle = angle.curve(Curve::new(against_time(2)).series(n).label_at(label, 0.6));
        if let (true, Some(&[t, v, theta])) = (history.rests, history.points.last()) {
            let disc = |y: f64| Points::new([[t, y]]).series(n).marker(Marker::Disc);
            speed = speed.points(disc(v));
            angle = angle.points(disc(theta));
        }
    }
    Plot::new("constant-speed-angle", "Speed and direction against time")
        .caption(
            "Speed $v$ and angle $\\theta$ between the velocity and the inertial force, against time, for \
             several $\\lambda$. A disc marks where the particle comes to rest: there the angle \
             reaches zero as well.",
        )
        .alt(
            "Two panels against time in units of the initial speed over the acceleration. Above, the \
             speed first falls, then rises for small λ and falls to zero for λ above 1. Below, the \
             angle falls towards zero, the faster the larger λ.",
        )
        .panel(speed)
        .panel(angle)
        .figure(table)
}

/// Stopping times for one λ.
#[derive(Debug, Clone, PartialEq)]
pub struct StoppingTimes {
    /// λ > 1, dimensionless.
    pub lambda: f64,
    /// (θ₀, T): θ₀ in radians, T in v₀/A.
    pub points: Vec<[f64; 2]>,
}

/// Time until rest against the initial angle, for several λ > 1.
///
/// Fails as [`Plot::figure`] does, thus when there is no finite point.
pub fn stopping_time(times: &[StoppingTimes]) -> Result<Figure, FigureError> {
    let mut table = Table::new(&["lambda", "theta_0 (rad)", "T (v_0/A)"]);
    let angles = [
        (0.0, "0"),
        (PI / 4.0, ""),
        (PI / 2.0, "π/2"),
        (0.75 * PI, ""),
        (PI, "π"),
    ];
    let mut panel = Panel::new(
        Axis::linear("θ_0").range(0.0, PI).ticks(angles),
        Axis::linear("A T/v_0"),
    );
    for (n, one) in times.iter().enumerate() {
        for [theta0, time] in &one.points {
            table.row([one.lambda.into(), theta0.into(), time.into()])?;
        }
        let label = format!("λ = {}", one.lambda);
        panel = panel.curve(
            Curve::new(one.points.iter().copied())
                .series(n)
                .label_at(label, 0.3),
        );
    }
    Plot::new(
        "constant-stopping-time",
        "Stopping time against the initial direction",
    )
    .caption(
        "Time $T$ until the particle stops, against the initial angle $\\theta_0$, for \
             several $\\lambda>1$. It is longest when the particle starts along the inertial force.",
    )
    .alt(
        "Curves that fall from the initial angle zero to the angle π, the higher and the steeper \
             the closer λ is to 1.",
    )
    .panel(panel)
    .figure(table)
}

/// The different values of λ in order of first appearance.
fn lambdas(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut out = Vec::new();
    for value in values {
        if !out.contains(&value) {
            out.push(value);
        }
    }
    out
}
