//! Blocks on floors, slopes, trucks and springs.

use super::{
    Case,
    Printed::{Decimal, Formula},
    Source,
    follow::{Found, border, cases, moving, sources, zero_of},
};
use crate::exam::ExamError;
use crate::motion::{Motion, Plane, Signal, Spring, SpringState, State, run, run_to_stop};
use std::f64::consts::{FRAC_1_SQRT_2, FRAC_PI_4, PI, SQRT_2, TAU};

sources! {
    NEWTON: "Newton (the physics engine), newton/tests/test_rigid_friction_ramp.py",
        "the file, at commit 00e7f285";
    SICONOS: "Siconos tutorials, examples/mechanics/FrictionOscillator: program and reference file",
        "the program, and the rows of the .ref file about the stop and at the end, at commit 0472c74e";
    M8: "“M8. Numerical Examples with GTest Mappings”, a design note of a rigid-body engine on GitHub",
        "examples 1 to 3 and a part of 4 and 5; the index does not name the repository";
    PHYSICS_IT: "physics.it.com, “Stopping distance on rough floor”",
        "an excerpt with the solution";
    NETHERCRAFT: "nethercraft.net, “A hockey puck is given an initial speed of 16m/s”",
        "question and answers";
    GUELPH: "University of Guelph, Problem 6-7, “Friction coefficient”",
        "the problem and the first steps of the solution";
    QAMMUNITY_TRUCK: "qammunity.org 12101900, a box on a truck",
        "question and answer";
    FORUMS_CRATE: "Physics Forums, thread 436767, a crate on a flatbed truck",
        "the question and the first answers";
    ABAQUS: "Abaqus 6.6 Verification Manual, VFRIC: frictional heating",
        "the page, whose text has lost the minus signs of its exponents";
    CODE_ASTER: "code_aster, astest/sdnd100a.comm: a mass on springs, let go on a rough plane (V5.01.100)",
        "the command file, at commit 162067d8, where the numbers are called analytical";
    DEN_HARTOG: "DenHartogHarmonic.m, after Den Hartog as in Marino and Cicirello 2020 (doi 10.1007/s11071-019-05443-2)",
        "the program; not the papers";
    JISKHA_TRUCK: "jiskha.com 1253755050, a box on a truck",
        "question and answer";
    JISKHA_TWO: "jiskha.com 1351374613, a box on a truck with two coefficients of friction",
        "question and answer";
    JISKHA_BOX: "jiskha.com 1317417147, a box on a truck",
        "question and answer";
}

