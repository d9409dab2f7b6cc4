//! Theorems about every motion on the table: that it rests or goes away, and how it stops.

use super::arrivals;
use crate::claims::escape::exact::chains::{
    acceleration, comes_to_rest, polar, pushed, stops_along,
};
use crate::claims::turntable::exact as turntable;
use crate::paper::{rest as printed, turntable as motion};
use trialbook::prelude::*;

/// Rest or escape.
pub const DICHOTOMY: Statement<(Expr, Expr, [Expr; 2])> = Statement::new(
    Within,
    Compared::shown(
        r"every motion from every start, for which $\rho$ stays bounded and which never comes to rest, has a place to which it converges, with $p\to0$: at $\rho<1$ it would come to rest, at $\rho>1$ be pushed away; at $\rho=1$ it creeps",
    ),
    || {
        (
            printed::s4_third_fates(),
            printed::eq139_largest_sigma(),
            acceleration(),
        )
    },
    dichotomy,
);

fn dichotomy((third, bound, acceleration): (Expr, Expr, [Expr; 2])) -> Proof {
    polar("Rest, escape, or creeping towards ρ = 1", |p| {
        p.note(
            "Let a motion never come to rest, and ρ stay bounded",
            "it converges to a place, as follows, with p → 0",
        );
        p.rests_on(&pushed(bound, acceleration))?;
        p.note(
            "If that place is beyond the bound",
            "there is no such motion",
        );
        p.rests_on(&comes_to_rest(bound))?;
        p.note(
            "If it is inside the bound",
            "p + ρ falls below the bound at some time, and the particle comes to rest: there is no such motion",
        );
        let one = p.read(
            "At the bound it creeps for ever: this is excepted. The bound",
            bound,
        )?;
        p.equal("It is 1", &one, &Rational::int(1))?;
        p.vanishes("The number of other fates, as stated", third)
    })
}

/// How the particle comes to rest.
pub const NEAR_REST: Statement<([Expr; 2], Expr)> = Statement::new(
    Within,
    Compared::shown(
        r"for every motion with $p<\rho$ that comes to rest after a finite time, $\tanh\alpha=p/\rho\to0$, and $\xi=\rho\cos\psi$ tends to $\pm\rho$, so that $\psi\to0$ unless the particle comes straight in; (140) to (145) are proved under their conditions",
    ),
    || {
        let [p, ell] = Expr::symbols(["p", "ℓ"]);
        (
            printed::s4_near_rest_limits(),
            motion::eq101_xi_rate(p, ell),
        )
    },
    near_rest,
);

/// α and ψ at rest, of which all else follows.
pub fn settles() -> Proof {
    let (limits, ahead) = (NEAR_REST.formulas)();
    polar("α and ψ at rest", |p| settle(p, limits, ahead))
}

fn settle(p: &mut Prover<'_>, [alpha, psi]: [Expr; 2], ahead: Expr) -> Result<(), Obstacle> {
    given(
        p,
        &[
            &turntable::EQ103,
            &turntable::EQ110,
            &turntable::EQ111,
            &turntable::EQ112,
        ],
    )?;
    p.note(
        "At rest",
        "ρ = σ > 0, as A² = ρ² − p² is positive and never falls; so A → σ and tanh α = p/ρ → 0",
    );
    p.vanishes("The stated limit of α", alpha)?;
    stops_along(p, ahead)?;
    p.note("Straight in, ψ → π, is excepted", "ψ → 0");
    p.vanishes("The stated limit of ψ", psi)
}

fn near_rest((limits, ahead): ([Expr; 2], Expr)) -> Proof {
    polar("How the particle comes to rest", |p| {
        settle(p, limits, ahead)?;
        given(
            p,
            &[
                &arrivals::EQ140,
                &arrivals::EQ141,
                &arrivals::EQ142,
                &arrivals::EQ143,
                &arrivals::EQ144,
                &arrivals::EQ145,
            ],
        )
    })
}

pub(in crate::claims) const TRIALS: &[Attempt] = trials![&NEAR_REST, &DICHOTOMY];
