//! Section 2.4 for every q ≥ 1 and λ₀ > 0: the one motion that repeats itself, region by region, and that all are drawn to it.
//!
//! Where they exist, α = asin λ₀ and β = asin(qλ₀), between 0 and π/2: from rest forward motion begins at the phase α,
//! backward motion at π + β. Each link is an identity of the ring, and a term that has a sign.

use super::certified::arcs::{a_falls, b_falls, corner_falls, e_grows};
use super::exact::{
    arc, frictions, plane, printed_rates, prove_e, prove_eq53, prove_eq54, sides_of_a, sides_of_b,
    sides_of_e, with_angle, with_angles,
};
use super::prelude::*;

type Rates = [Expr; 2];
type Sides = [Expr; 2];

/// K of (53), and its sides.
type CurveA = (Expr, Sides);

pub(crate) const FIRST: Statement<(Rates, CurveA, [Expr; 2])> = Statement::shown(
    Printed,
    r"for every $q\ge1$ and $0<\lambda_0$ below A: from $m-K$ forward, from $m+K$ backward, with $\sin m=\lambda_0K/\sin K$, $\pi/2<m<\pi$, is a motion without rest, to which every motion along $x$ is drawn; the drive exceeds friction at both phases",
    || (printed_rates(), curve_a(), printed::s24_first_signs()),
    first,
);

pub(crate) const SECOND: Statement<(Rates, CurveA, [Sides; 2], Lists)> = Statement::shown(
    Corrected,
    r"for every $q\ge1$ and $\lambda_0$ above A, below B if $q\le q_Y$ and below E if $q>q_Y$: forward from $\sin^{-1}\lambda_0$, at once backward, then rest; between E and C forward, then rest; every motion along $x$ is drawn to this one",
    || {
        let signs = (printed::s24_second_signs(), printed::s24_fourth_signs());
        (
            printed_rates(),
            curve_a(),
            [sides_of_b(), sides_of_e()],
            signs,
        )
    },
    second,
);

/// The signs of region II and of region IV.
type Lists = ([Expr; 3], [Expr; 2]);

pub(crate) const THIRD: Statement<(Rates, Sides, Expr, [Expr; 4])> = Statement::shown(
    Printed,
    r"for every $1\le q<q_Y$ and $\lambda_0$ between B and C: forward from $\sin^{-1}\lambda_0$, rest, backward from $\pi+\sin^{-1}(q\lambda_0)$, rest; every motion along $x$ is drawn to this one",
    || {
        (
            printed_rates(),
            sides_of_b(),
            on_c(),
            printed::s24_third_signs(),
        )
    },
    |(rates, b, c, signs)| third(rates, b, c, signs),
);

pub(crate) const FOURTH: Statement<(Rates, [Expr; 2], [Expr; 2])> = Statement::shown(
    Printed,
    r"for every $q\ge1$ and $1/q<\lambda_0<1$: forward from $\sin^{-1}\lambda_0$, then rest; every motion along $x$ is drawn to this one",
    || {
        let curves = [on_c(), printed::eq56_lambda0()];
        (printed_rates(), curves, printed::s24_fourth_signs())
    },
    |(rates, curves, signs)| fourth(rates, curves, signs),
);

pub(crate) const FIFTH: Statement<(Rates, Expr, [Expr; 1])> = Statement::shown(
    Printed,
    r"for every $q\ge1$ and $\lambda_0>1$ the rates (51) and (52) oppose the motion by $\lambda_0-1$ at least: from every velocity along $x$ the particle is at rest after a finite time, and stays",
    || {
        (
            printed_rates(),
            printed::eq56_lambda0(),
            printed::s24_fifth_signs(),
        )
    },
    fifth,
);

fn curve_a() -> CurveA {
    (printed::eq53_k::tree(), sides_of_a())
}

fn on_c() -> Expr {
    printed::eq55_lambda0::tree()
}

