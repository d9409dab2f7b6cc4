//! The README's table of verdicts is the ledger's.

use crate::LEDGER;
use slipbook::book::files_below;
use slipbook::claims::PAPER;
use slipbook::ledger::{Standing, Verdict};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use trialbook::data::text;

#[test]
fn the_table_of_verdicts_is_the_ledgers() {
    let ledger = &*LEDGER;
    let mut rows: Vec<(&str, BTreeMap<Verdict, usize>)> = Vec::new();
    for entry in &ledger.entries {
        let title = entry.topic.title;
        if rows.last().is_none_or(|(last, _)| *last != title) {
            rows.push((title, BTreeMap::new()));
        }
        let counts = &mut rows.last_mut().unwrap().1;
        *counts.entry(entry.judgement.verdict).or_default() += 1;
    }
    rows.push(("**all**", ledger.counts()));
    let cells = |cells: Vec<String>| format!("| {} |\n", cells.join(" | "));
    let words = Verdict::ALL.iter().map(|v| v.words().to_owned());
    let mut table = cells([String::from("topic")].into_iter().chain(words).collect());
    table += &cells(vec!["---".into(); Verdict::ALL.len() + 1]);
    for (title, counts) in rows {
        let count = |v: &Verdict| counts.get(v).map_or(String::new(), usize::to_string);
        let numbers = Verdict::ALL.iter().map(count);
        table += &cells([title.to_owned()].into_iter().chain(numbers).collect());
    }
    let readme = Path::new(env!("CARGO_MANIFEST_DIR")).join("README.md");
    let text = fs::read_to_string(&readme).unwrap();
    let known = Standing::ALL.map(|of| format!("{} {}", ledger.known(of), of.word()));
    table += &format!(
        "\nHow that is known, of the claim or of what is right in its place: {}.\n",
        known.join(", ")
    );
    let (begin, end) = ("<!-- verdicts -->\n", "<!-- /verdicts -->\n");
    let (before, rest) = text.split_once(begin).expect("a table of verdicts");
    let (old, after) = rest.split_once(end).expect("the end of the table");
    if old != table {
        fs::write(&readme, [before, begin, &table, end, after].concat()).unwrap();
        panic!("README.md had another table of verdicts; look at the new one");
    }
}

#[test]
fn the_picture_is_fig_1() {
    let figures = slipbook::figures::all().unwrap();
    let portrait = figures.iter().find(|figure| figure.id == "fig-1").unwrap();
    let picture = portrait.svg.clone().into_bytes();
    let settings = crate::snapshots("constant");
    settings.bind(|| insta::assert_binary_snapshot!("portrait.svg", picture));
}

#[test]
fn the_descriptions_of_the_crate_agree() {
    let meta: serde_json::Value =
        serde_json::from_str(include_str!("../../codemeta.json")).unwrap();
    assert_eq!(meta["version"], env!("CARGO_PKG_VERSION"));
    assert_eq!(meta["description"], env!("CARGO_PKG_DESCRIPTION"));
    let rust = format!("Rust {}", env!("CARGO_PKG_RUST_VERSION"));
    assert_eq!(meta["runtimePlatform"], rust);
    let licenses = meta["license"].as_array().unwrap().iter();
    let names = licenses.map(|url| url.as_str().unwrap().rsplit('/').next().unwrap());
    assert_eq!(
        names.collect::<Vec<_>>().join(" OR "),
        env!("CARGO_PKG_LICENSE")
    );
    let cargo = include_str!("../../Cargo.toml");
    for keyword in meta["keywords"].as_array().unwrap() {
        assert!(cargo.contains(&keyword.to_string()), "{keyword}");
    }
    let cited = include_str!("../../CITATION.cff");
    let paper = &meta["referencePublication"];
    assert!(cited.contains(&format!("version: {}", env!("CARGO_PKG_VERSION"))));
    assert!(cited.contains(paper["name"].as_str().unwrap()));
    let authors = paper["author"].as_array().unwrap().iter();
    let families = authors.map(|author| author["familyName"].as_str().unwrap());
    let (_, of_paper) = cited.split_once("references:").unwrap();
    let names = of_paper.split("- family-names: ").skip(1).map(|name| {
        let (family, rest) = name.split_once("given-names: ").unwrap();
        let given = rest.split_whitespace().next().unwrap();
        (family.trim(), given)
    });
    let all: Vec<_> = names.collect();
    assert!(all.iter().map(|(family, _)| *family).eq(families));
    let all: Vec<_> = all
        .iter()
        .map(|(family, given)| format!("{given} {family}"))
        .collect();
    assert_eq!(all.join(", "), PAPER.authors.replace(" and ", ", "));
    let checked = include_str!("../../codecheck.yml");
    assert!(checked.contains(paper["name"].as_str().unwrap()));
    assert!(checked.contains(paper["url"].as_str().unwrap()));
    assert!(
        text!("README.md")
            .as_str()
            .contains(&format!("Rust {}", env!("CARGO_PKG_RUST_VERSION")))
    );
}

