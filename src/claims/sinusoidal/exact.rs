//! Sinusoidal acceleration, exactly: what of section 2.2 is an identity.
//!
//! Entered here are Newton's law (1) on the line, v_y = 0, with |v| = v for v > 0 and −v for v < 0, and that the
//! square root of (36) and (37) is positive.

use super::prelude::*;
use crate::paper::sinusoidal as paper;

/// The ring in which λ₀ = sin φ₁, so that arcsin λ₀ = φ₁ and √(1 − λ₀²) = cos φ₁.
pub(super) fn ring_of_phi1() -> Result<Ring, ExactError> {
    let mut ring = Ring::new();
    let angle = ring.angle("β");
    ring.angle("φ");
    let beta = symbol("β");
    let (sine, cosine) = (ring.read(beta.sin())?, ring.read(beta.cos())?);
    ring.inverse(Function::Asin, &sine, &angle)?;
    ring.root_is(&(Rational::int(1) - &sine * &sine), 2, &cosine)?;
    ring.define("λ₀", sine)?;
    Ok(ring)
}

/// The ring in which φ̃₁ is an angle and λ₀ = 2 cos φ̃₁/π, so that arccos(π λ₀/2) = φ̃₁.
pub(super) fn ring_of_phi_t1() -> Result<Ring, ExactError> {
    let mut ring = Ring::new();
    let angle = ring.angle("φ̃₁");
    ring.angle("φ");
    let cosine = ring.read(symbol("φ̃₁").cos())?;
    ring.inverse(Function::Acos, &cosine, &angle)?;
    let pi = ring.read(pi())?;
    let lambda = ring.divide(&(Rational::int(2) * cosine), &pi)?;
    ring.define("λ₀", lambda)?;
    Ok(ring)
}

/// (21) to (24): the acceleration along x, λ₀, φ, and 𝔴.
fn units() -> [Expr; 4] {
    let [a0, varpi, vx] = symbols(["A₀", "ϖ", "v_x"]);
    let [ax, _] = paper::eq21_acceleration::tree();
    [
        ax,
        paper::eq22_lambda0::tree(),
        paper::eq23_phase::tree(),
        paper::eq24_w(varpi, vx, a0),
    ]
}

fn prove_eq26([ax, friction, phase, scaled]: [Expr; 4], rate: Expr, sign: i64) -> Proof {
    let ring = || {
        let mut ring = Ring::of(["A₀", "ϖ", "t", "μ", "g", "v_x", "𝔴"]);
        ring.angle("φ");
        let w = ring.named("𝔴")?;
        ring.root_is(&(&w * &w), 2, &(&w * &Rational::int(sign)))?;
        ring.define("λ₀", ring.read(friction)?)?;
        Ok(ring)
    };
    Proof::in_ring("(26): d𝔴/dφ", ring(), |p| {
        let [varpi, mu, g, phi] = symbols(["ϖ", "μ", "g", "φ"]);
        p.note("The velocity's sign", sign.to_string());
        p.read("λ₀ by (22)", friction)?;
        let at_phase = |formula: Expr| formula.with("t", phi / varpi);
        let ours = p.read("(23) at t = φ/ϖ", at_phase(phase))?;
        p.equal("It is φ", &ours, &p.ring().read(phi)?)?;
        let newton = -at_phase(ax) - int(sign) * mu * g;
        let newton = p.read("dv_x/dt by (1) and (21)", newton)?;
        let read = |p: &mut Prover<'_>, says: &str, formula: Expr, name: &str| {
            let element = p.ring().read(formula)?;
            p.slope(says, &element, name)
        };
        let scaled = read(p, "d𝔴/dv_x by (24)", scaled, "v_x")?;
        let clock = read(p, "dφ/dt by (23)", phase, "t")?;
        let expected = p.quotient("d𝔴/dφ by (1)", &(newton * scaled), &clock)?;
        p.reads_as(&expected, "the printed rate", rate)
    })
}

fn eq26_rate() -> Expr {
    paper::eq26_rate::tree()
}

