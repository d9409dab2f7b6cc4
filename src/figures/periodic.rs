//! The figures of section 2.3, dimensionless: φ is the phase in radians, 𝔴 the velocity, h the drive with max |h| =
//! 1, λ₀ the friction, η the share of a half period that a pulse fills.

use super::{Drawn, trend::rises};
use crate::claims::{
    periodic::drawn::{self, Row, Wave},
    periodic::drives::Phase,
};
use std::f64::consts::{PI, TAU};
use trialbook::plotting::{
    Area, Axis, Curve, Figure, FigureError, Note, Panel, Plot, Points, Raster, Table,
};

pub(super) fn figures() -> Drawn<Vec<Figure>> {
    let side = 140;
    Ok(vec![
        census(&drawn::census(400)?)?,
        pulse_waves(drawn::ETA, &drawn::pulse_waves()?)?,
        rest_shares(side, &drawn::shares(side)?)?,
        come_and_go(&drawn::come_and_go()?)?,
    ])
}

/// Kinds in the census: no rest, one to four or more, drift.
const FOUR_OR_MORE: usize = 4;
const DRIFT: u8 = 5;

/// How often a motion rests in each period, for several drives over 0 < λ₀ < 1; the first drive on top.
pub(super) fn census(rows: &[Row]) -> Result<Figure, FigureError> {
    let mut table = Table::new(&["drive", "lambda_0", "rests per period"]);
    let mut cells = Vec::new();
    let columns = rows.first().map_or(0, |row| row.phases.len());
    for row in rows.iter().rev() {
        for (k, phase) in row.phases.iter().enumerate() {
            let lambda = (k as f64 + 0.5) / row.phases.len() as f64;
            let (class, words) = match rests_of(*phase) {
                None => (DRIFT, "drifts".into()),
                Some(n) => (n.min(FOUR_OR_MORE) as u8, n.to_string()),
            };
            cells.push(class);
            table.row((row.name, lambda, words))?;
        }
    }
    let names: Vec<(f64, String)> = rows
        .iter()
        .rev()
        .enumerate()
        .map(|(k, row)| (k as f64 + 0.5, row.name.to_owned()))
        .collect();
    let bounds = rows.iter().rev().enumerate();
    let bounds: Vec<[f64; 2]> = bounds
        .map(|(k, row)| [row.mean_size, k as f64 + 0.5])
        .collect();
    let count = rows.len() as f64;
    let raster = Raster::new(columns, rows.len(), (0.0, 1.0), (0.0, count), cells)?
        .class("no rest", 0, 0.12)
        .class("1 rest", 0, 0.4)
        .class("2 rests", 0, 0.7)
        .class("3 rests", 1, 0.45)
        .class("4 or more", 1, 0.85)
        .ink_class("drifts for ever (∞)", 0.35);
    let mut panel = Panel::new(
        Axis::linear("λ_0").range(0.0, 1.0).without_grid(),
        Axis::linear("")
            .range(0.0, count)
            .ticks(names)
            .without_grid(),
    )
    .height(34.0 * count)
    .raster(raster);
    for k in 1..rows.len() {
        let y = k as f64;
        panel = panel.curve(Curve::new([[0.0, y], [1.0, y]]).ink().width(0.8));
    }
    for (k, row) in rows.iter().rev().enumerate() {
        for (at, rests) in wide_bands(&row.phases) {
            let words = rests.map_or("∞".to_owned(), |n| n.to_string());
            let clear = (at - row.mean_size).abs() > 0.03;
            let at = if clear { at } else { row.mean_size - 0.05 };
            panel = panel.note(Note::new([at, k as f64 + 0.5], words));
        }
    }
    let panel = panel.points(Points::new(bounds).ink().size(4.0).key("mean of |h|"));
    Plot::new("periodic-census", "How often the motion rests")
        .caption(
            "Number of rests per period against $\\lambda_0$ for ten drives, by simulation alone. Of each \
             drive the largest $\\lvert h\\rvert$ is 1. The first seven have no rest at small friction and \
             at least one to the right of the disc, the mean of $\\lvert h\\rvert$; the last three each break a condition: \
             $\\lvert h\\rvert$ is 1 throughout, the antiderivative is level at its median, the mean is not 0.",
        )
        .alt(
            "Ten horizontal bars from λ₀ = 0 to 1, coloured by the number of rests per period, which stands in them. For the \
             first seven the colour starts with no rest and ends with one, two or four rests; for the third \
             harmonic no rest appears twice. The square wave never rests, the drive level at its median always \
             does, and the sine with a mean drifts at first.",
        )
        .panel(panel)
        .figure(table)
}

