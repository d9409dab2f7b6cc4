//! The figures of section 2.2, dimensionless: φ is the phase in radians, 𝔴 the velocity along the drive, 𝔴_y the one
//! across it, λ₀ the friction over the drive's amplitude.

use super::{
    Drawn,
    trend::{column, peak, rises, steepens, way, ways},
};
use crate::claims::sinusoidal::drawn::{self, Transient};
use std::f64::consts::PI;
use trialbook::plotting::{Axis, Curve, Figure, FigureError, Panel, Plot, Rule, Table};

pub(super) fn figures() -> Drawn<Vec<Figure>> {
    let curves = drawn::transients()?;
    let panel = |lambda: f64, title: &'static str| {
        let own = curves.iter().filter(|curve| curve.lambda == lambda);
        (title, own.collect())
    };
    let small = drawn::two_periods(drawn::SMALL)?;
    let large = drawn::two_periods(drawn::LARGE)?;
    let depths = |lambda: f64| -> Drawn<_> { Ok((lambda, drawn::depths(lambda)?)) };
    let periodic = |lambda: f64| -> Drawn<_> {
        let mut points = drawn::two_periods(lambda)?;
        points.truncate(points.len() / 2 + 1);
        Ok((lambda, points))
    };
    let decays: Result<Vec<_>, _> = [0.1, 0.2, 0.3, 0.45].into_iter().map(depths).collect();
    let motions: Result<Vec<_>, _> = [0.1, 0.3, 0.5, 0.6, 0.8]
        .into_iter()
        .map(periodic)
        .collect();
    Ok(vec![
        fig2(&[
            panel(drawn::SMALL, "λ_0 = 1/π"),
            panel(drawn::LARGE, "λ_0 = 1/√2"),
        ])?,
        two_periods(&TwoPeriods {
            id: "fig-3",
            lambda: "1/π",
            top: 1.0,
            mark: 0.8,
            points: &small,
        })?,
        two_periods(&TwoPeriods {
            id: "fig-4",
            lambda: "1/√2",
            top: 0.35,
            mark: 0.3,
            points: &large,
        })?,
        decay(&decays?)?,
        rest_share(&drawn::rest_shares()?, drawn::critical())?,
        family(&motions?)?,
    ])
}

/// Ticks at whole multiples of π, every second one with a label.
fn multiples_of_pi(last: i32) -> Vec<(f64, String)> {
    let label = |k: i32| match k {
        0 => "0".to_owned(),
        k if k % 2 == 0 => format!("{k}π"),
        _ => String::new(),
    };
    (0..=last).map(|k| (PI * f64::from(k), label(k))).collect()
}

/// fig-2: 𝔴 against φ, one panel for each λ₀, one curve for each initial 𝔴_y.
pub(super) fn fig2(panels: &[(&str, Vec<&Transient>)]) -> Result<Figure, FigureError> {
    let mut table = Table::new(&["lambda_0", "w_y at phi = 0", "phi (rad)", "w"]);
    let mut plot = Plot::new("fig-2", "The way to the large-time motion")
        .caption(format!(
            "The velocity $\\mathfrak w$ along the drive against the phase, from $\\mathfrak w=1$ and several velocities \
             $\\mathfrak w_y$ across the drive at $\\phi=0$. All end in the same motion. {{{{First without rest, then with rests|First with rests, then without rest}}}}. {}",
            super::after("fig-2")
        ))
        .alt(
            "Two panels of velocity against phase over four periods, five curves each. The curves start together, spread in \
             the first period, the lower the smaller the velocity across, and run together within two or three periods.",
        );
    for (title, curves) in panels {
        let mut panel = Panel::new(
            Axis::linear("φ")
                .range(0.0, 8.0 * PI)
                .ticks(multiples_of_pi(8)),
            Axis::linear("𝔴"),
        )
        .title(*title)
        .height(210.0);
        for (n, curve) in curves.iter().enumerate() {
            let points = curve.states.iter().map(|s| [s.phi, s.w_x]);
            table.rows([curve.lambda, curve.w_y], points.clone())?;
            let key = format!("𝔴_y = {}", curve.w_y);
            panel = panel.curve(Curve::new(points).series(n).key(key));
        }
        plot = plot.panel(panel);
    }
    // λ₀, 𝔴_y, φ, 𝔴.
    let stays = |rows: &Vec<Vec<f64>>| {
        rows.windows(2)
            .any(|two| two[0][3] == 0.0 && two[1][3] == 0.0)
    };
    let stays: Vec<bool> = table.groups().iter().map(stays).collect();
    let first = "First without rest, then with rests|First with rests, then without rest";
    plot.says([first], [stays == [false, true], stays == [true, false]])
        .figure(table)
}

