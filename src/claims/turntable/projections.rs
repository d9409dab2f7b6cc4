//! Trials of where (100) and (101) come from: which rate the two laws of motion are combined with.

use super::singular_starts::first_rate;
use super::trajectories::{ANY, View, stretches, sum};
use crate::corrections::turntable as corrected;
use crate::evidence::{Evidence, Subject};
use crate::motion::turntable::{State, Table};
use crate::paper::turntable as printed;
use trialbook::claims::attempt::{Attempt, trials};
use trialbook::claims::compare::{Compared, Failure, Pair, Trial};

/// ∫ rate dτ along stretches of motion with the change of the quantity.
fn change(
    subject: Subject,
    compared: Compared,
    quantity: fn(&View) -> f64,
    rate: fn(&View) -> f64,
) -> Evidence {
    Trial::quadrature(subject, compared).over(stretches(ANY), |stretch| {
        let stretch = stretch?;
        let [begin, end] = [stretch.view(stretch.from)?, stretch.view(stretch.to)?];
        let scale = 1f64.max(quantity(&begin).abs()).max(quantity(&end).abs());
        let at = |tau: f64| stretch.view(tau).map_or(f64::NAN, |view| rate(&view));
        Ok(Pair {
            at: stretch.at(),
            stated: sum(at, stretch.from, stretch.to, 1e-13 * scale),
            found: quantity(&end) - quantity(&begin),
            scale,
        })
    })
}

/// (99), as described.
pub fn tangential() -> Evidence {
    let compared = Compared::one(
        r"the integral of the projection of (89) on the velocity, along the motion,",
        r"the change of $p$",
    );
    change(
        Subject::Within,
        compared,
        |v| v.p,
        |v| printed::s4_tangential_rate([v.xi, -v.ell], [v.p, 0.0]),
    )
}

/// The rate of u: section 4 has no u, and so no value for it.
const U_RATE: f64 = f64::NAN;

/// (100), as described.
pub fn azimuthal() -> Evidence {
    let compared = Compared::one(
        r"the integral of $\mathrm d\ell/\mathrm d\tau$ by the law of the angular momentum and $\mathrm du/\mathrm d\tau$, along the motion,",
        r"the change of $\ell$",
    );
    change(
        Subject::Printed,
        compared,
        |v| v.ell,
        |v| printed::s4_azimuthal_rate(v.p, v.ell, v.xi, U_RATE),
    )
}

/// With the rate of p.
fn azimuthal_corrected() -> Evidence {
    let compared = Compared::one(
        r"the integral of $\mathrm d\ell/\mathrm d\tau$ by the law of the angular momentum and $\mathrm dp/\mathrm d\tau$, along the motion,",
        r"the change of $\ell$",
    );
    change(
        Subject::Corrected,
        compared,
        |v| v.ell,
        |v| corrected::azimuthal_rate(v.p, v.ell, v.xi),
    )
}

/// (101), as described.
pub fn radial() -> Evidence {
    let compared = Compared::one(
        r"the integral of $\mathrm d\xi/\mathrm d\tau$ by the law along the radius and $\mathrm du/\mathrm d\tau$, along the motion,",
        r"the change of $\xi$",
    );
    change(
        Subject::Printed,
        compared,
        |v| v.xi,
        |v| printed::s4_radial_rate(v.p, v.ell, v.xi, U_RATE),
    )
}

/// With the rate of p.
fn radial_corrected() -> Evidence {
    let compared = Compared::one(
        r"the integral of $\mathrm d\xi/\mathrm d\tau$ by the law along the radius and $\mathrm dp/\mathrm d\tau$, along the motion,",
        r"the change of $\xi$",
    );
    change(
        Subject::Corrected,
        compared,
        |v| v.xi,
        |v| corrected::radial_rate(v.p, v.ell, v.xi),
    )
}

/// The rate of a quantity at p = 1, ℓ = 1, ξ = 2, by differences along the motion.
pub fn in_the_motion(quantity: fn(&View) -> f64) -> Result<f64, Failure> {
    let start = State {
        t: 0.0,
        x: [2.0, -1.0],
        v: [1.0, 0.0],
    };
    first_rate(&Table::default(), &start, |s| quantity(&View::of(s)))
}

pub(super) const TRIALS: &[Attempt] = trials![
    tangential,
    azimuthal,
    azimuthal_corrected,
    radial,
    radial_corrected
];
