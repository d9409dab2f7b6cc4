//! How the velocity across the drive dies, as corrected: linearly while it is large; below λ_c by a factor of its logarithm where
//! v_x passes through zero; above λ_c to zero, after a finite time.
//!
//! With T = tan(θ/2) = v_y/(v + v_x) the motion keeps d ln v_y/dφ to λ₀/h times d ln T/dφ, h = sin φ. Beside a zero of v_x the drive
//! h is nearly d = sin φ̃₁, and ln T goes from −ln v_y to ln v_y, up to bounded terms. All is in units of A₀ and ϖ, with v_y > 0.

use super::attraction::{IGNORES_VY, TRICHOTOMY};
use super::chains::{VY_VANISHES, eq21, in_units};
use super::exact::{EQ40, eq38, prove_eq38, ring_of_phi_t1};
use crate::claims::general::two_frames::{eq1, eq1_proof, eq2, eq2_proof};
use crate::corrections::sinusoidal as corrected;
use crate::paper::sinusoidal as paper;
use trialbook::prelude::*;

/// Of the velocity, by (1).
type Rate = [Expr; 2];
type NoRest = ([Expr; 2], [Expr; 3]);

/// Of a passage through zero: the size of the drive there, the factor of ln v_y, and that of a distance to (38) in a period.
type Passage = [Expr; 3];

fn passage_formulas() -> Passage {
    let lambda0 = Expr::symbol("λ₀");
    let d = corrected::drive_at_zero(lambda0);
    let factor = corrected::passage_factor(lambda0, d);
    [d, factor, corrected::contraction(lambda0)]
}

fn ring_of_motion() -> Result<Ring, ExactError> {
    let mut ring = Ring::new();
    let [_, _, _, vx, vy] = ["λ₀", "d", "h", "v_x", "v_y"].map(|name| ring.symbol(name));
    ring.angle("φ");
    ring.root(&(vx.pow(2) + vy.pow(2)), 2)?;
    Ok(ring)
}

/// The ring in which sin φ̃₁ is the positive root of 1 − (πλ₀/2)².
fn ring_of_passage() -> Result<Ring, ExactError> {
    let mut ring = ring_of_phi_t1()?;
    let turn = Expr::symbol("φ̃₁");
    let [sine, cosine] = [ring.read(turn.sin())?, ring.read(turn.cos())?];
    ring.root_is(&(Rational::int(1) - &cosine * &cosine), 2, &sine)?;
    Ok(ring)
}

fn velocity() -> [Expr; 3] {
    let [vx, vy] = Expr::symbols(["v_x", "v_y"]);
    [vx, vy, (vx.squared() + vy.squared()).sqrt()]
}

/// While v_y is large its slope is the stated one.
fn first_stage(law: Rate, slope: Expr) -> Proof {
    Proof::in_ring(
        "A large velocity across falls linearly",
        ring_of_motion(),
        |p| {
            p.rests_on(&eq1_proof(law))?;
            let lambda0 = Expr::symbol("λ₀");
            let ([vx, vy, v], two) = (velocity(), Expr::int(2));
            let [_, across] = in_units(law, eq21());
            let across = p.read("dv_y/dφ by (1) and (21)", across)?;
            let stated = p.read("The stated slope", slope)?;
            let excess = lambda0 * vx.squared() / (v * (v + vy));
            let above = p.read("λ₀ v_x²/(v (v + v_y)), which is not negative", excess)?;
            p.equal(
                "The one is above the other by that",
                &(&across - &stated),
                &above,
            )?;
            let most = lambda0 * vx.squared() / (two * vy.squared());
            let terms = lambda0 * vx.squared() * (v - vy) * (v + two * vy);
            p.identity(
                ("λ₀ (v_x/v_y)²/2 less that", most - excess),
                (
                    "a product of which no factor is negative",
                    terms / (two * vy.squared() * v * (v + vy)),
                ),
            )?;
            p.note(
            "So as v_x/v_y tends to 0",
            "the slope tends to the stated one, and over any phase v_y falls by that much, up to λ₀/2 times the sum of (v_x/v_y)²",
        );
            Ok(())
        },
    )
}

