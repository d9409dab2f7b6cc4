//! The pages as a reader meets them: their words one after the other; and their sections, in them prose and code by turns.

use std::fs;
use std::path::Path;

/// A word without the marks around it, in small letters; a formula is `§`.
#[derive(Clone)]
pub struct Word {
    pub text: String,
    /// Where it begins.
    pub at: usize,
    /// Whether a mark parts it from the next word.
    pub ends: bool,
}

/// The words of a text, without its code and the targets of its links; of the placeholders those for counts and values stay.
pub fn words(text: &str) -> Vec<Word> {
    let mut words = Vec::new();
    let mut at = 0;
    while let Some(first) = text[at..].chars().next() {
        let rest = &text[at..];
        let skipped = SKIPPED.iter().find_map(|(open, close)| {
            let inside = rest.strip_prefix(open)?;
            // What is smaller than something begins with no letter.
            let tag = |c: char| c == '/' || c.is_ascii_alphabetic();
            (*open != "<" || inside.starts_with(tag)).then_some(())?;
            let end = inside.find(close)?;
            Some((&inside[..end], open.len() + end + close.len()))
        });
        let mut push = |text: String, ends| words.push(Word { text, at, ends });
        if let Some((inside, length)) = skipped {
            if first == '$' {
                push("§".to_owned(), false);
            } else if ["count ", "value "]
                .iter()
                .any(|kind| inside.starts_with(kind))
            {
                push(format!("{{{inside}}}"), false);
            }
            at += length;
        } else if first.is_whitespace() {
            at += first.len_utf8();
        } else {
            let stops = |(i, c): (usize, char)| {
                let opens = SKIPPED.iter().any(|(open, _)| rest[i..].starts_with(open));
                (i > 0 && (c.is_whitespace() || opens)).then_some(i)
            };
            let whole = &rest[..rest.char_indices().find_map(stops).unwrap_or(rest.len())];
            let word = whole.trim_matches(|c: char| !(c.is_alphanumeric() || "%×§{}".contains(c)));
            if !word.is_empty() {
                push(
                    word.to_lowercase(),
                    whole.ends_with([',', '.', ':', ';', ')']),
                );
            }
            at += whole.len();
        }
    }
    words
}

/// What is no word, by what it begins and ends with.
const SKIPPED: [(&str, &str); 8] = [
    ("```", "```"),
    ("`", "`"),
    ("$$", "$$"),
    ("$", "$"),
    ("{{", "}}"),
    ("](", ")"),
    ("{#", "}"),
    ("<", ">"),
];

/// Whether a text begins with these words.
pub fn stands(text: &[Word], wanted: &[Word]) -> bool {
    text.len() >= wanted.len() && text.iter().zip(wanted).all(|(a, b)| a.text == b.text)
}

/// A page: name without extension, its text, and the words of that.
pub struct Page {
    pub name: String,
    pub text: String,
    pub words: Vec<Word>,
}

/// All pages.
pub fn pages() -> Vec<Page> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("book/src");
    let mut files: Vec<_> = fs::read_dir(folder)
        .unwrap()
        .map(|file| file.unwrap().path())
        .collect();
    files.sort();
    let page = |path: std::path::PathBuf| {
        let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
        let text = fs::read_to_string(path).unwrap();
        let words = words(&text);
        Page { name, text, words }
    };
    files.into_iter().map(page).collect()
}

/// What stands between two headings, or in one exercise.
pub struct Section {
    pub page: String,
    /// Where it begins.
    pub from: usize,
    pub blocks: Vec<Block>,
}

pub enum Block {
    /// Prose with its formulas, without placeholders, code, and the targets of links.
    Prose(String),
    /// Code that runs as a test.
    Code(String),
}

impl Section {
    pub fn prose(&self) -> impl Iterator<Item = &str> {
        self.blocks.iter().filter_map(|block| match block {
            Block::Prose(text) => Some(&text[..]),
            Block::Code(_) => None,
        })
    }

