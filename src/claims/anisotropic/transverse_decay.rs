//! The velocity across the drive dies under every friction that depends on the direction, but is nowhere below some size.

use super::prelude::*;
use crate::claims::general::chains::{decays, ring_across};
use crate::claims::general::two_frames::eq1;

pub(super) const VY_VANISHES: Statement<([Expr; 2], Expr)> = Statement::shown(
    Within,
    r"with $\bm A$ along $x$, $\lvert\bm A\rvert\le a$, and in (1) a coefficient $\mu\ge m>0$ that may change with the direction of the velocity and with time: $v\le v_0+at$, and $v_y^2\,(v_0+at)^{2mg/a}$ never grows, so that $v_y\to0$ from every start",
    || (eq1(), printed::s24_late_vy()),
    vanishes,
);

fn vanishes((law, limit): ([Expr; 2], Expr)) -> Proof {
    let least = symbol("m");
    let title = "v_y vanishes under a friction that depends on the direction";
    Proof::in_ring(title, ring_across(least), |p| {
        p.note(
            "μ stands for the coefficient at that instant",
            "m for its least value",
        );
        decays(p, law, least, [-int(1), limit])
    })
}

attempts![&VY_VANISHES];
