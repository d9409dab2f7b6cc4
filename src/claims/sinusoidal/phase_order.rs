//! What of section 2.2 is an order of phases, for the whole range of λ₀ at once. All by φ₁ = β, λ₀ = sin β.

use super::exact::{EQ31, EQ32, EQ36, ring_of_phi1, with_lambda_c};
use super::prelude::*;
use crate::paper::sinusoidal as paper;

/// (27) to (30).
fn phases() -> [Expr; 4] {
    let lambda0 = symbol("λ₀");
    [
        paper::eq27_phi1(lambda0),
        paper::eq28_phi2(lambda0),
        paper::eq29_phi3(lambda0),
        paper::eq30_phi4(lambda0),
    ]
}

fn four_points(phases: [Expr; 4], number: Expr) -> Proof {
    Proof::in_ring(
        "The drive equals friction four times",
        ring_of_phi1(),
        |p| {
            let [beta, lambda0, phi] = symbols(["β", "λ₀", "φ"]);
            let pi = pi();
            let product = (phi - beta).sin() * (phi + beta).sin();
            p.identity(
                ("sin²φ − λ₀²", phi.sin().squared() - lambda0.squared()),
                ("", product),
            )?;
            let zeros = [beta, pi - beta, pi + beta, 2 * pi - beta];
            for (i, (printed, zero)) in phases.into_iter().zip(zeros).enumerate() {
                p.identity(
                    (&format!("The printed phase {}", i + 1), printed),
                    ("the zero of a sine", zero),
                )?;
            }
            for (says, earlier, later) in [
                (
                    "From the first to the second, and from the third to the fourth",
                    0,
                    1,
                ),
                ("The same", 2, 3),
            ] {
                p.identity(
                    (says, zeros[later] - zeros[earlier]),
                    ("positive for β < π/2", pi - 2 * beta),
                )?;
            }
            p.identity(
                ("From the second to the third", zeros[2] - zeros[1]),
                ("positive for β > 0", 2 * beta),
            )?;
            p.identity(
                ("The stated number", number),
                ("two zeros of each sine, none in common", int(2) + 2),
            )
        },
    )
}

fn rest_ends(phases: [Expr; 4]) -> Proof {
    Proof::in_ring("Where a rest can end", ring_of_phi1(), |p| {
        p.rests_on(&four_points(phases, int(4)))?;
        let [beta, phi] = symbols(["β", "φ"]);
        let drive = p.read("sin²φ", phi.sin().squared())?;
        let slope = p.slope("Its slope", &drive, "φ")?;
        let stated = 2 * phi.sin() * phi.cos();
        p.reads_as(&slope, "", stated)?;
        let steep = p.read(
            "2 sin β cos β, positive for 0 < β < π/2",
            stated.with("φ", beta),
        )?;
        for (i, (phase, way)) in phases.into_iter().zip([1, -1, 1, -1]).enumerate() {
            let there = p.read(
                &format!("At the printed phase {}", i + 1),
                stated.with("φ", phase),
            )?;
            let signed = &steep * &Rational::int(way);
            p.equal(&format!("It is {way} times that"), &there, &signed)?;
        }
        Ok(())
    })
}

fn period_ends(end: Expr) -> Proof {
    let title = "The period of the slip ends where the next slip begins";
    Proof::in_ring(title, ring_of_phi1(), |p| {
        let [first, second, third, fourth] = phases();
        p.rests_on(&four_points([first, second, third, fourth], int(4)))?;
        p.rests_on(&slip())?;
        let [beta, lambda0] = symbols(["β", "λ₀"]);
        for (says, phase) in [("φ₁", first), ("the stated end", end)] {
            p.identity(
                (&format!("The drive, sin φ, at {says}"), phase.sin()),
                ("", lambda0),
            )?;
            p.identity(
                ("Its slope there", phase.cos()),
                ("positive for 0 < β < π/2", beta.cos()),
            )?;
        }
        p.identity(
            ("The slope at φ₂", second.cos()),
            ("so that the drive falls there", -beta.cos()),
        )?;
        for (says, phase) in [("φ₃", third), ("φ₄", fourth)] {
            p.identity(
                (&format!("The drive at {says}"), phase.sin()),
                ("so that it is backward there", -lambda0),
            )?;
        }
        p.identity(
            ("From φ₁ to the stated end", end - first),
            ("so that it is the next such phase", 2 * pi()),
        )?;
        p.vanishes("What the drive gives on the way", first.cos() - end.cos())
    })
}

pub(crate) fn slip() -> Proof {
    let [lambda0, phi] = symbols(["λ₀", "φ"]);
    ends_once(paper::eq31_w(lambda0, paper::eq27_phi1::tree(), phi))
}

