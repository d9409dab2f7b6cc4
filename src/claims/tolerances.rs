//! Every tolerance, with its reason, in one place; sorted by name.

use crate::evidence::Tolerance;

/// What the inertial frame's foreign integrator and ours may differ by.
pub const FOREIGN: Tolerance = Tolerance {
    value: 1e-10,
    reason: "the second integrator, of order 8, is asked for 1e-13 a step",
};

/// A formula against the integrated motion.
pub const MOTION: Tolerance = Tolerance {
    value: 1e-12,
    reason: "the motion is good to 1e-12 where the problem is well conditioned; the scale is what the formula can resolve",
};

/// Nothing may differ.
pub const NONE: Tolerance = Tolerance {
    value: 0.0,
    reason: "a count or a normal form: nothing may differ",
};

/// A formula against a quadrature.
pub const QUADRATURE: Tolerance = Tolerance {
    value: 1e-12,
    reason: "the quadrature is asked for 1e-13",
};

/// A root of a formula against the integrated motion.
pub const ROOT: Tolerance = Tolerance {
    value: 1e-11,
    reason: "the root is found to 1e-15; the formula's own rounding is divided by its slope",
};