pub(crate) const EQ26: Statement<([Expr; 4], Expr)> = Statement::new(
    Printed,
    Compared::one(
        "(26)",
        r"Newton's law (1) on the line, in the symbols (21) to (24), for both signs of $\mathfrak w$",
    ),
    || (units(), eq26_rate()),
    |(units, rate)| Proof::for_both_signs(|sign| prove_eq26(units, rate, sign)),
);

/// Drive and friction, sin φ ∓ λ₀, are a product of which each factor is zero once in a turn: one of them at a printed phase,
/// which lies in this quarter of the period, from 0, for 0 < λ₀ < 1. The drive's slope there is that at asin λ₀, or its negative.
fn prove_phase(phase: Expr, quarter: i64) -> Proof {
    let sign = if quarter < 2 { 1 } else { -1 };
    let growth = if quarter % 3 == 0 { 1 } else { -1 };
    let ring = || {
        let mut ring = ring_of_phi1()?;
        let (beta, pi) = (ring.named("β")?, ring.read(pi())?);
        ring.suppose_positive(&pi - &(&beta * &Rational::int(2)));
        ring.suppose_positive(beta);
        Ok(ring)
    };
    Proof::in_ring("The drive at the printed phase", ring(), |p| {
        let ring = p.ring();
        let [lambda0, phi, beta] = symbols(["λ₀", "φ", "β"]);
        let (two, sign, growth) = (int(2), int(sign), int(growth));
        p.remark("Let sin β = λ₀, with β between 0 and π/2");
        let rising = ((phi - sign * beta) / two).sin();
        let falling = ((phi + sign * beta) / two).cos();
        p.identity(
            ("Drive and friction", phi.sin() - sign * lambda0),
            (
                "of which each factor is 0 once in a turn",
                two * rising * falling,
            ),
        )?;
        let own = if quarter % 3 == 0 { rising } else { falling };
        p.vanishes("One of them at the printed phase", own.with("φ", phase))?;
        p.identity(
            ("The slope of the drive there", phase.cos()),
            (
                "with its sign that at asin λ₀",
                growth * lambda0.asin().cos(),
            ),
        )?;
        let end = |n: i64| ring.read(int(n) * pi() / two);
        let phase = ring.read(phase)?;
        let [first, last] = [&phase - &end(quarter)?, &end(quarter + 1)? - &phase];
        p.positive(
            "From the beginning of its quarter of the period to it",
            &first,
        )?;
        p.positive("From it to the end of that", &last)
    })
}

#[track_caller]
const fn at_phase(phase: fn() -> Expr, prove: fn(Expr) -> Proof) -> Statement {
    let compared = Compared::one(
        "the phase",
        r"the one zero of $\sin\phi\mp\lambda_0$, a product, in its quarter of the period, for $0<\lambda_0<1$",
    );
    Statement::new(Printed, compared, phase, prove)
}

/// A slip: its slope is sin φ ∓ λ₀, and it is zero at `start`.
fn slip(p: &mut Prover<'_>, w: Expr, sign: i64, start: Expr) -> Result<(), Obstacle> {
    let [lambda0, phi] = symbols(["λ₀", "φ"]);
    let value = p.read("The printed 𝔴", w)?;
    let slope = p.slope("Its slope", &value, "φ")?;
    p.reads_as(&slope, "the slope by (26)", phi.sin() - int(sign) * lambda0)?;
    let at_start = p.read("Where the slip begins", w.with("φ", start))?;
    p.reads_as(&at_start, "", int(0))
}

fn prove_eq31(w: Expr) -> Proof {
    Proof::in_ring("(31): the slip after a rest", ring_of_phi1(), |p| {
        slip(p, w, 1, paper::eq27_phi1::tree())
    })
}

pub(crate) const EQ31: Statement = Statement::new(
    Printed,
    Compared::many(
        r"the slope of (31), and (31) at $\phi_1$,",
        r"(26) for $\mathfrak w>0$, and 0",
    ),
    || {
        let [lambda0, phi] = symbols(["λ₀", "φ"]);
        paper::eq31_w(lambda0, paper::eq27_phi1::tree(), phi)
    },
    prove_eq31,
);

