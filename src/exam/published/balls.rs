//! Balls that slide until they roll.

use super::{
    Case,
    Printed::{Decimal, Fraction},
    Source,
    follow::{Found, cases, sources, zero_of},
};
use crate::exam::ExamError;
use crate::motion::{
    Plane,
    sphere::{Ball, Contact, Sphere, Turning},
};
use std::f64::consts::{FRAC_PI_6, PI, TAU};

sources! {
    FORUMS_BOWLING: "Physics Forums, thread 394359, a bowling ball",
        "the question, with the parts that were solved";
    TVP: "brainly.com, mirrored as answer 29669934, a bowling ball of 14 lb",
        "the answer";
    JISKHA_BALL: "jiskha.com 1337145166, a billiard ball struck below its centre",
        "question and answer";
    BGU: "Ben-Gurion University, pool of exercises, 22_8_422 (a billiard ball with forward English)",
        "the exercise, which states the result";
    BOICHOI: "boichoi.in, page 9863, a ball thrown with backspin",
        "the solution";
    DRAKE: "Drake, multibody/benchmarks/bowling_ball and its test, with numbers of MotionGenesis",
        "both files, at commits a6a76214 and 73023126";
    ASSIGNMENT: "assignmentexpert.com 39726, a sphere that slides",
        "question and answer";
    ASSIGNMENT_WALL: "assignmentexpert.com 155170, a rolling sphere that an elastic wall sends back",
        "question and answer";
    JISKHA_ROLLS: "jiskha.com 1322981027, a ball that slides until it rolls",
        "question and answer";
    UBC: "University of British Columbia, pl-ubc-experiments, Rotational-1",
        "the exercise with its solution, at commit 34d43ba9";
    SCHAUM: "McLean and Nelson, as in Lavitha/Scilab_TBC, example 16-6: a sphere on a slope",
        "the program, at commit 98e421ab; not the book";
    NAKANISHI: "Hiizu Nakanishi, “Sphere Rolling on a Turntable” (2024)",
        "the page";
    FORUMS_TABLE: "Physics Forums, thread 894305, a ball on a turntable",
        "the question and the first answers";
    WOODRUFF: "Woodruff, compare_plate_ball_to_analytical_solution.m, after Weltner 1979",
        "the program; not the paper";
}

const GENESIS: &str = "the last digits are those of an integration; they would be right if the ball slipped faster by 1.4E-7 m/s, perhaps a guard against 0/0";

pub(super) static CASES: [Case; 32] = cases! {
    FORUMS_BOWLING, "a ball of 11 cm with 8.1 m/s, μ = 0.19: acceleration while it slides",
        Decimal("1.86"), "m/s²", || Ok(8.1 - bowled()?.v[0]);
    FORUMS_BOWLING, "the same: angular acceleration",
        Decimal("42.3"), "rad/s²", || Ok(bowled()?.omega[1]);
    TVP, "a ball of 27 in around, radius of gyration 3.28 in, 20 ft/s, μ = 0.2: way until it rolls",
        Decimal("18.6566"), "ft", gyration, "the last digit is cut off instead of rounded";
    JISKHA_BALL, "struck 2R/3 below the centre: when it rolls, in v₀/(μg)",
        Fraction(16, 21), "", || Ok(rolls(-5.0 / 3.0)?.t);
    JISKHA_BALL, "the same: its velocity then, in v₀",
        Decimal("0.238"), "", || Ok(rolls(-5.0 / 3.0)?.v[0]);
    JISKHA_BALL, "the same: kinetic energy lost, in m v₀²",
        Decimal("1.016"), "", || {
            let before = 0.5 + 0.2 * 25.0 / 9.0;
            Ok(before - 0.7 * rolls(-5.0 / 3.0)?.v[0] * rolls(-5.0 / 3.0)?.v[0])
        };
    BGU, "struck 4R/5 above the centre: its final velocity, in v₀",
        Fraction(9, 7), "", || Ok(rolls(2.0)?.v[0]);
    BOICHOI, "thrown with v₀ and a backspin of v₀/R: its final velocity, in v₀",
        Fraction(1, 3), "", || Ok(rolls(-1.0)?.v[0]),
        "it is the velocity of a cylinder; a solid ball, which it names, ends with 3/7";
    DRAKE, "a ball of 6.35 kg with 8 m/s and 8π rad/s about its way, μ = 0.12: when it rolls",
        Decimal("2.054"), "s", drake_rolls, "it is known to 2E-3, as its test says";
    DRAKE, "after 1 s: sideways",
        Decimal("0.188846948"), "m", || Ok(drake(1.0)?.x[1]), GENESIS;
    DRAKE, "after 1 s: forwards",
        Decimal("7.44315099"), "m", || Ok(drake(1.0)?.x[0]), GENESIS;
    DRAKE, "after 1 s: velocity sideways",
        Decimal("0.377693896"), "m/s", || Ok(drake(1.0)?.v[1]), GENESIS;
    DRAKE, "after 1 s: velocity forwards",
        Decimal("6.88630198"), "m/s", || Ok(drake(1.0)?.v[0]), GENESIS;
    DRAKE, "after 1 s: turning about the way sideways",
        Decimal("25.7912332"), "rad/s", || Ok(drake(1.0)?.omega[1]), GENESIS;
    DRAKE, "after 1 s: turning about the way forwards",
        Decimal("-16.3860333"), "rad/s", || Ok(drake(1.0)?.omega[0]), GENESIS;
    DRAKE, "after 2.054 s: sideways",
        Decimal("0.796728926"), "m", || Ok(drake(2.054)?.x[1]), GENESIS;
    DRAKE, "after 2.054 s: forwards",
        Decimal("14.0827022"), "m", || Ok(drake(2.054)?.x[0]);
    DRAKE, "after 2.054 s: velocity sideways",
        Decimal("0.775181741"), "m/s", || Ok(drake(2.054)?.v[1]), GENESIS;
    DRAKE, "after 2.054 s: velocity forwards",
        Decimal("5.71423797"), "m/s", || Ok(drake(2.054)?.v[0]);
    DRAKE, "after 2.054 s: turning about the way sideways",
        Decimal("52.9341173"), "rad/s", || Ok(drake(2.054)?.omega[1]);
    DRAKE, "after 2.054 s: turning about the way forwards",
        Decimal("-7.18093322"), "rad/s", || Ok(drake(2.054)?.omega[0]), GENESIS;
    DRAKE, "after 2.4 s: sideways",
        Decimal("1.06494181"), "m", || Ok(drake(2.4)?.x[1]), GENESIS;
    DRAKE, "after 2.4 s: forwards",
        Decimal("16.0598286"), "m", || Ok(drake(2.4)?.x[0]), GENESIS;
    ASSIGNMENT, "a solid sphere slides with 7 m/s: its velocity when it rolls",
        Decimal("5"), "m/s", || Ok(7.0 * rolls(0.0)?.v[0]);
    ASSIGNMENT_WALL, "it rolled with v: its velocity when it rolls again, in v",
        Fraction(3, 7), "", || Ok(rolls(-1.0)?.v[0]);
    JISKHA_ROLLS, "when it rolls, in v₀/(μg)",
        Fraction(2, 7), "", || Ok(rolls(0.0)?.t);
    UBC, "when it rolls, in v₀/(μg)",
        Fraction(2, 7), "", || Ok(rolls(0.0)?.t);
    SCHAUM, "a sphere of 16.1 lb on a slope of 30°, μ = 0.1: the force of friction",
        Decimal("1.39"), "lb", slides;
    NAKANISHI, "a solid sphere rolls on a turntable: angular velocity of its orbit, in Ω",
        Fraction(2, 7), "", orbit;
    FORUMS_TABLE, "the same",
        Fraction(2, 7), "", orbit;
    WOODRUFF, "the same",
        Fraction(2, 7), "", orbit;
    WOODRUFF, "the same on a tilted turntable: velocity of its drift, in g sin θ/Ω",
        Fraction(5, 2), "", drift;
};

