//! Names, causes and places on the pages: of several that a sentence could have, the one of which it is true.
//!
//! Each is tried, and all but one have to fail: so the sentence is not repeated here, it is found.

use crate::pages::{flat, pages, spoken};
use slipbook::claims::anisotropic::simulated::attractor;
use slipbook::evidence::{Compared, Evidence, Kind, Route, Subject, Tolerance};
use slipbook::exam::TASKS;
use slipbook::ledger::{Verdict, judge};
use slipbook::motion::drive::{Drive, DriveState, Friction, Sign};
use slipbook::motion::turntable::{Start, State as Turning, Table, intrinsic::Run, rotating};
use slipbook::motion::{Launch, Plane, State, run};
use slipbook::numerics::roots::root;
use slipbook::paper::turntable::{eq107_p_rate, eq109_psi_rate};
use slipbook::paper::{constant, general, periodic, sphere};
use slipbook::symbols::SYMBOLS;
use std::f64::consts::{PI, SQRT_2, TAU};
use std::panic::Location;

/// A page, its words with `{}` (a formula as §), and what could stand there, each with whether it would be true.
type Chosen = (
    &'static str,
    &'static str,
    &'static [(&'static str, fn() -> bool)],
);

const CHOSEN: &[Chosen] = &[
    (
        "general",
        "Project the law onto the direction of {}, and you have the rate of change of the speed",
        &[
            ("motion", || speed_rate_along([0.6, 0.5])),
            ("the pull", || speed_rate_along([0.7, -0.4])),
        ],
    ),
    (
        "general",
        "Go to the laboratory frame, where there is no {} acts",
        &[
            ("inertial force: only friction", || {
                let [v, speed] = [[0.6, 0.5], [0.61_f64.sqrt(); 2]];
                in_the_room([-v[0] / speed[0], -v[1] / speed[1]])
            }),
            ("friction: only the inertial force", || {
                in_the_room([0.7, -0.4])
            }),
        ],
    ),
    (
        "constant",
        "Divide (7) by (6), and the {} drops out",
        &[
            ("time", || same(slope(0.5, 1.0), slope(0.5, 2.0), 1e-5)),
            ("friction", || same(slope(0.5, 1.0), slope(0.9, 1.0), 1e-5)),
        ],
    ),
    (
        "constant",
        "*hodograph*, the path that the tip of the {} vector draws",
        &[
            ("velocity", || hodograph(velocity)),
            ("acceleration", || {
                hodograph(|launch, t| {
                    let [a, b] = [t, t + 1e-4].map(|t| velocity(launch, t));
                    [b[0] - a[0], b[1] - a[1]]
                })
            }),
        ],
    ),
    (
        "constant",
        "it first turns into the direction of the {}.",
        &[
            ("inertial force", || turned(|_| 0.0)),
            ("friction force", || turned(|direction| direction + PI)),
        ],
    ),
    (
        "sinusoidal",
        "For small friction §: the slip lasts for {}.",
        &[
            ("nearly the whole period", || slip(1e-3) > 0.9),
            ("next to no time", || slip(1e-3) < 0.1),
            ("half a period", || (slip(1e-3) - 0.5).abs() < 0.1),
        ],
    ),
    (
        "sinusoidal",
        "Without friction {} is forgotten",
        &[
            ("nothing", || same(left_of_a_difference(), 1.0, 1e-12)),
            ("the start", || left_of_a_difference() < 0.5),
        ],
    ),
    (
        "anisotropic",
        "without any friction the particle {} whatever drift it started with",
        &[
            ("keeps", || same(left_of_a_difference(), 1.0, 1e-12)),
            ("forgets", || left_of_a_difference() < 0.5),
        ],
    ),
    (
        "periodic",
        "pushes along the motion with {} until then",
        &[
            ("full force", || same(stop(1.0), 1.0 / (1.25 - 1.0), 1e-9)),
            ("hardly any force", || {
                same(stop(0.01), 1.0 / (1.25 - 1.0), 1e-9)
            }),
        ],
    ),
    (
        "periodic",
        "during a {} friction cannot hold the particle",
        &[
            ("pulse", || sets_off(0.3 * PI)),
            ("gap", || sets_off(0.8 * PI)),
        ],
    ),
    (
        "anisotropic",
        "apart from zero, where § is {}.",
        &[
            ("stationary", || {
                let [left, right] = [-1e-4, 1e-4].map(|h| (touch() + h).sin() / (touch() + h));
                same(left, right, 1e-8)
            }),
            ("zero", || (touch().sin() / touch()).abs() < 1e-8),
        ],
    ),
    (
        "anisotropic",
        "The drive imparts no net {} over a period",
        &[
            ("velocity", || imparted(|_| 1.0).abs() < 1e-9),
            ("energy", || {
                let motion = attractor(2.0, 0.2).unwrap();
                imparted(|phi| motion.w(phi)).abs() < 1e-9
            }),
        ],
    ),
    (
        "sphere",
        "the normal force exert no torque about the {}.",
        &[
            ("centre", || torque([0.0; 3]) == [0.0; 3]),
            ("contact", || torque(CONTACT) == [0.0; 3]),
        ],
    ),
    (
        "sphere",
        "only that the force acts at the {}.",
        &[
            ("lowest point", || slip_over_centre(CONTACT)),
            ("centre", || slip_over_centre([0.0; 3])),
        ],
    ),
    (
        "turntable",
        "motions differ only in {}.",
        &[
            ("how they start", || {
                let (one, other) = (turning(0.3, 0.5), turning(0.3, 0.6));
                (one - other).abs() > 1e-3 && same(one, turning(0.1, 0.5), 1e-10)
            }),
            ("their friction", || {
                (turning(0.3, 0.5) - turning(0.1, 0.5)).abs() > 1e-3
            }),
        ],
    ),
    (
        "methods",
        "independent when their routes differ {} they have read no motion in common",
        &[
            ("and", || {
                !confirm(Route::Quadrature, true) && !confirm(Route::Integration, false)
            }),
            ("or", || {
                confirm(Route::Quadrature, true) && confirm(Route::Integration, false)
            }),
        ],
    ),
    (
        "proved",
        "a rational function of the {} of half its angle",
        &[
            ("tangent", || decides(f64::tan)),
            ("cosine", || decides(f64::cos)),
            ("sine", || decides(f64::sin)),
        ],
    ),
    (
        "accuracy",
        "limits were taken from times so {} that the omitted terms still showed",
        &[
            ("early", || omitted(1e2) > 10.0 * omitted(1e6)),
            ("late", || omitted(1e6) > 10.0 * omitted(1e2)),
        ],
    ),
    (
        "by hand",
        "proportional to §, holds only while § {} zero",
        &[
            ("stays away from", || {
                proportional(1.0) && !proportional(1e-3)
            }),
            ("stays close to", || {
                proportional(1e-3) && !proportional(1.0)
            }),
        ],
    ),
    (
        "src/corrections/sphere.rs",
        "its formulas hold only for A = {}.",
        &[
            ("μg", || printed_time_is_right(1.0)),
            ("bμg", || printed_time_is_right(3.5)),
        ],
    ),
    (
        "src/corrections/rest.rs",
        "The second one repels, but it does so at the rate {}:",
        &[
            ("σ/p, while ln p falls at the rate (1+σ)/p", || {
                straight_in([0.7, 1.7])
            }),
            ("(1+σ)/p, while ln p falls at the rate σ/p", || {
                straight_in([1.7, 0.7])
            }),
        ],
    ),
    (
        "src/claims/tolerances.rs",
        "under twice the friction, the slowest case, v⊥ falls as the {} of the time",
        &[
            ("inverse", || same(across(), 0.1, 1e-2)),
            ("inverse square", || same(across(), 0.01, 1e-2)),
        ],
    ),
    (
        "symbols",
        "angle from the {}",
        &[
            ("velocity to the position", || angle_is(1.0)),
            ("position to the velocity", || angle_is(-1.0)),
        ],
    ),
    (
        "tasks",
        "In the end the distance grows as {}.",
        &[
            ("t²/(3√2)", || same(grows(), 1.0 / (3.0 * SQRT_2), 1e-3)),
            ("2t²/9", || same(grows(), 2.0 / 9.0, 1e-3)),
        ],
    ),
];

