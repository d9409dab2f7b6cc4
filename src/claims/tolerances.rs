//! Every tolerance, with its reason, in one place; sorted by name.

use crate::evidence::Tolerance;

/// A factor per period against its limit near the periodic motion.
pub const APPROACH: Tolerance = Tolerance {
    value: 5e-6,
    reason: "taken where the distance to the periodic motion is 1e-6, of which the next term of the factor is a small multiple",
};

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
    reason: "what is left is of the order of η, which is at most 1e-3, or of δ², which is at most 1e-4",
};

/// A rate against differences of the motion.
pub const DIFFERENCES: Tolerance = Tolerance {
    value: 5e-10,
    reason: "differences of fourth order over a thousandth of the time scale, and the rounding that they enlarge",
};

/// A gap against its leading term at the edge of its range.
pub const EDGE: Tolerance = Tolerance {
    value: 1e-4,
    reason: "the next term of the gap, √(λ₀/π) of it, is below 2e-5 for λ₀ up to 1e-9",
};

/// The coefficient of (ln τ)/τ of an escape.
pub const ESCAPE_CORRECTION: Tolerance = Tolerance {
    value: 1e-5,
    reason: "it is a part 1e-4 to 1e-7 of what is fitted, and its neighbour 1/τ is hardly different from it; the fits scatter by 2e-6",
};

/// What a quantity tends to as a particle escapes.
pub const ESCAPE_LIMIT: Tolerance = Tolerance {
    value: 3e-12,
    reason: "fits with the known form of the corrections over τ from 1e5 to 1e8 leave out terms of order (ln τ/τ)³, and agree to 1e-12",
};

/// Equal falls of a logarithm.
pub const EXPONENTIAL: Tolerance = Tolerance {
    value: 0.1,
    reason: "falls that are equal up to a tenth would still count as equal",
};

/// Curve A far out against what it is the limit of.
pub const FAR_A: Tolerance = Tolerance {
    value: 1e-8,
    reason: "the first term left out on A is about 9 q⁻⁴: 6e-9 at the smallest q, 200",
};

/// Curve E far out against what it is the limit of.
pub const FAR_E: Tolerance = Tolerance {
    value: 2e-6,
    reason: "the first term left out on E is about 1700 q⁻⁴: 1e-6 at the smallest q, 200",
};

/// A difference in units of a hundred times the first order that is left out.
pub const FIRST_OMITTED: Tolerance = Tolerance {
    value: 1e-2,
    reason: "the unit is a hundred times that order, and its coefficient is of order one",
};

/// A slope to leading order in a small ratio.
pub const FIRST_STAGE: Tolerance = Tolerance {
    value: 1e-8,
    reason: "the correction is half the square of the ratio of the velocities, which is at most 1e-4",
};

/// What the inertial frame's foreign integrator and ours may differ by.
pub const FOREIGN: Tolerance = Tolerance {
    value: 2e-12,
    reason: "the second integrator, of order 8, is asked for 1e-13 a step",
};

/// A motion that has forgotten its start.
pub const FORGOTTEN: Tolerance = Tolerance {
    value: 1e-9,
    reason: "what is left of the start falls by the contraction factor in every period",
};

/// A motion on the turntable found in one frame against the same found in another.
pub const FRAMES: Tolerance = Tolerance {
    value: 1e-14,
    reason: "the integrators in the frame of the table and in the laboratory agree to a few units of rounding of the largest term",
};

/// A velocity that dies faster than any exponential.
pub const GONE: Tolerance = Tolerance {
    value: 0.0,
    reason: "it falls as the exponential of an exponential and below every number, or is zero after a finite time",
};

/// An angle that is to follow another one, in units of what that one has left.
pub const LAG: Tolerance = Tolerance {
    value: 1e-4,
    reason: "the integration is good to 1e-12; an angle that does not follow is off by a part of order one",
};

/// A time to leading order in a small velocity.
pub const LAST_STAGE: Tolerance = Tolerance {
    value: 2e-5,
    reason: "what the drive changes by within the last stage, over what friction exceeds it by: at most 2e-5 at the points tried",
};

