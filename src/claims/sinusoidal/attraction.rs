//! Every motion under the sine, with any velocity across it, is drawn to one and the same: to (38) for 0 < λ₀ ≤ λ_c, to (33) for
//! λ_c < λ₀ < 1, to rest for λ₀ ≥ 1.
//!
//! Two motions under one drive come no farther apart. Where the one passes through zero, or rests, they come closer by at least an
//! amount that depends on their distance alone, once in each period; so the distance goes to zero. All is in units of A₀ and ϖ.

use super::chains::{VX_STAYS, WEAK_DRIVE_STOPS, eq21, in_units};
use super::exact::{
    EQ33, EQ34, EQ35, EQ36, EQ40, eq33, eq38, prove_eq38, ring_of_phi_t1, ring_of_phi1,
};
use super::phase_order::slip;
use super::prelude::*;
use crate::claims::general::contraction::never_farther_apart;
use crate::claims::general::two_frames::eq2_proof;

type NoRest = ([Expr; 2], [Expr; 3]);

fn passes((cases, ends): NoRest) -> Proof {
    Proof::in_ring("(38) passes through zero twice", ring_of_phi_t1(), |p| {
        p.shows("For 0 < λ₀ ≤ λ_c: (38) is positive from φ̃₁ to φ̃₁ + π and negative in the half period after that; at the two zeros it does not rest.");
        p.rests_on(&prove_eq38(cases, ends))?;
        rest_on(p, &[&EQ40])?;
        let [phi, pi] = [symbol("φ"), pi()];
        let [forward, backward] = cases;
        let w = p.read("The forward case", forward)?;
        let by = p.ring().by("φ")?;
        let slope = p.derivative("Its slope", &w, &by)?;
        let bend = p.derivative("Its second derivative", &slope, &by)?;
        p.reads_as(&bend, "", phi.cos())?;
        let later = p.read(
            "The backward case, half a period later",
            backward.with("φ", phi + pi),
        )?;
        p.equal("It is the negative", &later, &-&w)?;
        Ok(())
    })
}

fn drawn_to_no_rest(law: [Expr; 2], motion: NoRest) -> Proof {
    let ring = || -> Result<Ring, ExactError> {
        let mut ring = Ring::new();
        let [_, _, _, vx, vy] = ring.symbols(["λ₀", "W", "D", "v_x", "v_y"]);
        ring.angle("φ");
        ring.root(&(vx.pow(2) + vy.pow(2)), 2)?;
        Ok(ring)
    };
    Proof::in_ring("Every motion is drawn to (38)", ring(), |p| {
        p.shows("For 0 < λ₀ ≤ λ_c and any start: D, the distance of the velocity from (38), tends to 0. In each period D² falls by the smaller of λ₀ D²/(4 (1 + λ₀)) and πλ₀ D at least, with D at φ̃₁.");
        p.rests_on(&never_farther_apart())?;
        p.rests_on(&passes(motion))?;
        p.rests_on(&eq2_proof(eq2()))?;
        let [lambda0, other, d, vx, vy, phi] = symbols(["λ₀", "W", "D", "v_x", "v_y", "φ"]);
        let speed = (vx.squared() + vy.squared()).sqrt();
        let cosine = vx / speed;
        p.note(
            "Let v be the speed of any motion, W that of (38), D the distance of their velocities, and γ the angle between them",
            "the rate of D² is −2λ₀ (v + W) (1 − cos γ)",
        );
        for (says, way, sign, bound) in [
            ("before", "backward", 1, "at least v + v_x"),
            ("after", "forward", -1, "at least v − v_x"),
        ] {
            let sign = int(sign);
            p.note(
                &format!("In the half period {says} φ̃₁"),
                format!("(38) goes {way}"),
            );
            let pull = (speed + other) * (1 + sign * cosine);
            let (least, more) = (speed + sign * vx, other * (1 + sign * cosine));
            p.identity(("(v + W) (1 − cos γ)", pull), (bound, least + more))?;
        }

        let drive = eq21();
        let [rate, _] = in_units(law, drive);
        let most = 1 + lambda0;
        let along = p.read("dv_x/dφ by (1)", rate)?;
        let [grows] = in_units([eq2()], drive);
        let grows = p.read("dv/dφ by (2)", grows)?;
        let sine = phi.sin();
        for (says, rate, sign, room) in [
            (
                "1 + λ₀ less dv_x/dφ",
                &along,
                -1,
                1 - sine + lambda0 * (1 + cosine),
            ),
            (
                "1 + λ₀ plus dv_x/dφ",
                &along,
                1,
                1 + sine + lambda0 * (1 - cosine),
            ),
            (
                "1 + λ₀ less dv/dφ",
                &grows,
                -1,
                1 - sine * cosine + 2 * lambda0,
            ),
            ("1 + λ₀ plus dv/dφ", &grows, 1, 1 + sine * cosine),
        ] {
            let left = p.ring().read(most)? + &Rational::int(sign) * rate;
            let room = p.read("Terms of which none is negative", room)?;
            p.equal(says, &left, &room)?;
        }

        let length = d / (4 * most);
        p.identity(
            (
                "D less that rate times the phase D/(4 (1 + λ₀))",
                d - 2 * most * length,
            ),
            ("", d / 2),
        )?;
        p.identity(
            (
                "Meanwhile the squared distance falls, at the rate 2λ₀ (D/2) at least, by",
                2 * lambda0 * (d / 2) * length,
            ),
            ("", lambda0 * d.squared() / (4 * most)),
        )?;
        Ok(())
    })
}

