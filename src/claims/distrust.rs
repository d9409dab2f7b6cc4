//! The trials that mistakes do not move as they move others, and why.

/// A trial by its claim and its name, and a reason.
pub type Excuse = (&'static str, &'static str, &'static str);

/// Trials that agree and notice no mistake in what they read, or read nothing. A test holds the list against the trials.
pub const IDLE: &[Excuse] = &[
    ("eq-33", "periodic::eq33_unique", ONE_MOTION),
    ("eq-38", "periodic::eq38_unique", ONE_MOTION),
    ("s22-rest-interval", "periodic::eq33_unique", ONE_MOTION),
    ("s22-vy-two-stages", "decay::finite_end", ONE_MOTION),
    (
        "s22-attractor-ignores-vy",
        "across::ignores_census",
        ON_THE_WAY,
    ),
    ("fig-2", "drawn::fig2_motion", DRAWN),
    ("fig-3", "drawn::fig3_frame", FRAME),
    ("fig-4", "drawn::fig4_frame", FRAME),
    ("s23-threshold-exists", "threshold::both_ends", NO_NUMBER),
    (
        "s23-threshold-exists",
        "threshold::two_zeros_root",
        NO_NUMBER,
    ),
    (
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

/// Trials that find something else, or look elsewhere, when a mistake is seeded in a formula. A test holds the list against
/// the trials.
pub const LEANING: &[Excuse] = &[];
