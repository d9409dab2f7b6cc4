//! The trials that read no formula of their claim.

pub use trialbook::claims::reading::Elsewhere;

const IN_WORDS: &str = "the claim in words: where the motion ends, whatever the formula says";
const DELAY: &str =
    "the first correction of every late law is the delay of the law's own time, times its power";

/// All such trials. A test holds the list against what is read.
pub const ELSEWHERE: [Elsewhere; 10] = [
    Elsewhere {
        claim: "eq-33",
        compared: "1 with 1 where seven starts, near and far, end in the same motion",
        reason: IN_WORDS,
    },
    Elsewhere {
        claim: "eq-38",
        compared: "1 with 1 where seven starts, near and far, end in the same motion",
        reason: IN_WORDS,
    },
    Elsewhere {
        claim: "eq-41",
        compared: "sin²φ̃₁ − λ₀² by (39) with (1 + π²/4) (λ_c² − λ₀²)",
        reason: "the sines of both sides of (41), whose phases are below π/2",
    },
    Elsewhere {
        claim: "s22-vy-two-stages",
        compared: "1 with 1 where 𝔴_y is exactly 0 after ten periods, and 𝔴 is then that of the motion on the line",
        reason: IN_WORDS,
    },
    Elsewhere {
        claim: "eq-46",
        compared: "the motion without rest for λ₀ below (46), from our own derivation, with 𝔴 of the motion, where they differ most",
        reason: "what the motion is below the threshold, which other trials try",
    },
    Elsewhere {
        claim: "eq-82",
        compared: "the regular form of τ with the motion, λ = 1 and cos θ₀ = −λ included",
        reason: "the regular form is that of section 2.1, which no claim of section 3 restates",
    },
    Elsewhere {
        claim: "s4-coriolis-no-work",
        compared: "0 with the work of the Coriolis force: the change of kinetic energy in the frame of the table, less the works of the centrifugal force and of friction",
        reason: "the work of friction is the motion's own here; the printed one is tried beside it",
    },
    Elsewhere {
        claim: "eq-132",
        compared: "−9√2/8 with the coefficient of (ln τ)/τ in A/τ^(3/2), over the limit",
        reason: DELAY,
    },
    Elsewhere {
        claim: "eq-135",
        compared: "−3√2/2 with the coefficient of (ln τ)/τ in p/τ², over the limit",
        reason: DELAY,
    },
    Elsewhere {
        claim: "eq-137",
        compared: "−9√2/4 with the coefficient of (ln τ)/τ in s/τ³, over the limit",
        reason: DELAY,
    },
];
