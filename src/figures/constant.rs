//! The figures of section 2.1. Speeds in v₀, times in v₀/A; λ = μg/A is the friction over the acceleration, θ the
//! angle between the velocity and the inertial force, θ₀ its initial value.

use super::{
    Drawn,
    trend::{column, peak, same, way, ways},
};
use crate::claims::constant::drawn;
use crate::motion::MotionError;
use std::f64::consts::PI;
use trialbook::plotting::{Axis, Curve, Figure, Marker, Panel, Plot, Points, Table};

pub(super) fn figures() -> Drawn<Vec<Figure>> {
    Ok(vec![portraits()?, histories()?, stopping_times()?])
}

/// Dense enough to draw: equal steps in time, and the integrator's own nodes where it turns fast.
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

/// fig-1: λ ≤ 1 above and λ > 1 below. Of each λ the curve that starts nearest to θ₀ = π/2 carries the label.
fn portraits() -> Drawn {
    let mut table = Table::new(&[
        "panel",
        "lambda",
        "theta_0 (rad)",
        "t (v_0/A)",
        "v_x (v_0)",
        "v_y (v_0)",
    ]);
    let [weak, strong] = [drawn::panel(&drawn::WEAK)?, drawn::panel(&drawn::STRONG)?];
    for (name, panel) in [("a", &weak), ("b", &strong)] {
        for curve in panel {
            let points = sampled(curve).map(|s| (s.t, s.v));
            table.rows((name, curve.lambda, curve.theta0), points)?;
        }
    }
    let count = |panel: &[drawn::Curve]| lambdas(panel.iter().map(|curve| curve.lambda)).len();
    Ok(Plot::new("fig-1", "Velocity under constant acceleration and dry friction")
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
            count(&weak),
            count(&strong)
        ))
        .panel(portrait(&weak, "'(a)'\u{2003}λ ≤ 1"))
        .panel(portrait(&strong, "'(b)'\u{2003}λ > 1"))
        .figure(table)?)
}

