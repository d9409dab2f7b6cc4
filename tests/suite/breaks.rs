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

/// Rebuild the module with `book/breaks/rebuild` where this fails.
#[test]
fn the_module_in_the_page_gives_the_answers_of_the_crate() {
    let mut page = Page::open(include_bytes!("../../book/theme/breaks.wasm"));
    let all = claims();
    let ids: Vec<_> = all.iter().map(|c| Value::from(c.id)).collect();
    let rows = read(page.call("claims", ()));
    assert!(rows.as_array().unwrap().iter().map(|row| &row[0]).eq(&ids));

    // A formula with an integral behind it, a threshold, a misprint.
    for id in ["eq-9", "eq-15", "eq-75"] {
        let number = all.iter().position(|c| c.id == id).unwrap();
        let said_of = read(page.call("ways", number as u32));
        let ways = breaks(id);
        assert_eq!(said_of, to_value(&ways).unwrap(), "{id}");
        for (i, way) in [(0, &ways[0]), (ways.len() - 1, &ways[ways.len() - 1])] {
            let found = read(page.call("broken", (number as u32, i as u32)));
            let expected = to_value(said(id, way)).unwrap();
            assert_eq!(outcomes(&found), outcomes(&expected), "{id} {}", way.wrong);
        }
    }
    let beyond = read(page.call("broken", (0_u32, 1_000_000_u32)));
    assert_eq!(beyond, Value::Null);
}

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
