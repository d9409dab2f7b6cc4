//! Where the two wings meet: one row per claim of the paper, and the trials that try it.
//!
//! A claim is data; a trial is a function that returns [`Evidence`](crate::evidence::Evidence). Whether a claim holds is not
//! said here: the [ledger](crate::ledger) judges.

#[cfg(feature = "book")]
pub mod by_hand;
#[cfg(feature = "book")]
mod failure;
#[cfg(feature = "book")]
pub mod formulas;
#[cfg(feature = "book")]
pub mod measured;
#[cfg(feature = "book")]
pub mod reading;
pub mod solve;
#[cfg(feature = "book")]
pub mod tolerances;
#[cfg(feature = "book")]
pub mod values;
#[cfg(feature = "book")]
pub mod variants;

#[cfg(feature = "book")]
pub mod anisotropic;
#[cfg(feature = "book")]
pub mod constant;
#[cfg(feature = "book")]
pub mod escape;
#[cfg(feature = "book")]
pub mod general;
#[cfg(feature = "book")]
pub mod periodic;
#[cfg(feature = "book")]
pub mod rest;
#[cfg(feature = "book")]
pub mod sinusoidal;
#[cfg(feature = "book")]
pub mod sphere;
#[cfg(feature = "book")]
pub mod turntable;

pub use trialbook::claims::{Claim, Condition, Correction, Topic};
#[cfg(feature = "book")]
pub use trialbook::claims::{attempt, compare, conditioned, enclosed, points, runs, statement};

/// All topics, in the paper's order.
#[cfg(feature = "book")]
pub static TOPICS: [Topic; 9] = [
    general::TOPIC,
    constant::TOPIC,
    sinusoidal::TOPIC,
    periodic::TOPIC,
    anisotropic::TOPIC,
    sphere::TOPIC,
    turntable::TOPIC,
    escape::TOPIC,
    rest::TOPIC,
];

/// All claims with their topics, in the order of the topics.
#[cfg(feature = "book")]
pub fn all() -> impl Iterator<Item = (&'static Topic, &'static Claim)> {
    let of = |topic: &'static Topic| topic.claims.iter().map(move |claim| (topic, claim));
    TOPICS.iter().flat_map(of)
}

/// The claim of this id, with its topic.
#[cfg(feature = "book")]
pub fn find(id: &str) -> Option<(&'static Topic, &'static Claim)> {
    all().find(|(_, claim)| claim.id == id)
}
