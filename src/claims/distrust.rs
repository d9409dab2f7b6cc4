//! The trials that notice no mistake, and why they need not.

pub use trialbook::claims::variants::{Coarse, Idle, Survivor, Unread};

/// Trials that agree and notice no mistake in what they read, or read nothing. A test holds the list against the trials.
pub const IDLE: &[Idle] = &[
    idle("eq-33", "periodic::eq33_unique", ONE_MOTION),
    idle("eq-38", "periodic::eq38_unique", ONE_MOTION),
    idle("s22-rest-interval", "periodic::eq33_unique", ONE_MOTION),
    idle("s22-vy-two-stages", "decay::finite_end", ONE_MOTION),
    idle(
        "s22-attractor-ignores-vy",
        "across::ignores_census",
        ON_THE_WAY,
    ),
    idle(
        "s21-incline-only-constant",
        "only_constant::turns",
        IN_WORDS,
    ),
    idle(
        "s21-incline-only-constant",
        "only_constant::both_ways",
        IN_WORDS,
    ),
    idle("s23-mostly-at-rest", "mostly::two_valued", BESIDE),
    idle("fig-2", "drawn::fig2_motion", DRAWN),
    idle("fig-3", "drawn::fig3_frame", FRAME),
    idle("fig-4", "drawn::fig4_frame", FRAME),
    idle(
        "s23-threshold-exists",
        "threshold::two_zeros_root",
        NO_NUMBER,
    ),
    idle(
        "s23-threshold-exists",
        "threshold::again_and_again",
        NO_NUMBER,
    ),
    idle("s23-threshold-exists", "threshold::with_mean_drift", BESIDE),
    idle("s23-threshold-exists", "threshold::with_mean_close", BESIDE),
];

const ONE_MOTION: &str = "motions are compared with each other: what is said of them, that they end alike, has no formula";
const ON_THE_WAY: &str =
    "that a velocity across the drive matters on the way is said without a formula";
const DRAWN: &str =
    "the drawn motion is held against another integrator; the paper prints no points";
const FRAME: &str = "the frame of a picture is tried, whose edge no formula gives";
const NO_NUMBER: &str =
    "the claim says that there is a threshold, or more, and no number; the bounds are our own";

const IN_WORDS: &str = "that two kinds of motion differ is said without a formula";
const BESIDE: &str = "it is remarked beside the claim, which has no formula";

const fn idle(claim: &'static str, trial: &'static str, reason: &'static str) -> Idle {
    Idle {
        claim,
        trial,
        reason,
    }
}

/// Measurements that do not notice a mistake of twice their tolerance. A test holds the list against the trials.
pub const COARSE: &[Coarse] = &[
    coarse(
        "s2-perpendicular-decays",
        "properties::across_integration",
        "s2_across_trend",
        SIGN,
    ),
    coarse(
        "s2-perpendicular-decays",
        "properties::across_quadrature",
        "s2_across_trend",
        SIGN,
    ),
    coarse(
        "s2-speeds-up-if-strong",
        "properties::grows_integration",
        "s2_speeds_up_above",
        BOUNDS,
    ),
    coarse(
        "s2-stops-if-weak",
        "properties::stops_integration",
        "s2_stops_below",
        BOUNDS,
    ),
    coarse(
        "eq-8",
        "hodograph::eq8_motion",
        "eq8_hodograph_slope",
        "the slope is compared by its angle, which moves by at most half as much",
    ),
    coarse(
        "s21-large-friction-stops",
        "extremes::large_friction_turns",
        "turning_slope",
        "the unit grows with the friction, as what rounding of the angle makes of the sum does",
    ),
    coarse(
        "s22-friction-across",
        "argument::across_proportional",
        "s22_across_friction",
        "a ratio is compared, which no factor changes",
    ),
    coarse("eq-33", "periodic::eq33_motion", "eq33_ends", JOINTS),
    coarse("eq-38", "periodic::eq38_motion", "eq38_ends", JOINTS),
    coarse("eq-44", "pulses::eq44_motion", "eq44_ends", JOINTS),
    coarse("eq-44", "pulses::eq44_plane", "eq44_cases", HALF),
    coarse("eq-44", "pulses::eq44_plane", "eq44_ends", JOINTS),
    coarse("eq-45", "pulses::eq45_motion", "eq45_w", HALF),
    coarse("eq-45", "pulses::eq45_plane", "eq45_w", HALF),
    coarse(
        "eq-46",
        "drawn::shares_motion",
        "eq46_lambda_c",
        "it says which motions have rests; close to where they appear they last for no time",
    ),
    coarse(
        "eq-46",
        "pulses::below_motion",
        "small_friction_ends",
        JOINTS,
    ),
    coarse(
        "eq-46",
        "pulses::below_motion",
        "small_friction_start",
        HALF,
    ),
    coarse("eq-62", "scaling::eq62", "eq62_kappa", SUM),
    coarse("eq-69", "scaling::eq69", "eq69_time", SUM),
    coarse("eq-71", "scaling::eq71", "eq71_slip", SUM),
    coarse("eq-71", "scaling::eq71_both_ways", "eq71_slip", SUM),
    coarse("eq-72", "scaling::eq72", "eq72_acceleration", SUM),
    coarse(
        "eq-130",
        "growth::corrected130_limit",
        "thrice_alpha_exp",
        "a third of its logarithm is compared",
    ),
    coarse("eq-132", "growth::corrected132_limit", "a", HALF),
    coarse("eq-132", "growth::eq132_exponent", "eq132_a", EXPONENT),
    coarse(
        "eq-133",
        "growth::corrected133_limit",
        "twice_alpha_exp",
        HALF,
    ),
    coarse("eq-134", "growth::corrected134_exponent", "lag", EXPONENT),
    coarse("eq-135", "growth::corrected135_limit", "amplitude", HALF),
    coarse("eq-135", "growth::corrected135_limit", "rho", HALF),
    coarse("eq-135", "growth::eq135_exponent", "eq135_p", EXPONENT),
    coarse("eq-136", "growth::eq136_exponent", "eq136_rho", EXPONENT),
    coarse("eq-137", "growth::corrected137_limit", "s", HALF),
    coarse("eq-137", "growth::eq137_exponent", "eq137_s", EXPONENT),
    coarse(
        "s4-envelope-is-boundary",
        "boundary::corrected_root",
        "boundary_curvature",
        "it is the coefficient of a small term of what is compared",
    ),
];

const SIGN: &str = "it states a sign";
const BOUNDS: &str = "it sets bounds, to which no motion that is tried comes so close";
const JOINTS: &str = "where one case ends, the next begins with the same value: a slight shift shows in the second order only";
const HALF: &str = "what is compared is at most half the unit, which is the size of its terms";
const SUM: &str = "the unit is the size of all terms that the motion adds up, of which this is one";
const EXPONENT: &str = "an exponent is compared, which no factor changes";

const fn coarse(
    claim: &'static str,
    trial: &'static str,
    formula: &'static str,
    reason: &'static str,
) -> Coarse {
    Coarse {
        claim,
        trial,
        formula,
        reason,
    }
}

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
