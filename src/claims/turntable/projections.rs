//! Trials of where (100) and (101) come from: which rate the two laws of motion are combined with.

use super::prelude::*;
use super::rates::change;
use super::singular_starts::first_rate;
use crate::corrections::turntable as corrected;

/// The rate of u: section 4 has no u, and so no value for it.
const U_RATE: f64 = f64::NAN;

/// The rate of a quantity at p = 1, ℓ = 1, ξ = 2, by differences along the motion.
pub(crate) fn in_the_motion(quantity: fn(&View) -> f64) -> Result<f64, Failure> {
    let start = State {
        t: 0.0,
        x: [2.0, -1.0],
        v: [1.0, 0.0],
    };
    first_rate(&Table::default(), &start, |s| quantity(&View::of(s)))
}

const BY_MOMENT_AND_U: &str = r"$\mathrm d\ell/\mathrm d\tau$ by the law of the angular momentum and $\mathrm du/\mathrm d\tau$,";
const BY_MOMENT_AND_P: &str = r"$\mathrm d\ell/\mathrm d\tau$ by the law of the angular momentum and $\mathrm dp/\mathrm d\tau$,";
const BY_RADIUS_AND_U: &str =
    r"$\mathrm d\xi/\mathrm d\tau$ by the law along the radius and $\mathrm du/\mathrm d\tau$,";
const BY_RADIUS_AND_P: &str =
    r"$\mathrm d\xi/\mathrm d\tau$ by the law along the radius and $\mathrm dp/\mathrm d\tau$,";

fn projected(
    subject: Subject,
    quantity: Quantity,
    law: &'static str,
    rate: fn(&View) -> f64,
) -> Evidence {
    change(law, subject, ANY, quantity, rate)
}

attempts![
    tangential = projected(Within, P, "the projection of (89) on the velocity,", |v| {
        printed::s4_tangential_rate([v.xi, -v.ell], [v.p, 0.0])
    }),
    azimuthal | azimuthal_corrected = projected(ELL)(
        (BY_MOMENT_AND_U, |v| {
            printed::s4_azimuthal_rate(v.p, v.ell, v.xi, U_RATE)
        }) | (BY_MOMENT_AND_P, |v| {
            corrected::azimuthal_rate(v.p, v.ell, v.xi)
        })
    ),
    radial | radial_corrected = projected(XI)(
        (BY_RADIUS_AND_U, |v| {
            printed::s4_radial_rate(v.p, v.ell, v.xi, U_RATE)
        }) | (BY_RADIUS_AND_P, |v| corrected::radial_rate(
            v.p, v.ell, v.xi
        ))
    )
];
