//! Theorems about every motion under the sinusoidal drive (21), by the law (1).

use super::prelude::*;
use crate::claims::general::chains::{decays, ring_across, stops};
use crate::claims::periodic::chains::side;
use crate::paper::sinusoidal as paper;

/// (21) at the phase φ.
pub(super) fn eq21() -> [Expr; 2] {
    let [a0, phi] = symbols(["A₀", "φ"]);
    paper::eq21_acceleration(a0, int(1), phi)
}

fn bounded([ax, ay]: [Expr; 2]) -> Proof {
    let ring = || {
        let mut ring = Ring::new();
        ring.symbol("A₀");
        ring.angle("φ");
        Ok(ring)
    };
    Proof::in_ring("The size of (21)", ring(), |p| {
        p.shows("(21) has no component across x, and at every phase φ its size is A₀ at most.");
        let [a0, phi] = symbols(["A₀", "φ"]);
        p.vanishes("The component of (21) across x", ay)?;
        p.identity(
            ("A₀² less the square of (21)", a0.squared() - ax.squared()),
            (
                "a square, which is not negative",
                (a0 * phi.cos()).squared(),
            ),
        )
    })
}

pub(crate) const VY_VANISHES: Statement<([Expr; 2], [Expr; 2], Expr)> = Statement::shown(
    Within,
    r"(21) is along $x$ and of the size $A_0$ at most, and with $\mu>0$ and any start (1) lets $v_y^2\,(v_0+A_0t)^{2\mu g/A_0}$ never grow, so that $v_y\to0$",
    || (eq21(), eq1(), paper::s22_late_vy()),
    vy_vanishes,
);

fn vy_vanishes((drive, law, limit): ([Expr; 2], [Expr; 2], Expr)) -> Proof {
    let mu = symbol("μ");
    Proof::in_ring("v_y vanishes under the sine", ring_across(mu), |p| {
        p.rests_on(&bounded(drive))?;
        decays(p, law, mu, [-int(1), limit])
    })
}

pub(crate) const WEAK_DRIVE_STOPS: Statement<([Expr; 2], Expr)> = Statement::shown(
    Printed,
    r"(21) is of the size $A_0$ at most, so that for every $A_0<\mu g$ and every start the particle, with its $v_x$, is at rest after $v_0/(\mu g-A_0)$ at the latest, and stays",
    || (eq21(), eq2()),
    weak_drive_stops,
);

fn weak_drive_stops((drive, speed): ([Expr; 2], Expr)) -> Proof {
    let ring = Ring::of(["μ", "g", "A₀", "v₀"]);
    Proof::of("A weak sine lets the particle stop", &ring, |p| {
        p.rests_on(&bounded(drive))?;
        p.rests_on(&stops(speed))?;
        let [mu, g, a0, v0] = symbols(["μ", "g", "A₀", "v₀"]);
        let time = v0 / (mu * g - a0);
        p.vanishes(
            "The line below which v lies, with a = A₀, at t = v₀/(μg − A₀)",
            v0 - (mu * g - a0) * time,
        )?;
        Ok(())
    })
}

pub(crate) const VX_STAYS: Statement<([Expr; 2], [Expr; 2], [Expr; 2])> = Statement::shown(
    Printed,
    r"for every $A_0>\mu g$ and every motion, (1) and (21) give $\mathrm d\mathfrak w/\mathrm d\phi\ge\sin\phi-\lambda_0$, so that from $\phi_1$ of (27) to $\phi_2$ of (28) in each period $\mathfrak w$ grows by $2(\sin b-b\cos b)$ at least, $b=\pi/2-\phi_1>0$: the same positive number in each period, by which no $\mathfrak w$ that tends to zero can grow",
    || {
        let lambda0 = symbol("λ₀");
        let phases = [paper::eq27_phi1(lambda0), paper::eq28_phi2(lambda0)];
        (eq1(), eq21(), phases)
    },
    vx_stays,
);

/// Rates by (1) or (2) in units in which A₀ and ϖ are 1, so that μg is λ₀, with (21) or another acceleration in those units.
pub(super) fn in_units<const N: usize>(law: [Expr; N], [ax, ay]: [Expr; 2]) -> [Expr; N] {
    let unit = |x: Expr| x.with("A₀", int(1));
    law.map(|rate| {
        let rate = rate.with("μ", symbol("λ₀")).with("g", int(1));
        rate.with("A_x", unit(ax)).with("A_y", unit(ay))
    })
}