/// For λ_c < λ₀ < 1: a motion has become (33) after some rests of (33).
fn drawn_to_rests(law: Expr, cases: [Expr; 4]) -> Proof {
    let ring = || -> Result<Ring, ExactError> {
        let mut ring = ring_of_phi1()?;
        ring.angle("x");
        let [vx, vy] = ring.symbols(["v_x", "v_y"]);
        ring.root(&(vx.pow(2) + vy.pow(2)), 2)?;
        Ok(ring)
    };
    Proof::in_ring("Every motion becomes (33)", ring(), |p| {
        p.rests_on(&never_farther_apart())?;
        p.rests_on(&(EQ33.prove)(cases))?;
        p.rests_on(&eq2_proof(law))?;
        p.rests_on(&slip())?;
        rest_on(p, &[&EQ34, &EQ35, &EQ36])?;
        let [beta, lambda0, vx, vy, phi] = symbols(["β", "λ₀", "v_x", "v_y", "φ"]);
        let pi = pi();
        let x = symbol("x");
        let excess = (pi + beta - x).sin().squared() - lambda0.squared();
        let product = -(x.sin() * (2 * beta - x).sin());
        p.identity(
            ("sin²φ − λ₀² at φ = π + β − x", excess),
            ("negative for 0 < x < 2β", product),
        )?;
        let speed = (vx.squared() + vy.squared()).sqrt();
        let drive = eq21();
        let [rate] = in_units([law], drive);
        let rate = p.read(
            "While (33) rests, the distance of a motion from it is v, with the rate by (2)",
            rate,
        )?;
        let along = p.read("sin φ v_x/v", phi.sin() * vx / speed)?;
        let friction = p.ring().read(lambda0)?;
        p.equal("The rate is that less λ₀", &rate, &(&along - &friction))?;
        p.identity(
            (
                "sin²φ less its square",
                phi.sin().squared() - (phi.sin() * vx / speed).squared(),
            ),
            ("a square", (phi.sin() * vy / speed).squared()),
        )?;
        Ok(())
    })
}

fn empty() -> Result<Ring, ExactError> {
    let mut ring = Ring::new();
    ring.angle("φ");
    ring.symbols(["v_x", "v_y", "λ₀"]);
    let [vx, vy] = symbols(["v_x", "v_y"]);
    let square = ring.read(vx.squared() + vy.squared())?;
    ring.root(&square, 2)?;
    Ok(ring)
}

fn no_rest_below((law, motion): ([Expr; 2], NoRest)) -> Proof {
    Proof::in_ring("No periodic motion rests below λ_c", empty(), |p| {
        p.rests_on(&drawn_to_no_rest(law, motion))?;
        p.note(
            "Let a motion have the period P; its distance from (38) goes to 0",
            "so does the change of (38) over P, which has the period 2π and so is 0: P is a period of (38), too. So the distance returns after P, and is 0: the motion is (38), which rests on no interval",
        );
        let [phi, zero] = [symbol("φ"), int(0)];
        let [rate, _] = in_units(law, eq21());
        p.identity(
            ("Without friction, dv_x/dφ by (1)", rate.with("λ₀", zero)),
            ("", phi.sin()),
        )?;
        Ok(())
    })
}

pub(crate) const TRICHOTOMY: Statement<([Expr; 2], NoRest, [Expr; 4])> = Statement::shown(
    Within,
    r"from every start, with any $v_y$: for every $0<\lambda_0<\lambda_\mathrm c$ the motion tends to (38), and beside its two zeros in a period, where $\mathrm dv_x/\mathrm d\phi$ has a sign by (1), $v_x$ has one zero each; for every $\lambda_\mathrm c<\lambda_0<1$ it has become (33), with two intervals of rest, after a finite time; for every $\lambda_0>1$ it rests after a finite time for ever",
    || (eq1(), eq38(), eq33()),
    trichotomy,
);

