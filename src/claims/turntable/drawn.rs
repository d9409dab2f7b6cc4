//! The motions that the chapter draws: two launches from the axis, one that comes to rest and one that escapes.

use super::prelude::*;

pub(crate) const SPEEDS: [f64; 2] = [1.0, 1.5];
pub(crate) const UNTIL: f64 = 7.0;

/// Dimensionless.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Moment {
    pub tau: f64,
    pub table: [f64; 2],
    pub laboratory: [f64; 2],
    /// Relative to the table.
    pub p: f64,
    pub rho: f64,
    /// Arc length on the table.
    pub s: f64,
}

#[derive(Debug, Clone)]
pub(crate) struct Launched {
    pub speed: f64,
    /// In order.
    pub moments: Vec<Moment>,
    /// When it comes to rest on the table, if it does.
    pub rest: Option<f64>,
}

/// By all three integrations: the place on the table by one, in the laboratory by another, the arc length by the
/// third.
pub(crate) fn launched(speed: f64) -> Result<Launched, MotionError> {
    let table = Table::default();
    let start = State {
        t: 0.0,
        x: [0.0; 2],
        v: [speed, 0.0],
    };
    let turning = rotating::run(&table, &start, UNTIL)?;
    let still = inertial::run(&table, &start, UNTIL)?;
    let parts = Run::new(&Start::launched(speed)?, UNTIL)?;
    let moment = |i: u32| -> Result<Moment, MotionError> {
        let tau = UNTIL * f64::from(i) / 250.0;
        let here = turning.at(tau)?;
        Ok(Moment {
            tau,
            table: here.x,
            laboratory: still.at(tau)?.x,
            p: here.speed(),
            rho: here.radius(),
            s: parts.at(tau)?.s,
        })
    };
    Ok(Launched {
        speed,
        moments: (0..=250).map(moment).collect::<Result<_, _>>()?,
        rest: turning.stops().first().copied(),
    })
}

pub(crate) fn kept() -> Evidence {
    let launches = SPEEDS.into_iter().map(launched);
    let all = launches.flat_map(|launch| {
        parts(launch.map(|l| l.moments.into_iter().map(move |moment| (l.speed, moment))))
    });
    Trial::motion(
        Printed,
        [
            "(104) at each drawn moment, on the way to rest and at rest,",
            "its value at the launch",
        ],
    )
    .over(all, |point| {
        let (speed, Moment { tau, p, rho, s, .. }) = point?;
        Ok(Pair {
            at: format!("launched from the axis with p = {speed}, at τ = {tau:.6}"),
            stated: printed::eq104_constant(p, rho, s),
            found: 0.5 * speed * speed,
            scale: 1f64.max(rho * rho),
        })
    })
}

attempts![kept];
