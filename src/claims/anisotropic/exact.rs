//! Section 2.4, exactly: the rates, the curves A, B and E, their meeting points, the touch at Y, the mirror.
//!
//! With α = asin λ₀ and β = asin(qλ₀) both sides of a printed formula are rational in the tangents of half these
//! angles. The curves are held against an arc from rest at φ₀, ∫ (sin φ ∓ λ±) dφ = cos φ₀ − cos φ ∓ λ± (φ − φ₀), and
//! against no formula of the paper.

use super::prelude::*;

/// With the friction of forward motion as sin α and that of backward motion as sin β.
pub(super) fn frictions() -> Result<Ring, ExactError> {
    let mut ring = Ring::new();
    for (angle, friction) in [("α", "λ₀"), ("β", "qλ₀")] {
        let value = ring.angle(angle);
        let (sine, cosine) = (
            ring.read(symbol(angle).sin())?,
            ring.read(symbol(angle).cos())?,
        );
        ring.inverse(Function::Asin, &sine, &value)?;
        // Both angles lie between 0 and π/2.
        let radicand = Rational::int(1) - &sine * &sine;
        ring.root_is(&radicand, 2, &cosine)?;
        ring.define(friction, sine)?;
    }
    Ok(ring)
}

pub(super) fn with_angles(p: &mut Prover<'_>) {
    p.remark("Let sin α = λ₀ and sin β = qλ₀, with α and β between 0 and π/2");
}

pub(super) fn with_angle(p: &mut Prover<'_>, [angle, friction]: [&str; 2]) {
    p.remark(&format!(
        "Let sin {angle} = {friction}, with {angle} between 0 and π/2"
    ));
}

/// 𝔴 after an arc from rest at `from` to `to`, with the deceleration `friction` (its sign included).
pub(super) fn arc(from: Expr, to: Expr, friction: Expr) -> Expr {
    from.cos() - to.cos() - friction * (to - from)
}

/// (47) to (50).
fn definitions() -> [Expr; 4] {
    [
        printed::eq47_lambda_plus::tree(),
        printed::eq48_lambda_minus::tree(),
        printed::eq49_lambda_plus::tree(),
        printed::eq50_lambda_minus::tree(),
    ]
}

/// (51) and (52) from Newton's law along x, dv_x/dt = A₀ sin ϖt ∓ μ±g, in the units of (23) and (24) and with the friction
/// by the definitions.
fn prove_rates(definitions: [Expr; 4], rates: [Expr; 2]) -> Proof {
    let ring = || {
        let mut ring = Ring::of(["A₀", "g", "μ₊", "μ₋", "q", "λ₀"]);
        ring.angle("φ");
        Ok(ring)
    };
    Proof::in_ring("(51) and (52)", ring(), |p| {
        let ring = p.ring();
        let [a0, g, phi] = symbols(["A₀", "g", "φ"]);
        p.note(
            "While sliding",
            "dv_x/dt = A₀ sin φ less the friction, φ = ϖt, 𝔴 = ϖv_x/A₀",
        );
        let names = ["μ₊", "μ₋"];
        for (i, sign) in [(0, 1), (1, -1)] {
            let both = [definitions[i], definitions[i + 2]].map(|d| ring.read(d));
            let [own, named] = both;
            let says = format!(
                "{} = {}, for the friction",
                definitions[i],
                definitions[i + 2]
            );
            let solved = p.solve(&says, &[own? - named?], None, &[names[i]])?;
            let newton = (a0 * phi.sin() - int(sign) * symbol(names[i]) * g) / a0;
            let found = p.read("d𝔴/dφ by Newton's law", newton)?;
            let values: Vec<_> = solved.iter().map(|(x, value)| (x, value)).collect();
            let found = ring.put(&found, &values)?;
            p.reads_as(&found, "the printed rate", rates[i])?;
        }
        Ok(())
    })
}

pub(crate) const DEFINED: Statement<([Expr; 4], [Expr; 2])> = Statement::new(
    Printed,
    Compared::one("Newton's law in the symbols (47) to (50)", "(51) and (52)"),
    || (definitions(), printed_rates()),
    |(a, b)| prove_rates(a, b),
);

