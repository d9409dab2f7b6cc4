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
            "s22-rest-of-period",
            "s23-nonzero-again",
        ],
    },
    Measured {
        reason: "That there are rests above the mean of $\\lvert h\\rvert$, and none where friction is small enough, is argued on its page, with integrals over sets of phases that the program does not know; that rests may come and go more than once is seen in simulated examples.",
        claims: &["s23-threshold-exists"],
    },
    Measured {
        reason: "It is about how fast $v_y$ dies, to leading order as $v_y\\to0$, beside each zero of $v_x$; that it dies is proved, but no bound of what the leading order leaves out.",
        claims: &["s22-vy-two-stages"],
    },
    Measured {
        reason: "It says in which order things happen, or that nothing else happens, on a whole range of $\\lambda_0$ and $q$: which motion belongs to it is counted at many points.",
        claims: &[
            "s24-region-1",
            "s24-region-3",
            "s24-region-4",
            "s24-region-5",
        ],
    },
    Measured {
        reason: "A part of it is proved: the order of the curves between which the regions lie, and that between E and C nothing moves backward. Which motion belongs to which region is counted at many points.",
        claims: &["eq-55", "s24-region-2", "fig-5"],
    },
    Measured {
        reason: "The step to it from (145) is proved; that the surfaces on which the motion comes to rest are others is measured.",
        claims: &["eq-146", "eq-147"],
    },
    Measured {
        reason: "It carries over to the sphere what is measured of the particle; the step itself, that the slip velocity moves as a particle's velocity does, is proved.",
        claims: &[
            "s32-rolling-trichotomy",
            "s33-any-drive",
            "s33-pulse",
            "s34-anisotropic",
        ],
    },
    Measured {
        reason: "It needs the formulas of an article of which only the abstract and the first lines could be read.",
        claims: &["s21-portrait-consistent"],
    },
    Measured {
        reason: "It speaks about every motion on the turntable from a region of starts. Power series show motions of that kind; that there are no others they cannot show.",
        claims: &[
            "eq-127",
            "s4-small-alpha",
            "s4-escape-if-A-above-1",
            "s4-alpha-unbounded",
            "s4-near-rest",
            "s4-dichotomy",
        ],
    },
];
