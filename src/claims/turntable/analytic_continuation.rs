//! Trials of (122) and (123): the first case's formulas with complex A and α, along motions with p > ρ.

use super::complex::Complex;
use super::prelude::*;

/// A and α by (122) and (123).
fn inner(view: &View) -> [Complex; 2] {
    let (b, beta) = view.outer();
    [
        printed::eq122_a(Complex::I, Complex::real(b)),
        printed::eq123_alpha(Complex::I, Complex::real(beta)),
    ]
}

fn eq122() -> Evidence {
    let trial = Trial::motion(Printed, Compared::many(
        r"the real and imaginary part of (111) plus twice (112), with the complex $A$ and $\alpha$ of (122) and (123),",
        r"$p+2\rho$ and 0",
    )
    .over(r"$p>\rho$"));
    trial.over(with_each(stretches(FASTER), [true, false]), |case| {
        let (stretch, real) = case?;
        let view = stretch.view(stretch.to)?;
        let [a, alpha] = inner(&view);
        let sum = printed::eq111_p(a, alpha) + Complex::real(2.0) * printed::eq112_rho(a, alpha);
        let found = view.p + 2.0 * view.rho;
        Ok(Pair {
            at: stretch.at(),
            stated: if real { sum.re } else { sum.im },
            found: if real { found } else { 0.0 },
            scale: found,
        })
    })
}

fn eq123() -> Evidence {
    let trial = Trial::quadrature(Printed, Compared::many(
        r"the real and imaginary part of the integral of (114) over $\tau$, with the complex $A$ and $\alpha$ of (122) and (123),",
        r"the change of $\beta$, and 0",
    )
    .over(r"$p>\rho$"));
    trial.over(with_each(stretches(FASTER), [true, false]), |case| {
        let (stretch, real) = case?;
        let rate = |view: &View| {
            let [a, alpha] = inner(view);
            let rate = printed::eq114_alpha_rate(a, alpha, Complex::real(view.psi));
            if real { rate.re } else { rate.im }
        };
        let beta = |tau: f64| stretch.view(tau).map(|view| view.outer().1);
        let change = beta(stretch.to)? - beta(stretch.from)?;
        Ok(Pair::plain(
            stretch.at(),
            stretch.sum(rate, 1e-13),
            if real { change } else { 0.0 },
        ))
    })
}

attempts![eq122, eq123];
