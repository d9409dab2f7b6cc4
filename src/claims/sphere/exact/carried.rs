//! What is proved of a particle, carried over to the sphere: its slip velocity moves, and stays 0, as a particle's velocity does
//! with bμ in place of μ.

use super::{S3_REDUCTION, body};
use crate::claims::anisotropic::{exact as anisotropy, motions};
use crate::claims::periodic::chains::{MOSTLY_AT_REST, REST_ABOVE_ONE};
use crate::claims::periodic::critical_friction::THRESHOLD;
use crate::claims::periodic::exact as pulses;
use crate::claims::sinusoidal::attraction;
use crate::claims::sphere::prelude::*;
use crate::paper::{anisotropic, sinusoidal, sphere as paper};

pub(crate) const TRICHOTOMY: Statement<[Expr; 2]> = Statement::shown(
    Within,
    r"for every sphere, every start and every $\lambda_0>0$ of (84) but $\lambda_\mathrm c$ and 1: the slip velocity moves, and stays 0, as a particle's velocity with $b\mu$ in place of $\mu$, which makes (84) of (22); for that the three kinds are proved, with the zeros and the rests, and that $\lambda_\mathrm c$ of (37) is where the curves A and B meet",
    || {
        let [b, mu, g, a0] = symbols();
        [
            paper::eq84_lambda(b, mu, g, a0),
            sinusoidal::eq37_lambda_c(),
        ]
    },
    trichotomy,
);

fn symbols() -> [Expr; 4] {
    Expr::symbols(["b", "μ", "g", "A₀"])
}

fn ring() -> Result<Ring, ExactError> {
    let mut ring = Ring::of(["b", "μ", "g", "A₀", "q"]);
    // For (37).
    let square = ring.read(4 + pi() * pi())?;
    ring.root(&square, 2)?;
    Ok(ring)
}

fn carried(title: &str, steps: impl FnOnce(&mut Prover<'_>) -> Result<(), Obstacle>) -> Proof {
    Proof::in_ring(title, ring(), |p| {
        rest_on(p, &[&S3_REDUCTION])?;
        p.rests_on(&body::prove_rolling())?;
        steps(p)
    })
}

/// That (84) is (22) with bμ in place of μ.
fn as_of_a_particle(p: &mut Prover<'_>, lambda0: Expr) -> Result<(), Obstacle> {
    let [b, mu, g, a0] = symbols();
    let particle = sinusoidal::eq22_lambda0(b * mu, g, a0);
    p.identity(
        ("λ₀ by (84)", lambda0),
        ("λ₀ of the particle with bμ, by (22)", particle),
    )
}

fn pulse(lambda0: Expr) -> Proof {
    carried("The pulse train of the sphere", |p| {
        as_of_a_particle(p, lambda0)?;
        rest_on(p, &[&pulses::EQ44, &pulses::EQ45, &pulses::EQ46])
    })
}

fn any_drive(lambda0: Expr) -> Proof {
    carried("The sphere under any periodic drive", |p| {
        as_of_a_particle(p, lambda0)?;
        rest_on(p, &[&REST_ABOVE_ONE, &MOSTLY_AT_REST, &THRESHOLD])
    })
}

fn trichotomy([lambda0, critical]: [Expr; 2]) -> Proof {
    carried("The driven sphere", |p| {
        as_of_a_particle(p, lambda0)?;
        rest_on(p, &[&attraction::TRICHOTOMY, &anisotropy::X])?;
        let [q, at] = anisotropic::eq57_x::<Expr>();
        let same = p.read("q of X, where A and B meet", q)?;
        p.equal("It is 1", &same, &Rational::int(1))?;
        p.identity(("λ₀ there", at), ("λ_c by (37)", critical))?;
        Ok(())
    })
}

fn regions(lambda0: Expr) -> Proof {
    carried("The regions of the sphere", |p| {
        let [b, mu, g, a0] = symbols();
        let q = symbol("q");
        let forward = anisotropic::eq47_lambda_plus(b * mu, g, a0);
        let backward = anisotropic::eq48_lambda_minus(b * q * mu, g, a0);
        for (says, particle, stated) in [
            (
                "λ₊ of the particle with bμ, by (47)",
                forward,
                anisotropic::eq49_lambda_plus(lambda0),
            ),
            (
                "λ₋ of the particle with bqμ, by (48)",
                backward,
                anisotropic::eq50_lambda_minus(q, lambda0),
            ),
        ] {
            p.identity((says, particle), ("by (85) and (49) or (50)", stated))?;
        }
        rest_on(
            p,
            &[
                &motions::FIRST,
                &motions::SECOND,
                &motions::THIRD,
                &motions::FOURTH,
                &motions::FIFTH,
            ],
        )
    })
}

attempts![
    &TRICHOTOMY,
    &ANY_DRIVE = Statement::shown(
        Printed,
        r"for every sphere and every start: the slip velocity moves, and stays 0, as a particle's velocity with $b\mu$ in place of $\mu$, which makes (84) of (22), and (26) with $h$ for the sine is its equation; for that it is proved that all rests above $\lambda_0=1$, that the share of rest tends to 1 below it if $\lvert h\rvert=1$ at single instants, and that, under the conditions of that theorem, some $\lambda_\mathrm c$ divides large friction, with rests, from small, without",
        || {
            let [b, mu, g, a0] = symbols();
            paper::eq84_lambda(b, mu, g, a0)
        },
        any_drive
    ),
    &PULSE = Statement::shown(
        Printed,
        r"for every sphere: the slip velocity moves, and stays 0, as a particle's velocity with $b\mu$ in place of $\mu$, which makes (84) of (22); for that (44) to (46) are proved",
        || {
            let [b, mu, g, a0] = symbols();
            paper::eq84_lambda(b, mu, g, a0)
        },
        pulse
    ),
    &ANISOTROPIC = Statement::shown(
        Printed,
        r"for every sphere: the slip velocity moves, and stays 0, as a particle's velocity with $b\mu_\pm$ in place of $\mu_\pm$, which makes (85) of (49) and $q$ times (85) of (50); for that the regions, with E, are proved for every $q\ge1$",
        || {
            let [b, mu, g, a0] = symbols();
            paper::eq85_lambda(b, mu, g, a0)
        },
        regions
    )
];
