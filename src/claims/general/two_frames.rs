//! Trials of (1) and (2): the law seen from the plane against the law seen from the laboratory.

use super::accelerations::{Case, bounded};
use super::prelude::*;

/// g: so small that some coefficients of friction exceed 1.
const GRAVITY: f64 = 0.5;

/// Each up to a time before the particle can stop and before the acceleration can jump.
fn cases() -> impl Iterator<Item = (Case, f64)> {
    bounded(3.0).map(|case| {
        let before_rest = 0.9 * case.start.speed() / (3.0 + case.friction);
        let before_jump = case
            .plane
            .next_break(0.0)
            .map_or(f64::INFINITY, |b| 0.9 * b);
        let until = before_rest.min(before_jump).min(3.0);
        (case, until)
    })
}

fn acceleration(case: &Case, t: f64) -> [f64; 2] {
    case.plane.coefficients(t).map(|series| series[0])
}

/// Not a number if (1) leads to none.
fn by_the_law(case: &Case, until: f64) -> [f64; 2] {
    let rate = |_: f64, y: &[f64; 3]| {
        let a = acceleration(case, y[2]);
        let rate = printed::eq1_velocity_rate(a, case.friction / GRAVITY, GRAVITY, [y[0], y[1]]);
        [rate[0], rate[1], 1.0]
    };
    let [vx, vy] = case.start.v;
    let end = dop853::end(rate, 0.0, [vx, vy, 0.0], until, 1e-13, 1e-14);
    end.map_or([f64::NAN; 2], |[x, y, _]| [x, y])
}

/// V − U by friction alone.
fn in_the_laboratory(case: &Case, until: f64) -> Result<[f64; 2], Failure> {
    // State: V, then U, then the time, all in the laboratory.
    let rate = |_: f64, y: &[f64; 5]| {
        let relative = [y[0] - y[2], y[1] - y[3]];
        let slip = libm::hypot(relative[0], relative[1]);
        let friction = relative.map(|c| -case.friction * c / slip);
        let [ux, uy] = acceleration(case, y[4]);
        [friction[0], friction[1], ux, uy, 1.0]
    };
    let [vx, vy] = case.start.v;
    let begin = [vx, vy, 0.0, 0.0, 0.0];
    let end = dop853::end(rate, 0.0, begin, until, 1e-13, 1e-14)?;
    Ok([end[0] - end[2], end[1] - end[3]])
}

fn eq1_rate(case: &Case, state: &State) -> f64 {
    let a = acceleration(case, state.t);
    let [x, y] = printed::eq1_velocity_rate(a, case.friction / GRAVITY, GRAVITY, state.v);
    x + 2.0 * y
}

fn components(state: &State) -> f64 {
    state.v[0] + 2.0 * state.v[1]
}

fn eq2_rate(case: &Case, state: &State) -> f64 {
    let a = acceleration(case, state.t);
    printed::eq2_speed_rate(a, case.friction / GRAVITY, GRAVITY, state.v)
}

const TIMES: u32 = 17;

/// With differences of fourth order along the motions.
fn followed(
    compared: Compared,
    rate: fn(&Case, &State) -> f64,
    quantity: fn(&State) -> f64,
) -> Evidence {
    Trial::by(Integration, Printed, compared, DIFFERENCES).pairs(cases(), |(case, until)| {
        let motion = run(&case.plane, case.friction, case.start, until)?;
        let look = |n: u32| {
            let state = motion.at(until * f64::from(n) / f64::from(TIMES + 1))?;
            // |A| ≤ 3: a thousandth of the time in which the forces can change the velocity by itself.
            let fastest = 3.0 + case.friction;
            let h = 1e-3 * state.speed() / fastest;
            let at = |k: f64| motion.at(state.t + k * h).map(|s| quantity(&s));
            let found = (8.0 * (at(1.0)? - at(-1.0)?) - (at(2.0)? - at(-2.0)?)) / (12.0 * h);
            Ok(Pair {
                at: format!("{}, t = {:.6}", case.name, state.t),
                stated: rate(&case, &state),
                found,
                scale: fastest,
            })
        };
        (1..=TIMES).map(look).collect()
    })
}

fn summed(
    compared: Compared,
    rate: fn(&Case, &State) -> f64,
    quantity: fn(&State) -> f64,
) -> Evidence {
    Trial::quadrature(Printed, compared).over(cases(), |(case, until)| {
        let motion = run(&case.plane, case.friction, case.start, until)?;
        let along = |t: f64| motion.at(t).map_or(f64::NAN, |state| rate(&case, &state));
        let scale = case.start.speed();
        Ok(Pair {
            at: format!("{}, t = {until:.6}", case.name),
            stated: sum(along, 0.0, until, 1e-13 * scale),
            found: quantity(&motion.end()) - quantity(&case.start),
            scale,
        })
    })
}