/// How v_y and the direction of the velocity change together.
fn turning(law: Rate) -> Proof {
    Proof::in_ring(
        "The velocity across and the direction",
        ring_of_motion(),
        |p| {
            p.rests_on(&eq1_proof(law))?;
            let [lambda0, d, phi] = Expr::symbols(["λ₀", "d", "φ"]);
            let [vx, vy, v] = velocity();
            let rates = in_units(law, eq21());
            let along = p.read("dv_x/dφ by (1) and (21)", rates[0])?;
            let across = p.read("dv_y/dφ by (1) and (21)", rates[1])?;
            p.reads_as(
                &across,
                "so that v_y falls, and ln v_y at the rate λ₀/v",
                -(lambda0 * vy / v),
            )?;
            let motion = p
                .ring()
                .along(&[("v_x", along.clone()), ("v_y", across.clone())])?;
            let tangent = p.read(
                "T, the tangent of half the angle with the drive",
                vy / (v + vx),
            )?;
            let turn = p.derivative("Its rate", &tangent, &motion)?;
            p.reads_as(
                &turn,
                "so that ln T has the rate −sin φ/v",
                -(phi.sin() / v) * vy / (v + vx),
            )?;
            let ring = p.ring();
            let [of_y, of_t] = [
                ring.divide(&across, &ring.read(vy)?)?,
                ring.divide(&turn, &tangent)?,
            ];
            let apart = of_y - ring.read(lambda0 / d)? * of_t;
            let drift = p.read("λ₀ (sin φ − d)/(d v)", lambda0 * (phi.sin() - d) / (d * v))?;
            p.equal(
                "The rate of ln v_y less λ₀/d times that of ln T",
                &apart,
                &drift,
            )?;
            p.identity(
                ("T v_y", vy / (v + vx) * vy),
                ("the sum of v and of the size of v_x where v_x < 0", v - vx),
            )?;
            // The other zero is the mirror image.
            let pi = Expr::pi();
            for (says, rate, sign) in [("dv_x/dφ", rates[0], -1), ("dv_y/dφ", rates[1], 1)] {
                let mirrored = rate.with("v_x", -vx).with("φ", phi + pi);
                p.identity(
                    (
                        &format!("{says} half a period later with v_x reversed"),
                        mirrored,
                    ),
                    (
                        "that before, with the sign of a mirror image",
                        Expr::int(sign) * rate,
                    ),
                )?;
            }
            Ok(())
        },
    )
}

/// The drive stays near its size d at the zeros of (38), and above friction.
fn near_zero(p: &mut Prover<'_>, [d, ..]: Passage) -> Result<(), Obstacle> {
    given(p, &[&EQ40])?;
    let [lambda0, turn, phi] = Expr::symbols(["λ₀", "φ̃₁", "φ"]);
    let two = Expr::int(2);
    p.identity(
        ("The stated size of the drive at a zero, d", d),
        ("", paper::eq39_phi_t1(lambda0).sin()),
    )?;
    p.note("By (40)", "d is above λ₀ below λ_c");
    let halves = two * ((phi - turn) / two).sin() * ((phi + turn) / two).cos();
    p.identity(
        ("sin φ − d", phi.sin() - d),
        ("of the size of φ − φ̃₁ at most", halves),
    )?;
    let margin = (d - lambda0) / two;
    p.identity(
        ("With m = (d − λ₀)/2: d − m", d - margin),
        ("", lambda0 + margin),
    )?;
    p.note(
        "So no farther from φ̃₁ than m",
        "sin φ ≥ λ₀ + m, and as dv_x/dφ ≥ sin φ − λ₀ the size of v_x is m times the distance from its zero at least",
    );
    Ok(())
}

