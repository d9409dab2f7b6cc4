//! The modules of the two crates and who may know whom, read off the sources themselves.

use slipbook::book::files_below;
use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;

/// The modules of a crate, each with those that it may name.
type Modules = [(&'static str, &'static [&'static str])];

/// The engine, which knows no paper.
const ENGINE: &Modules = &[
    ("scalar", &[]),
    // A formula is a tree too; the trees' own tests seed mistakes.
    ("seeded", &["exact", "scalar"]),
    ("evidence", &[]),
    ("notation", &[]),
    ("numerics", &["scalar"]),
    ("witness", &[]),
    ("exact", &["notation", "scalar", "seeded", "witness"]),
    ("certified", &["exact", "numerics", "scalar", "witness"]),
    (
        "trials",
        &[
            "scalar",
            "evidence",
            "numerics",
            "exact",
            "certified",
            "seeded",
            "witness",
            "notation",
        ],
    ),
    ("ledger", &["evidence", "trials", "seeded", "notation"]),
    ("plotting", &[]),
    ("publishing", &["trials", "plotting", "seeded"]),
    (
        "prelude",
        &[
            "trials",
            "publishing",
            "evidence",
            "exact",
            "plotting",
            "ledger",
            "numerics",
            "scalar",
            "seeded",
        ],
    ),
    (
        "book",
        &[
            "evidence",
            "trials",
            "ledger",
            "plotting",
            "publishing",
            "notation",
        ],
    ),
    (
        "cli",
        &[
            "trials",
            "evidence",
            "ledger",
            "plotting",
            "notation",
            "numerics",
            "book",
            "publishing",
            "witness",
        ],
    ),
];

/// What knows this paper.
const OF_THE_PAPER: &Modules = &[
    ("motion", &["numerics", "scalar"]),
    ("explorers", &["motion"]),
    ("symbols", &["seeded"]),
    ("paper", &["scalar", "seeded", "symbols"]),
    ("corrections", &["scalar", "seeded", "symbols"]),
    (
        "solve",
        &["corrections", "motion", "numerics", "paper", "scalar"],
    ),
    (
        "validated",
        &["certified", "exact", "numerics", "scalar", "witness"],
    ),
    ("exam", &["certified", "motion", "numerics", "validated"]),
    (
        "claims",
        &[
            "trials",
            "validated",
            "scalar",
            "evidence",
            "numerics",
            "motion",
            "paper",
            "corrections",
            "exact",
            "certified",
            "seeded",
            "symbols",
            "witness",
        ],
    ),
    (
        "figures",
        &["claims", "exam", "motion", "plotting", "solve", "trials"],
    ),
    (
        "breaks",
        &[
            "claims",
            "corrections",
            "evidence",
            "ledger",
            "notation",
            "paper",
            "scalar",
            "seeded",
            "trials",
        ],
    ),
    (
        "commands",
        &[
            "numerics",
            "exam",
            "figures",
            "cli",
            "plotting",
            "publishing",
            "solve",
        ],
    ),
    (
        "edition",
        &[
            "evidence",
            "breaks",
            "claims",
            "exam",
            "ledger",
            "figures",
            "notation",
            "symbols",
            "book",
            "commands",
            "plotting",
            "publishing",
            "trials",
        ],
    ),
];

/// The crates, by their sources.
const CRATES: [(&str, &Modules); 2] = [("trialbook/src", ENGINE), ("src", OF_THE_PAPER)];

#[test]
fn every_module_names_only_those_that_it_may() {
    let names = |table: &Modules| -> BTreeSet<&'static str> {
        // Other crates have preludes too; this one holds nothing of its own.
        let modules = table.iter().map(|(module, _)| *module);
        modules.filter(|module| *module != "prelude").collect()
    };
    let mut modules = BTreeSet::new();
    let mut offences = Vec::new();
    for (sources, table) in CRATES {
        // What the engine does not have, it cannot name: it is a crate below the other.
        modules.extend(names(table));
        for (module, may) in table {
            for file in sources_of(sources, module) {
                let code = fs::read_to_string(&file).unwrap();
                for named in modules_named(&code, &modules) {
                    if named != *module && !may.contains(&named.as_str()) {
                        offences.push(format!("{} names {named}", file.display()));
                    }
                }
            }
        }
    }
    assert!(offences.is_empty(), "{offences:#?}");
}

#[test]
fn every_module_is_in_the_table() {
    for (sources, table) in CRATES {
        let listed: BTreeSet<String> = table
            .iter()
            .map(|(module, _)| (*module).to_owned())
            .collect();
        let there: BTreeSet<String> = fs::read_dir(root().join(sources))
            .unwrap()
            .map(|entry| entry.unwrap().path())
            .map(|path| path.file_stem().unwrap().to_str().unwrap().to_owned())
            .filter(|stem| stem != "lib" && stem != "main")
            .collect();
        assert_eq!(listed, there, "{sources}");
    }
}

#[test]
fn an_import_of_the_other_side_is_seen_in_every_disguise() {
    let modules = BTreeSet::from(["paper", "claims"]);
    for code in [
        "use crate::paper::constant;",
        "use crate::{numerics, paper};",
        "use crate::{\n    numerics::{ode, roots},\n    paper::constant as c,\n};",
        "fn f() { super::super::paper::constant::eq11_speed(); }",
        "use crate as this; fn f() { this :: paper::x(); }",
        "/* // */ use crate::paper; // harmless",
        "const Q: char = '\"'; use crate::paper;",
        "let x = \"http://\"; use crate::paper;",
        "fn f<'a>() { crate::paper::x('a', \"\\\"\"); }",
        "let b = r\"\\\"; use crate::paper;",
        "use crate::r#paper;",
        "include!(\"../paper/constant.rs\");",
        "#[path = \"../paper/constant.rs\"] mod c;",
    ] {
        assert!(modules_named(code, &modules).contains("paper"), "{code}");
    }
    for code in [
        "// crate::paper",
        "/// see [`crate::paper`]\nfn f() {}",
        "let x = \"the paper says\";",
        "/* a /* crate::paper */ b */",
        "/*/ crate::paper */",
        "let wallpaper = 1;",
        "let x = \"because of the paper\";",
        "let x = r#\"use \"paper\" or crate::paper\"#;",
    ] {
        assert!(modules_named(code, &modules).is_empty(), "{code}");
    }
}

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

/// The source files of a module: `module.rs`, and all below `module/`.
fn sources_of(sources: &str, module: &str) -> Vec<PathBuf> {
    let folder = root().join(sources);
    let (file, folder) = (folder.join(format!("{module}.rs")), folder.join(module));
    let mut sources = Vec::new();
    if file.exists() {
        sources.push(file);
    }
    if folder.exists() {
        let files = files_below(&folder).unwrap().into_values();
        sources.extend(files.filter(|path| path.extension().is_some_and(|e| e == "rs")));
    }
    assert!(!sources.is_empty(), "the module {module} has no sources");
    sources
}

/// What stands between the first braces.
fn body(function: &str) -> &str {
    let mut depth = 0;
    let end = function.char_indices().find(|(_, c)| {
        depth += i32::from(*c == '{') - i32::from(*c == '}');
        *c == '}' && depth == 0
    });
    end.map_or(function, |(end, _)| &function[..end])
}

/// The modules whose names stand in the code as whole words in a path, or inside a file name.
fn modules_named(code: &str, modules: &BTreeSet<&str>) -> BTreeSet<String> {
    let code = code_alone(code);
    let mut named = BTreeSet::new();
    for word in code.split(|c: char| !(c.is_alphanumeric() || c == '_')) {
        let in_file_name =
            || code.contains(&format!("/{word}/")) || code.contains(&format!("/{word}.rs"));
        if modules.contains(word) && (in_path(&code, word) || in_file_name()) {
            named.insert(word.to_owned());
        }
    }
    named
}

/// True if `word` stands beside `::`, or in a `use` declaration's braces.
fn in_path(code: &str, word: &str) -> bool {
    let flat: String = code.split_whitespace().collect::<Vec<_>>().join(" ");
    let flat = flat
        .replace(" :: ", "::")
        .replace(" ::", "::")
        .replace(":: ", "::");
    let flat = flat.replace("r#", "");
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    let by_colons = flat.match_indices(word).any(|(at, _)| {
        let (before, after) = (&flat[..at], &flat[at + word.len()..]);
        let whole = !before.ends_with(is_word) && !after.starts_with(is_word);
        whole && (before.ends_with("::") || after.starts_with("::"))
    });
    let uses = flat
        .split(';')
        .filter_map(|s| Some(format!(" {s}").split_once(" use ")?.1.to_owned()));
    let by_use = uses
        .into_iter()
        .any(|declared| declared.split(|c: char| !is_word(c)).any(|w| w == word));
    by_colons || by_use
}

/// The code without its comments, nested ones included, and without its strings, but for names of files of Rust.
fn code_alone(code: &str) -> String {
    let mut out = String::new();
    let mut rest = code;
    while let Some(c) = rest.chars().next() {
        let hashes = out.len() - out.trim_end_matches('#').len();
        let raw = out[..out.len() - hashes].ends_with('r');
        let length = match c {
            '/' if rest.starts_with("//") => rest.find('\n').unwrap_or(rest.len()),
            '/' if rest.starts_with("/*") => comment(rest),
            '\'' if rest.starts_with("'\"'") || rest.starts_with("'\\\"'") => {
                1 + rest[1..].find("\"'").unwrap() + 2
            }
            '"' => {
                let close = format!("\"{}", &"#".repeat(if raw { hashes } else { 0 }));
                let length = string(rest, raw, &close);
                let text = &rest[..length];
                out.push_str(if text.ends_with(".rs\"") {
                    text
                } else {
                    "\"\""
                });
                length
            }
            _ => {
                out.push(c);
                c.len_utf8()
            }
        };
        rest = &rest[length..];
    }
    out
}

/// The length of the comment that the code begins with, those inside it included.
fn comment(code: &str) -> usize {
    let mut end = 2;
    while let Some(at) = code[end..].find(['/', '*']) {
        end += at;
        match code.as_bytes().get(end..end + 2) {
            Some(b"/*") => end += comment(&code[end..]),
            Some(b"*/") => return end + 2,
            _ => end += 1,
        }
    }
    code.len()
}

/// The length of the string that the code begins with.
fn string(code: &str, raw: bool, close: &str) -> usize {
    let mut end = 1;
    while !code[end..].starts_with(close) {
        end += usize::from(!raw && code[end..].starts_with('\\'));
        end += code[end..]
            .chars()
            .next()
            .expect("a string that ends")
            .len_utf8();
    }
    end + close.len()
}

/// A function of [`Scalar`](trialbook::scalar::Scalar) has no way to ask how large a number is but `nearest`. Without that it is one
/// analytic expression, and cannot be right at the points of its trials and wrong between them or beyond. What does distinguish
/// cases is no such expression, and is named here; its cases are all tried.
#[test]
fn no_formula_is_another_one_elsewhere() {
    // A number that can be compared, and what follows from it.
    const BRANCHES: [&str; 6] = ["f64", "nearest", "if", "match", "while", "for"];
    let mut found = BTreeSet::new();
    for module in ["paper", "corrections"] {
        for file in sources_of("src", module) {
            let code = code_alone(&fs::read_to_string(&file).unwrap());
            let code = code.split("#[cfg(test)]\nmod").next().unwrap();
            for function in code.split("fn ").skip(1) {
                let name = function.split(['<', '(']).next().unwrap();
                let mut words = body(function).split(|c: char| !(c.is_alphanumeric() || c == '_'));
                if words.any(|word| BRANCHES.contains(&word)) {
                    found.insert(format!("{module}::{name}"));
                }
            }
        }
    }
    let cases = [
        "corrections::region",
        "corrections::small_friction_case",
        "paper::eq42_h",
        "paper::eq44_case",
        "paper::region",
        "paper::signs",
    ];
    assert!(found.iter().eq(&cases), "{found:#?}");
}

/// A run that fails makes its trial fail. So nothing takes failures out of sight in the trials, but for `where_defined`: where there may be no
/// value.
#[test]
fn no_trial_leaves_out_what_could_not_be_followed() {
    let mut found = Vec::new();
    for file in sources_of("src", "claims") {
        let path = file.strip_prefix(root()).unwrap();
        let path = path.display().to_string().replace('\\', "/");
        if path.contains("/tests") {
            continue;
        }
        let code = code_alone(&fs::read_to_string(&file).unwrap());
        let code = code.split("#[cfg(test)]\nmod").next().unwrap();
        for hides in [
            "is_ok",
            "is_err",
            "Result::ok",
            ".ok()",
            ".flatten()",
            "if let Ok",
            "Ok(_)",
        ] {
            if code.contains(hides) {
                found.push(format!("{path}: {hides}"));
            }
        }
    }
    assert!(found.is_empty(), "{found:#?}");
}