/// The list says of the intervals of a period what was found.
fn listed<const N: usize>(
    p: &mut Prover<'_>,
    signs: [Expr; N],
    found: [i64; N],
) -> Result<(), Obstacle> {
    for (sign, found) in signs.into_iter().zip(found) {
        let says = match found {
            0 => "A rest, 0 in the list",
            1 => "Forward motion, 1 in the list",
            _ => "Backward motion, −1 in the list",
        };
        let sign = p.read(says, sign)?;
        p.equal("It is the number in the list", &sign, &Rational::int(found))?;
    }
    Ok(())
}

fn drawn([forward, backward]: Rates) -> Proof {
    Proof::in_ring(
        "Every motion is drawn to the one that repeats itself",
        plane(),
        |p| {
            p.shows("For λ₀ > 0 and q ≥ 1, with rests allowed: exactly one motion along x by (51) and (52) has the period 2π, and the velocity of every other one tends to it.");
            let [phi, q, lambda0] = symbols(["φ", "q", "λ₀"]);
            let [ahead, back] = [p.read("(51)", forward)?, p.read("(52)", backward)?];
            p.identity(
                ("(52) less (51)", backward - forward),
                ("which is positive", (1 + q) * lambda0),
            )?;
            p.note(
                "At rest",
                "friction balances the drive, and the rate, 0, is not below (51) and not above (52)",
            );
            let whole = 2 * pi();
            for (rate, is, friction) in [
                (&ahead, "It is that of (51)", lambda0),
                (&back, "It is that of (52)", -q * lambda0),
            ] {
                let velocity = -phi.cos() - friction * phi;
                let element = p.read("A velocity", velocity)?;
                let slope = p.slope("Its rate", &element, "φ")?;
                p.equal(is, &slope, rate)?;
                let change = velocity.with("φ", phi + whole) - velocity;
                p.identity(
                    ("Its change in a period", change),
                    ("what friction takes or gives", -whole * friction),
                )?;
            }
            p.remark("So no motion goes one way for ever, and a great velocity is smaller in size a period later. The velocity after a period is a continuous function of that before: some velocity is the same a period later");
            p.note(
                "Let two different motions repeat themselves, with the velocities 𝔴 and 𝔴 + d, d > 0",
                "their distance d stays, so that they never have different directions: 𝔴 is never between −d and 0. So 𝔴 ≥ 0 for ever, and the other goes forward for ever; or 𝔴 ≤ −d for ever, and itself goes backward for ever: a contradiction. Only one motion repeats itself",
            );
            Ok(())
        },
    )
}

/// The ring of both frictions, with a phase φ, the phase s of a start, and q as their ratio.
fn slips() -> Result<Ring, ExactError> {
    let mut ring = frictions()?;
    for name in ["φ", "s"] {
        ring.angle(name);
    }
    let [alpha, beta] = symbols(["α", "β"]);
    ring.define("q", ring.read(beta.sin() / alpha.sin())?)?;
    Ok(ring)
}

fn slip(
    title: &str,
    rate: Expr,
    (says, product, so): (&str, Expr, &str),
    friction: Expr,
    angle: [&str; 2],
) -> Proof {
    Proof::in_ring(title, slips(), |p| {
        p.shows(says);
        with_angle(p, angle);
        let [phi, s] = symbols(["φ", "s"]);
        let rate = p.read("The printed rate", rate)?;
        p.reads_as(&rate, "", product)?;
        p.note("So", so);
        let velocity = arc(s, phi, friction);
        let element = p.read("The velocity since a start at s", velocity)?;
        let slope = p.slope("Its rate", &element, "φ")?;
        p.equal("It is the printed rate", &slope, &rate)?;
        let whole = 2 * pi();
        for (says, end, left) in [
            ("At s it is", s, int(0)),
            ("A period later it is", s + whole, -whole * friction),
        ] {
            let says = (says, velocity.with("φ", end));
            p.identity(says, ("", left))?;
        }
        Ok(())
    })
}

