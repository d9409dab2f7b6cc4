//! Trials of the sphere under any periodic drive: what section 2.3 says of the particle, with λ₀ of (84).

use super::driven::{Swing, of_settled, part};
use super::every_drive::rolling_time;
use super::prelude::*;
use crate::claims::periodic::drives::Harmonics;
use crate::claims::periodic::threshold::{Bounds, bounds};
use crate::paper::periodic;

/// A drive of three harmonics at random, and the frictions between which section 2.3 leaves it open whether it rests.
fn any(points: &mut Points) -> Result<(Harmonics, Drive, Bounds), Failure> {
    loop {
        let shape = Harmonics::random(points)?;
        let drive = shape.drive()?;
        let bounds = bounds(&drive);
        // So little friction that many periods pass before a start is forgotten is left out.
        if bounds.low > 0.1 {
            return Ok((shape, drive, bounds));
        }
    }
}

fn rolls(swing: &Swing, shape: &Harmonics, start: [f64; 2]) -> Result<f64, Failure> {
    let [w, share] = start;
    let (from, to) = (swing.t(LATE * TAU), swing.t((LATE + 1.0) * TAU));
    let plane = swing.harmonics(shape);
    let motion = swing.sphere.run(&plane, &swing.start(w, share), to)?;
    Ok(rolling_time(&motion, from, to)? / (to - from))
}

/// Periods after which a motion counts as settled.
const LATE: f64 = 6.0;

fn start(points: &mut Points) -> [f64; 2] {
    [points.uniform(-1.0, 1.0), points.uniform(-1.0, 2.0)]
}

pub(super) fn census() -> Evidence {
    let trial = Trial::census(
        Printed,
        Compared::constant(
            r"0 below the lower bound of section 2.3 for $\lambda_0$ of (84), 1 above the upper one and 2 above 1",
            "what a sphere does in a late period (0 if it never rolls, 1 if it rolls at times, 2 if it always does)",
        ),
    );
    trial.drawn(0..30, |i, points| {
        let (shape, _, Bounds { low, high }) = any(points)?;
        let share = points.uniform(0.05, 0.95);
        let lambda = match i % 3 {
            0 => low * (0.8 + 0.2 * share),
            1 => high + (1.0 - high) * share,
            _ => 1.0 + share,
        };
        let swing = Swing::new(i, points, lambda);
        let rolled = rolls(&swing, &shape, start(points))?;
        let own = swing.stated();
        let [least, _] = periodic::s23_rest_sides(own);
        let stated = if own > least {
            2.0
        } else if own > high {
            1.0
        } else if own < low {
            0.0
        } else {
            f64::NAN
        };
        let found = match rolled {
            0.0 => 0.0,
            part if part > 1.0 - 1e-12 => 2.0,
            _ => 1.0,
        };
        Ok(Pair::plain(swing.at(), stated, found))
    })
}

pub(super) fn parts() -> Evidence {
    let trial = Trial::motion(
        Printed,
        [
            r"the part of a period in which a particle rests under the same drive, with $\lambda_0$ of (84),",
            "that of a late period in which a sphere rolls",
        ],
    );
    trial.drawn(0..20, |i, points| {
        let (shape, drive, Bounds { high, .. }) = any(points)?;
        let lambda = high + (1.0 - high) * points.uniform(0.05, 0.8);
        let swing = Swing::new(i, points, lambda);
        let found = rolls(&swing, &shape, start(points))?;
        let own = swing.stated();
        Ok(Pair {
            at: swing.at(),
            stated: of_settled(&drive, own, own, |all| part(all, Sign::Rest)),
            found,
            scale: 1.0 / (1.0 - lambda),
        })
    })
}

attempts![census, parts];