/// Rests per period; at rest for ever is one rest, and a motion that drifts has no number of them.
fn rests_of(phase: Phase) -> Option<usize> {
    match phase {
        Phase::Rests(rests) => Some(rests),
        Phase::Still => Some(1),
        Phase::Drifts => None,
    }
}

/// The middles of the bands of one fate that have room for a number.
fn wide_bands(phases: &[Phase]) -> Vec<(f64, Option<usize>)> {
    let fates: Vec<_> = phases.iter().copied().map(rests_of).collect();
    let cell = 1.0 / fates.len() as f64;
    let mut start = 0.0;
    let bands = fates.chunk_by(|a, b| a == b).map(|band| {
        let (from, width) = (start, cell * band.len() as f64);
        start += width;
        (from + 0.5 * width, width, band[0])
    });
    let wide = bands.filter(|(_, width, _)| *width > 0.06);
    wide.map(|(middle, _, fate)| (middle, fate)).collect()
}

fn phases(label: &str) -> Axis {
    let ticks = [
        (0.0, "0"),
        (PI, "π"),
        (TAU, "2π"),
        (3.0 * PI, "3π"),
        (2.0 * TAU, "4π"),
    ];
    Axis::linear(label).range(0.0, 2.0 * TAU).ticks(ticks)
}

fn listed(waves: &[Wave]) -> Result<Table, FigureError> {
    let mut table = Table::new(&["lambda_0", "phi (rad)", "h", "w"]);
    for wave in waves {
        table.rows(wave.lambda, &wave.points)?;
    }
    Ok(table)
}

fn rests(wave: &Wave) -> String {
    let count = match wave.rests {
        0 => "no rest".into(),
        1 => "1 rest".into(),
        n => format!("{n} rests"),
    };
    format!("λ_0 = {}: {count}", wave.lambda)
}

/// Under pulses that fill the share `eta` of their half periods, which are shaded; one panel for each friction.
pub(super) fn pulse_waves(eta: f64, waves: &[Wave]) -> Result<Figure, FigureError> {
    let mut plot = Plot::new("periodic-pulses", "Velocity under a train of pulses").caption(format!(
        "Velocity $\\mathfrak w$ over two periods under pulses that fill the fraction $\\eta={eta}$ of each half \
         period (shaded: up, then down). With $\\lambda_0<\\eta$ the next pulse comes {{{{before|after}}}} the particle has \
         stopped; with $\\lambda_0>\\eta$ it waits at rest."
    ))
    .alt(
        "Two panels. With small friction the velocity is a skewed wave that passes through zero under each \
         pulse. With large friction it rises in a pulse, falls to zero in the gap, and stays at zero until the \
         next.",
    );
    for wave in waves {
        let top = wave.points.iter().map(|p| p[2].abs()).fold(0.0, f64::max) * 1.15;
        let mut panel = Panel::new(phases("φ"), Axis::linear("𝔴").range(-top, top)).height(200.0);
        for half in 0..4 {
            let start = PI * f64::from(half);
            let (end, height) = (start + eta * PI, if half % 2 == 0 { top } else { -top });
            let corners = [[start, 0.0], [end, 0.0], [end, height], [start, height]];
            panel = panel.area(Area::new(corners).series(1).opacity(0.16));
        }
        let path = wave.points.iter().map(|p| [p[0], p[2]]);
        plot = plot.panel(panel.title(rests(wave)).curve(Curve::new(path)));
    }
    // Whether each moves when the next pulse comes, that of less friction than η first.
    let moves = |wave: &Wave| {
        wave.points
            .iter()
            .rfind(|p| p[0] < PI - 1e-2)
            .is_some_and(|p| p[2] > 0.0)
    };
    let moves: Vec<_> = waves
        .iter()
        .map(|wave| (wave.lambda < eta, moves(wave)))
        .collect();
    let before = [
        moves == [(true, true), (false, false)],
        moves == [(true, false), (false, true)],
    ];
    plot = plot.says(["before|after"], before);
    plot.figure(listed(waves)?)
}

