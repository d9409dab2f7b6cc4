//! The index of symbols: the paper's, the code's, what they mean and in which units.

use super::error::Fault;
use super::fill::Filler;
use super::tables::table;
use super::text::escape;

/// A symbol.
struct Symbol {
    /// As the paper has it, in LaTeX.
    paper: &'static str,
    /// As the code has it: names of parameters, fields or functions.
    code: &'static [&'static str],
    /// What it means.
    meaning: &'static str,
    /// Its units.
    units: &'static str,
    /// Id of the claim that introduces it.
    claim: &'static str,
}

const fn symbol(
    paper: &'static str,
    code: &'static [&'static str],
    meaning: &'static str,
    units: &'static str,
    claim: &'static str,
) -> Symbol {
    Symbol {
        paper,
        code,
        meaning,
        units,
        claim,
    }
}

const NONE: &str = "dimensionless";

/// All symbols, in the paper's order.
const SYMBOLS: &[Symbol] = &[
    symbol("t", &["t"], "time", "time", "eq-1"),
    symbol(
        r"\bm v,\ v",
        &["velocity", "v"],
        "velocity relative to the plane, and its size",
        "length/time",
        "eq-1",
    ),
    symbol(
        r"\bm A",
        &["acceleration", "Acceleration"],
        "acceleration of the plane",
        "length/time²",
        "eq-1",
    ),
    symbol(
        r"\mu",
        &["mu"],
        "coefficient of friction, the same at rest and in motion",
        NONE,
        "eq-1",
    ),
    symbol("g", &["g"], "gravity", "length/time²", "eq-1"),
    symbol(
        "A",
        &["a"],
        "size of a constant acceleration",
        "length/time²",
        "eq-3",
    ),
    symbol(
        r"\theta,\ \theta_0",
        &["theta", "theta0"],
        "direction of the velocity, now and at the start",
        "radians",
        "eq-4",
    ),
    symbol(
        r"\lambda",
        &["lambda"],
        "friction over acceleration",
        NONE,
        "eq-5",
    ),
    symbol("v_0", &["v0"], "speed at the start", "length/time", "eq-11"),
    symbol(
        "T",
        &["eq20_stop_time"],
        "time at which the particle stops",
        "time",
        "eq-20",
    ),
    symbol(
        "A_0",
        &["a0"],
        "amplitude of a periodic acceleration",
        "length/time²",
        "eq-21",
    ),
    symbol(
        r"\varpi",
        &["varpi"],
        "angular frequency of the acceleration",
        "1/time",
        "eq-21",
    ),
    symbol(
        r"\lambda_0",
        &["lambda0"],
        "friction over the amplitude",
        NONE,
        "eq-22",
    ),
    symbol(
        r"\phi",
        &["phi"],
        "phase of the acceleration",
        "radians",
        "eq-23",
    ),
    symbol(
        r"\mathfrak w",
        &["w"],
        "velocity along the drive, in units of $A_0/\\varpi$",
        NONE,
        "eq-24",
    ),
    symbol(
        r"\phi_1,\dots,\phi_4",
        &["phi1", "phi3"],
        "phases at which the drive equals the friction",
        "radians",
        "eq-27",
    ),
    symbol(
        r"\tilde\phi_2",
        &["phi_t2"],
        "phase at which a slip ends",
        "radians",
        "eq-32",
    ),
    symbol(
        r"\lambda_\mathrm c",
        &["lambda_c"],
        "friction from which on there are rests",
        NONE,
        "eq-36",
    ),
    symbol(
        r"\tilde\phi_1",
        &["phi_t1"],
        "phase at which the motion without rest passes through zero",
        "radians",
        "eq-38",
    ),
    symbol(
        "h",
        &["h"],
        "form of a periodic drive, at most 1 in size",
        NONE,
        "eq-42",
    ),
    symbol(
        r"\eta",
        &["eta"],
        "share of a half period that a pulse fills",
        NONE,
        "eq-42",
    ),
    symbol(
        r"\mu_+,\ \mu_-",
        &["mu_plus", "mu_minus"],
        "coefficients of friction forwards and backwards",
        NONE,
        "eq-47",
    ),
    symbol("q", &["q"], "ratio $\\mu_-/\\mu_+$", NONE, "eq-50"),
    symbol(
        "K",
        &["k"],
        "half the length of the forward slip on curve A",
        "radians",
        "eq-53",
    ),
    symbol(
        r"\bm r",
        &["r", "x"],
        "position of the centre, or of the particle on the turntable",
        "length",
        "eq-59",
    ),
    symbol(
        r"m,\ I,\ R",
        &["mass", "inertia", "radius"],
        "mass, moment of inertia and radius of the sphere",
        "mass, mass·length², length",
        "eq-59",
    ),
    symbol(
        r"\bm F",
        &["force"],
        "friction on the sphere",
        "mass·length/time²",
        "eq-59",
    ),
    symbol(
        r"\bm\omega",
        &["omega"],
        "angular velocity of the sphere",
        "1/time",
        "eq-60",
    ),
    symbol(
        r"\bm R",
        &["contact"],
        "from the centre to the point of contact",
        "length",
        "eq-61",
    ),
    symbol(r"\kappa", &["kappa"], "$I/(mR^2)$", NONE, "eq-62"),
    symbol(
        "b",
        &["b"],
        "$1+1/\\kappa$, by which the sphere's friction is multiplied",
        NONE,
        "eq-67",
    ),
    symbol(
        r"\tau",
        &["tau"],
        "time: times $\\sqrt{\\mu g/R}$ for the sphere, times $\\Omega$ on the turntable",
        NONE,
        "eq-69",
    ),
    symbol(
        r"\bm\zeta",
        &["zeta3"],
        "angular velocity of the sphere, in units of $\\sqrt{\\mu g/R}$",
        NONE,
        "eq-70",
    ),
    symbol(
        r"\bm u",
        &["u", "slip"],
        "velocity of the point of contact, in units of $\\sqrt{\\mu gR}$",
        NONE,
        "eq-71",
    ),
    symbol(
        r"\bm\gamma",
        &["gamma"],
        "acceleration of the plane, in units of $\\mu g$",
        NONE,
        "eq-72",
    ),
    symbol(
        r"\bm\nu",
        &["nu"],
        "time integral of $\\bm\\gamma$",
        NONE,
        "eq-76",
    ),
    symbol(
        r"\bm c",
        &["c"],
        "constant of the sphere's velocity",
        NONE,
        "eq-79",
    ),
    symbol(
        r"\Omega",
        &["omega"],
        "angular velocity of the turntable",
        "1/time",
        "eq-86",
    ),
    symbol(
        r"\bm\rho,\ \rho",
        &["position", "rho"],
        "position: over $R$ for the sphere, over $\\mu g/\\Omega^2$ on the turntable; its size",
        NONE,
        "eq-87",
    ),
    symbol(
        "p",
        &["p"],
        "speed relative to the turntable",
        NONE,
        "eq-93",
    ),
    symbol(
        r"\psi",
        &["psi"],
        "angle from the velocity to the position",
        "radians",
        "eq-94",
    ),
    symbol(
        r"\xi",
        &["xi"],
        "position along the velocity",
        NONE,
        "eq-94",
    ),
    symbol(
        r"\ell",
        &["ell"],
        "position to the right of the velocity; angular momentum over $p$",
        NONE,
        "eq-95",
    ),
    symbol("s", &["s"], "way on the table", NONE, "eq-105"),
    symbol(
        r"A,\ \alpha",
        &["a", "alpha"],
        "hyperbolic parameters where $p<\\rho$",
        NONE,
        "eq-111",
    ),
    symbol(
        r"B,\ \beta",
        &["b", "beta"],
        "hyperbolic parameters where $p>\\rho$",
        NONE,
        "eq-117",
    ),
    symbol(
        r"\psi_1,\ \psi_2",
        &["eq124_psi1", "eq125_psi2"],
        "values of $\\psi$ at which $\\dot\\psi=0$",
        "radians",
        "eq-124",
    ),
    symbol(
        r"\sigma",
        &["sigma"],
        "distance from the axis at rest",
        NONE,
        "eq-139",
    ),
    symbol(
        "c",
        &["c"],
        "constant of the approach to rest",
        NONE,
        "eq-143",
    ),
    symbol(
        r"\text{E}",
        &["curve_e", "e_sides"],
        "border that the paper's diagram lacks",
        NONE,
        "s24-region-2",
    ),
    symbol(
        "k",
        &["winding"],
        "turn of an escape per unit of $\\ln\\tau$, $\\sqrt2$",
        NONE,
        "eq-136",
    ),
];

/// The table.
pub(super) fn table_of(filler: &Filler<'_>) -> Result<String, Fault> {
    let maths = filler.maths();
    let rows: Result<Vec<_>, Fault> = SYMBOLS
        .iter()
        .map(|symbol| {
            let code = symbol
                .code
                .iter()
                .map(|name| format!("<code>{}</code>", escape(name)));
            Ok([
                maths.inline(symbol.paper)?,
                code.collect::<Vec<_>>().join(", "),
                maths.words(symbol.meaning)?,
                symbol.units.to_owned(),
                filler.link(filler.entry(symbol.claim)?)?,
            ])
        })
        .collect();
    let head = ["Paper", "Code", "Meaning", "Units", "First in"];
    Ok(table("symbols", head, rows?))
}

#[cfg(test)]
mod tests {
    use super::SYMBOLS;
    use crate::book::code::Code;
    use crate::claims;

    #[test]
    fn every_name_stands_in_the_code() {
        let code = Code::new();
        for symbol in SYMBOLS {
            assert!(claims::find(symbol.claim).is_some(), "{}", symbol.paper);
            for name in symbol.code {
                assert!(code.names(name), "{}: no `{name}`", symbol.paper);
            }
        }
    }
}
