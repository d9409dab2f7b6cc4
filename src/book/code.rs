//! The code behind the claims: the sources as pages of the book, and where in them a claim's parts stand.

use super::text::escape;
use crate::claims::attempt::Attempt;
use crate::claims::{Claim, Topic};
use include_dir::{Dir, DirEntry, include_dir};
use std::collections::BTreeMap;

/// All sources of the crate.
static SOURCES: Dir<'_> = include_dir!("$CARGO_MANIFEST_DIR/src");

/// The rooms whose sources are shown: the two sides, and the room where they meet.
const SHOWN: [&str; 4] = ["claims", "corrections", "motion", "paper"];

/// A place in the code.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Place {
    /// The file below `src`.
    file: &'static str,
    /// The function, or the id of a claim's row; empty for the file as a whole.
    name: String,
}

impl Place {
    /// The address within the book.
    pub(super) fn address(&self) -> String {
        let hash = if self.name.is_empty() { "" } else { "#" };
        format!("{}{hash}{}", page(self.file), self.name)
    }

    /// A link, with the function's name or else the file's.
    pub(super) fn link(&self) -> String {
        let words = if self.name.is_empty() {
            self.file
        } else {
            &self.name
        };
        format!(
            "<a href=\"{}\"><code>{}</code></a>",
            self.address(),
            escape(words)
        )
    }
}

/// What stands where.
pub(super) struct Code {
    /// Files shown, by their path below `src`.
    files: BTreeMap<&'static str, Source>,
}

/// A file.
struct Source {
    text: &'static str,
    /// Its functions, with their lines counted from 0.
    functions: Vec<(usize, &'static str)>,
}

/// The page that shows a file.
fn page(file: &str) -> String {
    format!("code/{}.html", file.trim_end_matches(".rs"))
}

impl Code {
    pub(super) fn new() -> Self {
        let mut files = BTreeMap::new();
        let mut open: Vec<&DirEntry<'_>> = SOURCES.entries().iter().collect();
        while let Some(entry) = open.pop() {
            open.extend(entry.children());
            let path = entry.path().to_str().unwrap_or_default();
            let shown = SHOWN
                .iter()
                .any(|room| path.starts_with(&format!("{room}/")));
            let text = entry.as_file().and_then(|file| file.contents_utf8());
            if let (true, Some(text)) = (shown, text) {
                let functions = functions(text).collect();
                files.insert(path, Source { text, functions });
            }
        }
        Code { files }
    }

    /// The sources of a topic in a room: `claims/escape.rs` and all in `claims/escape`.
    fn of_topic(&self, room: &str, topic: &Topic) -> impl Iterator<Item = (&'static str, &Source)> {
        let stem = format!("{room}/{}", topic.stem);
        let files = self.files.iter().map(|(file, source)| (*file, source));
        files.filter(move |(file, _)| {
            let rest = file.strip_prefix(stem.as_str());
            rest.is_some_and(|rest| rest == ".rs" || rest.starts_with('/'))
        })
    }

    /// The printed formula of a numbered claim; none for words.
    pub(super) fn printed(&self, topic: &Topic, claim: &Claim) -> Option<Place> {
        let start = format!("eq{}_", claim.equation?);
        let mut functions = self
            .of_topic("paper", topic)
            .flat_map(|(file, source)| source.functions.iter().map(move |f| (file, f.1)));
        let (file, name) = functions.find(|(_, name)| name.starts_with(&start))?;
        Some(Place {
            file,
            name: name.to_owned(),
        })
    }

    /// The file of the corrections of a topic.
    pub(super) fn corrections(&self, topic: &Topic) -> Option<Place> {
        let (file, _) = self.of_topic("corrections", topic).next()?;
        Some(Place {
            file,
            name: String::new(),
        })
    }

    /// The side that knows no formula, for a topic.
    pub(super) fn motion(&self, topic: &Topic) -> Option<Place> {
        let file = match topic.stem {
            "general" | "constant" => "motion/particle.rs",
            "sphere" => "motion/sphere.rs",
            "turntable" | "escape" | "rest" => "motion/turntable/mod.rs",
            _ => "motion/drive/mod.rs",
        };
        let (file, _) = self.files.get_key_value(file)?;
        Some(Place {
            file,
            name: String::new(),
        })
    }

    /// The row of a claim.
    pub(super) fn row(&self, topic: &Topic, claim: &Claim) -> Option<Place> {
        let (file, _, _) = self.row_text(topic, claim)?;
        Some(Place {
            file,
            name: claim.id.to_owned(),
        })
    }

    fn row_text(
        &self,
        topic: &Topic,
        claim: &Claim,
    ) -> Option<(&'static str, &'static str, usize)> {
        let start = format!("id: \"{}\"", claim.id);
        let mut files = self.of_topic("claims", topic);
        files.find_map(|(file, source)| Some((file, source.text, source.text.find(&start)?)))
    }

    /// Where a trial is written.
    pub(super) fn trial(&self, trial: &Attempt) -> Option<Place> {
        let path = format!("{}.rs", trial.file());
        let (file, _) = self.files.get_key_value(path.strip_prefix("src/")?)?;
        let (_, name) = trial.name().rsplit_once("::")?;
        Some(Place {
            file,
            name: name.to_owned(),
        })
    }

    /// The pages: address within the book, and HTML.
    pub(super) fn pages(&self) -> impl Iterator<Item = (String, String)> {
        self.files
            .iter()
            .map(|(file, source)| (page(file), code_page(file, source)))
    }