/// (31) `later` than an angle δ, for which another one, `end`, is put in: against the left side of (32) or (34).
fn prove_end(title: &str, left: Expr, later: Expr, end: &'static str) -> Proof {
    let ring = || {
        let mut ring = ring_of_phi1()?;
        ring.angle("φ̃₂");
        ring.angle("δ");
        Ok(ring)
    };
    Proof::in_ring(title, ring(), |p| {
        let [lambda0, phi, delta] = symbols(["λ₀", "φ", "δ"]);
        let slip = paper::eq31_w(lambda0, paper::eq27_phi1::tree(), phi);
        p.rests_on(&prove_eq31(slip))?;
        let at = p.read("(31) at an angle with δ", slip.with("φ", delta + later))?;
        let ring = p.ring();
        let half = |angle| -> Result<_, ExactError> {
            Ok([ring.named(angle)?, ring.half_tangent(angle)?])
        };
        let [[from, u], [to, w]] = [half("δ")?, half(end)?];
        let cosine = |angle: &'static str| ring.read((symbol(angle) / 2).cos());
        let values = [(&from, &to), (&u, &w), (&cosine("δ")?, &cosine(end)?)];
        let there = ring.put(&at, &values)?;
        p.note(&format!("It at δ = {end}"), ring.text(&there));
        p.reads_as(&there, "the left side", left)
    })
}

fn eq32_left() -> Expr {
    let [lambda0, end] = symbols(["λ₀", "φ̃₂"]);
    paper::eq32_left(lambda0, paper::eq27_phi1::tree(), end)
}

pub(crate) const EQ32: Statement = Statement::new(
    Printed,
    Compared::one("the left side of (32)", r"(31) at $\tilde\phi_2$"),
    eq32_left,
    |left| prove_end("(32): the slip (31) ends at φ̃₂", left, int(0), "φ̃₂"),
);

fn eq34_left() -> Expr {
    let lambda0 = symbol("λ₀");
    paper::eq34_left(
        lambda0,
        paper::eq27_phi1(lambda0),
        paper::eq29_phi3(lambda0),
    )
}

pub(crate) const EQ34: Statement = Statement::new(
    Printed,
    Compared::one("the left side of (34)", r"(31) at $\phi_3$"),
    eq34_left,
    |left| {
        let title = "(34): the slip (31) would be negative at φ₃ = π + β";
        prove_end(title, left, pi(), "β")
    },
);

const EQ25: Statement<[Expr; 2]> = Statement::new(
    Printed,
    Compared::one(
        "the drive less friction",
        "the difference of the sides of (25) less a square",
    ),
    paper::eq25_sides::tree,
    |[left, right]| {
        let ring = || {
            let mut ring = Ring::new();
            ring.symbol("λ₀");
            ring.angle("φ");
            Ok(ring)
        };
        Proof::in_ring("(25): where the drive can start a slip", ring(), |p| {
            let [lambda0, phi] = symbols(["λ₀", "φ"]);
            let half = phi / 2;
            let square = (half.sin() - half.cos()).squared();
            p.identity(
                ("The drive less friction, by (26)", phi.sin() - lambda0),
                (
                    "the right side less the left one, less a square",
                    right - left - square,
                ),
            )?;
            Ok(())
        })
    },
);