/// Under one smooth drive at several frictions, between which rests come and go.
pub(super) fn come_and_go(waves: &[Wave]) -> Result<Figure, FigureError> {
    let mut plot = Plot::new("periodic-come-and-go", "Rests that come and go").caption(
        "Velocity $\\mathfrak w$ (line) over two periods under a drive $h\\propto\\sin\\phi+1.5\\sin3\\phi$ (dots, \
         not to scale). More friction {{brings rests, takes them away, and brings them|takes rests away, brings them, and takes them away}} again.",
    )
    .alt(
        "Four panels of growing friction. In the first the velocity passes through zero six times per period; in \
         the second it also stays at zero twice; in the third it passes through zero twice and never stays; in \
         the fourth it stays at zero again.",
    )
    .columns(2);
    for wave in waves {
        let top = wave.points.iter().map(|p| p[2].abs()).fold(0.0, f64::max) * 1.15;
        let drive = wave.points.iter().map(|p| [p[0], 0.8 * top * p[1]]);
        let path = wave.points.iter().map(|p| [p[0], p[2]]);
        let panel = Panel::new(phases("φ"), Axis::linear("𝔴").range(-top, top))
            .height(150.0)
            .title(rests(wave))
            .curve(Curve::new(drive).ink().dotted().width(1.2))
            .curve(Curve::new(path));
        plot = plot.panel(panel);
    }
    let stays = |wave: &Wave| wave.points.iter().any(|p| p[2] == 0.0);
    let stays: Vec<bool> = waves.iter().map(stays).collect();
    let more = rises(waves.iter().map(|wave| wave.lambda));
    let first = |rests: bool| more && stays == [!rests, rests, !rests, rests];
    let said = "brings rests, takes them away, and brings them|takes rests away, brings them, and takes them away";
    plot = plot.says([said], [true, false].map(first));
    plot.figure(listed(waves)?)
}

/// Over the square of η and λ₀: `side` cells each way, row by row from the lowest λ₀.
pub(super) fn rest_shares(side: usize, shares: &[f64]) -> Result<Figure, FigureError> {
    let mut table = Table::new(&["eta", "lambda_0", "share of the period at rest"]);
    let middle = |k: usize| (k as f64 + 0.5) / side as f64;
    for (cell, share) in shares.iter().enumerate() {
        table.row([middle(cell % side), middle(cell / side), *share])?;
    }
    // η, λ₀, share: on the side of the diagonal where λ₀ is larger, or smaller.
    let rows = table.numbers();
    let all = |above: bool, is: fn(&Vec<f64>) -> bool| {
        let sign = if above { 1.0 } else { -1.0 };
        rows.iter()
            .filter(|row| sign * (row[1] - row[0]) > 1e-9)
            .all(is)
    };
    let law = |row: &Vec<f64>| (row[2] - (1.0 - row[0] / row[1])).abs() < 1e-6;
    let [law, none] =
        [law, |row: &Vec<f64>| row[2] < 1e-9].map(|is| [true, false].map(|above| all(above, is)));
    let class = |share: &f64| {
        if *share == 0.0 {
            0
        } else {
            1 + ((4.0 * share) as u8).min(3)
        }
    };
    let cells = shares.iter().map(class).collect();
    let raster = Raster::new(side, side, (0.0, 1.0), (0.0, 1.0), cells)?
        .class("no rest", 1, 0.2)
        .class("0 to 25 %", 0, 0.12)
        .class("25 to 50 %", 0, 0.32)
        .class("50 to 75 %", 0, 0.55)
        .class("75 to 100 %", 0, 0.8);
    let axis = |label: &str| Axis::linear(label).range(0.0, 1.0).without_grid();
    let panel = Panel::new(axis("η"), axis("λ_0")).equal().raster(raster);
    Plot::new("periodic-rest-shares", "How long the pulses let rest")
        .caption(
            "Fraction of the period spent at rest under the train of pulses, over $\\eta$ and $\\lambda_0<1$, by \
             simulation alone. The diagonal is $\\lambda_\\mathrm c=\\eta$; {{above|below}} it the share is \
             $1-\\eta/\\lambda_0$.",
        )
        .alt(
            "A square with η to the right and λ₀ upwards. {{Above|Below}} the diagonal there is no rest. {{On its other side}} the \
             share of rest grows in wedges from the diagonal to the left edge.",
        )
        .says(["above|below"], law)
        .says(["Above|Below"], none)
        .says(["On its other side"], law[0] == none[1])
        .panel(panel)
        .figure(table)
}
