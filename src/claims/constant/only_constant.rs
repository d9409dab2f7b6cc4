//! Trials of how a drive that changes with time differs from an inclined plane: along the slope the sense of sliding
//! changes once at most, under a drive again and again.

use super::prelude::*;

/// Periods, or as many units of time on an incline.
const PERIODS: f64 = 6.0;

/// On an incline or under a sine; which it is and how it is called.
fn motion(points: &mut Points, i: usize) -> Result<(bool, String, Motion), Failure> {
    let (driven, lambda) = (i.is_multiple_of(2), points.uniform(0.0, 0.9));
    let start = State::moving([points.uniform(-2.0, 2.0), 0.0]);
    let pull = match driven {
        true => Signal::Sine {
            frequency: 1.0,
            phase: points.uniform(0.0, TAU),
        },
        false => Signal::constant(1.0),
    };
    // Without friction a fast particle goes to and fro without turning back.
    let lambda = lambda.max(0.2);
    let plane = Plane::along([-1.0, 0.0], pull);
    let name = match driven {
        true => "a sine",
        false => "an incline",
    };
    let at = format!("{name}, λ = {lambda:.6}, v₀ = {:.6}", start.v[0]);
    Ok((driven, at, run(&plane, lambda, start, PERIODS * TAU)?))
}

/// One after the other.
fn senses(motion: &Motion) -> Result<Vec<f64>, Failure> {
    let mut senses: Vec<f64> = Vec::new();
    for k in 0..=600 {
        let v = motion.at(PERIODS * TAU * f64::from(k) / 600.0)?.v[0];
        if v != 0.0 && senses.last() != Some(&v.signum()) {
            senses.push(v.signum());
        }
    }
    Ok(senses)
}

pub(super) fn turns() -> Evidence {
    Trial::census(
        Printed,
        Compared::constant(
            "0 for a constant pull, 1 for a sine",
            "whether the sense of sliding changes more than once (1 if so)",
        ),
    )
    .drawn(0..60, |i, points| {
        let (driven, at, motion) = motion(points, i)?;
        Ok(Pair::plain(at, is(driven), is(senses(&motion)?.len() > 2)))
    })
}

fn both_ways() -> Evidence {
    let trial = Trial::by(
        Integration,
        Printed,
        Compared::constant(
            r"$-1$ for a sine, 1 for a constant pull",
            "the sign of the product of the velocities at two late times, half a period apart, at which the particle slides,",
        ),
        NONE,
    );
    trial.drawn(0..60, |i, points| {
        let (driven, at, motion) = motion(points, i)?;
        let mut largest = (0.0, 0.0);
        for k in 0..100 {
            let t = TAU * (4.0 + f64::from(k) / 100.0);
            let v = motion.at(t)?.v[0];
            if v.abs() > largest.1 {
                largest = (t, v.abs());
            }
        }
        let of = |t: f64| -> Result<f64, Failure> { Ok(motion.at(t)?.v[0]) };
        let product = of(largest.0)? * of(largest.0 + 0.5 * TAU)?;
        Ok(Pair::plain(
            at,
            if driven { -1.0 } else { 1.0 },
            product.signum(),
        ))
    })
}

attempts![turns, both_ways];
