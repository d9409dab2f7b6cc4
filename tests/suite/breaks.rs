//! "Break it yourself": the module in the page gives the crate's own answers.

use crate::Page;
use serde_json::{Value, json, to_value};
use slipbook::breaks::{Break, answer, breaks, claims};

/// The JSON behind its length.
fn read(bytes: &[u8]) -> Value {
    let (length, json) = bytes.split_at(4);
    let length = u32::from_le_bytes(length.try_into().unwrap());
    serde_json::from_slice(&json[..length as usize]).unwrap()
}

/// The ids and all ways to break every formula: a module that was made of another formula is told by the claim. What the trials say
/// takes long in it: of the first and the last way to break a formula with an integral behind it, a threshold and a misprint.
#[test]
fn the_module_in_the_page_gives_the_answers_of_the_crate() {
    let mut page = Page::open(include_bytes!("../../book/theme/breaks.wasm"));
    let all = claims();
    let rows = read(page.call("claims", ()));
    let rows: Vec<_> = rows.as_array().unwrap().iter().map(|row| &row[0]).collect();
    let ids: Vec<_> = all.iter().map(|claim| claim.id).collect();
    let mut old: Vec<_> = ids
        .iter()
        .filter(|id| rows.iter().all(|row| row != *id))
        .collect();
    for (number, id) in rows.iter().enumerate() {
        let Some(id) = ids.iter().find(|known| id == known) else {
            panic!("{id} is in the module and no claim any more: {REBUILD}");
        };
        let (said_of, ways) = (read(page.call("ways", number as u32)), breaks(id));
        let mut same = said_of == to_value(&ways).unwrap();
        let both = [(0, &ways[0]), (ways.len() - 1, &ways[ways.len() - 1])];
        let tried = ["eq-9", "eq-15", "eq-75"].contains(id);
        for (i, way) in both.into_iter().filter(|_| tried) {
            let found = same.then(|| read(page.call("broken", (number as u32, i as u32))));
            let expected = to_value(said(id, way)).unwrap();
            same = found.is_some_and(|found| outcomes(&found) == outcomes(&expected));
        }
        old.extend((!same).then_some(id));
    }
    assert!(
        old.is_empty(),
        "the module is older than {old:?}: {REBUILD}"
    );
    let beyond = read(page.call("broken", (0_u32, 1_000_000_u32)));
    assert_eq!(beyond, Value::Null);
}

/// What to do then.
const REBUILD: &str = "run `book/breaks/rebuild`, which adds the target wasm32-unknown-unknown to the toolchain, and commit book/theme/breaks.wasm";

fn said(id: &str, way: &Break) -> slipbook::breaks::Answer {
    let all = claims();
    let claim = all.iter().find(|c| c.id == id).unwrap();
    answer(claim, way.seed)
}

/// The verdicts, and of each trial whether it reads the formula and agrees: no words, and not the last digits of what is measured.
fn outcomes(answer: &Value) -> Value {
    let trials = answer["trials"].as_array().unwrap();
    let trials = trials
        .iter()
        .map(|trial| json!([trial["reads"], trial["agrees"]]));
    json!([answer["verdicts"], trials.collect::<Vec<_>>()])
}
