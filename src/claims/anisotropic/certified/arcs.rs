//! For all q ≥ 1: the arcs that decide the curves rise or fall all the way, so that each has one zero at most.
//!
//! With sin α = λ₀ and sin β = qλ₀, both angles from 0 to π/2 and α ≤ β. Each link is an identity of the ring; what is left is to
//! see that every term of a sum has the same sign.

use super::super::exact::{arc, frictions, with_angle, with_angles};
use crate::claims::anisotropic::prelude::*;

/// The ring of both frictions, with q as their ratio.
fn ratios() -> Result<Ring, ExactError> {
    let mut ring = frictions()?;
    let [alpha, beta] = symbols(["α", "β"]);
    ring.define("q", ring.read(beta.sin() / alpha.sin())?)?;
    Ok(ring)
}

pub(crate) fn b_falls() -> Proof {
    Proof::in_ring("B's arc falls", ratios(), |p| {
        p.shows("Let sin α = λ₀, sin β = qλ₀, with q ≥ 1 fixed. B's arc, 𝔴 at π + β after a forward start at α, which is cos α + cos β − λ₀ (π + β − α), is 2 at β = 0 and falls as β grows to π/2.");
        let [alpha, beta, q] = symbols(["α", "β", "q"]);
        let to_b = |alpha: Expr, beta: Expr| arc(alpha, pi() + beta, alpha.sin());
        with_angles(p);
        let zero = int(0);
        let first = p.read("The arc from 0 to π", to_b(zero, zero))?;
        p.reads_as(&first, "", int(2))?;
        let rate = p.read("dα/dβ, as sin α = sin β/q", beta.cos() / (q * alpha.cos()))?;
        let along = p.ring().along(&[("α", rate), ("β", Rational::int(1))])?;
        let ratio = p.ring().read(q)?;
        let kept = p.derivative("dq/dβ, where q is held fixed", &ratio, &along)?;
        p.zero("It vanishes", &kept)?;
        let all = p.read("The arc from α to π + β", to_b(alpha, beta))?;
        let slope = p.derivative("Its slope", &all, &along)?;
        let way = pi() + beta - alpha;
        let terms = beta.sin() + alpha.sin() + beta.cos() * way / q;
        p.reads_as(&slope, "where no term of the sum is negative", -terms)
    })
}

pub(crate) fn e_grows() -> Proof {
    Proof::in_ring("E's arc over λ₀ grows", ratios(), |p| {
        p.shows("Let sin α = λ₀, sin β = qλ₀, with q ≥ 1 fixed. E's arc, 𝔴 at 2π − β after a forward start at α, which is cos α − cos β − λ₀ (2π − β − α), over λ₀ grows as λ₀ grows to 1/q.");
        with_angles(p);
        let [alpha, beta, q] = symbols(["α", "β", "q"]);
        let late = 2 * pi() - beta;
        let all = p.read("The arc from α to 2π − β", arc(alpha, late, alpha.sin()))?;
        let first = (q.squared() - 1) * alpha.sin() / (alpha.cos() + beta.cos());
        let factor = first - (2 * pi() - beta - alpha);
        let factor = p.read(
            "(q² − 1) λ₀/(cos α + cos β) + α + β − 2π, which grows with λ₀, as α and β do and the cosines fall",
            factor,
        )?;
        let friction = p.ring().read(alpha.sin())?;
        p.equal("The arc is λ₀ times that", &all, &(&friction * &factor))
    })
}

pub(crate) fn corner_falls() -> Proof {
    let ring = || {
        let mut ring = Ring::new();
        ring.angle("α");
        Ok(ring)
    };
    Proof::in_ring("The arcs of B and E at β = π/2", ring(), |p| {
        p.shows("Where qλ₀ = 1, with sin α = λ₀: 𝔴 after the arcs of B and E is sin α times cot α + α − 3π/2, which falls as α grows.");
        let alpha = symbol("α");
        let three = 3 * pi() / 2;
        p.note(
            "There qλ₀ = 1",
            "both arcs go from α, with sin α = 1/q, to 3π/2",
        );
        let all = p.read("The arc from α to 3π/2", arc(alpha, three, alpha.sin()))?;
        let factor = p.read("cot α + α − 3π/2", alpha.cot() + alpha - three)?;
        let sine = p.ring().read(alpha.sin())?;
        p.equal("The arc is sin α times that", &all, &(&sine * &factor))?;
        let slope = p.slope("Its slope", &factor, "α")?;
        p.reads_as(&slope, "so that it falls", -alpha.cot().squared())
    })
}