pub(crate) const EQ33: Statement<[Expr; 4]> = Statement::new(
    Printed,
    Compared::many("the slopes of (33), and its ends,", "(26), and 0 by (32)"),
    eq33,
    |cases| {
        let ring = || {
            let mut ring = ring_of_phi1()?;
            ring.angle("φ̃₂");
            Ok(ring)
        };
        Proof::in_ring("(33): slips and rests", ring(), |p| {
            let [lambda0, end] = symbols(["λ₀", "φ̃₂"]);
            let (phi1, phi3) = (paper::eq27_phi1::tree(), paper::eq29_phi3::tree());
            let [forward, first_rest, backward, second_rest] = cases;
            slip(p, forward, 1, phi1)?;
            slip(p, backward, -1, phi3)?;
            for rest in [first_rest, second_rest] {
                let rest = p.read("A rest", rest)?;
                p.zero("It is zero", &rest)?;
            }
            // (32) makes both slips end in zero.
            let left = p.read(
                "The left side of (32)",
                paper::eq32_left(lambda0, phi1, end),
            )?;
            let ends = paper::eq33_ends(phi1, end, phi3);
            let first = p.read("(33) at φ̃₂", forward.with("φ", ends[1]))?;
            p.equal("It vanishes with (32)", &first, &left)?;
            let second = p.read("(33) at φ̃₂ + π", backward.with("φ", ends[3]))?;
            p.equal("It vanishes with (32) too", &second, &-left)?;
            let period = p.read("The period of the cases", ends[4] - ends[0])?;
            p.equal("It is 2π", &period, &p.ring().read(2 * pi())?)
        })
    },
);

pub(super) fn eq33() -> [Expr; 4] {
    let [lambda0, phi] = symbols(["λ₀", "φ"]);
    paper::eq33_w(
        lambda0,
        paper::eq27_phi1::tree(),
        paper::eq29_phi3::tree(),
        phi,
    )
}

pub(crate) const EQ35: Statement = Statement::new(
    Printed,
    Compared::one("the left side of (35)", "that of (34), by (27) and (29)"),
    paper::eq35_left::tree,
    |left| {
        Proof::in_ring("(35): (34) in the friction alone", ring_of_phi1(), |p| {
            let lambda0 = symbol("λ₀");
            let (phi1, phi3) = (paper::eq27_phi1(lambda0), paper::eq29_phi3(lambda0));
            p.identity(
                (
                    "The left side of (34)",
                    paper::eq34_left(lambda0, phi1, phi3),
                ),
                ("the left side of (35)", left),
            )
        })
    },
);

/// Adds √(4 + π²), and √π² = π.
pub(super) fn with_lambda_c(mut ring: Ring) -> Result<Ring, ExactError> {
    let pi = ring.read(pi())?;
    ring.root(&(Rational::int(4) + &pi * &pi), 2)?;
    ring.root_is(&(&pi * &pi), 2, &pi)?;
    Ok(ring)
}

/// `found` = (1 + π²/4) (right² − left²): its sign is that of right − left, both being positive.
fn beside_lambda_c(
    p: &mut Prover<'_>,
    found: Expr,
    [left, right]: [Expr; 2],
) -> Result<(), Obstacle> {
    let factor = 1 + pi().squared() / 4;
    let expected = factor * (right.squared() - left.squared());
    p.identity(
        ("The difference of squares", found),
        ("by the printed sides", expected),
    )
}

/// The factor that turns the left side of (35) into a difference of squares is positive.
pub(crate) const EQ36: Statement<[Expr; 2]> = Statement::new(
    Printed,
    Compared::one(
        "the left side of (35), times the sum of its terms,",
        r"$(4+\pi^2)(\lambda_\mathrm c^2-\lambda_0^2)$",
    ),
    paper::eq36_sides::tree,
    |sides| {
        let ring = || {
            let mut ring = Ring::new();
            let lambda0 = ring.symbol("λ₀");
            ring.root(&(Rational::int(1) - &lambda0 * &lambda0), 2)?;
            with_lambda_c(ring)
        };
        Proof::in_ring("(36): (35) squared", ring(), |p| {
            let lambda0 = symbol("λ₀");
            let left = paper::eq35_left(lambda0);
            // (a − b)(a + b) with a − b the left side of (35) and b = π λ₀.
            let other = left + 2 * pi() * lambda0;
            beside_lambda_c(p, left * other / 4, sides)
        })
    },
);

