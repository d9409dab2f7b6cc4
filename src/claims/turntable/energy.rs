//! Trials of work and energy: (104) to (106), and who does the work.

use super::prelude::*;
use super::trajectories::{Launch, launches};

fn change_of_eq104(stretch: &Stretch) -> Result<f64, Failure> {
    let [from, to] = [stretch.part(stretch.from)?, stretch.part(stretch.to)?];
    let [from, to] = [from, to].map(|part| printed::eq104_constant(part.p(), part.rho(), part.s));
    Ok(to - from)
}

fn balance(trial: &Trial, pair: impl Fn(&Stretch) -> Result<[f64; 2], Failure>) -> Evidence {
    trial.each(stretches(ANY), Stretch::at, |stretch| {
        let size = 0.5 * stretch.part(stretch.to)?.rho().powi(2);
        let [stated, found] = pair(stretch)?;
        Ok([stated, found, size.max(1.0)])
    })
}

/// By the motion found in the laboratory.
pub(super) fn way(launch: &Launch) -> Result<f64, Failure> {
    let speed = |t: f64| launch.still.on_table(t).map_or(f64::NAN, |s| s.speed());
    Ok(integral(speed, 0.0, launch.to)?.value)
}

fn work_step() -> Evidence {
    let points = Points::here().within(40, [[0.2, 3.0]; 3]);
    Trial::by(
        Consistency,
        Step,
        [
            "$-mgs$, the work of friction, over what kinetic and centrifugal energy gain by (106)",
            "the expected 1",
        ],
        FRAMES,
    )
    .at(["m", "g", "s"], points, 1.0, |[m, g, s]| {
        let at_rest = |s| printed::eq106_constant(m, g, 1.0, [0.0; 2], [0.0; 2], s);
        Ok([
            printed::friction_work(m, g, s) / (at_rest(0.0) - at_rest(s)),
            1.0,
        ])
    })
}

fn kept(
    subject: Subject,
    what: &'static str,
    energy: impl Fn(&Table, &State, f64) -> f64,
) -> Evidence {
    let compared = Compared::one(what, "0");
    Trial::by(Integration, subject, compared, FRAMES).each(launches(), Launch::at, |launch| {
        let Table { omega, mass: m, .. } = launch.table;
        let end = launch.still.on_table(launch.to)?;
        let size =
            |s: &State| 0.5 * m * (s.speed() * s.speed() + omega * omega * s.radius() * s.radius());
        Ok([
            energy(&launch.table, &end, way(launch)?) - energy(&launch.table, &launch.start, 0.0),
            0.0,
            size(&launch.start).max(size(&end)),
        ])
    })
}

/// The work that friction does on the particle relative to the table, as the laboratory has it. There friction
/// F is the only force, so that ∫ F·V dt is the change of m V²/2 and ∫ F·(Ω ẑ × X) dt is Ω times that of the
/// angular momentum; the work along V − Ω ẑ × X is their difference.
fn friction_work(launch: &Launch) -> Result<f64, Failure> {
    let Table { omega, mass: m, .. } = launch.table;
    let value = |s: &State| {
        let kinetic = 0.5 * m * (s.v[0] * s.v[0] + s.v[1] * s.v[1]);
        kinetic - omega * m * (s.x[0] * s.v[1] - s.x[1] * s.v[0])
    };
    Ok(value(&launch.still.at(launch.to)?) - value(&launch.still.at(0.0)?))
}

fn work(subject: Subject, stated: &'static str, formula: impl Fn(&Table, f64) -> f64) -> Evidence {
    let compared = Compared::one(
        stated,
        "the work of friction along the path of length $s$ on the table, found in the laboratory",
    );
    Trial::by(Integration, subject, compared, FRAMES).each(launches(), Launch::at, |launch| {
        let found = friction_work(launch)?;
        Ok([
            formula(&launch.table, way(launch)?),
            found,
            found.abs().max(launch.table.energy(&launch.start).abs()),
        ])
    })
}

pub(super) fn coriolis() -> Evidence {
    let trial = Trial::by(
        Integration,
        Printed,
        [
            "the work of the Coriolis force of (86)",
            "the change of kinetic energy in the frame of the table, less the works of the centrifugal force and of friction",
        ],
        FRAMES,
    );
    trial.each(launches(), Launch::at, |launch| {
        let Table { omega, mass: m, .. } = launch.table;
        let (begin, end) = (&launch.start, launch.turning.at(launch.to)?);
        let kinetic = |s: &State| 0.5 * m * s.speed() * s.speed();
        let centrifugal = |s: &State| 0.5 * m * omega * omega * s.radius() * s.radius();
        let friction = friction_work(launch)?;
        let power = |t: f64| {
            let state = launch.turning.at(t);
            state.map_or(f64::NAN, |s| printed::coriolis_power(m, omega, s.v))
        };
        let found =
            kinetic(&end) - kinetic(begin) - (centrifugal(&end) - centrifugal(begin)) - friction;
        let scale = kinetic(begin) + centrifugal(begin) + kinetic(&end) + centrifugal(&end);
        Ok([sum(power, 0.0, launch.to, 1e-15 * scale), found, scale])
    })
}

attempts![
    eq104 = Trial::motion(
        Printed,
        ["the change of (104) over a stretch of motion", "0"],
    )
    .each(stretches(ANY), Stretch::at, |stretch| {
        Ok([change_of_eq104(stretch)?, 0.0, 1.0])
    }),
    eq105 = Trial::by(
        Consistency,
        Printed,
        [
            r"the integral of (105) over $\tau$ in the frame of the table",
            "the arc length by components along the velocity",
        ],
        FRAMES,
    )
    .each(stretches(ANY), Stretch::at, |stretch| {
        Ok([
            stretch.sum(|v| printed::eq105_arc_rate(v.p), 1e-13),
            stretch.part(stretch.to)?.s - stretch.part(stretch.from)?.s,
            1.0,
        ])
    }),
    eq106 | eq106_corrected = kept(
        ("the change of (106) over a motion", |table, state, s| {
            printed::eq106_constant(table.mass, table.g, table.omega, state.x, state.v, s)
        }) | (
            r"the change of (106) with $m\mu gs$ over a motion",
            |table, state, s| {
                let Table { omega, mu, g, mass } = *table;
                corrections::constant(mass, mu, g, omega, state.x, state.v, s)
            }
        )
    ),
    eq104_kept = {
        let trial = Trial::motion(
            Printed,
            [
                "the change of (104), with $s$, over a stretch of motion",
                "the expected 0",
            ],
        );
        balance(&trial, |stretch| Ok([change_of_eq104(stretch)?, 0.0]))
    },
    eq104_without_s = {
        let trial = Trial::quadrature(
            Remark,
            [
                r"the integral of $-p$ over a stretch of motion",
                r"the change of $\frac12(p^2-\ell^2-\xi^2)$",
            ],
        );
        balance(&trial, |stretch| {
            let view = |tau| stretch.view(tau);
            let [begin, end] = [view(stretch.from)?, view(stretch.to)?];
            let value = |v: &View| 0.5 * (v.p * v.p - v.ell * v.ell - v.xi * v.xi);
            let rate = |v: &View| -printed::eq105_arc_rate(v.p);
            Ok([stretch.sum(rate, 1e-13), value(&end) - value(&begin)])
        })
    },
    friction | friction_corrected = work(
        ("$-mgs$", |table, s| {
            printed::friction_work(table.mass, table.g, s)
        }) | (r"$-m\mu gs$", |table, s| {
            corrections::friction_work(table.mass, table.mu, table.g, s)
        })
    ),
    coriolis,
    work_step
];
