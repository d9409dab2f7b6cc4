//! The cases, each with the motion that it asks for.

use super::Printed::{Decimal, Formula, Fraction};
use super::{Case, Source};
use crate::exam::ExamError;
use crate::motion::drive::{Drive, DriveState, Friction};
use crate::motion::sphere::{Ball, Contact, Sphere};
use crate::motion::spring::{Spring, SpringState};
use crate::motion::turntable::{self, Table, rotating};
use crate::motion::{Motion, Plane, Signal, State, run, run_to_stop};
use crate::numerics::roots::root;
use std::f64::consts::{FRAC_PI_4, PI, TAU};

static NEWTON: Source = Source {
    title: "Newton (the physics engine), newton/tests/test_rigid_friction_ramp.py",
    read: "the file, at commit 00e7f285",
};
static SICONOS: Source = Source {
    title: "Siconos tutorials, examples/mechanics/FrictionOscillator: program and reference file",
    read: "the program, and the rows of the .ref file about the stop and at the end, at commit 0472c74e",
};
static PYSLAMMER: Source = Source {
    title: "pySLAMMER, src/pyslammer/analytical_sliding_block.py",
    read: "the file, at commit dd8cfad; its function find_harmonic_solution was run, g = 9.81",
};
static M8: Source = Source {
    title: "“M8. Numerical Examples with GTest Mappings”, a design note of a rigid-body engine on GitHub",
    read: "examples 1 to 3 and a part of 4 and 5; the index does not name the repository",
};
static PHYSICS_IT: Source = Source {
    title: "physics.it.com, “Stopping distance on rough floor”",
    read: "an excerpt with the solution",
};
static NETHERCRAFT: Source = Source {
    title: "nethercraft.net, “A hockey puck is given an initial speed of 16m/s”",
    read: "question and answers",
};
static GUELPH: Source = Source {
    title: "University of Guelph, Problem 6-7, “Friction coefficient”",
    read: "the problem and the first steps of the solution",
};
static QAMMUNITY_TRUCK: Source = Source {
    title: "qammunity.org 12101900, a box on a truck",
    read: "question and answer",
};
static FILO: Source = Source {
    title: "askfilo.com, “A block is on a horizontal surface (a shake table)”",
    read: "question and answer",
};
static QAMMUNITY_TABLE: Source = Source {
    title: "qammunity.org 21459856, a block on a vibration table",
    read: "question and answer",
};
static FORUMS_CRATE: Source = Source {
    title: "Physics Forums, thread 436767, a crate on a flatbed truck",
    read: "the question and the first answers",
};
static GRADESAVER: Source = Source {
    title: "GradeSaver on College Physics, 4th edition, chapter 5, problem 83",
    read: "the solution",
};
static JISKHA_COIN: Source = Source {
    title: "jiskha.com 1271214338, a coin on a turntable",
    read: "question and answer",
};
static FORUMS_BOWLING: Source = Source {
    title: "Physics Forums, thread 394359, a bowling ball",
    read: "the question, with the parts that were solved",
};
static TVP: Source = Source {
    title: "brainly.com, mirrored as answer 29669934, a bowling ball of 14 lb",
    read: "the answer",
};
static JISKHA_BALL: Source = Source {
    title: "jiskha.com 1337145166, a billiard ball struck below its centre",
    read: "question and answer",
};
static BGU: Source = Source {
    title: "Ben-Gurion University, pool of exercises, 22_8_422 (a billiard ball with forward English)",
    read: "the exercise, which states the result",
};
static BOICHOI: Source = Source {
    title: "boichoi.in, page 9863, a ball thrown with backspin",
    read: "the solution",
};

/// What stands twice: a case without a reason, since none is needed.
macro_rules! case {
    ($source:ident, $asked:literal, $printed:expr, $unit:literal, $ours:expr) => {
        case!($source, $asked, $printed, $unit, $ours, "")
    };
    ($source:ident, $asked:literal, $printed:expr, $unit:literal, $ours:expr, $why:literal) => {
        Case {
            source: &$source,
            asked: $asked,
            printed: $printed,
            unit: $unit,
            why: $why,
            ours: $ours,
        }
    };
}