/// Late zeros of v_x come close to those of (38): an inequality for their distances Z and Z′ from them, one after the other.
fn zeros_settle(law: Rate, (cases, ends): NoRest, passage: Passage) -> Proof {
    let ring = || -> Result<Ring, ExactError> {
        let mut ring = ring_of_passage()?;
        let [vx, vy] = ["v_x", "v_y"].map(|name| ring.symbol(name));
        ring.angle("Z");
        ring.root(&(vx.pow(2) + vy.pow(2)), 2)?;
        Ok(ring)
    };
    Proof::in_ring("The zeros of v_x settle", ring(), |p| {
        p.rests_on(&turning(law))?;
        p.rests_on(&prove_eq38(cases, ends))?;
        given(p, &[&TRICHOTOMY])?;
        near_zero(p, passage)?;
        let [lambda0, phi, turn, z] = Expr::symbols(["λ₀", "φ", "φ̃₁", "Z"]);
        let [vx, vy, v] = velocity();
        let (one, two) = (Expr::int(1), Expr::int(2));
        p.note(
            "Late, v is close to (38)",
            "v_x has one zero within m of each zero of (38), at the distance Z from it, which tends to 0; farther from them the size of v_x has a positive bound from below",
        );
        let [along, _] = in_units(law, eq21());
        let along = p.read("dv_x/dφ by (1) and (21)", along)?;
        for (says, sign) in [("v_x > 0", 1), ("v_x < 0", -1)] {
            let sign = Expr::int(sign);
            let lack = one - sign * vx / v;
            let terms = phi.sin() - sign * lambda0 + sign * lambda0 * lack;
            p.reads_as(&along, &format!("Where {says}, the slope on the line, and λ₀ times what 1 has beyond the size of v_x/v, with a sign"), terms)?;
            p.identity(
                (
                    "(v_y + |v_x|)² less v²",
                    (vy + sign * vx).squared() - v.squared(),
                ),
                ("not negative", two * vy * sign * vx),
            )?;
        }
        p.note(
            "So λ₀ times what 1 has beyond the size of v_x/v is λ₀ v_y/v at most, the rate at which v_y falls",
            "all that v_x departs from the motion on the line from the beginning of a passage on is v_y there at most: Y",
        );

        let [forward, backward] = cases;
        let pi = Expr::pi();
        let rise = turn.cos() - (turn + z).cos();
        p.identity(
            ("(38) at φ̃₁ + Z", forward.with("φ", turn + z)),
            (
                "the integral of the drive from φ̃₁ to there, less λ₀Z",
                rise - lambda0 * z,
            ),
        )?;
        let before = backward.with("φ", turn + two * pi - z);
        let rise = (turn - z).cos() - turn.cos();
        p.identity(
            ("(38) at φ̃₁ − Z, a period later", before),
            (
                "the negative integral of the drive from there to φ̃₁, less λ₀Z",
                -rise - lambda0 * z,
            ),
        )?;
        p.note(
            "A zero that is late or early by Z",
            "so on the line v_x is off (38) by the drive's sum and λ₀ Z before, and by the drive's sum less λ₀ Z after; both sums are Z times a mean of sin φ, and so d Z up to Z² at most",
        );
        p.note(
            "Between two passages v_x on the line keeps its distance from (38)",
            "so of one zero and the next, with Y for what is across: Z′ (d + λ₀ − Z′) ≤ Z (d − λ₀ + Z) + Y",
        );
        let [d, factor, contraction] = passage;
        let ratio = (d - lambda0) / (d + lambda0);
        p.identity(
            ("(d − λ₀)/(d + λ₀), twice", ratio.squared()),
            ("the stated contraction in a period", contraction),
        )?;
        let inverse = p.read(
            "The stated factor of ln v_y times (d − λ₀)/(d + λ₀)",
            factor * ratio,
        )?;
        p.equal("They are inverse", &inverse, &p.ring().read(one)?)
    })
}

