//! The turntable, exactly: proofs of (86) to (125).
//!
//! What is entered here is that friction alone acts in the laboratory; it proves (86), (86) proves (89), and (89)
//! all that follows. The printed formulas come from [`crate::paper::turntable`], as trees. All holds for a
//! particle that slides, p > 0, and off the axis, ρ > 0, where a formula divides by p or ρ.

mod components;
mod definitions;
mod energy;
mod fixed;
mod frames;
mod hyperbolic;
mod setting;
#[cfg(test)]
mod tests;

use crate::claims::statement::Statement;
use crate::evidence::Subject;
use crate::exact::{ExactError, Expr, Obstacle, Proof, Prover};
pub use setting::Setting;

/// A statement about the turntable: formulas, or the two components of one.
pub type Law = Statement<Vec<Expr>, Read>;

/// How formulas are read.
#[derive(Debug, Clone, Copy)]
pub struct Read {
    /// Where.
    pub setting: fn() -> Result<Setting, ExactError>,
    /// True if the claim only says that the formula keeps its value.
    pub invariant: bool,
}

#[track_caller]
const fn law(
    subject: Subject,
    compared: &'static str,
    formulas: fn() -> Vec<Expr>,
    prove: fn(Vec<Expr>) -> Proof,
    setting: fn() -> Result<Setting, ExactError>,
) -> Law {
    let invariant = false;
    Law::within(
        subject,
        compared,
        formulas,
        prove,
        Read { setting, invariant },
    )
}

const fn invariant(mut law: Law) -> Law {
    law.setting.invariant = true;
    law
}

const RATE: &str = "the printed rate with the rate by (89), exactly";
const SIDES: &str = "the two sides, with (89)";

