//! The symbols' units: in other units of length, time and mass every formula gives the same quantity.

use slipbook::book::files_below;
use slipbook::claims::formulas::formulas;
use slipbook::seeded::{Formula, symbol};
use slipbook::symbols::SYMBOLS;
use std::path::Path;

/// How a number with this unit grows when length, time and mass are counted in units that are smaller by these factors.
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

/// The units of a formula's arguments, one for each component; none where one has several.
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

/// What pages say, and what the code says and comments, each text on one line.
fn texts_in(folder: &str) -> impl Iterator<Item = (String, String)> {
    let files = files_below(&Path::new(env!("CARGO_MANIFEST_DIR")).join(folder)).unwrap();
    let texts = files
        .into_iter()
        .filter(|(name, _)| name.ends_with(".md") || name.ends_with(".rs"));
    texts.map(|(name, path)| {
        let text = std::fs::read_to_string(path).unwrap();
        let words: Vec<_> = text.split_whitespace().collect();
        (name, words.join(" "))
    })
}

/// A distance is one over μg/Ω², a speed one over μg/Ω, where the words before the unit speak of one of them alone.
#[test]
fn lengths_and_speeds_of_the_table_have_their_own_units() {
    let lengths = [
        "distance",
        "length",
        "radius",
        "place",
        "position",
        "ξ",
        "where a particle",
        "ρ, in",
        "σ ",
    ];
    let speeds = ["speed", "velocity", "how fast", "p, in"];
    let mut asked = 0;
    for (path, text) in ["book/src", "src"].into_iter().flat_map(texts_in) {
        for unit in [r"\mu g/\Omega", r"\\mu g/\\Omega", "μg/Ω"] {
            for (at, _) in text.match_indices(unit) {
                let squared = text[at + unit.len()..].starts_with(['^', '²']);
                let near = text[..at]
                    .char_indices()
                    .rev()
                    .nth(150)
                    .map_or(0, |(i, _)| i);
                let before = text[near..at].to_lowercase();
                let [length, speed] = [&lengths[..], &speeds]
                    .map(|words| words.iter().any(|word| before.contains(word)));
                if length != speed {
                    assert_eq!(squared, length, "{path}: …{before}{unit}");
                    asked += 1;
                }
            }
        }
    }
    assert!(asked > 0);
}