pub(super) fn prove_eq53(k_formula: Expr, [left, right]: [Expr; 2]) -> Proof {
    let balance = || {
        let mut ring = Ring::new();
        ring.symbol("q");
        ring.symbol("λ₀");
        Ok(ring)
    };
    let balanced = Proof::in_ring("(53): K", balance(), |p| {
        p.shows("For K = πq/(q + 1): λ₀ 2K = qλ₀ (2π − 2K), so that friction takes forwards in the phase 2K what it gives backwards in the rest of a period.");
        let [q, lambda0] = symbols(["q", "λ₀"]);
        let lost = lambda0 * 2 * k_formula;
        let gained = q * lambda0 * (2 * pi() - 2 * k_formula);
        let lost = p.read("Taken forwards, with the printed K", lost)?;
        p.reads_as(&lost, "what is given backwards", gained)
    });
    let angles = || {
        let mut ring = frictions()?;
        ring.angle("K");
        Ok(ring)
    };
    Proof::in_ring("(53): curve A", angles(), |p| {
        p.rests_on(&balanced)?;
        with_angle(p, ["α", "λ₀"]);
        let [alpha, k, lambda0] = symbols(["α", "K", "λ₀"]);
        let end = p.read(
            "𝔴 at α + 2K after a start at α",
            arc(alpha, alpha + 2 * k, lambda0),
        )?;
        let factor = 2 * k.sin().squared() * alpha.sin();
        let stated = p.read(
            "2 sin²K sin α times left less right side",
            factor * (left - right),
        )?;
        p.equal("The two vanish together", &end, &stated)
    })
}

pub(super) fn prove_eq54([left, right]: [Expr; 2]) -> Proof {
    Proof::in_ring("(54): curve B", frictions(), |p| {
        with_angles(p);
        let [alpha, beta, lambda0] = symbols(["α", "β", "λ₀"]);
        p.identity(
            (
                "𝔴 at π + β after a start at α",
                arc(alpha, pi() + beta, lambda0),
            ),
            ("the left side less the right one", left - right),
        )
    })
}

pub(super) fn prove_e([left, right]: [Expr; 2]) -> Proof {
    Proof::in_ring("Curve E", frictions(), |p| {
        with_angles(p);
        let [alpha, beta, lambda0] = symbols(["α", "β", "λ₀"]);
        let late = 2 * pi() - beta;
        p.identity(
            ("𝔴 at 2π − β after a start at α", arc(alpha, late, lambda0)),
            ("the left side less the right one", left - right),
        )
    })
}

pub(super) fn sides_of_b() -> [Expr; 2] {
    let [lambda0, q_lambda0] = symbols(["λ₀", "qλ₀"]);
    printed::eq54_sides(lambda0, q_lambda0)
}

pub(super) fn sides_of_a() -> [Expr; 2] {
    printed::eq53_sides::tree()
}

pub(super) fn sides_of_e() -> [Expr; 2] {
    let [lambda0, q_lambda0] = symbols(["λ₀", "qλ₀"]);
    corrected::e_sides(lambda0, q_lambda0)
}

