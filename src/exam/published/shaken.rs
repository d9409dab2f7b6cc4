//! Bodies on tables that shake or turn.

use super::{
    Case,
    Printed::{Decimal, Formula},
    Source,
    follow::{Found, border, cases, moving, sources},
};
use crate::motion::{
    Plane, Signal, Spring, SpringState, run,
    turntable::{self, Table, rotating},
};
use std::f64::consts::TAU;

sources! {
    FILO: "askfilo.com, “A block is on a horizontal surface (a shake table)”",
        "question and answer";
    QAMMUNITY_TABLE: "qammunity.org 21459856, a block on a vibration table",
        "question and answer";
    GRADESAVER: "GradeSaver on College Physics, 4th edition, chapter 5, problem 83",
        "the solution";
    JISKHA_COIN: "jiskha.com 1271214338, a coin on a turntable",
        "question and answer";
    CODE_ASTER: "code_aster, astest/sdnd104a.comm: wear of a mass on a plate that shakes",
        "the command file, at commit 17417dda, whose values called analytical leave out its spring of 3E-5 N/m";
    FORUMS_COIN: "Physics Forums, thread 52910, a coin on a turntable",
        "question and answers";
}

pub(super) static CASES: [Case; 9] = cases! {
    FILO, "a table shaken at 1.91 Hz, μ = 0.538: largest amplitude without slip",
        Decimal("0.0366"), "m", || amplitude(1.91, 0.538);
    QAMMUNITY_TABLE, "a table shaken at 2.10 Hz, μ = 0.55: largest amplitude without slip",
        Decimal("0.031"), "m", || amplitude(2.10, 0.55);
    GRADESAVER, "a coin with μ = 0.1 on a table of 33.3 rpm: largest distance without slip",
        Decimal("8.05"), "cm", || coin(33.3 * TAU / 60.0, 0.98).map(|r| 100.0 * r),
        "the angular velocity in it is rounded to 3.49 rad/s";
    JISKHA_COIN, "a coin at 15 cm slips at 5.6 rad/s: μ, without the small tangential part",
        Decimal("0.48"), "", || coin_friction(0.15, 5.6).map(|f| f / 9.8);
    CODE_ASTER, "1 kg pressed with 10 N on a plate with 15 m/s² sin 2πt, μ = 0.1: normal force times slip in a second, from 4 s to 12 s",
        Decimal("15.2671"), "W", || wear(15.0);
    CODE_ASTER, "the same with 1.5 m/s²",
        Decimal("0.409062"), "W", || wear(1.5);
    CODE_ASTER, "the same with 1.01 m/s²",
        Decimal("2.26164E-4"), "W", || wear(1.01);
    CODE_ASTER, "the same with 0.99 m/s²",
        Formula("0", 0.0), "W", || wear(0.99);
    FORUMS_COIN, "a coin at 10 cm slips at 36 rpm: μ",
        Decimal("0.145"), "", || coin_friction(0.1, 36.0 * TAU / 60.0).map(|f| f / 9.8);
};

/// On which a block does not move in a period.
fn amplitude(frequency: f64, mu: f64) -> Found {
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

fn goes(omega: f64, friction: f64, radius: f64) -> Found<bool> {
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
fn coin(omega: f64, friction: f64) -> Found {
    border(|radius| goes(omega, friction, radius), 0.01, 1.0)
}

/// The least μg that holds a coin.
fn coin_friction(radius: f64, omega: f64) -> Found {
    border(|friction| goes(omega, friction, radius), 1.0, 10.0)
}

/// A mass pressed with 10 N on a plate with the acceleration a sin 2πt, μ = 0.1: normal force times
/// slip between t = 4 and 12, for a second.
fn wear(a: f64) -> Found {
    let spring = Spring {
        frequency: 0.0,
        friction: 1.0,
    };
    let start = SpringState {
        t: 0.0,
        x: 0.0,
        v: 0.0,
    };
    let sine = Signal::Sine {
        frequency: TAU,
        phase: 0.0,
    };
    let pull = Signal::Product(vec![Signal::constant(a), sine]);
    let slipped = |until: f64| -> Found {
        let motion = spring.run(&pull, start, until)?;
        let places = motion.turns.iter().chain([&motion.end]);
        let (way, _) = places.fold((0.0, start.x), |(way, x), place| {
            (way + (place.x - x).abs(), place.x)
        });
        Ok(way)
    };
    Ok(10.0 * (slipped(12.0)? - slipped(4.0)?) / 8.0)
}