/// Below λ_c: a passage multiplies ln v_y by the factor, up to terms that stay bounded.
fn passages(law: Rate, motion: NoRest, passage: Passage) -> Proof {
    let ring = || -> Result<Ring, ExactError> {
        let mut ring = ring_of_passage()?;
        for name in ["L", "b", "e", "Z", "Z′", "Y", "B"] {
            ring.symbol(name);
        }
        Ok(ring)
    };
    let title = "A passage multiplies the logarithm of the velocity across";
    Proof::in_ring(title, ring(), |p| {
        p.rests_on(&turning(law))?;
        p.rests_on(&zeros_settle(law, motion, passage))?;
        given(p, &[&VY_VANISHES])?;
        near_zero(p, passage)?;
        let [lambda0, before, b, e] = Expr::symbols(["λ₀", "L", "b", "e"]);
        let [d, factor, _] = passage;
        let one = Expr::int(1);
        p.note(
            "From m before φ̃₁ to m after",
            "−ln v_y goes from L to M, and ln T from L to −M, up to bounded terms, as |v_x| has bounds there: in all ln T changes by b − L − M, with a bounded b",
        );
        p.note(
            "The sum of λ₀ (sin φ − d)/(d v)",
            "is e/d: |sin φ − d| is |φ − zero of v_x| + Z at most and |v_x| ≥ m |φ − zero of v_x|, so that |e| ≤ 2λ₀ + Z (M − L), as λ₀/v has the sum M − L",
        );
        let after = factor * before - (lambda0 * b + e) / (d - lambda0);
        let left = before - after;
        let right = lambda0 / d * (b - before - after) + e / d;
        let left = p.read(
            "With M = (stated factor) L − (λ₀ b + e)/(d − λ₀): L − M",
            left,
        )?;
        let right = p.read("λ₀/d times the change of ln T, and e/d", right)?;
        p.equal("The two, as the rates say", &left, &right)?;
        p.note(
            "From one passage to the next",
            "ln v_y changes by a bounded amount, as |v_x| has a positive bound from below",
        );

        let [z, next, y, bound] = Expr::symbols(["Z", "Z′", "Y", "B"]);
        let (sum, difference) = (d + lambda0, d - lambda0);
        p.note(
            "So L′ (d − λ₀ − Z) ≤ (d + λ₀) L + B and L′ (d − λ₀ + Z) ≥ (d + λ₀) L − B",
            "L′ belongs to the next passage, B is some constant; L tends to infinity as v_y tends to 0, and Z to 0: L grows by a factor above 1 from some passage on",
        );
        p.note(
            "Y is exp(−L)",
            "so that the sums of Y and of L Y over all passages are finite, and with them that of Z, which shrinks by a factor below 1, but for Y",
        );
        let product = (z * (difference + z) + y) * (sum * before + bound);
        let terms = sum * difference * z * before * (one + z / difference)
            + bound * z * (difference + z)
            + y * (sum * before + bound);
        p.identity(
            (
                "The right sides of the inequalities for Z′ and L′, multiplied",
                product,
            ),
            (
                "where all terms but the first have a finite sum over all passages",
                terms,
            ),
        )?;
        let close = sum * difference * (one - next / sum) * (one - z / difference);
        p.identity(
            (
                "The factors of Z′ L′ on the left sides",
                (sum - next) * (difference - z),
            ),
            ("", close),
        )?;
        p.note(
            "So from one passage to the next Z L grows by a factor 1 + O(Z + Z′) at most, and by terms with a finite sum",
            "the product of all these factors is finite: Z L stays bounded, and with it Z M and e",
        );
        p.identity(
            ("The stated factor less 1", factor - one),
            ("which is positive", Expr::int(2) * lambda0 / difference),
        )?;
        p.note(
            "So L grows as the powers of the factor",
            "v_y falls as the exponential of an exponential",
        );
        Ok(())
    })
}

