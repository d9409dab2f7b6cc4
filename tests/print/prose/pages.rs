//! The pages as a reader meets them: sections, and in them prose and code by turns.

use std::fs;
use std::path::{Path, PathBuf};

/// What stands between two headings, or in one exercise.
pub struct Section {
    /// The page's name without its extension.
    pub page: String,
    pub blocks: Vec<Block>,
}

pub enum Block {
    /// Prose with its formulas, without placeholders, code, and the targets of links.
    Prose(String),
    /// Code that runs as a test.
    Code(String),
}

/// The pages: name without extension, and text.
pub fn pages() -> Vec<(String, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("book/src");
    let files = fs::read_dir(folder).unwrap();
    let mut files: Vec<_> = files.map(|file| file.unwrap().path()).collect();
    files.sort();
    let read = |path: &PathBuf| {
        let stem = path.file_stem().unwrap().to_str().unwrap();
        (stem.to_owned(), fs::read_to_string(path).unwrap())
    };
    files.iter().map(read).collect()
}

/// All sections of all pages, in order.
pub fn sections() -> Vec<Section> {
    pages()
        .iter()
        .flat_map(|(page, text)| of_page(page, text))
        .collect()
}

/// The pages without code, each on one line.
pub fn one_line() -> Vec<(String, String)> {
    let line = |(page, text): (String, String)| (page, without(&text, "`", "`"));
    with_code().into_iter().map(line).collect()
}

/// The pages without blocks of code, each on one line.
pub fn with_code() -> Vec<(String, String)> {
    let line = |(page, text): (String, String)| {
        let prose = without(&text, "```", "```");
        (page, prose.split_whitespace().collect::<Vec<_>>().join(" "))
    };
    pages().into_iter().map(line).collect()
}

/// The sections of a page.
pub fn of_page(page: &str, text: &str) -> Vec<Section> {
    let mut sections = Vec::new();
    let mut blocks = Vec::new();
    let (mut prose, mut code) = (String::new(), None::<String>);
    for line in text.lines().chain(["#"]) {
        match (&mut code, line.strip_prefix("```")) {
            (None, Some(language)) => {
                blocks.push(Block::Prose(bare(&std::mem::take(&mut prose))));
                code = Some(language.to_owned());
            }
            (Some(text), Some(_)) => {
                if let Some(rust) = text.strip_prefix("rust\n") {
                    blocks.push(Block::Code(rust.to_owned()));
                }
                code = None;
            }
            (Some(text), None) => *text += &format!("\n{line}"),
            (None, None) => {
                if line.starts_with('#') || line.starts_with("<div class=\"exercise\"") {
                    blocks.push(Block::Prose(bare(&std::mem::take(&mut prose))));
                    let blocks = std::mem::take(&mut blocks);
                    let page = page.to_owned();
                    sections.push(Section { page, blocks });
                }
                prose += line;
                prose.push('\n');
            }
        }
    }
    sections
}

/// Prose without what stands between marks and is no prose.
fn bare(text: &str) -> String {
    let tag = |line: &&str| line.starts_with('<');
    let mut text: String = text
        .lines()
        .filter(|line| !tag(line))
        .flat_map(|line| [line, "\n"])
        .collect();
    for (open, close) in [("{{", "}}"), ("`", "`"), ("](", ")"), ("{#", "}")] {
        text = without(&text, open, close);
    }
    text.replace("$$", "$")
}

/// A text without what stands between two marks.
fn without(text: &str, open: &str, close: &str) -> String {
    let mut out = String::new();
    let mut rest = text;
    while let Some((before, after)) = rest.split_once(open) {
        out.push_str(before);
        let Some((_, after)) = after.split_once(close) else {
            return out + open + after;
        };
        out.push(' ');
        rest = after;
    }
    out + rest
}

#[test]
fn a_page_falls_into_sections_of_prose_and_code() {
    let text = "# A {#a}\nx {{y}} `z` [b](c.md)\n<div>\n```rust\nlet a = 1;\n```\n$c$\n## B\n```text\n3\n```\nd\n";
    let sections = of_page("p", text);
    let shown = sections.iter().flat_map(|section| &section.blocks);
    let shown: Vec<_> = shown
        .map(|block| match block {
            Block::Prose(text) => format!("prose {}", text.trim()),
            Block::Code(text) => format!("code {text}"),
        })
        .filter(|block| block != "prose ")
        .collect();
    assert_eq!(
        shown,
        [
            "prose # A  \nx     [b",
            "code let a = 1;",
            "prose $c$",
            "prose ## B",
            "prose d"
        ]
    );
    assert_eq!(sections.len(), 3);
}