/// By hash, in time, with no more rights than needed.
#[test]
fn workflows_are_pinned_limited_and_have_few_rights() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(".github/workflows");
    let mut files = 0;
    // The packed crate has none.
    for file in fs::read_dir(folder).into_iter().flatten() {
        let path = file.unwrap().path();
        let text = fs::read_to_string(&path).unwrap();
        let name = path.display();
        for line in text
            .lines()
            .filter(|line| line.contains("uses:") && !line.contains("uses: ./"))
        {
            let (_, hash) = line
                .split_once('@')
                .unwrap_or_else(|| panic!("{name}: {line}"));
            let (hash, version) = hash
                .split_once(" # v")
                .unwrap_or_else(|| panic!("{name}: {line}"));
            let hex = |c: char| c.is_ascii_digit() || ('a'..='f').contains(&c);
            assert!(
                hash.len() == 40 && hash.chars().all(hex) && !version.is_empty(),
                "{name}: {line}"
            );
        }
        let (head, jobs) = text.split_once("\njobs:\n").unwrap();
        assert!(
            head.contains("\npermissions:\n  contents: read\n"),
            "{name}"
        );
        let machines = jobs.matches("runs-on:").count();
        assert!(
            machines > 0 && machines == jobs.matches("timeout-minutes:").count(),
            "{name}"
        );
        let checkouts = text.matches("actions/checkout@").count();
        assert_eq!(
            checkouts,
            text.matches("persist-credentials: false").count(),
            "{name}"
        );
        files += 1;
    }
    let packed = !Path::new(env!("CARGO_MANIFEST_DIR")).join(".ci").exists();
    assert!(files > 0 || packed);
}

#[test]
fn the_package_has_all_sources() {
    let list = std::process::Command::new(env!("CARGO"))
        .args(["package", "--list", "--allow-dirty", "--offline"])
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        .output()
        .unwrap();
    assert!(
        list.status.success(),
        "{}",
        String::from_utf8_lossy(&list.stderr)
    );
    let list = String::from_utf8(list.stdout).unwrap();
    let packed: std::collections::BTreeSet<_> =
        list.lines().map(|line| line.replace('\\', "/")).collect();
    let below = |folder: &str| {
        let files = files_below(&Path::new(env!("CARGO_MANIFEST_DIR")).join(folder)).unwrap();
        let named = files.into_keys().map(|name| format!("{folder}/{name}"));
        named.collect::<Vec<_>>()
    };
    let sources = ["src", "claims", "book/src", "snapshots", "examples"];
    let mut missing: Vec<_> = sources.into_iter().flat_map(below).collect();
    missing.retain(|name| !packed.contains(name) && !name.ends_with(".new"));
    assert!(missing.is_empty(), "{missing:#?}");
    for file in [
        "Cargo.lock",
        "README.md",
        "LICENSE-MIT",
        "LICENSE-APACHE",
        "codemeta.json",
        "codecheck.yml",
    ] {
        assert!(packed.contains(file), "{file}");
    }
}
