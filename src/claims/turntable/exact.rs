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

pub use setting::Setting;
use trialbook::prelude::*;

/// A statement about the turntable: formulas, or the two components of one.
pub type Vectorial = Statement<Vec<Expr>>;

const RATE: Compared = Compared::one("the printed rate", "the rate by (89), exactly");
const SIDES: Compared = Compared::one("the left side", "the right side, with (89)");

const EQ86: Vectorial = Vectorial::new(
    Subject::Within,
    Compared::one(
        "the acceleration in the laboratory that (86) leads to",
        "that by friction alone",
    ),
    frames::eq86,
    frames::prove_eq86,
);
const EQ87: Vectorial = Vectorial::new(
    Subject::Printed,
    Compared::one("(86) in the symbols (87) and (88)", "(89)"),
    frames::eq87,
    frames::prove_eq87,
);
const EQ88: Vectorial = Vectorial::new(
    Subject::Printed,
    Compared::one("(86) in the symbols (87) and (88)", "(89)"),
    frames::eq88,
    frames::prove_eq88,
);
pub const EQ89: Vectorial = Vectorial::new(
    Subject::Within,
    Compared::one("(89)", "(86) in the units of (87) and (88)"),
    frames::eq89,
    frames::prove_eq89,
);
const EQ90: Vectorial = Vectorial::new(Subject::Printed, SIDES, frames::eq90, frames::prove_eq90);
const EQ91: Vectorial = Vectorial::new(Subject::Within, SIDES, frames::eq91, frames::prove_eq91);
const EQ92: Vectorial = Vectorial::new(Subject::Within, SIDES, frames::eq92, frames::prove_eq92);
const EQ93: Vectorial = Vectorial::new(
    Subject::Printed,
    Compared::one("(93)", "the size of the velocity"),
    definitions::eq93,
    definitions::prove_eq93,
);
const EQ94: Vectorial = Vectorial::new(
    Subject::Printed,
    Compared::one("(94)", r"$\bm\rho\cdot(\mathrm d\bm\rho/\mathrm d\tau)/p$"),
    definitions::eq94,
    definitions::prove_eq94,
);
pub const EQ95: Vectorial = Vectorial::new(
    Subject::Printed,
    Compared::one(
        "(95)",
        r"$\hat{\bm z}\cdot(\bm\rho\times\mathrm d\bm\rho/\mathrm d\tau)/p$",
    ),
    definitions::eq95,
    definitions::prove_eq95,
);
pub const EQ96: Vectorial = Vectorial::new(
    Subject::Printed,
    Compared::one("the left side", "the right side, with (95)"),
    components::eq96,
    components::prove_eq96,
);
const EQ97: Vectorial = Vectorial::new(
    Subject::Printed,
    Compared::one("the left side", "the right side, with (94)"),
    components::eq97,
    components::prove_eq97,
);
pub const EQ98: Vectorial = Vectorial::new(
    Subject::Printed,
    Compared::one("the left side", "the right side, with (94) and (95)"),
    components::eq98,
    components::prove_eq98,
);
pub const EQ99: Vectorial = Vectorial::new(
    Subject::Within,
    RATE,
    components::eq99,
    components::prove_eq99,
);
const EQ100: Vectorial = Vectorial::new(
    Subject::Within,
    RATE,
    components::eq100,
    components::prove_eq100,
);
pub const EQ101: Vectorial = Vectorial::new(
    Subject::Within,
    RATE,
    components::eq101,
    components::prove_eq101,
);
const TANGENTIAL: Vectorial = Vectorial::new(
    Subject::Within,
    RATE,
    components::tangential,
    components::prove_tangential,
);
const AZIMUTHAL: Vectorial = Vectorial::new(
    Subject::Corrected,
    RATE,
    components::azimuthal,
    components::prove_azimuthal,
);
const RADIAL: Vectorial = Vectorial::new(
    Subject::Corrected,
    RATE,
    components::radial,
    components::prove_radial,
);
const EQ102: Vectorial = Vectorial::new(
    Subject::Printed,
    Compared::one(
        "each printed expression",
        r"$\rho\,\mathrm d\rho/\mathrm d\tau$ by (89)",
    ),
    components::eq102,
    components::prove_eq102,
);
pub const EQ103: Vectorial =
    Vectorial::new(Subject::Printed, RATE, energy::eq103, energy::prove_eq103);
