//! Every tolerance, with its reason, in one place; sorted by name.

use crate::evidence::Tolerance;

/// A rate against differences of the motion.
pub const DIFFERENCES: Tolerance = Tolerance {
    value: 1e-9,
    reason: "differences of fourth order over a thousandth of the time scale, and the rounding that they enlarge",
};

/// What the inertial frame's foreign integrator and ours may differ by.
pub const FOREIGN: Tolerance = Tolerance {
    value: 1e-10,
    reason: "the second integrator, of order 8, is asked for 1e-13 a step",
};

/// An angle that tends to zero as a power of the time, or faster.
pub const LATE_ANGLE: Tolerance = Tolerance {
    value: 1e-7,
    reason: "the slowest case, without friction, has 2e-8 left at a hundred million times v₀/A",
};

/// The width of a narrow range of friction, over its expected width.
pub const LIMIT_OF_WIDTH: Tolerance = Tolerance {
    value: 1e-6,
    reason: "the jumps of h are known to 4e-16, and the least width, 1e-3, divides that twice",
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

/// What a short push may leave behind and still count as motion: nothing near the strength of the push.
pub const SHORT_PUSH: Tolerance = Tolerance {
    value: 1e-3,
    reason: "a motion that a push started would have a speed of the push's strength times a time of order one",
};

/// A logarithmic slope against its limit.
pub const SLOPE: Tolerance = Tolerance {
    value: 1e-6,
    reason: "taken where the speed is below 1e-12 of the initial one; the angle's correction falls with it",
};

/// A velocity that has settled.
pub const TERMINAL: Tolerance = Tolerance {
    value: 1e-12,
    reason: "the rest falls as exp(−A t/v_x(∞)) and is below 1e-25; the motion is good to 1e-12",
};

<<<<<<< HEAD
/// A velocity that vanishes as a power of the time.
pub const VANISHES: Tolerance = Tolerance {
    value: 1e-6,
    reason: "under twice the friction, the slowest case, v⊥ falls as the inverse of the time, which is 1e8 at the end",
=======
/// A friction at which the list of intervals changes, by bisection.
pub const THRESHOLD: Tolerance = Tolerance {
    value: 1e-11,
    reason: "halved to the last bit; there the motion itself is known to about 1e-15 over the friction",
>>>>>>> periodic
};