pub(super) static CASES: [Case; 28] = cases! {
    NEWTON, "a box with 2 m/s and μ = 0.2: way to the stop",
        Formula("v₀²/(2μg), g = 9.81", 4.0 / (2.0 * 0.2 * 9.81)), "m", || stop(2.0, 0.2 * 9.81).map(way);
    NEWTON, "the same with μ = 0.4",
        Formula("v₀²/(2μg)", 4.0 / (2.0 * 0.4 * 9.81)), "m", || stop(2.0, 0.4 * 9.81).map(way);
    NEWTON, "the same with μ = 0.7",
        Formula("v₀²/(2μg)", 4.0 / (2.0 * 0.7 * 9.81)), "m", || stop(2.0, 0.7 * 9.81).map(way);
    SICONOS, "a block on a spring, x″ = −x − sgn x′ from x = 12, x′ = 6: where it comes to rest",
        Decimal("0.6820441351954105"), "", || Ok(spring_at_rest()?.x),
        "the file is what a time step of 0.01 gives, and serves as reference to 1e-12; exact is 15 − √205, reached at t = 7π + arctan(6/13)";
    M8, "a block on a slope of 45° with μ = 0.3: acceleration, by forces",
        Decimal("4.855"), "m/s²", slope, "the forces in it are rounded to two decimals; its other way gives 4.856";
    M8, "the same by the formula",
        Decimal("4.856"), "m/s²", slope;
    M8, "a block with 10 m/s and μ = 0.5: way to the stop",
        Decimal("10.19"), "m", || stop(10.0, 4.905).map(way);
    M8, "the same: time",
        Decimal("2.039"), "s", || stop(10.0, 4.905).map(|end| end.t);
    PHYSICS_IT, "a puck with 20 m/s, μ = 0.5, g = 9.807: time to the stop",
        Decimal("4.08"), "s", || stop(20.0, 0.5 * 9.807).map(|end| end.t);
    PHYSICS_IT, "the same: way",
        Decimal("40.79"), "m", || stop(20.0, 0.5 * 9.807).map(way);
    NETHERCRAFT, "a puck with 16 m/s stops after 60 m: μ, first answer",
        Decimal("0.217"), "", || friction_that_stops(16.0, 60.0).map(|f| f / 9.81);
    NETHERCRAFT, "the same, second answer",
        Decimal("0.05"), "", || friction_that_stops(16.0, 60.0).map(|f| f / 9.81),
        "a slip of arithmetic: 2.14/9.81 is not 0.05";
    GUELPH, "a puck with 11 m/s stops after 33 m: acceleration",
        Decimal("-1.83"), "m/s²", || friction_that_stops(11.0, 33.0).map(|f| -f);
    QAMMUNITY_TRUCK, "a truck starts with 2 m/s²; box with μ_k = 0.1, 5 m from the rear: when it falls",
        Decimal("3.13"), "s", || slid(2.0, 0.98, 5.0);
    FORUMS_CRATE, "a crate with μ_s = 0.3: largest acceleration without slip",
        Decimal("3"), "m/s²", || held(0.3 * 9.8);
    ABAQUS, "a block with 200 in/s, stopped by a stress of 300 psi on a height of 1 in, density 7.3E-4 lb s²/in⁴: deceleration",
        Decimal("4.109589E5"), "in/s²", || Ok(200.0 / stop(200.0, RUBBED)?.t);
    ABAQUS, "the same: way to the stop",
        Decimal("4.866E-2"), "in", || stop(200.0, RUBBED).map(way), "the last digit is cut off instead of rounded";
    ABAQUS, "the same: time",
        Decimal("4.866E-4"), "s", || stop(200.0, RUBBED).map(|end| end.t),
        "the last digit is cut off instead of rounded";
    CODE_ASTER, "1 kg on 10⁴ N/m, μg = 1 m/s², let go at 0.85 mm along 45°: one coordinate at the first turn",
        Decimal("-4.596E-4"), "m", || turn(0);
    CODE_ASTER, "the same: at the second",
        Decimal("3.182E-4"), "m", || turn(1);
    CODE_ASTER, "the same: at the third",
        Decimal("-1.768E-4"), "m", || turn(2);
    CODE_ASTER, "the same: at the fourth, where it rests",
        Decimal("3.536E-05"), "m", || turn(3);
    DEN_HARTOG, "a block on a spring shaken at twice its frequency, friction 0.4 of the force: amplitude, in force/stiffness",
        Formula("√(V² − β²U²), V = −1/3, U = 1/2", 4.0 / 15.0), "", || Ok(shaken(2.0, 0.4)?.x.abs());
    DEN_HARTOG, "the same at 2/3 of its frequency",
        Formula("√(V² − β²U²), V = 9/5, U = −3/2", 1.2 * SQRT_2), "", || Ok(shaken(2.0 / 3.0, 0.4)?.x.abs());
    DEN_HARTOG, "at twice its frequency: friction, in the force, from which on it stops for a while at each turn",
        Formula("√(V²/(U² + S²/r⁴)), S = 1", 0.596_284_793_999_943_9), "", || zero_of(|friction| Ok(left_over(2.0, friction)? - friction), 0.55, 0.65);
    JISKHA_TRUCK, "a box with μ_s = 0.3: largest acceleration of the truck without slip",
        Decimal("2.94"), "m/s²", || held(0.3 * 9.8);
    JISKHA_TWO, "μ_s = 0.3, μ_k = 0.1, and a truck that is just too fast: acceleration of the box",
        Decimal("0.98"), "m/s²", || Ok(2.94 - pulled(2.94, 0.98, 1.0)?.end().v[0]);
    JISKHA_BOX, "a box with μ_s = 0.369, g = 9.81: largest acceleration of the truck without slip",
        Decimal("3.62"), "m/s²", || held(0.369 * 9.81);
};

