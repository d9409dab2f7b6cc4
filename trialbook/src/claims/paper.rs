//! A paper on trial.

use super::{Claim, Topic};
#[cfg(feature = "book")]
use super::{
    by_hand::ByHand, formulas::Formulas, measured::Measured, values::Value, variants::Survivor,
};

/// A paper: what it claims, and all that belongs to its claims.
#[derive(Debug)]
pub struct Paper {
    /// Its title.
    pub title: &'static str,
    /// Its authors.
    pub authors: &'static str,
    /// How its claims were tried, for a letter to the journal: `against …, and by …`.
    pub tried: &'static str,
    /// Its claims, by topics in its own order.
    pub topics: &'static [Topic],
    /// The recorded verdicts: a line `id: verdict` for each claim.
    pub record: &'static str,
    /// How many wrong variants are rejected, as recorded: a line `id: n of m` for each claim with a formula.
    pub tallies: &'static str,
    /// Its formulas.
    #[cfg(feature = "book")]
    pub formulas: Formulas,
    /// Why claims fail, with cases to check by hand.
    #[cfg(feature = "book")]
    pub cases: &'static [ByHand],
    /// The numbers by which claims can be found.
    #[cfg(feature = "book")]
    pub values: &'static [Value],
    /// Why claims have no proof.
    #[cfg(feature = "book")]
    pub measured: &'static [Measured],
    /// The wrong variants that no trial rejects.
    #[cfg(feature = "book")]
    pub survivors: &'static [Survivor],
}

impl Paper {
    /// All claims with their topics, in the order of the topics.
    pub fn claims(&self) -> impl Iterator<Item = (&'static Topic, &'static Claim)> + use<> {
        let of = |topic: &'static Topic| topic.claims.iter().map(move |claim| (topic, claim));
        self.topics.iter().flat_map(of)
    }

    /// The claim of this id, with its topic.
    pub fn find(&self, id: &str) -> Option<(&'static Topic, &'static Claim)> {
        self.claims().find(|(_, claim)| claim.id == id)
    }

    /// The case by hand of the claim of this id, if it has one.
    #[cfg(feature = "book")]
    pub fn case(&self, id: &str) -> Option<&'static ByHand> {
        self.cases.iter().find(|case| case.claim == id)
    }

    /// The number of this short name.
    #[cfg(feature = "book")]
    pub fn value(&self, id: &str) -> Option<&'static Value> {
        self.values.iter().find(|value| value.id == id)
    }
}