pub(crate) const X: Statement<[Expr; 2]> = Statement::new(
    Printed,
    Compared::one("X", "(53) and (54) at $q=1$"),
    printed::eq57_x,
    |[q, critical]| {
        let lambda0 = symbol("λ₀");
        let k = |mut ring: Ring| {
            ring.define("K", ring.read(printed::eq53_k(q))?)?;
            Ok(ring)
        };
        let same = Proof::in_ring("A and B at the q of X", frictions().and_then(k), |p| {
            p.shows("At q = 1, with sin α = λ₀: (54), left less right side, is 2 sin α times (53), left less right side.");
            let [left, right] = sides_of_a();
            let a = p.read("A: left less right side", left - right)?;
            let [left, right] = printed::eq54_sides(lambda0, q * lambda0);
            let b = p.read("B: left less right side", left - right)?;
            let factor = p.read("2 sin α", 2 * symbol("α").sin())?;
            p.equal("B is 2 sin α times A", &b, &(&factor * &a))
        });
        let roots = || {
            let mut ring = Ring::of(["λ₀"]);
            let own = ring.named("λ₀")?;
            ring.root(&(Rational::int(1) - &own * &own), 2)?;
            ring.suppose_positive(own);
            let square = ring.read(4 + pi().squared())?;
            ring.root(&square, 2)?;
            k(ring)
        };
        Proof::in_ring("(57): X", roots(), |p| {
            p.rests_on(&same)?;
            let [left, right] = sides_of_a();
            let a = p.read("A: left less right side", left - right)?;
            let cosine = (1 - lambda0.squared()).sqrt();
            let factor = 2 * lambda0 * (2 * cosine + pi() * lambda0);
            let factor = p.read("A factor", factor)?;
            p.positive("It", &factor)?;
            let distance = critical.squared() - lambda0.squared();
            let product = (4 + pi().squared()) * distance;
            let says = "A times that, by the printed λ₀, where alone it is 0";
            let product = p.read(says, product)?;
            p.equal("The two", &(&a * &factor), &product)
        })
    },
);

pub(crate) const Y: Statement<[Expr; 2]> = Statement::new(
    Printed,
    Compared::one(
        "the direction of (54)",
        r"that of (55) where they meet, which is where $\tan x=x$ and $q=\sqrt{1+x^2}$",
    ),
    sides_of_b,
    prove_y,
);

/// The touch at Y: on (54), at β = π/2, qλ₀ = sin β stands still while λ₀ = sin α goes on; and tan x = x.
fn prove_y([left, right]: [Expr; 2]) -> Proof {
    let ring = || {
        let mut ring = frictions()?;
        ring.symbols(["x", "D"]);
        Ok(ring)
    };
    Proof::in_ring("B and C touch at Y", ring(), |p| {
        let b = p.read("B: left less right side", left - right)?;
        let by_alpha = p.slope("Its slope along α", &b, "α")?;
        let by_beta = p.slope("Its slope along β", &b, "β")?;
        let turn = p.quotient("dβ/dα along B", &-&by_alpha, &by_beta)?;
        let on_c = |p: &mut Prover<'_>, x: &Rational| -> Result<Rational, ExactError> {
            // β = π/2, where the tangent of the half is 1 and its cosine 1/√2; only cos²(β/2) occurs.
            let ring = p.ring();
            let beta = ring.named("β")?;
            let half = ring.read(pi() / 2)?;
            ring.put(
                x,
                &[
                    (&beta, &half),
                    (&ring.half_tangent("β")?, &Rational::int(1)),
                ],
            )
        };
        let growth = p.read("cos β, by which d(qλ₀) = cos β dβ", symbol("β").cos())?;
        let rate = on_c(p, &(&growth * &turn))?;
        p.zero("d(qλ₀)/dα along B is 0 at β = π/2", &rate)?;
        let meeting = on_c(p, &b)?;
        let [alpha] = symbols(["α"]);
        let x = 3 * pi() / 2 - alpha;
        let condition = p.read("x cos x − sin x with x = 3π/2 − α", x * x.cos() - x.sin())?;
        p.equal("B at β = π/2 vanishes with it", &meeting, &condition)?;
        let [q, _] = [alpha.cot(), int(0)];
        let square = p.read("1 + x², with x = tan x = cot α", 1 + q.squared())?;
        let one = p.read("The square of λ₀", symbol("λ₀").squared())?;
        p.equal(
            "Their product is 1, so that q = 1/λ₀ = √(1 + x²)",
            &(&square * &one),
            &Rational::int(1),
        )?;
        p.rests_on(&prove_eq54([left, right]))?;
        touch(p)
    })
}

