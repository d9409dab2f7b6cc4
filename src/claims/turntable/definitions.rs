//! Trials of the definitions (93) to (95), (110) to (112), (116) to (118), and of the relations (96) to (98).
//!
//! The motion is integrated twice: in Cartesian components, and in components along and across the velocity.

use super::stretches::{ANY, Class, FASTER, SLOWER, Stretch, View, stretches};
use crate::claims::compare::{Pair, Trial};
use crate::claims::tolerances::FRAMES;
use crate::evidence::{Evidence, Route, Subject};
use crate::motion::turntable::Intrinsic;
use crate::paper::turntable as printed;

/// At both ends of each stretch: what a formula gives from one integration with what the other has.
fn ends(
    compared: &'static str,
    classes: &[Class],
    pair: impl Fn(&View, &Intrinsic) -> [f64; 2],
) -> Evidence {
    let trial = Trial::by(Route::Consistency, Subject::Printed, compared, FRAMES);
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

/// (93).
pub fn eq93() -> Evidence {
    let compared = "(93) of the Cartesian velocity with the speed by components along the velocity";
    ends(compared, ANY, |view, part| {
        [printed::eq93_speed(view.rate), part.p()]
    })
}

/// (94).
pub fn eq94() -> Evidence {
    let compared = "(94), with the angle ψ from the Cartesian velocity to the position, with the position along the velocity";
    ends(compared, ANY, |view, part| {
        [printed::eq94_xi(view.rho, view.psi), part.parts.xi]
    })
}

/// (95).
pub fn eq95() -> Evidence {
    let compared = "(95), with the angle ψ from the Cartesian velocity to the position, with minus the position to the left of the velocity";
    ends(compared, ANY, |view, part| {
        let left = part.parts.p - part.parts.zeta;
        [printed::eq95_ell(view.rho, view.psi), -left]
    })
}

/// At both ends of each stretch: the left-hand side by components along the velocity with what the Cartesian motion has, and
/// the right-hand side of the Cartesian motion with what the components have; or the other way round.
fn both_sides(
    compared: &'static str,
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

/// (96).
pub fn eq96() -> Evidence {
    let compared = "the sides of (96), pℓ by components along the velocity, the other one Cartesian, with the angular momentum, Cartesian and by components";
    both_sides(
        compared,
        |view, part| {
            let ell = printed::eq95_ell(part.rho(), part.psi());
            printed::eq96_angular_momentum(part.p(), ell, view.position, view.rate)
        },
        |view, part| {
            let left = part.parts.p - part.parts.zeta;
            [view.moment(), -part.p() * left]
        },
    )
}

/// (97).
pub fn eq97() -> Evidence {
    let compared = "the sides of (97), pξ by components along the velocity, the other one Cartesian, with 𝛒·(d𝛒/dτ), Cartesian and by components";
    both_sides(
        compared,
        |view, part| {
            let xi = printed::eq94_xi(part.rho(), part.psi());
            printed::eq97_radial(part.p(), xi, view.position, view.rate)
        },
        |view, part| [view.along(), part.p() * part.parts.xi],
    )
}

/// (98).
pub fn eq98() -> Evidence {
    let compared = "the sides of (98), 𝛒·𝛒 Cartesian, the other one by components along the velocity, with ρ², by components and Cartesian";
    both_sides(
        compared,
        |view, part| {
            let (rho, psi) = (part.rho(), part.psi());
            let (ell, xi) = (printed::eq95_ell(rho, psi), printed::eq94_xi(rho, psi));
            printed::eq98_distance(view.position, ell, xi)
        },
        |view, part| [part.rho() * part.rho(), view.rho * view.rho],
    )
}

/// (103): the energy in its brackets.
pub fn eq103() -> Evidence {
    let compared =
        "(p² − ρ²)/2 of (103), Cartesian, with the same by components along the velocity";
    ends(compared, ANY, |view, part| {
        [printed::eq103_energy(view.p, view.rho), -0.5 * lead(part)]
    })
}

/// ρ² − p², by components along the velocity, where no large terms cancel.
fn lead(part: &Intrinsic) -> f64 {
    part.parts.energy()
}

/// (110).
pub fn eq110() -> Evidence {
    let compared =
        "p² − ρ² of (110), where the particle is slower than the table under it, with −A²";
    ends(compared, SLOWER, |view, part| {
        let a = part.a().unwrap_or(f64::NAN);
        [printed::eq110_case(view.p, view.rho), -a * a]
    })
}

/// (111).
pub fn eq111() -> Evidence {
    let compared = "(111), with A = √(ρ² − p²) and tanh α = p/ρ, with p";
    ends(compared, SLOWER, |view, part| {
        let (a, alpha) = (
            part.a().unwrap_or(f64::NAN),
            part.alpha().unwrap_or(f64::NAN),
        );
        [printed::eq111_p(a, alpha), view.p]
    })
}

/// (112).
pub fn eq112() -> Evidence {
    let compared = "(112), with A = √(ρ² − p²) and tanh α = p/ρ, with ρ";
    ends(compared, SLOWER, |view, part| {
        let (a, alpha) = (
            part.a().unwrap_or(f64::NAN),
            part.alpha().unwrap_or(f64::NAN),
        );
        [printed::eq112_rho(a, alpha), view.rho]
    })
}

/// (116).
pub fn eq116() -> Evidence {
    let compared =
        "p² − ρ² of (116), where the particle is faster than the table under it, with B²";
    ends(compared, FASTER, |view, part| {
        let b = libm::sqrt(-lead(part));
        [printed::eq116_case(view.p, view.rho), b * b]
    })
}

/// B and β by components along the velocity.
fn outer(part: &Intrinsic) -> (f64, f64) {
    let b = libm::sqrt(-lead(part));
    (b, libm::asinh(part.rho() / b))
}

/// (117).
pub fn eq117() -> Evidence {
    let compared = "(117), with B = √(p² − ρ²) and tanh β = ρ/p, with p";
    ends(compared, FASTER, |view, part| {
        let (b, beta) = outer(part);
        [printed::eq117_p(b, beta), view.p]
    })
}

/// (118).
pub fn eq118() -> Evidence {
    let compared = "(118), with B = √(p² − ρ²) and tanh β = ρ/p, with ρ";
    ends(compared, FASTER, |view, part| {
        let (b, beta) = outer(part);
        [printed::eq118_rho(b, beta), view.rho]
    })
}