fn forward_slip(rate: Expr) -> Proof {
    let [phi, alpha, lambda0] = symbols(["φ", "α", "λ₀"]);
    let product = 2 * ((phi + alpha) / 2).cos() * ((phi - alpha) / 2).sin();
    slip(
        "Forward motion speeds up and slows down once",
        rate,
        (
            "Let sin α = λ₀, 0 < α < π/2. A forward slip by (51) that begins at α, or later but before π − α, speeds up until π − α, then slows down, and ends before 2π + α.",
            product,
            "it is positive from α to π − α and negative from there to 2π + α: a forward slip that begins at α, or later but before π − α, ends between π − α and 2π + α. The velocity has no other zero within a period from its beginning, at whose end it would have risen to −2πλ₀",
        ),
        lambda0,
        ["α", "λ₀"],
    )
}

fn backward_slip(rate: Expr) -> Proof {
    let [phi, beta, q_lambda0] = symbols(["φ", "β", "qλ₀"]);
    let product = 2 * ((phi + beta) / 2).sin() * ((phi - beta) / 2).cos();
    slip(
        "Backward motion speeds up and slows down once",
        rate,
        (
            "Let sin β = qλ₀, 0 < β < π/2. A backward slip by (52) that begins at π + β, or later but before 2π − β, speeds up until 2π − β, then slows down, and ends before 3π + β.",
            product,
            "it is negative from π + β to 2π − β and positive from there to 3π + β: a backward slip that begins at π + β, or later but before 2π − β, ends between 2π − β and 3π + β. The velocity has no other zero within a period from its beginning, at whose end it would have fallen to 2πqλ₀",
        ),
        -q_lambda0,
        ["β", "qλ₀"],
    )
}

fn rests_on_slips(p: &mut Prover<'_>, rates: Rates) -> Result<(), Obstacle> {
    p.rests_on(&drawn(rates))?;
    p.rests_on(&forward_slip(rates[0]))?;
    p.rests_on(&backward_slip(rates[1]))
}

fn middle([left, right]: Sides) -> Proof {
    let ring = || {
        let mut ring = Ring::new();
        ring.angle("K");
        let lambda0 = ring.symbol("λ₀");
        ring.root(&(Rational::int(1) - &lambda0 * &lambda0), 2)?;
        Ok(ring)
    };
    Proof::in_ring("Below A: λ₀K < sin K", ring(), |p| {
        p.shows("Below A, which is where the left side of (53) exceeds the right one: λ₀K < sin K, with K by (53).");
        let [k, lambda0] = symbols(["K", "λ₀"]);
        let spare = 1 - (lambda0 * k / k.sin()).squared();
        let square = (lambda0 * (k.sin() - k * k.cos()) / k.sin().squared()).squared();
        let parts = lambda0.squared() * (left.squared() - right.squared()) + square;
        p.identity(("1 − (λ₀K/sin K)²", spare), ("λ₀² times the difference of the squared sides of (53), which is positive below A, and a square: so λ₀K < sin K", parts))
    })
}

/// A forward slip of the length 2K around m, and a backward one for the rest of the period; K = π/2 + y.
fn whole_period() -> Result<Ring, ExactError> {
    let mut ring = Ring::new();
    for name in ["y", "m"] {
        ring.angle(name);
    }
    let [y, m, k] = symbols(["y", "m", "K"]);
    ring.define("K", ring.read(pi() / 2 + y)?)?;
    let lambda0 = ring.read(m.sin() * k.sin() / k)?;
    ring.root(&ring.normal(&(Rational::int(1) - &lambda0 * &lambda0)), 2)?;
    ring.define("λ₀", lambda0)?;
    ring.define("q", ring.read(k / (pi() - k))?)?;
    Ok(ring)
}