/// B beside Y in powers of ε = asin λ₀ − α: qλ₀ = sin β has no term in ε, and a negative one in ε². The length D of the arc is
/// cot α at Y, and grows as β − α.
fn touch(p: &mut Prover<'_>) -> Result<(), Obstacle> {
    let ring = p.ring();
    let [alpha, beta, length] = symbols(["α", "β", "D"]);
    let half_turn = ring.read(pi())?;
    let (own, x, one) = (ring.named("α")?, ring.named("x")?, Rational::int(1));
    let mut d = vec![p.read("The length of the arc at Y is x, which is", alpha.cot())?];
    let zeros = || std::iter::repeat_n(Rational::int(0), ORDER);
    let a = [own, one.clone()].into_iter().chain(zeros());
    let a = Series::new(0, a.collect());
    let mut b = vec![ring.divide(&half_turn, &Rational::int(2))?];
    let end = alpha.cos() - (pi() + beta).cos() - alpha.sin() * length;
    for k in 1..=ORDER {
        let slower = if k == 1 { &x - &one } else { x.clone() };
        let trial = |known: &[Rational], next: &Rational| {
            Series::new(0, known.iter().chain([next]).cloned().collect())
        };
        let known = [("α", &a), ("β", &trial(&b, &x)), ("D", &trial(&d, &slower))];
        let left = ring.expand(end, &known, ORDER as i64)?;
        let left = left.coefficient(k as i64).ok_or(Obstacle::Empty)?;
        let says = format!("B at the order ε^{k}, for the coefficient x of β");
        for (x, value) in p.solve(&says, &[left], None, &["x"])? {
            d.push(ring.put(&slower, &[(&x, &value)])?);
            b.push(value);
        }
    }
    let b = Series::new(0, b);
    let slope = b.coefficient(1).ok_or(Obstacle::Empty)?;
    let sine = p.expand("qλ₀", beta.sin(), &[("β", &b)], ("ε", ORDER as i64))?;
    let at = |k| sine.coefficient(k).ok_or(Obstacle::Empty);
    p.equal("It is on C at Y", &at(0)?, &Rational::int(1))?;
    p.zero("It does not leave C at the order ε", &at(1)?)?;
    let half_square = &slope.pow(2) * &p.ring().divide(&Rational::int(1), &Rational::int(2))?;
    p.equal(
        "At the order ε² it lies below C by half the square of the slope of β",
        &-&at(2)?,
        &half_square,
    )?;
    p.quotient(
        "The slope is not zero, as it has the inverse",
        &Rational::int(1),
        &slope,
    )?;
    Ok(())
}

/// The touch is of the first order; two more orders follow.
const ORDER: usize = 3;

pub(super) fn plane() -> Result<Ring, ExactError> {
    let mut ring = Ring::new();
    ring.angle("φ");
    ring.symbol("q");
    ring.symbol("λ₀");
    Ok(ring)
}

/// The rate of a slip with friction, against the excess of a curve's friction over it and a square: the drive can
/// start that slip exactly where the excess is positive.
fn prove_start(title: &str, rate: Expr, excess: Expr, square: Expr) -> Proof {
    Proof::in_ring(title, plane(), |p| {
        p.identity(
            ("The rate by (51) or (52)", rate),
            (
                "by how far λ₀ is from the curve, and a square",
                excess + square,
            ),
        )
    })
}

fn prove_mirror(([forward, backward], [other_q, other_lambda0]): ([Expr; 2], [Expr; 2])) -> Proof {
    Proof::in_ring("The mirror", plane(), |p| {
        let [phi] = symbols(["φ"]);
        let mirrored = |rate: Expr| {
            let [apart, both] = ["q there", "λ₀ there"];
            let rate = rate.with("q", symbol(apart)).with("λ₀", symbol(both));
            let rate = rate.with(apart, other_q).with(both, other_lambda0);
            -rate.with("φ", phi + pi())
        };
        for (says, here, there) in [
            ("Forward motion", forward, backward),
            ("Backward motion", backward, forward),
        ] {
            p.identity(
                (says, here),
                ("that of the other, mirrored", mirrored(there)),
            )?;
        }
        Ok(())
    })
}

pub(super) fn printed_rates() -> [Expr; 2] {
    [printed::eq51_rate::tree(), printed::eq52_rate::tree()]
}

