//! What the pages say of directions, computed.

use slipbook::claims::anisotropic::drift::budget;
use slipbook::claims::anisotropic::simulated::Curves;
use slipbook::claims::solve::{anisotropic as ratchet, sinusoidal, turntable};
use slipbook::corrections::{
    anisotropic as border, escape, periodic as pulses, sinusoidal as swing,
};
use slipbook::motion::turntable::boundary::between;
use slipbook::motion::turntable::{
    Fate, Start, Table, boundary, critical_radius, critical_speed, fate, inertial,
};
use slipbook::motion::{Launch, State};
use slipbook::paper::{anisotropic, constant, escape as growing, periodic, turntable as print};
use std::f64::consts::{FRAC_PI_2, PI, SQRT_2, TAU};

/// A page, its words (a formula as §), and whether it is so.
pub type Said = (&'static str, &'static str, fn() -> bool);

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

pub const SAID: &[Said] = &[
    ("constant", "(20) falls with §", || {
        let stops = along(0.0, PI).map(|theta0| constant::eq20_stop_time(2.0, 1.0, 1.0, theta0));
        falls(stops)
    }),
    (
        "constant",
        "§ falls exactly as fast as § rises, so the sum is constant",
        || {
            let states = launched(1.0);
            let sums = states.iter().map(|s| s.speed() + s.v[0]);
            falls(states.iter().map(State::speed))
                && rises(states.iter().map(|s| s.v[0]))
                && sums
                    .map(|sum| (sum - 1.0 - 2f64.cos()).abs())
                    .all(|off| off < 1e-12)
        },
    ),
    ("constant", "The § component can only shrink", || {
        [0.0, 0.5, 1.0].iter().all(|lambda| {
            let y: Vec<_> = launched(*lambda).iter().map(|s| s.v[1]).collect();
            y.windows(2).all(|two| two[1] <= two[0])
        })
    }),
    (
        "sinusoidal",
        "This factor falls from 1 without friction to 0 at §",
        || {
            let lambda_c = 2.0 / (4.0 + PI * PI).sqrt();
            let end = swing::contraction(lambda_c);
            swing::contraction(0.0) == 1.0
                && end < 1e-15
                && falls(along(0.0, lambda_c).map(swing::contraction))
        },
    ),
    ("sinusoidal", "By §, a little less than two", || {
        let factor = 0.5 * (4.0 + PI * PI).sqrt();
        (1.8..2.0).contains(&factor) && never_rests(1.01 * factor) && !never_rests(0.99 * factor)
    }),
    (
        "sinusoidal",
        "For a smaller factor there are rests, for a larger one none",
        || !never_rests(1.7) && never_rests(2.0),
    ),
    (
        "periodic",
        "As § rises to § the start § falls to 0",
        || {
            let start = |lambda| pulses::small_friction_start(lambda, 0.4);
            falls(along(0.01, 0.4).map(start)) && start(0.4) == 0.0
        },
    ),
    ("periodic", "the less friction, the faster", || {
        let fastest = |lambda: f64| periodic::eq44_cases(lambda, 0.3, 0.3 * PI)[0];
        falls(along(0.31, 0.99).map(fastest))
    }),
    (
        "anisotropic",
        "For (54) this is positive at § and falls",
        || {
            along(1.5, 12.0).all(|q| {
                let over = excess(anisotropic::eq54_sides, q);
                over(0.0) > 0.0 && falls(along(0.0, 1.0 / q).map(over))
            })
        },
    ),
    (
        "anisotropic",
        "for E it is 0 there, falls at first and is convex",
        || {
            along(1.5, 12.0).all(|q| {
                let over = excess(border::e_sides, q);
                let slopes = along(0.0, 0.95 / q).map(|x| over(x + 1e-4 / q) - over(x));
                over(0.0) == 0.0 && over(1e-3 / q) < 0.0 && rises(slopes)
            })
        },
    ),
    (
        "anisotropic",
        "the two are equal, negative before Y and positive beyond",
        || {
            [(4.5, -1.0), (4.7, 1.0)].iter().all(|(q, sign)| {
                let [b, e] = [anisotropic::eq54_sides, border::e_sides]
                    .map(|sides| excess(sides, *q)(1.0 / q));
                (b - e).abs() < 1e-12 && b * sign > 0.0
            })
        },
    ),
    (
        "anisotropic",
        "In this unit the drift is faster for weaker friction and for larger §",
        || {
            let drift = |q: f64, lambda0: f64| budget(q, lambda0).unwrap().drift;
            falls(along(0.01, 0.97).map(|lambda0| drift(2.6, lambda0)))
                && rises(along(1.1, 6.0).map(|q| drift(q, 0.05)))
        },
    ),
    (
        "anisotropic",
        "It is largest for §, where it is §",
        || {
            let lost = |lambda0: f64| border::loss_without_rest(1.0, lambda0, FRAC_PI_2);
            let most = lost(SQRT_2 / PI);
            (most - 4.0 / PI).abs() < 1e-15 && along(0.05, 0.53).all(|lambda0| lost(lambda0) < most)
        },
    ),
    (
        "anisotropic",
        "C is at § and B lies lower, at §, so this is region III",
        || {
            let over = excess(anisotropic::eq54_sides, 2.0);
            // (54) falls through zero on B.
            over(0.406) > 0.0 && over(0.408) < 0.0
        },
    ),
    (
        "turntable",
        "One that starts from rest at § first moves straight outwards",
        || {
            let moment = soon(1.5, 0.0, 0.0);
            moment.velocity[0] > 0.0 && moment.psi.abs() < 0.02
        },
    ),
    (
        "turntable",
        "has the axis straight behind it, and at first § grows at the rate 1",
        || {
            let moment = soon(0.0, 1.0, 0.0);
            (moment.psi - 1e-2).abs() < 1e-4
        },
    ),
    (
        "turntable",
        "which points against the velocity *relative to the record*",
        || {
            // At rest in the room it is carried along; at rest on the record friction only holds it.
            let room = |v| State {
                t: 0.0,
                x: [0.5, 0.0],
                v: [0.0, v],
            };
            let later = |v| {
                inertial::run(&Table::default(), &room(v), 0.1)
                    .unwrap()
                    .at(0.1)
                    .unwrap()
            };
            let carried = later(0.5);
            later(0.0).v[1] > 0.09 && (carried.speed() - 0.5).abs() < 1e-12
        },
    ),
    (
        "turntable",
        "the angular velocity §, counterclockwise seen from above",
        || {
            let at_rest = State {
                t: 0.1,
                x: [1.0, 0.0],
                v: [0.0; 2],
            };
            let seen = Table::default().to_laboratory(&at_rest);
            seen.x[1] > 0.0 && seen.v[1] > 0.0
        },
    ),
    (
        "turntable",
        "measured counterclockwise from the velocity to the position",
        || {
            let moment = soon(1.0, 1.0, 0.5);
            let ([x, y], [u, v]) = (moment.position, moment.velocity);
            let turned = y.atan2(x) - v.atan2(u);
            (turned - moment.psi).abs() < 1e-12 && (turned - 0.5).abs() < 0.02
        },
    ),
    (
        "turntable",
        "§ is the component of the position along the velocity, and § its component to the left of it",
        || {
            let moment = soon(1.0, 1.0, 0.5);
            let ([x, y], [u, v]) = (moment.position, moment.velocity);
            let along = (x * u + y * v) / moment.p;
            let left = (y * u - x * v) / moment.p;
            let [xi, ell] = [print::eq94_xi, print::eq95_ell].map(|of| of(moment.rho, moment.psi));
            (along - xi).abs() < 1e-12 && (left + ell).abs() < 1e-12
        },
    ),
    (
        "escape",
        "The power is right. The prefactor is wrong",
        || {
            let growth = |of: fn(f64) -> f64| (of(2e3) / of(1e3)).log2();
            let printed: fn(f64) -> f64 = growing::eq136_rho;
            let right: fn(f64) -> f64 = escape::rho;
            (growth(printed) - growth(right)).abs() < 1e-12 && printed(1.0) != right(1.0)
        },
    ),
    (
        "escape",
        "The laws of growth hold in a time that lags behind",
        || escape::delay::<f64>() > 0.0,
    ),
    ("escape", "which is a little more than twice around", || {
        (2.0..2.2).contains(&(escape::winding::<f64>() * 1e4f64.ln() / TAU))
    }),
    (
        "rest",
        "one launched from the axis does so if it is slower than a critical speed",
        || {
            let critical = critical_speed().unwrap();
            rests(0.0, 0.99 * critical, 0.0) && !rests(0.0, 1.01 * critical, 0.0)
        },
    ),
    (
        "rest",
        "Thrown outwards, it escapes the more easily the farther out it starts",
        || falls((0..9).map(|i| outwards(0.1 * f64::from(i)))),
    ),
    (
        "rest",
        "Thrown inwards, it may even be faster than the critical speed",
        || rests(0.3, 1.05 * critical_speed().unwrap(), PI),
    ),
    (
        "rest",
        "a coin put down beyond the critical radius slides past that distance before it can stop",
        || {
            let critical = critical_radius().unwrap();
            let ends = |rho: f64| {
                let start = Start::put_down(rho).unwrap();
                matches!(fate(&start).unwrap(), Fate::Rest { .. })
            };
            ends(0.999 * critical) && !ends(1.001 * critical)
        },
    ),
    (
        "new",
        "what starts below the line § comes to rest, what starts above it escapes",
        || {
            // In the slow motion ψ ≈ 2α, a = A − 1.
            let alpha = 0.01;
            let start = |a: f64| Start::hyperbolic(1.0 + a, alpha, 2.0 * alpha).unwrap();
            let border = boundary(alpha, 2.0 * alpha).unwrap() - 1.0;
            (border + alpha).abs() < 0.05 * alpha
                && matches!(fate(&start(-1.1 * alpha)).unwrap(), Fate::Rest { .. })
                && matches!(fate(&start(-0.9 * alpha)).unwrap(), Fate::Escape { .. })
        },
    ),
    (
        "index",
        "Where friction is much stronger backwards than forwards",
        || {
            // What the printed list says, and the motion.
            let alike = |q: f64, lambda0: f64| {
                let printed = anisotropic::region(lambda0, &Curves::at(q).unwrap().printed);
                let moves = ratchet::AnisotropicProblem { q, lambda0 }
                    .solve()
                    .unwrap()
                    .best
                    .region;
                printed.map(|i| ["I", "II", "III", "IV", "V"][i - 1]) == Some(moves)
            };
            let all_alike = |q: f64| along(0.013, 1.1).all(|lambda0| alike(q, lambda0));
            all_alike(1.5) && all_alike(4.5) && !alike(8.0, 0.12)
        },
    ),
];
