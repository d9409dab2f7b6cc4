//! How the velocity across the drive dies, as corrected: linearly while it is large; below λ_c by a factor of its logarithm where
//! v_x passes through zero; above λ_c to zero, after a finite time.
//!
//! With T = tan(θ/2) = v_y/(v + v_x) the motion keeps d ln v_y/dφ to λ₀/h times d ln T/dφ, h = sin φ. Beside a zero of v_x the drive
//! h is nearly d = sin φ̃₁, and ln T goes from −ln v_y to ln v_y, up to bounded terms. All is in units of A₀ and ϖ, with v_y > 0.

use super::attraction::{IGNORES_VY, TRICHOTOMY};
use super::chains::{VY_VANISHES, eq21, in_units};
use super::exact::{EQ40, eq38, prove_eq38, ring_of_phi_t1};
use super::prelude::*;
use crate::claims::general::two_frames::{eq1_proof, eq2_proof};
use crate::paper::sinusoidal as paper;

/// Of the velocity, by (1).
type Rate = [Expr; 2];
type NoRest = ([Expr; 2], [Expr; 3]);

/// Of a passage through zero: the size of the drive there, the factor of ln v_y, and that of a distance to (38) in a period.
type Passage = [Expr; 3];

fn passage_formulas() -> Passage {
    let lambda0 = symbol("λ₀");
    let d = corrected::drive_at_zero(lambda0);
    let factor = corrected::passage_factor(lambda0, d);
    [d, factor, corrected::contraction(lambda0)]
}

fn ring_of_motion() -> Result<Ring, ExactError> {
    let mut ring = Ring::new();
    let [_, _, _, vx, vy] = ring.symbols(["λ₀", "d", "h", "v_x", "v_y"]);
    ring.angle("φ");
    ring.root(&(vx.pow(2) + vy.pow(2)), 2)?;
    Ok(ring)
}

/// The ring in which sin φ̃₁ is the positive root of 1 − (πλ₀/2)².
fn ring_of_passage() -> Result<Ring, ExactError> {
    let mut ring = ring_of_phi_t1()?;
    let turn = symbol("φ̃₁");
    let [sine, cosine] = [ring.read(turn.sin())?, ring.read(turn.cos())?];
    ring.root_is(&(Rational::int(1) - &cosine * &cosine), 2, &sine)?;
    Ok(ring)
}

fn velocity() -> [Expr; 3] {
    let [vx, vy] = symbols(["v_x", "v_y"]);
    [vx, vy, (vx.squared() + vy.squared()).sqrt()]
}

fn first_stage(law: Rate, slope: Expr) -> Proof {
    Proof::in_ring(
        "A large velocity across falls linearly",
        ring_of_motion(),
        |p| {
            p.shows("By (1) and (21), with v_y > 0: dv_y/dφ exceeds −λ₀ by λ₀ (v_x/v_y)²/2 at most, and is not below it. Velocities are in units of A₀/ϖ.");
            p.rests_on(&eq1_proof(law))?;
            let lambda0 = symbol("λ₀");
            let ([vx, vy, v], two) = (velocity(), int(2));
            let [_, across] = in_units(law, eq21());
            let excess = lambda0 * vx.squared() / (v * (v + vy));
            p.identity(
                (
                    "dv_y/dφ by (1) and (21), less the stated slope",
                    across - slope,
                ),
                ("which is not negative", excess),
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
            Ok(())
        },
    )
}

fn turning(law: Rate) -> Proof {
    Proof::in_ring(
        "How v_y and the direction of the velocity change together",
        ring_of_motion(),
        |p| {
            p.shows("By (1) and (21), with v_y > 0 and T = v_y/(v + v_x): ln v_y has the rate −λ₀/v, and ln T the rate −sin φ/v. The motion with v_x reversed, half a period later, has the same law. Velocities are in units of A₀/ϖ.");
            p.rests_on(&eq1_proof(law))?;
            let [lambda0, d, phi] = symbols(["λ₀", "d", "φ"]);
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
                "T, the tangent of half the angle of the velocity with the x axis",
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
                "It is the rate of ln v_y less λ₀/d times that of ln T, with any d > 0",
                &apart,
                &drift,
            )?;
            p.identity(
                ("T v_y", vy / (v + vx) * vy),
                ("which is v + |v_x| where v_x < 0", v - vx),
            )?;
            // The other zero is the mirror image.
            let pi = pi();
            for (says, rate, sign) in [("dv_x/dφ", rates[0], -1), ("dv_y/dφ", rates[1], 1)] {
                let mirrored = rate.with("v_x", -vx).with("φ", phi + pi);
                p.identity(
                    (
                        &format!("{says} half a period later with v_x reversed"),
                        mirrored,
                    ),
                    (
                        "that before, with the sign of a mirror image",
                        int(sign) * rate,
                    ),
                )?;
            }
            Ok(())
        },
    )
}