pub(crate) const E: Statement<[Expr; 2]> = Statement::new(
    Corrected,
    Compared::one(
        "E",
        r"the forward arc from $\sin^{-1}\lambda_0$ to $2\pi-\sin^{-1}(q\lambda_0)$",
    ),
    sides_of_e,
    prove_e,
)
.of_a_part();

pub(crate) const MIRROR: Statement<([Expr; 2], [Expr; 2])> = Statement::new(
    Printed,
    Compared::many(
        r"(51) and (52) under $\phi\to\phi+\pi$, $\mathfrak w\to-\mathfrak w$, $\lambda_0\to q\lambda_0$, $q\to1/q$",
        "(52) and (51)",
    ),
    || (printed_rates(), printed::s24_mirrored::tree()),
    prove_mirror,
);

attempts![
    &DEFINED,
    &EQ51 = Statement::new(
        Printed,
        Compared::one(
            "(51)",
            "Newton's law along $x$, in the units of (23), (24) and (47) to (50)",
        ),
        printed::eq51_rate::tree,
        |formula| prove_rates(definitions(), [formula, printed_rates()[1]]),
    ),
    &EQ52 = Statement::new(
        Printed,
        Compared::one(
            "(52)",
            "Newton's law along $x$, in the units of (23), (24) and (47) to (50)",
        ),
        printed::eq52_rate::tree,
        |formula| prove_rates(definitions(), [printed_rates()[0], formula]),
    ),
    &EQ53 = Statement::new(
        Printed,
        Compared::one(
            "(53)",
            r"the balance of friction over a period, with a forward arc of length $2K$ from $\sin^{-1}\lambda_0$",
        ),
        || (printed::eq53_k::tree(), sides_of_a()),
        |(a, b)| prove_eq53(a, b),
    ),
    &EQ54 = Statement::new(
        Printed,
        Compared::one(
            "(54)",
            r"the forward arc from $\sin^{-1}\lambda_0$ to $\pi+\sin^{-1}(q\lambda_0)$",
        ),
        sides_of_b,
        prove_eq54,
    ),
    // (55): backward motion can begin, d𝔴/dφ < 0 by (52) at some φ, exactly below C.
    &EQ55 = Statement::new(
        Step,
        Compared::one(
            "(52)",
            r"$q$ times the difference of $\lambda_0$ and (55), plus a square that vanishes at $\phi=3\pi/2$",
        ),
        printed::eq55_lambda0::tree,
        |curve| {
            let [q, lambda0, phi] = symbols(["q", "λ₀", "φ"]);
            let half = phi / 2;
            let square = (half.sin() + half.cos()).squared();
            let rate = printed::eq52_rate::tree();
            prove_start("(55): curve C", rate, q * (lambda0 - curve), square)
        },
    ),
    // (56): forward motion can begin, d𝔴/dφ > 0 by (51) at some φ, exactly below D.
    &EQ56 = Statement::new(
        Printed,
        Compared::one(
            "(51)",
            r"(56) less $\lambda_0$, less a square that vanishes at $\phi=\pi/2$",
        ),
        printed::eq56_lambda0,
        |curve: Expr| {
            let [lambda0, phi] = symbols(["λ₀", "φ"]);
            let half = phi / 2;
            let square = (half.sin() - half.cos()).squared();
            let rate = printed::eq51_rate::tree();
            prove_start("(56): curve D", rate, curve - lambda0, -square)
        },
    ),
    &X,
    &MIRROR,
    &E,
    &Y
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn b_leaves_y_with_its_slope() {
        // dB/dα = −cos α (3π/2 − α) and dB/dβ = −1 − sin α at β = π/2, where 3π/2 − α = cot α: by α, the slope of β is
        // −cos²α/(sin α (1 + sin α)) = 1 − 1/sin α.
        let proof = prove_y(sides_of_b());
        let mut steps = proof.steps().iter();
        let first = steps.find(|step| step.says.starts_with("B at the order ε^1"));
        let gives = "x = −(tan(α/2)^2 − 2 tan(α/2) + 1)/(2 tan(α/2))";
        assert_eq!(first.unwrap().gives, gives);
    }
}