fn ends_once(w: Expr) -> Proof {
    Proof::in_ring("A slip from rest ends once", ring_of_phi1(), |p| {
        p.shows("For 0 < λ₀ < 1 and sin β = λ₀, 0 < β < π/2: (31) is positive from β up to one phase between π − β and 2π − β, and negative from there to 2π + β.");
        rest_on(p, &[&EQ31])?;
        let [beta, lambda0, phi] = symbols(["β", "λ₀", "φ"]);
        let printed = p.read("(31), with sin β = λ₀", w)?;
        let slope = p.slope("Its slope", &printed, "φ")?;
        let halves = ((phi - beta) / 2).sin() * ((phi + beta) / 2).cos();
        p.reads_as(
            &slope,
            "positive from β to π − β, negative from there to 2π + β",
            2 * halves,
        )?;
        p.identity(
            ("(31) at 2π − β", w.with("φ", 2 * pi() - beta)),
            ("negative", -(2 * lambda0 * (pi() - beta))),
        )?;
        Ok(())
    })
}

fn outlasts((w, left): (Expr, Expr)) -> Proof {
    let ring = || {
        let mut ring = with_lambda_c(ring_of_phi1()?)?;
        ring.angle("φ̃₂");
        Ok(ring)
    };
    Proof::in_ring("A slip outlasts half the period", ring(), |p| {
        rest_on(p, &[&EQ32, &EQ36])?;
        p.rests_on(&ends_once(w))?;
        let [beta, lambda0, phi, end] = symbols(["β", "λ₀", "φ", "φ̃₂"]);
        let (two, pi) = (int(2), pi());
        let there = p.read("(31) at β + π", w.with("φ", beta + pi))?;
        p.reads_as(&there, "the left side of (35)", paper::eq35_left::tree())?;
        let [friction, critical] = paper::eq36_sides::tree();
        let sum = p.read("Its terms, added", two * beta.cos() + pi * lambda0)?;
        let factor = 4 + pi.squared();
        let apart = factor * (critical.squared() - friction.squared());
        let apart = p.read(
            "(4 + π²) (λ_c² − λ₀²), positive where (36) does not hold",
            apart,
        )?;
        p.equal(
            "It is that times their sum, which is positive",
            &(&there * &sum),
            &apart,
        )?;

        let most = lambda0 * (phi - end) + end.cos() - phi.cos();
        let rate = p.read("From 0 at φ̃₂ that gives at most", most)?;
        let rate = p.slope("Its slope", &rate, "φ")?;
        p.reads_as(&rate, "", phi.sin() + lambda0)?;
        p.vanishes("At φ̃₂", most.with("φ", end))?;
        let later = p.read("At β + 2π", most.with("φ", beta + two * pi))?;
        let left = p.read("The left side of (32), which is 0,", left)?;
        let stated = p.read(
            "−2λ₀ (φ̃₂ − β − π), which is negative",
            -(two * lambda0 * (end - beta - pi)),
        )?;
        p.equal(
            "The value there is that less the left side",
            &later,
            &(&stated - &left),
        )
    })
}

attempts![
    &FOUR_POINTS = Statement::shown(
        Within,
        r"for every $0<\lambda_0<1$: $\sin^2\phi-\lambda_0^2=\sin(\phi-\phi_1)\sin(\phi+\phi_1)$, whose factors vanish twice each in a period, at $\phi_1$ and $\phi_3$ and at $\phi_2$ and $\phi_4$ of (27) to (30), which are four different phases",
        || (phases(), paper::s22_points()),
        |(phases, number)| four_points(phases, number)
    ),
    &REST_ENDS = Statement::shown(
        Printed,
        r"for every $0<\lambda_0<1$ a rest can end only where $\lvert\sin\phi\rvert$ rises above $\lambda_0$: of the four phases (27) to (30) at which the two are equal, $\sin^2\phi$ rises with the slope $2\sin\phi_1\cos\phi_1>0$ at $\phi_1$ and $\phi_3$ and falls with it at $\phi_2$ and $\phi_4$; for $\lambda_0\ge1$ no rest ends, and for $\lambda_0=0$ there is none",
        phases,
        rest_ends
    ),
    &OUTLASTS = Statement::shown(
        Within,
        r"for every $0<\lambda_0<\lambda_\mathrm c$ the slip (31) is still positive at $\phi_1+\pi$, where it is the left side of (35), and has not been zero since $\phi_1$; and with the largest possible forward friction $+\lambda_0$ from $\tilde\phi_2$ on, $\mathfrak w(\phi_1+2\pi)=-2\lambda_0(\tilde\phi_2-\phi_1-\pi)<0$",
        || {
            let [lambda0, phi, end] = symbols(["λ₀", "φ", "φ̃₂"]);
            let phi1 = paper::eq27_phi1::tree();
            (
                paper::eq31_w(lambda0, phi1, phi),
                paper::eq32_left(lambda0, phi1, end),
            )
        },
        outlasts
    ),
    &PERIOD_ENDS = Statement::shown(
        Corrected,
        r"for every $0<\lambda_0<1$, and so below $\lambda_\mathrm c$: of the four phases of a period at which $\lvert\sin\phi\rvert=\lambda_0$ the drive rises above $+\lambda_0$ at $\phi_1$ only, and again a period later; in between it gives nothing, and the slip ends before",
        || corrected::rest_of_period_end(paper::eq27_phi1::tree()),
        period_ends
    )
];
