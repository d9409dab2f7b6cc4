//! Theorems about every motion on the table: that it rests or goes away, and how it stops.

use super::arrivals;
use crate::claims::escape::exact::chains::{acceleration, comes_to_rest, polar, pushed};
use crate::claims::rest::prelude::*;

pub(crate) const DICHOTOMY: Statement<(Expr, Expr, [Expr; 2])> = Statement::shown(
    Within,
    r"every motion that never comes to rest, though $\rho$ stays bounded, converges to a place, with $p\to0$: inside $\rho=1$ it would come to rest, beyond it would be pushed away, so that it creeps towards $\rho=1$",
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
        p.rests_on(&pushed(bound, acceleration))?;
        p.rests_on(&comes_to_rest(bound))?;
        p.note(
            "Let a motion never come to rest, and ρ stay bounded",
            "its place converges, not beyond the bound, and p → 0. Were the limit inside the bound, p + ρ would fall below the bound, and the particle would come to rest",
        );
        let one = p.read(
            "So it creeps towards the bound for ever, which is excepted. The bound",
            bound,
        )?;
        p.equal("It is 1", &one, &Rational::int(1))?;
        p.vanishes("The number of other fates, as stated", third)
    })
}

pub(crate) const NEAR_REST: Statement<([Expr; 2], Expr)> = Statement::shown(
    Within,
    r"for every motion with $p<\rho$ that comes to rest after a finite time, $\tanh\alpha=p/\rho\to0$, and $\xi=\rho\cos\psi$ tends to $\pm\rho$, so that $\psi\to0$ unless the particle comes straight in; (140) to (145) are proved under their conditions",
    || {
        (
            printed::s4_near_rest_limits(),
            motion::eq101_xi_rate::tree(),
        )
    },
    near_rest,
);

fn near_rest((limits, ahead): ([Expr; 2], Expr)) -> Proof {
    polar("How the particle comes to rest", |p| {
        arrivals::settle(p, limits, ahead)?;
        rest_on(
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

attempts![&NEAR_REST, &DICHOTOMY];