/// All cases.
pub static CASES: [Case; 34] = [
    case!(
        NEWTON,
        "a box with 2 m/s and μ = 0.2: way to the stop",
        Formula("v₀²/(2μg), g = 9.81", 4.0 / (2.0 * 0.2 * 9.81)),
        "m",
        || stop(2.0, 0.2 * 9.81).map(way)
    ),
    case!(
        NEWTON,
        "the same with μ = 0.4",
        Formula("v₀²/(2μg)", 4.0 / (2.0 * 0.4 * 9.81)),
        "m",
        || stop(2.0, 0.4 * 9.81).map(way)
    ),
    case!(
        NEWTON,
        "the same with μ = 0.7",
        Formula("v₀²/(2μg)", 4.0 / (2.0 * 0.7 * 9.81)),
        "m",
        || stop(2.0, 0.7 * 9.81).map(way)
    ),
    case!(
        SICONOS,
        "a block on a spring, x″ = −x − sgn x′ from x = 12, x′ = 6: where it comes to rest",
        Decimal("0.6820441351954105"),
        "",
        || Ok(spring_at_rest()?.x),
        "the file is what a time step of 0.01 gives, and serves as reference to 1e-12; exact is 15 − √205, reached at t = 7π + arctan(6/13)"
    ),
    case!(
        PYSLAMMER,
        "a block that slides one way, sin 2πft of g at f = 1 Hz, yield 0.1 g: slip in a cycle",
        Decimal("1.1821792101"),
        "m",
        || newmark(1.0, 0.1)
    ),
    case!(
        PYSLAMMER,
        "the same, yield 0.2 g",
        Decimal("0.8914483478"),
        "m",
        || newmark(1.0, 0.2)
    ),
    case!(
        PYSLAMMER,
        "the same, yield 0.4 g",
        Decimal("0.4666522534"),
        "m",
        || newmark(1.0, 0.4)
    ),
    case!(
        PYSLAMMER,
        "the same, yield 0.6 g",
        Decimal("0.1959027452"),
        "m",
        || newmark(1.0, 0.6)
    ),
    case!(
        PYSLAMMER,
        "the same, yield 0.8 g",
        Decimal("0.0466650990"),
        "m",
        || newmark(1.0, 0.8)
    ),
    case!(
        PYSLAMMER,
        "f = 0.5 Hz, yield 0.1 g",
        Decimal("4.7287168402"),
        "m",
        || newmark(0.5, 0.1)
    ),
    case!(
        PYSLAMMER,
        "f = 10 Hz, yield 0.8 g",
        Decimal("0.00046665099"),
        "m",
        || newmark(10.0, 0.8)
    ),
    case!(
        M8,
        "a block on a slope of 45° with μ = 0.3: acceleration, by forces",
        Decimal("4.855"),
        "m/s²",
        slope,
        "the forces in it are rounded to two decimals; its other way gives 4.856"
    ),
    case!(
        M8,
        "the same by the formula",
        Decimal("4.856"),
        "m/s²",
        slope
    ),
    case!(
        M8,
        "a block with 10 m/s and μ = 0.5: way to the stop",
        Decimal("10.19"),
        "m",
        || stop(10.0, 4.905).map(way)
    ),
    case!(M8, "the same: time", Decimal("2.039"), "s", || stop(
        10.0, 4.905
    )
    .map(|end| end.t)),
    case!(
        PHYSICS_IT,
        "a puck with 20 m/s, μ = 0.5, g = 9.807: time to the stop",
        Decimal("4.08"),
        "s",
        || stop(20.0, 0.5 * 9.807).map(|end| end.t)
    ),
    case!(PHYSICS_IT, "the same: way", Decimal("40.79"), "m", || stop(
        20.0,
        0.5 * 9.807
    )
    .map(way)),
    case!(
        NETHERCRAFT,
        "a puck with 16 m/s stops after 60 m: μ, first answer",
        Decimal("0.217"),
        "",
        || friction_that_stops(16.0, 60.0).map(|f| f / 9.81)
    ),
    case!(
        NETHERCRAFT,
        "the same, second answer",
        Decimal("0.05"),
        "",
        || friction_that_stops(16.0, 60.0).map(|f| f / 9.81),
        "a slip of arithmetic: 2.14/9.81 is not 0.05"
    ),
    case!(
        GUELPH,
        "a puck with 11 m/s stops after 33 m: acceleration",
        Decimal("-1.83"),
        "m/s²",
        || friction_that_stops(11.0, 33.0).map(|f| -f)
    ),
    case!(
        QAMMUNITY_TRUCK,
        "a truck starts with 2 m/s²; box with μ_k = 0.1, 5 m from the rear: when it falls",
        Decimal("3.13"),
        "s",
        || slid(2.0, 0.98, 5.0)
    ),
    case!(
        FILO,
        "a table shaken at 1.91 Hz, μ = 0.538: largest amplitude without slip",
        Decimal("0.0366"),
        "m",
        || amplitude(1.91, 0.538)
    ),
    case!(
        QAMMUNITY_TABLE,
        "a table shaken at 2.10 Hz, μ = 0.55: largest amplitude without slip",
        Decimal("0.031"),
        "m",
        || amplitude(2.10, 0.55)
    ),
    case!(
        FORUMS_CRATE,
        "a crate with μ_s = 0.3: largest acceleration without slip",
        Decimal("3"),
        "m/s²",
        || held(0.3 * 9.8)
    ),
    case!(
        GRADESAVER,
        "a coin with μ = 0.1 on a table of 33.3 rpm: largest distance without slip",
        Decimal("8.05"),
        "cm",
        || coin(33.3 * TAU / 60.0, 0.98).map(|r| 100.0 * r),
        "the angular velocity in it is rounded to 3.49 rad/s"
    ),
    case!(
        JISKHA_COIN,
        "a coin at 15 cm slips at 5.6 rad/s: μ, without the small tangential part",
        Decimal("0.48"),
        "",
        || coin_friction(0.15, 5.6).map(|f| f / 9.8)
    ),
    case!(
        FORUMS_BOWLING,
        "a ball of 11 cm with 8.1 m/s, μ = 0.19: acceleration while it slides",
        Decimal("1.86"),
        "m/s²",
        || Ok(8.1 - bowled()?.v[0])
    ),
    case!(
        FORUMS_BOWLING,
        "the same: angular acceleration",
        Decimal("42.3"),
        "rad/s²",
        || Ok(bowled()?.omega[1])
    ),
    case!(
        TVP,
        "a ball of 27 in around, radius of gyration 3.28 in, 20 ft/s, μ = 0.2: way until it rolls",
        Decimal("18.6566"),
        "ft",
        gyration,
        "the last digit is cut off instead of rounded"
    ),
    case!(
        JISKHA_BALL,
        "struck 2R/3 below the centre: when it rolls, in v₀/(μg)",
        Fraction(16, 21),
        "",
        || Ok(rolls(-5.0 / 3.0)?.t)
    ),
    case!(
        JISKHA_BALL,
        "the same: its velocity then, in v₀",
        Decimal("0.238"),
        "",
        || Ok(rolls(-5.0 / 3.0)?.v[0])
    ),
    case!(
        JISKHA_BALL,
        "the same: kinetic energy lost, in m v₀²",
        Decimal("1.016"),
        "",
        || {
            let before = 0.5 + 0.2 * 25.0 / 9.0;
            Ok(before - 0.7 * rolls(-5.0 / 3.0)?.v[0] * rolls(-5.0 / 3.0)?.v[0])
        }
    ),
    case!(
        BGU,
        "struck 4R/5 above the centre: its final velocity, in v₀",
        Fraction(9, 7),
        "",
        || Ok(rolls(2.0)?.v[0])
    ),
    case!(
        BOICHOI,
        "thrown with v₀ and a backspin of v₀/R: its final velocity, in v₀",
        Fraction(1, 3),
        "",
        || Ok(rolls(-1.0)?.v[0]),
        "it is the velocity of a cylinder; a solid ball, which it names, ends with 3/7"
    ),
];

