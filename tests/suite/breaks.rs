//! "Break it yourself": the module in the page is made of the crate's formulas and trials, and gives its answers.

use crate::{LEDGER, Page};
use serde_json::{Value, json, to_value};
use slipbook::breaks::{TOPICS, answer, breaks, claims, made};
use std::collections::BTreeMap;

fn read(bytes: &[u8]) -> Value {
    let (length, json) = bytes.split_at(4);
    let length = u32::from_le_bytes(length.try_into().unwrap());
    serde_json::from_slice(&json[..length as usize]).unwrap()
}

const REBUILD: &str = "run `book/breaks/rebuild`, which adds the target wasm32-unknown-unknown to the toolchain, and commit book/theme/breaks.wasm";

#[test]
fn the_module_in_the_page_is_made_of_these_formulas_and_trials() {
    let mut page = Page::open(include_bytes!("../../book/theme/breaks.wasm"));
    let rows = read(page.call("claims", ()));
    let rows = rows.as_array().unwrap();
    let known = (0_u32..).zip(rows).map(|(number, row)| {
        let id = row[0].as_str().unwrap().to_owned();
        (id, read(page.call("made", number)))
    });
    let mut known: BTreeMap<_, _> = known.collect();
    let mut old = Vec::new();
    for claim in claims() {
        let now = to_value(made(claim)).unwrap();
        match known.remove(claim.id) {
            None => old.push(format!("{}: the module does not have it", claim.id)),
            Some(was) => {
                old.extend(difference(&was, &now).map(|what| format!("{}: {what}", claim.id)))
            }
        }
    }
    old.extend(
        known
            .into_keys()
            .map(|id| format!("{id}: it is in the module, and no claim with a formula")),
    );
    assert!(
        old.is_empty(),
        "book/theme/breaks.wasm is not of these sources:\n{}\nWhat to do: {REBUILD}.",
        old.join("\n")
    );
}

fn difference(was: &Value, now: &Value) -> Option<String> {
    let all = |value: &Value| -> Vec<Value> {
        match value {
            Value::Array(all) => all.clone(),
            Value::Object(all) => all.values().cloned().collect(),
            _ => Vec::new(),
        }
    };
    let [a, b] = [was, now].map(all);
    let close = match (was.as_f64(), now.as_f64()) {
        (Some(x), Some(y)) => (x - y).abs() <= 1e-9 * x.abs().max(y.abs()).max(1.0),
        _ => was == now || a.len() == b.len() && !a.is_empty(),
    };
    match close {
        false => Some(format!("{was} is now {now}")),
        true => a.iter().zip(&b).find_map(|(a, b)| difference(a, b)),
    }
}

/// With the fewest comparisons of each topic: it takes long.
#[test]
fn the_module_in_the_page_gives_the_answers_of_the_crate() {
    let mut page = Page::open(include_bytes!("../../book/theme/breaks.wasm"));
    let rows = read(page.call("claims", ()));
    let rows = rows.as_array().unwrap().iter();
    let ids: Vec<_> = rows
        .map(|row| row[0].as_str().unwrap().to_owned())
        .collect();
    let all = claims();
    let fewest = TOPICS.map(|topic| {
        let own =
            (0..all.len()).filter(|n| topic.claims().iter().any(|claim| claim.id == all[*n].id));
        let points = |id| -> usize {
            let evidence = LEDGER.entry(id).map(|entry| &entry.evidence);
            evidence.into_iter().flatten().map(|e| e.points).sum()
        };
        own.min_by_key(|n| points(all[*n].id))
    });
    for number in fewest.into_iter().flatten() {
        let claim = all[number];
        let ways = breaks(claim.id);
        for i in [0, ways.len() - 1] {
            let place = ids.iter().position(|id| id == claim.id);
            let place =
                place.unwrap_or_else(|| panic!("{} is not in the module: {REBUILD}", claim.id));
            let found = read(page.call("broken", (place as u32, i as u32)));
            let expected = to_value(answer(claim, ways[i].seed)).unwrap();
            assert_eq!(
                outcomes(&found),
                outcomes(&expected),
                "{} answers otherwise in book/theme/breaks.wasm: {REBUILD}",
                claim.id
            );
        }
    }
    let beyond = read(page.call("broken", (0_u32, 1_000_000_u32)));
    assert_eq!(beyond, Value::Null);
}

fn outcomes(answer: &Value) -> Value {
    let trials = answer["trials"].as_array();
    let trials = trials.into_iter().flatten();
    let trials = trials.map(|trial| json!([trial["reads"], trial["agrees"]]));
    json!([answer["verdicts"], trials.collect::<Vec<_>>()])
}