fn near_zero([d, ..]: Passage) -> Proof {
    let title = "The drive beside a zero of (38)";
    Proof::in_ring(title, ring_of_passage(), |p| {
        p.shows("For λ₀ < λ_c let d = sin φ̃₁, which exceeds λ₀, and m = (d − λ₀)/2. Where |φ − φ̃₁| ≤ m: sin φ ≥ λ₀ + m, and |v_x| is at least m times the distance of φ from a zero of v_x there.");
        rest_on(p, &[&EQ40])?;
        let [lambda0, turn, phi] = symbols(["λ₀", "φ̃₁", "φ"]);
        p.identity(
            ("The stated size d of the drive at a zero", d),
            ("", paper::eq39_phi_t1::tree().sin()),
        )?;
        let halves = 2 * ((phi - turn) / 2).sin() * ((phi + turn) / 2).cos();
        p.identity(
            ("sin φ − d", phi.sin() - d),
            ("of the size |φ − φ̃₁| at most", halves),
        )?;
        let margin = (d - lambda0) / 2;
        p.identity(
            ("With m = (d − λ₀)/2: d − m", d - margin),
            ("", lambda0 + margin),
        )?;
        Ok(())
    })
}

fn zeros_settle(law: Rate, (cases, ends): NoRest, passage: Passage) -> Proof {
    let ring = || -> Result<Ring, ExactError> {
        let mut ring = ring_of_passage()?;
        let [vx, vy] = ring.symbols(["v_x", "v_y"]);
        ring.angle("Z");
        ring.root(&(vx.pow(2) + vy.pow(2)), 2)?;
        Ok(ring)
    };
    Proof::in_ring("The zeros of v_x approach those of (38)", ring(), |p| {
        p.shows("For 0 < λ₀ < λ_c and v_y > 0, d = sin φ̃₁: late zeros of v_x, first at the distance Z, next Z′, from those of (38), obey Z′ (d + λ₀ − Z′) ≤ Z (d − λ₀ + Z) + Y, with Y for v_y at the phase (d − λ₀)/2 before the first.");
        p.rests_on(&turning(law))?;
        p.rests_on(&prove_eq38(cases, ends))?;
        rest_on(p, &[&TRICHOTOMY])?;
        p.rests_on(&near_zero(passage))?;
        let [lambda0, phi, turn, z] = symbols(["λ₀", "φ", "φ̃₁", "Z"]);
        let [vx, vy, v] = velocity();
        let [along, _] = in_units(law, eq21());
        let along = p.read("dv_x/dφ by (1) and (21)", along)?;
        for (says, sign) in [("v_x > 0", 1), ("v_x < 0", -1)] {
            let sign = int(sign);
            let lack = 1 - sign * vx / v;
            let terms = phi.sin() - sign * lambda0 + sign * lambda0 * lack;
            p.reads_as(
                &along,
                &format!("where {says}: the slope on the line, and λ₀ (1 − |v_x|/v) with a sign"),
                terms,
            )?;
            p.identity(
                (
                    "(v_y + |v_x|)² less v²",
                    (vy + sign * vx).squared() - v.squared(),
                ),
                ("not negative", 2 * vy * sign * vx),
            )?;
        }

        let [forward, backward] = cases;
        let pi = pi();
        let rise = turn.cos() - (turn + z).cos();
        p.identity(
            ("(38) at φ̃₁ + Z", forward.with("φ", turn + z)),
            (
                "the integral of the drive from φ̃₁ to there, less λ₀Z",
                rise - lambda0 * z,
            ),
        )?;
        let before = backward.with("φ", turn + 2 * pi - z);
        let rise = (turn - z).cos() - turn.cos();
        p.identity(
            ("(38) at φ̃₁ − Z, a period later", before),
            (
                "the negative integral of the drive from there to φ̃₁, less λ₀Z",
                -rise - lambda0 * z,
            ),
        )?;
        p.note(
            "Let v_x, on the line, have its zero Z later or earlier than (38)",
            "before both zeros the two differ by the integral of the drive from one to the other and λ₀ Z, after both by this integral less λ₀ Z. It is Z times a mean of sin φ, and so d Z up to Z² at most",
        );
        let [d, factor, contraction] = passage;
        let ratio = (d - lambda0) / (d + lambda0);
        p.identity(
            ("The square of (d − λ₀)/(d + λ₀)", ratio.squared()),
            ("the stated contraction in a period", contraction),
        )?;
        p.identity(
            (
                "The stated factor of ln v_y times (d − λ₀)/(d + λ₀)",
                factor * ratio,
            ),
            ("", int(1)),
        )
    })
}