/// (40): (38) passes through zero without rest where the drive exceeds friction there, sin φ̃₁ > λ₀ = sin φ₁; as both
/// phases are below π/2, that is (41) too.
pub(crate) const EQ40: Statement<[Expr; 2]> = Statement::new(
    Printed,
    Compared::one(
        r"$\sin^2\tilde\phi_1-\lambda_0^2$ by (39)",
        r"$(1+\pi^2/4)(\lambda_\mathrm c^2-\lambda_0^2)$",
    ),
    paper::eq40_sides::tree,
    |sides| {
        let ring = || with_lambda_c(ring_of_phi_t1()?);
        Proof::in_ring("(40): the drive where (38) vanishes", ring(), |p| {
            let lambda0 = symbol("λ₀");
            let drive = paper::eq39_phi_t1(lambda0).sin();
            beside_lambda_c(p, drive.squared() - lambda0.squared(), sides)
        })
    },
);

pub(super) fn prove_eq38(cases: [Expr; 2], ends: [Expr; 3]) -> Proof {
    Proof::in_ring("(38): no rest", ring_of_phi_t1(), |p| {
        let [forward, backward] = cases;
        slip(p, forward, 1, ends[0])?;
        slip(p, backward, -1, ends[1])?;
        for (w, end) in [(forward, ends[1]), (backward, ends[2])] {
            let value = p.read("Where the slip ends", w.with("φ", end))?;
            p.reads_as(&value, "", int(0))?;
        }
        let length = p.read("From where it begins to where it ends", ends[2] - ends[0])?;
        let period = p.read("A period", 2 * pi())?;
        p.equal("Its length is a period", &length, &period)
    })
}

pub(super) fn eq38() -> ([Expr; 2], [Expr; 3]) {
    let [lambda0, phi] = symbols(["λ₀", "φ"]);
    let turn = paper::eq39_phi_t1::tree();
    (paper::eq38_w(lambda0, turn, phi), paper::eq38_ends(turn))
}

#[cfg(test)]
mod tests;

attempts![
    &DEFINITIONS = Statement::new(
        Printed,
        Compared::one("Newton's law in the symbols (21) to (24)", "(26)"),
        || (units(), eq26_rate(), 1),
        |(a, b, c)| prove_eq26(a, b, c),
    ),
    &EQ25,
    &EQ26,
    &EQ27 = at_phase(paper::eq27_phi1::tree, |phase| prove_phase(phase, 0)),
    &EQ28 = at_phase(paper::eq28_phi2::tree, |phase| prove_phase(phase, 1)),
    &EQ29 = at_phase(paper::eq29_phi3::tree, |phase| prove_phase(phase, 2)),
    &EQ30 = at_phase(paper::eq30_phi4::tree, |phase| prove_phase(phase, 3)),
    &EQ31,
    &EQ32,
    &EQ33,
    &EQ34,
    &EQ35,
    &EQ36,
    &EQ37 = Statement::new(
        Printed,
        Compared::one("the left side of (35) at (37)", "0"),
        paper::eq37_lambda_c,
        |critical| {
            Proof::in_ring(
                "(37): the critical friction",
                with_lambda_c(Ring::new()),
                |p| p.vanishes("The left side of (35) at λ_c", paper::eq35_left(critical)),
            )
        },
    ),
    &EQ38 = Statement::new(
        Within,
        Compared::many(
            "the slopes of (38), and both its ends,",
            "(26), and 0 by (39)",
        ),
        eq38,
        |(a, b)| prove_eq38(a, b),
    ),
    &EQ39 = Statement::new(
        Printed,
        Compared::one(r"(38) with (39), half a period after $\tilde\phi_1$,", "0"),
        paper::eq39_phi_t1::tree,
        |turn| {
            Proof::in_ring("(39): where 𝔴 turns positive", ring_of_phi_t1(), |p| {
                let lambda0 = symbol("λ₀");
                let [forward, _] = paper::eq38_w(lambda0, turn, turn + pi());
                p.vanishes("(38) half a period after φ̃₁", forward)
            })
        },
    ),
    &EQ40
];