/// A page; or what the code says: of what is wrong, of the symbols, in the exam, in the comments of a file.
fn text_of(page: &str) -> String {
    match page {
        "by hand" => spoken(page),
        _ if page.ends_with(".rs") => {
            let text = std::fs::read_to_string(page).unwrap().replace("//!", "");
            text.split_whitespace().collect::<Vec<_>>().join(" ")
        }
        "symbols" => SYMBOLS
            .iter()
            .map(|s| format!("{} | ", s.meaning))
            .collect(),
        "tasks" => TASKS
            .iter()
            .map(|task| format!("{} {} | ", task.setup, task.question))
            .collect(),
        _ => flat(page),
    }
}

#[test]
fn of_what_a_sentence_could_say_it_says_what_is_true() {
    let mut texts: Vec<(String, String)> = pages()
        .into_iter()
        .map(|page| (page.clone(), flat(&page)))
        .collect();
    for more in ["by hand", "symbols", "tasks"] {
        texts.push((format!("the {more}"), text_of(more)));
    }
    let mut failures = Vec::new();
    for (page, words, names) in CHOSEN {
        let (right, wrong): (Vec<_>, Vec<_>) = names.iter().partition(|(_, holds)| holds());
        let [(right, _)] = right[..] else {
            failures.push(format!(
                "{page}: {} of the names fit in {words:?}",
                right.len()
            ));
            continue;
        };
        let said = words.replace("{}", right);
        if !text_of(page).contains(&said) {
            failures.push(format!("{page}: it should say {said:?}"));
        }
        for (name, _) in wrong {
            let slip = words.replace("{}", name);
            let places = texts.iter().filter(|(_, text)| text.contains(&slip));
            failures.extend(places.map(|(place, _)| format!("{place}: it says {slip:?}")));
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

fn same(a: f64, b: f64, tolerance: f64) -> bool {
    (a - b).abs() <= tolerance * b.abs()
}

/// The rate of a velocity (0.6, 0.5) on a plane with the acceleration (−0.7, 0.4) and the friction 1.
fn rate() -> ([f64; 2], f64) {
    let start = State {
        t: 0.0,
        x: [0.0; 2],
        v: [0.6, 0.5],
    };
    let h = 1e-6;
    let later = run(&Plane::constant([-0.7, 0.4]), 1.0, start, h)
        .unwrap()
        .end();
    let of = |i: usize| (later.v[i] - start.v[i]) / h;
    ([of(0), of(1)], (later.speed() - start.speed()) / h)
}

fn speed_rate_along(direction: [f64; 2]) -> bool {
    let ([x, y], speed) = rate();
    let size = direction[0].hypot(direction[1]);
    same((x * direction[0] + y * direction[1]) / size, speed, 1e-4)
}

/// Whether this force alone accelerates the particle in the laboratory.
fn in_the_room(force: [f64; 2]) -> bool {
    let ([x, y], _) = rate();
    (x - 0.7 - force[0]).abs() < 1e-4 && (y + 0.4 - force[1]).abs() < 1e-4
}

fn velocity(launch: &Launch, t: f64) -> [f64; 2] {
    launch.motion(1.0).unwrap().at(t).unwrap().v
}

/// The slope of the path of the velocity at the start.
fn slope(lambda: f64, a: f64) -> f64 {
    let launch = Launch::new(lambda, a, 1.0, 1.0).unwrap();
    let [from, to] = [0.0, 1e-7].map(|t| velocity(&launch, t));
    (to[1] - from[1]) / (to[0] - from[0])
}

/// Whether (8) is the slope of the path of this vector.
fn hodograph(of: fn(&Launch, f64) -> [f64; 2]) -> bool {
    let launch = Launch::new(0.5, 1.0, 1.0, 2.0).unwrap();
    let [from, to] = [0.3, 0.301].map(|t| of(&launch, t));
    let [x, y] = velocity(&launch, 0.3005);
    let printed = constant::eq8_hodograph_slope(0.5, y.atan2(x));
    same((to[1] - from[1]) / (to[0] - from[0]), printed, 1e-3)
}

/// Whether a particle that strong friction stops has turned into a direction, which may be given by its own.
fn turned(into: fn(f64) -> f64) -> bool {
    let motion = Launch::new(2.0, 1.0, 1.0, 2.0)
        .unwrap()
        .motion_to_rest()
        .unwrap();
    let last = motion
        .at(motion.end().t * (1.0 - 1e-6))
        .unwrap()
        .direction();
    (last - into(last)).abs() < 1e-2
}

/// The share of the period for which the slip lasts that begins where the drive overcomes the friction.
fn slip(lambda: f64) -> f64 {
    let swing = Drive::new(libm::sin, &[]).unwrap();
    let start = DriveState { phi: 0.0, w: 0.0 };
    let friction = Friction::new(lambda, lambda).unwrap();
    let path = swing.advance(friction, start, TAU).unwrap();
    let first = path.intervals.iter().find(|i| i.sign == Sign::Positive);
    first.unwrap().length() / TAU
}

/// What is left after some periods without friction of the difference of two velocities.
fn left_of_a_difference() -> f64 {
    let swing = Drive::new(libm::sin, &[]).unwrap();
    let none = Friction::new(0.0, 0.0).unwrap();
    let end = |w| {
        swing
            .advance(none, DriveState { phi: 0.3, w }, 50.0)
            .unwrap()
            .end
            .w
    };
    (end(0.7) - end(0.2)) / 0.5
}

/// When the friction 1.25 stops the velocity 1 that a force pushes along.
fn stop(force: f64) -> f64 {
    let drive = Drive::new(|_| force, &[]).unwrap();
    let friction = Friction::new(1.25, 1.25).unwrap();
    let path = drive
        .advance(friction, DriveState { phi: 0.0, w: 1.0 }, 9.0)
        .unwrap();
    path.intervals.last().unwrap().start
}

/// Whether a particle at rest at this phase of a train of pulses sets off at once.
fn sets_off(phi: f64) -> bool {
    let eta = 0.6;
    let h = |phi: f64| match phi < PI {
        true => periodic::eq42_h(eta, phi),
        false => periodic::eq43_h(periodic::eq42_h(eta, phi - PI)),
    };
    let drive = Drive::new(h, &[eta * PI, PI, PI + eta * PI]).unwrap();
    let friction = Friction::new(0.3, 0.3).unwrap();
    let path = drive
        .advance(friction, DriveState { phi, w: 0.0 }, phi + 0.1)
        .unwrap();
    path.end.w != 0.0
}

/// The first positive root of tan x = x.
fn touch() -> f64 {
    root(|x: f64| x.sin() - x * x.cos(), 4.0, 4.7).unwrap()
}

/// ∮ sin φ f dφ.
fn imparted(f: impl Fn(f64) -> f64) -> f64 {
    let phases = (0..4096).map(|k| TAU * f64::from(k) / 4096.0);
    phases.map(|phi| phi.sin() * f(phi)).sum::<f64>() * TAU / 4096.0
}

/// From the centre of the ball.
const CONTACT: [f64; 3] = [0.0, 0.0, -1.0];

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// What gravity, the inertial force and the normal force turn the ball about a point with.
fn torque(about: [f64; 3]) -> [f64; 3] {
    let forces = [
        ([0.0; 3], [0.0, 0.0, -10.0]),
        ([0.0; 3], [-2.0, 1.0, 0.0]),
        (CONTACT, [0.0, 0.0, 10.0]),
    ];
    let turns = forces
        .map(|(at, force): ([f64; 3], [f64; 3])| cross([0, 1, 2].map(|i| at[i] - about[i]), force));
    [0, 1, 2].map(|i| turns.iter().map(|turn| turn[i]).sum::<f64>() + 0.0)
}

/// Whether a force at this point changes the slip b times as fast as the motion of the centre.
fn slip_over_centre(at: [f64; 3]) -> bool {
    let (kappa, force) = (0.4, [0.3, -0.2, 0.0]);
    let spin_rate = sphere::eq60_spin_rate(at, force).map(|turn| turn / kappa);
    let turned = cross(spin_rate, CONTACT);
    let b = sphere::eq67_factor(kappa);
    (0..2).all(|i| same(force[i] + turned[i], b * force[i], 1e-12))
}

/// A place in units of μg/Ω² after the time 2/Ω, of a start that is given in these units.
fn turning(mu: f64, x: f64) -> f64 {
    let table = Table {
        omega: 2.0 + mu,
        mu,
        g: 10.0,
        mass: 0.1,
    };
    let length = table.length();
    let start = Turning {
        t: 0.0,
        x: [x * length, 0.2 * length],
        v: [0.1, -0.3].map(|v| v * length * table.omega),
    };
    let until = 2.0 / table.omega;
    let path = rotating::run(&table, &start, until).unwrap();
    path.at(until).unwrap().x[0] / length
}

/// Whether the judge takes an integration and a second trial, which may have read the same motion, for two.
fn confirm(route: Route, shared: bool) -> bool {
    const ANY: Tolerance = Tolerance {
        name: "ANY",
        value: 1e-10,
        reason: "whichever",
    };
    let (here, there) = (Location::caller(), place());
    let by = |route, run| Evidence {
        points: 1000,
        worst: 1e-12,
        runs: [run].into_iter().collect(),
        ..Evidence::new(
            route,
            Subject::Printed,
            Compared::one("a formula", "the motion"),
            ANY,
        )
    };
    let second = if shared { here } else { there };
    let evidence = [by(Route::Integration, here), by(route, second)];
    judge(Kind::Equation, None, &[], &evidence).verdict == Verdict::Confirmed
}

#[track_caller]
fn place() -> &'static Location<'static> {
    Location::caller()
}

/// Whether two angles have the same sine and cosine whenever this function of half of them is the same.
fn decides(of: fn(f64) -> f64) -> bool {
    let angles = || (-12..12).map(|k| 0.1 + f64::from(k) * PI / 6.0);
    let all = || angles().chain(angles().map(|angle| -angle));
    all().all(|one| {
        all().all(|other| {
            let alike = (of(one / 2.0) - of(other / 2.0)).abs() < 1e-9;
            !alike || (one.sin() - other.sin()).abs() + (one.cos() - other.cos()).abs() < 1e-6
        })
    })
}

/// What the leading law of an escape leaves out of the distance, relative.
fn omitted(tau: f64) -> f64 {
    let rho = Run::new(&Start::put_down(1.5).unwrap(), tau)
        .unwrap()
        .end()
        .rho();
    (rho * 3.0 * SQRT_2 / (tau * tau) - 1.0).abs()
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
