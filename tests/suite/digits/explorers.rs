//! What the explorer of the sphere shows, four digits after the point, against an integration in numbers of 31 digits.

use super::{Room, TERMS, cases};
use slipbook::explorers::sphere;
use slipbook::numerics::{
    double::Double,
    number::Real,
    series::{product, sqrt, square, value},
    taylor::{Control, Integrator, Step, System},
};
use std::f64::consts::{PI, TAU};

/// With room for its rounding.
const SHOWN: f64 = 1e-8;

/// u′ = sin φ x̂ − λ₀ u/|u|, dφ = |u| ds; components φ, u_x, u_y, sin φ, cos φ.
struct Slip(Double);

impl System<Double, 5, TERMS> for Slip {
    /// |u|² and |u|.
    type Work = Room<2>;

    fn begin(&self, _: &Double, _: &[Double; 5], _: &mut Room<2>) {}

    fn derivative(&self, k: usize, x: &[[Double; TERMS]; 5], room: &mut Room<2>) -> [Double; 5] {
        let [_, u, v, sine, cosine] = x;
        let Room([squared, size]) = room;
        squared[k] = square(u, k) + square(v, k);
        size[k] = sqrt(squared, size, k);
        [
            size[k],
            product(size, sine, k) - self.0 * u[k],
            -(self.0 * v[k]),
            product(size, cosine, k),
            -product(size, sine, k),
        ]
    }
}

/// Where a slip in the plane ends, or how large it is at the time `until`; nothing where it takes too long.
fn slips(lambda0: f64, slip: [f64; 2], until: f64) -> Option<Result<f64, f64>> {
    let [u, v, zero, one, friction] = [slip[0], slip[1], 0.0, 1.0, lambda0].map(Double::from);
    let system = Slip(friction);
    let state = [zero, u, v, zero, one];
    let mut integrator = Integrator::<_, _, 5, TERMS>::new(&system, zero, state, Control::Each);
    let mut step = Step::empty();
    for _ in 0..2000 {
        let &[phi, u, v, ..] = integrator.state();
        if u.hypot(v).to_f64() < 1e-20 {
            return Some(Ok(phi.to_f64()));
        }
        integrator.expand(&mut step).ok()?;
        if value(&step.series[0], &Double::from(step.h)).to_f64() >= until {
            let [mut low, mut high] = [0.0, step.h];
            while high - low > 1e-15 * step.h {
                let middle = 0.5 * (low + high);
                let early = value(&step.series[0], &Double::from(middle)).to_f64() < until;
                *(if early { &mut low } else { &mut high }) = middle;
            }
            let [_, u, v, ..] = step.at(&Double::from(low));
            return Some(Err(u.hypot(v).to_f64()));
        }
        integrator.advance(&step);
    }
    None
}

/// From `phi` with u there, by the integral of sin φ ∓ λ₀; and the slip at the time `until`. Rolling lasts until |sin φ| = λ₀.
fn along(lambda0: f64, mut phi: f64, mut u: f64, until: f64) -> (Vec<[f64; 2]>, f64) {
    let mut rolls = Vec::new();
    loop {
        if u == 0.0 && phi.sin().abs() <= lambda0 {
            let begin = phi;
            let release = lambda0.min(1.0).asin();
            let released = |k: i32| f64::from(k) * PI + release;
            phi = (0..).map(released).find(|end| *end >= begin).unwrap();
            if lambda0 >= 1.0 || phi >= until {
                rolls.push([begin, until]);
                return (rolls, 0.0);
            }
            rolls.push([begin, phi]);
        }
        // Just after the release sin φ has grown beyond λ₀.
        let sign = if u == 0.0 {
            phi.sin().signum()
        } else {
            u.signum()
        };
        let slip = |at: f64| sign * (u + phi.cos() - at.cos()) - lambda0 * (at - phi);
        let steps = (1..).map(|k| phi + 1e-3 * f64::from(k));
        let Some(after) = steps
            .take_while(|at| *at < until + 1e-3)
            .find(|at| slip(*at) < 0.0)
        else {
            return (rolls, slip(until));
        };
        let [mut low, mut high] = [(after - 1e-3).max(phi), after];
        while high - low > 1e-14 {
            let middle = 0.5 * (low + high);
            *(if slip(middle) > 0.0 {
                &mut low
            } else {
                &mut high
            }) = middle;
        }
        if low >= until {
            return (rolls, slip(until));
        }
        (phi, u) = (low, 0.0);
    }
}

#[test]
fn the_sphere() {
    let mut rng = fastrand::Rng::with_seed(23);
    let (until, wanted) = (4.0 * TAU, cases(300));
    let (mut tried, mut rolled) = (0, 0);
    while tried < wanted {
        let lambda0 = 0.02 + 1.4 * rng.f64();
        let kappa = 0.05 + 0.95 * rng.f64();
        let v = if rng.bool() {
            0.0
        } else {
            4.0 * rng.f64() - 2.0
        };
        let slip = [4.0 * rng.f64() - 2.0, v];
        let case = format!("{lambda0} {kappa} {slip:?}");
        let (rolls, end) = if v == 0.0 {
            along(lambda0, 0.0, slip[0], until)
        } else {
            match slips(lambda0, slip, until) {
                Some(Ok(phi)) => along(lambda0, phi, 0.0, until),
                Some(Err(size)) => (Vec::new(), size),
                None => continue,
            }
        };
        tried += 1;
        let share = rolls.iter().map(|[a, b]| (b - a.max(until - TAU)).max(0.0));
        let mut exact = vec![
            1.0 + 1.0 / kappa,
            rolls.first().map_or(-1.0, |[begin, _]| *begin),
            share.sum::<f64>() / TAU,
            end.abs(),
            rolls.len() as f64,
        ];
        exact.extend(rolls.iter().flatten());
        let values = sphere::motion(lambda0, kappa, slip).unwrap().values;
        assert_eq!(
            values.len(),
            exact.len(),
            "{case}: {values:?}, right is {exact:?}"
        );
        for (value, exact) in values.iter().zip(&exact) {
            assert!(
                (value - exact).abs() < SHOWN,
                "{case}: {value}, right is {exact}"
            );
        }
        rolled += usize::from(!rolls.is_empty());
    }
    assert!(rolled > wanted / 10);
}
