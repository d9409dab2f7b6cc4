//! The same results everywhere: in two runs, on one thread and on many, in the debug and in the release profile.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Command;

/// What the main job says as JSON, and every file of the book that it writes.
fn run(jobs: &str) -> (String, BTreeMap<String, Vec<u8>>) {
    let folder = tempfile::tempdir().unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_slipbook"))
        .args(["--json", "--out", "book", "--jobs", jobs])
        .current_dir(folder.path())
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(0), "on {jobs} threads");
    let mut files = BTreeMap::new();
    read(&folder.path().join("book"), "", &mut files);
    // The address of the book is the only thing that may differ.
    let said = String::from_utf8(output.stdout).unwrap();
    let (ledger, _) = said.split_once("\"book\": ").unwrap();
    (ledger.to_owned(), files)
}

fn read(folder: &Path, below: &str, files: &mut BTreeMap<String, Vec<u8>>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = format!("{below}/{}", path.file_name().unwrap().to_str().unwrap());
        if path.is_dir() {
            read(&path, &name, files);
        } else {
            files.insert(name, fs::read(&path).unwrap());
        }
    }
}

#[test]
fn one_thread_and_many_give_the_same_ledger_and_the_same_book() {
    let (ledger, book) = run("1");
    let (other_ledger, other_book) = run("4");
    assert!(ledger.contains("\"eq-147\"") && ledger == other_ledger);
    assert!(book.keys().any(|name| name.ends_with(".csv")));
    let names = |book: &BTreeMap<String, Vec<u8>>| book.keys().cloned().collect::<Vec<_>>();
    assert_eq!(names(&book), names(&other_book));
    let differ = book
        .iter()
        .filter(|(name, bytes)| other_book[*name] != **bytes);
    let differ: Vec<_> = differ.map(|(name, _)| name).collect();
    assert!(differ.is_empty(), "{differ:?}");
    recorded("book", &published(&book));
}

/// What readers and programs are told: the main part of each page, and each file of text that is made of the ledger. Figures are recorded
/// apart, and the pages of code are the code.
fn published(book: &BTreeMap<String, Vec<u8>>) -> String {
    let mut lines = String::new();
    for (name, bytes) in book {
        let text = String::from_utf8_lossy(bytes);
        let told = match name.rsplit('.').next() {
            _ if name.starts_with("/figures") || name.starts_with("/code") => continue,
            Some("html") => text.split_once("<main>").map_or("", |(_, main)| main),
            Some("csv" | "json" | "tex" | "txt" | "yml") => &text,
            _ => continue,
        };
        lines += &format!("{:016x} {name}\n", fnv1a(told));
    }
    lines
}

/// The figures are the recorded ones, to the byte, in whatever profile and on whatever machine this runs. The sheets
/// are so too: `snapshots` has them as they are.
#[test]
fn the_figures_are_the_recorded_ones() {
    let figures = slipbook::figures::all().unwrap();
    let line = |id: &str, kind: &str, text: &str| format!("{id} {kind} {:016x}\n", fnv1a(text));
    let lines = figures
        .iter()
        .map(|f| line(f.id, "csv", &f.csv) + &line(f.id, "svg", &f.svg));
    recorded("figures", &lines.collect::<String>());
}

/// What is said to a reader is what was read before it was recorded: each section of a page, and in each file the sentences among its
/// strings; of formulas what their documentation says, of explorers whatever they say. A lie that no calculation notices shows here.
#[test]
fn the_sentences_are_the_recorded_ones() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut files = BTreeMap::new();
    for folder in ["book/src", "src", "trialbook/src"] {
        read(&root.join(folder), folder, &mut files);
    }
    for file in [
        "README.md",
        "book/theme/explorers-list.js",
        "book/theme/explorers-scenes.js",
    ] {
        files.insert(file.to_owned(), fs::read(root.join(file)).unwrap());
    }
    let mut lines = String::new();
    for (file, bytes) in &files {
        let text = String::from_utf8_lossy(bytes).replace("\r\n", "\n");
        let said: Vec<(&str, String)> = match file.rsplit('.').next() {
            Some("md") => sections(&text),
            Some("rs") if file.contains("/tests") => continue,
            Some("rs") => {
                let code = without_tests(&text);
                let mut said = sentences(code);
                if file.starts_with("src/paper") || file.starts_with("src/corrections") {
                    let documented = code
                        .lines()
                        .map(str::trim_start)
                        .filter(|line| line.starts_with("///") || line.starts_with("//!"));
                    said.extend(documented.map(str::to_owned));
                }
                vec![("", said.join("\n"))]
            }
            _ => vec![("", text.clone())],
        };
        for (heading, said) in said.into_iter().filter(|(_, said)| !said.is_empty()) {
            lines += &format!("{:016x} {file} {heading}\n", fnv1a(&said));
        }
    }
    recorded("sentences", &lines);
}

