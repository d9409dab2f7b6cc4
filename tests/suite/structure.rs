//! The modules of the two crates and who may know whom, read off the sources themselves.

use slipbook::book::files_below;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// It knows no paper. A formula is a tree too, so that what is seeded in it knows trees.
const ENGINE: &str = "
    data:
    scalar:
    stop:
    seeded: exact scalar
    evidence:
    notation:
    numerics: scalar
    exact: notation scalar seeded
    certified: numerics scalar
    trials: data scalar evidence numerics exact certified seeded notation theorems
    theorems: data exact seeded trials
    ledger: data evidence trials seeded notation stop
    plotting: data notation
    publishing: data trials plotting seeded
    prelude: data trials publishing evidence exact plotting ledger numerics scalar seeded
    book: data evidence exact trials ledger plotting publishing notation theorems
    cli: data trials evidence ledger plotting notation numerics book publishing theorems stop
";

/// What knows this paper.
const OF_THE_PAPER: &str = "
    symbols: seeded
    paper: scalar seeded symbols
    corrections: scalar seeded symbols
    solve: corrections motion numerics paper scalar
    scene: motion solve
    exam: motion numerics
    claims: data trials validated scalar evidence numerics motion paper corrections exact certified seeded symbols theorems
    figures: data claims exam motion notation plotting solve trials
    breaks: claims corrections evidence ledger notation paper scalar seeded trials
    commands: numerics exam figures cli motion plotting publishing scene solve stop book
    edition: data evidence breaks claims corrections exam ledger figures motion notation numerics paper scene seeded solve symbols book commands plotting publishing trials
";

/// The row `motion` is all modules of its crate that have none of their own.
const OF_MOTION: &str = "
    motion: numerics scalar
    numerics: scalar
    explorers: motion numerics
    validated: certified numerics scalar
    exam: certified numerics validated
";

const CRATES: [(&str, &str); 3] = [
    ("trialbook/src", ENGINE),
    ("motion/src", OF_MOTION),
    ("src", OF_THE_PAPER),
];

fn rows(table: &'static str) -> impl Iterator<Item = (&'static str, &'static str)> {
    table.lines().filter_map(|row| row.trim().split_once(':'))
}

#[test]
fn every_module_names_only_those_that_it_may() {
    let mut modules = BTreeSet::new();
    let mut offences = Vec::new();
    for (sources, table) in CRATES {
        // Other crates have preludes too.
        modules.extend(rows(table).map(|(module, _)| module));
        modules.remove("prelude");
        for (module, may) in rows(table) {
            for file in sources_of(sources, module, table) {
                let code = fs::read_to_string(&file).unwrap();
                for named in modules_named(&code, &modules) {
                    if named != module && !may.split(' ').any(|may| may == named) {
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
        let listed: BTreeSet<_> = rows(table).map(|(module, _)| module.to_owned()).collect();
        let there: BTreeSet<_> = fs::read_dir(root().join(sources))
            .unwrap()
            .map(|entry| entry.unwrap().path())
            .map(|path| path.file_stem().unwrap().to_str().unwrap().to_owned())
            .filter(|stem| stem != "lib" && stem != "main")
            .collect();
        if table == OF_MOTION {
            assert!(listed.difference(&there).eq(["motion"]), "{sources}");
            continue;
        }
        assert_eq!(listed, there, "{sources}");
    }
}

#[test]
fn an_import_of_the_other_side_is_seen() {
    let modules = BTreeSet::from(["paper", "claims"]);
    for code in [
        "use crate::paper::constant;",
        "pub use crate::{numerics, paper};",
        "use crate::{\n    numerics::{ode, roots},\n    paper,\n};",
        "fn f() { super::super::paper::constant::eq11_speed(); }",
        "use crate as this; fn f() { this::paper::x(); }",
        "use crate::r#paper;",
        "include!(\"../paper/constant.rs\");",
        "#[path = \"../paper.rs\"] mod c;",
    ] {
        assert!(modules_named(code, &modules).contains("paper"), "{code}");
    }
    for code in [
        "// crate::paper",
        "/// see [`crate::paper`]\nfn f() {}",
        "let x = \"the paper says\";",
        "let wallpaper = wallpaper::new();",
        "let x = \"because of the paper\";",
    ] {
        assert!(modules_named(code, &modules).is_empty(), "{code}");
    }
}

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

/// `module.rs` and all below `module/`; of the motions what is in no other row.
fn sources_of(sources: &str, module: &str, table: &'static str) -> Vec<PathBuf> {
    let top = root().join(sources);
    let of = |path: &Path| -> Option<String> {
        let first = path.strip_prefix(&top).ok()?.components().next()?;
        let stem = Path::new(first.as_os_str())
            .file_stem()?
            .to_str()?
            .to_owned();
        let is_listed = rows(table).any(|(row, _)| row == stem);
        Some(match is_listed || table != OF_MOTION || stem == "lib" {
            true => stem,
            false => "motion".to_owned(),
        })
    };
    let mut found: Vec<_> = files_below(&top).unwrap().into_values().collect();
    found.retain(|path| {
        path.extension().is_some_and(|e| e == "rs") && of(path).is_some_and(|of| of == module)
    });
    assert!(!found.is_empty(), "the module {module} has no sources");
    found
}

fn body(function: &str) -> &str {
    let mut depth = 0;
    let end = function.char_indices().find(|(_, c)| {
        depth += i32::from(*c == '{') - i32::from(*c == '}');
        *c == '}' && depth == 0
    });
    end.map_or(function, |(end, _)| &function[..end])
}

fn lines(code: &str) -> impl Iterator<Item = &str> {
    code.lines()
        .map(|line| line.split("//").next().unwrap_or_default())
}

fn words(code: &str) -> impl Iterator<Item = &str> {
    code.split(|c: char| !(c.is_alphanumeric() || c == '_'))
}

/// Beside `::`, in a `use` declaration, or by a file.
fn modules_named<'m>(code: &str, modules: &BTreeSet<&'m str>) -> BTreeSet<&'m str> {
    let (mut named, mut declares) = (BTreeSet::new(), false);
    for line in lines(code) {
        declares |= line.split_whitespace().take(2).any(|word| word == "use");
        let whole = declares || ["include!(", "#[path"].iter().any(|by| line.contains(by));
        let pieces = line.split(|c: char| !(c.is_alphanumeric() || "_:".contains(c)));
        let pieces = pieces.filter(|piece| whole || piece.contains("::"));
        named.extend(pieces.flat_map(words).filter_map(|word| modules.get(word)));
        declares &= !line.contains(';');
    }
    named
}

/// A function of [`Scalar`](trialbook::scalar::Scalar) can ask how large a number is by `nearest` alone. Without that it is one
/// analytic expression, and cannot be right at the points of its trials and wrong between them. What distinguishes cases is named
/// here.
#[test]
fn no_formula_is_another_one_elsewhere() {
    // A number that can be compared, and what follows from it.
    const BRANCHES: [&str; 6] = ["f64", "nearest", "if", "match", "while", "for"];
    let mut found = BTreeSet::new();
    for module in ["paper", "corrections"] {
        for file in sources_of("src", module, OF_THE_PAPER) {
            let code = fs::read_to_string(&file).unwrap();
            let code = code.split("#[cfg(test)]\nmod").next().unwrap();
            let code = lines(code).collect::<Vec<_>>().join("\n");
            for function in code.split("fn ").skip(1) {
                let name = function.split(['<', '(']).next().unwrap();
                if words(body(function)).any(|word| BRANCHES.contains(&word)) {
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