fn first((rates, (k_formula, [left, right]), signs): (Rates, CurveA, [Expr; 2])) -> Proof {
    Proof::in_ring("Region I", whole_period(), |p| {
        rests_on_slips(p, rates)?;
        p.rests_on(&prove_eq53(k_formula, [left, right]))?;
        p.rests_on(&a_falls([left, right]))?;
        p.rests_on(&middle([left, right]))?;
        let [y, m, k, q, lambda0] = symbols(["y", "m", "K", "q", "λ₀"]);
        p.identity(("K by (53), for q = K/(π − K)", k_formula), ("", k))?;
        let (begin, turn) = (m - k, m + k);
        let whole = 2 * pi();
        p.vanishes("Forward from m − K: 𝔴 at m + K", arc(begin, turn, lambda0))?;
        let back = arc(turn, begin + whole, -q * lambda0);
        p.vanishes("Backward from there: 𝔴 at m − K + 2π", back)?;
        let pull = p.read("The pull at m − K", begin.sin() - lambda0)?;
        let factor = -m.cos() * k.sin() + lambda0 * (1 + k * y.tan());
        let factor = p.read("−cos m sin K + λ₀ (1 + K tan y), which is positive", factor)?;
        let both = (lambda0 * k.sin()).squared() * (left - right) * (left + right);
        let both = p.read("(λ₀ sin K)² (L − R)(L + R), which is positive", both)?;
        p.equal("Their product is that", &(&pull * &factor), &both)?;
        let other = p.read("The pull back at m + K", -turn.sin() - q * lambda0)?;
        let (quarter, near) = (pi().squared() / 4, pi() / 2 - y);
        let rest = (quarter - y.squared()) * y.sin() - y * y.cos();
        let more = p.read(
            "2λ₀/((π/2 − y) cos y) times (π²/4 − y²) sin y − y cos y",
            2 * lambda0 * rest / (near * y.cos()),
        )?;
        p.equal("It exceeds the other by that", &(&other - &pull), &more)?;
        let rest = p.read("Here (π²/4 − y²) sin y − y cos y", rest)?;
        let chord = 2 * y / pi();
        let terms =
            (quarter - y.squared()) * (y.sin() - chord) + y * (near - y.cos()) + near * chord * y;
        p.reads_as(&rest, "of which no term is negative: the sine lies above its chord, and cos y = sin(π/2 − y) below π/2 − y", terms)?;
        listed(p, signs, [1, -1])
    })
}

fn second((rates, (k_formula, a), [b, e], signs): (Rates, CurveA, [Sides; 2], Lists)) -> Proof {
    let ring = || {
        let mut ring = slips()?;
        ring.angle("z");
        Ok(ring)
    };
    Proof::in_ring("Region II, and between E and C", ring(), |p| {
        rests_on_slips(p, rates)?;
        for premise in [
            prove_eq53(k_formula, a),
            a_falls(a),
            prove_eq54(b),
            b_falls(),
            prove_e(e),
            e_grows(),
            corner_falls(),
        ] {
            p.rests_on(&premise)?;
        }
        with_angles(p);
        let [alpha, end, q, lambda0] = symbols(["α", "z", "q", "λ₀"]);
        let whole = 2 * pi();
        let both = arc(alpha, end, lambda0) + arc(end, alpha + whole, -q * lambda0);
        let left = (1 + q) * lambda0 * (alpha + 2 * k_formula - end);
        p.identity(
            (
                "𝔴 at 2π + α if the backward motion from z lasted until then",
                both,
            ),
            ("", left),
        )?;
        listed(p, signs.0, [1, -1, 0])?;
        listed(p, signs.1, [1, 0])
    })
}

fn third(rates: Rates, b: Sides, c: Expr, signs: [Expr; 4]) -> Proof {
    Proof::in_ring("Region III", slips(), |p| {
        rests_on_slips(p, rates)?;
        p.rests_on(&prove_eq54(b))?;
        p.rests_on(&b_falls())?;
        with_angles(p);
        let [alpha, beta, q, lambda0] = symbols(["α", "β", "q", "λ₀"]);
        p.identity(
            ("q (C − λ₀), by (55)", q * (c - lambda0)),
            (
                "positive, as sin β = qλ₀ with β < π/2 below C",
                ((beta / 2).cos() - (beta / 2).sin()).squared(),
            ),
        )?;
        let d = beta - alpha;
        let size = alpha.cos() + beta.cos();
        let end = arc(pi() + beta, 2 * pi() + alpha, -q * lambda0);
        let end = p.read("𝔴 of that slip at 2π + α", end)?;
        let weighted = &p.ring().read(pi() + d)? * &end;
        let short = p.read(
            "Right less left side of (54), which is positive",
            b[1] - b[0],
        )?;
        let first = &p.ring().read(pi() - d)? * &short;
        let tangent = (d / 2).tan();
        let product = pi().squared() - d.squared();
        let second = p.read(
            "(cos α + cos β) times (π² − d²) tan(d/2) − 2d, where d = β − α",
            size * (product * tangent - 2 * d),
        )?;
        p.equal(
            "π + d times 𝔴 is π − d times the second, and so the third",
            &weighted,
            &(&first + &second),
        )?;
        let terms = product * (tangent - d / 2) + d / 2 * (product - 4);
        p.identity(
            ("Here (π² − d²) tan(d/2) − 2d", product * tangent - 2 * d),
            ("of which no term is negative, as 0 ≤ d < π/2", terms),
        )?;
        listed(p, signs, [1, 0, -1, 0])
    })
}

