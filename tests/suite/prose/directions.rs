//! Directions, names and causes on the pages: of the words that could stand there, the one of which it is so.
//!
//! Where a page says none of them any more, nothing is asked.

use super::choices::Held;
use super::text::{Word, pages, words};
use slipbook::claims::PAPER;
use slipbook::claims::anisotropic::drift::budget;
use slipbook::claims::anisotropic::simulated::{Curves, attractor};
use slipbook::claims::tolerances::VANISHES;
use slipbook::corrections::{
    anisotropic as border, escape, periodic as pulses, sinusoidal as swing,
};
use slipbook::evidence::{Compared, Evidence, Kind, Route, Subject, Tolerance};
use slipbook::exam::TASKS;
use slipbook::ledger::{Verdict, judge};
use slipbook::motion::drive::{Drive, DriveState, Friction, Sign};
use slipbook::motion::turntable::boundary::between;
use slipbook::motion::turntable::{Fate, Start, State as Turning, Table, intrinsic::Run};
use slipbook::motion::turntable::{
    boundary, critical_radius, critical_speed, fate, inertial, rotating,
};
use slipbook::motion::{Launch, Plane, State, run};
use slipbook::numerics::roots::root;
use slipbook::paper::turntable::{eq107_p_rate, eq109_psi_rate};
use slipbook::paper::{
    anisotropic, constant, escape as growing, general, periodic, sphere, turntable as print,
};
use slipbook::solve::{anisotropic as ratchet, sinusoidal, turntable};
use slipbook::symbols::SYMBOLS;
use std::f64::consts::{FRAC_PI_2, PI, SQRT_2, TAU};
use std::panic::Location;

/// A page; words, with what could stand there in braces; and of each of these whether it is so. Of one alone that the first is.
type Said = (
    &'static str,
    &'static [&'static str],
    &'static [fn() -> bool],
);

macro_rules! said {
    ($($page:literal: $($words:literal),+ => $($holds:expr),+;)*) => {
        const SAID: &[Said] = &[$(($page, &[$($words),+], &[$($holds),+])),*];
    };
}

