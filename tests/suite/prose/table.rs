//! Which part of a printed text is which formula of the code: one line each.
//!
//! An equation without a line is held by the default: its right side is its only formula.

use super::corrections;
use slipbook::exact::Expr;
use slipbook::seeded::Formula;

/// A part of a text. Statements and sides are counted from 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Place {
    /// A side: of this statement, of this number.
    Side(usize, usize),
    /// Both sides of this statement.
    Sides(usize),
    /// What is differentiated on the left of the first statement.
    Rate,
    /// π/2 less the right side.
    FromRightAngle,
    /// The values of all cases.
    Pieces,
    /// Where the cases begin and the last one ends; each has to begin where the one before it ends.
    Ends,
    /// The right sides of what is listed in brackets.
    List,
}

use Place::{Ends, FromRightAngle, List, Pieces, Rate, Side, Sides};

/// A line: of which text; which formula between dollar signs, 0 if the text is a formula; the part; the formulas it is
/// held against, one after the other; names that mean something of their own there.
///
/// A formula is given by the end of its path, with `.2` for the third of its components; or it is `0` or `π`. A name means
/// an argument of the formula or a component of one, a formula, a number, or with `@` the right side of that statement.
pub type Line = (&'static str, usize, Place, &'static str, Names);

type Names = &'static [(&'static str, &'static str)];

const NONE: Names = &[];
const BY_THETA: Names = &[(r"\mathrm d\theta", "1")];
const POWER: Names = &[(r"\mathrm{d}{[(\tan\frac{\theta}{2})^\lambda]}", "d_power")];
const AT_START: Names = &[("v_0", "v"), (r"\theta_0", "theta")];
const LAMBDA_C: Names = &[(r"\lambda_\mathrm{c}", "eq37_lambda_c")];
const SLIP: Names = &[(
    r"\frac{\mathrm d\bm r}{\mathrm dt}+\bm\omega\times\bm R",
    "slip",
)];
const UPRIGHT_I: Names = &[(r"\mathrm{i}", "i")];
const SLIP_SPEED: Names = &[("u_0", "v0")];
const ALONG_X: Names = &[("A", "A_x")];
const PER_A: Names = &[("A", "1")];
const PHI_1: Names = &[(r"\tilde\phi_1", "eq39_phi_t1")];
const HALF_ANGLE: Names = &[(r"\chi", "@1")];
const H: Names = &[(r"h(\phi)", "h")];
const W: Names = &[(r"\mathfrak{w}(\phi)", "w")];

/// Printed equations that are not held by the default.
pub const PRINTED: &[Line] = &[
    ("9", 0, Side(0, 1), "eq9_log_speed_rate", BY_THETA),
    ("10", 0, Side(0, 0), "eq10_invariant", NONE),
    ("12", 0, Side(0, 1), "eq12_time_rate", POWER),
    ("17", 0, Side(0, 0), "eq17_invariant", NONE),
    ("17", 0, Side(0, 1), "eq17_invariant", AT_START),
    ("25", 0, Sides(0), "eq25_sides", NONE),
    ("32", 0, Sides(0), "eq32_left 0", NONE),
    ("33", 0, Pieces, "eq33_w", NONE),
    ("33", 0, Ends, "eq33_ends", NONE),
    ("34", 0, Sides(0), "eq34_left 0", NONE),
    ("35", 0, Sides(0), "eq35_left 0", NONE),
    ("36", 0, Sides(0), "eq36_sides", LAMBDA_C),
    ("38", 0, Pieces, "eq38_w", NONE),
    ("38", 0, Ends, "eq38_ends", NONE),
    ("40", 0, Sides(0), "eq40_sides", LAMBDA_C),
    ("41", 0, Sides(0), "eq41_sides", NONE),
    ("42", 0, Pieces, "eq42_cases", NONE),
    ("42", 0, Ends, "0 eq42_end π", NONE),
    ("43", 0, Side(0, 1), "eq43_h", H),
    ("44", 0, Pieces, "eq44_cases", NONE),
    ("44", 0, Ends, "0 eq44_ends π", NONE),
    ("45", 0, Side(0, 1), "eq45_w", W),
    ("53", 0, Side(0, 1), "eq53_k", NONE),
    ("53", 0, Sides(1), "eq53_sides", NONE),
    ("54", 0, Sides(0), "eq54_sides", NONE),
    ("57", 0, List, "eq57_x", LAMBDA_C),
    ("58", 0, List, "eq58_y", NONE),
    ("66", 0, Side(0, 1), "eq66_slip_rate", SLIP),
    ("71", 0, Side(0, 1), "eq71_slip", SLIP),
    ("96", 0, Sides(0), "eq96_angular_momentum", NONE),
    ("97", 0, Sides(0), "eq97_radial", NONE),
    ("98", 0, Sides(0), "eq98_distance", NONE),
    ("102", 0, Side(0, 1), "eq102_rate.2", NONE),
    ("103", 0, Rate, "eq103_energy", NONE),
    ("103", 0, Side(0, 1), "eq103_energy_rate", NONE),
    ("104", 0, Side(0, 0), "eq104_constant", NONE),
    ("106", 0, Side(0, 0), "eq106_constant", NONE),
    ("110", 0, Sides(0), "eq110_case 0", NONE),
    ("116", 0, Sides(0), "eq116_case 0", NONE),
    ("122", 0, Side(0, 1), "eq122_a", UPRIGHT_I),
    ("123", 0, Side(0, 1), "eq123_alpha", UPRIGHT_I),
    ("129", 0, Side(0, 0), "eq129_a", NONE),
    ("134", 0, FromRightAngle, "eq134_lag", NONE),
    ("138", 0, Side(0, 0), "eq138_s", NONE),
    ("142", 0, Side(0, 0), "eq142_left", NONE),
    ("142", 0, Side(0, 1), "eq142_right", NONE),
    ("143", 0, Side(0, 1), "eq143_psi", NONE),
    ("144", 0, Side(0, 0), "eq144_left", NONE),
    ("144", 0, Side(0, 1), "eq144_right", NONE),
];