pub(crate) fn a_falls([left, right]: [Expr; 2]) -> Proof {
    let ring = || {
        let mut ring = frictions()?;
        ring.angle("K");
        Ok(ring)
    };
    Proof::in_ring("The sides of (53)", ring(), |p| {
        p.shows("With sin α = λ₀, 0 < α < π/2, the left side of (53) is cot α, which falls as α grows; the right side is positive for 0 < K < π.");
        with_angle(p, ["α", "λ₀"]);
        let [alpha, k] = symbols(["α", "K"]);
        let left = p.read("The left side", left)?;
        p.reads_as(&left, "", alpha.cot())?;
        let slope = p.slope("Its slope", &left, "α")?;
        let fall = -(1 / alpha.sin().squared());
        p.reads_as(&slope, "so that it falls", fall)?;
        let twice = 2 * k;
        let stated = (twice - twice.sin()) / (2 * k.sin().squared());
        p.identity(("The right side", right), ("which is positive", stated))
    })
}

pub(crate) fn c_falls(on_c: fn(Expr) -> Expr) -> Proof {
    let ring = || {
        let mut ring = Ring::new();
        ring.symbol("q");
        Ok(ring)
    };
    Proof::in_ring("C falls", ring(), |p| {
        let q = symbol("q");
        let first = p.read("C at q = 1", on_c(int(1)))?;
        p.equal("It is D", &first, &p.ring().read(printed::eq56_lambda0())?)?;
        let c = p.read("C", on_c(q))?;
        let slope = p.slope("Its slope by q", &c, "q")?;
        let fall = -(1 / q.squared());
        p.reads_as(&slope, "so that it falls", fall)
    })
}

/// E's arc over λ₀, (q² − 1) λ₀/(cos α + cos β) + α + β − 2π, by p = 1/q and λ₀q²: it has a value at p = 0 too.
pub(crate) fn e_beyond<S: Scalar>([p, scaled]: [S; 2]) -> S {
    let (one, square) = (S::int(1), p.squared());
    let [sine_b, sine_a] = [p * scaled, square * scaled];
    let cosine = |sine: S| (one - sine.squared()).sqrt();
    scaled * (one - square) / (cosine(sine_a) + cosine(sine_b)) + sine_a.asin() + sine_b.asin()
        - S::int(2) * S::pi()
}

/// On A λ₀ is below π/q², and E's arc is that by 1/q and λ₀q².
pub(crate) fn a_below() -> Proof {
    let ring = || {
        let mut ring = ratios()?;
        let [alpha, beta, q] = symbols(["α", "β", "q"]);
        let (first, second) = (1 / q, alpha.sin() * q.squared());
        for (sine, angle) in [(first * second, beta), (first.squared() * second, alpha)] {
            let (sine, angle) = (ring.read(sine)?, ring.read(angle)?);
            ring.inverse(Function::Asin, &sine, &angle)?;
        }
        Ok(ring)
    };
    Proof::in_ring("A far out", ring(), |p| {
        let [alpha, beta, q] = symbols(["α", "β", "q"]);
        let first = (q.squared() - 1) * alpha.sin() / (alpha.cos() + beta.cos());
        let by_ratio = e_beyond([1 / q, alpha.sin() * q.squared()]);
        p.identity(
            ("By the angles", first + alpha + beta - 2 * pi()),
            ("by 1/q and λ₀q²", by_ratio),
        )?;
        p.note(
            "On A",
            "tan α = 2 sin²K/(2K − sin 2K), K = πq/(q+1) from π/2 to π, where sin 2K ≤ 0 and sin K = sin(π/(q+1))",
        );
        Ok(())
    })
}