/// v_y is lost only where the particle sticks.
fn lost_at_rest(law: Rate) -> Proof {
    Proof::in_ring("Where the velocity across is lost", ring_of_motion(), |p| {
        p.rests_on(&turning(law))?;
        p.rests_on(&eq2_proof(eq2()))?;
        let [lambda0, phi] = Expr::symbols(["λ₀", "φ"]);
        let ([vx, _, v], one) = (velocity(), Expr::int(1));
        p.note(
            "ln v_y has the rate −λ₀/v",
            "while v > 0 it stays finite: v_y becomes 0 only where v does, and then all of it is lost",
        );
        let [along, _] = in_units(law, eq21());
        let terms = phi.sin() - lambda0 + lambda0 * (one - vx / v);
        p.identity(
            ("dv_x/dφ by (1) and (21)", along),
            ("sin φ − λ₀ and what is not negative", terms),
        )?;
        let [grows] = in_units([eq2()], eq21());
        let grows = p.read("dv/dφ by (2)", grows)?;
        let room = p.ring().read(one + lambda0)? + grows;
        let terms = p.read(
            "1 + sin φ v_x/v, which is not negative",
            one + phi.sin() * vx / v,
        )?;
        p.equal("1 + λ₀ and dv/dφ", &room, &terms)?;
        p.note(
            "If v became 0 where sin φ > λ₀",
            "v_x would rise to 0, so that T ≥ 1 before; v would be (1 + λ₀) times the phase that is left at most, so that sin φ/v, by which ln T falls, had no finite sum: T would come below 1. Where sin φ < −λ₀ the mirror image holds",
        );
        p.note(
            "So v becomes 0 only where |sin φ| ≤ λ₀",
            "there it sticks, or, exactly at φ₁ or φ₃, sets off along the line at once: v_y is 0 from then on",
        );
        Ok(())
    })
}

/// How long what is left of v_y lasts where friction exceeds the drive; `phase` is the stated bound.
fn last_stage(law: Rate, phase: Expr) -> Proof {
    Proof::in_ring("The last of the velocity across", ring_of_motion(), |p| {
        p.rests_on(&eq1_proof(law))?;
        let [lambda0, d, h] = Expr::symbols(["λ₀", "d", "h"]);
        let ([vx, vy, v], one) = (velocity(), Expr::int(1));
        p.note("Let |h| ≤ d < λ₀, h the drive", "while the particle slides");
        let [x, y] = in_units(law, [-h, Expr::int(0)]);
        let along = p.read("dv_x/dφ by (1)", x)?;
        let across = p.read("dv_y/dφ by (1)", y)?;
        let motion = p.ring().along(&[("v_x", along), ("v_y", across)])?;
        for (says, sign) in [("v_x ≥ 0", 1), ("v_x ≤ 0", -1)] {
            let sign = Expr::int(sign);
            p.note("Where", says);
            let left = (lambda0 * v + sign * d * vx) / (lambda0.squared() - d.squared());
            let left = p.read("(λ₀ v + d |v_x|)/(λ₀² − d²)", left)?;
            let rate = p.derivative("Its rate", &left, &motion)?;
            let room = (d - sign * h) * (d + lambda0 * sign * vx / v);
            let room = p.read(
                "(d − h) (d + λ₀ |v_x|/v)/(λ₀² − d²), with h along v_x, not negative",
                room / (lambda0.squared() - d.squared()),
            )?;
            let fall = -p.ring().read(one)? - rate;
            p.equal("By that it falls faster than the phase grows", &fall, &room)?;
            p.identity(
                (
                    "At v_x = 0, where v is v_y, it is",
                    (lambda0 * vy) / (lambda0.squared() - d.squared()),
                ),
                ("the stated phase", phase),
            )?;
            let ring = p.ring();
            let same = ring.put(&room, &[(&ring.named("h")?, &ring.read(sign * d)?)])?;
            p.zero(
                "With h = d all along, that is the phase exactly: the room",
                &same,
            )?;
        }
        p.note(
            "So by then the particle is at rest",
            "it is not negative, and 0 at rest only; there it stays as long as |h| ≤ λ₀",
        );
        p.note(
            "If |sin φ| is d where v_x = 0",
            "it is below any D > d for some phase, D < λ₀, and v_y, if small enough, is lost before, within the stated phase with D for d: that with d, to leading order",
        );
        Ok(())
    })
}

fn two_stages((law, slope, motion, passage, phase): (Rate, Expr, NoRest, Passage, Expr)) -> Proof {
    Proof::in_ring("The two stages, as corrected", ring_of_motion(), |p| {
        p.rests_on(&first_stage(law, slope))?;
        p.rests_on(&passages(law, motion, passage))?;
        p.rests_on(&lost_at_rest(law))?;
        p.rests_on(&last_stage(law, phase))?;
        given(p, &[&IGNORES_VY])?;
        p.note(
            "For λ₀ > λ_c",
            "the motion has become (33), or rests, after a finite time: v_y = 0",
        );
        p.vanishes(
            "At rest and in (33), which is along the line, v_y",
            paper::s22_late_vy(),
        )
    })
}

