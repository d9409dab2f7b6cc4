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
        reason: "That there are rests above the mean of $\\lvert h\\rvert$, and none where friction is small enough, is argued on its page, with integrals over sets of phases that the program does not know; that rests may come and go more than once is seen in simulated examples.",
        claims: &["s23-threshold-exists"],
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