const EQ104: Vectorial = Vectorial::new(
    Subject::Printed,
    Compared::one("the rate of (104) along (89)", "0"),
    energy::eq104,
    energy::prove_eq104,
);
const CORRECTED_106: Vectorial = Vectorial::new(
    Subject::Corrected,
    Compared::one(r"the rate of (106) with $m\mu gs$, along (86),", "0"),
    energy::corrected_106,
    energy::prove_106,
);
pub const EQ107: Vectorial = Vectorial::new(
    Subject::Within,
    RATE,
    components::eq107,
    components::prove_eq107,
);
pub const EQ108: Vectorial = Vectorial::new(
    Subject::Printed,
    RATE,
    components::eq108,
    components::prove_eq108,
);
pub const EQ109: Vectorial = Vectorial::new(
    Subject::Within,
    RATE,
    components::eq109,
    components::prove_eq109,
);
pub const EQ110: Vectorial = Vectorial::new(
    Subject::Printed,
    Compared::one("(110), by (111) and (112),", "$-A^2$"),
    definitions::eq110,
    definitions::prove_eq110,
);
pub const EQ111: Vectorial = Vectorial::new(
    Subject::Printed,
    Compared::one(r"$\rho\pm p$ by (111) and (112)", r"$A\exp(\pm\alpha)$"),
    definitions::eq111,
    definitions::prove_eq111,
);
pub const EQ112: Vectorial = Vectorial::new(
    Subject::Printed,
    Compared::one(r"$\rho\pm p$ by (111) and (112)", r"$A\exp(\pm\alpha)$"),
    definitions::eq112,
    definitions::prove_eq112,
);
pub const EQ113: Vectorial = Vectorial::new(
    Subject::Printed,
    RATE,
    hyperbolic::eq113,
    hyperbolic::prove_eq113,
);
pub const EQ114: Vectorial = Vectorial::new(
    Subject::Within,
    RATE,
    hyperbolic::eq114,
    hyperbolic::prove_eq114,
);
pub const EQ115: Vectorial = Vectorial::new(
    Subject::Within,
    RATE,
    hyperbolic::eq115,
    hyperbolic::prove_eq115,
);
const EQ116: Vectorial = Vectorial::new(
    Subject::Printed,
    Compared::one("(116), by (117) and (118),", "$B^2$"),
    definitions::eq116,
    definitions::prove_eq116,
);
const EQ117: Vectorial = Vectorial::new(
    Subject::Printed,
    Compared::one(r"$p\pm\rho$ by (117) and (118)", r"$B\exp(\pm\beta)$"),
    definitions::eq117,
    definitions::prove_eq117,
);
const EQ118: Vectorial = Vectorial::new(
    Subject::Printed,
    Compared::one(r"$p\pm\rho$ by (117) and (118)", r"$B\exp(\pm\beta)$"),
    definitions::eq118,
    definitions::prove_eq118,
);
const EQ119: Vectorial = Vectorial::new(
    Subject::Printed,
    RATE,
    hyperbolic::eq119,
    hyperbolic::prove_eq119,
);
const EQ120: Vectorial = Vectorial::new(
    Subject::Printed,
    RATE,
    hyperbolic::eq120,
    hyperbolic::prove_eq120,
);
const EQ121: Vectorial = Vectorial::new(
    Subject::Within,
    RATE,
    hyperbolic::eq121,
    hyperbolic::prove_eq121,
);
const EQ122: Vectorial = Vectorial::new(
    Subject::Printed,
    Compared::many(
        "(111) to (115), with (122) and (123) put in,",
        "(117) to (121)",
    ),
    hyperbolic::eq122,
    hyperbolic::prove_eq122,
);
const EQ123: Vectorial = Vectorial::new(
    Subject::Printed,
    Compared::many(
        "(111) to (115), with (122) and (123) put in,",
        "(117) to (121)",
    ),
    hyperbolic::eq123,
    hyperbolic::prove_eq123,
);
pub const EQ124: Vectorial = Vectorial::new(
    Subject::Printed,
    Compared::one("(115) at this angle", "0"),
    fixed::eq124,
    fixed::prove_zero,
);
const EQ125: Vectorial = Vectorial::new(
    Subject::Printed,
    Compared::one("(115) at this angle", "0"),
    fixed::eq125,
    fixed::prove_zero,
);
const S4_MIRROR: Vectorial = Vectorial::new(
    Subject::Printed,
    Compared::many(
        "the mirrored accelerations of (86)",
        r"those of (86) for $-\Omega$ at the mirrored state",
    ),
    frames::eq86,
    frames::prove_mirror,
);
const CORRECTED_WORK: Vectorial = Vectorial::new(
    Subject::Corrected,
    Compared::many(
        r"the power of the Coriolis force and the rate of $-m\mu gs$, in (86),",
        "0 and the power of friction",
    ),
    energy::works,
    energy::prove_works,
);
const S4_QUASI_FIXED_STABILITY: Vectorial = Vectorial::new(
    Subject::Within,
    Compared::many(
        r"the slopes of (115) at $\psi_1$ and $\psi_2$",
        r"$-2/\sinh2\alpha$ and $2/\sinh2\alpha$",
    ),
    fixed::slope,
    fixed::prove_slope,
);