/// Deceleration of a block under a stress of 300 psi, in in/s².
const RUBBED: f64 = 300.0 / 7.3e-4;

/// A body that starts with `v` along x, under a pull along x, until it stops.
fn stop(v: f64, friction: f64) -> Found<State> {
    let start = moving(v);
    Ok(run_to_stop(&Plane::constant([0.0; 2]), friction, start, 1e6)?.end())
}

fn way(end: State) -> f64 {
    end.x[0]
}

fn pulled(pull: f64, friction: f64, until: f64) -> Found<Motion> {
    Ok(run(
        &Plane::constant([-pull, 0.0]),
        friction,
        moving(0.0),
        until,
    )?)
}

/// g sin − μ g cos at 45° and μ = 0.3, read off the velocity after a second.
fn slope() -> Found {
    let along = 9.81 * libm::sin(FRAC_PI_4);
    Ok(pulled(along, 0.3 * along, 1.0)?.end().v[0])
}

/// The μg that stops a body of velocity `v` after this way.
fn friction_that_stops(v: f64, after: f64) -> Found {
    zero_of(|friction| Ok(way(stop(v, friction)?) - after), 0.1, 100.0)
}

/// When a body at rest has slid this far.
fn slid(pull: f64, friction: f64, far: f64) -> Found {
    let motion = pulled(pull, friction, 100.0)?;
    zero_of(|t| Ok(motion.at(t)?.x[0] - far), 0.0, 100.0)
}

fn held(friction: f64) -> Found {
    border(
        |pull| Ok(!pulled(pull, friction, 1.0)?.starts().is_empty()),
        1.0,
        10.0,
    )
}

fn spring_at_rest() -> Found<SpringState> {
    let spring = Spring {
        frequency: 1.0,
        friction: 1.0,
    };
    let start = SpringState {
        t: 0.0,
        x: 12.0,
        v: 6.0,
    };
    let motion = spring.run(&Signal::constant(0.0), start, 10.0 * PI)?;
    let last = motion.turns.last().copied();
    last.ok_or(ExamError::Missing("a stop"))
}

/// The mass of code_aster at its n-th turn: one coordinate, at 45° to its way.
fn turn(n: usize) -> Found {
    let spring = Spring {
        frequency: 100.0,
        friction: 1.0,
    };
    let start = SpringState {
        t: 0.0,
        x: 8.5e-4,
        v: 0.0,
    };
    let motion = spring.run(&Signal::constant(0.0), start, 1.0)?;
    let turn = motion.turns.get(n).ok_or(ExamError::Missing("a turn"))?;
    Ok(turn.x * FRAC_1_SQRT_2)
}

/// The last turn in sixty periods of a force sin rt, on a spring of frequency 1: by then the motion repeats.
fn shaken(r: f64, friction: f64) -> Found<SpringState> {
    let spring = Spring {
        frequency: 1.0,
        friction,
    };
    let start = SpringState {
        t: 0.0,
        x: 0.0,
        v: 0.0,
    };
    let force = Signal::Sine {
        frequency: r,
        phase: 0.0,
    };
    let motion = spring.run(&force, start, 60.0 * TAU / r)?;
    let last = motion.turns.last().copied();
    last.ok_or(ExamError::Missing("a turn"))
}

/// What pulls the block at its turns.
fn left_over(r: f64, friction: f64) -> Found {
    let turn = shaken(r, friction)?;
    Ok((libm::sin(r * turn.t) - turn.x).abs())
}