pub(super) const NAMES: [&str; 6] = ["A_x", "A_y", "μ", "g", "v_x", "v_y"];

pub(in crate::claims) fn eq1() -> [Expr; 2] {
    let [ax, ay, mu, g, vx, vy] = NAMES.map(symbol);
    printed::eq1_velocity_rate([ax, ay], mu, g, [vx, vy])
}

pub(in crate::claims) fn ring() -> Result<Ring, ExactError> {
    let mut ring = Ring::new();
    let [_, _, _, _, vx, vy] = NAMES.map(|name| ring.symbol(name));
    ring.root(&(vx.pow(2) + vy.pow(2)), 2)?;
    Ok(ring)
}

pub(in crate::claims) fn eq1_proof(formula: [Expr; 2]) -> Proof {
    let title = "(1): the rate of the velocity relative to the plane";
    let setting = || -> Result<Ring, ExactError> {
        let mut ring = ring()?;
        ring.symbols(["U_x", "U_y"]);
        Ok(ring)
    };
    Proof::in_ring(title, setting(), |p| {
        let [ax, ay, mu, g, vx, vy] = NAMES.map(symbol);
        let [x, y] = formula.map(|c| p.read("A component of (1)", c));
        let read = |c: Expr| p.ring().read(c);
        let rates = [
            ("v_x", x?),
            ("v_y", y?),
            ("U_x", read(ax)?),
            ("U_y", read(ay)?),
        ];
        let along = p.ring().along(&rates)?;
        let speed = (vx.squared() + vy.squared()).sqrt();
        for (name, own) in [("U_x", vx), ("U_y", vy)] {
            let seen = p.read("A component of the velocity", symbol(name) + own)?;
            let rate = p.derivative("Its rate", &seen, &along)?;
            p.reads_as(&rate, "friction per mass, against v", -mu * g * own / speed)?;
        }
        Ok(())
    })
}

pub(in crate::claims) fn eq2() -> Expr {
    let [ax, ay, mu, g, vx, vy] = NAMES.map(symbol);
    printed::eq2_speed_rate([ax, ay], mu, g, [vx, vy])
}

pub(in crate::claims) fn eq2_proof(formula: Expr) -> Proof {
    let title = "(2): the rate of the speed";
    Proof::in_ring(title, ring(), |p| {
        let [_, _, _, _, vx, vy] = NAMES.map(symbol);
        let [x, y] = eq1();
        p.rests_on(&eq1_proof([x, y]))?;
        let x = p.read("dv_x/dt by (1)", x)?;
        let y = p.read("dv_y/dt by (1)", y)?;
        let speed = p.read("The speed", (vx.squared() + vy.squared()).sqrt())?;
        let along = p.ring().along(&[("v_x", x), ("v_y", y)])?;
        let rate = p.derivative("Its rate", &speed, &along)?;
        let formula = p.read("The printed rate", formula)?;
        p.equal("The rate is the printed one", &rate, &formula)
    })
}

attempts![
    &EQ1 = Statement::new(
        Printed,
        Compared::one(
            "the velocity's rate in the laboratory, by (1) and the plane's acceleration,",
            "that by friction alone",
        ),
        eq1,
        eq1_proof,
    ),
    // The laboratory knows no inertial force: there V changes by friction alone, which points against V − U, with
    // the plane's velocity U.
    eq1_laboratory = Trial::by(
        Integration,
        Printed,
        [
            r"$\bm v$ of (1), integrated,",
            r"$\bm V-\bm U$ of the laboratory, where friction alone acts, component by component",
        ],
        FOREIGN,
    )
    .pairs(cases(), |(case, until)| {
        let (stated, found) = (by_the_law(&case, until), in_the_laboratory(&case, until)?);
        let pair = |i: usize| Pair {
            at: format!("{}, t = {until:.6}", case.name),
            stated: stated[i],
            found: found[i],
            scale: case.start.speed(),
        };
        Ok([0, 1].map(pair).into())
    }),
    eq1_quadrature = summed(
        Compared::one(
            "the integral of (1), its second component taken twice,",
            "the change of $v_x+2v_y$ of the motion",
        ),
        eq1_rate,
        components
    ),
    eq1_motion = followed(
        Compared::one(
            "(1), its second component taken twice,",
            "the rate of $v_x+2v_y$ of the motion",
        ),
        eq1_rate,
        components
    ),
    &EQ2 = Statement::new(
        Printed,
        Compared::one(
            "(2)",
            r"the rate of $\lvert\bm v\rvert$ by (1), as algebraic functions of the components",
        ),
        eq2,
        eq2_proof,
    ),
    eq2_quadrature = summed(
        Compared::one(
            "the integral of (2) over $t$ along the motion",
            "its change of speed",
        ),
        eq2_rate,
        State::speed
    ),
    eq2_motion = followed(
        Compared::one("(2)", "the rate of the speed of the motion"),
        eq2_rate,
        State::speed,
    )
];
