//! Validated integration: steps that enclose every motion from every start of a box (Moore; Lohner). Picard's
//! iteration finds a box B with x + \[0, h\] f(B) ⊂ B; Taylor's series is summed with the last coefficient
//! taken over B, also for the middle m and for the matrix J of derivatives by the start: the result is also
//! within φ(m) + J (x − m).

mod tilted;

pub use tilted::Tilted;

use super::{error::CertifiedError, interval::Interval};
use crate::numerics::{
    number::Number,
    series::Series,
    taylor::{Control, Integrator, Step, System},
};

/// Coefficients of a series; the last one is that of the remainder.
pub const TERMS: usize = 18;

/// By how much steps shrink until one encloses well, and grow again.
const LONGEST: f64 = 1.0;
const SHRINK: f64 = 0.7;
const GROW: f64 = 1.2;

/// How wide what the series leaves out may be, unless the steps become shorter than [`SHORT`] for it.
const ACCURACY: f64 = 1e-14;
const SHORT: f64 = 0.1;

/// Steps below this are none.
const SHORTEST: f64 = 1e-9;

/// A state of three components, then its derivatives by three of the start, row by row.
pub type Extended = [Interval; 12];

fn extended(state: [Interval; 3]) -> Extended {
    std::array::from_fn(|i| match i {
        0..3 => state[i],
        _ => Interval::point(if (i - 3) % 4 == 0 { 1.0 } else { 0.0 }),
    })
}

/// One step of a system without explicit time; the state after it. `h` is the length to try first, and
/// becomes the one to try next.
///
/// # Errors
/// [`CertifiedError::NotProved`] if no box is found that the motions do not leave.
pub fn step<S: System<Interval, 12, TERMS> + System<Interval, 3, TERMS>>(
    system: &S,
    state: &[Interval; 3],
    h: &mut f64,
) -> Result<[Interval; 3], CertifiedError> {
    *h = h.min(LONGEST);
    while *h > SHORTEST {
        if let Some(next) = attempt(system, state, *h) {
            *h *= GROW;
            return Ok(next);
        }
        *h *= SHRINK;
    }
    Err(CertifiedError::unproved(
        "no step encloses the motion",
        state,
    ))
}

fn attempt<S: System<Interval, 12, TERMS> + System<Interval, 3, TERMS>>(
    system: &S,
    state: &[Interval; 3],
    h: f64,
) -> Option<[Interval; 3]> {
    let middle = state.map(Interval::mid);
    let Image { all, centre } = image::<S, TERMS>(system, state, middle, h, ACCURACY)?;
    let mut next = *state;
    for i in 0..3 {
        let mut value = centre[i];
        for j in 0..3 {
            value = value + all[3 + 3 * i + j] * (state[j] - Interval::point(middle[j]));
        }
        next[i] = value.meet(all[i])?;
    }
    Some(next)
}

struct Image {
    all: Extended,
    centre: [Interval; 3],
}

/// By series of `N` terms, the last for the remainder, which is at most `accuracy` wide unless the step is short.
fn image<S, const N: usize>(
    system: &S,
    state: &[Interval; 3],
    middle: [f64; 3],
    h: f64,
    accuracy: f64,
) -> Option<Image>
where
    S: System<Interval, 12, N> + System<Interval, 3, N>,
{
    let start = extended(*state);
    let walls = walls(system, &start, h)?;
    let rest = series::<S, 12, N>(system, &walls)?.map(|x| x[N - 1]);
    let left_out = |x: &Interval| x.width() * h.powi(N as i32 - 1);
    if h > SHORT && rest[..3].iter().any(|x| left_out(x) > accuracy) {
        return None;
    }
    let sum = |series: &Series<Interval, N>, rest| {
        let length = Interval::point(h);
        (0..N - 1)
            .rev()
            .fold(rest, |sum, k| sum * length + series[k])
    };
    let all = series::<S, 12, N>(system, &start)?;
    let centre = series::<S, 3, N>(system, &middle.map(Interval::point))?;
    Some(Image {
        all: std::array::from_fn(|i| sum(&all[i], rest[i])),
        centre: std::array::from_fn(|i| sum(&centre[i], rest[i])),
    })
}