said! {
    "constant": "(20) {falls|rises} with" => || {
        falls(along(0.0, PI).map(|theta0| constant::eq20_stop_time(2.0, 1.0, 1.0, theta0)))
    };
    "constant": "§ falls exactly as fast as § {rises|falls}", "so the {sum|difference} is constant" => || {
        let states = launched(1.0);
        let off = |s: &State| (s.speed() + s.v[0] - 1.0 - 2f64.cos()).abs();
        falls(states.iter().map(State::speed)) && rises(states.iter().map(|s| s.v[0])) && states.iter().all(|s| off(s) < 1e-12)
    };
    "constant": "component can only {shrink|grow}" => || {
        [0.0, 0.5, 1.0].iter().all(|lambda| launched(*lambda).windows(2).all(|two| two[1].v[1] <= two[0].v[1]))
    };
    "constant": "and the {time|friction} drops out" =>
        || same(slope(0.5, 1.0), slope(0.5, 2.0), 1e-5), || same(slope(0.5, 1.0), slope(0.9, 1.0), 1e-5);
    "constant": "the tip of the {velocity|acceleration} vector" =>
        || hodograph(velocity),
        || hodograph(|launch, t| {
            let [a, b] = [t, t + 1e-4].map(|t| velocity(launch, t));
            [b[0] - a[0], b[1] - a[1]]
        });
    "constant": "into the direction of the {inertial|friction} force" =>
        || turned(|_| 0.0), || turned(|direction| direction + PI);
    "general": "onto the direction of {motion|the pull}" =>
        || speed_rate_along([0.6, 0.5]), || speed_rate_along([0.7, -0.4]);
    "general": "where there is no {inertial force: only friction|friction: only the inertial force} acts" =>
        || {
            let speed = 0.61_f64.sqrt();
            in_the_room([-0.6 / speed, -0.5 / speed])
        },
        || in_the_room([0.7, -0.4]);
    "sinusoidal": "factor {falls|rises} from 1", "from {1|0} without friction" => || {
        let lambda_c = 2.0 / (4.0 + PI * PI).sqrt();
        let end = swing::contraction(lambda_c);
        swing::contraction(0.0) == 1.0 && end < 1e-15 && falls(along(0.0, lambda_c).map(swing::contraction))
    };
    "sinusoidal": "a little {less|more} than two" => || {
        let factor = 0.5 * (4.0 + PI * PI).sqrt();
        (1.8..2.0).contains(&factor) && never_rests(1.01 * factor) && !never_rests(0.99 * factor)
    };
    "sinusoidal": "for a {smaller|larger} factor there are rests", "for a {larger|smaller} one none" =>
        || !never_rests(1.7) && never_rests(2.0);
    "sinusoidal": "the slip lasts for {nearly the whole period|next to no time|half a period}" =>
        || slip(1e-3) > 0.9, || slip(1e-3) < 0.1, || (slip(1e-3) - 0.5).abs() < 0.1;
    "sinusoidal": "without friction {nothing|the start} is forgotten" =>
        || same(left_of_a_difference(), 1.0, 1e-12), || left_of_a_difference() < 0.5;
    "anisotropic": "the particle {keeps|forgets} whatever drift" =>
        || same(left_of_a_difference(), 1.0, 1e-12), || left_of_a_difference() < 0.5;
    "periodic": "as § rises to § the start § {falls|rises}" => || {
        let start = |lambda| pulses::small_friction_start(lambda, 0.4);
        falls(along(0.01, 0.4).map(start)) && start(0.4) == 0.0
    };
    "periodic": "the less friction, the {faster|slower}" =>
        || falls(along(0.31, 0.99).map(|lambda| periodic::eq44_cases(lambda, 0.3, 0.3 * PI)[0]));
    "periodic": "pushes along the motion with {full|hardly any} force" =>
        || same(stop(1.0), 1.0 / (1.25 - 1.0), 1e-9), || same(stop(0.01), 1.0 / (1.25 - 1.0), 1e-9);
    "periodic": "during a {pulse|gap} friction cannot hold" => || sets_off(0.3 * PI), || sets_off(0.8 * PI);
    "anisotropic": "(54) this is {positive|negative} at", "this is positive at § and {falls|rises}" => || {
        along(1.5, 12.0).all(|q| {
            let over = excess(anisotropic::eq54_sides, q);
            over(0.0) > 0.0 && falls(along(0.0, 1.0 / q).map(over))
        })
    };
    "anisotropic": "for E it is {0|positive|negative} there", "{falls|rises} at first and is", "at first and is {convex|concave}" => || {
        along(1.5, 12.0).all(|q| {
            let over = excess(border::e_sides, q);
            let slopes = along(0.0, 0.95 / q).map(|x| over(x + 1e-4 / q) - over(x));
            over(0.0) == 0.0 && over(1e-3 / q) < 0.0 && rises(slopes)
        })
    };
    "anisotropic": "{negative|positive} before Y", "{positive|negative} beyond" => || {
        [(4.5, -1.0), (4.7, 1.0)].iter().all(|(q, sign)| {
            let [b, e] = [anisotropic::eq54_sides, border::e_sides].map(|sides| excess(sides, *q)(1.0 / q));
            (b - e).abs() < 1e-12 && b * sign > 0.0
        })
    };
    "anisotropic": "the drift is {faster|slower} for weaker friction", "weaker friction and for {larger|smaller} §" => || {
        let drift = |q: f64, lambda0: f64| budget(q, lambda0).unwrap().drift;
        falls(along(0.01, 0.97).map(|lambda0| drift(2.6, lambda0))) && rises(along(1.1, 6.0).map(|q| drift(q, 0.05)))
    };
    "anisotropic": "it is {largest|smallest} for § where" => || {
        let lost = |lambda0: f64| border::loss_without_rest(1.0, lambda0, FRAC_PI_2);
        let most = lost(SQRT_2 / PI);
        (most - 4.0 / PI).abs() < 1e-15 && along(0.05, 0.53).all(|lambda0| lost(lambda0) < most)
    };
    "anisotropic": "B lies {lower|higher}", "so this is region {III|I|II|IV|V}" => || {
        let over = excess(anisotropic::eq54_sides, 2.0);
        // (54) falls through zero on B.
        over(0.406) > 0.0 && over(0.408) < 0.0
    };
    "anisotropic": "apart from zero, where § is {stationary|zero}" =>
        || {
            let [left, right] = [-1e-4, 1e-4].map(|h| (touch() + h).sin() / (touch() + h));
            same(left, right, 1e-8)
        },
        || (touch().sin() / touch()).abs() < 1e-8;
    "anisotropic": "imparts no net {velocity|energy}" =>
        || imparted(|_| 1.0).abs() < 1e-9,
        || {
            let motion = attractor(2.0, 0.2).unwrap();
            imparted(|phi| motion.w(phi)).abs() < 1e-9
        };
    "sphere": "no torque about the {centre|contact}" => || torque([0.0; 3]) == [0.0; 3], || torque(CONTACT) == [0.0; 3];
    "sphere": "only that the force acts at the {lowest point|centre}" =>
        || slip_over_centre(CONTACT), || slip_over_centre([0.0; 3]);
    "turntable": "first moves straight {outwards|inwards}" => || {
        let moment = soon(1.5, 0.0, 0.0);
        moment.velocity[0] > 0.0 && moment.psi.abs() < 0.02
    };
    "turntable": "has the axis straight {behind|before|ahead of} it" => || (soon(0.0, 1.0, 0.0).psi - 1e-2).abs() < 1e-4;
    "turntable": "points {against|along} the velocity relative to the {record|room}" => || {
        // At rest in the room it is carried along; at rest on the record friction only holds it.
        let start = |v| State { t: 0.0, x: [0.5, 0.0], v: [0.0, v] };
        let later = |v| inertial::run(&Table::default(), &start(v), 0.1).unwrap().at(0.1).unwrap();
        later(0.0).v[1] > 0.09 && (later(0.5).speed() - 0.5).abs() < 1e-12
    };
    "turntable": "{counterclockwise|clockwise} seen from above" => || {
        let at_rest = State { t: 0.1, x: [1.0, 0.0], v: [0.0; 2] };
        let seen = Table::default().to_laboratory(&at_rest);
        seen.x[1] > 0.0 && seen.v[1] > 0.0
    };
    "turntable": "measured {counterclockwise|clockwise} from the velocity to",
        "measured counterclockwise from the {velocity to the position|position to the velocity}" => || {
        let moment = soon(1.0, 1.0, 0.5);
        let ([x, y], [u, v]) = (moment.position, moment.velocity);
        let turned = y.atan2(x) - v.atan2(u);
        (turned - moment.psi).abs() < 1e-12 && (turned - 0.5).abs() < 0.02
    };
    "turntable": "component of the position {along|across} the velocity", "its component to the {left|right} of it" => || {
        let moment = soon(1.0, 1.0, 0.5);
        let ([x, y], [u, v]) = (moment.position, moment.velocity);
        let (along, left) = ((x * u + y * v) / moment.p, (y * u - x * v) / moment.p);
        let [xi, ell] = [print::eq94_xi, print::eq95_ell].map(|of| of(moment.rho, moment.psi));
        (along - xi).abs() < 1e-12 && (left + ell).abs() < 1e-12
    };
    "turntable": "motions differ only in {how they start|their friction}" =>
        || {
            let (one, other) = (turning(0.3, 0.5), turning(0.3, 0.6));
            (one - other).abs() > 1e-3 && same(one, turning(0.1, 0.5), 1e-10)
        },
        || (turning(0.3, 0.5) - turning(0.1, 0.5)).abs() > 1e-3;
    "escape": "the power is {right|wrong}", "the prefactor is {wrong|right}" => || {
        let growth = |of: fn(f64) -> f64| (of(2e3) / of(1e3)).log2();
        let [printed, right]: [fn(f64) -> f64; 2] = [growing::eq136_rho, escape::rho];
        (growth(printed) - growth(right)).abs() < 1e-12 && printed(1.0) != right(1.0)
    };
    "escape": "in a time that {lags behind|runs ahead}" => || escape::delay::<f64>() > 0.0;
    "escape": "a little {more|less} than twice around" =>
        || (2.0..2.2).contains(&(escape::winding::<f64>() * 1e4f64.ln() / TAU));
    "rest": "if it is {slower|faster} than a critical speed" => || {
        let critical = critical_speed().unwrap();
        rests(0.0, 0.99 * critical, 0.0) && !rests(0.0, 1.01 * critical, 0.0)
    };
    "rest": "escapes the more easily the {farther|nearer}" => || falls((0..9).map(|i| outwards(0.1 * f64::from(i))));
    "rest": "inwards, it may even be {faster|slower} than" => || rests(0.3, 1.05 * critical_speed().unwrap(), PI);
    "rest": "put down {beyond|within|below} the critical radius slides" => || {
        let critical = critical_radius().unwrap();
        let ends = |rho: f64| matches!(fate(&Start::put_down(rho).unwrap()).unwrap(), Fate::Rest { .. });
        ends(0.999 * critical) && !ends(1.001 * critical)
    };
    "new": "starts {below|above} the line § comes to rest", "what starts {above|below} it escapes" => || {
        // In the slow motion ψ ≈ 2α, a = A − 1.
        let alpha = 0.01;
        let ends = |a: f64| fate(&Start::hyperbolic(1.0 + a, alpha, 2.0 * alpha).unwrap()).unwrap();
        let border = boundary(alpha, 2.0 * alpha).unwrap() - 1.0;
        (border + alpha).abs() < 0.05 * alpha
            && matches!(ends(-1.1 * alpha), Fate::Rest { .. })
            && matches!(ends(-0.9 * alpha), Fate::Escape { .. })
    };
    "index": "where friction is much {stronger|weaker} backwards" => || {
        // What the printed list says, and the motion.
        let alike = |q: f64, lambda0: f64| {
            let printed = anisotropic::region(lambda0, &Curves::at(q).unwrap().printed);
            let moves = ratchet::AnisotropicProblem { q, lambda0 }.solve().unwrap().best.region;
            printed.map(|i| ["I", "II", "III", "IV", "V"][i - 1]) == Some(moves)
        };
        let all_alike = |q: f64| along(0.013, 1.1).all(|lambda0| alike(q, lambda0));
        all_alike(1.5) && all_alike(4.5) && !alike(8.0, 0.12)
    };
    "methods": "when their routes differ {and|or} they have read no motion" =>
        || !confirm(Route::Quadrature, true) && !confirm(Route::Integration, false),
        || confirm(Route::Quadrature, true) && confirm(Route::Integration, false);
    "methods": "rational function of the {tangent|cosine|sine} of half" =>
        || decides(f64::tan), || decides(f64::cos), || decides(f64::sin);
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

/// What a page says; or what the code says: of what is wrong, of the symbols, in the exam, in the comments at the top of a file.
fn text_of(name: &str) -> Vec<Word> {
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
    let pages = pages();
    let mut held = Held::default();
    for (name, patterns, holds) in SAID {
        let page = pages.iter().find(|page| page.name == *name);
        let text = page.map_or_else(|| text_of(name), |page| page.words.clone());
        let true_of: Vec<bool> = holds.iter().map(|holds| holds()).collect();
        if true_of.len() > 1 && true_of.iter().filter(|holds| **holds).count() != 1 {
            let both = format!("{name}: {true_of:?} of {patterns:?}");
            held.wrong.push(both);
        }
        // Of several one is so, of one alone that the first is.
        let right = |choice: usize| true_of.get(choice).copied().unwrap_or(!true_of[0]);
        for pattern in *patterns {
            held.hold(name, &text, pattern, right);
        }
    }
    held.end();
}

/// Numbers from `low` to `high`.
fn along(low: f64, high: f64) -> impl Iterator<Item = f64> + Clone {
    (0..=20).map(move |i| low + (high - low) * f64::from(i) / 20.0)
}

fn falls(values: impl Iterator<Item = f64>) -> bool {
    let values: Vec<_> = values.collect();
    values.windows(2).all(|two| two[0] > two[1])
}

fn rises(values: impl Iterator<Item = f64>) -> bool {
    falls(values.map(|x| -x))
}

/// The velocities of a launch at λ = `lambda`, one after the other.
fn launched(lambda: f64) -> Vec<State> {
    let motion = Launch::new(lambda, 1.0, 1.0, 2.0)
        .unwrap()
        .motion(3.0)
        .unwrap();
    along(0.0, 3.0).map(|t| motion.at(t).unwrap()).collect()
}

/// The left side of (54), or of E, less the right, at q.
fn excess(sides: fn(f64, f64) -> [f64; 2], q: f64) -> impl Fn(f64) -> f64 {
    move |lambda0| {
        let [left, right] = sides(lambda0, (q * lambda0).min(1.0));
        left - right
    }
}

/// Whether the particle never rests, under a drive whose amplitude is so many times the friction.
fn never_rests(factor: f64) -> bool {
    let lambda0 = 1.0 / factor;
    let swing = sinusoidal::SinusoidalProblem { lambda0 }
        .solve()
        .unwrap()
        .best;
    swing.rest_fraction == 0.0
}

fn starts(rho: f64, p: f64, psi: f64) -> Start {
    Start::polar(rho, p, psi).unwrap()
}

fn rests(rho: f64, p: f64, psi: f64) -> bool {
    matches!(fate(&starts(rho, p, psi)).unwrap(), Fate::Rest { .. })
}

/// The speed above which a particle thrown straight outwards at ρ escapes.
fn outwards(rho: f64) -> f64 {
    between(|p| Start::polar(rho, p, 0.0), 1e-9, 2.0, 1e-6).unwrap()
}

/// ψ and the rest, a little after a start.
fn soon(rho: f64, p: f64, psi: f64) -> turntable::Moment {
    turntable::TurntableProblem::Polar { rho, p, psi }
        .at(1e-2)
        .unwrap()
        .best
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
