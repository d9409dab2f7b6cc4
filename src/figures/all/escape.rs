//! Figures of section 4, escape.

use super::AllFiguresError;
use crate::claims::escape::laws::{self, Quantity, lag, size, speed};
use crate::claims::escape::runs::{Flight, Late, Launch};
use crate::figures::{Figure, escape as escape_figures};
use crate::motion::MotionError;
use crate::motion::turntable::{State, Table, critical_radius, inertial};

pub(super) fn figures() -> Result<Vec<Figure>, AllFiguresError> {
    Ok(vec![compensated()?, paths()?, fan()?])
}

/// Three escapes, over seven decades of the time.
fn compensated() -> Result<Figure, AllFiguresError> {
    let launches = [(1.2, 0.3, 1.0), (2.0, 0.5, -1.0), (8.0, 1.0, 2.0)];
    let moments: Vec<Vec<Late>> = launches
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
        .collect::<Result<_, _>>()?;
    let followed = |quantity: Quantity| {
        let one = |moments: &Vec<Late>| moments.iter().map(|l| [l.tau, quantity(l)]).collect();
        moments.iter().map(one).collect()
    };
    Ok(escape_figures::compensated(&[
        escape_figures::Compensated {
            name: "p/tau^2",
            axis: "p/τ^2",
            range: (0.18, 0.26),
            printed: Some(laws::printed_speed()),
            corrected: laws::corrected_speed(),
            escapes: followed(speed),
        },
        escape_figures::Compensated {
            name: "A/tau^(3/2)",
            axis: "A/τ^{3/2}",
            range: (0.34, 0.42),
            printed: Some(laws::printed_size()),
            corrected: laws::corrected_size(),
            escapes: followed(size),
        },
        escape_figures::Compensated {
            name: "(pi/2 - psi) tau",
            axis: "(π/2 − ψ) τ",
            range: (1.5, 3.0),
            printed: None,
            corrected: laws::corrected_lag(),
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

/// Particles put down along a ray, the nearer to the critical radius the closer to each other.
fn fan() -> Result<Figure, AllFiguresError> {
    let critical = critical_radius()?;
    let steps = [
        -0.372, -0.27, -0.18, -0.11, -0.06, -0.03, -0.01, -0.001, -0.0001,
    ];
    let outward = [0.0001, 0.001, 0.01, 0.03, 0.06, 0.11, 0.18, 0.25, 0.33];
    let ways = steps.into_iter().chain(outward).map(|step| {
        let start = State {
            t: 0.0,
            x: [critical + step, 0.0],
            v: [0.0; 2],
        };
        let until = 16.0;
        let run = inertial::run(&Table::default(), &start, until)?;
        let rests = run.resting_place().is_some();
        // A particle at rest adds nothing to its way.
        let end = if rests {
            run.stops().last().map_or(until, |stop| stop.min(until))
        } else {
            until
        };
        let way: Result<_, MotionError> = (0..=160)
            .map(|i| {
                let t = end * f64::from(i) / 160.0;
                let [x, y] = run.on_table(t)?.x;
                Ok([t, x, y])
            })
            .collect();
        Ok(escape_figures::PutDown {
            rho: critical + step,
            rests,
            way: way?,
        })
    });
    let ways = ways.collect::<Result<Vec<_>, MotionError>>()?;
    Ok(escape_figures::fan(&ways, critical)?)
}