fn trichotomy((law, no_rest, rests): ([Expr; 2], NoRest, [Expr; 4])) -> Proof {
    Proof::in_ring("Small, large and very large friction", empty(), |p| {
        p.rests_on(&drawn_to_no_rest(law, no_rest))?;
        p.rests_on(&drawn_to_rests(eq2(), rests))?;
        rest_on(p, &[&WEAK_DRIVE_STOPS, &VX_STAYS, &EQ36, &EQ40])?;
        let [lambda0, vx, vy, phi] = symbols(["λ₀", "v_x", "v_y", "φ"]);
        let cosine = vx / (vx.squared() + vy.squared()).sqrt();
        let [rate, _] = in_units(law, eq21());
        let rate = p.read("For λ₀ < λ_c: dv_x/dφ by (1)", rate)?;
        for (says, size, more) in [
            (
                "sin φ − λ₀, which is positive beside φ̃₁, and what is not negative",
                phi.sin() - lambda0,
                lambda0 * (1 - cosine),
            ),
            (
                "sin φ + λ₀, which is negative beside φ̃₁ + π, less what is not negative",
                phi.sin() + lambda0,
                -(lambda0 * (1 + cosine)),
            ),
        ] {
            p.reads_as(&rate, says, size + more)?;
        }
        Ok(())
    })
}

pub(crate) const IGNORES_VY: Statement<([Expr; 2], NoRest, [Expr; 4])> = Statement::shown(
    Within,
    r"for every $\lambda_0>0$ all motions, with any $v_y$ at the start, tend to one and the same: to (38) for $\lambda_0\le\lambda_\mathrm c$, to (33) for $\lambda_\mathrm c<\lambda_0<1$, to rest for $\lambda_0\ge1$, both of which they become after a finite time; but at the same $v_x\ne0$ another $\lvert v_y\rvert$ gives another $\mathrm dv_x/\mathrm d\phi$ by (1)",
    || (eq1(), eq38(), eq33()),
    ignores_vy,
);

fn ignores_vy((law, no_rest, rests): ([Expr; 2], NoRest, [Expr; 4])) -> Proof {
    Proof::in_ring("The start across the drive is forgotten", empty(), |p| {
        p.rests_on(&drawn_to_no_rest(law, no_rest))?;
        p.rests_on(&drawn_to_rests(eq2(), rests))?;
        let [lambda0, vx, vy, phi] = symbols(["λ₀", "v_x", "v_y", "φ"]);
        let speed = (vx.squared() + vy.squared()).sqrt();
        let drive = eq21();
        let [growth] = in_units([eq2()], drive);
        p.identity(
            ("For λ₀ ≥ 1, dv/dφ by (2)", growth),
            ("at most |sin φ| − λ₀", phi.sin() * vx / speed - lambda0),
        )?;
        let whole = -phi.cos() - lambda0 * phi;
        let gain = whole.with("φ", pi()) - whole.with("φ", int(0));
        p.identity(
            (
                "So in half a period v grows by −cos φ − λ₀φ from 0 to π at most",
                gain,
            ),
            ("at most 2 − π", 2 - pi() * lambda0),
        )?;

        let [rate, _] = in_units(law, drive);
        let rate = p.read("On the way: dv_x/dφ by (1)", rate)?;
        let slope = p.slope("Its slope by v_y", &rate, "v_y")?;
        let stated = lambda0 * vx * vy / speed.pow(int(3));
        p.reads_as(&slope, "not 0 but where v_x or v_y is", stated)?;
        Ok(())
    })
}

attempts![
    &IGNORES_VY,
    &REST_INTERVAL = Statement::shown(
        Printed,
        r"for every $\lambda_0$ with $\tilde\phi_2<\phi_3$: the velocities of two motions under one drive never move apart, while (33) rests the speed of any other motion falls by $\lambda_0-\lvert\sin\phi\rvert>0$ at least, and so from every start, with any $v_y$, the distance from (33) is 0 after a finite number of its rests",
        || (eq2(), eq33()),
        |(law, cases)| drawn_to_rests(law, cases)
    ),
    &NO_REST_BELOW = Statement::shown(
        Printed,
        r"for every $0<\lambda_0<\lambda_\mathrm c$: the velocities of two motions under one drive never move apart, and in each period the distance $D$ of any motion from (38) shrinks by at least an amount that depends on $D$ and $\lambda_0$ alone, to 0: a periodic motion, whose distance from (38) returns, is (38), which is zero at $\tilde\phi_1$ and half a period later only; and for $\lambda_0=0$ nothing holds a particle at rest while $\sin\phi\ne0$",
        || (eq1(), eq38()),
        no_rest_below
    ),
    &TRICHOTOMY
];