#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct TwoPeriods<'a> {
    pub id: &'static str,
    /// In words: `1/π`.
    pub lambda: &'static str,
    /// Upper end of the axis of 𝔴; the lower one is its negative.
    pub top: f64,
    /// The mark that the paper puts on it.
    pub mark: f64,
    /// (φ, w).
    pub points: &'a [[f64; 2]],
}

/// fig-3 and fig-4, on the paper's axes.
pub(super) fn two_periods(shown: &TwoPeriods<'_>) -> Result<Figure, FigureError> {
    let mut table = Table::new(&["phi (rad)", "w"]);
    table.rows((), shown.points)?;
    let TwoPeriods {
        id,
        lambda,
        top,
        mark,
        points,
    } = *shown;
    let marks = [
        (-mark, format!("−{mark}")),
        (0.0, "0".into()),
        (mark, format!("{mark}")),
    ];
    let panel = Panel::new(
        Axis::linear("φ")
            .range(0.0, 4.0 * PI)
            .ticks(multiples_of_pi(4)),
        Axis::linear("𝔴").range(-top, top).ticks(marks),
    )
    .curve(Curve::new(points).series(0));
    let rests = points.windows(2).any(|p| p[0][1] == 0.0 && p[1][1] == 0.0);
    let (said, seen) = if rests {
        (
            "it is at rest for a part of every half period",
            "stays at zero for a while after every hump",
        )
    } else {
        (
            "it turns at once where it vanishes",
            "crosses zero with a kink twice in a period",
        )
    };
    Plot::new(id, format!("Large-time motion, λ₀ = {lambda}"))
        .caption(format!(
            "The large-time motion over two periods for $\\lambda_0={}$: {said}. {}",
            lambda.replace("1/√2", "2^{-1/2}"),
            super::after(id)
        ))
        .alt(format!(
            "Velocity against phase from 0 to 4π: a positive and a negative hump in each period; the curve {seen}."
        ))
        .panel(panel)
        .figure(table)
}

/// λ₀, and points.
type Curved = (f64, Vec<[f64; 2]>);

/// The growth of −ln 𝔴_y, period by period, on a logarithmic axis: (periods, −ln 𝔴_y) as long as 𝔴_y is not zero.
pub(super) fn decay(decays: &[Curved]) -> Result<Figure, FigureError> {
    let mut table = Table::new(&["lambda_0", "periods", "-ln w_y"]);
    let mut panel = Panel::new(
        Axis::linear("'periods'").range(0.0, 20.0),
        Axis::log("−ln 𝔴_y").range(1.0, 1e20),
    );
    for (n, (lambda, points)) in decays.iter().enumerate() {
        table.rows(lambda, points)?;
        let label = format!("λ_0 = {lambda}");
        panel = panel.curve(Curve::new(points).series(n).label_at(label, 0.7));
    }
    // λ₀, periods, depth.
    let groups = table.groups();
    let rates = groups.iter().map(|rows| libm::log(rows[2][2] / rows[1][2]));
    let exponential = (0..=100)
        .map(|k| 0.2 * f64::from(k))
        .map(|x| [x, 1.0 + 2.0 * x]);
    Plot::new("sinusoidal-decay", "How the velocity across the drive dies")
        .caption(
            "The depth $-\\ln\\mathfrak w_y$ period by period, from $\\mathfrak w_y=0.3$, on a logarithmic axis, for several \
             $\\lambda_0<\\lambda_\\mathrm c$. Straight lines here are exponentials of exponentials; an ordinary exponential would be \
             the {{line 'an exponential'}} curve, whose slope dwindles.",
        )
        .alt(
            "Four straight {{falling|rising}} lines on a logarithmic axis, the {{flatter|steeper}} the larger λ₀, and a \
             {{line 'an exponential'}} curve that flattens out far below them.",
        )
        .says(["falling|rising"], ways(&groups, 2))
        .says(["flatter|steeper"], way(rates))
        .panel(panel.curve(
            Curve::new(exponential)
                .ink()
                .dotted()
                .label_at("'an exponential'", 0.9),
        ))
        .figure(table)
}

