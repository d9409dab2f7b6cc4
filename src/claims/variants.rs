//! What the wrong variants of the formulas have to know: which stand, and where the formulas are stated.

pub use trialbook::claims::variants::{Spared, Survivor, Variant};

/// All wrong variants that no trial rejects. A test holds the list against the trials.
pub const SURVIVORS: &[Survivor] = &[
    Survivor {
        claim: "s21-along-acceleration",
        text: "−1",
        reason: TAKEN_BACK,
    },
    Survivor {
        claim: "eq-75",
        text: "ζ₃ 0 + (0 (u_z − ρ̇_z) − (−1) (u_y − ρ̇_y)); ζ₃ 0 + ((−1) (u_x − ρ̇_x) − 0 (u_z − ρ̇_z)); ζ₃ 1 + (0 (u_y − ρ̇_y) − 0 (u_x − ρ̇_x))",
        reason: TAKEN_BACK,
    },
    Survivor {
        claim: "eq-143",
        text: "2 α (c − ln(2 α))",
        reason: "a factor of α in the logarithm is another constant c, which each motion sets",
    },
];

const TAKEN_BACK: &str = "it is the corrected formula: the mistake takes the misprint back";
const BY_ITS_SINE: &str =
    "the proof knows a phase by its sine and cosine; in which period it lies, the motions tell";
const BY_ITS_SQUARE: &str = "λ_c enters by its square; its sign is told by enclosure";
const BY_ITS_POWER: &str =
    "of every escape the exponential of α is known by an even power; its sign, the motions tell";
const LARGE: &str = "the law is stated for large α, where sinh and cosh are equal to leading order";

const fn spared(claim: &'static str, formula: &'static str, reason: &'static str) -> Spared {
    Spared {
        claim,
        formula,
        reason,
    }
}

/// All of them. A test holds the list against the proofs.
pub const SPARED: &[Spared] = &[
    spared(
        "eq-21",
        "eq21_acceleration",
        "(26) is about the motion along the drive: what pulls across it does not enter",
    ),
    spared("eq-28", "eq28_phi2", BY_ITS_SINE),
    spared("eq-29", "eq29_phi3", BY_ITS_SINE),
    spared("eq-30", "eq30_phi4", BY_ITS_SINE),
    spared(
        "eq-33",
        "eq33_ends",
        "the proof is about the slips; how long the rest between them lasts, the motions tell",
    ),
    spared("eq-36", "eq36_sides", BY_ITS_SQUARE),
    spared(
        "eq-39",
        "eq39_phi_t1",
        "the proof knows the phase by its cosine alone; which phase it is, the motions tell",
    ),
    spared("eq-40", "eq40_sides", BY_ITS_SQUARE),
    spared("eq-57", "eq57_x", BY_ITS_SQUARE),
    spared(
        "eq-79",
        "eq79_velocity",
        "another constant is a constant too",
    ),
    spared("eq-125", "eq125_psi2", BY_ITS_SINE),
    spared("eq-128", "alpha_rate", LARGE),
    spared("eq-129", "eq129_a", LARGE),
    spared("eq-130", "alpha_by_a", BY_ITS_POWER),
    spared("eq-130", "thrice_alpha_exp", BY_ITS_POWER),
    spared("eq-133", "alpha", BY_ITS_POWER),
    spared("eq-133", "twice_alpha_exp", BY_ITS_POWER),
    spared(
        "eq-136",
        "winding",
        "it enters by its square; which way the particle circles, the motions tell",
    ),
];

/// The formulas that say that something vanishes or keeps its value: a constant factor does not make them wrong.
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

/// The formulas that state a sign: a positive factor does not make them wrong.
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
