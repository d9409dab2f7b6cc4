//! The trials that mistakes do not move as they move others, and why.

/// A trial by its claim and its name, and a reason.
pub type Excuse = (&'static str, &'static str, &'static str);

/// Trials that agree and notice no mistake in what they read, or read nothing. A test holds the list against the trials.
pub const IDLE: &[Excuse] = &[(
    "eq-82",
    "angle::regular_time",
    "the regular form is that of section 2.1, where (13) is tried; it branches at λ = 1, so that no mistake can be seeded in it",
)];

/// Trials that find something else, or look elsewhere, when a mistake is seeded in a formula. A test holds the list against
/// the trials.
pub const LEANING: &[Excuse] = &[];
