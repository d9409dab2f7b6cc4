//! Printed rates, integrated along motions, against what changed.

use super::trajectories::{ANY, Class, FASTER, SLOWER, Stretch, View, samples, stretches, sum};
use crate::evidence::{Evidence, Subject};
use crate::motion::MotionError;
use crate::paper::turntable as printed;
use std::f64::consts::TAU;
use trialbook::claims::attempt::{Attempt, trials};
use trialbook::claims::compare::{Compared, Pair, Trial};

/// What the quadratures are asked for.
const ASKED: f64 = 1e-13;

/// ∫ rate dτ along each stretch of these classes with the change of the quantity.
fn change(
    subject: Subject,
    compared: Compared,
    classes: &[Class],
    quantity: impl Fn(&View) -> f64,
    rate: impl Fn(&View) -> f64,
) -> Evidence {
    Trial::quadrature(subject, compared).over(stretches(classes), |stretch| {
        let stretch = stretch?;
        let [begin, end] =
            [stretch.view(stretch.from)?, stretch.view(stretch.to)?].map(|v| quantity(&v));
        let scale = 1f64.max(begin.abs()).max(end.abs());
        let at = |tau: f64| stretch.view(tau).map_or(f64::NAN, |view| rate(&view));
        Ok(Pair {
            at: stretch.at(),
            stated: sum(at, stretch.from, stretch.to, ASKED * scale),
            found: end - begin,
            scale,
        })
    })
}

/// The same for the angle ψ, which is measured up to whole turns, and followed through them.
fn turning(compared: Compared, classes: &[Class], rate: impl Fn(&View) -> f64) -> Evidence {
    Trial::quadrature(Subject::Within, compared).over(stretches(classes), |stretch| {
        let stretch = stretch?;
        let at = |tau: f64| stretch.view(tau).map_or(f64::NAN, |view| rate(&view));
        Ok(Pair {
            at: stretch.at(),
            stated: sum(at, stretch.from, stretch.to, ASKED),
            found: turned(stretch)?,
            scale: 1.0,
        })
    })
}

/// By how much ψ grows over a stretch. Off rest and off the axis it changes by less than half a turn from one moment that is
/// looked at to the next, so that whole turns can be counted.
fn turned(stretch: &Stretch) -> Result<f64, MotionError> {
    let angles = samples(stretch.from, stretch.to).map(|tau| Ok(stretch.view(tau)?.psi));
    let angles = angles.collect::<Result<Vec<_>, MotionError>>()?;
    let jumps = angles.windows(2).map(|w| libm::round((w[0] - w[1]) / TAU));
    Ok(angles[angles.len() - 1] - angles[0] + TAU * jumps.sum::<f64>())
}

/// (90): its left-hand side is the rate of p²/2.
pub fn eq90() -> Evidence {
    let compared = Compared::one(
        r"the integral of (90) over $\tau$ along the motion",
        r"the change of $\frac12p^2$",
    );
    change(
        Subject::Printed,
        compared,
        ANY,
        |v| 0.5 * v.p * v.p,
        |v| printed::eq90_power(v.position, v.rate),
    )
}

/// (91): its left-hand side is the rate of ẑ·(𝛒 × d𝛒/dτ).
pub fn eq91() -> Evidence {
    let compared = Compared::one(
        r"the integral of (91) over $\tau$ along the motion",
        r"the change of $\hat{\bm z}\cdot(\bm\rho\times\mathrm d\bm\rho/\mathrm d\tau)$",
    );
    change(Subject::Within, compared, ANY, View::moment, |v| {
        printed::eq91_moment(v.position, v.rate)
    })
}

/// (92): its left-hand side is the rate of 𝛒·d𝛒/dτ.
pub fn eq92() -> Evidence {
    let compared = Compared::one(
        r"the integral of (92) over $\tau$ along the motion",
        r"the change of $\bm\rho\cdot\mathrm d\bm\rho/\mathrm d\tau$",
    );
    change(Subject::Within, compared, ANY, View::along, |v| {
        printed::eq92_virial(v.position, v.rate)
    })
}

/// (99).
pub fn eq99() -> Evidence {
    let compared = Compared::one(
        r"the integral of (99) over $\tau$ along the motion",
        "the change of $p$",
    );
    change(
        Subject::Within,
        compared,
        ANY,
        |v| v.p,
        |v| printed::eq99_p_rate(v.xi),
    )
}

/// (100).
pub fn eq100() -> Evidence {
    let compared = Compared::one(
        r"the integral of (100) over $\tau$ along the motion",
        r"the change of $\ell$",
    );
    change(
        Subject::Within,
        compared,
        ANY,
        |v| v.ell,
        |v| printed::eq100_ell_rate(v.p, v.ell, v.xi),
    )
}