/// After a second.
fn bowled() -> Found<Ball> {
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

fn rolling(sphere: Sphere, start: Ball) -> Found<Ball> {
    let motion = sphere.run(&Plane::constant([0.0; 2]), &start, 1e3)?;
    let mut changes = motion.transitions().iter();
    let change = changes.find(|change| change.to == Contact::Rolling);
    Ok(motion.at(change.ok_or(ExamError::Missing("rolling"))?.t)?)
}

/// The way of a ball with a given radius of gyration until it rolls, in feet.
fn gyration() -> Found {
    let part = 3.28 / (27.0 / TAU);
    let sphere = Sphere {
        mu: 0.2,
        g: 32.2,
        ..Sphere::with_kappa(part * part)
    };
    Ok(rolling(sphere, with(20.0, 0.0))?.x[0])
}

/// The solid ball of velocity 1 and this angular velocity when it begins to roll, μg = R = 1.
fn rolls(turning: f64) -> Found<Ball> {
    rolling(Sphere::with_kappa(0.4), with(1.0, turning))
}

/// Drake's ball: its z is our first direction, its x the second, its y points up.
const DRAKE_BALL: Sphere = Sphere {
    mass: 6.35,
    radius: 0.10795,
    inertia: 0.0296,
    mu: 0.12,
    g: 9.8,
};

fn drake(until: f64) -> Found<Ball> {
    Ok(DRAKE_BALL
        .run(&Plane::constant([0.0; 2]), &drake_start(), until)?
        .end())
}

fn drake_rolls() -> Found {
    Ok(rolling(DRAKE_BALL, drake_start())?.t)
}

fn drake_start() -> Ball {
    Ball {
        omega: [-8.0 * PI, 0.0, 0.0],
        ..with(8.0, 0.0)
    }
}

/// What friction takes from the weight of a sphere that slides down a slope of 30°.
fn slides() -> Found {
    let (radius, mass) = (0.5, 16.1 / 32.2);
    let sphere = Sphere {
        mass,
        radius,
        inertia: 0.4 * mass * radius * radius,
        mu: 0.1,
        g: 32.2 * libm::cos(FRAC_PI_6),
    };
    let along = 0.5 * 32.2;
    let end = sphere
        .run(&Plane::constant([-along, 0.0]), &with(0.0, 0.0), 1.0)?
        .end();
    Ok(mass * (along - end.v[0]))
}

/// A ball on a turntable of angular velocity 1: half an orbit reverses its velocity.
fn orbit() -> Found {
    let table = Turning {
        omega: 1.0,
        pull: [0.0; 2],
    };
    let path = table.roll(&Sphere::with_kappa(0.4), [[1.0, 0.0], [0.5, 0.0]], 14.0)?;
    Ok(PI / zero_of(|t| Ok(path.at(t)?[3]), 8.0, 14.0)?)
}

/// How fast a pull drives it away, over an orbit that starts at rest.
fn drift() -> Found {
    let (pull, lasts) = (0.1, TAU / orbit()?);
    let table = Turning {
        omega: 1.0,
        pull: [pull, 0.0],
    };
    let path = table.roll(&Sphere::with_kappa(0.4), [[0.0; 2]; 2], lasts)?;
    Ok(libm::hypot(path.end[0], path.end[1]) / (lasts * pull))
}
