//! The trials that read no formula of their claim.

pub use trialbook::claims::reading::Elsewhere;

const AT_WHICH: &str =
    "at which friction rests appear, and how often; that there are some, or none, others try";
const IN_WORDS: &str = "the claim in words: where the motion ends, whatever the formula says";
const PARTS: &str = "(15) and (16) are what the parabola is made of";
const DELAY: &str =
    "the first correction of every late law is the delay of the law's own time, times its power";

const BY_THE_LAW: &str = "a theorem about every motion, by the law that is proved elsewhere";

const AS_135: &str =
    "the distance grows as the speed, by the formula of (135); that of (136) is the winding";

const BETWEEN: &str = "where the curves are; which region lies between which, the others try";

/// All such trials. A test holds the list against what is read.
pub const ELSEWHERE: &[Elsewhere] = &[
    Elsewhere {
        claim: "s2-stops-if-weak",
        trial: "chains::STOPS",
        reason: BY_THE_LAW,
    },
    Elsewhere {
        claim: "s4-A-never-decreases",
        trial: "exact::NEVER_DECREASES",
        reason: BY_THE_LAW,
    },
    Elsewhere {
        claim: "s21-frictionless-parabola",
        trial: "exact::EQ15",
        reason: PARTS,
    },
    Elsewhere {
        claim: "s21-frictionless-parabola",
        trial: "exact::EQ16",
        reason: PARTS,
    },
    Elsewhere {
        claim: "s21-frictionless-parabola",
        trial: "limits::parabola_quadrature",
        reason: PARTS,
    },
    Elsewhere {
        claim: "eq-38",
        trial: "periodic::eq38_approach",
        reason: "how fast the periodic motion is approached, which (38) does not say",
    },
    Elsewhere {
        claim: "s22-four-points",
        trial: "phases::four_points_root",
        reason: "the places of the points, by (27) to (30); their number is tried beside it",
    },
    Elsewhere {
        claim: "s22-vy-vanishes",
        trial: "across::vanishes_census",
        reason: "(1) never lets the velocity grow before that",
    },
    Elsewhere {
        claim: "s24-vy-vanishes",
        trial: "across::never_grows",
        reason: "(1) never lets the velocity grow before that",
    },
    Elsewhere {
        claim: "s23-rest-above-one",
        trial: "rest::stopping_time",
        reason: "when it comes to rest, by (1)",
    },
    Elsewhere {
        claim: "eq-33",
        trial: "periodic::eq33_unique",
        reason: IN_WORDS,
    },
    Elsewhere {
        claim: "eq-38",
        trial: "periodic::eq38_unique",
        reason: IN_WORDS,
    },
    Elsewhere {
        claim: "s22-vy-two-stages",
        trial: "decay::finite_end",
        reason: IN_WORDS,
    },
    Elsewhere {
        claim: "s23-threshold-exists",
        trial: "threshold::two_zeros_root",
        reason: AT_WHICH,
    },
    Elsewhere {
        claim: "s23-threshold-exists",
        trial: "threshold::again_and_again",
        reason: AT_WHICH,
    },
    Elsewhere {
        claim: "eq-46",
        trial: "pulses::below_motion",
        reason: "what the motion is below the threshold, which other trials try",
    },
    Elsewhere {
        claim: "eq-82",
        trial: "angle::regular_time",
        reason: "the regular form is that of section 2.1, which no claim of section 3 restates",
    },
    Elsewhere {
        claim: "eq-132",
        trial: "growth::corrected132_delay",
        reason: DELAY,
    },
    Elsewhere {
        claim: "eq-135",
        trial: "growth::corrected135_delay",
        reason: DELAY,
    },
    Elsewhere {
        claim: "eq-136",
        trial: "exact::EQ136",
        reason: AS_135,
    },
    Elsewhere {
        claim: "eq-136",
        trial: "growth::corrected136_limit",
        reason: AS_135,
    },
    Elsewhere {
        claim: "eq-136",
        trial: "growth::corrected136_delay",
        reason: DELAY,
    },
    Elsewhere {
        claim: "eq-137",
        trial: "growth::corrected137_delay",
        reason: DELAY,
    },
    Elsewhere {
        claim: "fig-5",
        trial: "regions::corrected_curves",
        reason: BETWEEN,
    },
    Elsewhere {
        claim: "fig-5",
        trial: "certified::order",
        reason: BETWEEN,
    },
];