fn fourth(rates: Rates, [c, d]: [Expr; 2], signs: [Expr; 2]) -> Proof {
    let ring = || {
        let mut ring = Ring::new();
        for name in ["α", "φ"] {
            ring.angle(name);
        }
        ring.symbol("q");
        ring.define("λ₀", ring.read(symbol("α").sin())?)?;
        Ok(ring)
    };
    Proof::in_ring("Region IV", ring(), |p| {
        p.rests_on(&drawn(rates))?;
        p.rests_on(&forward_slip(rates[0]))?;
        let [alpha, phi, q, lambda0] = symbols(["α", "φ", "q", "λ₀"]);
        let square = |x: Expr| ((x / 2).sin() + (x / 2).cos()).squared();
        p.identity(
            ("D − λ₀, by (56)", d - lambda0),
            (
                "positive, as below D there is an α < π/2 with sin α = λ₀",
                square(-alpha),
            ),
        )?;
        p.identity(
            ("(52)", rates[1]),
            (
                "q times λ₀ less C by (55), and a square",
                q * (lambda0 - c) + square(phi),
            ),
        )?;
        p.note(
            "With sin α = λ₀, the forward slip from α ends between π − α and 2π + α",
            "there −qλ₀ < sin φ < λ₀, and static friction holds the particle until the slip from 2π + α",
        );
        listed(p, signs, [1, 0])
    })
}

fn fifth(([forward, backward], d, signs): (Rates, Expr, [Expr; 1])) -> Proof {
    Proof::in_ring("Region V", plane(), |p| {
        let [phi, q, lambda0] = symbols(["φ", "q", "λ₀"]);
        let half = phi / 2;
        let excess = lambda0 - d;
        let ahead = p.read("(51)", forward)?;
        let least = excess + (half.sin() - half.cos()).squared();
        let least = p.read("λ₀ less (56), and a square", least)?;
        p.equal("Forward motion slows down by that", &-&ahead, &least)?;
        let back = p.read("(52)", backward)?;
        let least = excess + (q - 1) * lambda0 + (half.sin() + half.cos()).squared();
        let least = p.read("λ₀ less (56), (q − 1) λ₀, and a square", least)?;
        p.equal("So does backward motion, as q ≥ 1", &back, &least)?;
        listed(p, signs, [0])
    })
}

fn border(c: Expr) -> Proof {
    let (rates, b, _, signs) = (THIRD.formulas)();
    let (_, [_, d], [ahead, rest]) = (FOURTH.formulas)();
    Proof::in_ring("Curve C up to Y", plane(), |p| {
        p.rests_on(&third(rates, b, c, signs))?;
        p.rests_on(&FIRST.proof())?;
        p.rests_on(&SECOND.proof())?;
        p.rests_on(&fourth(rates, [c, d], [ahead, rest]))?;
        p.rests_on(&corner_falls())?;
        let q = symbol("q");
        let product = p.read("q times (55): there qλ₀ is the drive's amplitude", q * c)?;
        p.reads_as(&product, "", int(1))?;
        Ok(())
    })
}

attempts![
    // C, as far as it is a border.
    &CURVE_C = Statement::shown(
        Corrected,
        r"for every $1\le q\le q_Y$ there is backward motion just below (55), as in III or, at $q_Y$, in I or II, and none between it and D",
        on_c,
        border
    ),
    &FIRST,
    &SECOND,
    &THIRD,
    &FOURTH,
    &FIFTH
];
