//! All that is tried besides the claims and the pages in a browser: one program, so that what it needs is built and linked once.

mod attractors;
mod breaks;
mod by_hand;
mod calculators;
mod careless;
mod certified;
mod claims_list;
mod command;
mod digits;
mod domains;
mod drive;
mod explored;
mod explorers;
mod json;
mod judge;
mod motions;
mod one_build;
mod package;
mod pages;
mod prose;
mod readme;
mod rows;
mod same;
mod structure;
mod theorems;
mod trust;
mod units;
mod values;

use slipbook::claims::PAPER;
use slipbook::edition::EDITION;
use slipbook::ledger::Ledger;
use std::ops::Deref;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::LazyLock;
use wasmi::{Engine, Instance, Linker, Module, Store, WasmParams};

struct Made<T>(LazyLock<Result<T, String>>);

impl<T> Deref for Made<T> {
    type Target = T;

    fn deref(&self) -> &T {
        self.0.as_ref().unwrap_or_else(|why| panic!("{why}"))
    }
}

static LEDGER: Made<Ledger> = Made(LazyLock::new(|| {
    EDITION.check().map_err(|faults| faults.to_string())?;
    Ok(Ledger::try_all(&PAPER, |_| {}))
}));

static BOOK: Made<PathBuf> = Made(LazyLock::new(|| {
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join("book");
    let job = slipbook(&["--quiet", "--out", out.to_str().expect("a name")]);
    check_success(&job).map(|()| out)
}));

fn check_success(output: &Output) -> Result<(), String> {
    let said = [&output.stdout, &output.stderr].map(|said| String::from_utf8_lossy(said));
    match output.status.code() {
        Some(0) => Ok(()),
        Some(1) => Err(format!(
            "{}\nA verdict is not the recorded one: `cargo test --test claims` says why. Accept what is right, and then run this.",
            said.concat()
        )),
        code => Err(format!("{}\n(it ended with {code:?})", said.concat())),
    }
}

fn slipbook(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_slipbook"));
    let there = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data");
    let command = command.args(arguments).current_dir(there);
    command.output().expect("it runs")
}

fn snapshots(folder: &str) -> insta::Settings {
    let all = Path::new(env!("CARGO_MANIFEST_DIR")).join("snapshots");
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(all.join(folder));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings
}

/// One with a comma stands between quotation marks.
fn cells(line: &str) -> Vec<String> {
    let mut quoted = false;
    let ends = |c| {
        quoted ^= c == '"';
        c == ',' && !quoted
    };
    let cells = line.split(ends);
    cells.map(|cell| cell.replace('"', "")).collect()
}

struct Page {
    store: Store<()>,
    instance: Instance,
}

impl Page {
    fn open(module: &[u8]) -> Self {
        let engine = Engine::default();
        let module = Module::new(&engine, module).unwrap();
        let mut store = Store::new(&engine, ());
        let linker = Linker::new(&engine);
        let instance = linker.instantiate_and_start(&mut store, &module).unwrap();
        Page { store, instance }
    }

    /// Asked in words.
    fn tell(&mut self, question: &str) -> &[u8] {
        let function = self.instance.get_typed_func(&self.store, "room").unwrap();
        let at: u32 = function
            .call(&mut self.store, question.len() as u32)
            .unwrap();
        let memory = self.instance.get_memory(&self.store, "memory").unwrap();
        memory
            .write(&mut self.store, at as usize, question.as_bytes())
            .unwrap();
        self.call("tell", ())
    }

    fn call(&mut self, name: &str, given: impl WasmParams) -> &[u8] {
        let function = self.instance.get_typed_func(&self.store, name).unwrap();
        let at: u32 = function.call(&mut self.store, given).unwrap();
        let memory = self.instance.get_memory(&self.store, "memory").unwrap();
        &memory.data(&self.store)[at as usize..]
    }
}
