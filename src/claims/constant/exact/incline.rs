//! An inclined plane at rest has the law of a drive that is constant, and none that of a drive that changes with time.

use crate::claims::constant::prelude::*;
use crate::claims::general::two_frames::{self, eq1};
use crate::paper::constant as paper;

fn on_an_incline((law, drive): ([Expr; 2], [Expr; 2])) -> Proof {
    let title = "An incline is a constant drive";
    let ring = || -> Result<Ring, ExactError> {
        let mut ring = two_frames::ring()?;
        ring.angle("β");
        Ok(ring)
    };
    Proof::in_ring(title, ring(), |p| {
        let [mu, g, vx, vy, beta] = symbols(["μ", "g", "v_x", "v_y", "β"]);
        let [zero, one] = [0, 1].map(int);
        let (sine, cosine) = (beta.sin(), beta.cos());
        let (down, across, normal) = (
            [cosine, zero, -sine],
            [zero, one, zero],
            [sine, zero, cosine],
        );
        let along = |a: [Expr; 3], b: [Expr; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        p.note("Down the slope", "x̂ = (cos β, 0, −sin β)");
        p.note("Across it", "ŷ = (0, 1, 0), the normal (sin β, 0, cos β)");
        let weight = [zero, zero, -g];
        let push = -along(weight, normal);
        p.read(
            "The normal force per mass, which balances weight along the normal",
            push,
        )?;
        let speed = (vx.squared() + vy.squared()).sqrt();
        let sum = [0, 1, 2].map(|i| {
            let velocity = vx * down[i] + vy * across[i];
            weight[i] + push * normal[i] - mu * push * velocity / speed
        });
        let [ax, ay] = drive.map(|c| c.with("A", g * sine));
        let on_plane = |rate: Expr| rate.with("g", g * cosine).with("A_x", ax).with("A_y", ay);
        for (says, axis, stated) in [
            ("down the slope", down, on_plane(law[0])),
            ("across it", across, on_plane(law[1])),
            ("along the normal", normal, zero),
        ] {
            p.identity(
                (&format!("All forces per mass, {says}"), along(sum, axis)),
                ("by (1) with (3), and 0 along the normal", stated),
            )?;
        }
        p.identity(
            (
                "At rest: the weight's part down the slope",
                along(weight, down),
            ),
            ("−A_x of (3)", -ax),
        )?;
        p.note(
            "The greatest friction",
            "μ times the normal force, μg cos β, there and here",
        );
        Ok(())
    })
}

attempts![
    &ON_AN_INCLINE = Statement::shown(
        Printed,
        r"for every slope $0<\beta<\pi/2$, every friction and every velocity weight, normal force and friction on an inclined plane, added in three dimensions, give (1) with $\bm A$ of (3), $A=g\sin\beta$, and $g\cos\beta$ in the place of $g$; at rest pull and greatest friction are those too",
        || (eq1(), paper::eq3_acceleration::tree()),
        on_an_incline,
    ),
    &ONLY_CONSTANT = Statement::shown(
        Printed,
        r"by (1) the rates of the velocity at $\bm v$ and at $-\bm v$ add up to $-2\bm A(t)$ at every time, and on an inclined plane of any slope and friction to twice the pull along it, which is constant: at a time at which $-\bm A$ is not that pull a motion that passes with the velocity $\bm v$, or one with $-\bm v$, is none on the inclined plane",
        eq1,
        |law| {
            let title = "No incline has a drive that changes";
            let ring = || -> Result<Ring, ExactError> {
                let mut ring = two_frames::ring()?;
                ring.symbols(["P_x", "P_y", "k"]);
                Ok(ring)
            };
            Proof::in_ring(title, ring(), |p| {
                let [ax, ay, vx, vy] = symbols(["A_x", "A_y", "v_x", "v_y"]);
                let [px, py, k] = symbols(["P_x", "P_y", "k"]);
                let (two, speed) = (int(2), (vx.squared() + vy.squared()).sqrt());
                p.note(
            "On an inclined plane",
            "weight gives the pull P along the slope, friction k against the velocity, both constant",
        );
                let incline = [px - k * vx / speed, py - k * vy / speed];
                let opposite = |rate: Expr| rate.with("v_x", -vx).with("v_y", -vy);
                for ((plane, incline), [a, pull]) in
                    law.into_iter().zip(incline).zip([[ax, px], [ay, py]])
                {
                    for (rate, sum) in [(plane, -(two * a)), (incline, two * pull)] {
                        p.identity(
                            ("A component at v and at −v, added", rate + opposite(rate)),
                            ("without friction, twice", sum),
                        )?;
                    }
                }
                p.note(
                    "With the same rates at all velocities",
                    "the drive would be the opposite of the pull at every time",
                );
                Ok(())
            })
        },
    ),
];
