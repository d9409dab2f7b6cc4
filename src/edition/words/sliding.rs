//! The chapters on sliding, on the constant acceleration and on the sphere.

use super::{Known, along, falls, found, rises, same, words};
use crate::motion::{
    Launch, Plane, State, run,
    sphere::{Ball, Sphere},
};
use crate::numerics::roots::root;
use crate::paper::{constant, sphere};
use libm::hypot;
use std::f64::consts::{FRAC_PI_2, PI};
use trialbook::publishing::Word;

words! {
    "stop-falls" => falls(along(0.0, PI).map(|theta0| constant::eq20_stop_time(2.0, 1.0, 1.0, theta0)));
    "speed-falls-sum-constant" => {
        let states = launched(1.0)?;
        let off = |s: &State| (s.speed() + s.v[0] - 1.0 - libm::cos(2.0)).abs();
        falls(states.iter().map(State::speed)) && rises(states.iter().map(|s| s.v[0])) && states.iter().all(|s| off(s) < 1e-12)
    };
    "across-can-shrink" => {
        let [none, weak, even] = [launched(0.0)?, launched(0.5)?, launched(1.0)?];
        [none, weak, even].iter().all(|states| states.windows(2).all(|two| two[1].v[1] <= two[0].v[1]))
    };
    "time-drops-out" => [
        same(slope(0.5, 1.0)?, slope(0.5, 2.0)?, 1e-5),
        same(slope(0.5, 1.0)?, slope(0.9, 1.0)?, 1e-5),
    ];
    "tip-of-velocity" => [
        hodograph(velocity)?,
        hodograph(|launch, t| {
            let [a, b] = [velocity(launch, t)?, velocity(launch, t + 1e-4)?];
            Ok([b[0] - a[0], b[1] - a[1]])
        })?,
    ];
    "across-inverse" => {
        // What a tenfold time leaves of the velocity across twice the friction.
        let start = State { t: 0.0, x: [0.0; 2], v: [0.0, 1.0] };
        let motion = run(&Plane::constant([-2.0, 0.0]), 1.0, start, 1e5)?;
        let left = motion.at(1e5)?.v[1] / motion.at(1e4)?.v[1];
        [same(left, 0.1, 1e-2), same(left, 0.01, 1e-2)]
    };
    "into-inertial" => [turned(|_| 0.0)?, turned(|direction| direction + PI)?];
    "half-tangent-start" => half_tangent(0.0)?;
    "half-tangent-end" => half_tangent(1e4)?;
    "speed-kept-across" => libm::round(1e9 * kept(90.0)?) * 1e-9;
    "degrees-for-three-quarters" => {
        let angle = root(|degrees: f64| kept(degrees).map_or(f64::NAN, |kept| kept - 0.75), 1.0, 179.0)?;
        libm::round(angle)
    };
    "later-than-at-rest" => Launch::new(2.0, 1.0, 1.0, FRAC_PI_2)?.motion_to_rest()?.end().t * 2.0 - 1.0;
    "onto-motion" => [speed_rate_along([0.6, 0.5])?, speed_rate_along([0.7, -0.4])?];
    "room-inertial-force:-only-friction" => {
        let speed = libm::sqrt(0.61);
        [in_the_room([-0.6 / speed, -0.5 / speed])?, in_the_room([0.7, -0.4])?]
    };
    "about-the-centre" => [torque([0.0; 3]) == [0.0; 3], torque(CONTACT) == [0.0; 3]];
    "acts-at-lowest-point" => [slip_over_centre(CONTACT), slip_over_centre([0.0; 3])];
    "printed-time-over-true" => {
        let start = Ball { t: 0.0, x: [0.0; 2], v: [0.0, 1.0], omega: [0.0; 3] };
        let motion = Sphere::with_kappa(0.4).run(&Plane::constant([-2.0, 0.0]), &start, 1.0)?;
        let printed = sphere::eq82_time(3.5 / 2.0, 1.0, FRAC_PI_2, 1e-9);
        libm::round(printed / found(motion.transitions().first())?.t * 1e6) / 1e6
    };
}

/// One after the other.
fn launched(lambda: f64) -> Known<Vec<State>> {
    let motion = Launch::new(lambda, 1.0, 1.0, 2.0)?.motion(3.0)?;
    along(0.0, 3.0).map(|t| Ok(motion.at(t)?)).collect()
}

fn velocity(launch: &Launch, t: f64) -> Known<[f64; 2]> {
    Ok(launch.motion(1.0)?.at(t)?.v)
}

/// Of the path of the velocity at the start.
fn slope(lambda: f64, a: f64) -> Known {
    let launch = Launch::new(lambda, a, 1.0, 1.0)?;
    let [from, to] = [velocity(&launch, 0.0)?, velocity(&launch, 1e-7)?];
    Ok((to[1] - from[1]) / (to[0] - from[0]))
}

/// Whether (8) is the slope of the path of this vector.
fn hodograph(of: fn(&Launch, f64) -> Known<[f64; 2]>) -> Known<bool> {
    let launch = Launch::new(0.5, 1.0, 1.0, 2.0)?;
    let [from, to] = [of(&launch, 0.3)?, of(&launch, 0.301)?];
    let [x, y] = velocity(&launch, 0.3005)?;
    let printed = constant::eq8_hodograph_slope(0.5, libm::atan2(y, x));
    Ok(same((to[1] - from[1]) / (to[0] - from[0]), printed, 1e-3))
}

/// Whether a particle that strong friction stops has turned into a direction, which may be given by its own.
fn turned(into: fn(f64) -> f64) -> Known<bool> {
    let motion = Launch::new(2.0, 1.0, 1.0, 2.0)?.motion_to_rest()?;
    let last = motion.at(motion.end().t * (1.0 - 1e-6))?.direction();
    Ok((last - into(last)).abs() < 1e-2)
}

/// tan(θ/2) at a time, over what it was at the start.
fn half_tangent(t: f64) -> Known {
    let motion = Launch::new(0.5, 1.0, 1.0, 2.0)?.motion(1e4)?;
    Ok(libm::round(
        libm::tan(motion.at(t)?.direction() / 2.0) / libm::tan(1.0),
    ))
}

/// The share of its speed that a particle keeps at λ = 1, launched at so many degrees to the inertial force.
fn kept(degrees: f64) -> Known {
    Ok(Launch::new(1.0, 1.0, 1.0, degrees.to_radians())?
        .motion(400.0)?
        .end()
        .speed())
}

/// The rate of a velocity (0.6, 0.5) on a plane with the acceleration (−0.7, 0.4) and the friction 1.
fn rate() -> Known<([f64; 2], f64)> {
    let start = State {
        t: 0.0,
        x: [0.0; 2],
        v: [0.6, 0.5],
    };
    let h = 1e-6;
    let later = run(&Plane::constant([-0.7, 0.4]), 1.0, start, h)?.end();
    let of = |i: usize| (later.v[i] - start.v[i]) / h;
    Ok(([of(0), of(1)], (later.speed() - start.speed()) / h))
}

fn speed_rate_along(direction: [f64; 2]) -> Known<bool> {
    let ([x, y], speed) = rate()?;
    let size = hypot(direction[0], direction[1]);
    Ok(same(
        (x * direction[0] + y * direction[1]) / size,
        speed,
        1e-4,
    ))
}

/// Whether this force alone accelerates the particle in the laboratory.
fn in_the_room(force: [f64; 2]) -> Known<bool> {
    let ([x, y], _) = rate()?;
    Ok((x - 0.7 - force[0]).abs() < 1e-4 && (y + 0.4 - force[1]).abs() < 1e-4)
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
