//! The figures of section 4 up to (125). Lengths in μg/Ω², times in 1/Ω.

use super::{
    Drawn,
    trend::{falls, sides},
};
use crate::claims::{
    turntable::drawn::{self, Launched, Moment},
    turntable::fixed::{self, Following},
};
use std::f64::consts::PI;
use trialbook::plotting::{
    Axis, Curve, Figure, FigureError, Marker, Panel, Plot, Points, Rule, Table,
};

pub(super) fn figures() -> Drawn<Vec<Figure>> {
    let [rests, escapes] = drawn::SPEEDS.map(drawn::launched);
    let launches = [rests?, escapes?];
    let escape = |start: [f64; 3]| Ok((start[0], fixed::following(start)?));
    let escapes: Drawn<Vec<_>> = fixed::ESCAPES.into_iter().map(escape).collect();
    Ok(vec![
        energy(&launches[0])?,
        paths(&launches)?,
        following(&escapes?)?,
    ])
}

const SHOWN: f64 = 2.5;

/// On the table above and in the laboratory below.
pub(super) fn paths(launches: &[Launched]) -> Result<Figure, FigureError> {
    let mut table = Table::new(&[
        "launch speed (mu g/Omega)",
        "tau",
        "x on the table (mu g/Omega^2)",
        "y on the table (mu g/Omega^2)",
        "X in the laboratory (mu g/Omega^2)",
        "Y in the laboratory (mu g/Omega^2)",
    ]);
    for launch in launches {
        let moments = launch.moments.iter();
        table.rows(
            launch.speed,
            moments.map(|m| (m.tau, m.table, m.laboratory)),
        )?;
    }
    let panel = |title: &str, place: fn(&Moment) -> [f64; 2], labels: [&str; 2]| {
        let axis = |label: &str| Axis::linear(label).range(-SHOWN, SHOWN);
        let mut panel = Panel::new(axis(labels[0]), axis(labels[1]))
            .title(title)
            .equal();
        for (n, launch) in launches.iter().enumerate() {
            let label = format!("p = {} at the start", launch.speed);
            panel = panel.curve(
                Curve::new(launch.moments.iter().map(place))
                    .series(n)
                    .arrows(&[0.5])
                    .key(label),
            );
            if let Some(rest) = launch.rest {
                let stopped = launch.moments.iter().find(|m| m.tau >= rest).map(place);
                let disc = Points::new(stopped)
                    .series(n)
                    .marker(Marker::Disc)
                    .size(4.5);
                panel = panel.points(disc.key("rest on the table"));
            }
        }
        panel.points(Points::new([[0.0, 0.0]]).ink().size(2.5).label("axis"))
    };
    let turn = |launch: &Launched| {
        let way = launch
            .moments
            .windows(2)
            .map(|two| [0, 1].map(|k| two[1].table[k] - two[0].table[k]));
        match way.take(2).collect::<Vec<_>>()[..] {
            [[x, y], [then_x, then_y]] => x * then_y - y * then_x,
            _ => f64::NAN,
        }
    };
    let mut by_speed: Vec<_> = launches
        .iter()
        .map(|launch| (launch.speed, launch.rest.is_some()))
        .collect();
    by_speed.sort_by(|a, b| a.0.total_cmp(&b.0));
    let rests: Vec<_> = by_speed.iter().map(|(_, rests)| *rests).collect();
    let rests = [rests == [true, false], rests == [false, true]];
    Plot::new("turntable-paths", "Two launches from the axis of a turntable")
        .caption(
            "Two particles, launched from the axis with different speeds (in units of $\\mu g/\\Omega$). \
             (a) On the table both curve to the {{right|left}}; the {{slower|faster}} one comes to rest, the {{faster|slower}} one spirals \
             outwards for ever. (b) The same in the laboratory, where friction is the only force: once at rest \
             on the table, the {{slower|faster}} one is carried round in a circle.",
        )
        .says(["right|left"], sides(launches.iter().map(turn), 0.0))
        .says(["slower|faster", "faster|slower"], rests)
        .alt(
            "Two panels with equal axes. In the first, on the table, both curves leave the axis to the right and bend \
             clockwise; the short one ends in a disc, the long one winds outwards. In the second, in the laboratory, \
             the short one runs into a circle about the axis, the long one winds outwards \
             counterclockwise.",
        )
        .panel(panel("'(a)'\u{2003}on the table", |m| m.table, ["Ω^2x/(μg)", "Ω^2y/(μg)"]))
        .panel(panel("'(b)'\u{2003}in the laboratory", |m| m.laboratory, ["Ω^2X/(μg)", "Ω^2Y/(μg)"]))
        .figure(table)
}