fn vx_stays((law, drive, [phi1, phi2]): ([Expr; 2], [Expr; 2], [Expr; 2])) -> Proof {
    let ring = || -> Result<Ring, ExactError> {
        let mut ring = super::exact::ring_of_phi1()?;
        let [vx, vy] = ring.symbols(["v_x", "v_y"]);
        ring.root(&(vx.pow(2) + vy.pow(2)), 2)?;
        Ok(ring)
    };
    Proof::in_ring("A strong drive moves the particle for ever", ring(), |p| {
        let [lambda0, phi, vx, vy, beta] = symbols(["λ₀", "φ", "v_x", "v_y", "β"]);
        let [rate, _] = in_units(law, drive);
        let speed = (vx.squared() + vy.squared()).sqrt();
        let terms = phi.sin() - lambda0 + lambda0 * (1 - vx / speed);
        p.identity(
            ("d𝔴/dφ by (1) and (21)", rate),
            ("sin φ − λ₀ and what is not negative", terms),
        )?;
        p.note(
            "Where sin φ > λ₀",
            "no rest lasts: this holds from φ₁ to φ₂, but for single instants",
        );
        let whole = -phi.cos() - lambda0 * phi;
        let slope = p.read("−cos φ − λ₀ φ", whole)?;
        let slope = p.slope("Its slope", &slope, "φ")?;
        p.reads_as(&slope, "", phi.sin() - lambda0)?;
        let gain = whole.with("φ", phi2) - whole.with("φ", phi1);
        let gain = p.read("From φ₁ to φ₂ it grows by", gain)?;
        let b = pi() / 2 - beta;
        p.reads_as(&gain, "with b = π/2 − β", 2 * (b.sin() - b * b.cos()))?;
        let slope = p.slope("Its slope by β", &gain, "β")?;
        let falls = p.read("2 b sin b, positive for 0 < b ≤ π/2", 2 * b * b.sin())?;
        p.equal("The slope is less than 0 by that", &-&slope, &falls)?;
        let end = p.read("At β = π/2, b = 0, it is", 2 * (int(0).sin() - 0))?;
        p.zero("That is 0", &end)?;
        Ok(())
    })
}

const FRICTION_ACROSS: Statement<([Expr; 2], Expr)> = Statement::shown(
    Printed,
    r"for all $\mathfrak w\ne0$ and $\mathfrak w_y$, with $r=\sqrt{1+(\mathfrak w_y/\mathfrak w)^2}$: by (1) friction is $1/r$ times what is stated across the drive, and $1/r$ times $-\lambda_0\,\mathfrak w/\lvert\mathfrak w\rvert$ along it, and $0\le1-1/r\le\frac12(\mathfrak w_y/\mathfrak w)^2$",
    || {
        let stated = paper::s22_across_friction::tree();
        (eq1(), stated)
    },
    |(law, stated)| Proof::for_both_signs(|sign| friction_across(law, stated, sign)),
);

fn friction_across(law: [Expr; 2], stated: Expr, sign: i64) -> Proof {
    let ring = || -> Result<Ring, ExactError> {
        let mut ring = Ring::new();
        let [w, wy, _] = ring.symbols(["𝔴", "𝔴_y", "λ₀"]);
        ring.root(&(w.pow(2) + wy.pow(2)), 2)?;
        ring.root_is(&w.pow(2), 2, &(&w * &Rational::int(sign)))?;
        Ok(ring)
    };
    let still = [int(0), int(0)];
    Proof::in_ring("Friction across the drive", ring(), |p| {
        p.note("The proof is for either sign of 𝔴, here for", side(sign));
        let [w, wy, lambda0] = symbols(["𝔴", "𝔴_y", "λ₀"]);
        let friction = in_units(law, still).map(|c| c.with("v_x", w).with("v_y", wy));
        let ratio = (w.squared() + wy.squared()).sqrt() / (int(sign) * w);
        let along = -(int(sign) * lambda0);
        for (says, exact, stated) in [
            ("across the drive", friction[1], stated),
            ("along the drive", friction[0], along),
        ] {
            p.identity(
                (&format!("Friction {says}, by (1)"), exact),
                ("what is stated, over r", stated / ratio),
            )?;
        }
        close(p, ratio, (wy / w).squared())
    })
}

/// 0 ≤ 1 − 1/r ≤ s/2 for r = √(1 + s).
fn close(p: &mut Prover<'_>, r: Expr, s: Expr) -> Result<(), Obstacle> {
    let off = 1 - 1 / r;
    p.identity(
        ("1 − 1/r", off),
        ("which is not negative", s / (r * (r + 1))),
    )?;
    let square = (r - 1).squared() * (r + 2) / (2 * r);
    p.identity(
        ("Half of (𝔴_y/𝔴)² less that", s / 2 - off),
        ("which is not negative", square),
    )
}

attempts![&VY_VANISHES, &WEAK_DRIVE_STOPS, &VX_STAYS, &FRICTION_ACROSS];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn friction_across_is_as_stated_and_nothing_else_for_both_signs() {
        let proof = FRICTION_ACROSS.proof();
        assert!(proof.holds(), "{proof}");
        let (law, stated) = (FRICTION_ACROSS.formulas)();
        let one = |stated| [1, -1].map(|sign| friction_across(law, stated, sign).holds());
        assert_eq!(one(stated), [true; 2]);
        assert_eq!(one(-stated), [false; 2]);
        // Right for one sign of 𝔴 only.
        let [lambda0, w, wy] = symbols(["λ₀", "𝔴", "𝔴_y"]);
        assert_eq!(one(-(lambda0 * wy / w)), [true, false]);
    }
}