fn series<S: System<Interval, D, N>, const D: usize, const N: usize>(
    system: &S,
    start: &[Interval; D],
) -> Option<[Series<Interval, N>; D]> {
    let zero = Interval::from_f64(0.0);
    let mut integrator = Integrator::new(system, zero, *start, Control::Largest);
    let mut step = Step::empty();
    integrator.expand(&mut step).ok()?;
    Some(step.series)
}

fn reached<S: System<Interval, 12, N>, const N: usize>(
    system: &S,
    start: &Extended,
    h: f64,
    walls: &Extended,
) -> Extended {
    let time = Interval::new(0.0, h);
    let mut work = S::Work::default();
    system.begin(&Interval::point(0.0), walls, &mut work);
    let zero = Interval::point(0.0);
    let constant = walls.map(|x| std::array::from_fn(|k| if k == 0 { x } else { zero }));
    let slope = system.derivative(0, &constant, &mut work);
    std::array::from_fn(|i| start[i] + time * slope[i])
}

/// A box that no motion from `start` leaves within the time `h`.
fn walls<S: System<Interval, 12, N>, const N: usize>(
    system: &S,
    start: &Extended,
    h: f64,
) -> Option<Extended> {
    let mut walls = *start;
    for _ in 0..8 {
        let next = reached(system, start, h, &walls);
        if next.iter().zip(&walls).all(|(a, b)| a.within(*b)) {
            return Some(next);
        }
        // Farther than necessary, or the iteration would not end.
        walls = next.map(|x| x.widened(0.2 * x.width() + 1e-9));
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numerics::series::product;
    use crate::scalar::Scalar;

    /// x′ = y, y′ = −x, z′ = z², with the derivatives by the start.
    pub(super) struct Known;

    impl<const N: usize> System<Interval, 3, N> for Known {
        type Work = ();

        fn begin(&self, _: &Interval, _: &[Interval; 3], (): &mut ()) {}

        fn derivative(&self, k: usize, x: &[Series<Interval, N>; 3], (): &mut ()) -> [Interval; 3] {
            [x[1][k], -x[0][k], product(&x[2], &x[2], k)]
        }
    }

    impl<const N: usize> System<Interval, 12, N> for Known {
        type Work = ();

        fn begin(&self, _: &Interval, _: &Extended, (): &mut ()) {}

        fn derivative(&self, k: usize, x: &[Series<Interval, N>; 12], (): &mut ()) -> Extended {
            std::array::from_fn(|i| match i {
                0 | 3..6 => x[if i == 0 { 1 } else { i + 3 }][k],
                1 | 6..9 => -x[if i == 1 { 0 } else { i - 3 }][k],
                2 => product(&x[2], &x[2], k),
                _ => product(&x[2], &x[i], k) + product(&x[2], &x[i], k),
            })
        }
    }

    #[test]
    fn known_motions_are_enclosed() {
        let (mut state, mut h) = ([1.0, 0.0, 0.1].map(Interval::point), 1.0);
        for _ in 0..12 {
            state = step(&Known, &state, &mut h).unwrap();
            let t = Interval::int(10) - Interval::int(1) / state[2];
            let expected = [t.cos(), -t.sin()];
            for (x, expected) in state.iter().zip(expected) {
                assert!(
                    x.meet(expected).is_some() && x.width() < 1e-10,
                    "{x} {expected}"
                );
            }
        }
    }

    #[test]
    fn a_box_keeps_its_size_while_it_turns() {
        let mut state = [
            Interval::new(0.99, 1.01),
            Interval::new(-0.01, 0.01),
            Interval::point(0.01),
        ];
        let mut h = 0.25;
        state = step(&Known, &state, &mut h).unwrap();
        // A square of this size, turned by 1/4.
        let size = 0.02 * (libm::cos(0.25) + libm::sin(0.25));
        assert!(state[0].width() < 1.001 * size && state[0].width() > 0.999 * size);
    }

    #[test]
    fn a_motion_to_infinity_is_not_followed() {
        let (mut state, mut h) = ([1.0, 0.0, 10.0].map(Interval::point), 1.0);
        let steps = (0..1000).map_while(|_| {
            state = step(&Known, &state, &mut h).ok()?;
            Some(())
        });
        assert!(steps.count() < 1000);
    }

    /// z′ = `factor` z², with the derivatives by the start; the others rest.
    struct Growing {
        factor: Interval,
    }

    impl System<Interval, 3, TERMS> for Growing {
        type Work = ();

        fn begin(&self, _: &Interval, _: &[Interval; 3], (): &mut ()) {}

        fn derivative(
            &self,
            k: usize,
            x: &[Series<Interval, TERMS>; 3],
            (): &mut (),
        ) -> [Interval; 3] {
            let zero = Interval::point(0.0);
            [zero, zero, self.factor * product(&x[2], &x[2], k)]
        }
    }

    impl System<Interval, 12, TERMS> for Growing {
        type Work = ();

        fn begin(&self, _: &Interval, _: &Extended, (): &mut ()) {}

        fn derivative(&self, k: usize, x: &[Series<Interval, TERMS>; 12], (): &mut ()) -> Extended {
            std::array::from_fn(|i| match i {
                2 => self.factor * product(&x[2], &x[2], k),
                9.. => self.factor * (product(&x[2], &x[i], k) + product(&x[2], &x[i], k)),
                _ => Interval::point(0.0),
            })
        }
    }

    #[test]
    fn walls_hold_the_motion_and_little_else() {
        let h = 0.125;
        let start = [1.0, 0.0, 0.5].map(Interval::point);
        let [x, y, z, ..] = walls::<_, TERMS>(&Known, &extended(start), h).unwrap();
        let time = Interval::point(h);
        let end = [
            (x, time.cos()),
            (y, -time.sin()),
            (z, Interval::int(1) / (Interval::int(2) - time)),
        ];
        for ((wall, end), start) in end.into_iter().zip(start) {
            assert!(start.within(wall) && end.within(wall), "{wall} {end}");
            assert!(
                wall.width() < 1.05 * end.hull(start).width() + 0.015,
                "{wall}"
            );
        }
    }

    #[test]
    fn the_remainder_of_a_step_is_counted_once() {
        // z = z₀/(1 − factor z₀ t), so small that what the series leaves out shows: 0.2¹⁷ against 2⁻⁵³.
        let start = Interval::point(libm::ldexp(1.0, -20));
        let factor = Interval::point(libm::ldexp(0.2, 20));
        let zero = Interval::point(0.0);
        let [_, _, z] = attempt(&Growing { factor }, &[zero, zero, start], 1.0).unwrap();
        let expected = start / (Interval::int(1) - factor * start);
        assert!(z.meet(expected).is_some(), "{z} {expected}");
        assert!(z.width() < 1e-8 * z.hi(), "{z}");
    }

    #[test]
    fn long_steps_are_taken_only_where_little_is_left_out() {
        let (factor, zero) = (Interval::point(1.0), Interval::point(0.0));
        let tried = |z: f64, h: f64| {
            let state = [zero, zero, Interval::point(z)];
            let walls = walls(&Growing { factor }, &extended(state), h).unwrap();
            // The coefficient of t¹⁷ in z/(1 − z t) is z¹⁸.
            let power = |x: f64| libm::pow(x, 18.0);
            let left_out = (power(walls[2].hi()) - power(walls[2].lo())) * libm::pow(h, 17.0);
            (left_out, attempt(&Growing { factor }, &state, h).is_some())
        };
        let mut taken = 0;
        for k in 0..=20 {
            let (left_out, done) = tried(0.9 + 0.02 * f64::from(k), 0.125);
            assert_eq!(done, left_out <= 1e-14, "{k}: {left_out}");
            taken += usize::from(done);
        }
        assert!(0 < taken && taken < 21, "{taken}");
        let (left_out, done) = tried(2.0, 0.1);
        assert!(left_out > 1e-12 && done, "{left_out}");
    }
}