pub const EQ86: Law = law(
    Subject::Within,
    "the acceleration in the laboratory that (86) leads to, with friction alone",
    frames::eq86,
    frames::prove_eq86,
    Setting::dimensional,
);
pub const EQ87: Law = law(
    Subject::Printed,
    "(86) in the symbols (87) and (88) with (89)",
    frames::eq87,
    frames::prove_eq87,
    Setting::dimensional,
);
pub const EQ88: Law = law(
    Subject::Printed,
    "(86) in the symbols (87) and (88) with (89)",
    frames::eq88,
    frames::prove_eq88,
    Setting::dimensional,
);
pub const EQ89: Law = law(
    Subject::Within,
    "(89) with (86) in the units of (87) and (88)",
    frames::eq89,
    frames::prove_eq89,
    Setting::cartesian,
);
pub const EQ90: Law = law(
    Subject::Printed,
    SIDES,
    frames::eq90,
    frames::prove_eq90,
    Setting::cartesian,
);
pub const EQ91: Law = law(
    Subject::Within,
    SIDES,
    frames::eq91,
    frames::prove_eq91,
    Setting::cartesian,
);
pub const EQ92: Law = law(
    Subject::Within,
    SIDES,
    frames::eq92,
    frames::prove_eq92,
    Setting::cartesian,
);
pub const EQ93: Law = law(
    Subject::Printed,
    "(93) with the size of the velocity",
    definitions::eq93,
    definitions::prove_eq93,
    Setting::polar,
);
pub const EQ94: Law = law(
    Subject::Printed,
    "(94) with 𝛒·(d𝛒/dτ)/p",
    definitions::eq94,
    definitions::prove_eq94,
    Setting::polar,
);
pub const EQ95: Law = law(
    Subject::Printed,
    "(95) with ẑ·(𝛒 × d𝛒/dτ)/p",
    definitions::eq95,
    definitions::prove_eq95,
    Setting::polar,
);
pub const EQ96: Law = law(
    Subject::Printed,
    "the two sides, with (95)",
    components::eq96,
    components::prove_eq96,
    Setting::polar,
);
pub const EQ97: Law = law(
    Subject::Printed,
    "the two sides, with (94)",
    components::eq97,
    components::prove_eq97,
    Setting::polar,
);
pub const EQ98: Law = law(
    Subject::Printed,
    "the two sides, with (94) and (95)",
    components::eq98,
    components::prove_eq98,
    Setting::polar,
);
pub const EQ99: Law = law(
    Subject::Within,
    RATE,
    components::eq99,
    components::prove_eq99,
    Setting::polar,
);
pub const EQ100: Law = law(
    Subject::Within,
    RATE,
    components::eq100,
    components::prove_eq100,
    Setting::polar,
);
pub const EQ101: Law = law(
    Subject::Within,
    RATE,
    components::eq101,
    components::prove_eq101,
    Setting::polar,
);
pub const EQ102: Law = law(
    Subject::Printed,
    "each printed expression with ρ dρ/dτ by (89)",
    components::eq102,
    components::prove_eq102,
    Setting::polar,
);
pub const EQ103: Law = law(
    Subject::Printed,
    RATE,
    energy::eq103,
    energy::prove_eq103,
    Setting::polar,
);
pub const EQ104: Law = invariant(law(
    Subject::Printed,
    "the rate of (104) along (89) with 0",
    energy::eq104,
    energy::prove_eq104,
    Setting::polar,
));
pub const CORRECTED_106: Law = invariant(law(
    Subject::Corrected,
    "the rate of (106) with mμgs, along (86), with 0",
    energy::corrected_106,
    energy::prove_106,
    Setting::dimensional,
));
pub const EQ107: Law = law(
    Subject::Within,
    RATE,
    components::eq107,
    components::prove_eq107,
    Setting::polar,
);
pub const EQ108: Law = law(
    Subject::Printed,
    RATE,
    components::eq108,
    components::prove_eq108,
    Setting::polar,
);
pub const EQ109: Law = law(
    Subject::Within,
    RATE,
    components::eq109,
    components::prove_eq109,
    Setting::polar,
);
pub const EQ110: Law = law(
    Subject::Printed,
    "(110), by (111) and (112), with −A²",
    definitions::eq110,
    definitions::prove_eq110,
    Setting::slower,
);
pub const EQ111: Law = law(
    Subject::Printed,
    "ρ ± p by (111) and (112) with A exp(±α)",
    definitions::eq111,
    definitions::prove_eq111,
    Setting::slower,
);
pub const EQ112: Law = law(
    Subject::Printed,
    "ρ ± p by (111) and (112) with A exp(±α)",
    definitions::eq112,
    definitions::prove_eq112,
    Setting::slower,
);
pub const EQ113: Law = law(
    Subject::Printed,
    RATE,
    hyperbolic::eq113,
    hyperbolic::prove_eq113,
    Setting::slower,
);
pub const EQ114: Law = law(
    Subject::Within,
    RATE,
    hyperbolic::eq114,
    hyperbolic::prove_eq114,
    Setting::slower,
);
pub const EQ115: Law = law(
    Subject::Within,
    RATE,
    hyperbolic::eq115,
    hyperbolic::prove_eq115,
    Setting::slower,
);
pub const EQ116: Law = law(
    Subject::Printed,
    "(116), by (117) and (118), with B²",
    definitions::eq116,
    definitions::prove_eq116,
    Setting::faster,
);
pub const EQ117: Law = law(
    Subject::Printed,
    "p ± ρ by (117) and (118) with B exp(±β)",
    definitions::eq117,
    definitions::prove_eq117,
    Setting::faster,
);
pub const EQ118: Law = law(
    Subject::Printed,
    "p ± ρ by (117) and (118) with B exp(±β)",
    definitions::eq118,
    definitions::prove_eq118,
    Setting::faster,
);
pub const EQ119: Law = law(
    Subject::Printed,
    RATE,
    hyperbolic::eq119,
    hyperbolic::prove_eq119,
    Setting::faster,
);
pub const EQ120: Law = law(
    Subject::Printed,
    RATE,
    hyperbolic::eq120,
    hyperbolic::prove_eq120,
    Setting::faster,
);
pub const EQ121: Law = law(
    Subject::Within,
    RATE,
    hyperbolic::eq121,
    hyperbolic::prove_eq121,
    Setting::faster,
);
pub const EQ122: Law = law(
    Subject::Printed,
    "(111) to (115), with (122) and (123) put in, with (117) to (121)",
    hyperbolic::eq122,
    hyperbolic::prove_eq122,
    Setting::continued,
);
pub const EQ123: Law = law(
    Subject::Printed,
    "(111) to (115), with (122) and (123) put in, with (117) to (121)",
    hyperbolic::eq123,
    hyperbolic::prove_eq123,
    Setting::continued,
);
pub const EQ124: Law = law(
    Subject::Printed,
    "(115) at this angle with 0",
    fixed::eq124,
    fixed::prove_zero,
    Setting::fixed,
);
pub const EQ125: Law = law(
    Subject::Printed,
    "(115) at this angle with 0",
    fixed::eq125,
    fixed::prove_zero,
    Setting::fixed,
);
pub const S4_MIRROR: Law = law(
    Subject::Printed,
    "the mirrored accelerations of (86) with those of (86) for −Ω at the mirrored state",
    frames::eq86,
    frames::prove_mirror,
    Setting::dimensional,
);
pub const CORRECTED_WORK: Law = law(
    Subject::Corrected,
    "the power of the Coriolis force with 0, and the rate of −mμgs with the power of friction, in (86)",
    energy::works,
    energy::prove_works,
    Setting::dimensional,
);
pub const S4_QUASI_FIXED_STABILITY: Law = law(
    Subject::Within,
    "the slope of (115) at ψ₁ and ψ₂ with −2/sinh 2α and 2/sinh 2α",
    fixed::slope,
    fixed::prove_slope,
    Setting::fixed,
);