fn passages(law: Rate, motion: NoRest, passage: Passage) -> Proof {
    let ring = || -> Result<Ring, ExactError> {
        let mut ring = ring_of_passage()?;
        ring.symbols(["L", "b", "e", "Z", "Z′", "Y", "B"]);
        Ok(ring)
    };
    let title = "A passage of v_x through zero multiplies ln v_y";
    Proof::in_ring(title, ring(), |p| {
        p.shows("For 0 < λ₀ < λ_c and v_y > 0: a late passage of v_x through zero multiplies ln v_y by F = (d + λ₀)/(d − λ₀), which exceeds 1, up to terms that stay bounded; d = sin φ̃₁.");
        p.rests_on(&turning(law))?;
        p.rests_on(&zeros_settle(law, motion, passage))?;
        rest_on(p, &[&VY_VANISHES])?;
        p.rests_on(&near_zero(passage))?;
        let [lambda0, before, b, e] = symbols(["λ₀", "L", "b", "e"]);
        let [d, factor, _] = passage;
        p.note(
            "Let −ln v_y be L at the phase m before φ̃₁, and M at the phase m after",
            "as |v_x| has positive bounds at both, ln T is L at the one and −M at the other, up to bounded terms: it changes by b − L − M, with a bounded b",
        );
        p.note(
            "Let e/d be the integral of λ₀ (sin φ − d)/(d v) between the two, and r the distance from the zero of v_x",
            "|sin φ − d| ≤ r + Z, |v_x| ≥ m r, and the integral of λ₀/v is M − L: so |e| ≤ 2λ₀ + Z (M − L)",
        );
        let after = factor * before - (lambda0 * b + e) / (d - lambda0);
        let left = before - after;
        let right = lambda0 / d * (b - before - after) + e / d;
        p.identity(("L − M with it", left), ("the right side", right))?;

        let [z, next, y, bound] = symbols(["Z", "Z′", "Y", "B"]);
        let (sum, difference) = (d + lambda0, d - lambda0);
        let product = (z * (difference + z) + y) * (sum * before + bound);
        let terms = sum * difference * z * before * (1 + z / difference)
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
        let close = sum * difference * (1 - next / sum) * (1 - z / difference);
        p.identity(
            (
                "The factors of Z′ L′ on the left sides",
                (sum - next) * (difference - z),
            ),
            ("", close),
        )?;
        p.identity(
            ("The stated factor less 1", factor - 1),
            ("which is positive", 2 * lambda0 / difference),
        )?;
        Ok(())
    })
}

fn lost_at_rest(law: Rate) -> Proof {
    let title = "v_y becomes 0 only where the particle stops";
    Proof::in_ring(title, ring_of_motion(), |p| {
        p.shows("By (1) and (21), v_y > 0 becomes 0 only where the particle stops, v = 0, at a phase with |sin φ| ≤ λ₀; from then on v_y = 0.");
        p.rests_on(&turning(law))?;
        p.rests_on(&eq2_proof(eq2()))?;
        let [lambda0, phi] = symbols(["λ₀", "φ"]);
        let ([vx, _, v], one) = (velocity(), int(1));
        let [along, _] = in_units(law, eq21());
        let terms = phi.sin() - lambda0 + lambda0 * (one - vx / v);
        p.identity(
            ("dv_x/dφ by (1) and (21)", along),
            ("sin φ − λ₀ and what is not negative", terms),
        )?;
        let [grows] = in_units([eq2()], eq21());
        p.identity(
            ("1 + λ₀ plus dv/dφ by (2)", one + lambda0 + grows),
            ("which is not negative", one + phi.sin() * vx / v),
        )?;
        Ok(())
    })
}

