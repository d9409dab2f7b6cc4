//! Where the two sides meet: the claims of the paper, and the trials that try them.
//!
//! A claim is data, an entry in `claims/<topic>.toml`; a trial is a function that returns
//! [`Evidence`](crate::evidence::Evidence). Whether a claim holds is not said here: the [ledger](crate::ledger) judges.

pub mod edges;
pub mod formulas;
pub(crate) mod laid_over;
mod prelude;
mod shared;
pub mod tolerances;
pub mod variants;

pub mod anisotropic;
pub mod constant;
pub mod escape;
pub(crate) mod general;
pub mod periodic;
pub mod rest;
pub(crate) mod sinusoidal;
pub(crate) mod sphere;
pub(crate) mod turntable;

use trialbook::data::{folder, text};
use trialbook::theorems::Theorems;
pub use trialbook::trials::values;
use trialbook::trials::{Paper, Topic};

/// In the paper's order.
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

/// What a kernel has accepted.
static THEOREMS: Theorems = Theorems::new(folder!("rocq"), text!("rocq/record.txt"));

/// The paper on trial.
pub static PAPER: Paper = Paper {
    title: "Slipping and rolling on a rough accelerating surface",
    authors: "M. Khorrami, A. Aghamohammadi and C. Aghamohammadi",
    reference: "arXiv:2307.15836",
    letter: text!("book/letter.md"),
    topics: TOPICS.as_slice(),
    record: text!("snapshots/verdicts.snap"),
    sheets: folder!("snapshots"),
    tries_variants: true,
    deep: text!("snapshots/deep.tsv"),
    theorems: &THEOREMS,
    formulas: formulas::FORMULAS,
};
