//! Every tolerance, with its reason, in one place; sorted by name.

use trialbook::trials::tolerances::tolerances;
pub use trialbook::trials::tolerances::{MOTION, NONE, QUADRATURE};

tolerances! {

/// Friction across the drive, for velocities that are small beside the one along it.
ACROSS = 5e-7,
    "the next term is the square of the ratio of the velocities, and differences are as good: 8e-8 at the worst";

/// A factor per period against its limit near the periodic motion.
APPROACH = 5e-6,
    "taken where the distance to the periodic motion is 1e-6, of which the next term of the factor is a small multiple";

/// A on the boundary between rest and escape.
BOUNDARY = 1e-7,
    "the bisection is stopped at 1e-8";

/// The slope of the surfaces of constant σ close to where they end.
CLOSING_SURFACES = 1e-2,
    "the saddle's surfaces are exact only at σ → 1; 1 − σ is up to 1e-2 here, where they are 6e-3 off";

/// An exponent or coefficient of a touch, taken at a small distance from it.
CONTACT = 1e-3,
    "what is left is of the order of η, which is at most 1e-3, or of δ², which is at most 1e-4";

/// A rate against differences of the motion.
DIFFERENCES = 5e-10,
    "differences of fourth order over a thousandth of the time scale, and the rounding that they enlarge";

/// A gap against its leading term at the edge of its range.
EDGE = 1e-4,
    "the next term of the gap, √(λ₀/π) of it, is below 2e-5 for λ₀ up to 1e-9";

/// When and where a motion on the turntable comes to rest.
ENDS = 2e-13,
    "the bounds of a fate are closed to 2e-13 of the place; the programs agree to a part of it";

/// The coefficient of (ln τ)/τ of an escape.
ESCAPE_CORRECTION = 1e-5,
    "it is a part 1e-5 to 1e-7 of what is fitted, and its neighbour 1/τ is hardly different from it; the fits scatter by 4e-6";

/// What a quantity tends to as a particle escapes.
ESCAPE_LIMIT = 2e-12,
    "fits with the known form of the corrections over τ from 1e6 to 1e8 leave out terms of order (ln τ/τ)³, and agree to 1e-12";

/// Equal falls of a logarithm.
EXPONENTIAL = 0.1,
    "falls that are equal up to a tenth would still count as equal";

/// Curve A far out against what it is the limit of.
FAR_A = 2e-8,
    "the first term left out on A is about 9 q⁻⁴: 6e-9 at the smallest q, 200; at the largest, 20,000, λ₀ is 8e-9, and the simulation rounds to 1e-16";

/// Curve E far out against what it is the limit of.
FAR_E = 2e-6,
    "the first term left out on E is about 1700 q⁻⁴: 1e-6 at the smallest q, 200";

/// A difference in units of a hundred times the first order that is left out.
FIRST_OMITTED = 1e-2,
    "the unit is a hundred times that order, and its coefficient is of order one";

/// A slope to leading order in a small ratio.
FIRST_STAGE = 1e-8,
    "the correction is half the square of the ratio of the velocities, which is at most 1e-4";

/// What the inertial frame's foreign integrator and ours may differ by.
FOREIGN = 2e-12,
    "the second integrator, of order 8, is asked for 1e-13 a step";

/// A motion that has forgotten its start.
FORGOTTEN = 1e-9,
    "what is left of the start falls by the contraction factor in every period";

/// A motion on the turntable found in one frame against the same found in another.
FRAMES = 1e-14,
    "the integrators in the frame of the table and in the laboratory agree to a few units of rounding of the largest term";

/// An acceleration, by what is gained over a hundredth of a unit of phase.
GAINED = 2e-13,
    "the velocities are rounded to a few parts in 10^16, and their difference is a hundredth";

/// A velocity that dies faster than any exponential.
GONE = 0.0,
    "it is zero, or smaller than any number of the machine";

/// A time to leading order in a small velocity.
LAST_STAGE = 2e-5,
    "what the drive changes by within the last stage, over what friction exceeds it by: at most 2e-5 at the points tried";

/// An angle that tends to zero as a power of the time, or faster.
LATE_ANGLE = 2e-8,
    "the slowest case, without friction, has 1e-8 left at a hundred million times v₀/A";

/// The width of a narrow range of friction, over its expected width.
LIMIT_OF_WIDTH = 2e-10,
    "the jumps of h are known to 4e-16 at the worst, and the least width, 1e-3, divides that twice; as measured it is 3e-11";

/// A ratio of eigenvalues of a linearised motion.
LINEARISED = 1e-12,
    "rounding, in differences of steps of 1e-2 and in the iteration for the eigenvalues";

/// A factor of very large logarithms.
LOGARITHM = 1e-8,
    "terms that stay bounded, beside a logarithm of 1e9";

/// A Floquet multiplier, between 0.1 and 1.
MULTIPLIER = 1e-7,
    "a motion over a period is known to 1e-14, and divided by twice the step of 1e-5; the square of the step is less";

/// A place on the boundary close to A = 1, α = 0.
NEAR_CORNER = 2e-4,
    "the boundary is within α of 1, and α is about 1e-4";

/// A coefficient of an expansion about rest.
NEAR_REST = 5e-8,
    "at the levels chosen the terms left out are below 1e-8, and rounding as well";

/// An exponent of an expansion about rest.
NEAR_REST_EXPONENT = 5e-7,
    "at the levels chosen the terms left out are below 1e-7 of the one measured";

/// Where one of many motions on the turntable ends that are followed at once.
OF_MANY = 5e-12,
    "the steps of many at once are longer: they cost up to 7e-13 beside 1, and more where friction hardly outweighs the pull";

/// The friction at which rests appear, found by bisection on the motion.
ONSET = 2e-14,
    "the bisection ends at neighbouring numbers; rests shorter than 1e-14 are not listed";

/// A factor of logarithms across a passage through zero.
PASSAGE = 1e-5,
    "what stays bounded stands beside a logarithm of at least 1e5; what is linear in the distance, beside 1e-5";

/// What is left of an angle that has relaxed, or of its square.
RELAXED = 1e-5,
    "α and ψ are below 1e-5 by then, or their squares are";

/// A root of a formula against the integrated motion.
ROOT = 3e-13,
    "the root is found to 1e-15; the formula's own rounding is divided by its slope";

/// A correction of second order, from its effect.
SECOND_ORDER = 2e-2,
    "the next order is the time of a period over the velocity, a hundredth; rounding of the slope is as large";

/// The share of rest as friction rises to the largest drive, from two frictions.
SHARE = 5e-8,
    "the term left out is of the order of what friction is below 1: 1e-8";

/// What a short push may leave behind and still count as motion: nothing near the strength of the push.
SHORT_PUSH = 1e-3,
    "a motion that a push started would have a speed of the push's strength times a time of order one";

/// A logarithmic slope against its limit.
SLOPE = 2e-13,
    "extrapolated to θ = 0 from where the speed is below 1e-12 of the initial one; the terms left out are of order θ⁴";

/// The angle at which a rate, found by differences of the motion, is zero.
STANDS_STILL = 3e-9,
    "differences are good to 5e-10 and are divided by the slope of the rate, which is above 0.5";

/// The coefficient of α² on a surface of starts that come to rest at one distance, from halvings of α.
SURFACE = 1e-5,
    "the term left out is of the order α³, and α is about a hundredth";

/// A velocity that has settled.
TERMINAL = 2e-15,
    "the rest falls as exp(−A t/v_x(∞)) and is below 1e-25; what remains is rounding";

/// The third-order term of the boundary, in units of 1000 α³.
THIRD_ORDER = 6e-3,
    "the coefficient of α³ depends on ψ and lies between −5.9 and 1.7 as α → 0";

/// A number that is printed to three decimals.
THREE_DECIMALS = 5e-4,
    "half a unit of the third decimal";

/// A friction at which the list of intervals changes, by bisection.
THRESHOLD = 1e-11,
    "halved to the last bit; there the motion itself is known to about 1e-15 over the friction";

/// A velocity that vanishes as a power of the time.
VANISHES = 4e-8,
    "what is left of v⊥ under twice the friction, the slowest case, after a time of 1e8";

}