/// The terms of (104) along one launch.
pub(super) fn energy(launch: &Launched) -> Result<Figure, FigureError> {
    let mut table = Table::new(&["tau", "p^2/2", "-rho^2/2", "s", "sum"]);
    let rows: Vec<[f64; 5]> = launch
        .moments
        .iter()
        .take_while(|m| m.tau <= launch.rest.unwrap_or(f64::INFINITY) + 0.3)
        .map(|&Moment { tau, p, rho, s, .. }| {
            let (kinetic, centrifugal) = (0.5 * p * p, -0.5 * rho * rho);
            [tau, kinetic, centrifugal, s, kinetic + centrifugal + s]
        })
        .collect();
    table.rows((), &rows)?;
    let mut panel = Panel::new(Axis::linear("τ"), Axis::linear("energy in m(μg)^2/Ω^2"));
    for (n, label) in ["p^2/2", "−ρ^2/2", "s"].into_iter().enumerate() {
        let curve = rows.iter().map(|row| [row[0], row[n + 1]]);
        panel = panel.curve(Curve::new(curve).series(n).label_at(label, 0.55));
    }
    let sum = rows.iter().map(|row| [row[0], row[4]]);
    panel = panel.curve(Curve::new(sum).ink().label_at("sum", 0.8));
    if let Some(rest) = launch.rest {
        panel = panel.rule(Rule::vertical(rest).dotted().label("rest"));
    }
    let column = |i: usize| rows.iter().map(move |row| row[i]);
    let slides = column(1).take_while(|kinetic| *kinetic > 0.0).count();
    let still = column(1).skip(slides).all(|kinetic| kinetic == 0.0);
    let grows = |of: &dyn Fn(&[f64; 5]) -> f64| {
        let ends = rows.first().zip(rows.last());
        ends.is_some_and(|(first, last)| of(first) < of(last))
            && rows.windows(2).all(|two| of(&two[0]) <= of(&two[1]))
    };
    Plot::new("turntable-energy", "Energy on the turntable")
        .caption(
            "The three terms of (104) for the launch that comes to rest: kinetic energy relative to the \
             table, potential energy of the centrifugal force, and what friction has taken, which is the arc \
             length $s$ in these units. Their sum stays the same.",
        )
        .alt(
            "Three curves against time: the kinetic energy {{falls to zero}}, the centrifugal energy {{falls from \
             zero}} to a negative value, the arc length {{rises}}; their sum is a horizontal line.",
        )
        .says(["falls to zero"], still && falls(column(1).take(slides + 1)))
        .says(["falls from zero"], column(2).next() == Some(0.0) && grows(&|row| -row[2]))
        .says(["rises"], grows(&|row| row[3]))
        .panel(panel)
        .figure(table)
}

/// ψ and ψ₁ against time in escapes, and what is left of each to π/2; `escapes` are A at the start and the moments.
pub(super) fn following(escapes: &[(f64, Vec<Following>)]) -> Result<Figure, FigureError> {
    let mut table = Table::new(&[
        "A at the start",
        "tau",
        "psi (rad)",
        "psi_1 (rad)",
        "(pi/2-psi)/(pi/2-psi_1)",
    ]);
    for (a, moments) in escapes {
        table.rows(a, moments.iter().map(|m| [m.tau, m.psi, m.psi1, m.ratio]))?;
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
    for (n, (a, moments)) in escapes.iter().enumerate() {
        let against_time = |of: fn(&Following) -> f64| moments.iter().map(move |m| [m.tau, of(m)]);
        let key = |what: &str| format!("{what}, A = {a} at the start");
        angles = angles
            .curve(Curve::new(against_time(|m| m.psi)).series(n).key(key("ψ")))
            .curve(Curve::new(against_time(|m| m.psi1)).series(n).width(0.8));
        ratios = ratios.curve(Curve::new(against_time(|m| m.ratio)).series(n));
    }
    let ends = escapes.iter().filter_map(|(_, moments)| moments.last());
    let quarter = |psi: f64| (psi - PI / 2.0).abs() < 3e-3;
    let tend = ends
        .clone()
        .all(|end| quarter(end.psi) && quarter(end.psi1));
    let ratio = ends.clone().map(|end| end.ratio);
    let mut settled: Vec<_> = ratio.clone().map(|ratio| format!("{ratio:.2}")).collect();
    settled.dedup();
    let follows = Rule::horizontal(1.0).dotted();
    Plot::new("turntable-following", "How the angle follows its quasi-fixed point")
        .caption(
            "Three escapes. First $\\psi$ (thick) and, at the $\\alpha$ of the same moment, $\\psi_1$ \
             (thin). Both {{tend to|stay away from}} $\\pi/2$. Then the ratio $(\\pi/2-\\psi)/(\\pi/2-\\psi_1)$. \
             If $\\psi$ followed $\\psi_1$, it would tend to 1 ({{line followed}} line).",
        )
        .alt(format!(
            "Two panels against time on a logarithmic axis. In the first, thick and thin curves rise together to \
             a quarter turn. In the second, all {{{{three}}}} ratios settle at about {}, {{{{below|above}}}} the {{{{line followed}}}} line at 1.",
            settled.join(" or ")
        ))
        .says(["tend to|stay away from"], tend)
        .says(["three"], if settled.len() == 1 { ratio.clone().count() } else { 0 })
        .says(["below|above"], sides(ratio, 1.0))
        .panel(angles)
        .panel(ratios.rule(follows.label("followed")))
        .figure(table)
}
