//! The claims without a proof, each with the reason why there is none. A test holds the list against the ledger.

pub use trialbook::claims::measured::Measured;

/// All claims without a proof, by the reason.
pub const MEASURED: &[Measured] = &[
    Measured {
        reason: "It gives a name to something, and no equation that is proved decides whether it is the right one; it is tried by its dimensions and by the use made of it.",
        claims: &[
            "eq-42", "eq-43", "eq-61", "eq-67", "eq-76", "eq-80", "eq-84", "eq-85", "eq-105",
        ],
    },
    Measured {
        reason: "It is a picture: what can be read off it has the accuracy of a drawing.",
        claims: &["fig-1", "fig-2", "fig-3", "fig-4", "fig-6"],
    },
    Measured {
        reason: "It says in words in which sense something goes, or which of two things is meant; it is tried on motions.",
        claims: &[
            "s21-along-acceleration",
            "s21-incline",
            "s22-rest-of-period",
            "s23-nonzero-again",
            "s23-pulses-normalised",
        ],
    },
    Measured {
        reason: "It is proved in a line or two of text, on its page, and not by the program.",
        claims: &[
            "s2-no-permanent-rest",
            "s21-friction-cannot-hold",
            "s21-incline-only-constant",
            "s22-vx-stays",
            "s22-friction-across",
            "s22-slip-longer-than-half",
            "s23-rest-above-one",
            "s23-threshold-exists",
            "s23-mostly-at-rest",
            "s24-vy-vanishes",
        ],
    },
    Measured {
        reason: "It speaks about every acceleration of the plane as a function of time, or of every drive: there is no formula for the motion.",
        claims: &["s2-speeds-up-if-strong", "s23-pulse-phases"],
    },
    Measured {
        reason: "It speaks about the motion at late times from every start, which no formula gives: the drive acts on both components of the velocity at once.",
        claims: &[
            "s22-vy-vanishes",
            "s22-weak-drive-stops",
            "s22-vy-two-stages",
            "s22-attractor-ignores-vy",
        ],
    },
    Measured {
        reason: "It says in which order things happen, or that nothing else happens: an inequality that holds on a whole range of $\\lambda_0$, $q$ or $\\theta$, not an identity.",
        claims: &[
            "s21-small-friction-aligns",
            "s22-four-points",
            "s22-rest-ends",
            "s22-rest-interval",
            "s22-no-rest-below",
            "s22-trichotomy",
        ],
    },
    Measured {
        reason: "The step to it from (145) and (146) is proved, and that the boundary is another surface; but nothing is put in its place, which could be proved.",
        claims: &["eq-147"],
    },
    Measured {
        reason: "It carries over to the sphere what is measured of the particle; the step itself, that the slip velocity moves as a particle's velocity does, is proved.",
        claims: &["s33-any-drive"],
    },
    Measured {
        reason: "It needs the formulas of an article of which only the abstract and the first lines could be read.",
        claims: &["s21-portrait-consistent"],
    },
];
