//! Trials of the definitions (93) to (95), (110) to (112), (116) to (118), and of the relations (96) to (98).
//!
//! The motion is integrated twice: in Cartesian components, and in components along and across the velocity.

use super::trajectories::{ANY, Class, FASTER, SLOWER, Stretch, View, stretches};
use crate::claims::tolerances::FRAMES;
use crate::motion::turntable::Intrinsic;
use crate::paper::turntable as printed;
use trialbook::prelude::*;

/// At both ends of each stretch: what a formula gives from one integration with what the other has.
fn ends(
    [stated, found]: [&'static str; 2],
    classes: &[Class],
    pair: impl Fn(&View, &Intrinsic) -> [f64; 2],
) -> Evidence {
    let trial = Trial::by(
        Route::Consistency,
        Subject::Printed,
        Compared::one(stated, found),
        FRAMES,
    );
    let both =
        stretches(classes).flat_map(|s| [Stretch::first, Stretch::last].map(|f| (s.clone(), f)));
    trial.over(both, |(stretch, end)| {
        let stretch = stretch?;
        let tau = end(stretch);
        let [stated, found] = pair(&stretch.view(tau)?, &stretch.part(tau)?);
        Ok(Pair {
            at: stretch.at(),
            stated,
            found,
            scale: 1f64.max(found.abs()),
        })
    })
}

impl Stretch {
    fn first(&self) -> f64 {
        self.from
    }
    fn last(&self) -> f64 {
        self.to
    }
}

/// At both ends of each stretch: the left-hand side by components along the velocity with what the Cartesian motion has, and
/// the right-hand side of the Cartesian motion with what the components have; or the other way round.
fn both_sides(
    compared: Compared,
    stated: impl Fn(&View, &Intrinsic) -> [f64; 2],
    found: impl Fn(&View, &Intrinsic) -> [f64; 2],
) -> Evidence {
    let trial = Trial::by(Route::Integration, Subject::Printed, compared, FRAMES);
    let ends = stretches(ANY).flat_map(|s| [Stretch::first, Stretch::last].map(|f| (s.clone(), f)));
    let sides = ends.flat_map(|(s, end)| [0, 1].map(|side| (s.clone(), end, side)));
    trial.over(sides, |(stretch, end, side)| {
        let stretch = stretch?;
        let tau = end(stretch);
        let (view, part) = (stretch.view(tau)?, stretch.part(tau)?);
        let found = found(&view, &part)[side];
        Ok(Pair {
            at: stretch.at(),
            stated: stated(&view, &part)[side],
            found,
            scale: 1f64.max(found.abs()),
        })
    })
}

/// ρ² − p², by components along the velocity, where no large terms cancel.
fn lead(part: &Intrinsic) -> f64 {
    part.parts.energy()
}

/// A and α by components along the velocity.
fn inner(part: &Intrinsic) -> (f64, f64) {
    let none = f64::NAN;
    (part.a().unwrap_or(none), part.alpha().unwrap_or(none))
}

/// B and β by components along the velocity.
fn outer(part: &Intrinsic) -> (f64, f64) {
    let b = libm::sqrt(-lead(part));
    (b, libm::asinh(part.rho() / b))
}

pub(super) const TRIALS: &[Attempt] = trials![
    eq93 = ends(
        [
            "(93) of the Cartesian velocity",
            "the speed by components along the velocity"
        ],
        ANY,
        |view, part| [printed::eq93_speed(view.rate), part.p()],
    ),
    eq94 = ends(
        [
            r"(94), with the angle $\psi$ from the Cartesian velocity to the position,",
            "the position along the velocity",
        ],
        ANY,
        |view, part| [printed::eq94_xi(view.rho, view.psi), part.parts.xi],
    ),
    eq95 = ends(
        [
            r"(95), with the angle $\psi$ from the Cartesian velocity to the position,",
            "minus the position to the left of the velocity",
        ],
        ANY,
        |view, part| {
            let left = part.parts.p - part.parts.zeta;
            [printed::eq95_ell(view.rho, view.psi), -left]
        },
    ),
    eq96 = both_sides(
        Compared::many(
            r"the sides of (96), $p\ell$ by components along the velocity and the other one Cartesian,",
            "the angular momentum, Cartesian and by components",
        ),
        |view, part| {
            let ell = printed::eq95_ell(part.rho(), part.psi());
            printed::eq96_angular_momentum(part.p(), ell, view.position, view.rate)
        },
        |view, part| {
            let left = part.parts.p - part.parts.zeta;
            [view.moment(), -part.p() * left]
        },
    ),
    eq97 = both_sides(
        Compared::many(
            r"the sides of (97), $p\xi$ by components along the velocity and the other one Cartesian,",
            r"$\bm\rho\cdot\mathrm d\bm\rho/\mathrm d\tau$, Cartesian and by components",
        ),
        |view, part| {
            let xi = printed::eq94_xi(part.rho(), part.psi());
            printed::eq97_radial(part.p(), xi, view.position, view.rate)
        },
        |view, part| [view.along(), part.p() * part.parts.xi],
    ),
    eq98 = both_sides(
        Compared::many(
            r"the sides of (98), $\bm\rho\cdot\bm\rho$ Cartesian and the other one by components along the velocity,",
            r"$\rho^2$, by components and Cartesian",
        ),
        |view, part| {
            let (rho, psi) = (part.rho(), part.psi());
            let (ell, xi) = (printed::eq95_ell(rho, psi), printed::eq94_xi(rho, psi));
            printed::eq98_distance(view.position, ell, xi)
        },
        |view, part| [part.rho() * part.rho(), view.rho * view.rho],
    ),
    eq103 = ends(
        [
            r"$\frac12(p^2-\rho^2)$ of (103), Cartesian,",
            "the same by components along the velocity",
        ],
        ANY,
        |view, part| [printed::eq103_energy(view.p, view.rho), -0.5 * lead(part)],
    ),
    eq110 = ends(
        [
            r"$p^2-\rho^2$ of (110), where the particle is slower than the table under it,",
            "$-A^2$",
        ],
        SLOWER,
        |view, part| {
            let (a, _) = inner(part);
            [printed::eq110_case(view.p, view.rho), -a * a]
        },
    ),
    eq111 = ends(
        [
            r"(111), with $A=\sqrt{\rho^2-p^2}$ and $\tanh\alpha=p/\rho$,",
            "$p$"
        ],
        SLOWER,
        |view, part| {
            let (a, alpha) = inner(part);
            [printed::eq111_p(a, alpha), view.p]
        },
    ),
    eq112 = ends(
        [
            r"(112), with $A=\sqrt{\rho^2-p^2}$ and $\tanh\alpha=p/\rho$,",
            r"$\rho$"
        ],
        SLOWER,
        |view, part| {
            let (a, alpha) = inner(part);
            [printed::eq112_rho(a, alpha), view.rho]
        },
    ),
    eq116 = ends(
        [
            r"$p^2-\rho^2$ of (116), where the particle is faster than the table under it,",
            "$B^2$",
        ],
        FASTER,
        |view, part| {
            let (b, _) = outer(part);
            [printed::eq116_case(view.p, view.rho), b * b]
        },
    ),
    eq117 = ends(
        [
            r"(117), with $B=\sqrt{p^2-\rho^2}$ and $\tanh\beta=\rho/p$,",
            "$p$"
        ],
        FASTER,
        |view, part| {
            let (b, beta) = outer(part);
            [printed::eq117_p(b, beta), view.p]
        },
    ),
    eq118 = ends(
        [
            r"(118), with $B=\sqrt{p^2-\rho^2}$ and $\tanh\beta=\rho/p$,",
            r"$\rho$"
        ],
        FASTER,
        |view, part| {
            let (b, beta) = outer(part);
            [printed::eq118_rho(b, beta), view.rho]
        },
    ),
];
