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
        reason: "The power series of the surfaces is found exactly; that what is left out of it is small is measured.",
        claims: &["eq-146"],
    },
    Measured {
        reason: "It is a picture: what can be read off it has the accuracy of a drawing.",
        claims: &["fig-1", "fig-2", "fig-3", "fig-4", "fig-6"],
    },
    Measured {
        reason: "It needs the formulas of an article of which only the abstract and the first lines could be read.",
        claims: &["s21-portrait-consistent"],
    },
];