/// The two stages, as corrected.
const TWO_STAGES: Statement<(Rate, Expr, NoRest, Passage, Expr)> = Statement::new(
    Corrected,
    Compared::shown(
        r"for every $\lambda_0>0$ and $v_y>0$ the rate of $\mathfrak w_y$ is $-\lambda_0$ up to $\frac12\lambda_0(v_x/v_y)^2$; for every $0<\lambda_0<\lambda_\mathrm c$ and every motion whose speed never becomes 0 each passage, from some time on, multiplies $\ln v_y$ by $(d+\lambda_0)/(d-\lambda_0)$, $d=\sin\tilde\phi_1$, up to terms that stay bounded, and a particle whose speed becomes 0 loses all of $v_y$; for every $\lambda_0>\lambda_\mathrm c$ $v_y=0$ after a finite time, and with $v_x=0$ and $\lvert\sin\phi\rvert\le d<\lambda_0$ as long as it slides within a phase of $\lambda_0\mathfrak w_y/(\lambda_0^2-d^2)$",
    ),
    || {
        let [lambda0, d, vy] = Expr::symbols(["λ₀", "d", "v_y"]);
        (
            eq1(),
            paper::s22_first_stage_slope(lambda0),
            eq38(),
            passage_formulas(),
            corrected::last_stage(lambda0, d, vy),
        )
    },
    two_stages,
);

/// Below λ_c: by what factor the fall of ln v_y in a period grows in the limit.
fn ratio_of_falls(ratio: Expr, law: Rate, motion: NoRest, passage: Passage) -> Proof {
    Proof::in_ring(
        "The falls of the logarithm in two periods",
        ring_of_passage(),
        |p| {
            p.rests_on(&passages(law, motion, passage))?;
            let lambda0 = Expr::symbol("λ₀");
            let [d, factor, _] = passage;
            p.note(
            "Two passages in a period multiply ln v_y by the square of the factor, up to bounded terms",
            "so they do the fall in a period, which grows beyond all bounds: in the limit its ratio to the one before is that square",
        );
            let one = Expr::int(1);
            let found = p.read("The square", factor.squared())?;
            let excess = found.clone() - p.ring().read(one)?;
            let positive = Expr::int(4) * d * lambda0 / (d - lambda0).squared();
            let positive = p.read("4 d λ₀/(d − λ₀)², positive for every λ₀ > 0", positive)?;
            p.equal("It is above 1 by that", &excess, &positive)?;
            p.reads_as(&found, "the stated ratio", ratio)
        },
    )
}

/// The second stage as printed.
pub const EXPONENTIAL: Statement<(Expr, Rate, NoRest, Passage)> = Statement::new(
    Printed,
    Compared::one(
        "the stated 1",
        r"the limit of the fall of $\ln v_y$ in a period over that in the one before, for every $0<\lambda_0<\lambda_\mathrm c$ and every motion whose speed never becomes 0, periods being counted from any phase but those of its zeros in the limit",
    ),
    || {
        (
            paper::s22_second_stage_ratio(),
            eq1(),
            eq38(),
            passage_formulas(),
        )
    },
    |(ratio, law, motion, passage)| ratio_of_falls(ratio, law, motion, passage),
);

pub(super) const TRIALS: &[Attempt] = trials![&EXPONENTIAL, &TWO_STAGES];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_stages_are_as_corrected_and_the_second_is_no_exponential() {
        let proof = TWO_STAGES.proof();
        assert!(proof.holds(), "{proof}");
        let proof = EXPONENTIAL.proof();
        let refused = matches!(proof.obstacle(), Some(Obstacle::NotZero { says, .. }) if says == "The square");
        assert!(refused, "{proof}");
        let (_, law, motion, passage) = (EXPONENTIAL.formulas)();
        let square = passage[1].squared();
        assert!(ratio_of_falls(square, law, motion, passage).holds());
    }
}