    pub fn code(&self) -> impl Iterator<Item = &str> {
        self.blocks.iter().filter_map(|block| match block {
            Block::Code(text) => Some(&text[..]),
            Block::Prose(_) => None,
        })
    }
}

/// All sections of all pages, in order.
pub fn sections() -> Vec<Section> {
    let of_page = |page: Page| sections_of(&page.name, &page.text);
    pages().into_iter().flat_map(of_page).collect()
}

/// The sections of a page.
pub fn sections_of(page: &str, text: &str) -> Vec<Section> {
    let mut sections = vec![Section {
        page: page.to_owned(),
        from: 0,
        blocks: Vec::new(),
    }];
    let (mut prose, mut code) = (String::new(), None::<String>);
    let mut at = 0;
    for line in text.split_inclusive('\n').chain(["#"]) {
        let heading = line.starts_with('#') || line.starts_with("<div class=\"exercise\"");
        let fence = line.strip_prefix("```");
        if fence.is_some() || heading && code.is_none() {
            let blocks = &mut sections.last_mut().unwrap().blocks;
            match code.take() {
                Some(text) => blocks.extend(
                    text.strip_prefix("rust\n")
                        .map(|rust| Block::Code(rust.to_owned())),
                ),
                None => {
                    blocks.push(Block::Prose(bare(&std::mem::take(&mut prose))));
                    code = fence.map(str::to_owned);
                }
            }
            if heading {
                sections.push(Section {
                    page: page.to_owned(),
                    from: at,
                    blocks: Vec::new(),
                });
            }
        }
        match &mut code {
            _ if fence.is_some() => {}
            Some(code) => *code += line,
            None => prose += line,
        }
        at += line.len();
    }
    sections
}

/// Prose without what stands between marks and is no prose.
pub fn bare(text: &str) -> String {
    let lines = text
        .split_inclusive('\n')
        .filter(|line| !line.starts_with('<'));
    let mut text: String = lines.collect();
    for (open, close) in [("{{", "}}"), ("`", "`"), ("](", ")"), ("{#", "}")] {
        let mut out = String::new();
        let mut rest = &text[..];
        while let Some((before, after)) = rest.split_once(open)
            && let Some((_, after)) = after.split_once(close)
        {
            out += before;
            out.push(' ');
            rest = after;
        }
        text = out + rest;
    }
    text.replace("$$", "$")
}

/// The formulas of a text, each on one line.
pub fn formulas_of(text: &str) -> Vec<String> {
    let formulas = text.split('$').skip(1).step_by(2);
    let flat = |formula: &str| formula.split_whitespace().collect::<Vec<_>>().join(" ");
    formulas.map(flat).collect()
}

#[test]
fn a_page_falls_into_words_and_into_sections_of_prose_and_code() {
    let text = "# A {#a}\nx {{y}} `z` [b](c.md), {{count d}}\n<div>\n```rust\nlet a = 1;\n```\n$c$\n## B\n```text\n3\n```\nd\n";
    let found: Vec<_> = words(text).into_iter().map(|word| word.text).collect();
    assert_eq!(found, ["a", "x", "b", "{count d}", "§", "b", "d"]);
    let sections = sections_of("p", text);
    let shown = sections
        .iter()
        .flat_map(|section| &section.blocks)
        .map(|block| match block {
            Block::Prose(text) => format!("prose {}", text.trim()),
            Block::Code(text) => format!("code {}", text.trim()),
        });
    let shown: Vec<_> = shown.filter(|block| block != "prose ").collect();
    assert_eq!(
        shown,
        [
            "prose # A  \nx     [b ,",
            "code let a = 1;",
            "prose $c$",
            "prose ## B",
            "prose d"
        ]
    );
    let from: Vec<_> = sections.iter().map(|section| section.from).collect();
    assert_eq!(from[1..], [0, text.find("## B").unwrap(), text.len()]);
}
