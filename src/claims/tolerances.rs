//! Every tolerance, with its reason, in one place.

use crate::evidence::Tolerance;

/// Nothing may differ.
pub const NONE: Tolerance = Tolerance {
    value: 0.0,
    reason: "exact: a count or a normal form, nothing may differ",
};
