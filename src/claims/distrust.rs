//! The trials that notice no mistake, and why they need not.

pub use trialbook::claims::variants::Idle;

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
    idle("fig-2", "drawn::fig2_motion", DRAWN),
    idle("fig-3", "drawn::fig3_frame", FRAME),
    idle("fig-4", "drawn::fig4_frame", FRAME),
    idle("s23-threshold-exists", "threshold::both_ends", NO_NUMBER),
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
];

const ONE_MOTION: &str = "motions are compared with each other: what is said of them, that they end alike, has no formula";
const ON_THE_WAY: &str =
    "that a velocity across the drive matters on the way is said without a formula";
const DRAWN: &str =
    "the drawn motion is held against another integrator; the paper prints no points";
const FRAME: &str = "the frame of a picture is tried, whose edge no formula gives";
const NO_NUMBER: &str =
    "the claim says that there is a threshold, or more, and no number; the bounds are our own";

const fn idle(claim: &'static str, trial: &'static str, reason: &'static str) -> Idle {
    Idle {
        claim,
        trial,
        reason,
    }
}
