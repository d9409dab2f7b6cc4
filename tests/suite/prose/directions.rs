//! Directions, names and causes that the code says, of the words that could stand there, the one of which it is so. Those of the pages are
//! computed where the book is made, `src/edition/words`.

use super::{choices::Held, text::words};
use slipbook::claims::{PAPER, tolerances::VANISHES};
use slipbook::exam::TASKS;
use slipbook::motion::{
    Plane, State, run,
    turntable::{Start, State as Turning, Table, intrinsic::Run, rotating},
};
use slipbook::paper::{
    general, sphere,
    turntable::{eq107_p_rate, eq109_psi_rate},
};
use slipbook::symbols::SYMBOLS;
use std::f64::consts::{PI, SQRT_2};

/// Where it stands; words, with what could stand there in braces; and of each of these whether it is so. Of one alone that the first is.
type Said = (
    &'static str,
    &'static [&'static str],
    &'static [fn() -> bool],
);

macro_rules! said {
    ($($place:literal: $($words:literal),+ => $($holds:expr),+;)*) => {
        const SAID: &[Said] = &[$(($place, &[$($words),+], &[$($holds),+])),*];
    };
}

said! {
    "by hand": "holds only while § stays {away from|close to} zero" =>
        || proportional(1.0) && !proportional(1e-3), || proportional(1e-3) && !proportional(1.0);
    "src/corrections/sphere.rs": "hold only for A = {μg|bμg}" => || printed_time_is_right(1.0), || printed_time_is_right(3.5);
    "src/corrections/rest.rs":
        "at the rate {σ/p, while ln p falls at the rate (1+σ)/p|(1+σ)/p, while ln p falls at the rate σ/p}" =>
        || straight_in([0.7, 1.7]), || straight_in([1.7, 0.7]);
    "tolerances": "falls as the {inverse of|inverse square of} the time" =>
        || same(across(), 0.1, 1e-2), || same(across(), 0.01, 1e-2);
    "meanings": "angle from the {velocity to the position|position to the velocity}" => || angle_is(1.0), || angle_is(-1.0);
    "tasks": "the distance grows as {t²/(3√2)|2t²/9}" =>
        || same(grows(), 1.0 / (3.0 * SQRT_2), 1e-3), || same(grows(), 2.0 / 9.0, 1e-3);
}

/// What the code says: of what is wrong, of the symbols, in the exam, in the comments at the top of a file.
fn text_of(name: &str) -> Vec<super::text::Word> {
    let joined = |parts: &mut dyn Iterator<Item = &str>| parts.collect::<Vec<_>>().join(" | ");
    words(&match name {
        "by hand" => joined(
            &mut PAPER
                .cases()
                .flat_map(|(_, case)| [case.wrong, case.reason, case.case]),
        ),
        "meanings" => joined(&mut SYMBOLS.iter().map(|symbol| symbol.meaning)),
        "tasks" => joined(&mut TASKS.iter().flat_map(|task| [task.setup, task.question])),
        "tolerances" => VANISHES.reason.to_owned(),
        _ => std::fs::read_to_string(name).unwrap_or_default(),
    })
}

#[test]
fn of_what_a_sentence_could_say_it_says_what_is_so() {
    let mut held = Held::default();
    for (name, patterns, holds) in SAID {
        let true_of: Vec<bool> = holds.iter().map(|holds| holds()).collect();
        if true_of.len() > 1 && true_of.iter().filter(|holds| **holds).count() != 1 {
            let both = format!("{name}: {true_of:?} of {patterns:?}");
            held.wrong.push(both);
        }
        // Of several one is so, of one alone that the first is.
        let right = |choice: usize| true_of.get(choice).copied().unwrap_or(!true_of[0]);
        for pattern in *patterns {
            held.hold(name, &text_of(name), pattern, right);
        }
    }
    held.end();
}

fn same(a: f64, b: f64, tolerance: f64) -> bool {
    (a - b).abs() <= tolerance * b.abs()
}
/// Whether friction across the drive is proportional to a small velocity across, beside this one along.
fn proportional(along: f64) -> bool {
    let v = [along, 1e-2];
    let [_, friction] = general::eq1_velocity_rate([0.0; 2], 1.0, 1.0, v);
    same(friction, -v[1] / along, 1e-2)
}

/// Whether (82) is when the ball's slip has turned, under this pull in units of μg.
fn printed_time_is_right(gamma: f64) -> bool {
    let plane = Plane::constant([-gamma, 0.0]);
    let (v, theta) = ([0.0, 1.0], PI / 2.0 - 0.1);
    let slip = State {
        t: 0.0,
        x: [0.0; 2],
        v,
    };
    let turned = run(&plane, 3.5, slip, 1.0).unwrap();
    let along = turned
        .first_along([theta.cos(), theta.sin()])
        .unwrap()
        .unwrap();
    let printed = sphere::eq82_time(3.5 / gamma, 1.0, PI / 2.0, theta);
    same(printed, along.t, 1e-9)
}

/// Whether these over p are the rates at which a particle that slides straight in turns away from that, and loses ln p.
fn straight_in([turns, slows]: [f64; 2]) -> bool {
    let (sigma, p, h) = (0.7, 1e-3, 1e-4);
    let [before, behind] = [PI - h, PI + h].map(|psi| eq109_psi_rate(p, sigma, psi));
    let away = (behind - before) / 2.0;
    let slower = -eq107_p_rate(sigma, PI);
    same(away * p / h, turns, 1e-2) && same(slower, slows, 1e-9)
}

/// What a tenfold time leaves of the velocity across twice the friction.
fn across() -> f64 {
    let start = State {
        t: 0.0,
        x: [0.0; 2],
        v: [0.0, 1.0],
    };
    let motion = run(&Plane::constant([-2.0, 0.0]), 1.0, start, 1e5).unwrap();
    motion.at(1e5).unwrap().v[1] / motion.at(1e4).unwrap().v[1]
}

/// ρ/τ² at a late time.
fn grows() -> f64 {
    let tau = 1e6;
    let rho = Run::new(&Start::put_down(1.5).unwrap(), tau)
        .unwrap()
        .end()
        .rho();
    rho / (tau * tau)
}

/// Whether (109) is the rate of this many times the angle by which the position is ahead of the velocity.
fn angle_is(sign: f64) -> bool {
    let start = Turning {
        t: 0.0,
        x: [1.1, 0.6],
        v: [0.8, 0.1],
    };
    let h = 1e-6;
    let path = rotating::run(&Table::default(), &start, h).unwrap();
    let angle = |state: &Turning| sign * (state.x[1].atan2(state.x[0]) - state.direction());
    let rate = (angle(&path.at(h).unwrap()) - angle(&start)) / h;
    let printed = eq109_psi_rate(start.speed(), start.radius(), angle(&start));
    same(rate, printed, 1e-4)
}
