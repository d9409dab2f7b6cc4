//! A third look at the certificates, beside what wrote them and `certificates/check.py`, which is complete.

mod modular;
mod roots;

use modular::{Unknown, list, place};
use rayon::prelude::*;
use serde_json::Value;
use slipbook::claims::PAPER;
use std::collections::BTreeSet;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::LazyLock;

/// A change of a witness.
type Spoil<'a> = &'a dyn Fn(&mut Value);

/// A witness, with its claim and trial, and with what that says if it is no exact proof.
struct Left {
    name: String,
    says: String,
    witness: Value,
}

/// The witnesses of all proofs but those of motions.
fn witnesses() -> Vec<Left> {
    let trials = PAPER
        .claims()
        .flat_map(|(_, claim)| claim.trials.iter().map(|trial| (claim.id, trial)));
    let trials: Vec<_> = trials.collect();
    let left = trials.into_par_iter().flat_map_iter(|(id, trial)| {
        let (says, left) = match trial.statement() {
            Some(statement) => {
                let (_, left) = trialbook::witness::of(|| statement.proof());
                (String::new(), left)
            }
            // Motions are enclosed there, which takes too long.
            None if id == "s4-envelope-is-boundary" => (String::new(), Vec::new()),
            // Whether a function proves or measures is known once it has.
            None => match trialbook::witness::of(|| trial.evidence()) {
                (evidence, left) if evidence.route.is_proof() => (evidence.comparison(), left),
                _ => (String::new(), Vec::new()),
            },
        };
        left.into_iter().map(move |witness| Left {
            name: format!("{id} {}", trial.name()),
            says: says.clone(),
            witness: serde_json::to_value(witness).unwrap(),
        })
    });
    left.collect()
}

/// Proved once for all tests.
static WITNESSES: LazyLock<Vec<Left>> = LazyLock::new(witnesses);

fn of_kind(kind: &str) -> impl Iterator<Item = &'static Left> {
    let all = WITNESSES.iter();
    all.filter(move |left| left.witness["kind"] == kind)
}

#[test]
fn the_equations_hold_for_numbers_modulo_a_prime_and_no_others_do() {
    let mut random = fastrand::Rng::with_seed(1);
    let (mut right, mut beyond, mut spoilt, mut missed) = (0_usize, Vec::new(), 0, Vec::new());
    for Left { name, witness, .. } in of_kind("identity") {
        match modular::holds(witness, &mut random) {
            Ok(true) => right += 1,
            Ok(false) => panic!("{name}: {} does not hold", witness["title"]),
            Err(Unknown) => {
                beyond.push(format!("{name}: {}", witness["title"]));
                continue;
            }
        }
        // Another value on a side of each equation.
        let proved = list(&witness["equal"]).len() - usize::from(witness["fails"] == true);
        for i in 0..proved {
            let mut wrong = witness.clone();
            let left = place(&wrong["equal"][i]["left"]);
            let parts = wrong["parts"].as_array_mut().unwrap();
            parts.push(serde_json::json!({"read": "7"}));
            let last = parts.len();
            parts.push(serde_json::json!({"sum": [left, last - 1]}));
            wrong["equal"][i]["left"] = last.into();
            spoilt += 1;
            if modular::holds(&wrong, &mut random).unwrap_or(false) {
                missed.push(name.clone());
            }
        }
    }
    assert!(missed.is_empty(), "{missed:?}");
    assert!(right > 0 && spoilt > 0);
    // Beyond it are those with series, with values put in for what others are made of, and with products of more powers than it tries.
    assert!(10 * beyond.len() < right, "{beyond:#?}");
}

