//! The tools of `numerics`.

use super::{SHAPES, any, config, each, finite, some};
use proptest::prelude::*;
use slipbook::numerics::{
    dop853, events, fit,
    number::Number,
    piecewise::Piecewise,
    quadrature,
    roots::{falling_root, root},
    series::{Series, arrival, product},
    taylor::{Control, System, TERMS, integrate, reach},
};
use std::cell::Cell;
use std::f64::consts::TAU;

/// `f`, and how often it has been asked.
fn counted(f: impl Fn(f64) -> f64) -> (impl Fn(f64) -> f64, std::rc::Rc<Cell<usize>>) {
    let count = std::rc::Rc::new(Cell::new(0));
    let inner = std::rc::Rc::clone(&count);
    let counting = move |x| {
        inner.set(inner.get() + 1);
        f(x)
    };
    (counting, count)
}

/// x′ = a x + b x².
struct Growth([f64; 2]);

impl System<f64, 1, TERMS> for Growth {
    type Work = ();
    fn begin(&self, _: &f64, _: &[f64; 1], (): &mut ()) {}
    fn derivative(&self, k: usize, [x]: &[Series<f64, TERMS>; 1], (): &mut ()) -> [f64; 1] {
        [self.0[0] * x[k] + self.0[1] * product(x, x, k)]
    }
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn a_root_lies_in_its_bracket([a, b, low, high] in each(), shape in 0..SHAPES.len()) {
        let (f, asked) = counted(|x| SHAPES[shape](a, b, x));
        if let Ok(found) = root(&f, low, high) {
            prop_assert!(found >= low.min(high) && found <= low.max(high), "{found}");
        }
        prop_assert!(asked.get() < 5000, "{}", asked.get());
        let (f, asked) = counted(|x| SHAPES[shape](a, b, x));
        falling_root(low, high, a, |x| (f(x), b));
        prop_assert!(asked.get() < 200, "{}", asked.get());
    }

    #[test]
    fn roots_of_a_series_lie_in_the_step(series in some(10), h in any()) {
        for found in events::roots(&series, h).into_iter().flatten() {
            prop_assert!(found.at.is_finite() && (0.0..=1.0).contains(&(found.at / h)), "{found:?}");
        }
    }

    #[test]
    fn a_series_serves_for_a_length_and_arrives_within_it(mut series in some(10), amount in any(), h in any()) {
        prop_assert!(reach(&series) >= 0.0 || !finite(&series), "{series:?}");
        series.extend([0.0, 0.0]);
        arrival(&series, amount, h);
    }

    #[test]
    fn an_integral_is_a_number([a, b, low, high] in each(), within in any(), shape in 0..SHAPES.len()) {
        let (f, asked) = counted(|x| SHAPES[shape](a, b, x));
        for found in [
            quadrature::integral(&f, low, high),
            quadrature::integral_within(&f, low, high, within),
        ].into_iter().flatten() {
            prop_assert!(finite(&[found.value, found.error]), "{found:?}");
        }
        prop_assert!(asked.get() < 1_000_000, "{}", asked.get());
    }

    #[test]
    fn a_fit_has_numbers(points in prop::collection::vec([any(), any()], 0..8)) {
        let data: Vec<_> = points.iter().map(|[x, y]| (*x, *y)).collect();
        if let Ok(found) = fit::fit(&data, &[&|_| 1.0, &|x| x, &|x| x * x]) {
            prop_assert!(finite(&found.coefficients) && finite(&found.errors), "{found:?}");
            prop_assert!(finite(&[found.residual, found.worst]), "{found:?}");
        }
    }

    #[test]
    fn pieces_have_values_everywhere([a, b, at] in each(), breaks in some(3), shape in 0..SHAPES.len()) {
        let (f, asked) = counted(|x| SHAPES[shape](a, b, x));
        if let Ok(found) = Piecewise::fit(&f, &breaks) {
            prop_assert!(finite(&[found.size(), found.integral()]), "{found:?}");
            let value = found.value(at);
            prop_assert!(value.is_finite() || !at.is_finite(), "{value}");
            let so_far = found.antiderivative(at % (10.0 * TAU));
            prop_assert!(so_far.is_finite() || !at.is_finite(), "{so_far}");
        }
        prop_assert!(asked.get() < 2_000_000, "{}", asked.get());
    }

    #[test]
    fn what_is_integrated_stays_finite([a, b, from, start, to, at] in each(), tolerance in any()) {
        for control in [Control::Each, Control::Largest] {
            if let Ok(path) = integrate(&Growth([a, b]), from, [start], to, control, 500) {
                prop_assert!(finite(&path.end) && path.steps.len() <= 500, "{path:?}");
                if let Ok([x]) = path.at(at) {
                    prop_assert!(x.is_finite(), "{x}");
                }
            }
        }
        let asked = Cell::new(0);
        let slope = |_: f64, [x]: &[f64; 1]| {
            asked.set(asked.get() + 1);
            [a * x + b * x * x]
        };
        if let Ok([x]) = dop853::end(slope, from, [start], to, tolerance, 1e-10) {
            prop_assert!(x.is_finite(), "{x}");
        }
        prop_assert!(asked.get() < 2_000_000, "{}", asked.get());
    }

    #[test]
    fn sums_with_a_carry_are_those_of_their_parts([sum, carry, delta] in each()) {
        let (new, rest) = f64::accumulate(&sum, &carry, &delta);
        prop_assert!(new.is_nan() || !new.is_finite() || rest.is_finite() || !carry.is_finite(), "{new} {rest}");
    }
}