    /// True if a word stands somewhere in the files shown.
    #[cfg(test)]
    pub(super) fn names(&self, word: &str) -> bool {
        let is_word = |c: char| c.is_alphanumeric() || c == '_';
        self.files.values().any(|Source { text, .. }| {
            text.match_indices(word).any(|(at, _)| {
                !text[..at].ends_with(is_word) && !text[at + word.len()..].starts_with(is_word)
            })
        })
    }
}

/// The functions and constants of a source, with their lines counted from 0.
fn functions(text: &str) -> impl Iterator<Item = (usize, &str)> {
    text.lines().enumerate().filter_map(|(i, line)| {
        let mut words = line.trim_start();
        for word in ["pub ", "pub(super) ", "pub(crate) "] {
            words = words.strip_prefix(word).unwrap_or(words);
        }
        let constant = words.strip_prefix("const ");
        let name = constant.unwrap_or(words);
        let name = name.strip_prefix("fn ").or(constant)?;
        Some((i, &name[..name.find(['(', '<', ':'])?]))
    })
}

fn code_page(file: &str, source: &Source) -> String {
    let text = source.text;
    let up = "../".repeat(file.matches('/').count() + 1);
    let mut anchors = BTreeMap::new();
    let mut taken: Vec<&str> = Vec::new();
    let rows = text.lines().enumerate().filter_map(|(i, line)| {
        let id = line.trim_start().strip_prefix("id: \"")?;
        Some((i, id.split('"').next()?))
    });
    for (line, name) in source.functions.iter().copied().chain(rows) {
        if !taken.contains(&name) {
            taken.push(name);
            anchors.insert(line, name);
        }
    }
    let mut code = String::with_capacity(text.len() * 2);
    let mut state = State::Plain;
    for (i, line) in text.lines().enumerate() {
        if let Some(name) = anchors.get(&i) {
            code.push_str(&format!("<a id=\"{}\"></a>", escape(name)));
        }
        state = highlight(line, state, &mut code);
        code.push('\n');
    }
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{file}</title>\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\
         <style>{STYLE}</style></head><body><header><a href=\"{up}index.html\">Slipbook</a></header>\
         <main><h1>src/{file}</h1><pre tabindex=\"0\"><code>{code}</code></pre></main></body></html>\n"
    )
}

const STYLE: &str = include_str!("../../book/theme/code.css");

/// What goes on from line to line.
#[derive(Clone, Copy, PartialEq)]
enum State {
    Plain,
    Text,
}

const KEYWORDS: &[&str] = &[
    "as", "break", "const", "continue", "crate", "else", "enum", "fn", "for", "if", "impl", "in",
    "let", "loop", "match", "mod", "move", "mut", "pub", "ref", "return", "self", "Self", "static",
    "struct", "super", "trait", "type", "use", "where", "while",
];

/// One line of Rust as HTML: comments, strings and keywords are marked.
fn highlight(line: &str, mut state: State, out: &mut String) -> State {
    let mut rest = line;
    while let Some(c) = rest.chars().next() {
        let (end, class) = if state == State::Text {
            (end_of_string(rest, &mut state), "s")
        } else if rest.starts_with("//") {
            (rest.len(), "c")
        } else if c == '"' {
            state = State::Text;
            (1 + end_of_string(&rest[1..], &mut state), "s")
        } else if c.is_alphabetic() || c == '_' {
            let end = rest.find(|c: char| !(c.is_alphanumeric() || c == '_'));
            let end = end.unwrap_or(rest.len());
            (
                end,
                if KEYWORDS.contains(&&rest[..end]) {
                    "k"
                } else {
                    ""
                },
            )
        } else if rest.starts_with("'\"'") {
            (3, "s")
        } else {
            (c.len_utf8(), "")
        };
        let text = escape(&rest[..end]);
        match class {
            "" => out.push_str(&text),
            class => out.push_str(&format!("<i class=\"{class}\">{text}</i>")),
        }
        rest = &rest[end..];
    }
    state
}

/// How far a string goes on this line.
fn end_of_string(rest: &str, state: &mut State) -> usize {
    let mut escaped = false;
    for (at, c) in rest.char_indices() {
        match c {
            '"' if !escaped => {
                *state = State::Plain;
                return at + 1;
            }
            '\\' => escaped = !escaped,
            _ => escaped = false,
        }
    }
    rest.len()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::claims::PAPER;

    #[test]
    fn every_claim_leads_to_its_code() {
        let code = Code::new();
        for (topic, claim) in PAPER.claims() {
            let row = code.row(topic, claim);
            assert!(row.is_some(), "{}: no row", claim.id);
            assert!(
                code.printed(topic, claim).is_some() == claim.equation.is_some(),
                "{}",
                claim.id
            );
            assert!(code.motion(topic).is_some());
            for trial in claim.trials {
                let trial = code.trial(trial).unwrap_or_else(|| panic!("{trial:?}"));
                let shown = code_page(trial.file, &code.files[trial.file]);
                assert!(
                    shown.contains(&format!("<a id=\"{}\"></a>", trial.name)),
                    "{trial:?}"
                );
            }
        }
    }

    #[test]
    fn rust_is_marked() {
        let mut out = String::new();
        assert!(
            highlight("let a = \"b \\\" // c\"; // <d>", State::Plain, &mut out) == State::Plain
        );
        assert_eq!(
            out,
            "<i class=\"k\">let</i> a = <i class=\"s\">&quot;b \\&quot; // c&quot;</i>; <i class=\"c\">// &lt;d&gt;</i>"
        );
        assert!(highlight("x(\"open", State::Plain, &mut out) == State::Text);
    }
}
