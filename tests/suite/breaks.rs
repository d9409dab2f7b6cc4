//! "Break it yourself": the module in the page gives the crate's own answers.

use serde_json::{Value, json, to_value};
use slipbook::breaks::{Break, answer, breaks, claims};
use wasmi::{Engine, Linker, Memory, Module, Store, TypedFunc};

/// The module as the page runs it.
struct Page {
    store: Store<()>,
    memory: Memory,
    claims: TypedFunc<(), u32>,
    ways: TypedFunc<u32, u32>,
    broken: TypedFunc<(u32, u32), u32>,
}

impl Page {
    fn open() -> Self {
        let engine = Engine::default();
        let module = Module::new(&engine, include_bytes!("../../book/theme/breaks.wasm")).unwrap();
        let mut store = Store::new(&engine, ());
        let linker = Linker::new(&engine);
        let instance = linker.instantiate_and_start(&mut store, &module).unwrap();
        Page {
            memory: instance.get_memory(&store, "memory").unwrap(),
            claims: instance.get_typed_func(&store, "claims").unwrap(),
            ways: instance.get_typed_func(&store, "ways").unwrap(),
            broken: instance.get_typed_func(&store, "broken").unwrap(),
            store,
        }
    }

    fn read(&self, at: u32) -> Value {
        let bytes = &self.memory.data(&self.store)[at as usize..];
        let (length, json) = bytes.split_at(4);
        let length = u32::from_le_bytes(length.try_into().unwrap());
        serde_json::from_slice(&json[..length as usize]).unwrap()
    }
}

/// Rebuild the module with `book/breaks/rebuild` where this fails.
#[test]
fn the_module_in_the_page_gives_the_answers_of_the_crate() {
    let mut page = Page::open();
    let at = page.claims.call(&mut page.store, ()).unwrap();
    let all = claims();
    let ids: Vec<_> = all.iter().map(|c| Value::from(c.id)).collect();
    let rows = page.read(at);
    assert!(rows.as_array().unwrap().iter().map(|row| &row[0]).eq(&ids));

    // A formula with an integral behind it, a threshold, a misprint.
    for id in ["eq-9", "eq-15", "eq-75"] {
        let number = all.iter().position(|c| c.id == id).unwrap();
        let at = page.ways.call(&mut page.store, number as u32).unwrap();
        let ways = breaks(id);
        assert_eq!(page.read(at), to_value(&ways).unwrap(), "{id}");
        for (i, way) in [(0, &ways[0]), (ways.len() - 1, &ways[ways.len() - 1])] {
            let given = (number as u32, i as u32);
            let at = page.broken.call(&mut page.store, given).unwrap();
            let found = page.read(at);
            let expected = to_value(said(id, way)).unwrap();
            assert_eq!(outcomes(&found), outcomes(&expected), "{id} {}", way.wrong);
        }
    }
    let beyond = page.broken.call(&mut page.store, (0, 1_000_000)).unwrap();
    assert_eq!(page.read(beyond), Value::Null);
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
