//! Where the two sides meet: the claims of the paper, and the trials that try them.
//!
//! A claim is data, an entry in `claims/<topic>.toml`; a trial is a function that returns
//! [`Evidence`](crate::evidence::Evidence). Whether a claim holds is not said here: the [ledger](crate::ledger) judges.

#[cfg(feature = "trials")]
pub mod by_hand;
#[cfg(feature = "trials")]
pub mod corners;
#[cfg(feature = "trials")]
mod failure;
#[cfg(feature = "trials")]
pub mod formulas;
#[cfg(feature = "trials")]
pub mod laid_over;
#[cfg(feature = "trials")]
pub mod tolerances;
#[cfg(feature = "trials")]
pub mod values;
#[cfg(feature = "trials")]
pub mod variants;

#[cfg(feature = "trials")]
pub mod anisotropic;
#[cfg(feature = "trials")]
pub mod constant;
#[cfg(feature = "trials")]
pub mod escape;
#[cfg(feature = "trials")]
pub mod general;
#[cfg(feature = "trials")]
pub mod periodic;
#[cfg(feature = "trials")]
pub mod rest;
#[cfg(feature = "trials")]
pub mod sinusoidal;
#[cfg(feature = "trials")]
pub mod sphere;
#[cfg(feature = "trials")]
pub mod turntable;

pub use trialbook::claims::{Claim, Condition, Correction, Excuse, Paper, Sort, Topic, as_of};
#[cfg(feature = "trials")]
pub use trialbook::claims::{attempt, compare, enclosed, excepted, points, read, runs, statement};

/// The conditions and reasons that claims of several topics have.
#[cfg(feature = "trials")]
const SHARED: read::File = read::claims!("../../claims/shared.toml");

/// All topics, in the paper's order.
#[cfg(feature = "trials")]
static TOPICS: [&Topic; 9] = [
    &general::TOPIC,
    &constant::TOPIC,
    &sinusoidal::TOPIC,
    &periodic::TOPIC,
    &anisotropic::TOPIC,
    &sphere::TOPIC,
    &turntable::TOPIC,
    &escape::TOPIC,
    &rest::TOPIC,
];

/// The paper on trial.
#[cfg(feature = "trials")]
pub static PAPER: Paper = Paper {
    title: "Slipping and rolling on a rough accelerating surface",
    authors: "M. Khorrami, A. Aghamohammadi and C. Aghamohammadi",
    reference: "arXiv:2307.15836",
    letter: include_str!("../../book/letter.md"),
    topics: TOPICS.as_slice(),
    record: include_str!("../../snapshots/verdicts.snap"),
    tallies: include_str!("../../snapshots/variants.snap"),
    deep: include_str!("../../snapshots/deep.tsv"),
    certified: include_str!("../../snapshots/certificates.csv"),
    formulas: formulas::FORMULAS,
};