/// A body that starts with `v` along x, under a pull along x, until it stops.
fn stop(v: f64, friction: f64) -> Result<State, ExamError> {
    let start = moving(v);
    Ok(run_to_stop(&Plane::constant([0.0; 2]), friction, start, 1e6)?.end())
}

fn moving(v: f64) -> State {
    State {
        t: 0.0,
        v: [v, 0.0],
        x: [0.0; 2],
    }
}

fn way(end: State) -> f64 {
    end.x[0]
}

fn pulled(pull: f64, friction: f64, until: f64) -> Result<Motion, ExamError> {
    Ok(run(
        &Plane::constant([-pull, 0.0]),
        friction,
        moving(0.0),
        until,
    )?)
}

/// g sin − μ g cos at 45° and μ = 0.3, read off the velocity after a second.
fn slope() -> Result<f64, ExamError> {
    let along = 9.81 * libm::sin(FRAC_PI_4);
    Ok(pulled(along, 0.3 * along, 1.0)?.end().v[0])
}

/// A root of something that may fail.
fn solve(
    mut f: impl FnMut(f64) -> Result<f64, ExamError>,
    low: f64,
    high: f64,
) -> Result<f64, ExamError> {
    let mut failed = None;
    let found = root(
        |x| {
            f(x).unwrap_or_else(|error| {
                failed = Some(error);
                f64::NAN
            })
        },
        low,
        high,
    );
    match failed {
        Some(error) => Err(error),
        None => Ok(found?),
    }
}

/// The μg that stops a body of velocity `v` after this way.
fn friction_that_stops(v: f64, after: f64) -> Result<f64, ExamError> {
    solve(|friction| Ok(way(stop(v, friction)?) - after), 0.1, 100.0)
}

/// When a body at rest has slid this far.
fn slid(pull: f64, friction: f64, far: f64) -> Result<f64, ExamError> {
    let motion = pulled(pull, friction, 100.0)?;
    solve(|t| Ok(motion.at(t)?.x[0] - far), 0.0, 100.0)
}

