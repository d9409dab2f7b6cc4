//! Every tolerance, with its reason, in one place; sorted by name.

use crate::evidence::Tolerance;

/// A on the boundary between rest and escape.
pub const BOUNDARY: Tolerance = Tolerance {
    value: 1e-7,
    reason: "the bisection is stopped at 1e-8",
};

/// The slope of the surfaces of constant σ close to where they end.
pub const CLOSING_SURFACES: Tolerance = Tolerance {
    value: 1e-2,
    reason: "the saddle's surfaces are exact only at σ → 1; 1 − σ is up to 1e-2 here, where they are 6e-3 off",
};

/// An exponent or coefficient of a touch, taken at a small distance from it.
pub const CONTACT: Tolerance = Tolerance {
    value: 1e-3,
    reason: "taken at distances of 1e-2 and less, on both sides, where the next term is below 1e-4",
};

/// A rate against differences of the motion.
pub const DIFFERENCES: Tolerance = Tolerance {
    value: 1e-9,
    reason: "differences of fourth order over a thousandth of the time scale, and the rounding that they enlarge",
};

/// The coefficient of (ln τ)/τ of an escape.
pub const ESCAPE_CORRECTION: Tolerance = Tolerance {
    value: 1e-5,
    reason: "it is a part 1e-4 to 1e-7 of what is fitted, and its neighbour 1/τ is hardly different from it; the fits scatter by 2e-6",
};

/// What a quantity tends to as a particle escapes.
pub const ESCAPE_LIMIT: Tolerance = Tolerance {
    value: 1e-11,
    reason: "fits with the known form of the corrections over τ from 1e5 to 1e8 leave out terms of order (ln τ/τ)³, and agree to 1e-12",
};

/// An asymptotic form against what it is the limit of.
pub const FAR: Tolerance = Tolerance {
    value: 2e-6,
    reason: "the first term left out is about 1700 q⁻⁴, or 1e-6 at the smallest q, 200",
};

/// A difference in units of a hundred times the first order that is left out.
pub const FIRST_OMITTED: Tolerance = Tolerance {
    value: 1e-2,
    reason: "the unit is a hundred times that order, and its coefficient is of order one",
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

/// A place on the boundary close to A = 1, α = 0.
pub const NEAR_CORNER: Tolerance = Tolerance {
    value: 2e-4,
    reason: "the boundary is within α of 1, and α is about 1e-4",
};

/// A coefficient of an expansion about rest.
pub const NEAR_REST: Tolerance = Tolerance {
    value: 1e-6,
    reason: "at the levels chosen the terms left out are below 1e-7, and rounding as well",
};

/// An exponent of an expansion about rest.
pub const NEAR_REST_EXPONENT: Tolerance = Tolerance {
    value: 1e-6,
    reason: "at the levels chosen the terms left out are below 1e-7 of the one measured",
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

/// What is left of an angle that has relaxed, or of its square.
pub const RELAXED: Tolerance = Tolerance {
    value: 1e-5,
    reason: "α and ψ are below 1e-5 by then, or their squares are",
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

/// The third-order term of the boundary, in units of 1000 α³.
pub const THIRD_ORDER: Tolerance = Tolerance {
    value: 6e-3,
    reason: "the coefficient of α³ depends on ψ and lies between −5.2 and 1.7 as α → 0",
};

/// A number that is printed to three decimals.
pub const THREE_DECIMALS: Tolerance = Tolerance {
    value: 5e-4,
    reason: "half a unit of the third decimal",
};

/// A friction at which the list of intervals changes, by bisection.
pub const THRESHOLD: Tolerance = Tolerance {
    value: 1e-11,
    reason: "halved to the last bit; there the motion itself is known to about 1e-15 over the friction",
};

/// A velocity that vanishes as a power of the time.
pub const VANISHES: Tolerance = Tolerance {
    value: 1e-6,
    reason: "under twice the friction, the slowest case, v⊥ falls as the inverse of the time, which is 1e8 at the end",
};
