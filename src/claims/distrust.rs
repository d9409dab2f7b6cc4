//! The mistakes in a corner that nothing notices, and why nothing need.

pub use trialbook::claims::variants::{Survivor, Unread};

/// Mistakes in a corner that no measurement notices. A test holds the list against the trials.
pub const CORNERED: &[Survivor] = &[
    cornered(
        "s2-no-permanent-rest",
        "s2_rest_ends_above 1 % more where μ > 1",
        BORDER,
    ),
    cornered(
        "s2-speeds-up-if-strong",
        "s2_speeds_up_above 1 % more where μ > 1",
        BORDER,
    ),
    cornered(
        "s2-stops-if-weak",
        "s2_stops_below 1 % more where μ > 1",
        BORDER,
    ),
    cornered(
        "s22-vy-two-stages",
        "last_stage 1 % more where 0 < λ₀ < 0.001",
        RESTS,
    ),
    cornered(
        "eq-44",
        "eq44_ends 1 % more where 0 < λ₀ < 0.001",
        "where one case ends, the next begins with the same value, and both are small there",
    ),
    cornered(
        "s22-friction-across",
        "s22_across_friction 1 % more where 0 < λ₀ < 0.001",
        "with so little friction many periods pass before the motion is periodic",
    ),
    cornered(
        "s24-region-2",
        "e_sides with inverse function 2 on the other branch over the upper half of its range",
        BELOW,
    ),
    cornered(
        "eq-54",
        "eq54_sides with inverse function 2 on the other branch over the upper half of its range",
        BELOW,
    ),
    cornered(
        "eq-146",
        "surface_slope 1 % more where 0 < α < 0.01",
        "at the distance at which it is measured, the law itself is right to one in a hundred",
    ),
    cornered(
        "eq-147",
        "boundary_least 1 % more where 0 < α < 0.01",
        "it is measured from α = 0.01 on; below that its series is proved",
    ),
];

const BORDER: &str = "it is a border, and no motion that is tried is within one in a hundred of it";
const RESTS: &str = "it is about rests, of which there are none with so little friction";
const BELOW: &str = "it is the arcsine of λ₀, and on the curve λ₀ stays below 0.54";

const fn cornered(claim: &'static str, text: &'static str, reason: &'static str) -> Survivor {
    Survivor {
        claim,
        text,
        reason,
    }
}

/// Formulas in whose corners mistakes are made and that no measurement reads which agrees. A test holds the list against the
/// trials.
pub const UNREAD: &[Unread] = &[
    unread("eq-82", "eq82_time", FAILS),
    unread("eq-83", "eq83_slip_at_time", FAILS),
    unread("eq-128", "eq128_alpha_rate", FAILS),
    unread("eq-129", "eq129_a", FAILS),
    unread("eq-134", "eq134_lag", FAILS),
    unread(
        "eq-143",
        "eq143_psi",
        "its constant and its exponent are measured, which are formulas of their own; the whole is proved, and as one \
         expression without cases it cannot be wrong in a corner alone",
    ),
    unread("eq-147", "eq147_a", FAILS),
];

const FAILS: &str = "as printed it fails, and no measurement agrees with it";

const fn unread(claim: &'static str, formula: &'static str, reason: &'static str) -> Unread {
    Unread {
        claim,
        formula,
        reason,
    }
}