fn portrait(curves: &[drawn::Curve], title: &str) -> Panel {
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
            let path = Vec::from_iter(sampled(curve).map(|s| s.v));
            let mut drawn = Curve::new(&path).series(n).arrows(&[0.55]);
            if Some(i) == labelled {
                drawn = drawn.label_at(format!("λ = {lambda}"), 0.4);
            }
            panel = panel.curve(drawn);
            starts.extend(path.first().copied());
            let end = curve.motion.end();
            if end.speed() == 0.0 {
                rests.extend(path.last().copied());
            } else if lambda == 1.0 {
                // It tends to this velocity, for ever.
                ends.push(end.v);
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

/// From θ₀ = 2π/3 for several λ; one panel each.
fn histories() -> Drawn {
    let mut table = Table::new(&["lambda", "t (v_0/A)", "v (v_0)", "theta (rad)"]);
    let angles = [
        (0.0, "0"),
        (PI / 3.0, "π/3"),
        (2.0 * PI / 3.0, "2π/3"),
        (PI, "π"),
    ];
    let mut histories = Vec::new();
    let mut top = PI / 3.0;
    for lambda in [0.0, 0.5, 1.0, 2.0] {
        let curve = drawn::curve(lambda, 2.0 * PI / 3.0)?;
        let states = sampled(&curve).filter(|s| s.t <= 4.0);
        let points: Vec<_> = states.map(|s| [s.t, s.speed(), s.direction()]).collect();
        table.rows(lambda, &points)?;
        top = points.iter().map(|p| p[2]).fold(top, f64::max);
        histories.push((lambda, points, curve.motion.end().speed() == 0.0));
    }
    let mut speed = Panel::new(
        Axis::linear("A t/v_0"),
        Axis::linear("v/v_0").range(0.0, 2.0),
    );
    let mut angle = Panel::new(
        Axis::linear("A t/v_0"),
        Axis::linear("θ").range(0.0, top.min(PI)).ticks(angles),
    );
    for (n, (lambda, points, rests)) in histories.iter().enumerate() {
        let against_time = |k: usize| points.iter().map(move |p| [p[0], p[k]]);
        let label = format!("λ = {lambda}");
        let curve = |k| Curve::new(against_time(k)).series(n);
        speed = speed.curve(curve(1).label_at(label.clone(), 0.85));
        angle = angle.curve(curve(2).label_at(label, 0.6));
        if let (true, Some(&[t, v, theta])) = (rests, points.last()) {
            let disc = |y: f64| Points::new([[t, y]]).series(n).marker(Marker::Disc);
            speed = speed.points(disc(v));
            angle = angle.points(disc(theta));
        }
    }
    // λ, time, speed, angle.
    let groups = table.groups();
    let speeds = groups.iter().all(|rows| {
        let (least, end) = (
            column(rows, 2).fold(f64::INFINITY, f64::min),
            rows[rows.len() - 1][2],
        );
        let lambda = rows[0][0];
        least < rows[0][2] && (lambda >= 1.0 || end > least) && (lambda <= 1.0 || end == 0.0)
    });
    let soon = groups
        .iter()
        .filter_map(|rows| rows.iter().find(|row| row[1] >= 0.4).map(|row| row[3]));
    Ok(Plot::new("constant-speed-angle", "Speed and direction against time")
        .caption(
            "Speed $v$ and angle $\\theta$ between the velocity and the inertial force, against time, for \
             several $\\lambda$. A disc marks where the particle comes to rest: there the angle \
             reaches zero as well.",
        )
        .alt(
            "Two panels against time in units of the initial speed over the acceleration. Above, the \
             speed {{first falls, then rises for small λ and falls to zero for λ above 1}}. Below, the \
             angle {{falls|rises}} towards zero, the {{faster|slower}} the larger λ.",
        )
        .says(["first falls, then rises for small λ and falls to zero for λ above 1"], speeds)
        .says(["falls|rises"], ways(&groups, 3))
        .says(["faster|slower"], way(soon))
        .panel(speed)
        .panel(angle)
        .figure(table)?)
}

fn stopping_times() -> Drawn {
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
    for (n, lambda) in [1.2, 1.5, 2.0, 5.0].into_iter().enumerate() {
        let time = |i: u32| -> Result<_, MotionError> {
            let theta0 = PI * f64::from(i) / 60.0;
            Ok([theta0, drawn::curve(lambda, theta0)?.motion.end().t])
        };
        let times = (0..=60).map(time).collect::<Result<Vec<_>, _>>()?;
        table.rows(lambda, &times)?;
        let label = format!("λ = {lambda}");
        panel = panel.curve(Curve::new(times).series(n).label_at(label, 0.3));
    }
    // λ, angle, time.
    let groups = table.groups();
    let drop = groups
        .iter()
        .map(|rows| rows[0][2] - rows[rows.len() - 1][2]);
    let longest = |at: f64| {
        groups
            .iter()
            .all(|rows| same(peak(rows, 1, 2)[0], at, 1e-9))
    };
    Ok(Plot::new(
        "constant-stopping-time",
        "Stopping time against the initial direction",
    )
    .caption(
        "Time $T$ until the particle stops, against the initial angle $\\theta_0$, for \
             several $\\lambda>1$. It is longest when the particle starts {{along|against}} the inertial force.",
    )
    .alt(
        "Curves that {{fall|rise}} from the initial angle zero to the angle π, the {{higher|lower}} and the {{steeper|flatter}} \
             the closer λ is to 1.",
    )
    .says(["along|against"], [longest(0.0), longest(PI)])
    .says(["fall|rise"], ways(&groups, 2))
    .says(["higher|lower"], way(groups.iter().map(|rows| rows[0][2])))
    .says(["steeper|flatter"], way(drop))
    .panel(panel)
    .figure(table)?)
}

/// In order of first appearance.
fn lambdas(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut out = Vec::new();
    for value in values {
        if !out.contains(&value) {
            out.push(value);
        }
    }
    out
}
