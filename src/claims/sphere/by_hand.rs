//! The two numbers of each case by hand. The words are in the claims' entries.

use super::prelude::*;

/// In the paper's order: what the printed formula says, and what the motion does.
pub(super) static CASES: [Numbers; 3] = [
    Numbers::new(
        "eq-75",
        || Ok(printed::eq75_spin(0.0, [0.0; 3], [1.0, 0.0, 0.0])[1]),
        || {
            let end = thrown(0.0, 2.0)?.end();
            Ok(end.omega[1] / end.v[0])
        },
    ),
    Numbers::new(
        "eq-82",
        || Ok(printed::eq82_time(1.75, 1.0, FRAC_PI_2, 1e-12)),
        end_of_slip,
    ),
    Numbers::new(
        "eq-83",
        || {
            Ok(printed::eq83_slip_at_time(
                1.75,
                1.0,
                FRAC_PI_2,
                0.0,
                14.0 / 33.0,
            ))
        },
        || {
            let slip = thrown(2.0, 1.0)?.slip(end_of_slip()?)?;
            Ok(libm::hypot(slip[0], slip[1]))
        },
    ),
];

/// A solid sphere thrown across with slip velocity 1 and no spin, on a plane with A = γμg, units of R and μg.
fn thrown(gamma: f64, until: f64) -> Result<BallMotion, Failure> {
    let start = match gamma {
        // Nothing is across: along the x axis.
        0.0 => [1.0, 0.0],
        _ => [0.0, 1.0],
    };
    let start = Ball {
        t: 0.0,
        x: [0.0, 0.0],
        v: start,
        omega: [0.0; 3],
    };
    Ok(Sphere::with_kappa(0.4).run(&Plane::constant([-gamma, 0.0]), &start, until)?)
}

/// With γ = 2.
fn end_of_slip() -> Result<f64, Failure> {
    let motion = thrown(2.0, 1.0)?;
    Ok(motion.transitions().first().ok_or("it slips on")?.t)
}