/// The border between bodies that stay and bodies that move, to 10⁻⁹ of its size, more than any of the sources has.
fn border(
    moved: impl Fn(f64) -> Result<bool, ExamError>,
    mut low: f64,
    mut high: f64,
) -> Result<f64, ExamError> {
    let of_low = moved(low)?;
    while high - low > 1e-9 * high {
        let middle = 0.5 * (low + high);
        match moved(middle)? == of_low {
            true => low = middle,
            false => high = middle,
        }
    }
    Ok(0.5 * (low + high))
}

/// The largest amplitude of a shaken table on which a block does not move in a period.
fn amplitude(frequency: f64, mu: f64) -> Result<f64, ExamError> {
    let omega = TAU * frequency;
    let moved = |amplitude: f64| {
        let sine = Signal::Sine {
            frequency: omega,
            phase: 0.0,
        };
        let plane = Plane::along([amplitude * omega * omega, 0.0], sine);
        let motion = run(&plane, mu * 9.8, moving(0.0), 1.0 / frequency)?;
        Ok(!motion.starts().is_empty())
    };
    border(moved, 0.01, 0.1)
}

/// The largest pull that friction holds.
fn held(friction: f64) -> Result<f64, ExamError> {
    border(
        |pull| Ok(!pulled(pull, friction, 1.0)?.starts().is_empty()),
        1.0,
        10.0,
    )
}

/// Whether a coin put down on a turning table moves.
fn goes(omega: f64, friction: f64, radius: f64) -> Result<bool, ExamError> {
    let table = Table {
        omega,
        mu: 1.0,
        g: friction,
        mass: 1.0,
    };
    let start = turntable::State {
        t: 0.0,
        x: [radius, 0.0],
        v: [0.0; 2],
    };
    let path = rotating::run(&table, &start, 0.1)?;
    Ok(path.on_table(0.1)?.speed() > 0.0)
}

/// The largest distance from the axis at which friction holds a coin.
fn coin(omega: f64, friction: f64) -> Result<f64, ExamError> {
    border(|radius| goes(omega, friction, radius), 0.01, 1.0)
}

/// The least μg that holds a coin.
fn coin_friction(radius: f64, omega: f64) -> Result<f64, ExamError> {
    border(|friction| goes(omega, friction, radius), 1.0, 10.0)
}

/// A block on a spring, until it rests.
fn spring_at_rest() -> Result<SpringState, ExamError> {
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

/// The slip in a cycle of sin 2πft of g, where nothing moves the block back.
fn newmark(frequency: f64, yields: f64) -> Result<f64, ExamError> {
    let drive = Drive::new(libm::sin, &[])?;
    let start = DriveState { phi: 0.0, w: 0.0 };
    let outcome = drive.attractor(Friction::new(yields, 2.0)?, start, 100)?;
    let settled = outcome
        .settled()
        .ok_or(ExamError::Missing("a motion that repeats"))?;
    let omega = TAU * frequency;
    Ok(settled.displacement() * 9.81 / (omega * omega))
}

/// The bowling ball after a second.
fn bowled() -> Result<Ball, ExamError> {
    let sphere = Sphere {
        mass: 1.0,
        radius: 0.11,
        inertia: 0.4 * 0.11 * 0.11,
        mu: 0.19,
        g: 9.8,
    };
    Ok(sphere
        .run(&Plane::constant([0.0; 2]), &with(8.1, 0.0), 1.0)?
        .end())
}

fn with(v: f64, turning: f64) -> Ball {
    Ball {
        t: 0.0,
        x: [0.0; 2],
        v: [v, 0.0],
        omega: [0.0, turning, 0.0],
    }
}

/// The state in which a ball of these properties begins to roll.
fn rolling(sphere: Sphere, start: Ball) -> Result<Ball, ExamError> {
    let motion = sphere.run(&Plane::constant([0.0; 2]), &start, 1e3)?;
    let mut changes = motion.transitions().iter();
    let change = changes.find(|change| change.to == Contact::Rolling);
    Ok(motion.at(change.ok_or(ExamError::Missing("rolling"))?.t)?)
}

/// The way of a ball with a given radius of gyration until it rolls, in feet.
fn gyration() -> Result<f64, ExamError> {
    let part = 3.28 / (27.0 / TAU);
    let sphere = Sphere {
        mu: 0.2,
        g: 32.2,
        ..Sphere::with_kappa(part * part)
    };
    Ok(rolling(sphere, with(20.0, 0.0))?.x[0])
}

/// The solid ball of velocity 1 and this angular velocity when it begins to roll, μg = R = 1.
fn rolls(turning: f64) -> Result<Ball, ExamError> {
    rolling(Sphere::with_kappa(0.4), with(1.0, turning))
}
