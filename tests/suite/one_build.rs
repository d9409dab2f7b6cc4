//! README's two commands are one build: what `cargo run` compiles, `cargo test` uses and does not compile again.

use serde_json::Value;
use std::collections::BTreeSet;
use std::process::Command;

fn units(arguments: &[&str]) -> BTreeSet<String> {
    let mut cargo = Command::new(env!("CARGO"));
    cargo
        .args(arguments)
        .args(["-Zunstable-options", "--unit-graph"]);
    // The graph is for nightly compilers only; nothing is compiled here.
    cargo.env("RUSTC_BOOTSTRAP", "1");
    let said = cargo
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .expect("cargo runs");
    let told = String::from_utf8_lossy(&said.stderr);
    let mut graph: Value =
        serde_json::from_slice(&said.stdout).unwrap_or_else(|e| panic!("{e}: {told}"));
    let units = graph["units"].as_array_mut().expect("units").iter_mut();
    units
        .map(|unit| {
            // One profile has two names.
            unit["profile"]["name"].take();
            let unit = &*unit;
            let [package, target, mode, features, profile] =
                ["pkg_id", "target", "mode", "features", "profile"].map(|key| &unit[key]);
            let name = package
                .as_str()
                .map_or("", |id| id.rsplit('/').next().unwrap_or(id));
            format!(
                "{name} {} {mode}, features {features}, {profile}",
                target["name"]
            )
        })
        .collect()
}

#[test]
fn the_second_command_uses_what_the_first_has_built() {
    let (run, test) = (
        units(&["build", "--bin", "slipbook"]),
        units(&["test", "--no-run"]),
    );
    assert!(run.iter().any(|unit| unit.starts_with("trialbook")) && run.len() < test.len());
    let again: Vec<_> = run.difference(&test).collect();
    assert!(
        again.is_empty(),
        "`cargo test` builds these once more, with other features or settings than `cargo run`; a feature that only a \
         dev-dependency asks for has to be asked for in trialbook/Cargo.toml, too: {again:#?}"
    );
}