/// Those that hold.
#[cfg(test)]
const ALL: &[Law] = &[
    EQ86,
    EQ87,
    EQ88,
    EQ89,
    EQ90,
    EQ91,
    EQ92,
    EQ93,
    EQ94,
    EQ95,
    EQ96,
    EQ97,
    EQ98,
    EQ99,
    EQ100,
    EQ101,
    EQ102,
    EQ103,
    EQ104,
    CORRECTED_106,
    EQ107,
    EQ108,
    EQ109,
    EQ110,
    EQ111,
    EQ112,
    EQ113,
    EQ114,
    EQ115,
    EQ116,
    EQ117,
    EQ118,
    EQ119,
    EQ120,
    EQ121,
    EQ122,
    EQ123,
    EQ124,
    EQ125,
    S4_MIRROR,
    CORRECTED_WORK,
    S4_QUASI_FIXED_STABILITY,
];

/// A proof in a setting.
fn prove(
    title: &str,
    setting: Result<Setting, ExactError>,
    steps: impl FnOnce(&mut Prover<'_>, &Setting) -> Result<(), Obstacle>,
) -> Proof {
    match setting {
        Err(error) => Proof::impossible(title, error),
        Ok(setting) => Proof::of(title, &setting.ring, |p| {
            p.note("Law of motion", setting.law);
            steps(p, &setting)
        }),
    }
}

fn symbols<const N: usize>(names: [&'static str; N]) -> [Expr; N] {
    names.map(Expr::symbol)
}

/// Position and velocity in Cartesian components.
fn vectors() -> [[Expr; 2]; 2] {
    [symbols(["x", "y"]), symbols(["u", "v"])]
}

/// (106) as printed.
pub const PRINTED_106: Law = invariant(law(
    Subject::Printed,
    "the rate of (106) along (86) with 0",
    energy::printed_106,
    energy::prove_106,
    Setting::dimensional,
));

/// The work as printed.
pub const PRINTED_WORK: Law = law(
    Subject::Printed,
    "the power of the Coriolis force with 0, and the rate of −mgs with the power of friction, in (86)",
    energy::printed_works,
    energy::prove_works,
    Setting::dimensional,
);
