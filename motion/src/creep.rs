//! Sliding so slow that its direction follows the pull at once.
//!
//! With the velocity q(cos θ, sin θ), the drive f and the friction L of [`onset`](super::onset),
//!
//! ```text
//! dq/dt = f·û − L,    q dθ/dt = f·n̂,
//! ```
//!
//! θ forgets where it came from in a time q/|f|. Where f hardly changes in that, what is left is one motion, whose θ is as slow
//! as f: f·n̂ = q θ′ tells it from its own derivative, again and again, each time closer by the part q/|f| of the time in which f
//! changes. Its power series in t serve for that whole time, to the stop too.
use crate::numerics::{
    events::roots,
    series::{convolution, product, square, value},
    taylor::{Coefficients, TERMS, reach},
};

pub(super) struct Creep {
    /// In powers of the time since.
    pub velocity: [Coefficients; 2],
    /// Time for which they serve.
    pub h: f64,
    /// Whether the velocity is zero then.
    pub stops: bool,
}

/// It has to be worth as many times q/|f|,
const MANY: f64 = 100.0;
/// each of which makes what is left of another direction smaller by e, down to this angle, which is nothing.
const FORGOTTEN: f64 = 1e-14;
/// A direction farther off than this is not looked at.
const WIDE: f64 = 0.1;
/// What a round still changes in the sine of θ when it is the last one, and how many there are.
const SETTLED: f64 = 1e-17;
const ROUNDS: usize = 16;

/// With the velocity `v` and the acceleration `a` about the present time, which serves for `left`; `limit` is L. If this motion
/// is none, how many times q/|f| to wait before it may be one.
pub(super) fn creep(
    a: &[Coefficients; 2],
    limit: f64,
    v: [f64; 2],
    left: f64,
) -> Result<Creep, f64> {
    let speed = libm::hypot(v[0], v[1]);
    let size = libm::hypot(a[0][0], a[1][0]);
    let slowing = limit + (a[0][0] * v[0] + a[1][0] * v[1]) / speed;
    if !(size * left > MANY * speed && size > MANY * slowing) {
        return Err(0.0);
    }
    let (e, along, across) = pull(a, size);
    if across.iter().all(|c| *c == 0.0) {
        return Err(0.0);
    }
    let [ahead, aside] = [e[0] * v[0] + e[1] * v[1], e[0] * v[1] - e[1] * v[0]].map(|c| c / speed);
    if aside.abs() > WIDE || ahead < 0.0 {
        return Err(libm::log(WIDE / FORGOTTEN));
    }
    let [mut q, mut sine, mut cosine, mut turning] = [[0.0; TERMS]; 4];
    (q[0], cosine[0]) = (speed, 1.0);
    let mut settled = None;
    for _ in 0..ROUNDS {
        for k in 0..TERMS - 1 {
            let known = convolution(&cosine[1..=k], &turning[..k]);
            turning[k] = ((k + 1) as f64 * sine[k + 1] - known) / cosine[0];
        }
        let mut changes = [0.0; TERMS];
        for k in 0..TERMS {
            if k == 1 {
                // f·û − L without its cancellation.
                let bent = sine[0] * sine[0] / (1.0 + cosine[0]);
                q[1] = (size - limit) - size * bent;
            } else if k > 1 {
                q[k] =
                    (product(&along, &cosine, k - 1) + product(&across, &sine, k - 1)) / k as f64;
            }
            let push =
                convolution(&across[1..=k], &cosine[..k]) - convolution(&along[1..=k], &sine[..k]);
            let s = (push - product(&q, &turning, k)) / size;
            changes[k] = s - sine[k];
            sine[k] = s;
            cosine[k] = if k == 0 {
                libm::sqrt((1.0 - s) * (1.0 + s))
            } else {
                let known = convolution(&cosine[1..k], &cosine[1..k]);
                -0.5 * (square(&sine, k) + known) / cosine[0]
            };
        }
        let h = left.min(reach(&q)).min(reach(&sine)).min(reach(&cosine));
        if value(&changes.map(f64::abs), &h) <= SETTLED {
            settled = Some(h);
            break;
        }
    }
    let Some(mut h) = settled.filter(|h| size * h > speed) else {
        return Err(10.0);
    };
    let off = (aside - sine[0]).abs();
    if off > FORGOTTEN {
        return Err(libm::log(off / FORGOTTEN));
    }
    let stop = roots(&q, h).ok().and_then(|roots| roots.first().copied());
    if let Some(stop) = stop {
        h = stop.at;
    }
    Ok(Creep {
        velocity: velocity(e, &q, &cosine, &sine),
        h,
        stops: stop.is_some(),
    })
}

/// With this size; and the series of its components along that and across.
pub(super) fn pull(a: &[Coefficients; 2], size: f64) -> ([f64; 2], Coefficients, Coefficients) {
    let e = [-a[0][0] / size, -a[1][0] / size];
    let mut along: Coefficients = std::array::from_fn(|k| -(a[0][k] * e[0] + a[1][k] * e[1]));
    let mut across: Coefficients = std::array::from_fn(|k| -(a[1][k] * e[0] - a[0][k] * e[1]));
    (along[0], across[0]) = (size, 0.0);
    // Of a fixed direction only rounding is left across it, which recurrences would amplify.
    for (k, c) in across.iter_mut().enumerate() {
        if c.abs() <= 4.0 * f64::EPSILON * libm::hypot(a[0][k], a[1][k]) {
            *c = 0.0;
        }
    }
    (e, along, across)
}

/// In the direction of these cosine and sine from `e`.
pub(super) fn velocity(
    e: [f64; 2],
    size: &Coefficients,
    cosine: &Coefficients,
    sine: &Coefficients,
) -> [Coefficients; 2] {
    let turned = |along: f64, across: f64| {
        std::array::from_fn(|k| along * product(size, cosine, k) + across * product(size, sine, k))
    };
    [turned(e[0], -e[1]), turned(e[1], e[0])]
}
