//! The symbols' units: in other units of length, time and mass every formula gives the same quantity.

use slipbook::claims::formulas::formulas;
use slipbook::seeded::{Formula, symbol};
use slipbook::symbols::SYMBOLS;

/// When length, time and mass are counted in units that are smaller by these factors.
fn growth(unit: &str, [length, time, mass]: [f64; 3]) -> Option<f64> {
    let product = |factors: &str| -> Option<f64> {
        let one = |factor: &str| {
            let (name, power) = match factor.strip_suffix('²') {
                Some(name) => (name, 2),
                None => (factor, 1),
            };
            let base = match name {
                "1" | "radians" => 1.0,
                "length" => length,
                "time" => time,
                "mass" => mass,
                _ => return None,
            };
            Some(f64::powi(base, power))
        };
        factors.split('·').map(one).product()
    };
    match unit.split_once('/') {
        Some((above, below)) => Some(product(above)? / product(below)?),
        None => product(unit),
    }
}

fn units(formula: &Formula<f64>) -> Option<Vec<&'static str>> {
    let module = formula.path.rsplit_once("::")?.0;
    let mut units = Vec::new();
    let mut letters = formula.symbols.iter().peekable();
    for argument in formula.arguments {
        let symbol = symbol(SYMBOLS, module, argument)?;
        let mut own = 0;
        while letters
            .next_if(|l| **l == symbol.plain && own == 0 || symbol.parts.contains(l))
            .is_some()
        {
            own += 1;
            units.push(symbol.unit);
        }
    }
    (letters.next().is_none() && units.iter().all(|u| !u.contains(','))).then_some(units)
}

#[test]
fn a_formula_gives_the_same_in_other_units() {
    let mut random = fastrand::Rng::with_seed(7);
    let (mut asked, mut failures) = (0, Vec::new());
    for formula in formulas::<f64>() {
        let Some(units) = units(&formula) else {
            continue;
        };
        if units.iter().all(|unit| ["1", "radians"].contains(unit)) {
            continue;
        }
        let points = (0..200).map(|_| units.iter().map(|_| random.f64()).collect::<Vec<_>>());
        let at = |x: &[f64], by: [f64; 3]| {
            let there = x
                .iter()
                .zip(&units)
                .map(|(x, u)| x * growth(u, by).unwrap());
            (formula.value)(&there.collect::<Vec<_>>())
        };
        let mut known = 0;
        let holds = points.into_iter().all(|x| {
            let here = at(&x, [1.0; 3]);
            [[4.0, 1.0, 1.0], [1.0, 4.0, 1.0], [1.0, 1.0, 4.0]]
                .into_iter()
                .all(|by| {
                    here.iter().zip(at(&x, by)).all(|(here, there)| {
                        let power = libm::log2(there / here);
                        if !power.is_finite() {
                            return true;
                        }
                        known += 1;
                        (power - libm::round(power)).abs() < 1e-9
                    })
                })
        });
        asked += usize::from(known > 0);
        if !holds {
            failures.push(formula.path);
        }
    }
    assert!(failures.is_empty(), "{failures:#?}");
    assert!(asked > 40, "{asked}");
}