/// (101).
pub fn eq101() -> Evidence {
    let compared = Compared::one(
        r"the integral of (101) over $\tau$ along the motion",
        r"the change of $\xi$",
    );
    change(
        Subject::Within,
        compared,
        ANY,
        |v| v.xi,
        |v| printed::eq101_xi_rate(v.p, v.ell),
    )
}

/// (102): its three expressions, added with different weights, so that no two errors can cancel.
pub fn eq102() -> Evidence {
    let compared = Compared::one(
        "the integral of the expressions of (102), taken once, twice and four times,",
        r"7 times the change of $\frac12\rho^2$",
    );
    change(
        Subject::Printed,
        compared,
        ANY,
        |v| 3.5 * v.rho * v.rho,
        |v| {
            let ell = [v.ell, printed::eq100_ell_rate(v.p, v.ell, v.xi)];
            let xi = [v.xi, printed::eq101_xi_rate(v.p, v.ell)];
            let p = [v.p, printed::eq99_p_rate(v.xi)];
            let [first, second, third] = printed::eq102_rate(ell, xi, p);
            first + 2.0 * second + 4.0 * third
        },
    )
}

/// (103).
pub fn eq103() -> Evidence {
    let compared = Compared::one(
        r"the integral of $-p$ over $\tau$ along the motion",
        r"the change of $\frac12(p^2-\rho^2)$",
    );
    change(
        Subject::Printed,
        compared,
        ANY,
        |v| 0.5 * (v.p * v.p - v.rho * v.rho),
        |v| printed::eq103_energy_rate(v.p),
    )
}

/// (107).
pub fn eq107() -> Evidence {
    let compared = Compared::one(
        r"the integral of (107) over $\tau$ along the motion",
        "the change of $p$",
    );
    change(
        Subject::Within,
        compared,
        ANY,
        |v| v.p,
        |v| printed::eq107_p_rate(v.rho, v.psi),
    )
}

/// (108).
pub fn eq108() -> Evidence {
    let compared = Compared::one(
        r"the integral of (108) over $\tau$ along the motion",
        r"the change of $\rho$",
    );
    change(
        Subject::Printed,
        compared,
        ANY,
        |v| v.rho,
        |v| printed::eq108_rho_rate(v.p, v.psi),
    )
}

/// (109).
pub fn eq109() -> Evidence {
    let compared = Compared::one(
        r"the integral of (109) over $\tau$ along the motion",
        r"the change of $\psi$",
    );
    turning(compared, ANY, |v| {
        printed::eq109_psi_rate(v.p, v.rho, v.psi)
    })
}

/// (113).
pub fn eq113() -> Evidence {
    let compared = Compared::one(
        r"the integral of (113) over $\tau$ along the motion",
        "the change of $A$",
    );
    change(
        Subject::Printed,
        compared,
        SLOWER,
        |v| v.inner().0,
        |v| printed::eq113_a_rate(v.inner().1),
    )
}

/// (114).
pub fn eq114() -> Evidence {
    let compared = Compared::one(
        r"the integral of (114) over $\tau$ along the motion",
        r"the change of $\alpha$",
    );
    change(
        Subject::Within,
        compared,
        SLOWER,
        |v| v.inner().1,
        |v| {
            let (a, alpha) = v.inner();
            printed::eq114_alpha_rate(a, alpha, v.psi)
        },
    )
}

/// (115).
pub fn eq115() -> Evidence {
    let compared = Compared::one(
        r"the integral of (115) over $\tau$ along the motion",
        r"the change of $\psi$",
    );
    turning(compared, SLOWER, |v| {
        printed::eq115_psi_rate(v.inner().1, v.psi)
    })
}

/// (119).
pub fn eq119() -> Evidence {
    let compared = Compared::one(
        r"the integral of (119) over $\tau$ along the motion",
        "the change of $B$",
    );
    change(
        Subject::Printed,
        compared,
        FASTER,
        |v| v.outer().0,
        |v| printed::eq119_b_rate(v.outer().1),
    )
}

/// (120).
pub fn eq120() -> Evidence {
    let compared = Compared::one(
        r"the integral of (120) over $\tau$ along the motion",
        r"the change of $\beta$",
    );
    change(
        Subject::Printed,
        compared,
        FASTER,
        |v| v.outer().1,
        |v| {
            let (b, beta) = v.outer();
            printed::eq120_beta_rate(b, beta, v.psi)
        },
    )
}

/// (121).
pub fn eq121() -> Evidence {
    let compared = Compared::one(
        r"the integral of (121) over $\tau$ along the motion",
        r"the change of $\psi$",
    );
    turning(compared, FASTER, |v| {
        printed::eq121_psi_rate(v.outer().1, v.psi)
    })
}

pub(super) const TRIALS: &[Attempt] = trials![
    eq90, eq91, eq92, eq99, eq100, eq101, eq102, eq103, eq107, eq108, eq109, eq113, eq114, eq115,
    eq119, eq120, eq121
];