fn last_stage(law: Rate, phase: Expr) -> Proof {
    let title = "Where friction exceeds the drive, v_y vanishes within the stated phase";
    Proof::in_ring(title, ring_of_motion(), |p| {
        p.shows("By (1), under a drive h along x with |h| ≤ d < λ₀: a particle with v_x = 0 comes to rest within the phase λ₀ v_y/(λ₀² − d²), any other within (λ₀ v + d |v_x|)/(λ₀² − d²).");
        p.rests_on(&eq1_proof(law))?;
        let [lambda0, d, h] = symbols(["λ₀", "d", "h"]);
        let ([vx, vy, v], one) = (velocity(), int(1));
        p.note(
            "Let h be the drive, and |h| ≤ d < λ₀",
            "as long as the particle slides",
        );
        let [x, y] = in_units(law, [-h, int(0)]);
        let along = p.read("dv_x/dφ by (1)", x)?;
        let across = p.read("dv_y/dφ by (1)", y)?;
        let motion = p.ring().along(&[("v_x", along), ("v_y", across)])?;
        for (says, sign) in [("v_x ≥ 0", 1), ("v_x ≤ 0", -1)] {
            let sign = int(sign);
            p.note("The case", says);
            let left = (lambda0 * v + sign * d * vx) / (lambda0.squared() - d.squared());
            let left = p.read("X = (λ₀ v + d |v_x|)/(λ₀² − d²)", left)?;
            let rate = p.derivative("Its rate", &left, &motion)?;
            let room = (d - sign * h) * (d + lambda0 * sign * vx / v);
            let room = room / (lambda0.squared() - d.squared());
            p.reads_as(&rate, "at most −1", -one - room)?;
            p.vanishes(
                "If h is d along v_x, it is −1: what it has beside −1",
                room.with("h", sign * d),
            )?;
            p.identity(
                (
                    "At v_x = 0, where v is v_y, X is",
                    (lambda0 * vy) / (lambda0.squared() - d.squared()),
                ),
                ("the stated phase", phase),
            )?;
        }
        Ok(())
    })
}

fn two_stages((law, slope, motion, passage, phase): (Rate, Expr, NoRest, Passage, Expr)) -> Proof {
    Proof::in_ring("The two stages, as corrected", ring_of_motion(), |p| {
        p.rests_on(&first_stage(law, slope))?;
        p.rests_on(&passages(law, motion, passage))?;
        p.rests_on(&lost_at_rest(law))?;
        p.rests_on(&last_stage(law, phase))?;
        rest_on(p, &[&IGNORES_VY])?;
        p.vanishes(
            "At rest and in (33), which is along the line, v_y",
            paper::s22_late_vy(),
        )
    })
}

const TWO_STAGES: Statement<(Rate, Expr, NoRest, Passage, Expr)> = Statement::shown(
    Corrected,
    r"for every $\lambda_0>0$ and $v_y>0$ the rate of $\mathfrak w_y$ is $-\lambda_0$ up to $\frac12\lambda_0(v_x/v_y)^2$; for every $0<\lambda_0<\lambda_\mathrm c$ and every motion whose speed never becomes 0 each passage, from some time on, multiplies $\ln v_y$ by $(d+\lambda_0)/(d-\lambda_0)$, $d=\sin\tilde\phi_1$, up to terms that stay bounded, and a particle whose speed becomes 0 loses all of $v_y$; for every $\lambda_0>\lambda_\mathrm c$ $v_y=0$ after a finite time, and with $v_x=0$ and $\lvert\sin\phi\rvert\le d<\lambda_0$ as long as it slides within a phase of $\lambda_0\mathfrak w_y/(\lambda_0^2-d^2)$",
    || {
        let [lambda0, d, vy] = symbols(["λ₀", "d", "v_y"]);
        (
            eq1(),
            paper::s22_first_stage_slope::tree(),
            eq38(),
            passage_formulas(),
            corrected::last_stage(lambda0, d, vy),
        )
    },
    two_stages,
);

fn ratio_of_falls(ratio: Expr, law: Rate, motion: NoRest, passage: Passage) -> Proof {
    Proof::in_ring(
        "The falls of the logarithm in two periods",
        ring_of_passage(),
        |p| {
            p.rests_on(&passages(law, motion, passage))?;
            let lambda0 = symbol("λ₀");
            let [d, factor, _] = passage;
            let found = p.read("The square", factor.squared())?;
            let excess = found.clone() - p.ring().read(int(1))?;
            let positive = 4 * d * lambda0 / (d - lambda0).squared();
            let positive = p.read("4 d λ₀/(d − λ₀)², positive for every λ₀ > 0", positive)?;
            p.equal("It is above 1 by that", &excess, &positive)?;
            p.reads_as(&found, "the stated ratio", ratio)
        },
    )
}

pub(crate) const EXPONENTIAL: Statement<(Expr, Rate, NoRest, Passage)> = Statement::new(
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

attempts![&EXPONENTIAL, &TWO_STAGES];

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
