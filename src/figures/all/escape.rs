//! Figures of section 4, escape.

use super::AllFiguresError;
use crate::claims::escape::escapes::{Flight, Late, Launch};
use crate::claims::escape::growth::{self, Quantity, lag, size, speed};
use crate::figures::escape as escape_figures;
use crate::motion::MotionError;
use crate::motion::turntable::{State, Table, critical_radius, inertial};
use trialbook::figures::Figure;

pub(super) fn figures() -> Result<Vec<Figure>, AllFiguresError> {
    let moments = moments()?;
    Ok(vec![
        compensated(&moments)?,
        residual(&moments)?,
        paths()?,
        fan()?,
    ])
}

/// Three escapes, over seven decades of the time.
fn moments() -> Result<Vec<Vec<Late>>, AllFiguresError> {
    let launches = [(1.2, 0.3, 1.0), (2.0, 0.5, -1.0), (8.0, 1.0, 2.0)];
    let all: Result<_, MotionError> = launches
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

/// What the first correction leaves of their speeds.
fn residual(moments: &[Vec<Late>]) -> Result<Figure, AllFiguresError> {
    let left = |late: &Late| {
        [
            late.tau,
            (speed(late) / growth::corrected_speed() - 1.0) * late.tau,
        ]
    };
    let escapes: Vec<Vec<_>> = moments
        .iter()
        .map(|one| one.iter().map(left).collect())
        .collect();
    Ok(escape_figures::residual(
        &escapes,
        growth::corrected_speed_log(),
    )?)
}

/// Their growth.
fn compensated(moments: &[Vec<Late>]) -> Result<Figure, AllFiguresError> {
    let followed = |quantity: Quantity| {
        let one = |moments: &Vec<Late>| moments.iter().map(|l| [l.tau, quantity(l)]).collect();
        moments.iter().map(one).collect()
    };
    Ok(escape_figures::compensated(&[
        escape_figures::Compensated {
            name: "p/tau^2",
            axis: "p/τ^2",
            range: (0.18, 0.26),
            printed: Some(growth::printed_speed()),
            corrected: growth::corrected_speed(),
            escapes: followed(speed),
        },
        escape_figures::Compensated {
            name: "A/tau^(3/2)",
            axis: "A/τ^{3/2}",
            range: (0.34, 0.42),
            printed: Some(growth::printed_size()),
            corrected: growth::corrected_size(),
            escapes: followed(size),
        },
        escape_figures::Compensated {
            name: "(pi/2 - psi) tau",
            axis: "(π/2 − ψ) τ",
            range: (1.5, 3.0),
            printed: None,
            corrected: growth::corrected_lag(),
            escapes: followed(lag),
        },
    ])?)
}

/// Two particles put down at rest in the laboratory.
fn paths() -> Result<Figure, AllFiguresError> {
    let table = Table::default();
    let path = |rho: f64, until: f64, label: &str| -> Result<_, MotionError> {
        let start = State {
            t: 0.0,
            x: [rho, 0.0],
            v: [0.0; 2],
        };
        let run = inertial::run(&table, &start, until)?;
        let (mut on_table, mut in_laboratory) = (Vec::new(), Vec::new());
        for i in 0..=400 {
            let t = until * f64::from(i) / 400.0;
            let (seen, here) = (run.on_table(t)?, run.at(t)?);
            on_table.push([t, seen.x[0], seen.x[1]]);
            in_laboratory.push([t, here.x[0], here.x[1]]);
        }
        Ok(escape_figures::Path {
            label: label.into(),
            table: on_table,
            laboratory: in_laboratory,
        })
    };
    Ok(escape_figures::paths(&[
        path(0.86, 14.0, "ρ_0 = 0.86: rest")?,
        path(0.89, 14.0, "ρ_0 = 0.89: escape")?,
    ])?)
}

/// Particles put down along a ray, on both sides of the critical radius.
fn fan() -> Result<Figure, AllFiguresError> {
    let critical = critical_radius()?;
    let steps = [
        -0.5, -0.36, -0.24, -0.14, -0.06, -0.01, 0.001, 0.01, 0.05, 0.12, 0.24, 0.4,
    ];
    let ways = steps.map(|step| -> Result<_, MotionError> {
        let rho = critical + step;
        let start = State {
            t: 0.0,
            x: [rho, 0.0],
            v: [0.0; 2],
        };
        let run = inertial::run(&Table::default(), &start, 16.0)?;
        let rests = run.resting_place().is_some();
        // What happens at rest, or outside the picture, adds nothing.
        let end = run
            .stops()
            .last()
            .copied()
            .filter(|_| rests)
            .unwrap_or(16.0);
        let mut way = Vec::new();
        for i in 0..=120 {
            let t = end * f64::from(i) / 120.0;
            let seen = run.on_table(t)?;
            way.push([t, seen.x[0], seen.x[1]]);
            if seen.radius() > 4.5 {
                break;
            }
        }
        Ok(escape_figures::PutDown { rho, rests, way })
    });
    let ways = ways.into_iter().collect::<Result<Vec<_>, _>>()?;
    Ok(escape_figures::fan(&ways, critical)?)
}