/// A proof in a setting.
fn prove(
    title: &str,
    setting: Result<Setting, ExactError>,
    steps: impl FnOnce(&mut Prover<'_>, &Setting) -> Result<(), Obstacle>,
) -> Proof {
    match setting {
        Err(error) => Proof::impossible(title, error),
        Ok(setting) => Proof::of(title, &setting.ring, |p| {
            p.note("Vectorial of motion", setting.law);
            steps(p, &setting)
        }),
    }
}

/// Position and velocity in Cartesian components.
fn vectors() -> [[Expr; 2]; 2] {
    [Expr::symbols(["x", "y"]), Expr::symbols(["u", "v"])]
}

/// (106) as printed.
pub const PRINTED_106: Vectorial = Vectorial::new(
    Subject::Printed,
    Compared::one("the rate of (106) along (86)", "0"),
    energy::printed_106,
    energy::prove_106,
);

/// The work as printed.
pub const PRINTED_WORK: Vectorial = Vectorial::new(
    Subject::Printed,
    Compared::many(
        "the power of the Coriolis force and the rate of $-mgs$, in (86),",
        "0 and the power of friction",
    ),
    energy::printed_works,
    energy::prove_works,
);

pub(super) const TRIALS: &[Attempt] = trials![
    &EQ86,
    &EQ87,
    &EQ88,
    &EQ89,
    &EQ90,
    &EQ91,
    &EQ92,
    &EQ93,
    &EQ94,
    &EQ95,
    &EQ96,
    &EQ97,
    &EQ98,
    &EQ99,
    &EQ100,
    &EQ101,
    &EQ102,
    &EQ103,
    &EQ104,
    &PRINTED_106,
    &CORRECTED_106,
    &EQ107,
    &EQ108,
    &EQ109,
    &EQ110,
    &EQ111,
    &EQ112,
    &EQ113,
    &EQ114,
    &EQ115,
    &EQ116,
    &EQ117,
    &EQ118,
    &EQ119,
    &EQ120,
    &EQ121,
    &EQ122,
    &EQ123,
    &EQ124,
    &EQ125,
    &S4_MIRROR,
    &TANGENTIAL,
    &AZIMUTHAL,
    &RADIAL,
    &PRINTED_WORK,
    &CORRECTED_WORK,
    &S4_QUASI_FIXED_STABILITY
];