/// An angle that tends to zero as a power of the time, or faster.
pub const LATE_ANGLE: Tolerance = Tolerance {
    value: 2e-8,
    reason: "the slowest case, without friction, has 1e-8 left at a hundred million times v₀/A",
};

/// The width of a narrow range of friction, over its expected width.
pub const LIMIT_OF_WIDTH: Tolerance = Tolerance {
    value: 5e-10,
    reason: "the jumps of h are known to 4e-16, and the least width, 1e-3, divides that twice",
};

/// A factor of very large logarithms.
pub const LOGARITHM: Tolerance = Tolerance {
    value: 1e-8,
    reason: "terms that stay bounded, beside a logarithm of 1e9",
};

/// A formula against the integrated motion.
pub const MOTION: Tolerance = Tolerance {
    value: 2e-13,
    reason: "the motion is good to about 1e-13 where the problem is well conditioned; the scale is what the formula can resolve",
};

/// A place on the boundary close to A = 1, α = 0.
pub const NEAR_CORNER: Tolerance = Tolerance {
    value: 2e-4,
    reason: "the boundary is within α of 1, and α is about 1e-4",
};

/// A coefficient of an expansion about rest.
pub const NEAR_REST: Tolerance = Tolerance {
    value: 5e-8,
    reason: "at the levels chosen the terms left out are below 1e-8, and rounding as well",
};

/// An exponent of an expansion about rest.
pub const NEAR_REST_EXPONENT: Tolerance = Tolerance {
    value: 5e-7,
    reason: "at the levels chosen the terms left out are below 1e-7 of the one measured",
};

/// Nothing may differ.
pub const NONE: Tolerance = Tolerance {
    value: 0.0,
    reason: "a count or a normal form: nothing may differ",
};

/// The friction at which rests appear, found by bisection on the motion.
pub const ONSET: Tolerance = Tolerance {
    value: 2e-14,
    reason: "the bisection ends at neighbouring numbers; rests shorter than 1e-14 are not listed",
};

/// A factor of logarithms across a passage through zero.
pub const PASSAGE: Tolerance = Tolerance {
    value: 1e-5,
    reason: "what stays bounded stands beside a logarithm of at least 1e5; what is linear in the distance, beside 1e-5",
};

/// A formula against a quadrature.
pub const QUADRATURE: Tolerance = Tolerance {
    value: 5e-13,
    reason: "the quadrature is asked for 1e-13",
};

/// What is left of an angle that has relaxed, or of its square.
pub const RELAXED: Tolerance = Tolerance {
    value: 1e-5,
    reason: "α and ψ are below 1e-5 by then, or their squares are",
};

/// A root of a formula against the integrated motion.
pub const ROOT: Tolerance = Tolerance {
    value: 3e-13,
    reason: "the root is found to 1e-15; the formula's own rounding is divided by its slope",
};

/// A correction of second order, from its effect.
pub const SECOND_ORDER: Tolerance = Tolerance {
    value: 2e-2,
    reason: "the next order is the time of a period over the velocity, a hundredth; rounding of the slope is as large",
};

/// What a short push may leave behind and still count as motion: nothing near the strength of the push.
pub const SHORT_PUSH: Tolerance = Tolerance {
    value: 1e-3,
    reason: "a motion that a push started would have a speed of the push's strength times a time of order one",
};

/// A logarithmic slope against its limit.
pub const SLOPE: Tolerance = Tolerance {
    value: 2e-11,
    reason: "taken where the speed is below 1e-12 of the initial one; the angle's correction falls with it",
};

/// The angle at which a rate, found by differences of the motion, is zero.
pub const STANDS_STILL: Tolerance = Tolerance {
    value: 3e-9,
    reason: "differences are good to 5e-10 and are divided by the slope of the rate, which is above 0.5",
};

/// A velocity that has settled.
pub const TERMINAL: Tolerance = Tolerance {
    value: 2e-15,
    reason: "the rest falls as exp(−A t/v_x(∞)) and is below 1e-25; what remains is rounding",
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
    value: 4e-8,
    reason: "under twice the friction, the slowest case, v⊥ falls as the inverse of the time, which is 1e8 at the end",
};
