//! Trials of the definitions (93) to (95), (110) to (112), (116) to (118), and of the relations (96) to (98).
//!
//! The motion is integrated twice: in Cartesian components, and in components along and across the velocity.

use super::prelude::*;
use super::trajectories::{Class, SLOWER};

/// At both ends of each stretch: what formulas give from one integration with what the other has.
fn ends<const N: usize>(
    route: Route,
    compared: Compared,
    classes: &[Class],
    pairs: impl Fn(&View, &Intrinsic) -> [[f64; 2]; N],
) -> Evidence {
    Trial::by(route, Printed, compared, FRAMES).pairs(stretches(classes), |stretch| {
        let stretch = stretch?;
        let mut all = Vec::new();
        for tau in [stretch.from, stretch.to] {
            for [stated, found] in pairs(&stretch.view(tau)?, &stretch.part(tau)?) {
                all.push(Pair {
                    at: stretch.at(),
                    stated,
                    found,
                    scale: 1f64.max(found.abs()),
                });
            }
        }
        Ok(all)
    })
}

fn defined(
    [stated, found]: [&'static str; 2],
    classes: &[Class],
    pair: impl Fn(&View, &Intrinsic) -> [f64; 2],
) -> Evidence {
    let compared = Compared::one(stated, found);
    ends(Consistency, compared, classes, |view, part| {
        [pair(view, part)]
    })
}

/// A relation: the left-hand side by components along the velocity with what the Cartesian motion has, and the right-hand side of
/// the Cartesian motion with what the components have; or the other way round.
fn both_sides(compared: Compared, pairs: impl Fn(&View, &Intrinsic) -> [[f64; 2]; 2]) -> Evidence {
    ends(Integration, compared, ANY, pairs)
}

/// Its symbols in words, where it is tried, and its symbols by components along the velocity.
type Case = (&'static str, &'static [Class], fn(&Intrinsic) -> (f64, f64));

const INNER: Case = (
    r", with $A=\sqrt{\rho^2-p^2}$ and $\tanh\alpha=p/\rho$,",
    SLOWER,
    inner,
);
const OUTER: Case = (
    r", with $B=\sqrt{p^2-\rho^2}$ and $\tanh\beta=\rho/p$,",
    FASTER,
    outer,
);

fn by_case(
    law: &'static str,
    (symbols, classes, of): Case,
    (name, quantity): Quantity,
    formula: fn(f64, f64) -> f64,
) -> Evidence {
    let compared = Compared::composed([law, symbols, ""], [name, "", ""]);
    ends(Consistency, compared, classes, |view, part| {
        let (size, angle) = of(part);
        [[formula(size, angle), quantity(view)]]
    })
}

/// ρ² − p², by components along the velocity, where no large terms cancel.
fn lead(part: &Intrinsic) -> f64 {
    part.parts.energy()
}

/// The position to the left of the velocity.
fn to_the_left(part: &Intrinsic) -> f64 {
    part.parts.p - part.parts.zeta
}

/// A and α.
fn inner(part: &Intrinsic) -> (f64, f64) {
    let none = f64::NAN;
    (part.a().unwrap_or(none), part.alpha().unwrap_or(none))
}

/// B and β.
fn outer(part: &Intrinsic) -> (f64, f64) {
    let b = libm::sqrt(-lead(part));
    (b, libm::asinh(part.rho() / b))
}

attempts![
    eq93 = defined(
        [
            "(93) of the Cartesian velocity",
            "the speed by components along the velocity"
        ],
        ANY,
        |view, part| [printed::eq93_speed(view.rate), part.p()],
    ),
    eq94 = defined(
        [
            r"(94), with the angle $\psi$ from the Cartesian velocity to the position,",
            "the position along the velocity",
        ],
        ANY,
        |view, part| [printed::eq94_xi(view.rho, view.psi), part.parts.xi],
    ),
    eq95 = defined(
        [
            r"(95), with the angle $\psi$ from the Cartesian velocity to the position,",
            "minus the position to the left of the velocity",
        ],
        ANY,
        |view, part| { [printed::eq95_ell(view.rho, view.psi), -to_the_left(part)] },
    ),
    eq96 = both_sides(
        Compared::many(
            r"the sides of (96), $p\ell$ by components along the velocity and the other one Cartesian,",
            "the angular momentum, Cartesian and by components",
        ),
        |view, part| {
            let ell = printed::eq95_ell(part.rho(), part.psi());
            let [left, right] =
                printed::eq96_angular_momentum(part.p(), ell, view.position, view.rate);
            [
                [left, view.moment()],
                [right, -part.p() * to_the_left(part)],
            ]
        },
    ),
    eq97 = both_sides(
        Compared::many(
            r"the sides of (97), $p\xi$ by components along the velocity and the other one Cartesian,",
            r"$\bm\rho\cdot\mathrm d\bm\rho/\mathrm d\tau$, Cartesian and by components",
        ),
        |view, part| {
            let xi = printed::eq94_xi(part.rho(), part.psi());
            let [left, right] = printed::eq97_radial(part.p(), xi, view.position, view.rate);
            [[left, view.along()], [right, part.p() * part.parts.xi]]
        },
    ),
    eq98 = both_sides(
        Compared::many(
            r"the sides of (98), $\bm\rho\cdot\bm\rho$ Cartesian and the other one by components along the velocity,",
            r"$\rho^2$, by components and Cartesian",
        ),
        |view, part| {
            let (rho, psi) = (part.rho(), part.psi());
            let (ell, xi) = (printed::eq95_ell(rho, psi), printed::eq94_xi(rho, psi));
            let [left, right] = printed::eq98_distance(view.position, ell, xi);
            [[left, rho * rho], [right, view.rho * view.rho]]
        },
    ),
    eq103 = defined(
        [
            r"$\frac12(p^2-\rho^2)$ of (103), Cartesian,",
            "the same by components along the velocity",
        ],
        ANY,
        |view, part| [printed::eq103_energy(view.p, view.rho), -0.5 * lead(part)],
    ),
    eq110 = defined(
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
    eq111 = by_case("(111)", INNER, P, printed::eq111_p),
    eq112 = by_case("(112)", INNER, RHO, printed::eq112_rho),
    eq116 = defined(
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
    eq117 = by_case("(117)", OUTER, P, printed::eq117_p),
    eq118 = by_case("(118)", OUTER, RHO, printed::eq118_rho)
];