/// Equations that the plain text of their row states in other words than the print, and the print's left side.
pub const OTHER_WORDS: &[(&str, &str)] = &[
    ("63", "d²𝐫/dt² = "),
    ("64", "κ R² d𝛚/dt = "),
    ("65", "d(𝛚 × 𝐑)/dt = "),
    ("66", "d/dt (d𝐫/dt + 𝛚 × 𝐑) = "),
    ("71", "𝐮 = "),
    ("86", "d²𝐫/dt² = "),
    ("92", "𝛒·(d²𝛒/dτ²) + (d𝛒/dτ)·(d𝛒/dτ) = "),
    ("102", "= "),
];

/// The corrections' formulas, by the claim.
pub const CORRECTED: &[Line] = &[
    ("eq-11", 0, Side(0, 1), "constant::speed", NONE),
    ("eq-13", 0, Side(0, 1), "constant::time_of_ln_r", NONE),
    ("eq-55", 0, Side(0, 1), "eq55_lambda0", NONE),
    ("s24-region-2", 6, Sides(0), "anisotropic::e_sides", NONE),
    ("eq-75", 0, Side(0, 1), "sphere::spin", NONE),
    ("eq-81", 0, Side(0, 1), "constant::speed", SLIP_SPEED),
    ("eq-82", 0, Side(0, 1), "sphere::time", NONE),
    ("eq-82", 0, Side(1, 1), "eq72_acceleration.0", ALONG_X),
    ("eq-83", 0, Side(0, 1), "sphere::slip_at_time", NONE),
    ("eq-83", 0, Side(1, 1), "eq72_acceleration.0", ALONG_X),
    ("eq-106", 0, Side(0, 0), "turntable::constant", NONE),
    ("eq-128", 0, Side(0, 1), "escape::alpha_rate", NONE),
    ("eq-129", 0, Side(0, 0), "eq129_a", NONE),
    ("eq-129", 0, Side(0, 1), "escape::product_over_a", PER_A),
    ("eq-130", 0, Side(0, 1), "escape::alpha_by_a", NONE),
    ("eq-131", 0, Side(0, 1), "escape::a_rate", NONE),
    ("eq-132", 0, Side(0, 1), "escape::late_a", NONE),
    ("eq-133", 0, Side(0, 1), "escape::alpha", NONE),
    ("eq-134", 0, FromRightAngle, "escape::late_lag", NONE),
    ("eq-135", 0, Side(0, 1), "escape::late_rho", NONE),
    ("eq-136", 0, Side(0, 1), "escape::late_rho", NONE),
    ("eq-137", 0, Side(0, 1), "escape::late_s", NONE),
    ("eq-146", 0, Side(0, 1), "rest::surface_slope", NONE),
    ("eq-147", 0, Side(0, 1), "rest::boundary_least", NONE),
    (
        "s22-rest-of-period",
        2,
        Side(0, 0),
        "sinusoidal::rest_of_period_end",
        NONE,
    ),
    (
        "s22-vy-two-stages",
        11,
        Side(0, 0),
        "sinusoidal::last_stage",
        NONE,
    ),
    (
        "s22-vy-two-stages",
        13,
        Side(0, 1),
        "sinusoidal::drive_at_zero",
        PHI_1,
    ),
    (
        "s22-vy-two-stages",
        16,
        Side(0, 0),
        "sinusoidal::passage_factor",
        NONE,
    ),
    (
        "s4-coriolis-no-work",
        1,
        Side(0, 0),
        "corrections::turntable::friction_work",
        NONE,
    ),
    ("s4-psi-free", 2, Side(0, 1), "rest::surface_a", HALF_ANGLE),
    (
        "s4-envelope-is-boundary",
        3,
        Side(0, 0),
        "rest::boundary_a",
        HALF_ANGLE,
    ),
];

/// Formulas of the corrections that are written for more kinds of numbers than these trees alone, or that a print joins.
pub fn joined() -> Vec<Formula<Expr>> {
    let formula = |path, arguments, symbols: &[&'static str], value| Formula {
        path,
        name: path,
        tried_in: None,
        arguments,
        lengths: vec![1; arguments.len()],
        symbols: symbols.to_vec(),
        value,
    };
    let late = |path, value| formula(path, &["tau"], &["τ"], value);
    vec![
        formula(
            "slipbook::corrections::constant::time_of_ln_r",
            &["lambda", "a", "v0", "theta0", "r"],
            &["λ", "A", "v₀", "θ₀", "r"],
            corrections::time,
        ),
        late("slipbook::corrections::escape::late_a", corrections::late_a),
        late(
            "slipbook::corrections::escape::late_lag",
            corrections::late_lag,
        ),
        late(
            "slipbook::corrections::escape::late_rho",
            corrections::late_rho,
        ),
        late("slipbook::corrections::escape::late_s", corrections::late_s),
    ]
}