/// Every number and every comparison in what decides is what was read before it was recorded: a threshold that no motion comes near can be
/// another one without any result being another.
#[test]
fn the_thresholds_are_the_recorded_ones() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut files = BTreeMap::new();
    for folder in ["src", "trialbook/src"] {
        read(&root.join(folder), folder, &mut files);
    }
    let mut lines = String::new();
    for (file, bytes) in &files {
        let text = String::from_utf8_lossy(bytes).replace("\r\n", "\n");
        if !file.ends_with(".rs") || file.contains("/tests") {
            continue;
        }
        let code = without_tests(&text);
        let code = code
            .lines()
            .map(str::trim)
            .filter(|line| !line.starts_with("//"));
        let told: Vec<&str> = code.filter(|line| decides(line)).collect();
        if !told.is_empty() {
            let (count, hash) = (told.len(), fnv1a(&told.join("\n")));
            lines += &format!("{hash:016x} {file}: {count} lines\n");
        }
    }
    recorded("thresholds", &lines);
}

/// Whether a line of code compares, or has a number that is not a small whole one.
fn decides(line: &str) -> bool {
    let compares = [
        " < ", " > ", " <= ", " >= ", " == ", " != ", "..=", ".max(", ".min(", "below(", "within(",
    ];
    let number = |pair: &[u8]| pair[0].is_ascii_digit() && matches!(pair[1], b'.' | b'e');
    compares.iter().any(|sign| line.contains(sign)) || line.as_bytes().windows(2).any(number)
}

#[test]
fn a_threshold_is_found_in_a_line() {
    let lines = [
        "p < 1e-29 &&",
        "if a == b {",
        "x * 0.5",
        "f(2)",
        "let x = y;",
        "a.below(b)",
    ];
    assert_eq!(lines.map(decides), [true, true, true, false, false, true]);
}

/// A file of code up to the tests in it; where they stand in a file of their own, all of it.
fn without_tests(code: &str) -> &str {
    code.split("#[cfg(test)]\nmod tests {").next().unwrap()
}

/// The sections of a page by their headings, without the code, which is tested.
fn sections(text: &str) -> Vec<(&str, String)> {
    let mut sections = vec![("", String::new())];
    let mut code = false;
    for line in text.lines() {
        if line.starts_with("```") {
            code = !code;
        } else if !code {
            if line.starts_with('#') {
                sections.push((line, String::new()));
            }
            let (_, said) = sections.last_mut().unwrap();
            *said += line;
            said.push('\n');
        }
    }
    sections
}

/// The strings in code that have a blank in them.
fn sentences(code: &str) -> Vec<String> {
    let mut said = Vec::new();
    let mut rest = code;
    while let Some(at) = rest.find(['"', '/', '\'']) {
        let before = &rest[..at];
        rest = &rest[at..];
        if rest.starts_with("//") {
            rest = rest.find('\n').map_or("", |end| &rest[end..]);
        } else if let Some(next) = rest.strip_prefix("'\"'") {
            rest = next;
        } else if rest.starts_with('"') {
            let marks = before.len() - before.trim_end_matches('#').len();
            let raw = before.trim_end_matches('#').ends_with('r');
            let close = format!("\"{}", "#".repeat(if raw { marks } else { 0 }));
            let mut end = 1;
            while !rest[end..].starts_with(&close) {
                let escaped = !raw && rest[end..].starts_with('\\');
                end += usize::from(escaped);
                end += rest[end..].chars().next().map_or(0, char::len_utf8);
                assert!(end < rest.len(), "a string without an end");
            }
            if rest[..end].contains(' ') {
                said.push(rest[1..end].to_owned());
            }
            rest = &rest[end + close.len()..];
        } else {
            rest = &rest[1..];
        }
    }
    said
}

#[test]
fn a_sentence_is_found_in_any_string() {
    let code = r##"f("a b", 'c', '"', "no", r"d \", r#"e "f" g"#); // "h i""##;
    assert_eq!(
        sentences(code),
        ["a b", r"d \", "e \"f\" g"].map(str::to_owned)
    );
    assert_eq!(sentences(r#"g("a \" b")"#), [r#"a \" b"#]);
    let page = sections("a\n# B\nc\n```rust\n# d\n```\n");
    assert_eq!(
        page,
        [("", "a\n".to_owned()), ("# B", "# B\nc\n".to_owned())]
    );
}

fn recorded(name: &str, lines: &str) {
    let mut settings = insta::Settings::clone_current();
    settings.set_snapshot_path(concat!(env!("CARGO_MANIFEST_DIR"), "/snapshots"));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(name, lines));
}

/// The Fowler–Noll–Vo hash of 64 bits: enough to see a change, and the same in every version of Rust.
fn fnv1a(text: &str) -> u64 {
    text.bytes().fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
    })
}
