//! The promise of the intervals: what has a value is enclosed, and where something has none no bound is
//! claimed, neither at once nor by what is computed later.

use crate::certified::interval::Interval;
use crate::scalar::Scalar;
use proptest::prelude::*;
use std::f64::consts::{FRAC_PI_2, PI};

struct Function {
    name: &'static str,
    of: fn(Interval) -> Interval,
    at: fn(f64) -> f64,
    lacks: fn(Interval) -> bool,
    /// Of a quotient one bound is known next to a divisor 0.
    quotient: bool,
}

struct Operation {
    name: &'static str,
    of: fn(Interval, Interval) -> Interval,
    at: fn(f64, f64) -> f64,
    lacks: fn(Interval, Interval) -> bool,
    quotient: bool,
}

macro_rules! functions {
    ($($name:ident, $lacks:expr, $quotient:literal;)*) => {
        [$(Function {
            name: stringify!($name),
            of: <Interval as Scalar>::$name,
            at: <f64 as Scalar>::$name,
            lacks: $lacks,
            quotient: $quotient,
        }),*]
    };
}

fn is_zero(x: Interval) -> bool {
    x == Interval::point(0.0)
}

fn beyond_one(x: Interval) -> bool {
    x.lo() > 1.0 || x.hi() < -1.0
}

const FUNCTIONS: [Function; 14] = functions! {
    sin, |_| false, false;
    cos, |_| false, false;
    tan, |_| false, true;
    cot, is_zero, true;
    asin, beyond_one, false;
    acos, beyond_one, false;
    sinh, |_| false, false;
    cosh, |_| false, false;
    tanh, |_| false, true;
    coth, is_zero, true;
    exp, |_| false, false;
    ln, |x| x.hi() <= 0.0, false;
    sqrt, |x| x.hi() < 0.0, false;
    squared, |_| false, false;
};

const OPERATIONS: [Operation; 5] = [
    Operation {
        name: "+",
        of: |x, y| x + y,
        at: |x, y| x + y,
        lacks: |_, _| false,
        quotient: false,
    },
    Operation {
        name: "-",
        of: |x, y| x - y,
        at: |x, y| x - y,
        lacks: |_, _| false,
        quotient: false,
    },
    Operation {
        name: "*",
        of: |x, y| x * y,
        at: |x, y| x * y,
        lacks: |_, _| false,
        quotient: false,
    },
    Operation {
        name: "/",
        of: |x, y| x / y,
        at: |x, y| x / y,
        lacks: |_, y| is_zero(y),
        quotient: true,
    },
    Operation {
        name: "pow",
        of: Scalar::pow,
        at: Scalar::pow,
        lacks: |x, y| x.hi() < 0.0 && y.lo() == y.hi() && y.lo().fract() != 0.0,
        quotient: false,
    },
];

/// Ends of domains, changes of a function's way, and what is too large or too small for it.
const EDGES: [f64; 33] = [
    f64::NEG_INFINITY,
    f64::MIN,
    -1e300,
    -750.0,
    -700.0,
    -7.0,
    -PI,
    -3.0,
    -FRAC_PI_2,
    -1.5,
    -1.000_000_000_000_000_2,
    -1.0,
    -0.5,
    -1e-300,
    -5e-324,
    -0.0,
    0.0,
    5e-324,
    1e-300,
    0.5,
    0.75,
    1.0,
    1.000_000_000_000_000_2,
    FRAC_PI_2,
    2.0,
    3.0,
    PI,
    7.0,
    700.0,
    750.0,
    1e300,
    f64::MAX,
    f64::INFINITY,
];

fn edge_intervals() -> impl Iterator<Item = Interval> {
    let from = |i: usize| {
        EDGES[i..]
            .iter()
            .map(move |&hi| Interval::new(EDGES[i], hi))
    };
    (0..EDGES.len()).flat_map(from)
}

fn bound() -> impl Strategy<Value = f64> {
    prop_oneof![
        prop::sample::select(&EDGES[..]),
        -2.0..2.0,
        -20.0..20.0,
        -800.0..800.0,
    ]
}

fn interval() -> impl Strategy<Value = Interval> {
    (bound(), bound(), 0..4).prop_map(|(a, b, kind)| match kind {
        0 => Interval::point(a),
        1 => Interval::new(a, a + 1e-3 * b.abs()),
        _ => Interval::new(a.min(b), a.max(b)),
    })
}

