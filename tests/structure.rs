//! The rooms of the house and who may know whom, read off the sources themselves.

use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;

/// The rooms of a crate, each with the rooms that it may name.
type Rooms = [(&'static str, &'static [&'static str])];

/// The engine, which knows no paper.
const ENGINE: &Rooms = &[
    ("scalar", &[]),
    ("seeded", &["scalar"]),
    ("evidence", &[]),
    ("numerics", &["scalar"]),
    ("witness", &[]),
    ("exact", &["scalar", "seeded", "witness"]),
    ("certified", &["exact", "numerics", "scalar", "witness"]),
    (
        "claims",
        &[
            "scalar",
            "evidence",
            "numerics",
            "exact",
            "certified",
            "seeded",
            "witness",
        ],
    ),
    ("ledger", &["evidence", "claims", "seeded"]),
    ("figures", &[]),
    ("edition", &["claims", "figures", "seeded"]),
    (
        "prelude",
        &[
            "claims", "edition", "evidence", "exact", "figures", "ledger", "numerics", "scalar",
            "seeded",
        ],
    ),
    (
        "book",
        &["evidence", "claims", "ledger", "figures", "edition"],
    ),
    (
        "cli",
        &[
            "claims", "evidence", "ledger", "figures", "numerics", "book", "edition", "witness",
        ],
    ),
];

/// What knows this paper. A room of the engine's name holds what belongs to this paper there.
const OF_THE_PAPER: &Rooms = &[
    ("motion", &["numerics", "scalar"]),
    ("explorers", &["motion"]),
    ("symbols", &["seeded"]),
    ("paper", &["scalar", "seeded", "symbols"]),
    ("corrections", &["scalar", "seeded", "symbols"]),
    ("certified", &["exact", "numerics", "scalar", "witness"]),
    ("exam", &["certified", "motion", "numerics"]),
    (
        "claims",
        &[
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
    ("figures", &["claims", "exam", "motion"]),
    (
        "breaks",
        &[
            "claims",
            "corrections",
            "evidence",
            "ledger",
            "paper",
            "scalar",
            "seeded",
        ],
    ),
    (
        "commands",
        &["numerics", "claims", "exam", "figures", "cli", "edition"],
    ),
    (
        "edition",
        &[
            "evidence", "claims", "exam", "ledger", "figures", "symbols", "book", "commands",
        ],
    ),
];

/// The crates, by their sources.
const CRATES: [(&str, &Rooms); 2] = [("trialbook/src", ENGINE), ("src", OF_THE_PAPER)];

/// Words that the engine has no use for, wherever they stand.
const WORDS_OF_THE_PAPER: [&str; 8] = [
    "slipbook",
    "slipping",
    "friction",
    "rolling",
    "plane",
    "sphere",
    "turntable",
    "coulomb",
];

#[test]
fn every_room_names_only_the_rooms_above_it() {
    let names = |table: &Rooms| -> BTreeSet<&'static str> {
        // Other crates have preludes too; this one holds nothing of its own.
        let rooms = table.iter().map(|(room, _)| *room);
        rooms.filter(|room| *room != "prelude").collect()
    };
    let mut rooms = BTreeSet::new();
    let mut offences = Vec::new();
    for (sources, table) in CRATES {
        // What the engine does not have, it cannot name: it is a crate below the other.
        rooms.extend(names(table));
        for (room, may) in table {
            for file in sources_of(sources, room) {
                let code = fs::read_to_string(&file).unwrap();
                for named in rooms_named(&code, &rooms) {
                    if named != *room && !may.contains(&named.as_str()) {
                        offences.push(format!("{} names {named}", file.display()));
                    }
                }
            }
        }
    }
    assert!(offences.is_empty(), "{offences:#?}");
}

#[test]
fn every_room_is_in_the_table() {
    for (sources, table) in CRATES {
        let listed: BTreeSet<String> = table.iter().map(|(room, _)| (*room).to_owned()).collect();
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
fn the_engine_has_no_words_of_the_paper() {
    let mut offences = Vec::new();
    let mut files = Vec::new();
    for folder in ["src", "examples", "pages", "theme"] {
        files.extend(files_below(root().join("trialbook").join(folder)));
    }
    for file in files {
        // A font is no text.
        let Ok(text) = fs::read_to_string(&file) else {
            continue;
        };
        let text = text.to_lowercase();
        let words: BTreeSet<_> = text.split(|c: char| !c.is_alphabetic()).collect();
        for word in WORDS_OF_THE_PAPER
            .iter()
            .filter(|word| words.contains(*word))
        {
            offences.push(format!("{}: {word}", file.display()));
        }
    }
    assert!(offences.is_empty(), "{offences:#?}");
}

#[test]
fn an_import_of_the_other_side_is_seen_in_every_disguise() {
    let rooms = BTreeSet::from(["paper", "claims"]);
    for code in [
        "use crate::paper::constant;",
        "use crate::{numerics, paper};",
        "use crate::{\n    numerics::{ode, roots},\n    paper::constant as c,\n};",
        "fn f() { super::super::paper::constant::eq11_speed(); }",
        "use crate as house; fn f() { house :: paper::x(); }",
        "/* // */ use crate::paper; // harmless",
        "const Q: char = '\"'; use crate::paper;",
        "use crate::r#paper;",
        "include!(\"../paper/constant.rs\");",
        "#[path = \"../paper/constant.rs\"] mod c;",
    ] {
        assert!(rooms_named(code, &rooms).contains("paper"), "{code}");
    }
    for code in [
        "// crate::paper",
        "/// see [`crate::paper`]\nfn f() {}",
        "let x = \"the paper says\";",
        "/* a /* crate::paper */ b */",
        "let wallpaper = 1;",
    ] {
        assert!(rooms_named(code, &rooms).is_empty(), "{code}");
    }
}

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

/// The source files of a room: `room.rs`, and all below `room/`.
fn sources_of(sources: &str, room: &str) -> Vec<PathBuf> {
    let folder = root().join(sources);
    let (file, folder) = (folder.join(format!("{room}.rs")), folder.join(room));
    let mut sources = Vec::new();
    if file.exists() {
        sources.push(file);
    }
    if folder.exists() {
        let files = files_below(folder).into_iter();
        sources.extend(files.filter(|path| path.extension().is_some_and(|e| e == "rs")));
    }
    assert!(!sources.is_empty(), "the room {room} has no sources");
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

/// All files in a folder and in those within it.
fn files_below(folder: PathBuf) -> Vec<PathBuf> {
    let mut files = Vec::new();
    let mut open = vec![folder];
    while let Some(folder) = open.pop() {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            match path.is_dir() {
                true => open.push(path),
                false => files.push(path),
            }
        }
    }
    files
}

/// The rooms whose names stand in the code as whole words in a path, or inside a file name.
fn rooms_named(code: &str, rooms: &BTreeSet<&str>) -> BTreeSet<String> {
    let code = without_comments(code);
    let mut named = BTreeSet::new();
    for word in code.split(|c: char| !(c.is_alphanumeric() || c == '_')) {
        let in_file_name =
            || code.contains(&format!("/{word}/")) || code.contains(&format!("/{word}.rs"));
        if rooms.contains(word) && (in_path(&code, word) || in_file_name()) {
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
        .filter_map(|s| s.split_once("use ").map(|(_, rest)| rest));
    let by_use = uses
        .into_iter()
        .any(|declared| declared.split(|c: char| !is_word(c)).any(|w| w == word));
    by_colons || by_use
}

/// The code with its comments, nested ones included, taken out; text in quotes stays.
fn without_comments(code: &str) -> String {
    let mut out = String::new();
    let mut rest = code;
    let mut depth = 0;
    while let Some(c) = rest.chars().next() {
        if depth == 0 && rest.starts_with("//") {
            rest = rest.find('\n').map_or("", |end| &rest[end..]);
        } else if rest.starts_with("/*") {
            depth += 1;
            rest = &rest[2..];
        } else if depth > 0 && rest.starts_with("*/") {
            depth -= 1;
            rest = &rest[2..];
        } else {
            if depth == 0 {
                out.push(c);
            }
            rest = &rest[c.len_utf8()..];
        }
    }
    out
}

/// What trials share counts as a run that they have read, unless it is a setting; so a setting is nothing that moves.
#[test]
fn settings_are_drives_and_the_onset_of_rest() {
    let mut settings = Vec::new();
    for path in files_below(root().join("src/claims")) {
        let code = fs::read_to_string(&path).unwrap();
        let made = code.lines().filter(|line| line.contains("Runs::setting("));
        settings.extend(made.map(|line| line.trim().to_owned()));
    }
    settings.sort();
    settings.dedup();
    let drive = "static DRIVE: Runs<Drive> = Runs::setting(|| Ok(Drive::new(libm::sin, &[])?));";
    let onset = "static ONSET: Runs<f64> = Runs::setting(|| Ok(root(excess_length, 0.2, 0.9)?));";
    assert_eq!(settings, [drive, onset]);
}

/// A function of [`Scalar`](trialbook::scalar::Scalar) has no way to ask how large a number is but `nearest`. Without that it is one
/// analytic expression, and cannot be right at the points of its trials and wrong between them or beyond. What does distinguish
/// cases is no such expression, and is named here; its cases are all tried.
#[test]
fn no_formula_is_another_one_elsewhere() {
    // A number that can be compared, and what follows from it.
    const BRANCHES: [&str; 6] = ["f64", "nearest", "if", "match", "while", "for"];
    let mut found = BTreeSet::new();
    for room in ["paper", "corrections"] {
        for file in sources_of("src", room) {
            let code = without_comments(&fs::read_to_string(&file).unwrap());
            let code = code.split("#[cfg(test)]\nmod").next().unwrap();
            for function in code.split("fn ").skip(1) {
                let name = function.split(['<', '(']).next().unwrap();
                let mut words = body(function).split(|c: char| !(c.is_alphanumeric() || c == '_'));
                if words.any(|word| BRANCHES.contains(&word)) {
                    found.insert(format!("{room}::{name}"));
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

/// A run that fails makes its trial fail. So what takes failures out of sight in the trials is listed: where there may be no value.
#[test]
fn no_trial_leaves_out_what_could_not_be_followed() {
    let mut found = BTreeSet::new();
    for file in sources_of("src", "claims") {
        let path = file.strip_prefix(root().join("src")).unwrap();
        let path = path.display().to_string().replace('\\', "/");
        if path.contains("/solve") || path.contains("/tests") {
            continue;
        }
        let code = without_comments(&fs::read_to_string(&file).unwrap());
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
            let times = code.matches(hides).count();
            if times > 0 {
                found.insert(format!("{path}: {times} {hides}"));
            }
        }
    }
    // Printed curves without a value, a rate that is zero as it stands, flattened lists.
    let known = [
        "claims/anisotropic/certified/points.rs: 1 .ok()",
        "claims/anisotropic/curves.rs: 1 .flatten()",
        "claims/anisotropic/curves.rs: 1 .ok()",
        "claims/anisotropic/regions.rs: 1 .ok()",
        "claims/anisotropic/simulated.rs: 2 .ok()",
        "claims/constant/exact/sliding.rs: 1 is_ok",
        "claims/escape/exact/late.rs: 1 .flatten()",
        "claims/formulas.rs: 1 .flatten()",
        "claims/sinusoidal/drawn.rs: 1 .flatten()",
    ];
    assert!(found.iter().eq(&known), "{found:#?}");
}