/// Against λ₀: `points` are (λ₀, share), `critical` is λ_c.
pub(super) fn rest_share(points: &[[f64; 2]], critical: f64) -> Result<Figure, FigureError> {
    let mut table = Table::new(&["lambda_0", "share of rest"]);
    table.rows((), points)?;
    let rows = table.numbers();
    let moving: Vec<_> = rows
        .iter()
        .filter(|row| row[1] > 0.0 && row[0] < 1.0)
        .cloned()
        .collect();
    let whole = rows
        .iter()
        .find(|row| row[0] >= 1.0)
        .is_some_and(|row| (row[1] - 1.0).abs() < 1e-9);
    let mut near = rows
        .iter()
        .filter(|row| (0.9..0.999).contains(&row[0]))
        .map(|row| row.iter().map(|x| libm::log(1.0 - x)).collect::<Vec<_>>());
    let power = match (near.next(), near.next_back()) {
        (Some(first), Some(last)) => (last[1] - first[1]) / (last[0] - first[0]),
        _ => f64::NAN,
    };
    let panel = Panel::new(
        Axis::linear("λ_0").range(0.0, 1.2),
        Axis::linear("'share of rest'").range(0.0, 1.05),
    )
    .curve(Curve::new(points).series(0))
    .rule(Rule::vertical(critical).dotted().label("λ_c"))
    .height(220.0);
    Plot::new("sinusoidal-rest", "How long it rests")
        .caption(
            "The fraction of a period that the large-time motion spends at rest, read off the simulated intervals. It {{grows \
             from zero}} at $\\lambda_\\mathrm c$ with a finite slope and reaches one at $\\lambda_0=1$ as a {{square root|square|cube root}} does.",
        )
        .alt("A curve that is zero up to the critical friction, then {{rises, ever more steeply, to one}} at λ₀ = 1, and stays there.")
        .says(["grows from zero"], points.first().is_some_and(|first| first[1] == 0.0) && rises(column(&moving, 1)))
        .says(["square root|square|cube root"], [0.5, 2.0, 1.0 / 3.0].map(|of| (power - of).abs() < 0.03))
        .says(["rises, ever more steeply, to one"], steepens(&moving, 0, 1) && whole)
        .panel(panel)
        .figure(table)
}

/// Over one period: (φ, 𝔴).
pub(super) fn family(motions: &[Curved]) -> Result<Figure, FigureError> {
    let mut table = Table::new(&["lambda_0", "phi (rad)", "w"]);
    let mut panel = Panel::new(
        Axis::linear("φ")
            .range(0.0, 2.0 * PI)
            .ticks(multiples_of_pi(2)),
        Axis::linear("𝔴").range(-1.1, 1.1),
    );
    for (n, (lambda, points)) in motions.iter().enumerate() {
        table.rows(lambda, points)?;
        let key = format!("λ_0 = {lambda}");
        panel = panel.curve(Curve::new(points).series(n).key(key));
    }
    // λ₀, φ, 𝔴.
    let groups = table.groups();
    let peaks = groups.iter().map(|rows| peak(rows, 1, 2));
    Plot::new("sinusoidal-family", "Large-time motions")
        .caption(
            "The large-time motion over one period for several $\\lambda_0$. With growing friction the humps {{shrink|grow}} and peak \
             {{earlier|later}}; beyond $\\lambda_\\mathrm c$ rests appear between them.",
        )
        .alt(
            "Curves of velocity against phase. For small friction nearly a cosine upside down; for larger friction {{lower|higher}} \
             humps that peak {{earlier|later}}, then flat stretches at zero between them.",
        )
        .says(["shrink|grow", "lower|higher"], way(peaks.clone().map(|peak| peak[1])))
        .says(["earlier|later"], way(peaks.map(|peak| peak[0])))
        .panel(panel)
        .figure(table)
}
