//! What the wrong variants of the formulas have to know: which stand, and where the formulas are stated.

pub use trialbook::trials::variants::Variant;

/// They say that something vanishes or keeps its value: a constant factor does not make them wrong.
pub(super) const UP_TO_A_FACTOR: [&str; 10] = [
    "constant",
    "eq10_invariant",
    "eq17_invariant",
    "eq32_left",
    "eq34_left",
    "eq35_left",
    "eq104_constant",
    "eq106_constant",
    "eq146_right",
    "half_angle",
];

/// They state a sign: a positive factor does not make them wrong.
pub(super) const UP_TO_A_POSITIVE_FACTOR: [&str; 2] = ["eq110_case", "eq116_case"];

/// A random value of an argument, by its letter: vectors of the sphere lie in the plane, but for the angular velocity,
/// and **R** is upright; h in (43) is that of (42).
pub(super) fn argument(letter: &str, random: &mut fastrand::Rng) -> f64 {
    match letter {
        "ω_z" | "R_z" => random.f64(),
        "R_x" | "R_y" => 0.0,
        "ln r" => -random.f64(),
        letter if letter.ends_with("_z") => 0.0,
        "h" => f64::from(random.u8(0..2)),
        _ => random.f64(),
    }
}
