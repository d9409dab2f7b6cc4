//! Printed rates, integrated along motions, against what changed.

use super::prelude::*;
use super::trajectories::{ALONG, ALPHA, BETA, Class, MOMENT, PSI, SLOWER, samples};

const ASKED: f64 = 1e-13;

/// ∫ rate dτ along each stretch of these classes with the change of the quantity.
pub(super) fn change(
    law: &'static str,
    subject: Subject,
    classes: &[Class],
    (name, quantity): Quantity,
    rate: impl Fn(&View) -> f64,
) -> Evidence {
    let ends = |stretch: &Stretch| -> Result<_, MotionError> {
        let [begin, end] = [stretch.view(stretch.from)?, stretch.view(stretch.to)?];
        let [begin, end] = [quantity(&begin), quantity(&end)];
        Ok((end - begin, 1f64.max(begin.abs()).max(end.abs())))
    };
    integral(law, subject, classes, name, ends, rate)
}

fn integral(
    law: &'static str,
    subject: Subject,
    classes: &[Class],
    of: &'static str,
    change: impl Fn(&Stretch) -> Result<(f64, f64), MotionError>,
    rate: impl Fn(&View) -> f64,
) -> Evidence {
    Trial::quadrature(
        subject,
        Compared::composed(
            ["the integral of ", law, r" over $\tau$ along the motion"],
            ["the change of ", of, ""],
        ),
    )
    .each(stretches(classes), Stretch::at, |stretch| {
        let (found, scale) = change(stretch)?;
        Ok([stretch.sum(&rate, ASKED * scale), found, scale])
    })
}

/// By how much ψ, which is measured up to whole turns, grows over a stretch. Off rest and off the axis it changes by less than half a turn from one moment that is
/// looked at to the next, so that whole turns can be counted.
fn turned(stretch: &Stretch) -> Result<(f64, f64), MotionError> {
    let angles = samples(stretch.from, stretch.to).map(|tau| Ok(stretch.view(tau)?.psi));
    let angles = angles.collect::<Result<Vec<_>, MotionError>>()?;
    let jumps = angles.windows(2).map(|w| libm::round((w[0] - w[1]) / TAU));
    let grown = angles[angles.len() - 1] - angles[0] + TAU * jumps.sum::<f64>();
    Ok((grown, 1.0))
}

/// (90) is the rate of this.
const HALF_P2: Quantity = (r"$\frac12p^2$", |v| 0.5 * v.p * v.p);
/// (103) is the rate of this.
const ENERGY: Quantity = (r"$\frac12(p^2-\rho^2)$", |v| {
    0.5 * (v.p * v.p - v.rho * v.rho)
});
const A: Quantity = ("$A$", |v| v.inner().0);
const B: Quantity = ("$B$", |v| v.outer().0);

const EQ102: &str = "the expressions of (102), taken once, twice and four times,";
/// The sum of so many expressions of (102) is the rate of this.
const RHO2: Quantity = (r"$\frac72\rho^2$", |v| 3.5 * v.rho * v.rho);

/// The three expressions of (102), added with different weights, so that no two errors can cancel.
fn eq102_sum(v: &View) -> f64 {
    let ell = [v.ell, printed::eq100_ell_rate(v.p, v.ell, v.xi)];
    let xi = [v.xi, printed::eq101_xi_rate(v.p, v.ell)];
    let p = [v.p, printed::eq99_p_rate(v.xi)];
    let [first, second, third] = printed::eq102_rate(ell, xi, p);
    first + 2.0 * second + 4.0 * third
}

attempts![
    eq90 = change("(90)", Printed, ANY, HALF_P2, |v| {
        printed::eq90_power(v.position, v.rate)
    }),
    eq91 = change("(91)", Within, ANY, MOMENT, |v| {
        printed::eq91_moment(v.position, v.rate)
    }),
    eq92 = change("(92)", Within, ANY, ALONG, |v| {
        printed::eq92_virial(v.position, v.rate)
    }),
    eq99 = change("(99)", Within, ANY, P, |v| printed::eq99_p_rate(v.xi)),
    eq100 = change("(100)", Within, ANY, ELL, |v| {
        printed::eq100_ell_rate(v.p, v.ell, v.xi)
    }),
    eq101 = change("(101)", Within, ANY, XI, |v| {
        printed::eq101_xi_rate(v.p, v.ell)
    }),
    eq102 = change(EQ102, Printed, ANY, RHO2, eq102_sum),
    eq103 = change(
        "$-p$",
        Printed,
        ANY,
        ENERGY,
        |v| printed::eq103_energy_rate(v.p)
    ),
    eq107 = change("(107)", Within, ANY, P, |v| {
        printed::eq107_p_rate(v.rho, v.psi)
    }),
    eq108 = change("(108)", Printed, ANY, RHO, |v| {
        printed::eq108_rho_rate(v.p, v.psi)
    }),
    eq109 = integral("(109)", Within, ANY, PSI.0, turned, |v| {
        printed::eq109_psi_rate(v.p, v.rho, v.psi)
    }),
    eq113 = change("(113)", Printed, SLOWER, A, |v| {
        printed::eq113_a_rate(v.inner().1)
    }),
    eq114 = change("(114)", Within, SLOWER, ALPHA, |v| {
        let (a, alpha) = v.inner();
        printed::eq114_alpha_rate(a, alpha, v.psi)
    }),
    eq115 = integral("(115)", Within, SLOWER, PSI.0, turned, |v| {
        printed::eq115_psi_rate(v.inner().1, v.psi)
    }),
    eq119 = change("(119)", Printed, FASTER, B, |v| {
        printed::eq119_b_rate(v.outer().1)
    }),
    eq120 = change("(120)", Printed, FASTER, BETA, |v| {
        let (b, beta) = v.outer();
        printed::eq120_beta_rate(b, beta, v.psi)
    }),
    eq121 = integral("(121)", Within, FASTER, PSI.0, turned, |v| {
        printed::eq121_psi_rate(v.outer().1, v.psi)
    })
];