#[test]
fn roots_are_where_they_are_said_to_be_and_nowhere_else() {
    assert!(of_kind("root").next().is_some());
    for Left { name, witness, .. } in of_kind("root") {
        assert_eq!(roots::check(witness), Ok(()), "{name}");
        let spoilt = |change: &dyn Fn(&mut Value)| {
            let mut wrong = witness.clone();
            change(&mut wrong);
            roots::check(&wrong)
        };
        // Another root, another box, another function, another matrix.
        let changes: [(&str, Spoil<'_>); 4] = [
            ("the root", &|w| w["root"][0] = "3*2^0".into()),
            ("a corner", &|w| {
                w["within"][0][1] = w["within"][0][0].clone()
            }),
            ("a corner", &|w| {
                w["functions"][0] = serde_json::json!(["+", w["functions"][0], "1"])
            }),
            ("the image", &|w| w["preconditioner"][0][0] = "0".into()),
        ];
        for (what, change) in changes {
            assert_eq!(spoilt(change), Err(what), "{name}");
        }
    }
}

/// How each part of a proof is made, from what is read on, in a number; and whether a name occurs in it.
fn makings(witness: &Value) -> Vec<(u64, bool)> {
    fn letters(tree: &Value) -> bool {
        match tree {
            Value::Array(all) => all.iter().skip(1).any(letters),
            Value::String(leaf) => leaf.chars().any(char::is_alphabetic),
            _ => false,
        }
    }
    let mut made: Vec<(u64, bool)> = Vec::new();
    for part in list(&witness["parts"]) {
        let (kind, of) = part.as_object().unwrap().iter().next().unwrap();
        let mut hash = DefaultHasher::new();
        kind.hash(&mut hash);
        // Earlier parts stand by their places.
        let mut named = match kind.as_str() {
            "read" => letters(of),
            "element" => !list(&of["above"])
                .iter()
                .all(|term| list(&term[1]).is_empty()),
            _ => true,
        };
        match kind.as_str() {
            "read" | "element" => of.to_string().hash(&mut hash),
            "sum" | "difference" | "product" | "quotient" | "raised" => {
                let both = [0, 1].map(|i| made[place(&of[i])]);
                both.hash(&mut hash);
                named = both.iter().any(|(_, named)| *named);
            }
            "negative" => {
                made[place(of)].hash(&mut hash);
                named = made[place(of)].1;
            }
            "derivative" | "put" => {
                made[place(&of[0])].hash(&mut hash);
                for pair in list(&of[1]) {
                    (place(&pair[0]), made[place(&pair[1])]).hash(&mut hash);
                }
            }
            "coefficient" => (made[place(&of[0])], of[1].to_string()).hash(&mut hash),
            "series" => {
                of[0].to_string().hash(&mut hash);
                for series in list(&of[1]) {
                    (series[0].to_string(), series[1].to_string()).hash(&mut hash);
                    for c in list(&series[2]) {
                        made[place(c)].hash(&mut hash);
                    }
                }
            }
            _ => panic!("a part of another kind: {kind}"),
        }
        made.push((hash.finish(), named));
    }
    made
}

/// An equation that stands twice in a proof has taken the place of another one, as a rule; of mere numbers many do.
#[test]
fn no_equation_is_compared_twice() {
    let mut repeated = BTreeSet::new();
    for Left { name, witness, .. } in of_kind("identity") {
        let made = makings(witness);
        let mut seen = BTreeSet::new();
        for equal in list(&witness["equal"]) {
            let sides =
                ["left", "right"].map(|side| equal[side].as_u64().map(|at| made[at as usize]));
            let mut pair = sides.map(|side| side.map(|(hash, _)| hash));
            // What is compared with itself is equal whatever it is.
            assert_ne!(pair[0], pair[1], "{}: {}", witness["title"], equal["says"]);
            pair.sort_unstable();
            let named = sides.iter().flatten().any(|(_, named)| *named);
            if !seen.insert(pair) && named {
                repeated.insert(name.split(' ').next().unwrap());
            }
        }
    }
    // There two different things come to the same formulas.
    assert_eq!(
        repeated.into_iter().collect::<Vec<_>>(),
        ["s21-friction-cannot-hold", "s4-quasi-fixed-stability",]
    );
}

/// The numbers between which words say that something lies, as `0.97\le q\le1.03` or `(4.4,4.6)`.
fn ranges(words: &str) -> Vec<[f64; 2]> {
    let number = |text: &str| text.trim().parse::<f64>().ok();
    let chains = words.split(['$', ',']).filter_map(|formula| {
        let sides: Vec<_> = formula
            .split(r"\le")
            .map(|side| side.trim_start_matches(' '))
            .collect();
        match sides.as_slice() {
            [low, _, high] => Some([number(low)?, number(high)?]),
            _ => None,
        }
    });
    let pairs = words.split('(').filter_map(|after| {
        let (inside, _) = after.split_once(')')?;
        let (low, high) = inside.split_once(',')?;
        Some([number(low)?, number(high)?])
    });
    chains.chain(pairs).collect()
}

#[test]
fn ranges_in_the_words_of_a_certificate_are_those_of_its_witnesses() {
    assert_eq!(
        ranges(r"one in $0.97\le q\le1.03$, $0.525\le\lambda_0\le0.55$, or in $(4.4,4.6)$ by (54)"),
        [[0.97, 1.03], [0.525, 0.55], [4.4, 4.6]]
    );
    let all: Vec<_> = WITNESSES
        .iter()
        .filter(|left| !left.says.is_empty())
        .collect();
    let mut found = 0;
    for Left { name, says, .. } in &all {
        let boxes = || {
            let own = all.iter().filter(|left| left.name == *name);
            own.flat_map(|left| list(&left.witness["within"]))
                .map(|side| [0, 1].map(|end| roots::number(&side[end])))
        };
        for range in ranges(says) {
            found += 1;
            // The box of a root is rounded outwards to multiples of 2⁻²⁰.
            let near = |side: [f64; 2]| (0..2).all(|end| (side[end] - range[end]).abs() < 2e-6);
            assert!(boxes().any(near), "{name}: {range:?} of {says}");
        }
    }
    assert!(found > 0);
}