fn numbers(x: Interval, parts: [f64; 3]) -> Vec<f64> {
    let (lo, hi) = (x.lo().max(-1e3), x.hi().min(1e3));
    let between = parts.map(|part| lo + part * (hi - lo));
    let all = [x.lo(), x.hi(), x.mid()]
        .into_iter()
        .chain(between)
        .chain(EDGES);
    all.filter(|&at| at.is_finite() && x.contains(at)).collect()
}

fn keeps(enclosure: Interval, value: f64, quotient: bool) -> bool {
    if value.is_finite() {
        // The number is rounded too.
        enclosure
            .widened(1e-13 * value.abs() + 1e-320)
            .contains(value)
    } else if value.is_nan() && !quotient {
        enclosure == Interval::WHOLE
    } else {
        !enclosure.is_bounded()
    }
}

type Formula = Vec<(usize, usize, usize)>;

fn steps<T: Copy>(
    formula: &Formula,
    start: [T; 2],
    function: impl Fn(&Function, T) -> T,
    operation: impl Fn(&Operation, T, T) -> T,
) -> Vec<T> {
    let mut all = start.to_vec();
    for &(which, i, j) in formula {
        let (x, y) = (all[i % all.len()], all[j % all.len()]);
        let which = which % (FUNCTIONS.len() + OPERATIONS.len());
        all.push(match FUNCTIONS.get(which) {
            Some(one) => function(one, x),
            None => operation(&OPERATIONS[which - FUNCTIONS.len()], x, y),
        });
    }
    all
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn what_has_a_value_is_enclosed_and_what_has_none_gets_no_bound(
        x in interval(), y in interval(), parts in prop::array::uniform3(0.0..1.0)
    ) {
        for Function { name, of, at, quotient, .. } in FUNCTIONS {
            for number in numbers(x, parts) {
                prop_assert!(keeps(of(x), at(number), quotient), "{name} {x:?} = {:?}, {number:e}", of(x));
            }
        }
        for Operation { name, of, at, quotient, .. } in OPERATIONS {
            for a in numbers(x, parts) {
                for b in numbers(y, parts) {
                    let all = of(x, y);
                    prop_assert!(keeps(all, at(a, b), quotient), "{x:?} {name} {y:?} = {all:?}, {a:e} {b:e}");
                }
            }
        }
    }

    #[test]
    fn a_bounded_enclosure_of_a_formula_holds_its_value_at_every_point(
        x in interval(), y in interval(), parts in prop::array::uniform3(0.0..1.0),
        formula in prop::collection::vec((any::<usize>(), any::<usize>(), any::<usize>()), 1..7),
    ) {
        let all = steps(&formula, [x, y], |f, x| (f.of)(x), |f, x, y| (f.of)(x, y));
        for (a, b) in numbers(x, parts).into_iter().zip(numbers(y, parts).into_iter().rev()) {
            // `None` where there surely is no value.
            let one = steps(
                &formula,
                [a, b].map(|at| Some(Interval::point(at))),
                |f, x| x.filter(|&x| !(f.lacks)(x)).map(f.of),
                |f, x, y| x.zip(y).filter(|&(x, y)| !(f.lacks)(x, y)).map(|(x, y)| (f.of)(x, y)),
            );
            for (all, one) in all.iter().zip(one) {
                let holds = one.map_or(!all.is_bounded(), |one| all.meet(one).is_some());
                prop_assert!(holds, "{formula:?} of {x:?}, {y:?}: {all:?}, but {one:?} at {a:e}, {b:e}");
            }
        }
    }
}

#[test]
fn nothing_later_makes_a_bound_of_what_has_none() {
    for x in edge_intervals().filter(|x| !x.is_bounded()) {
        let whole = x == Interval::WHOLE;
        let stays = |z: Interval| if whole { z == x } else { !z.is_bounded() };
        for Function { name, of, .. } in FUNCTIONS {
            assert!(stays(of(x)), "{name} {x:?} = {:?}", of(x));
        }
        for Operation { name, of, .. } in OPERATIONS {
            for y in edge_intervals() {
                assert!(stays(of(x, y)), "{x:?} {name} {y:?} = {:?}", of(x, y));
                assert!(stays(of(y, x)), "{y:?} {name} {x:?} = {:?}", of(y, x));
            }
        }
        assert!(stays(-x) && stays(x.hull(Interval::point(0.0))) && stays(x.widened(1.0)));
    }
}
